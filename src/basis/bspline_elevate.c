/* bspline_elevate.c -- raising the degree of a B-spline by one. */
#include "basis/blossom.h"
#include "basis/bspline_change.h"
#include "core/fail.h"
#include "core/memory.h"

#include <assert.h>
#include <string.h>

/* Adds weight times f(x without x[omit]) into sum, whose first entry stands for coefficient base.
 */
static void add_omitting(taut_blossom *blossom, const taut_basis *basis, const double *x, int omit,
                         double weight, double *scratch, int base, double *sum)
{
    const int p = basis->spec.degree;
    double *row = scratch + p;
    int first = 0;

    for (int i = 0, n = 0; i <= p; i++) {
        if (i != omit) {
            scratch[n++] = x[i];
        }
    }
    taut_blossom_row(blossom, basis->knots, basis->shape.count, scratch, &first, row);
    for (int a = 0; a <= p; a++) {
        if (row[a] != 0) {
            assert(first + a >= base && first + a - base < 3 * p + 2);
            sum[first + a - base] += weight * row[a];
        }
    }
}

/* The coefficient of the raised spline at knots x_0 .. x_p is the mean of the old blossom over the
 * p + 1 ways to leave one out ([Prautzsch1984]); equal ones are taken together. */
static void elevated_row(taut_blossom *blossom, const taut_basis *basis, const double *x,
                         double *scratch, int *first, double *row)
{
    const int p = basis->spec.degree;
    double *sum = scratch + 2 * p + 1; /* [3 p + 2] */
    int base = 0, start = 0, times = 0;

    taut_blossom_row(blossom, basis->knots, basis->shape.count, x, &base, row);
    base = base < p ? 0 : base - p; /* windows of the others begin at most p earlier */
    memset(sum, 0, (size_t)(3 * p + 2) * sizeof(double));
    for (int i = 0; i <= p; i += times) {
        times = 1;
        while (i + times <= p && x[i + times] == x[i]) {
            times++;
        }
        add_omitting(blossom, basis, x, i, (double)times / (p + 1), scratch, base, sum);
    }
    while (start < 2 * p + 1 && sum[start] == 0) {
        start++;
    }
    if (base + start > basis->shape.count - p - 1) {
        start = basis->shape.count - p - 1 - base;
    }
    memcpy(row, sum + start, (size_t)(p + 1) * sizeof(double));
    *first = base + start;
}

static taut_status elevate_rows(const taut_basis *basis, taut_change *change, taut_error *error)
{
    const size_t p = (size_t)basis->spec.degree;
    taut_blossom *blossom = taut_blossom_new(basis->spec.degree);
    double *scratch = taut_alloc(5 * p + 3, sizeof(double));
    taut_status status = TAUT_OK;

    if (blossom == NULL || scratch == NULL) {
        status = taut_fail_memory(error);
    }
    for (int i = 0; status == TAUT_OK && i < taut_basis_count(change->to); i++) {
        elevated_row(blossom, basis, change->to->knots + i + 1, scratch, &change->first[i],
                     taut_change_row(change, i));
    }
    taut_free(scratch);
    taut_blossom_free(blossom);
    return status;
}

taut_status taut_bspline_elevate(const taut_basis *basis, taut_change **change, taut_error *error)
{
    const int total = basis->shape.knot_count;
    double *knots = taut_alloc((size_t)total + (size_t)basis->shape.span_count + 1, sizeof(double));
    taut_basis_spec spec = {.type = "bspline", .degree = basis->spec.degree + 1, .knots = knots};
    taut_change *made = NULL;
    taut_status status = TAUT_OK;

    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < total; i++) {
        if (i == 0 || basis->knots[i] > basis->knots[i - 1]) {
            knots[spec.knot_count++] = basis->knots[i]; /* each once more */
        }
        knots[spec.knot_count++] = basis->knots[i];
    }
    status = taut_change_new(&spec, 0, basis->spec.degree + 1, &made, error);
    if (status == TAUT_OK) {
        status = elevate_rows(basis, made, error);
    }
    taut_free(knots);
    if (status != TAUT_OK) {
        taut_change_free(made);
        return status;
    }
    *change = made;
    return TAUT_OK;
}
