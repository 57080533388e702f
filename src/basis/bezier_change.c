/* bezier_change.c -- splitting and degree elevation of Bezier form; the rest through the bspline
 * basis of one span, which has the same coefficients. */
#include "basis/bspline_change.h"
#include "core/fail.h"
#include "numeric/bernstein.h"

/* The low piece has b_i = sum_j B[i,j](s) P_j, the high one b_i = sum_j B[n-i,j](s) P_{i+j}: de
 * Casteljau's triangle written out ([Farin2002] section 5.4). */
static taut_status bezier_split(const taut_basis *basis, double t, taut_change_list *list,
                                taut_error *error)
{
    const int n = basis->spec.degree;
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    const double s = (t - lo) / (hi - lo);
    const taut_basis_spec low = {.type = "bezier", .degree = n, .has_range = 1, .range = {lo, t}};
    const taut_basis_spec high = {.type = "bezier", .degree = n, .has_range = 1, .range = {t, hi}};
    taut_change_list made = {0, NULL};
    taut_status status = taut_change_list_new(2, &made, error);

    if (status == TAUT_OK) {
        status = taut_change_new(&low, 0, n + 1, &made.items[0], error);
    }
    if (status == TAUT_OK) {
        status = taut_change_new(&high, 0, n + 1, &made.items[1], error);
    }
    if (status != TAUT_OK) {
        taut_change_list_free(&made);
        return status;
    }
    for (int i = 0; i <= n; i++) {
        taut_bernstein_eval(i, 0, s, taut_change_row(made.items[0], i));
        taut_bernstein_eval(n - i, 0, s, taut_change_row(made.items[1], i) + i);
    }
    *list = made;
    return TAUT_OK;
}

static taut_status bezier_pieces(const taut_basis *basis, taut_change_list *list, taut_error *error)
{
    taut_change_list made = {0, NULL};
    taut_status status = taut_change_list_new(1, &made, error);

    if (status == TAUT_OK) {
        status = taut_change_select(&basis->spec, 0, 0, 0, &made.items[0], error);
    }
    if (status != TAUT_OK) {
        taut_change_list_free(&made);
        return status;
    }
    *list = made;
    return TAUT_OK;
}

static taut_status bezier_halve(const taut_basis *basis, taut_change **change, taut_error *error)
{
    taut_basis *bspline = NULL;
    taut_status status = taut_bspline_of_bezier(basis, &bspline, error);

    if (status == TAUT_OK) {
        status = bspline->ops->changes->halve(bspline, change, error);
    }
    taut_basis_free(bspline);
    return status;
}

static taut_status bezier_insert(const taut_basis *basis, double t, int times, taut_change **change,
                                 taut_error *error)
{
    taut_basis *bspline = NULL;
    taut_status status = taut_bspline_of_bezier(basis, &bspline, error);

    if (status == TAUT_OK) {
        status = bspline->ops->changes->insert(bspline, t, times, change, error);
    }
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

static taut_status bezier_reverse(const taut_basis *basis, taut_change **change, taut_error *error)
{
    return taut_change_select(&basis->spec, 0, 0, 1, change, error);
}

static taut_status bezier_rerange(const taut_basis *basis, double lo, double hi,
                                  taut_change **change, taut_error *error)
{
    taut_basis_spec spec = basis->spec;
    spec.has_range = 1;
    spec.range[0] = lo;
    spec.range[1] = hi;
    return taut_change_select(&spec, 0, 0, 0, change, error);
}

static taut_status bezier_to_bspline(const taut_basis *basis, int panels, const double *ends,
                                     taut_change **change, taut_error *error)
{
    taut_basis *bspline = NULL;
    taut_status status = taut_bspline_of_bezier(basis, &bspline, error);

    (void)panels;
    (void)ends;
    if (status == TAUT_OK) {
        status = taut_change_select(&bspline->spec, 0, 0, 0, change, error);
    }
    taut_basis_free(bspline);
    return status;
}

const taut_change_ops taut_changes_bezier = {
    .split = bezier_split,
    .pieces = bezier_pieces,
    .halve = bezier_halve,
    .insert = bezier_insert,
    .elevate = bezier_elevate,
    .reverse = bezier_reverse,
    .rerange = bezier_rerange,
    .to_bspline = bezier_to_bspline,
    .growth = NULL,
};
