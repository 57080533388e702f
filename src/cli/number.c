/* number.c -- words of the command line as numbers, whatever the locale. */
#include "cli/cli.h"
#include "core/decimal.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* JSON's grammar for numbers, with a leading + allowed; strtod would take the locale's comma, hex,
 * "inf" and blanks. */
static int looks_like_number(const char *word)
{
    const char *p = word;
    int digits = 0;
    p += *p == '-' || *p == '+';
    for (; isdigit((unsigned char)*p); p++) {
        digits++;
    }
    if (*p == '.') {
        for (p++; isdigit((unsigned char)*p); p++) {
            digits++;
        }
    }
    if (digits > 0 && (*p == 'e' || *p == 'E')) {
        p++;
        p += *p == '-' || *p == '+';
        digits = isdigit((unsigned char)*p) ? digits : 0;
        while (isdigit((unsigned char)*p)) {
            p++;
        }
    }
    return digits > 0 && *p == '\0';
}

int cli_number(const char *word, double *value)
{
    double found = 0;
    if (!looks_like_number(word)) {
        return 0;
    }
    found = taut_decimal_value(word, strlen(word));
    if (!isfinite(found)) {
        return 0;
    }
    *value = found;
    return 1;
}

int cli_pair(const char *word, double *a, double *b)
{
    char first[64];
    const char *comma = strchr(word, ',');
    if (comma == NULL || (size_t)(comma - word) >= sizeof first) {
        return 0;
    }
    memcpy(first, word, (size_t)(comma - word));
    first[comma - word] = '\0';
    return cli_number(first, a) && cli_number(comma + 1, b);
}
