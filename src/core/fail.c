#include "core/fail.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const double taut_none = (double)NAN;

static void fill_error(taut_error *error, taut_status status, const char *reason, const char *where,
                       double found, double limit)
{
    error->status = status;
    snprintf(error->reason, sizeof error->reason, "%s", reason);
    error->found = found;
    error->limit = limit;
    error->expected[0] = '\0';
    snprintf(error->where, sizeof error->where, "%s", where != NULL ? where : "");
}

taut_status taut_fail(taut_error *error, taut_status status, const char *reason, const char *where,
                      double found, double limit, const char *format, ...)
{
    if (error != NULL) {
        va_list arguments;
        fill_error(error, status, reason, where, found, limit);
        va_start(arguments, format);
        vsnprintf(error->message, sizeof error->message, format, arguments);
        va_end(arguments);
    }
    return status;
}

taut_status taut_fail_expected(taut_error *error, taut_status status, const char *reason,
                               const char *where, double found, const char *expected,
                               const char *format, ...)
{
    if (error != NULL) {
        size_t length = 0;
        va_list arguments;
        fill_error(error, status, reason, where, found, taut_none);
        snprintf(error->expected, sizeof error->expected, "%s", expected);
        va_start(arguments, format);
        vsnprintf(error->message, sizeof error->message, format, arguments);
        va_end(arguments);
        length = strlen(error->message);
        snprintf(error->message + length, sizeof error->message - length, ", expected %s",
                 expected);
    }
    return status;
}

taut_status taut_fail_memory(taut_error *error)
{
    return taut_fail(error, TAUT_NO_MEMORY, "memory", NULL, taut_none, taut_none, "memory ran out");
}

taut_status taut_fail_status(taut_error *error, taut_status status)
{
    const char *reason = status == TAUT_NO_MEMORY      ? "memory"
                         : status == TAUT_BAD_ARGUMENT ? "argument"
                         : status == TAUT_INTERRUPTED  ? "interrupted"
                                                       : "fault";
    return status == TAUT_OK ? TAUT_OK
                             : taut_fail(error, status, reason, NULL, taut_none, taut_none, "%s",
                                         taut_status_text(status));
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
