#include "construct/common/scaling.h"

#include "core/fail.h"

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

void taut_scaling_apply(const taut_scaling *scaling, size_t count, const double *points,
                        const unsigned char *known, double *net)
{
    for (size_t i = 0; i < count; i++) {
        for (size_t c = 0; c < 3; c++) {
            double *scaled = net + 3 * i + c;
            *scaled = 0;
            if (known == NULL || known[i]) {
                const double near =
                    times_power(points[3 * i + c], -scaling->outer) - scaling->centre[c];
                *scaled = times_power(near, -scaling->inner);
            }
        }
    }
}

taut_status taut_scaling_undo(const taut_scaling *scaling, size_t count, const double *given,
                              const unsigned char *known, const double *net, double *points,
                              taut_error *error)
{
    for (size_t i = 0; i < 3 * count; i++) {
        const double far = times_power(net[i], scaling->inner) + scaling->centre[i % 3];
        points[i] = known[i / 3] ? given[i] : times_power(far, scaling->outer);
    }
    for (size_t i = 0; i < 3 * count; i++) {
        if (!isfinite(points[i])) {
            return taut_fail(error, TAUT_NO_SOLUTION, "overflow", "/points", taut_none, taut_none,
                             "a point of the solution is beyond the range of double precision: "
                             "scale the points down");
        }
    }
    return TAUT_OK;
}

double taut_scaling_undo_square(const taut_scaling *scaling, double value)
{
    const int e = scaling->outer + scaling->inner;
    return times_power(times_power(value, e), e);
}
