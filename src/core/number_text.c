/* number_text.c -- numbers as text that reads back as the same number.
 *
 * Most numbers take the exact way. x = m 2^e with a whole m < 2^53; for the q that puts
 * s = x 10^q into [1e16, 1e17),
 *
 *     s = m 5^q / 2^sh,   sh = -(e + q),
 *
 * and m 5^q < 2^116 is a whole number for 0 <= q <= 27. The decimal D of n digits nearest to s,
 * counted in units of s, reads back as x when it lies nearer to s than half the gap to the next
 * double, which is 5^q / 2^sh / 2 (half of that below a power of two):
 *
 *     2 |D 2^sh - m 5^q| < 5^q
 *
 * All of it is whole-number arithmetic. Ties, and numbers outside of about 1e-11 to 1e15, take the
 * slow way of core/decimal.h.
 */
#include "core/number_text.h"

#include "core/decimal.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

__extension__ typedef unsigned __int128 wide;

enum { POWERS = 28 };
/* clang-format off */
static const uint64_t power_of_5[POWERS] = {
    1U, 5U, 25U, 125U, 625U, 3125U, 15625U, 78125U, 390625U, 1953125U, 9765625U, 48828125U,
    244140625U, 1220703125U, 6103515625U, 30517578125U, 152587890625U, 762939453125U,
    3814697265625U, 19073486328125U, 95367431640625U, 476837158203125U, 2384185791015625U,
    11920928955078125U, 59604644775390625U, 298023223876953125U, 1490116119384765625U,
    7450580596923828125U};
/* clang-format on */
static const uint64_t lowest = 10000000000000000U; /* 1e16, the smallest of 17 digits */

/* A decimal: digits * 10^exponent. */
typedef struct decimal {
    uint64_t digits;
    int exponent;
} decimal;

/* The digits of n, not ended; their number. */
static int put_digits(uint64_t n, char *text)
{
    char reversed[24];
    int count = 0;
    do {
        reversed[count++] = (char)('0' + n % 10);
        n /= 10;
    } while (n > 0);
    for (int i = 0; i < count; i++) {
        text[i] = reversed[count - 1 - i];
    }
    return count;
}

/* Lays out a decimal whose digits do not end in 0 as %g does: plain for exponents -5 .. 16. */
static size_t lay_out(decimal value, char *text)
{
    char digits[24];
    const int count = put_digits(value.digits, digits);
    const int point = count + value.exponent; /* digits before the decimal point */
    char *out = text;

    if (point > 17 || point < -4) {
        *out++ = digits[0];
        if (count > 1) {
            *out++ = '.';
            memcpy(out, digits + 1, (size_t)count - 1);
            out += count - 1;
        }
        return (size_t)(out - text) + (size_t)sprintf(out, "e%d", point - 1);
    }
    if (point <= 0) {
        memcpy(out, "0.0000", (size_t)(2 - point));
        out += 2 - point;
        memcpy(out, digits, (size_t)count);
        out += count;
    } else {
        for (int i = 0; i < count || i < point; i++) {
            if (i == point) {
                *out++ = '.';
            }
            *out++ = i < count ? digits[i] : '0';
        }
    }
    *out = '\0';
    return (size_t)(out - text);
}

static decimal stripped(uint64_t digits, int exponent)
{
    while (digits % 10 == 0 && digits > 0) {
        digits /= 10;
        exponent++;
    }
    return (decimal){digits, exponent};
}

/* The nearest multiple of `unit` to s = product / 2^shift; 0 at a tie. */
static uint64_t nearest_multiple(wide product, int shift, uint64_t unit)
{
    const uint64_t whole = (uint64_t)(product >> shift);
    const uint64_t below = whole / unit * unit;
    const wide twice = 2 * (product - ((wide)below << shift));
    const wide middle = (wide)unit << shift;
    if (twice == middle) {
        return 0;
    }
    return twice > middle ? below + unit : below;
}

/* The exact way for x > 0, not whole; 0 where it does not apply. */
static int exact_decimal(double x, decimal *value)
{
    static const uint64_t units[3] = {100, 10, 1};
    int exponent = 0;
    const double fraction = frexp(x, &exponent); /* x = fraction 2^exponent, in [1/2, 1) */
    const uint64_t m = (uint64_t)(fraction * 0x1p53);
    const int e = exponent - 53;
    int q = 16 - (int)floor((exponent - 1) * 0.30102999566398120); /* may be one too many */
    wide product = 0;
    int shift = 0;

    for (int attempt = 0; attempt < 2; attempt++, q--) {
        shift = -(e + q);
        if (q < 0 || q >= POWERS || shift < 0 || shift > 100) {
            return 0;
        }
        product = (wide)m * power_of_5[q];
        if ((product >> shift) < 10 * (wide)lowest) {
            break;
        }
    }
    if ((product >> shift) < lowest || (product >> shift) >= 10 * (wide)lowest) {
        return 0;
    }
    for (int i = 0; i < 3; i++) {
        const uint64_t candidate = nearest_multiple(product, shift, units[i]);
        const wide scaled = (wide)candidate << shift;
        const wide off = scaled > product ? scaled - product : product - scaled;
        const wide gap = m == (uint64_t)1 << 52 && scaled < product ? 2 * off : off;
        if (candidate == 0 || 2 * gap == power_of_5[q]) {
            return 0;
        }
        if (2 * gap < power_of_5[q]) {
            *value = stripped(candidate, -q);
            return 1;
        }
    }
    return 0;
}

/* The slow way for any x > 0: the first precision that reads back. */
static decimal printed_decimal(double x)
{
    uint64_t digits = 0;
    int exponent = 0;
    for (int precision = 15; precision <= 17; precision++) {
        char text[40];
        digits = taut_decimal_digits(x, precision, &exponent);
        int length = put_digits(digits, text);
        length += sprintf(text + length, "e%d", exponent);
        if (precision == 17 || taut_decimal_value(text, (size_t)length) == x) {
            break;
        }
    }
    return stripped(digits, exponent);
}

size_t taut_number_text(double x, char text[TAUT_NUMBER_ROOM])
{
    const double size = fabs(x);
    size_t sign = 0;
    decimal value = {0, 0};

    if (!isfinite(x)) {
        memcpy(text, "null", 5);
        return 4;
    }
    if (signbit(x)) {
        text[sign++] = '-';
    }
    if (size < 1e15 && size == floor(size)) {
        const size_t length = sign + (size_t)put_digits((uint64_t)size, text + sign);
        text[length] = '\0';
        return length;
    }
    if (!exact_decimal(size, &value)) {
        value = printed_decimal(size);
    }
    return sign + lay_out(value, text + sign);
}
