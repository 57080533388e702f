/* quasi_change.c -- cutting and refining quasi-Bezier and quasi-B-spline bases exactly.
 *
 * The coefficients of a function phi on a window [x0, x1] are ([XuWang2006] section 3)
 *     phi(x0),  phi(x0) + k phi'(x0),  phi(x1) - k phi'(x1),  phi(x1),     k = k(x1 - x0),
 * which gives the rows of a cut straight from the functions at the cut. It is the same map as the
 * quasi de Casteljau algorithm (ibid. section 6), whose ratios become 0/0 near alpha = pi.
 *
 * As a B-spline such a basis is met by a quintic C^2 one with two derivatives at the ends of
 * pieces. All inner knots are triple. The coefficient with knots x, x, x, x+y, x+z is the blossom
 * of the osculating parabola at x:
 *     f(x) + f'(x) (y + z)/5 + f''(x) y z/20
 */
#include "basis/quasi.h"

#include "core/fail.h"
#include "core/memory.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <string.h>

typedef double taut_rows[4][4];

/* A quasi-Bezier spec on [lo, hi]; `length` is hi - lo, unrounded where known better. */
static taut_basis_spec piece_spec(const taut_quasi_kind *kind, double length, double lo, double hi)
{
    taut_basis_spec spec = {.type = kind->bezier, .has_range = 1, .range = {lo, hi}};
    kind->set_length(&spec, length);
    return spec;
}

/* Rows of the two parts of one segment, cut at t. */
static void cut_segment(const taut_quasi_kind *kind, const taut_quasi_segment *segment, double lo,
                        double hi, double t, taut_rows low, taut_rows high)
{
    taut_quasi_segment left, right;
    double u[TAUT_QUASI_ROWS][4];

    kind->kernel->prepare(t - lo, &left);
    kind->kernel->prepare(hi - t, &right);
    taut_quasi_four(kind->kernel, segment, lo, hi, t, 1, u);
    memset(low, 0, sizeof(taut_rows));
    memset(high, 0, sizeof(taut_rows));
    low[0][0] = 1;
    low[1][1] = fmin(left.k / segment->k, 1);
    low[1][0] = 1 - low[1][1];
    high[2][2] = fmin(right.k / segment->k, 1);
    high[2][3] = 1 - high[2][2];
    high[3][3] = 1;
    for (int i = 0; i < 4; i++) {
        low[3][i] = high[0][i] = u[0][i];
        low[2][i] = i < 3 ? u[0][i] - left.k * u[1][i] : 0;
        high[1][i] = i > 0 ? u[0][i] + right.k * u[1][i] : 0;
    }
}

/* Both parts must be long enough for parameters to be distinguished within them. */
static taut_status check_cut(double lo, double hi, double t, taut_error *error)
{
    const double shorter = fmin(t - lo, hi - t);
    const double limit = fmax(TAUT_QUASI_APART * fmax(fabs(lo), fabs(hi)), TAUT_SPAN_MIN);
    if (!(shorter >= limit)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "short-span", NULL, shorter, limit,
                         "a cut at %.17g leaves a piece of length %g, too short for its parameters "
                         "to be distinguished: cut further from %.17g",
                         t, shorter, t - lo < hi - t ? lo : hi);
    }
    return TAUT_OK;
}

static taut_status fill_cut(const taut_basis *basis, double t, taut_change_list *list,
                            taut_error *error)
{
    const taut_quasi_kind *kind = basis->ops->quasi;
    const taut_quasi_segment segment = taut_quasi_segment_of(basis);
    const double ends[3] = {taut_basis_lo(basis), t, taut_basis_hi(basis)};
    taut_rows rows[2];
    taut_status status = check_cut(ends[0], ends[2], t, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_change_list_new(2, list, error);
    cut_segment(kind, &segment, ends[0], ends[2], t, rows[0], rows[1]);
    for (int i = 0; status == TAUT_OK && i < 2; i++) {
        const taut_basis_spec spec = piece_spec(kind, ends[i + 1] - ends[i], ends[i], ends[i + 1]);
        status = taut_change_new(&spec, 0, 4, &list->items[i], error);
        if (status == TAUT_OK) {
            memcpy(list->items[i]->rows, rows[i], sizeof rows[i]);
        }
    }
    return status;
}

static taut_status quasi_bezier_split(const taut_basis *basis, double t, taut_change_list *list,
                                      taut_error *error)
{
    return taut_change_list_done(fill_cut(basis, t, list, error), list);
}

/* The Bezier points of a segment ([XuWang2006] section 4):
 *     b_0 = rho Q_0 + (1-2 rho) Q_1 + rho Q_2,   b_1 = (1-2 rho) Q_1 + 2 rho Q_2,
 *     b_2 = 2 rho Q_1 + (1-2 rho) Q_2,           b_3 = rho Q_1 + (1-2 rho) Q_2 + rho Q_3 */
static void opening_rows(double rho, taut_rows rows)
{
    const double r = rho, s = 1 - 2 * rho;
    const taut_rows opened = {{r, s, r, 0}, {0, s, 2 * r, 0}, {0, 2 * r, s, 0}, {0, r, s, r}};
    memcpy(rows, opened, sizeof(taut_rows));
}

/* The piece [a, b] of a segment whose Bezier points come by `opened` out of Q_first.., with `cut`
 * out of those Bezier points, or the whole segment where cut is NULL. */
static taut_status opened_piece(const taut_quasi_kind *kind, double length, double a, double b,
                                int first, taut_rows opened, taut_rows cut, taut_change **change,
                                taut_error *error)
{
    const taut_basis_spec spec = piece_spec(kind, length, a, b);
    const taut_status status = taut_change_new(&spec, 0, 4, change, error);

    for (int i = 0; status == TAUT_OK && i < 4; i++) {
        double *row = taut_change_row(*change, i);
        (*change)->first[i] = first;
        if (cut == NULL) {
            memcpy(row, opened[i], sizeof opened[i]);
            continue;
        }
        for (int m = 0; m < 4; m++) {
            for (int j = 0; j < 4; j++) {
                row[j] += cut[i][m] * opened[m][j];
            }
        }
    }
    return status;
}

/* All segments as quasi-Bezier pieces; with cut >= 0, segment `cut` as two, cut at t. */
static taut_status fill_segments(const taut_basis *basis, int cut, double t, taut_change_list *list,
                                 taut_error *error)
{
    const taut_quasi_kind *kind = basis->ops->quasi;
    const taut_quasi_segment segment = taut_quasi_segment_of(basis);
    const int segments = basis->shape.span_count;
    taut_rows opened, parts[2];
    taut_status status = taut_change_list_new(segments + (cut >= 0), list, error);

    opening_rows(segment.rho, opened);
    for (int i = 0, n = 0; status == TAUT_OK && i < segments; i++) {
        const double lo = basis->breaks[i], hi = basis->breaks[i + 1];
        if (i != cut) {
            status = opened_piece(kind, segment.length, lo, hi, i, opened, NULL, &list->items[n++],
                                  error);
            continue;
        }
        status = check_cut(lo, hi, t, error);
        if (status != TAUT_OK) {
            return status;
        }
        cut_segment(kind, &segment, lo, hi, t, parts[0], parts[1]);
        status = opened_piece(kind, t - lo, lo, t, i, opened, parts[0], &list->items[n++], error);
        if (status != TAUT_OK) {
            return status;
        }
        status = opened_piece(kind, hi - t, t, hi, i, opened, parts[1], &list->items[n++], error);
    }
    return status;
}

static taut_status quasi_bspline_pieces(const taut_basis *basis, taut_change_list *list,
                                        taut_error *error)
{
    return taut_change_list_done(fill_segments(basis, -1, 0, list, error), list);
}

/* Two splines of the same type, when the cut is at knot number `knot`. */
static taut_status fill_at_knot(const taut_basis *basis, int knot, taut_change_list *list,
                                taut_error *error)
{
    const int ends[3] = {0, knot, basis->shape.span_count};
    taut_status status = taut_change_list_new(2, list, error);

    for (int i = 0; status == TAUT_OK && i < 2; i++) {
        taut_basis_spec spec = basis->spec;
        spec.segments = ends[i + 1] - ends[i];
        spec.has_range = 1;
        spec.range[0] = basis->breaks[ends[i]];
        spec.range[1] = basis->breaks[ends[i + 1]];
        status = taut_change_select(&spec, 0, ends[i], 0, &list->items[i], error);
    }
    return status;
}

/* A knot i a is rounded; who asks for it may have rounded otherwise, by so much of the range. */
static int is_knot(const taut_basis *basis, double t, double knot)
{
    const double far = fmax(fabs(taut_basis_lo(basis)), fabs(taut_basis_hi(basis)));
    return fabs(t - knot) <= 2 * DBL_EPSILON * far;
}

static taut_status quasi_bspline_split(const taut_basis *basis, double t, taut_change_list *list,
                                       taut_error *error)
{
    const int span = taut_basis_span(basis, t);

    for (int i = span; i <= span + 1; i++) {
        if (i > 0 && i < basis->shape.span_count && is_knot(basis, t, basis->breaks[i])) {
            return taut_change_list_done(fill_at_knot(basis, i, list, error), list);
        }
    }
    return taut_change_list_done(fill_segments(basis, span, t, list, error), list);
}

/* Half the length, twice the segments, the same range. */
static taut_basis_spec halved_spec(const taut_basis *basis)
{
    const taut_quasi_kind *kind = basis->ops->quasi;
    taut_basis_spec spec = basis->spec;
    spec.type = kind->bspline;
    spec.segments = 2 * basis->shape.span_count;
    kind->set_length(&spec, kind->length(&basis->spec) / 2);
    return spec;
}

/* Q' = (Q_i + Q_{i+1}) / 2 and (Q_i + (2 + 4 x) Q_{i+1} + Q_{i+2}) / (4 + 4 x) in turn, with
 * x = cos(a/2) or cosh(a/2) ([XuWang2006] section 6). */
static taut_status quasi_bspline_halve(const taut_basis *basis, taut_change **change,
                                       taut_error *error)
{
    const taut_basis_spec spec = halved_spec(basis);
    const taut_quasi_kind *kind = basis->ops->quasi;
    const double side = 1 / (4 + 4 * kind->kernel->middle(kind->length(&basis->spec)));
    const taut_status status = taut_change_new(&spec, 0, 3, change, error);

    for (int i = 0; status == TAUT_OK && i < taut_basis_count((*change)->to); i++) {
        double *row = taut_change_row(*change, i);
        const int first = i / 2;
        const int last = basis->shape.count - 3; /* where three still fit */
        const int shift = first > last ? first - last : 0;
        (*change)->first[i] = first - shift;
        if (i % 2 == 0) {
            row[shift] = row[shift + 1] = 0.5;
        } else {
            row[0] = row[2] = side;
            row[1] = 1 - 2 * side;
        }
    }
    return status;
}

/* The two-segment spline that is one quasi-Bezier segment. With the spline's half length b, its
 * coefficients at a knot x are the central one C = phi - (f(b)/s(b)) phi'' and its neighbours
 * C + phi''/(2 delta) -+ b phi', where delta = rho(b) s(b)/f(b) is the second derivative of an
 * outer function at a knot: three conditions, phi = C + rho (second difference), phi' = (difference
 * of the neighbours)/(2 b), phi'' = delta (second difference). */
static taut_status quasi_bezier_halve(const taut_basis *basis, taut_change **change,
                                      taut_error *error)
{
    const taut_quasi_kind *kind = basis->ops->quasi;
    const taut_basis_spec spec = halved_spec(basis);
    const taut_quasi_segment segment = taut_quasi_segment_of(basis);
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    const double b = kind->length(&spec);
    const double knots[3] = {lo, lo + (hi - lo) / 2, hi};
    taut_quasi_segment half;
    double top[TAUT_QUASI_ROWS][2];
    taut_status status = TAUT_OK;

    status = taut_change_new(&spec, 0, 4, change, error);
    if (status != TAUT_OK) {
        return status;
    }
    kind->kernel->prepare(b, &half);
    kind->kernel->half(&half, b, 2, top);
    const double bend = 1 / top[2][1]; /* f(b)/s(b), because U_3'' = s/f(b) */
    for (int n = 0; n < 3; n++) {
        double u[TAUT_QUASI_ROWS][4];
        taut_quasi_four(kind->kernel, &segment, lo, hi, knots[n], 2, u);
        for (int i = 0; i < 4; i++) {
            const double centre = u[0][i] - bend * u[2][i];
            const double curve = bend / (2 * half.rho) * u[2][i];
            taut_change_row(*change, n + 1)[i] = centre;
            if (n == 0) {
                taut_change_row(*change, 0)[i] = centre + curve - b * u[1][i];
            } else if (n == 2) {
                taut_change_row(*change, 4)[i] = centre + curve + b * u[1][i];
            }
        }
    }
    return TAUT_OK;
}

/* knots[0 .. 3 N + 8]: six at each end, three at each of the N - 1 inner piece ends. */
static void fill_hermite_knots(int pieces, const double *ends, double *knots)
{
    int n = 0;
    for (int k = 0; k <= pieces; k++) {
        const int times = k == 0 || k == pieces ? 6 : 3;
        for (int i = 0; i < times; i++) {
            knots[n++] = ends[k];
        }
    }
}

/* The three coefficients at piece end k. */
static void fill_hermite_rows(const taut_basis *basis, int pieces, const double *ends, int k,
                              taut_change *change)
{
    const double x = ends[k];
    const int span = taut_basis_span(basis, x);
    const double before = k > 0 ? ends[k - 1] - x : 0;
    const double after = k < pieces ? ends[k + 1] - x : 0;
    const double y[3] = {before, before, after};
    const double z[3] = {before, after, after};
    double u[3 * 4];

    basis->ops->eval(basis, span, x, 2, u);
    for (int m = 0; m < 3; m++) {
        double *row = taut_change_row(change, 3 * k + m);
        change->first[3 * k + m] = basis->first[span];
        for (int i = 0; i < 4; i++) {
            row[i] = u[i] + u[4 + i] * (y[m] + z[m]) / 5 + u[8 + i] * y[m] * z[m] / 20;
        }
    }
}

static taut_status quasi_to_bspline(const taut_basis *basis, int pieces, const double *ends,
                                    taut_change **change, taut_error *error)
{
    taut_basis_spec spec = {.type = "bspline", .degree = 5};
    taut_status status = TAUT_OK;
    double *knots = NULL;

    assert(pieces >= 1 && pieces <= (TAUT_COUNT_MAX - 3) / 3); /* see geometry/nurbs/spans.c */
    spec.knot_count = 3 * pieces + 9;
    knots = taut_alloc((size_t)spec.knot_count, sizeof(double));
    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    fill_hermite_knots(pieces, ends, knots);
    spec.knots = knots;
    status = taut_change_new(&spec, 0, 4, change, error);
    for (int k = 0; status == TAUT_OK && k <= pieces; k++) {
        fill_hermite_rows(basis, pieces, ends, k, *change);
    }
    taut_free(knots);
    return status;
}

static void quasi_growth(const taut_basis *basis, double reach, double *at, double *slope)
{
    basis->ops->quasi->kernel->growth(reach, at, slope);
}

const taut_change_ops taut_quasi_bezier_changes = {
    .split = quasi_bezier_split,
    .pieces = taut_change_whole,
    .halve = quasi_bezier_halve,
    .insert = NULL,
    .elevate = NULL,
    .reverse = taut_change_reverse,
    .rerange = taut_change_rerange, /* by translation: plan refuses another length */
    .to_bspline = quasi_to_bspline,
    .growth = quasi_growth,
};

const taut_change_ops taut_quasi_bspline_changes = {
    .split = quasi_bspline_split,
    .pieces = quasi_bspline_pieces,
    .halve = quasi_bspline_halve,
    .insert = NULL,
    .elevate = NULL,
    .reverse = taut_change_reverse,
    .rerange = taut_change_rerange, /* by translation: plan refuses another length */
    .to_bspline = quasi_to_bspline,
    .growth = quasi_growth,
};
