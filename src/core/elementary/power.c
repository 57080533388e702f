/* power.c -- x^y = exp(y log x), the logarithm to 2^-66, so that what y makes of its error, up to 2^10
 * times as much, is below 1/16 of a unit in the last place. */
#include "core/elementary/elementary.h"
#include "core/elementary/internal.h"

static int is_whole(double y)
{
    return floor(y) == y;
}

static int is_odd(double y)
{
    return is_whole(y) && fabs(y) < 0x1p53 && !is_whole(y / 2);
}

/* x is 0 or infinite, y is not 0 nor NaN. */
static double power_of_end(double x, double y)
{
    const double size = (x == 0) == (y < 0) ? HUGE_VAL : 0;
    return is_odd(y) ? copysign(size, x) : size;
}

/* y is infinite, x is not 1 nor NaN. */
static double power_to_end(double x, double y)
{
    return fabs(x) == 1 ? 1 : (fabs(x) > 1) == (y > 0) ? HUGE_VAL : 0;
}

/* |x|^y for finite x that are not 0. */
static double power_of_size(double x, double y)
{
    int k = 0, j = 0;
    const double m = taut_elementary_split(fabs(x), &k);
    const taut_twice log = taut_elementary_log(m, k);
    if (fabs(y) > 0x1p70) { /* x is 1, or at least 2^-53 from it */
        return log.high == 0 ? 1 : (log.high > 0) == (y > 0) ? HUGE_VAL : 0;
    }
    const double size = log.high * y;
    if (fabs(size) > 1000) {
        return size > 0 ? HUGE_VAL : 0;
    }
    if (fabs(size) < 0x1p-60) {
        return 1;
    }
    const taut_twice power = taut_elementary_exp(taut_twice_times(log, taut_twice_of(y)), &j);
    return taut_elementary_scaled(power, j);
}

double taut_pow(double x, double y)
{
    if (y == 0 || x == 1) {
        return 1;
    }
    if (isnan(x) || isnan(y)) {
        return x + y;
    }
    if (isinf(y)) {
        return power_to_end(x, y);
    }
    if (x == 0 || isinf(x)) {
        return power_of_end(x, y);
    }
    if (x < 0 && !is_whole(y)) {
        return (x - x) / 0.0;
    }
    const double size = power_of_size(x, y);
    return x < 0 && is_odd(y) ? -size : size;
}
