/* logarithm.c -- log, log2, log10 by a table ([Tang1990]):
 *
 *     x = 2^k m, 0.7 < m < 1.42,  c about 1/m from the table, in nine bits, 1 next to m = 1
 *     r = c m - 1 exactly, |r| < 2^-7
 *     log x = k ln 2 - log c + r - r^2/2 + r^3/3 - ...
 *
 * with the first terms exact: the series has no rounding larger than that of r^3/3, 2^-76.
 */
#include "core/elementary/elementary.h"
#include "core/elementary/internal.h"

/* ln 2: 42 bits, by which an exponent is multiplied exactly, and the rest */
static const double ln2 = 0x1.62e42fefa38p-1, ln2_rest = 0x1.ef35793c7673p-45;
static const taut_twice inverse_ln2 = {0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
static const taut_twice inverse_ln10 = {0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};

enum { CELLS_BELOW = 53 }; /* cells of m >= 1 + 53/128 stand for m/2 */

double taut_elementary_split(double x, int *k)
{
    *k = 0;
    if (x < 0x1p-1022) {
        x *= 0x1p54;
        *k = -54;
    }
    const uint64_t bits = taut_bits_of(x);
    const int cell = (int)(bits >> 45 & 127), up = cell >= CELLS_BELOW;
    *k += (int)(bits >> 52) - 1023 + up;
    return taut_of_bits((bits & 0xfffffffffffffu) | (uint64_t)(1023 - up) << 52);
}

taut_twice taut_elementary_log(double m, int k)
{
    const size_t cell = taut_bits_of(m) >> 45 & 127;
    const double c = taut_table_inverse[cell];
    const taut_twice product = taut_twice_product(c, m);
    const taut_twice r = taut_twice_sum(product.high - 1, product.low);
    const double x = r.high;
    const taut_twice square = taut_twice_product(x, x);
    double series = 0;
    for (int n = 11; n >= 3; n--) {
        series = (n % 2 == 0 ? -1.0 : 1.0) / n + series * x;
    }
    const taut_twice table = taut_table_log[cell];
    const taut_twice a = taut_twice_sum(k * ln2, table.high);
    const taut_twice b = taut_twice_sum(a.high, x);
    const taut_twice d = taut_twice_sum(b.high, -square.high / 2);
    const double low = (a.low + (k * ln2_rest + table.low)) + b.low + d.low +
                       (r.low - square.low / 2 - x * r.low) + x * square.high * series;
    return taut_twice_sum(d.high, low);
}

/* 0, infinity, NaN and negative numbers */
static double log_beyond(double x)
{
    return x < 0 ? (x - x) / 0.0 : x == 0 ? -HUGE_VAL : x;
}

static int is_beyond(double x)
{
    return !(x > 0 && x < HUGE_VAL);
}

double taut_log(double x)
{
    int k = 0;
    if (is_beyond(x)) {
        return log_beyond(x);
    }
    const double m = taut_elementary_split(x, &k);
    return taut_twice_round(taut_elementary_log(m, k));
}

double taut_log2(double x)
{
    int k = 0;
    if (is_beyond(x)) {
        return log_beyond(x);
    }
    const double m = taut_elementary_split(x, &k);
    const taut_twice part = taut_twice_times(taut_elementary_log(m, 0), inverse_ln2);
    return taut_twice_round(taut_twice_add(taut_twice_of(k), part));
}

double taut_log10(double x)
{
    int k = 0;
    if (is_beyond(x)) {
        return log_beyond(x);
    }
    const double m = taut_elementary_split(x, &k);
    return taut_twice_round(taut_twice_times(taut_elementary_log(m, k), inverse_ln10));
}
