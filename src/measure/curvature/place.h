/* place.h -- where the nodes of a rule lie in a span, to more digits than a parameter holds. */
#ifndef TAUT_MEASURE_CURVATURE_PLACE_H
#define TAUT_MEASURE_CURVATURE_PLACE_H

#include "numeric/sum.h"

#include <math.h>

/* Node -1 .. 1 of [lo, hi]: the parameter, never outside, and in *rest what rounding takes off it.
 */
static inline double taut_node_place(double lo, double hi, double node, double *rest)
{
    const double half = (hi - lo) / 2, middle = lo + half, step = half * node;
    const double t = middle + step, inside = fmin(fmax(t, lo), hi);
    *rest = taut_sum_rest(lo, half) + taut_sum_rest(middle, step) + (t - inside);
    return inside;
}

#endif /* TAUT_MEASURE_CURVATURE_PLACE_H */
