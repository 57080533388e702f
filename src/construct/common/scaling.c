#include "construct/common/scaling.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* x 2^e, rounded once: by a product where 2^e is a double, which is several times as fast as ldexp.
 */
static inline double times_power(double x, int e)
{
    const uint64_t bits = (uint64_t)(e + 1023) << 52;
    double power = 0;
    if (e < -1022 || e > 1023) {
        return ldexp(x, e);
    }
    memcpy(&power, &bits, sizeof power);
    return x * power;
}

/* The exponent e of max |x| = f 2^e, 1/2 <= f < 1; 0 for 0. */
static int exponent_of(double largest)
{
    int e = 0;
    (void)frexp(largest, &e);
    return e;
}

static void include_number(double x, double *lo, double *hi)
{
    *lo = fmin(*lo, x);
    *hi = fmax(*hi, x);
}

taut_scaling taut_scaling_of(size_t count, const double *points, const unsigned char *known)
{
    taut_scaling scaling = {{0, 0, 0}, 0, 0};
    double lo[3] = {INFINITY, INFINITY, INFINITY}, hi[3] = {-INFINITY, -INFINITY, -INFINITY};
    double largest = 0, size = 0;

    for (size_t i = 0; i < count; i++) {
        for (int c = 0; known[i] && c < 3; c++) {
            include_number(points[3 * i + (size_t)c], &lo[c], &hi[c]);
        }
    }
    for (int c = 0; c < 3; c++) {
        largest = fmax(largest, fmax(fabs(lo[c]), fabs(hi[c])));
    }
    scaling.outer = exponent_of(largest);
    for (int c = 0; c < 3; c++) {
        const double low = ldexp(lo[c], -scaling.outer), high = ldexp(hi[c], -scaling.outer);
        scaling.centre[c] = low + 0.5 * (high - low);
        size = fmax(size, fmax(high - scaling.centre[c], scaling.centre[c] - low));
    }
    scaling.inner = exponent_of(size);
    return scaling;
}

void taut_scaling_apply(const taut_scaling *scaling, const double *point, double *scaled)
{
    for (int c = 0; c < 3; c++) {
        const double near = times_power(point[c], -scaling->outer) - scaling->centre[c];
        scaled[c] = times_power(near, -scaling->inner);
    }
}

void taut_scaling_undo(const taut_scaling *scaling, const double *scaled, double *point)
{
    for (int c = 0; c < 3; c++) {
        const double far = times_power(scaled[c], scaling->inner) + scaling->centre[c];
        point[c] = times_power(far, scaling->outer);
    }
}

double taut_scaling_undo_square(const taut_scaling *scaling, double value)
{
    const int e = scaling->outer + scaling->inner;
    return times_power(times_power(value, e), e);
}
