/* fit.c -- opposite sides on one basis, exactly ([PieglTiller1997] section 10.3), with weights that
 * agree at the corners they share. */
#include "geometry/boundary/boundary.h"

#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/memory.h"
#include "taut/operations.h"

#include <math.h>
#include <string.h>

static const double same_knot = 1e-12; /* of the range: knots that rounding has parted */
/* Ratios of weights this near to 1 are rounding; up to the second they pass where nothing can be
 * done. */
static const double same_ratio = 1e-14, near_ratio = 1e-10;

/* Puts `next` in the place of *curve where status says that an operation gave it; returns status. */
static taut_status replace_curve(taut_curve **curve, taut_curve *next, taut_status status)
{
    if (status != TAUT_OK) {
        return status;
    }
    taut_curve_free(*curve);
    *curve = next;
    return TAUT_OK;
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
        weights[i] = (old != NULL ? old[i] : 1) * factor * taut_pow(ratio, i);
    }
    status =
        taut_curve_new(taut_curve_name(*side), t, taut_curve_points(*side), weights, &next, error);
    taut_free(weights);
    return replace_curve(side, next, status);
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
                side, 1, taut_pow(off, (double)takers[i].power / (taut_basis_count(t) - 1)), error);
        }
    }
    if (fabs(off - 1) <= near_ratio) {
        return TAUT_OK;
    }
    return taut_fail(
        error, TAUT_NO_SOLUTION, "corner-weights", NULL, off, 1,
        "the weights do not agree at the corners: around them they grow by a factor of "
        "%.6g, expected 1",
        off);
}

/* v0 stays; u0 and u1 are scaled to its ends, v1 to the end of u0: then it ends as u1 does. */
taut_status taut_boundary_agree(taut_curve *sides[TAUT_SIDES], taut_error *error)
{
    static const struct {
        int side, other, last; /* what `side` begins with is what `other` has at that end */
    } corners[3] = {{TAUT_SIDE_U0, TAUT_SIDE_V0, 0},
                    {TAUT_SIDE_U1, TAUT_SIDE_V0, 1},
                    {TAUT_SIDE_V1, TAUT_SIDE_U0, 1}};
    taut_status status = TAUT_OK;
    if (!taut_boundary_is_rational(sides)) {
        return TAUT_OK;
    }
    status = close_weights(sides, error);
    for (int k = 0; status == TAUT_OK && k < 3; k++) {
        taut_curve **side = &sides[corners[k].side];
        const double wanted = end_weight(sides[corners[k].other], corners[k].last);
        status = scale_weights(side, wanted / end_weight(*side, 0), 1, error);
    }
    return status;
}

static taut_status elevate_to(taut_curve **curve, int degree, taut_error *error)
{
    const int times = degree - taut_basis_degree(taut_curve_t(*curve));
    taut_curve *next = NULL;
    if (times <= 0) {
        return TAUT_OK;
    }
    const taut_status status = taut_curve_elevate(*curve, times, &next, error);
    return replace_curve(curve, next, status);
}

/* Is it on a basis whose degree and knots can be changed? */
static int is_polynomial(const taut_curve *curve)
{
    return taut_basis_degree(taut_curve_t(curve)) >= 1;
}

/* The same curve on a bspline basis over [lo, hi]. On failure *spline may hold what is to be freed. */
static taut_status to_spline(const taut_curve *side, double lo, double hi, taut_curve **spline,
                             taut_error *error)
{
    taut_curve *next = NULL;
    taut_status status = taut_curve_to_nurbs(side, 1, spline, NULL, error);
    if (status != TAUT_OK || (taut_basis_lo(taut_curve_t(*spline)) == lo &&
                              taut_basis_hi(taut_curve_t(*spline)) == hi)) {
        return status;
    }
    status = taut_curve_rerange(*spline, lo, hi, &next, error);
    return replace_curve(spline, next, status);
}

/* How often a knot near t is in a basis; *own is how it is spelled there. */
static int count_knots(const taut_basis *basis, double t, double close, double *own)
{
    taut_basis_spec spec;
    int times = 0;
    taut_basis_spec_of(basis, &spec);
    for (int i = 0; i < spec.knot_count; i++) {
        if (fabs(spec.knots[i] - t) <= close) {
            *own = spec.knots[i];
            times++;
        }
    }
    return times;
}

/* Puts the inner knots of `other` into *curve as often as they are there. */
static taut_status insert_knots_of(taut_curve **curve, const taut_curve *other, taut_error *error)
{
    const taut_basis *basis = taut_curve_t(other);
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    const double close = same_knot * (breaks[spans] - breaks[0]);
    taut_status status = TAUT_OK;
    for (int s = 1; status == TAUT_OK && s < spans; s++) {
        taut_curve *next = NULL;
        double spelled = breaks[s], ignored = 0;
        const int wanted = count_knots(basis, breaks[s], 0, &ignored);
        const int there = count_knots(taut_curve_t(*curve), breaks[s], close, &spelled);
        if (wanted > there) {
            status = taut_curve_insert(*curve, spelled, wanted - there, &next, error);
            status = replace_curve(curve, next, status);
        }
    }
    return status;
}

/* The curve over again, on the basis of its opposite: as many knots, apart by rounding. */
static taut_status share_basis(taut_curve **curve, const taut_curve *other, taut_error *error)
{
    taut_curve *next = NULL;
    taut_status status = TAUT_OK;
    if (taut_basis_count(taut_curve_t(*curve)) != taut_basis_count(taut_curve_t(other))) {
        return taut_fail(error, TAUT_NO_SOLUTION, "close-knots", NULL, taut_none, taut_none,
                         "the knots of two opposite curves lie too close to be distinguished");
    }
    status = taut_curve_new(taut_curve_name(*curve), taut_curve_t(other), taut_curve_points(*curve),
                            taut_curve_weights(*curve), &next, error);
    return replace_curve(curve, next, status);
}

static taut_status halve_spans(taut_curve **curve, int times, taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int k = 0; status == TAUT_OK && k < times; k++) {
        taut_curve *next = NULL;
        status = taut_curve_refine(*curve, &next, error);
        status = replace_curve(curve, next, status);
    }
    return status;
}

/* Two opposite c- or h- sides: alike already, or not to be had. */
static taut_status fit_quasi(const taut_curve *a, const taut_curve *b, taut_curve *pair[2],
                             taut_error *error)
{
    if (!taut_basis_equal(taut_curve_t(a), taut_curve_t(b))) {
        return taut_fail(error, TAUT_NO_SOLUTION, "bases-differ", NULL, taut_none, taut_none,
                         "opposite curves are on bases of type %s and %s that differ: give both on "
                         "the same one, or convert them to B-splines",
                         taut_basis_type(taut_curve_t(a)), taut_basis_type(taut_curve_t(b)));
    }
    if (taut_curve_copy(a, &pair[0]) != TAUT_OK || taut_curve_copy(b, &pair[1]) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return TAUT_OK;
}

static taut_status fit_polynomial(const taut_curve *a, const taut_curve *b, int degree,
                                  taut_curve *pair[2], taut_error *error)
{
    const taut_curve *given[2] = {a, b};
    const double lo = taut_basis_lo(taut_curve_t(a)), hi = taut_basis_hi(taut_curve_t(a));
    taut_status status = TAUT_OK;

    for (int i = 0; status == TAUT_OK && i < 2; i++) {
        status = to_spline(given[i], lo, hi, &pair[i], error);
    }
    for (int i = 0; status == TAUT_OK && i < 2; i++) {
        const int other = taut_basis_degree(taut_curve_t(pair[1 - i]));
        status = elevate_to(&pair[i], degree > other ? degree : other, error);
    }
    for (int i = 0; status == TAUT_OK && i < 2; i++) {
        status = insert_knots_of(&pair[i], pair[1 - i], error);
    }
    return status == TAUT_OK ? share_basis(&pair[1], pair[0], error) : status;
}

/* New curves for two opposite sides. On failure pair may hold what is to be freed. */
static taut_status fit_pair(const taut_curve *a, const taut_curve *b, int degree, int halvings,
                            taut_curve *pair[2], taut_error *error)
{
    taut_status status = is_polynomial(a) && is_polynomial(b)
                             ? fit_polynomial(a, b, degree, pair, error)
                             : fit_quasi(a, b, pair, error);
    for (int i = 0; status == TAUT_OK && i < 2; i++) {
        status = halve_spans(&pair[i], halvings, error);
    }
    return status;
}

static taut_status copy_sides(taut_curve *const sides[TAUT_SIDES], taut_curve *copies[TAUT_SIDES],
                              taut_error *error)
{
    for (int s = 0; s < TAUT_SIDES; s++) {
        if (taut_curve_copy(sides[s], &copies[s]) != TAUT_OK) {
            return taut_fail_memory(error);
        }
    }
    return TAUT_OK;
}

/* Hands the sides over, or frees them. */
static taut_status hand_over(taut_status status, taut_curve *made[TAUT_SIDES],
                             taut_curve *sides[TAUT_SIDES])
{
    if (status != TAUT_OK) {
        taut_boundary_free(made);
        return status;
    }
    memcpy(sides, made, TAUT_SIDES * sizeof *made);
    return TAUT_OK;
}

/* `copies` of the sides, and what they become; on failure both may hold what is to be freed. */
static taut_status fit_sides(taut_curve *const sides[TAUT_SIDES], const int degree[2],
                             const int halvings[2], taut_curve *copies[TAUT_SIDES],
                             taut_curve *made[TAUT_SIDES], taut_error *error)
{
    taut_status status = copy_sides(sides, copies, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_boundary_agree(copies, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = fit_pair(copies[TAUT_SIDE_V0], copies[TAUT_SIDE_V1], degree[0], halvings[0],
                      &made[TAUT_SIDE_V0], error);
    if (status != TAUT_OK) {
        return status;
    }
    return fit_pair(copies[TAUT_SIDE_U0], copies[TAUT_SIDE_U1], degree[1], halvings[1],
                    &made[TAUT_SIDE_U0], error);
}

taut_status taut_boundary_fit(taut_curve *const sides[TAUT_SIDES], const int degree[2],
                              const int halvings[2], taut_curve *fitted[TAUT_SIDES],
                              taut_error *error)
{
    taut_curve *copies[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    taut_curve *made[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    const taut_status status = fit_sides(sides, degree, halvings, copies, made, error);

    taut_boundary_free(copies);
    return hand_over(status, made, fitted);
}

/* One side on a bezier basis over [0, 1]. */
static taut_status to_bezier(taut_curve **side, taut_error *error)
{
    const taut_basis *t = taut_curve_t(*side);
    const taut_basis_spec spec = {.type = "bezier", .degree = taut_basis_degree(t)};
    taut_basis *bezier = NULL;
    taut_curve *next = NULL;
    taut_status status = TAUT_OK;
    if (!is_polynomial(*side) || taut_basis_span_count(t) != 1) {
        return taut_fail_expected(
            error, TAUT_NO_SOLUTION, "not-bezier", NULL, taut_basis_span_count(t), "a Bezier curve",
            "a curve \"%.40s\" of type %s with %d spans", taut_curve_name(*side),
            taut_basis_type(t), taut_basis_span_count(t));
    }
    status = taut_basis_new(&spec, 0, &bezier, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_curve_new(taut_curve_name(*side), bezier, taut_curve_points(*side),
                            taut_curve_weights(*side), &next, error);
    taut_basis_free(bezier);
    return replace_curve(side, next, status);
}

taut_status taut_boundary_bezier(taut_curve *const sides[TAUT_SIDES], taut_curve *made[TAUT_SIDES],
                                 taut_error *error)
{
    taut_curve *copies[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    taut_status status = copy_sides(sides, copies, error);

    for (int s = 0; status == TAUT_OK && s < TAUT_SIDES; s++) {
        status = to_bezier(&copies[s], error);
    }
    return hand_over(status, copies, made);
}
