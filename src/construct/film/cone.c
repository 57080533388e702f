/* cone.c -- the theorem of the cone.
 *
 * A connected minimal surface is bounded by no two curves of which one lies in each nappe of the open
 * cone  rho < |z| sinh(t0),  t0 tanh(t0) = 1, whatever its apex and its axis. With heights along the axis
 * there is an apex between them when
 *
 *     max (z + rho / sinh t0) over the lower curve  <  min (z - rho / sinh t0) over the upper
 *
 * A nappe is convex: the control points of what is held will do for the proof. The axis is looked for by steps from the one
 * through the middles.
 */
#include "construct/film/cone.h"

#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <string.h>

enum { HALVINGS = 24, NODES = 16 };
static const double sinh_t0 = 1.5088795615383199;
static const double near_enough = 0.2; /* of the widths: room that a better axis may make */

double taut_film_cone_gap(taut_film_rims *rims, const double axis[6])
{
    double n[3] = {axis[3], axis[4], axis[5]}, low[2] = {INFINITY, INFINITY},
           high[2] = {-INFINITY, -INFINITY}, end[2] = {-INFINITY, INFINITY};
    const double size = taut_norm(n);

    for (int c = 0; c < 3; c++) {
        n[c] /= size;
    }
    rims->span[0] = rims->span[1] = 0;
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < rims->count[k]; i++) {
            double from[3], across[3];
            taut_difference(rims->points[k] + 3 * i, axis, from);
            taut_cross(n, from, across);
            const double z = taut_dot(n, from), wide = taut_norm(across) / sinh_t0;
            rims->span[k] = fmax(rims->span[k], wide);
            low[k] = fmin(low[k], z);
            high[k] = fmax(high[k], z);
            end[k] = k == 0 ? fmax(end[k], z + wide) : fmin(end[k], z - wide);
        }
    }
    rims->height = low[1] - high[0];
    return end[1] - end[0];
}

/* The axis with the most room, by steps along its six numbers that are halved. */
static double widen_gap(taut_film_rims *rims, double axis[6], double size)
{
    double best = taut_film_cone_gap(rims, axis), step = 0.1 * size;

    for (int halved = 0; halved < HALVINGS;) {
        int better = 0;
        for (int k = 0; k < 12; k++) {
            double tried[6];
            memcpy(tried, axis, sizeof tried);
            tried[k / 2] += k % 2 == 0 ? step : -step;
            const double gap = taut_film_cone_gap(rims, tried);
            if (gap > best) {
                best = gap;
                memcpy(axis, tried, sizeof tried);
                better = 1;
            }
        }
        if (!better) {
            step *= 0.5;
            halved++;
        }
    }
    return best;
}

double taut_film_cone_widest(taut_film_rims *rims, double axis[6])
{
    const double size = taut_norm(axis + 3);
    double gap = -1;

    if (size > 0) {
        gap = taut_film_cone_gap(rims, axis);
        if (gap <= 0 && gap > -near_enough * (rims->span[0] + rims->span[1])) {
            gap = widen_gap(rims, axis, size);
        }
    }
    return gap;
}

taut_status taut_film_cone_refuse(const taut_film_rims *rims, int digits, const char *where,
                                  taut_error *error)
{
    const double most = rims->span[0] + rims->span[1];
    return taut_fail(error, TAUT_NO_SOLUTION, "collapses", where, rims->height, most,
                     "no film spans both rims, which is proved: they are %.15g apart, and lie in "
                     "the two halves of a cone that no film connects; rims as wide as these are "
                     "joined up to %.*g at most: bring them together",
                     rims->height, digits, most);
}

double taut_film_cone_area(const taut_curve *curve, const double tip[3])
{
    const taut_basis *t = taut_curve_t(curve);
    const double *breaks = taut_basis_breaks(t);
    double node[NODES], weight[NODES], area = 0;

    taut_gauss_rule(NODES, node, weight);
    for (int k = 0; k < taut_basis_span_count(t) * NODES; k++) {
        const double lo = breaks[k / NODES], half = 0.5 * (breaks[k / NODES + 1] - lo);
        double x[2][3], from[3], turned[3];
        (void)taut_curve_eval(curve, lo + half * (1 + node[k % NODES]), 1, x[0]);
        taut_difference(x[0], tip, from);
        taut_cross(from, x[1], turned);
        area += 0.5 * half * weight[k % NODES] * taut_norm(turned);
    }
    return area;
}
