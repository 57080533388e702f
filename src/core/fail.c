#include "core/fail.h"

#include "core/decimal.h"
#include "core/number_text.h"

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

/* Numbers with 17 digits, "%.17g", are such as the caller gave: as short as they read back. A number is a word of its own;
 * those that are quoted begin with their mark. */
static void shorten_numbers(char *text)
{
    enum { TRUE_DIGITS = 15 };
    char *out = text;
    while (*text != '\0') {
        char number[TAUT_NUMBER_ROOM];
        size_t length = strcspn(text, " ,;:=()[]"), shorter = 0;
        if (length > TRUE_DIGITS && strspn(text, "+-.0123456789e") >= length) {
            shorter = taut_number_text(taut_decimal_value(text, length), number);
        }
        if (shorter > 0 && shorter < length) {
            memcpy(out, number, shorter);
            out += shorter;
        } else {
            length += length == 0;
            memmove(out, text, length);
            out += length;
        }
        text += length;
    }
    *out = '\0';
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
        shorten_numbers(error->message);
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
        shorten_numbers(error->message);
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
