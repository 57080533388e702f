/* fit.c -- opposite sides on one basis, exactly ([PieglTiller1997] section 10.3). */
#include "geometry/boundary/boundary.h"

#include "core/fail.h"
#include "taut/operations.h"

#include <math.h>
#include <string.h>

static const double same_knot = 1e-12; /* of the range: knots that rounding has parted */

static taut_status elevate_to(taut_curve **curve, int degree, taut_error *error)
{
    const int times = degree - taut_basis_degree(taut_curve_t(*curve));
    taut_curve *next = NULL;
    if (times <= 0) {
        return TAUT_OK;
    }
    const taut_status status = taut_curve_elevate(*curve, times, &next, error);
    return taut_boundary_replace(curve, next, status);
}

/* Is it on a basis whose degree and knots can be changed? */
static int is_polynomial(const taut_curve *curve)
{
    return taut_basis_degree(taut_curve_t(curve)) >= 1;
}

/* The same curve on a bspline basis over [lo, hi]. */
static taut_status to_spline(const taut_curve *side, double lo, double hi, taut_curve **spline,
                             taut_error *error)
{
    taut_curve *made = NULL, *next = NULL;
    taut_status status = taut_curve_to_nurbs(side, 1, &made, NULL, error);
    if (status == TAUT_OK &&
        (taut_basis_lo(taut_curve_t(made)) != lo || taut_basis_hi(taut_curve_t(made)) != hi)) {
        status = taut_curve_rerange(made, lo, hi, &next, error);
        status = taut_boundary_replace(&made, next, status);
    }
    if (status != TAUT_OK) {
        taut_curve_free(made);
        return status;
    }
    *spline = made;
    return TAUT_OK;
}

/* How often a knot near t is in a basis; *own is how it is spelled there. */
static int multiplicity(const taut_basis *basis, double t, double close, double *own)
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
static taut_status take_knots(taut_curve **curve, const taut_curve *other, taut_error *error)
{
    const taut_basis *basis = taut_curve_t(other);
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    const double close = same_knot * (breaks[spans] - breaks[0]);
    taut_status status = TAUT_OK;
    for (int s = 1; status == TAUT_OK && s < spans; s++) {
        taut_curve *next = NULL;
        double spelled = breaks[s], ignored = 0;
        const int wanted = multiplicity(basis, breaks[s], 0, &ignored);
        const int there = multiplicity(taut_curve_t(*curve), breaks[s], close, &spelled);
        if (wanted > there) {
            status = taut_curve_insert(*curve, spelled, wanted - there, &next, error);
            status = taut_boundary_replace(curve, next, status);
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
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", NULL, taut_none, taut_none,
                         "the knots of two opposite curves lie too close to be told apart");
    }
    status = taut_curve_new(taut_curve_name(*curve), taut_curve_t(other), taut_curve_points(*curve),
                            taut_curve_weights(*curve), &next, error);
    return taut_boundary_replace(curve, next, status);
}

static taut_status halve(taut_curve **curve, int times, taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int k = 0; status == TAUT_OK && k < times; k++) {
        taut_curve *next = NULL;
        status = taut_curve_refine(*curve, &next, error);
        status = taut_boundary_replace(curve, next, status);
    }
    return status;
}

/* Two opposite c- or h- sides: alike already, or not to be had. */
static taut_status fit_quasi(const taut_curve *a, const taut_curve *b, taut_curve *pair[2],
                             taut_error *error)
{
    if (!taut_basis_equal(taut_curve_t(a), taut_curve_t(b))) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", NULL, taut_none, taut_none,
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
    const double lo = taut_basis_lo(taut_curve_t(a)), hi = taut_basis_hi(taut_curve_t(a));
    taut_status status = to_spline(a, lo, hi, &pair[0], error);
    if (status == TAUT_OK) {
        status = to_spline(b, lo, hi, &pair[1], error);
    }
    for (int i = 0; status == TAUT_OK && i < 2; i++) {
        const int other = taut_basis_degree(taut_curve_t(pair[1 - i]));
        status = elevate_to(&pair[i], degree > other ? degree : other, error);
    }
    if (status == TAUT_OK) {
        status = take_knots(&pair[0], pair[1], error);
    }
    if (status == TAUT_OK) {
        status = take_knots(&pair[1], pair[0], error);
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
        status = halve(&pair[i], halvings, error);
    }
    return status;
}

static taut_status copy_sides(taut_curve *const sides[TAUT_SIDES], taut_curve *copies[TAUT_SIDES])
{
    taut_status status = TAUT_OK;
    for (int s = 0; status == TAUT_OK && s < TAUT_SIDES; s++) {
        status = taut_curve_copy(sides[s], &copies[s]);
    }
    return status;
}

taut_status taut_boundary_fit(taut_curve *const sides[TAUT_SIDES], const int degree[2],
                              const int halvings[2], taut_curve *fitted[TAUT_SIDES],
                              taut_error *error)
{
    taut_curve *copies[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    taut_curve *made[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    taut_status status = copy_sides(sides, copies) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);

    if (status == TAUT_OK) {
        status = taut_boundary_agree(copies, error);
    }
    if (status == TAUT_OK) {
        status = fit_pair(copies[TAUT_SIDE_V0], copies[TAUT_SIDE_V1], degree[0], halvings[0],
                          &made[TAUT_SIDE_V0], error);
    }
    if (status == TAUT_OK) {
        status = fit_pair(copies[TAUT_SIDE_U0], copies[TAUT_SIDE_U1], degree[1], halvings[1],
                          &made[TAUT_SIDE_U0], error);
    }
    taut_boundary_free(copies);
    if (status != TAUT_OK) {
        taut_boundary_free(made);
        return status;
    }
    memcpy(fitted, made, sizeof made);
    return TAUT_OK;
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
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", NULL, taut_basis_span_count(t), 1,
                         "a curve \"%.40s\" of type %s with %d spans, expected a Bezier curve",
                         taut_curve_name(*side), taut_basis_type(t), taut_basis_span_count(t));
    }
    status = taut_basis_new(&spec, 0, &bezier, error);
    if (status == TAUT_OK) {
        status = taut_curve_new(taut_curve_name(*side), bezier, taut_curve_points(*side),
                                taut_curve_weights(*side), &next, error);
    }
    taut_basis_free(bezier);
    return taut_boundary_replace(side, next, status);
}

taut_status taut_boundary_bezier(taut_curve *const sides[TAUT_SIDES], taut_curve *made[TAUT_SIDES],
                                 taut_error *error)
{
    taut_curve *copies[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    taut_status status = copy_sides(sides, copies) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);

    for (int s = 0; status == TAUT_OK && s < TAUT_SIDES; s++) {
        status = to_bezier(&copies[s], error);
    }
    if (status != TAUT_OK) {
        taut_boundary_free(copies);
        return status;
    }
    memcpy(made, copies, sizeof copies);
    return TAUT_OK;
}
