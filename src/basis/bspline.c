/* bspline.c -- clamped B-splines on any legal knots.
 *
 * Degree p, n functions, full knots t_0 <= ... <= t_{n+p}, clamped: t_0 = .. = t_p < t_{p+1} and
 * t_{n-1} < t_n = .. = t_{n+p}; inner multiplicity at most p, so that the functions are continuous
 * ([WuWang2011] section 2.1; multiplicity p+1 may tear the surface). The form without the outermost
 * two knots is told by its length. Values and derivatives by the triangular table of
 * [PieglTiller1997] A2.2 and A2.3, which divides by knot differences of non-empty supports only.
 */
#include "basis/basis_ops.h"
#include "core/fail.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>

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

/* Checks the knots one by one; counts non-empty spans. */
static taut_status check_knots(const taut_basis_spec *spec, int dropped, int count, int *spans,
                               taut_error *error)
{
    const int p = spec->degree;
    const int total = count + p + 1;
    char where[48];
    int run = 0; /* how often the current value has come so far */

    *spans = 0;
    for (int i = 0; i < total; i++) {
        const double knot = full_knot(spec, dropped, i);
        const double before = i > 0 ? full_knot(spec, dropped, i - 1) : knot;
        const int given = i - dropped < 0 ? 0 : i - dropped;
        snprintf(where, sizeof where, "/knots/%d", given);
        if (!isfinite(knot)) {
            return taut_fail(error, TAUT_BAD_INPUT, where, knot, taut_none,
                             "a knot is not a finite number");
        }
        if (knot < before) {
            return taut_fail(error, TAUT_BAD_INPUT, where, knot, before,
                             "knot %.17g comes after %.17g, expected knots that do not decrease",
                             knot, before);
        }
        run = i > 0 && knot == before ? run + 1 : 1;
        *spans += i > 0 && knot > before;
        if (i > p && i < count && run > p) {
            return taut_fail(error, TAUT_BAD_INPUT, where, run, p,
                             "inner knot %.17g is repeated %d times, expected at most the degree, "
                             "%d: more would tear the surface",
                             knot, run, p);
        }
    }
    return TAUT_OK;
}

static taut_status check_clamped(const taut_basis_spec *spec, int dropped, int count,
                                 taut_error *error)
{
    const int p = spec->degree;
    const double lo = full_knot(spec, dropped, 0);
    const double hi = full_knot(spec, dropped, count + p);
    if (!(hi > lo) || !isfinite(hi - lo)) {
        return taut_fail(error, TAUT_BAD_INPUT, "/knots", hi - lo, 0,
                         "the knots run from %.17g to %.17g, expected a range that is not empty",
                         lo, hi);
    }
    if (full_knot(spec, dropped, p) != lo || full_knot(spec, dropped, count) != hi) {
        return taut_fail(error, TAUT_BAD_INPUT, "/knots", taut_none, p + 1,
                         "the knots are not clamped: expected the first and the last to come %d "
                         "times (or once less, without the outermost two)",
                         p + 1);
    }
    if (full_knot(spec, dropped, p + 1) == lo || full_knot(spec, dropped, count - 1) == hi) {
        return taut_fail(error, TAUT_BAD_INPUT, "/knots", taut_none, p + 1,
                         "an end knot comes more than %d times", p + 1);
    }
    return TAUT_OK;
}

static taut_status bspline_plan(const taut_basis_spec *spec, int functions, taut_basis_shape *shape,
                                taut_error *error)
{
    const int p = spec->degree;
    int count = spec->count;
    int spans = 0;
    taut_status status = TAUT_OK;

    if ((spec->knots == NULL) == (spec->count == 0)) {
        return taut_fail(error, TAUT_BAD_INPUT, "", taut_none, taut_none,
                         "a bspline needs either \"knots\" or \"count\"");
    }
    if (spec->knots != NULL) {
        const int dropped = knots_dropped(spec, functions);
        if (spec->knot_count < 0 || spec->knot_count > TAUT_COUNT_MAX + 2 * TAUT_DEGREE_MAX) {
            return taut_fail(error, TAUT_BAD_INPUT, "/knots", spec->knot_count, TAUT_COUNT_MAX,
                             "%d knots are too many", spec->knot_count);
        }
        count = spec->knot_count + 2 * dropped - p - 1;
        if (functions > 0 && count != functions) {
            return taut_fail(error, TAUT_BAD_INPUT, "/knots", spec->knot_count, functions + p + 1,
                             "%d knots, expected %d (or %d without the outermost two) for %d "
                             "points of degree %d",
                             spec->knot_count, functions + p + 1, functions + p - 1, functions, p);
        }
    }
    if (count < p + 1) {
        return taut_fail(error, TAUT_BAD_INPUT, spec->knots != NULL ? "/knots" : "/count", count,
                         p + 1, "%d functions of degree %d, expected at least %d", count, p, p + 1);
    }
    if (spec->knots != NULL) {
        const int dropped = knots_dropped(spec, functions);
        status = check_clamped(spec, dropped, count, error);
        if (status == TAUT_OK) {
            status = check_knots(spec, dropped, count, &spans, error);
        }
    } else {
        spans = count - p;
    }
    *shape =
        (taut_basis_shape){count, p + 1, spans, count <= TAUT_COUNT_MAX ? count + p + 1 : 0, p};
    return status;
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

/* The triangle of [PieglTiller1997] A2.2: ndu[j][r], j <= p; column j holds the values of degree j
 * (upper part), the lower part the knot differences. */
typedef double triangle[TAUT_DEGREE_MAX + 1][TAUT_DEGREE_MAX + 1];

static void fill_triangle(const double *knots, int i, int p, double t, triangle ndu)
{
    double left[TAUT_DEGREE_MAX + 1];
    double right[TAUT_DEGREE_MAX + 1];

    ndu[0][0] = 1;
    for (int j = 1; j <= p; j++) {
        double saved = 0;
        left[j] = t - knots[i + 1 - j];
        right[j] = knots[i + j] - t;
        for (int r = 0; r < j; r++) {
            ndu[j][r] = right[r + 1] + left[j - r]; /* a knot difference, never 0 */
            const double part = ndu[r][j - 1] / ndu[j][r];
            ndu[r][j] = saved + right[r + 1] * part;
            saved = left[j - r] * part;
        }
        ndu[j][j] = saved;
    }
}

/* Derivative k of function r out of the triangle: row a of coefficients, from the row before
 * ([PieglTiller1997] A2.3). */
static double derivative_row(int p, int r, int k, triangle ndu, const double *before, double *now)
{
    const int rk = r - k;
    const int pk = p - k;
    const int low = rk >= -1 ? 1 : -rk;
    const int high = r - 1 <= pk ? k - 1 : p - r;
    double sum = 0;

    if (rk >= 0) {
        now[0] = before[0] / ndu[pk + 1][rk];
        sum = now[0] * ndu[rk][pk];
    }
    for (int j = low; j <= high; j++) {
        now[j] = (before[j] - before[j - 1]) / ndu[pk + 1][rk + j];
        sum += now[j] * ndu[rk + j][pk];
    }
    if (r <= pk) {
        now[k] = -before[k - 1] / ndu[pk + 1][r];
        sum += now[k] * ndu[r][pk];
    }
    return sum;
}

static void bspline_eval(const taut_basis *basis, int span, double t, int order, double *values)
{
    const int p = basis->spec.degree;
    triangle ndu;
    double rows[2][TAUT_DEGREE_MAX + 1];

    fill_triangle(basis->knots, basis->knot_span[span], p, t, ndu);
    for (int r = 0; r <= p; r++) {
        double factor = 1;
        int now = 0;
        values[r] = ndu[r][p];
        rows[0][0] = 1;
        for (int k = 1; k <= order; k++) {
            double derivative = 0;
            if (k <= p) {
                factor *= p - k + 1;
                derivative = factor * derivative_row(p, r, k, ndu, rows[now], rows[1 - now]);
                now = 1 - now;
            }
            values[k * (p + 1) + r] = derivative;
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
};
