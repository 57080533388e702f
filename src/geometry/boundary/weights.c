/* weights.c -- weights of four sides that agree at the corners they share. */
#include "geometry/boundary/boundary.h"

#include "core/fail.h"
#include "core/memory.h"

#include <math.h>

/* Ratios this near to 1 are rounding; up to the second they pass where nothing can be done. */
static const double same_ratio = 1e-14, near_ratio = 1e-10;

taut_status taut_boundary_replace(taut_curve **curve, taut_curve *next, taut_status status)
{
    if (status == TAUT_OK) {
        taut_curve_free(*curve);
        *curve = next;
    }
    return status;
}

/* Weights w_i of a side become factor ratio^i w_i: a scale, and for one Bezier span a change of
 * parameter that is linear over linear. */
static taut_status scale_weights(taut_curve **side, double factor, double ratio, taut_error *error)
{
    const taut_basis *t = taut_curve_t(*side);
    const int count = taut_basis_count(t);
    const double *old = taut_curve_weights(*side);
    double *weights = taut_alloc((size_t)count, sizeof *weights);
    taut_curve *next = NULL;
    taut_status status = TAUT_OK;
    if (weights == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < count; i++) {
        weights[i] = (old != NULL ? old[i] : 1) * factor * pow(ratio, i);
    }
    status =
        taut_curve_new(taut_curve_name(*side), t, taut_curve_points(*side), weights, &next, error);
    taut_free(weights);
    return taut_boundary_replace(side, next, status);
}

static double end_weight(const taut_curve *side, int last)
{
    const double *weights = taut_curve_weights(side);
    return weights == NULL ? 1 : weights[last ? taut_basis_count(taut_curve_t(side)) - 1 : 0];
}

/* Around the corners from u0v0 to u1v1 the end weights grow by the ratios of v0 and u1, or of u0
 * and v1: if the two products differ, a side of one span takes the difference. */
static taut_status close_weights(taut_curve *sides[TAUT_SIDES], taut_error *error)
{
    static const struct {
        int side, power;
    } takers[] = {{TAUT_SIDE_V1, 1}, {TAUT_SIDE_U0, 1}, {TAUT_SIDE_U1, -1}, {TAUT_SIDE_V0, -1}};
    double ratios[TAUT_SIDES], off = 0;
    for (int s = 0; s < TAUT_SIDES; s++) {
        ratios[s] = end_weight(sides[s], 1) / end_weight(sides[s], 0);
    }
    off = ratios[TAUT_SIDE_V0] / ratios[TAUT_SIDE_U0] * ratios[TAUT_SIDE_U1] / ratios[TAUT_SIDE_V1];
    if (fabs(off - 1) <= same_ratio) {
        return TAUT_OK;
    }
    for (size_t i = 0; i < sizeof takers / sizeof takers[0]; i++) {
        taut_curve **side = &sides[takers[i].side];
        const taut_basis *t = taut_curve_t(*side);
        if (taut_basis_degree(t) >= 1 && taut_basis_span_count(t) == 1) {
            return scale_weights(
                side, 1, pow(off, (double)takers[i].power / (taut_basis_count(t) - 1)), error);
        }
    }
    if (fabs(off - 1) <= near_ratio) {
        return TAUT_OK;
    }
    return taut_fail(
        error, TAUT_NO_SOLUTION, "no-solution", NULL, off, 1,
        "the weights do not agree at the corners: around them they grow by a factor of "
        "%.6g, expected 1",
        off);
}

/* v0 stays; u0 and u1 are scaled to its ends, v1 to the end of u0: then it ends as u1 does. */
taut_status taut_boundary_agree(taut_curve *sides[TAUT_SIDES], taut_error *error)
{
    taut_status status = TAUT_OK;
    if (!taut_boundary_is_rational(sides)) {
        return TAUT_OK;
    }
    status = close_weights(sides, error);
    for (int last = 0; status == TAUT_OK && last < 2; last++) {
        taut_curve **u = &sides[last ? TAUT_SIDE_U1 : TAUT_SIDE_U0];
        const double wanted = end_weight(sides[TAUT_SIDE_V0], last);
        status = scale_weights(u, wanted / end_weight(*u, 0), 1, error);
    }
    if (status == TAUT_OK) {
        const double wanted = end_weight(sides[TAUT_SIDE_U0], 1);
        status = scale_weights(&sides[TAUT_SIDE_V1], wanted / end_weight(sides[TAUT_SIDE_V1], 0), 1,
                               error);
    }
    return status;
}
