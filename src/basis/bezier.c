/* bezier.c -- Bernstein polynomials on a range: N_i(t) = B[n,i]((t-lo)/(hi-lo)). Splitting and degree
 * elevation are those of the coefficients; the rest goes through the bspline basis of one span,
 * which has the same coefficients. */
#include "basis/change.h"
#include "numeric/bernstein.h"

static taut_status bezier_plan(const taut_basis_ops *ops, const taut_basis_spec *spec,
                               int functions, taut_basis_shape *shape, taut_error *error)
{
    (void)ops;
    (void)functions;
    (void)error;
    *shape = (taut_basis_shape){spec->degree + 1, spec->degree + 1, 1, 0, spec->degree};
    return TAUT_OK;
}

static void bezier_fill(taut_basis *basis)
{
    if (!basis->spec.has_range) {
        basis->spec.range[0] = 0;
        basis->spec.range[1] = 1;
    }
    basis->breaks[0] = basis->spec.range[0];
    basis->breaks[1] = basis->spec.range[1];
}

/* d^k/dt^k brings a factor (hi-lo)^-k; where the range is run through backwards, of either sign. */
static void scale_rows(const taut_basis *basis, int order, int is_backwards, double *values)
{
    const int local = basis->shape.local;
    const double width = basis->breaks[1] - basis->breaks[0];
    double scale = 1;

    for (int k = 1; k <= order; k++) {
        scale /= is_backwards ? -width : width;
        for (int i = 0; i < local; i++) {
            values[k * local + i] *= scale;
        }
    }
}

static void bezier_eval(const taut_basis *basis, int span, double t, int order, double *values)
{
    const double width = basis->breaks[1] - basis->breaks[0];

    (void)span;
    taut_bernstein_eval(basis->shape.local - 1, order, (t - basis->breaks[0]) / width, values);
    scale_rows(basis, order, 0, values);
}

/* From the nearer end, B[n,i](s) = B[n,n-i](1-s): the distance from there has all its digits, that
 * from the other end has none of the last ones. */
static void bezier_eval_beside(const taut_basis *basis, int span, double t, double rest, int order,
                               double *values)
{
    const int local = basis->shape.local;
    const double lo = basis->breaks[0], hi = basis->breaks[1];
    const double from_lo = (t - lo) + rest, from_hi = (hi - t) - rest;
    const int is_backwards = from_hi < from_lo;

    (void)span;
    taut_bernstein_eval(local - 1, order, (is_backwards ? from_hi : from_lo) / (hi - lo), values);
    scale_rows(basis, order, is_backwards, values);
    for (int k = 0; is_backwards && k <= order; k++) {
        double *row = values + k * local;
        for (int i = 0, j = local - 1; i < j; i++, j--) {
            const double held = row[i];
            row[i] = row[j];
            row[j] = held;
        }
    }
}

static void bezier_linear(const taut_basis *basis, double *t)
{
    const double lo = basis->breaks[0], hi = basis->breaks[1];
    const int degree = basis->shape.degree;
    for (int i = 0; i <= degree; i++) {
        t[i] = i == degree ? hi : lo + (hi - lo) * i / degree;
    }
}

/* The low piece has b_i = sum_j B[i,j](s) P_j, the high one b_i = sum_j B[n-i,j](s) P_{i+j}: de
 * Casteljau's triangle written out ([Farin2002] section 5.4). */
static taut_status fill_split(const taut_basis *basis, double t, taut_change_list *list,
                              taut_error *error)
{
    const int n = basis->spec.degree;
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    const double s = (t - lo) / (hi - lo), ends[3] = {lo, t, hi};
    taut_status status = taut_change_list_new(2, list, error);

    for (int k = 0; status == TAUT_OK && k < 2; k++) {
        const taut_basis_spec piece = {
            .type = "bezier", .degree = n, .has_range = 1, .range = {ends[k], ends[k + 1]}};
        status = taut_change_new(&piece, 0, n + 1, &list->items[k], error);
    }
    for (int i = 0; status == TAUT_OK && i <= n; i++) {
        taut_bernstein_eval(i, 0, s, taut_change_row(list->items[0], i));
        taut_bernstein_eval(n - i, 0, s, taut_change_row(list->items[1], i) + i);
    }
    return status;
}

static taut_status bezier_split(const taut_basis *basis, double t, taut_change_list *list,
                                taut_error *error)
{
    return taut_change_list_done(fill_split(basis, t, list, error), list);
}

static taut_status bezier_halve(const taut_basis *basis, taut_change **change, taut_error *error)
{
    taut_basis *bspline = NULL;
    taut_status status = taut_bspline_of_bezier(basis, &bspline, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_bspline_changes.halve(bspline, change, error);
    taut_basis_free(bspline);
    return status;
}

static taut_status bezier_insert(const taut_basis *basis, double t, int times, taut_change **change,
                                 taut_error *error)
{
    taut_basis *bspline = NULL;
    taut_status status = taut_bspline_of_bezier(basis, &bspline, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_bspline_changes.insert(bspline, t, times, change, error);
    taut_basis_free(bspline);
    return status;
}

/* b_i = i/(n+1) P_{i-1} + (1 - i/(n+1)) P_i ([Farin2002] section 6.1). */
static taut_status bezier_elevate(const taut_basis *basis, taut_change **change, taut_error *error)
{
    const int n = basis->spec.degree;
    taut_basis_spec spec = basis->spec;
    taut_status status = TAUT_OK;

    spec.degree = n + 1;
    status = taut_change_new(&spec, 0, 2, change, error);
    for (int i = 0; status == TAUT_OK && i <= n + 1; i++) {
        const double part = (double)i / (n + 1);
        double *row = taut_change_row(*change, i);
        const int first = i == 0 ? 0 : i > n ? n - 1 : i - 1;
        (*change)->first[i] = first;
        if (i > 0) {
            row[i - 1 - first] = part;
        }
        if (i <= n) {
            row[i - first] = 1 - part;
        }
    }
    return status;
}

static taut_status bezier_to_bspline(const taut_basis *basis, int pieces, const double *ends,
                                     taut_change **change, taut_error *error)
{
    taut_basis *bspline = NULL;
    taut_status status = taut_bspline_of_bezier(basis, &bspline, error);

    (void)pieces;
    (void)ends;
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_change_select(&bspline->spec, 0, 0, 0, change, error);
    taut_basis_free(bspline);
    return status;
}

static const taut_change_ops bezier_changes = {
    .split = bezier_split,
    .pieces = taut_change_whole,
    .halve = bezier_halve,
    .insert = bezier_insert,
    .elevate = bezier_elevate,
    .reverse = taut_change_reverse,
    .rerange = taut_change_rerange,
    .to_bspline = bezier_to_bspline,
    .growth = NULL,
};

const taut_basis_ops taut_basis_bezier = {
    .type = "bezier",
    .needs = TAUT_MEMBER_DEGREE,
    .allows = TAUT_MEMBER_RANGE,
    .weights = 1,
    .plan = bezier_plan,
    .fill = bezier_fill,
    .eval = bezier_eval,
    .eval_beside = bezier_eval_beside,
    .linear = bezier_linear,
    .changes = &bezier_changes,
};
