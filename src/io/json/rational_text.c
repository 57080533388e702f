#include "io/json/rational_text.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>

/* A whole number as its first digits, at most 19, times a power of ten. */
typedef struct whole {
    uint64_t digits;
    long power;
} whole;

/* Reads digits up to the first other character; NULL if there is none. */
static const char *read_whole(const char *text, whole *number)
{
    const char *first = text;
    number->digits = 0;
    number->power = 0;
    for (; *text >= '0' && *text <= '9'; text++) {
        if (number->digits <= (UINT64_MAX - 9) / 10) {
            number->digits = 10 * number->digits + (uint64_t)(*text - '0');
        } else {
            number->power++;
        }
    }
    return text > first ? text : NULL;
}

/* x 10^power: 10^27 is exact in the wider format. */
static long double scaled(long double x, long power)
{
    while (power != 0 && x != 0 && isfinite(x)) {
        const long part = power > 27 ? 27 : power < -27 ? -27 : power;
        long double ten = 1;
        for (long k = 0; k < (part < 0 ? -part : part); k++) {
            ten *= 10;
        }
        x = part < 0 ? x / ten : x * ten;
        power -= part;
    }
    return x;
}

int taut_rational_value(const char *text, double *value)
{
    const int negative = *text == '-';
    whole top = {0, 0}, bottom = {1, 0};
    const char *rest = read_whole(text + negative, &top);

    if (rest != NULL && *rest == '/') {
        rest = read_whole(rest + 1, &bottom);
    }
    if (rest == NULL || *rest != '\0' || rest - text > TAUT_RATIONAL_MAX || bottom.digits == 0) {
        return 0;
    }
    const long double size =
        scaled((long double)top.digits / (long double)bottom.digits, top.power - bottom.power);
    *value = negative ? -(double)size : (double)size;
    return 1;
}
