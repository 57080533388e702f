/* aspect.c -- the aspect of least energy ([WuWang2011] section 7.3).
 *
 *     f(lambda) = min_x  lambda a(x) + b(x)/lambda,   a = 1/2 iint |x_u|^2,  b = 1/2 iint |x_v|^2
 *     f'(lambda) = a - b/lambda^2 at the minimising x, so  lambda^2 = b/a  where f is least
 *
 * f may have several minima. A scan in steps of 4 finds the lowest place, and the sign change of
 * log(lambda^2 a/b) next to it is then closed in on by false position ([DahlquistBjorck2008] ch. 6,
 * the Illinois variant). Each f costs one solve; the eigenvectors of the box are kept.
 */
#include "construct/dirichlet/system.h"

#include "core/fail.h"

#include <math.h>

/* f and the slope's sign at one aspect. */
typedef struct sample {
    double log_aspect;
    double energy;
    double slope; /* log(lambda^2 a/b): negative where f falls */
} sample;

/* Steps of 4 from the aspect that makes fu = fv: scanned first, and at most. Beyond 4^20 the lesser
 * part of the energy is rounding of the other. */
enum { SCAN = 5, REACH = 20 };

/* Where the slope is rounding: sums of energies are good to about as much. */
static const double enough = 0x1p-50;

static taut_status take(taut_dirichlet_system *system, double log_aspect, double *net, sample *s,
                        taut_error *error)
{
    const double aspect = exp(log_aspect);
    double halves[2] = {0, 0};
    const taut_status status = taut_dirichlet_system_solve(system, aspect, net, error);

    if (status == TAUT_OK) {
        taut_dirichlet_system_energies(system, net, halves);
        s->log_aspect = log_aspect;
        s->energy = aspect * halves[0] + halves[1] / aspect;
        s->slope = halves[0] > 0 && halves[1] > 0 ? 2 * log_aspect + log(halves[0]) - log(halves[1])
                                                  : (halves[0] > halves[1] ? INFINITY : -INFINITY);
    }
    return status;
}

static taut_status no_aspect(int towards_infinity, taut_error *error)
{
    return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/aspect", taut_none, taut_none,
                     "the energy keeps falling as the aspect goes to %s: the surface shrinks to a "
                     "curve, so no aspect is best; give a number",
                     towards_infinity ? "infinity" : "0");
}

/* The lowest of the scan in best[1], its neighbours around it; goes further where it lies at an
 * end. */
static taut_status scan(taut_dirichlet_system *system, double middle, double *net, sample best[3],
                        taut_error *error)
{
    const double step = log(4.0);
    sample s[2 * REACH + 1];
    int from = REACH - SCAN, to = REACH + SCAN, lowest = from;
    taut_status status = TAUT_OK;

    for (int k = from; status == TAUT_OK && k <= to; k++) {
        status = take(system, middle + (k - REACH) * step, net, &s[k], error);
        lowest = status == TAUT_OK && s[k].energy < s[lowest].energy ? k : lowest;
    }
    while (status == TAUT_OK && (lowest == from || lowest == to)) {
        const int next = lowest == from ? from - 1 : to + 1;
        if (next < 0 || next > 2 * REACH) {
            return no_aspect(lowest == to, error);
        }
        status = take(system, middle + (next - REACH) * step, net, &s[next], error);
        from = next < from ? next : from;
        to = next > to ? next : to;
        lowest = status == TAUT_OK && s[next].energy < s[lowest].energy ? next : lowest;
        if (status == TAUT_OK && lowest != next) {
            break;
        }
    }
    for (int k = 0; status == TAUT_OK && k < 3; k++) {
        best[k] = s[lowest - 1 + k];
    }
    return status;
}

/* Closes in on the root of the slope between low (falling) and high (rising). A `high` where f
 * falls again, beyond a bump, is brought in by halving. */
static taut_status close_in(taut_dirichlet_system *system, sample low, sample high, double *net,
                            double *log_aspect, taut_error *error)
{
    double low_slope = low.slope, high_slope = high.slope;
    int side = 0; /* which end moved last: -1 low, 1 high */
    taut_status status = TAUT_OK;

    *log_aspect = low.log_aspect;
    for (int k = 0; status == TAUT_OK && k < 100; k++) {
        const double width = high.log_aspect - low.log_aspect;
        sample s;
        double at = low.log_aspect + 0.5 * width;
        if (high.slope > 0 && isfinite(high_slope) && isfinite(low_slope)) {
            at = low.log_aspect + width * (-low_slope / (high_slope - low_slope));
        }
        if (!(at > low.log_aspect && at < high.log_aspect)) {
            break;
        }
        *log_aspect = at;
        status = take(system, at, net, &s, error);
        if (status != TAUT_OK || fabs(s.slope) <= enough || width <= enough) {
            break;
        }
        if (s.slope < 0 && (high.slope > 0 || s.energy <= low.energy)) {
            high_slope *= side < 0 ? 0.5 : 1;
            low = s;
            low_slope = s.slope;
            side = -1;
        } else {
            low_slope *= side > 0 ? 0.5 : 1;
            high = s;
            high_slope = s.slope;
            side = 1;
        }
    }
    return status;
}

taut_status taut_dirichlet_system_aspect(taut_dirichlet_system *system, double *net, double *aspect,
                                         taut_error *error)
{
    const double natural = taut_dirichlet_system_natural_aspect(system);
    sample first, best[3];
    double log_aspect = 0;
    taut_status status = take(system, log(natural), net, &first, error);

    if (status == TAUT_OK && first.energy == 0) {
        *aspect = 1; /* a point: every aspect is as good */
        return TAUT_OK;
    }
    if (status == TAUT_OK) {
        status = scan(system, log(natural), net, best, error);
    }
    log_aspect = status == TAUT_OK ? best[1].log_aspect : 0;
    if (status == TAUT_OK && best[1].slope < -enough) {
        status = close_in(system, best[1], best[2], net, &log_aspect, error);
    } else if (status == TAUT_OK && best[1].slope > enough) {
        status = close_in(system, best[0], best[1], net, &log_aspect, error);
    }
    if (status == TAUT_OK) {
        *aspect = exp(log_aspect);
        status = taut_dirichlet_system_solve(system, *aspect, net, error);
    }
    return status;
}
