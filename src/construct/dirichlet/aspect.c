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

#include "core/elementary/elementary.h"
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
enum { SCAN = 5, REACH = 20, CLOSINGS = 100 };

/* Where the slope is rounding: sums of energies are good to about as much. */
static const double slope_flat = 0x1p-50;

static taut_status find_sample(taut_dirichlet_system *system, double log_aspect, double *net,
                               sample *s, taut_error *error)
{
    const double aspect = taut_exp(log_aspect);
    double halves[2] = {0, 0};
    const taut_status status = taut_dirichlet_system_solve(system, aspect, net, error);

    if (status != TAUT_OK) {
        return status;
    }
    taut_dirichlet_system_energies(system, net, halves);
    s->log_aspect = log_aspect;
    s->energy = aspect * halves[0] + halves[1] / aspect;
    s->slope = halves[0] > 0 && halves[1] > 0
                   ? 2 * log_aspect + taut_log(halves[0]) - taut_log(halves[1])
                   : (halves[0] > halves[1] ? INFINITY : -INFINITY);
    return TAUT_OK;
}

static taut_status refuse_aspect(int towards_infinity, taut_error *error)
{
    return taut_fail(error, TAUT_NO_SOLUTION, "no-best-aspect", "/aspect", taut_none, taut_none,
                     "the energy keeps falling as the aspect goes to %s: the surface shrinks to a "
                     "curve, so no aspect is best; give a number",
                     towards_infinity ? "infinity" : "0");
}

/* The lowest of the scan in best[1], its neighbours around it; goes further where it lies at an
 * end. */
static taut_status scan_aspects(taut_dirichlet_system *system, double middle, double *net,
                                sample best[3], taut_error *error)
{
    const double step = taut_log(4.0);
    sample s[2 * REACH + 1];
    int from = REACH - SCAN, to = REACH + SCAN, lowest = from;

    for (int k = from; k <= to; k++) {
        const taut_status status =
            find_sample(system, middle + (k - REACH) * step, net, &s[k], error);
        if (status != TAUT_OK) {
            return status;
        }
        lowest = s[k].energy < s[lowest].energy ? k : lowest;
    }
    while (lowest == from || lowest == to) {
        const int next = lowest == from ? from - 1 : to + 1;
        taut_status status = TAUT_OK;
        if (next < 0 || next > 2 * REACH) {
            return refuse_aspect(lowest == to, error);
        }
        status = find_sample(system, middle + (next - REACH) * step, net, &s[next], error);
        if (status != TAUT_OK) {
            return status;
        }
        from = next < from ? next : from;
        to = next > to ? next : to;
        if (!(s[next].energy < s[lowest].energy)) {
            break;
        }
        lowest = next;
    }
    for (int k = 0; k < 3; k++) {
        best[k] = s[lowest - 1 + k];
    }
    return TAUT_OK;
}

/* Closes in on the root of the slope between low (falling) and high (rising). A `high` where f
 * falls again, beyond a bump, is brought in by halving. */
static taut_status close_in(taut_dirichlet_system *system, sample low, sample high, double *net,
                            double *log_aspect, taut_error *error)
{
    double low_slope = low.slope, high_slope = high.slope;
    int side = 0; /* which end moved last: -1 low, 1 high */

    *log_aspect = low.log_aspect;
    for (int k = 0; k < CLOSINGS; k++) {
        const double width = high.log_aspect - low.log_aspect;
        taut_status status = TAUT_OK;
        sample s;
        double at = low.log_aspect + 0.5 * width;
        if (high.slope > 0 && isfinite(high_slope) && isfinite(low_slope)) {
            at = low.log_aspect + width * (-low_slope / (high_slope - low_slope));
        }
        if (!(at > low.log_aspect && at < high.log_aspect)) {
            break;
        }
        *log_aspect = at;
        status = find_sample(system, at, net, &s, error);
        if (status != TAUT_OK) {
            return status;
        }
        if (fabs(s.slope) <= slope_flat || width <= slope_flat) {
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
    return TAUT_OK;
}

/* *log_aspect: where f is least; net is that of some aspect near it. */
static taut_status find_least(taut_dirichlet_system *system, double *net, double *log_aspect,
                              int *is_point, taut_error *error)
{
    const double natural = taut_log(taut_dirichlet_system_natural_aspect(system));
    sample first, best[3];
    taut_status status = find_sample(system, natural, net, &first, error);

    if (status != TAUT_OK) {
        return status;
    }
    *is_point = first.energy == 0;
    if (*is_point) {
        return TAUT_OK;
    }
    status = scan_aspects(system, natural, net, best, error);
    if (status != TAUT_OK) {
        return status;
    }
    *log_aspect = best[1].log_aspect;
    if (best[1].slope < -slope_flat) {
        return close_in(system, best[1], best[2], net, log_aspect, error);
    }
    if (best[1].slope > slope_flat) {
        return close_in(system, best[0], best[1], net, log_aspect, error);
    }
    return TAUT_OK;
}

taut_status taut_dirichlet_system_aspect(taut_dirichlet_system *system, double *net, double *aspect,
                                         taut_error *error)
{
    double log_aspect = 0;
    int is_point = 0;
    const taut_status status = find_least(system, net, &log_aspect, &is_point, error);

    if (status != TAUT_OK) {
        return status;
    }
    *aspect = is_point ? 1 : taut_exp(log_aspect); /* of a point every aspect is as good */
    return is_point ? TAUT_OK : taut_dirichlet_system_solve(system, *aspect, net, error);
}
