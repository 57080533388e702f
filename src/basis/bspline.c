/* bspline.c -- clamped B-splines on any legal knots.
 *
 * Degree p, n functions, full knots t_0 <= ... <= t_{n+p}, clamped: t_0 = .. = t_p < t_{p+1} and
 * t_{n-1} < t_n = .. = t_{n+p}; inner multiplicity at most p, so that the functions are continuous
 * ([WuWang2011] section 2.1; multiplicity p+1 may tear the surface). The form without the outermost
 * two knots is told by its length. Values by the recurrence of [PieglTiller1997] A2.2, which
 * divides by knot differences of non-empty supports only; derivatives by raising saved rows of
 * lower degree.
 */
#include "basis/basis_ops.h"
#include "basis/change.h"
#include "core/fail.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Knot i of the full form out of the given knots, of which `dropped` (0 or 1) are left out at
 * each end. */
static double full_knot(const taut_basis_spec *spec, int dropped, int i)
{
    const int last = spec->knot_count - 1;
    const int j = i - dropped;
    return spec->knots[j < 0 ? 0 : j > last ? last : j];
}

/* How many knots are left out at each end: decided by the number of functions. */
static int knots_dropped(const taut_basis_spec *spec, int functions)
{
    return functions > 0 && spec->knot_count == functions + spec->degree - 1 ? 1 : 0;
}

static taut_status check_clamped(const taut_basis_spec *spec, int dropped, int count,
                                 taut_error *error)
{
    const int p = spec->degree;
    const double lo = full_knot(spec, dropped, 0);
    const double hi = full_knot(spec, dropped, count + p);
    if (!(hi > lo) || !isfinite(hi - lo)) {
        return taut_fail(error, TAUT_BAD_INPUT, "knots", "/knots", hi - lo, 0,
                         "the knots run from %.17g to %.17g, expected a range that is not empty",
                         lo, hi);
    }
    if (full_knot(spec, dropped, p) != lo || full_knot(spec, dropped, count) != hi) {
        return taut_fail(error, TAUT_BAD_INPUT, "knots", "/knots", taut_none, p + 1,
                         "the knots are not clamped: expected the first and the last to come %d "
                         "times (or once less, without the outermost two)",
                         p + 1);
    }
    if (full_knot(spec, dropped, p + 1) == lo || full_knot(spec, dropped, count - 1) == hi) {
        return taut_fail(error, TAUT_BAD_INPUT, "knots", "/knots", taut_none, p + 1,
                         "an end knot comes more than %d times", p + 1);
    }
    return TAUT_OK;
}

/* Checks the ends, then the knots one by one; counts non-empty spans. */
static taut_status check_knots(const taut_basis_spec *spec, int dropped, int count, int *spans,
                               taut_error *error)
{
    const int p = spec->degree;
    const int total = count + p + 1;
    char where[48];
    int run = 0; /* how often the current value has come so far */
    const taut_status status = check_clamped(spec, dropped, count, error);

    if (status != TAUT_OK) {
        return status;
    }
    *spans = 0;
    for (int i = 0; i < total; i++) {
        const double knot = full_knot(spec, dropped, i);
        const double before = i > 0 ? full_knot(spec, dropped, i - 1) : knot;
        const int given = i - dropped < 0 ? 0 : i - dropped;
        snprintf(where, sizeof where, "/knots/%d", given);
        if (!isfinite(knot)) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", where, knot, taut_none,
                             "a knot is not a finite number");
        }
        if (knot < before) {
            return taut_fail(error, TAUT_BAD_INPUT, "knots", where, knot, before,
                             "knot %.17g comes after %.17g, expected knots that do not decrease",
                             knot, before);
        }
        run = i > 0 && knot == before ? run + 1 : 1;
        *spans += i > 0 && knot > before;
        if (i > p && i < count && run > p) {
            return taut_fail(error, TAUT_BAD_INPUT, "knots", where, run, p,
                             "inner knot %.17g is repeated %d times, expected at most the degree, "
                             "%d: more would tear the surface",
                             knot, run, p);
        }
    }
    return TAUT_OK;
}

static taut_status bspline_plan(const taut_basis_ops *ops, const taut_basis_spec *spec,
                                int functions, taut_basis_shape *shape, taut_error *error)
{
    const int p = spec->degree;
    int count = spec->count;
    int spans = 0;

    (void)ops;
    if ((spec->knots == NULL) == (spec->count == 0)) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict", "", taut_none, taut_none,
                         "a bspline needs either \"knots\" or \"count\"");
    }
    if (spec->knots != NULL) {
        if (spec->knot_count < 0 || spec->knot_count > TAUT_COUNT_MAX + 2 * TAUT_DEGREE_MAX) {
            return taut_fail(error, TAUT_BAD_INPUT, "size", "/knots", spec->knot_count,
                             TAUT_COUNT_MAX, "%d knots are too many", spec->knot_count);
        }
        const int dropped = knots_dropped(spec, functions);
        count = spec->knot_count + 2 * dropped - p - 1;
        if (functions > 0 && count != functions) {
            return taut_fail(error, TAUT_BAD_INPUT, "size", "/knots", spec->knot_count,
                             functions + p + 1,
                             "%d knots, expected %d (or %d without the outermost two) for %d "
                             "points of degree %d",
                             spec->knot_count, functions + p + 1, functions + p - 1, functions, p);
        }
    }
    if (count < p + 1) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", spec->knots != NULL ? "/knots" : "/count",
                         count, p + 1, "%d functions of degree %d, expected at least %d", count, p,
                         p + 1);
    }
    if (spec->knots != NULL) {
        const taut_status status =
            check_knots(spec, knots_dropped(spec, functions), count, &spans, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    *shape = (taut_basis_shape){count, p + 1, spec->knots != NULL ? spans : count - p,
                                count <= TAUT_COUNT_MAX ? count + p + 1 : 0, p};
    return TAUT_OK;
}

static void bspline_fill(taut_basis *basis)
{
    const int p = basis->spec.degree;
    const int count = basis->shape.count;
    double *knots = basis->knots;
    int span = 0;

    if (basis->spec.knots != NULL) {
        const int dropped = basis->shape.knot_count > basis->spec.knot_count;
        for (int i = 0; i < count + p + 1; i++) {
            knots[i] = full_knot(&basis->spec, dropped, i);
        }
    } else {
        for (int i = 0; i < count + p + 1; i++) {
            const int inner = i - p < 0 ? 0 : i > count ? count - p : i - p;
            knots[i] = (double)inner / (count - p);
        }
    }
    basis->spec.count = 0; /* the knots say it all from here on */
    for (int i = p; i < count; i++) {
        if (knots[i + 1] > knots[i]) {
            basis->breaks[span] = knots[i];
            basis->first[span] = i - p;
            basis->knot_span[span] = i;
            span++;
        }
    }
    basis->breaks[span] = knots[count];
    assert(span == basis->shape.span_count);
}

/* Reciprocal knot differences of the highest TAUT_ORDER_MAX degrees:
 *     inverse[p - m][r] = 1 / (t_{i+r+1} - t_{i+r+1-m}),   r = 0..m-1,   never of an empty support
 */
typedef double reciprocals[TAUT_ORDER_MAX][TAUT_DEGREE_MAX];

/* Raises b[0..m-1], the functions of degree m-1 alive on knot interval i, to degree m
 * ([PieglTiller1997] A2.2); left[j] = t - t_{i+1-j}, right[j] = t_{i+j} - t. */
static void raise_degree(int m, const double *left, const double *right, double *inverse, double *b)
{
    double saved = 0;
    for (int r = 0; r < m; r++) {
        inverse[r] = 1 / (right[r + 1] + left[m - r]);
        const double part = b[r] * inverse[r];
        b[r] = saved + right[r + 1] * part;
        saved = left[m - r] * part;
    }
    b[m] = saved;
}

/* b[0..m-1] holds functions of degree m-1 on entry, derivatives of those of degree m on return:
 *     N'_{r,m} = m (N_{r-1,m-1} / (t_{i+r} - t_{i+r-m}) - N_{r,m-1} / (t_{i+r+1} - t_{i+r+1-m})) */
static void differentiate_row(int m, const double *inverse, double *b)
{
    double below = m * b[m - 1] * inverse[m - 1];
    b[m] = below;
    for (int r = m - 1; r > 0; r--) {
        const double above = below;
        below = m * b[r - 1] * inverse[r - 1];
        b[r] = below - above;
    }
    b[0] = -below;
}

static void bspline_eval_beside(const taut_basis *basis, int span, double t, double rest, int order,
                                double *values)
{
    const int p = basis->spec.degree;
    const double *knots = basis->knots + basis->knot_span[span];
    double left[TAUT_DEGREE_MAX + 1], right[TAUT_DEGREE_MAX + 1], spare[TAUT_DEGREE_MAX];
    reciprocals inverse;

    values[0] = 1;
    for (int m = 1; m <= p; m++) {
        const int k = p - m + 1; /* derivatives of order k start from degree m - 1 */
        if (k <= order) {
            memcpy(values + k * (p + 1), values, (size_t)m * sizeof(double));
        }
        left[m] = (t - knots[1 - m]) + rest;
        right[m] = (knots[m] - t) - rest;
        raise_degree(m, left, right, k <= TAUT_ORDER_MAX ? inverse[k - 1] : spare, values);
    }
    for (int k = 1; k <= order; k++) {
        double *row = values + k * (p + 1);
        if (k > p) {
            memset(row, 0, (size_t)(p + 1) * sizeof(double));
            continue;
        }
        for (int m = p - k + 1; m <= p; m++) {
            differentiate_row(m, inverse[p - m], row);
        }
    }
}

static void bspline_eval(const taut_basis *basis, int span, double t, int order, double *values)
{
    bspline_eval_beside(basis, span, t, 0, order, values);
}

/* The means of the inner knots, t_(i+1) .. t_(i+p). */
static void bspline_linear(const taut_basis *basis, double *t)
{
    const int p = basis->shape.degree;
    for (int i = 0; i < basis->shape.count; i++) {
        t[i] = 0;
        for (int k = 1; k <= p; k++) {
            t[i] += basis->knots[i + k] / p;
        }
    }
}

const taut_basis_ops taut_basis_bspline = {
    .type = "bspline",
    .needs = TAUT_MEMBER_DEGREE,
    .allows = TAUT_MEMBER_KNOTS | TAUT_MEMBER_COUNT,
    .weights = 1,
    .plan = bspline_plan,
    .fill = bspline_fill,
    .eval = bspline_eval,
    .eval_beside = bspline_eval_beside,
    .linear = bspline_linear,
    .changes = &taut_bspline_changes,
};
