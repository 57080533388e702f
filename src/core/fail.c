#include "core/fail.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const double taut_none = (double)NAN;

taut_status taut_fail(taut_error *error, taut_status status, const char *where, double found,
                      double limit, const char *format, ...)
{
    if (error != NULL) {
        va_list arguments;
        error->status = status;
        error->found = found;
        error->limit = limit;
        snprintf(error->where, sizeof error->where, "%s", where != NULL ? where : "");
        va_start(arguments, format);
        vsnprintf(error->message, sizeof error->message, format, arguments);
        va_end(arguments);
    }
    return status;
}

taut_status taut_fail_memory(taut_error *error)
{
    return taut_fail(error, TAUT_NO_MEMORY, NULL, taut_none, taut_none, "memory ran out");
}

void taut_error_prefix(taut_error *error, const char *prefix)
{
    if (error != NULL) {
        char where[sizeof error->where];
        size_t length = strlen(prefix);
        if (length >= sizeof where) {
            length = sizeof where - 1;
        }
        memcpy(where, prefix, length);
        snprintf(where + length, sizeof where - length, "%s", error->where);
        memcpy(error->where, where, sizeof where);
    }
}
