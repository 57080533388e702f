/* bspline_change.c -- knot insertion, and what follows from it: splitting, halving, Bezier pieces,
 * degree elevation. Every new coefficient is a blossom value of the old spline (blossom.h). */
#include "basis/blossom.h"
#include "basis/change.h"
#include "core/fail.h"
#include "core/memory.h"

#include <assert.h>
#include <string.h>

/* Rows of a change to `knots` (those of change->to in full, count + p + 1 of them). */
static taut_status fill_rows(const taut_basis *from, const double *knots, taut_change *change,
                             taut_error *error)
{
    taut_blossom *blossom = taut_blossom_new(from->spec.degree);
    if (blossom == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < taut_basis_count(change->to); i++) {
        taut_blossom_row(blossom, from->knots, from->shape.count, knots + i + 1, &change->first[i],
                         taut_change_row(change, i));
    }
    taut_blossom_free(blossom);
    return TAUT_OK;
}

/* The change from a spline to finer knots of the same degree. */
static taut_status to_knots(const taut_basis *from, const double *knots, int count,
                            taut_change **change, taut_error *error)
{
    const int p = from->spec.degree;
    const taut_basis_spec spec = {
        .type = "bspline", .degree = p, .knots = knots, .knot_count = count};
    taut_change *made = NULL;
    taut_status status = taut_change_new(&spec, 0, p + 1, &made, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = fill_rows(from, knots, made, error);
    if (status != TAUT_OK) {
        taut_change_free(made);
        return status;
    }
    *change = made;
    return TAUT_OK;
}

/* Writes x `times` times and returns where to go on. */
static double *repeat_knot(double *out, double x, int times)
{
    for (int i = 0; i < times; i++) {
        *out++ = x;
    }
    return out;
}

/* The knots equal to t are *below .. *upto - 1. */
static void find_knot(const taut_basis *basis, double t, int *below, int *upto)
{
    *below = 0;
    while (basis->knots[*below] < t) {
        (*below)++;
    }
    *upto = *below;
    while (basis->knots[*upto] == t) {
        (*upto)++;
    }
}

/* `knots` has room for all of them and p + 1 more. */
static taut_status fill_split(const taut_basis *basis, double t, double *knots,
                              taut_change_list *list, taut_error *error)
{
    const int p = basis->spec.degree, total = basis->shape.knot_count;
    int below = 0, upto = 0;
    taut_status status = taut_change_list_new(2, list, error);

    if (status != TAUT_OK) {
        return status;
    }
    find_knot(basis, t, &below, &upto);
    memcpy(knots, basis->knots, (size_t)below * sizeof(double));
    repeat_knot(knots + below, t, p + 1);
    status = to_knots(basis, knots, below + p + 1, &list->items[0], error);
    if (status != TAUT_OK) {
        return status;
    }
    memcpy(repeat_knot(knots, t, p + 1), basis->knots + upto,
           (size_t)(total - upto) * sizeof(double));
    return to_knots(basis, knots, total - upto + p + 1, &list->items[1], error);
}

static taut_status bspline_split(const taut_basis *basis, double t, taut_change_list *list,
                                 taut_error *error)
{
    const size_t room = (size_t)basis->shape.knot_count + (size_t)basis->spec.degree + 1;
    double *knots = taut_alloc(room, sizeof(double));
    const taut_status status =
        knots != NULL ? fill_split(basis, t, knots, list, error) : taut_fail_memory(error);
    taut_free(knots);
    return taut_change_list_done(status, list);
}

static taut_status bezier_piece(taut_blossom *blossom, const taut_basis *basis, int span,
                                taut_change **change, taut_error *error)
{
    const int p = basis->spec.degree;
    const taut_basis_spec spec = {.type = "bezier",
                                  .degree = p,
                                  .has_range = 1,
                                  .range = {basis->breaks[span], basis->breaks[span + 1]}};
    const taut_status status = taut_change_new(&spec, 0, p + 1, change, error);

    if (status != TAUT_OK) {
        return status;
    }
    taut_blossom_piece(blossom, basis->knots, basis->knot_span[span], (*change)->rows);
    for (int i = 0; i <= p; i++) {
        (*change)->first[i] = basis->first[span];
    }
    return TAUT_OK;
}

static taut_status bspline_pieces(const taut_basis *basis, taut_change_list *list,
                                  taut_error *error)
{
    taut_blossom *blossom = taut_blossom_new(basis->spec.degree);
    taut_status status = blossom != NULL
                             ? taut_change_list_new(basis->shape.span_count, list, error)
                             : taut_fail_memory(error);

    for (int i = 0; status == TAUT_OK && i < list->count; i++) {
        status = bezier_piece(blossom, basis, i, &list->items[i], error);
    }
    taut_blossom_free(blossom);
    return taut_change_list_done(status, list);
}

/* The knots of a basis with one more in the middle of each span: *count of them. */
static taut_status halve_spans(const taut_basis *basis, double *knots, int *count,
                               taut_error *error)
{
    const int total = basis->shape.knot_count;
    int n = 0;
    for (int i = 0; i < total; i++) {
        knots[n++] = basis->knots[i];
        if (i + 1 < total && basis->knots[i + 1] > basis->knots[i]) {
            const double a = basis->knots[i], b = basis->knots[i + 1];
            const double middle = a + (b - a) / 2;
            if (!(middle > a && middle < b)) {
                return taut_fail(error, TAUT_NO_SOLUTION, "short-span", "/knots", b - a, taut_none,
                                 "the span from %.17g to %.17g is too short to be halved", a, b);
            }
            knots[n++] = middle;
        }
    }
    *count = n;
    return TAUT_OK;
}

static taut_status bspline_halve(const taut_basis *basis, taut_change **change, taut_error *error)
{
    const size_t room = (size_t)basis->shape.knot_count + (size_t)basis->shape.span_count;
    double *knots = taut_alloc(room, sizeof(double));
    int count = 0;
    taut_status status =
        knots != NULL ? halve_spans(basis, knots, &count, error) : taut_fail_memory(error);
    if (status == TAUT_OK) {
        status = to_knots(basis, knots, count, change, error);
    }
    taut_free(knots);
    return status;
}

static taut_status bspline_insert(const taut_basis *basis, double t, int times,
                                  taut_change **change, taut_error *error)
{
    const int p = basis->spec.degree;
    const int total = basis->shape.knot_count;
    double *knots = NULL;
    int below = 0, upto = 0;
    taut_status status = TAUT_OK;

    find_knot(basis, t, &below, &upto);
    if (times < 0 || times > p - (upto - below)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, times, p - (upto - below),
                         "knot %.17g is there %d times; with %d more it would pass the degree, %d",
                         t, upto - below, times, p);
    }
    knots = taut_alloc((size_t)total + (size_t)times, sizeof(double));
    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    memcpy(knots, basis->knots, (size_t)upto * sizeof(double));
    repeat_knot(knots + upto, t, times);
    memcpy(knots + upto + times, basis->knots + upto, (size_t)(total - upto) * sizeof(double));
    status = to_knots(basis, knots, total + times, change, error);
    taut_free(knots);
    return status;
}

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

/* The change to `knots`, which are those of the basis, each once more. */
static taut_status elevate_to(const taut_basis *basis, const double *knots, int count,
                              taut_change **change, taut_error *error)
{
    const int p = basis->spec.degree;
    const taut_basis_spec spec = {
        .type = "bspline", .degree = p + 1, .knots = knots, .knot_count = count};
    taut_change *made = NULL;
    taut_status status = taut_change_new(&spec, 0, p + 1, &made, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = elevate_rows(basis, made, error);
    if (status != TAUT_OK) {
        taut_change_free(made);
        return status;
    }
    *change = made;
    return TAUT_OK;
}

static taut_status bspline_elevate(const taut_basis *basis, taut_change **change, taut_error *error)
{
    const int total = basis->shape.knot_count;
    double *knots = taut_alloc((size_t)total + (size_t)basis->shape.span_count + 1, sizeof(double));
    int count = 0;

    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < total; i++) {
        if (i == 0 || basis->knots[i] > basis->knots[i - 1]) {
            knots[count++] = basis->knots[i];
        }
        knots[count++] = basis->knots[i];
    }
    const taut_status status = elevate_to(basis, knots, count, change, error);
    taut_free(knots);
    return status;
}

/* A change of the knots alone: knot i becomes map(i); coefficients stay, or turn round. */
static taut_status move_knots(const taut_basis *basis, double lo, double hi, int reversed,
                              taut_change **change, taut_error *error)
{
    const int total = basis->shape.knot_count;
    const double from = taut_basis_lo(basis), to = taut_basis_hi(basis);
    double *knots = taut_alloc((size_t)total, sizeof(double));
    const taut_basis_spec spec = {
        .type = "bspline", .degree = basis->spec.degree, .knots = knots, .knot_count = total};
    taut_status status = TAUT_OK;

    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < total; i++) {
        const double old = basis->knots[reversed ? total - 1 - i : i];
        const double part = reversed ? to - old : old - from;
        const double scale = (hi - lo) / (to - from); /* exactly 1 for the same range */
        const double x = lo + part * scale;
        /* the ends exactly: the last one would be rounded */
        knots[i] = old == (reversed ? from : to) || x > hi ? hi : x;
    }
    status = taut_change_select(&spec, 0, 0, reversed, change, error);
    taut_free(knots);
    return status;
}

static taut_status bspline_reverse(const taut_basis *basis, taut_change **change, taut_error *error)
{
    return move_knots(basis, taut_basis_lo(basis), taut_basis_hi(basis), 1, change, error);
}

static taut_status bspline_rerange(const taut_basis *basis, double lo, double hi,
                                   taut_change **change, taut_error *error)
{
    return move_knots(basis, lo, hi, 0, change, error);
}

static taut_status bspline_to_bspline(const taut_basis *basis, int pieces, const double *ends,
                                      taut_change **change, taut_error *error)
{
    (void)pieces;
    (void)ends;
    return taut_change_select(&basis->spec, basis->shape.count, 0, 0, change, error);
}

taut_status taut_bspline_of_bezier(const taut_basis *bezier, taut_basis **bspline,
                                   taut_error *error)
{
    const int p = bezier->spec.degree;
    double knots[2 * (TAUT_DEGREE_MAX + 1)];
    const taut_basis_spec spec = {
        .type = "bspline", .degree = p, .knots = knots, .knot_count = 2 * p + 2};

    repeat_knot(repeat_knot(knots, taut_basis_lo(bezier), p + 1), taut_basis_hi(bezier), p + 1);
    return taut_basis_new(&spec, p + 1, bspline, error);
}

const taut_change_ops taut_bspline_changes = {
    .split = bspline_split,
    .pieces = bspline_pieces,
    .halve = bspline_halve,
    .insert = bspline_insert,
    .elevate = bspline_elevate,
    .reverse = bspline_reverse,
    .rerange = bspline_rerange,
    .to_bspline = bspline_to_bspline,
    .growth = NULL,
};
