/* number_value.c -- from a decimal to the nearest double.
 *
 * A decimal is d 10^k with a whole d of at most 19 digits, so d < 2^64. Two exact ways cover nearly
 * all numbers of documents:
 *
 *     d <= 2^53, |k| <= 22     d and 10^|k| are doubles: one multiplication or division, rounded
 *                              once
 *     -27 <= k < 0             d / 5^q = Q + rest in whole numbers, q = -k, with Q of 63 or 64
 *                              bits: rounded by hand, half to even, knowing whether there is a
 *                              rest
 *
 * All else takes the long way of core/decimal.h.
 */
#include "io/json/number_value.h"

#include "core/decimal.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

__extension__ typedef unsigned __int128 wide;

enum { DIGITS_MAX = 19, POWERS = 27, EXPONENT_MAX = 100000 };

static const double power_of_10[23] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                       1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                       1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

static int is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Past the digits that begin at i. */
static size_t skip_digits(const char *text, size_t room, size_t i)
{
    while (i < room && is_digit(text[i])) {
        i++;
    }
    return i;
}

size_t taut_number_length(const char *text, size_t room)
{
    size_t i = room > 0 && text[0] == '-' ? 1 : 0;
    size_t end = skip_digits(text, room, i);
    if (end == i || (text[i] == '0' && end > i + 1)) {
        return 0; /* no digit, or one after a leading 0 */
    }
    if (end < room && text[end] == '.') {
        i = end + 1;
        end = skip_digits(text, room, i);
        if (end == i) {
            return 0;
        }
    }
    if (end < room && (text[end] == 'e' || text[end] == 'E')) {
        i = end + 1;
        i += i < room && (text[i] == '+' || text[i] == '-');
        end = skip_digits(text, room, i);
        if (end == i) {
            return 0;
        }
    }
    return end;
}

/* d 10^k, without the sign; 0 if there are more digits than fit. */
static int split_decimal(const char *text, size_t length, uint64_t *d, int *k)
{
    size_t i = text[0] == '-';
    int digits = 0, after_point = 0, exponent = 0, sign = 1;
    *d = 0;
    *k = 0;
    for (; i < length && text[i] != 'e' && text[i] != 'E'; i++) {
        if (text[i] == '.') {
            after_point = 1;
        } else {
            *d = 10 * *d + (uint64_t)(text[i] - '0');
            digits += *d > 0;
            *k -= after_point;
            if (digits > DIGITS_MAX) {
                return 0;
            }
        }
    }
    if (i < length) {
        i++;
        sign = text[i] == '-' ? -1 : 1;
        i += !is_digit(text[i]);
        for (; i < length; i++) {
            exponent = exponent < EXPONENT_MAX ? 10 * exponent + (text[i] - '0') : exponent;
        }
    }
    *k += sign * exponent;
    return 1;
}

/* Zero bits above the highest one of n > 0. */
static int leading_zeros(uint64_t n)
{
    return __builtin_clzll(n);
}

/* d / 10^q, d > 0, 0 < q <= 27. With both factors shifted to their highest bit, d = D / 2^a and
 * 5^q = P / 2^b, the quotient D 2^63 / P = Q lies in [2^62, 2^64), and the value is
 * Q 2^(b - a - q - 63). */
static double divide(uint64_t d, int q)
{
    uint64_t power = 1;
    for (int i = 0; i < q; i++) {
        power *= 5;
    }
    const int a = leading_zeros(d), b = leading_zeros(power);
    const wide numerator = (wide)(d << a) << 63;
    const uint64_t quotient = (uint64_t)(numerator / (power << b));
    const int rest = numerator % (power << b) != 0;
    const int drop = 11 - leading_zeros(quotient); /* bits beyond the 53 of a double */
    const uint64_t half = (uint64_t)1 << (drop - 1);
    const uint64_t below = quotient & (2 * half - 1);
    uint64_t m = quotient >> drop;
    m += below > half || (below == half && (rest || (m & 1) != 0));
    return ldexp((double)m, drop + b - a - q - 63);
}

double taut_number_value(const char *text, size_t length)
{
    uint64_t d = 0;
    int k = 0;
    double size = 0;

    if (!split_decimal(text, length, &d, &k)) {
        return taut_decimal_value(text, length);
    }
    if (d == 0) {
        size = 0;
    } else if (d <= (uint64_t)1 << 53 && k >= -22 && k <= 22) {
        size = k < 0 ? (double)d / power_of_10[-k] : (double)d * power_of_10[k];
    } else if (k < 0 && k >= -POWERS) {
        size = divide(d, -k);
    } else {
        return taut_decimal_value(text, length);
    }
    return text[0] == '-' ? -size : size;
}
