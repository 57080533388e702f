/* exponential.c -- exp, exp2, expm1, sinh, cosh, tanh by a table ([Tang1989]):
 *
 *     n = nearest(64 x / ln 2),  r = x - n ln 2 / 64 in twice the precision, |r| < 0.0055
 *     exp(x) = 2^(n / 64) (1 + r + r^2/2 + ...),   2^((n mod 64) / 64) from the table
 *
 * The series has no rounding larger than that of r^2/2, 2^-69. Hyperbolic functions and expm1 are
 * sums of such values; where those would cancel, below 1/4, they are series of their own.
 */
#include "core/elementary/elementary.h"
#include "core/elementary/internal.h"

/* ln 2 / 64: 36 bits, by which a whole number of 17 is multiplied exactly, and the rest */
static const double step = 0x1.62e42fefap-7, step_rest = 0x1.cf79abc9e3b3ap-46;
static const taut_twice ln2 = {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

double taut_elementary_scaled(taut_twice a, int k)
{
    const double near = a.high + a.low;
    if (k > -1020 && k < 1020) {
        return near * taut_power_of_two(k);
    }
    if (k >= 1020) {
        return k > 1030 ? near * HUGE_VAL : near * taut_power_of_two(k - 20) * 0x1p20;
    }
    if (k < -1080) {
        return near * 0x1p-1000 * 0x1p-1000;
    }
    const double limit = taut_power_of_two(-1022 - k); /* the least normal number, without 2^k */
    double size = fabs(near);
    /* A subnormal result has its last place where the limit has it: rounded there once, not here
     * and there. */
    if (size < limit) {
        const double sign = near < 0 ? -1 : 1;
        const taut_twice sum = taut_twice_quick(limit, sign * a.high);
        size = (sum.high + (sum.low + sign * a.low)) - limit;
    }
    size = size * taut_power_of_two(k + 100) * 0x1p-100;
    return near < 0 ? -size : size;
}

/* exp of n ln 2 / 64 + r */
static taut_twice exp_near(double n, taut_twice r, int *k)
{
    const int whole = (int)n, place = whole & 63;
    const double x = r.high;
    const double series =
        1.0 / 2 + x * (1.0 / 6 + x * (1.0 / 24 + x * (1.0 / 120 + x * (1.0 / 720 + x / 5040))));
    const taut_twice less_one = taut_twice_quick(x, r.low + x * x * series);
    const taut_twice from = taut_table_exp[place];
    *k = (whole - place) / 64;
    const taut_twice more = taut_twice_times(from, less_one);
    const taut_twice sum = taut_twice_quick(from.high, more.high);
    return taut_twice_quick(sum.high, sum.low + (more.low + from.low));
}

taut_twice taut_elementary_exp(taut_twice x, int *k)
{
    const double n = taut_nearest_whole(x.high * 0x1.71547652b82fep+6);
    taut_twice r = taut_twice_sum(x.high - n * step, -n * step_rest);
    r.low += x.low;
    return exp_near(n, taut_twice_quick(r.high, r.low), k);
}

double taut_exp(double x)
{
    int k = 0;
    if (!(fabs(x) < 1000)) { /* NaN too */
        return x < 0 ? 0 : x * HUGE_VAL;
    }
    const taut_twice e = taut_elementary_exp(taut_twice_of(x), &k);
    return taut_elementary_scaled(e, k);
}

double taut_exp2(double x)
{
    int k = 0;
    if (!(fabs(x) < 1200)) {
        return x < 0 ? 0 : x * HUGE_VAL;
    }
    const double n = taut_nearest_whole(64 * x);
    const taut_twice e = exp_near(n, taut_twice_times(taut_twice_of(x - n / 64), ln2), &k);
    return taut_elementary_scaled(e, k);
}

/* a 2^k + b 2^j, k >= j, in units of 2^k. */
static taut_twice add_scaled(taut_twice a, int k, taut_twice b, int j)
{
    const double unit = k - j > 200 ? 0 : taut_power_of_two(j - k);
    return taut_twice_add(a, (taut_twice){b.high * unit, b.low * unit});
}

double taut_expm1(double x)
{
    int k = 0;
    if (!(fabs(x) < 800)) {
        return x < 0 ? -1 : x * HUGE_VAL;
    }
    if (fabs(x) < 0x1p-60) {
        return x;
    }
    if (fabs(x) < 0.25) { /* x + x^2/2 exactly, and the rest */
        double series = 0;
        for (int n = 15; n >= 3; n--) {
            series = (series * x + 1) / n;
        }
        /* x^3/3! (1 + x/4 (1 + ...)) = x^3 series / 2 */
        const taut_twice square = taut_twice_product(x, x);
        const taut_twice sum = taut_twice_quick(x, square.high / 2);
        return sum.high + (sum.low + (square.low / 2 + x * square.high * (series / 2)));
    }
    const taut_twice e = taut_elementary_exp(taut_twice_of(x), &k);
    const taut_twice less = {-1, 0};
    if (k >= 0) {
        return taut_elementary_scaled(add_scaled(e, k, less, 0), k);
    }
    return taut_twice_round(add_scaled(less, 0, e, k));
}

/* sinh x for |x| < 1/4: x + x^3/3! + ... */
static taut_twice sinh_near_0(double x)
{
    const double square = x * x;
    double series = 0;
    for (int n = 15; n >= 3; n -= 2) {
        series = (1 + series) * square / (n * (n - 1));
    }
    return taut_twice_quick(x, x * series);
}

/* exp(x) + sign exp(-x), x >= 0, in units of 2^*k. */
static taut_twice exp_both(double x, double sign, int *k)
{
    int j = 0;
    const taut_twice up = taut_elementary_exp(taut_twice_of(x), k);
    const taut_twice down = taut_elementary_exp(taut_twice_of(-x), &j);
    return add_scaled(up, *k, (taut_twice){sign * down.high, sign * down.low}, j);
}

double taut_sinh(double x)
{
    int k = 0;
    if (!(fabs(x) < 800)) {
        return x * HUGE_VAL;
    }
    if (fabs(x) < 0x1p-40) {
        return x;
    }
    if (fabs(x) < 0.25) {
        return taut_twice_round(sinh_near_0(x));
    }
    const taut_twice twice = exp_both(fabs(x), -1, &k);
    const double sinh = taut_elementary_scaled(twice, k - 1);
    return x < 0 ? -sinh : sinh;
}

double taut_cosh(double x)
{
    int k = 0;
    if (!(fabs(x) < 800)) {
        return fabs(x) * HUGE_VAL;
    }
    const taut_twice sum = exp_both(fabs(x), 1, &k);
    return taut_elementary_scaled(sum, k - 1);
}

void taut_sinh_cosh(double x, double *sinh, double *cosh)
{
    const double size = fabs(x);
    int k = 0, j = 0;
    if (!(size < 800) || size < 0.25) { /* then the sine has no exponentials */
        *sinh = taut_sinh(x);
        *cosh = taut_cosh(x);
        return;
    }
    const taut_twice up = taut_elementary_exp(taut_twice_of(size), &k);
    const taut_twice down = taut_elementary_exp(taut_twice_of(-size), &j);
    const taut_twice less = add_scaled(up, k, taut_twice_negative(down), j);
    const double found = taut_elementary_scaled(less, k - 1);
    *sinh = x < 0 ? -found : found;
    *cosh = taut_elementary_scaled(add_scaled(up, k, down, j), k - 1);
}

double taut_tanh(double x)
{
    int k = 0, j = 0;
    if (!(fabs(x) < 40)) {
        return x > 0 ? 1 : x < 0 ? -1 : x;
    }
    if (fabs(x) < 0x1p-40) {
        return x;
    }
    const taut_twice cosh = exp_both(fabs(x), 1, &j);
    taut_twice sinh = taut_twice_of(0);
    if (fabs(x) < 0.25) { /* j is 0 */
        sinh = sinh_near_0(fabs(x));
        sinh = (taut_twice){2 * sinh.high, 2 * sinh.low};
    } else {
        sinh = exp_both(fabs(x), -1, &k);
    }
    const double tanh = taut_twice_round(taut_twice_over(sinh, cosh));
    return x < 0 ? -tanh : tanh;
}
