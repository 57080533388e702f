/* bspline_change.c -- knot insertion, and what follows from it: splitting, halving, Bezier pieces,
 * degree elevation. Every new coefficient is a blossom value of the old spline (blossom.h). */
#include "basis/bspline_change.h"

#include "basis/blossom.h"
#include "core/fail.h"
#include "core/memory.h"

#include <assert.h>
#include <math.h>
#include <string.h>

static int knot_count(const taut_basis *basis)
{
    return basis->shape.knot_count;
}

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

    if (status == TAUT_OK) {
        status = fill_rows(from, knots, made, error);
    }
    if (status != TAUT_OK) {
        taut_change_free(made);
        return status;
    }
    *change = made;
    return TAUT_OK;
}

/* Writes x `times` times and returns where to go on. */
static double *repeat(double *out, double x, int times)
{
    for (int i = 0; i < times; i++) {
        *out++ = x;
    }
    return out;
}

static taut_status bspline_split(const taut_basis *basis, double t, taut_change_list *list,
                                 taut_error *error)
{
    const int p = basis->spec.degree;
    const int total = knot_count(basis);
    double *knots = taut_alloc((size_t)total + (size_t)p + 1, sizeof(double));
    taut_change_list made = {0, NULL};
    taut_status status = TAUT_OK;
    int below = 0, upto = 0;

    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    while (basis->knots[below] < t) {
        below++;
    }
    upto = below;
    while (basis->knots[upto] == t) {
        upto++;
    }
    status = taut_change_list_new(2, &made, error);
    if (status == TAUT_OK) {
        memcpy(knots, basis->knots, (size_t)below * sizeof(double));
        repeat(knots + below, t, p + 1);
        status = to_knots(basis, knots, below + p + 1, &made.items[0], error);
    }
    if (status == TAUT_OK) {
        memcpy(repeat(knots, t, p + 1), basis->knots + upto,
               (size_t)(total - upto) * sizeof(double));
        status = to_knots(basis, knots, total - upto + p + 1, &made.items[1], error);
    }
    taut_free(knots);
    if (status != TAUT_OK) {
        taut_change_list_free(&made);
        return status;
    }
    *list = made;
    return TAUT_OK;
}

/* The Bezier piece on one span: its blossom at a x (p-i), b x i. */
static taut_status bezier_piece(const taut_basis *basis, int span, double *knots,
                                taut_change **change, taut_error *error)
{
    const int p = basis->spec.degree;
    const double a = basis->breaks[span], b = basis->breaks[span + 1];
    const taut_basis_spec spec = {.type = "bezier", .degree = p, .has_range = 1, .range = {a, b}};
    taut_status status = taut_change_new(&spec, 0, p + 1, change, error);

    if (status == TAUT_OK) {
        repeat(repeat(knots, a, p + 1), b, p + 1);
        status = fill_rows(basis, knots, *change, error);
    }
    return status;
}

static taut_status bspline_pieces(const taut_basis *basis, taut_change_list *list,
                                  taut_error *error)
{
    const size_t p = (size_t)basis->spec.degree;
    double *knots = taut_alloc(2 * p + 2, sizeof(double));
    taut_change_list made = {0, NULL};
    taut_status status = taut_change_list_new(basis->shape.span_count, &made, error);

    if (knots == NULL) {
        status = taut_fail_memory(error);
    }
    for (int i = 0; status == TAUT_OK && i < made.count; i++) {
        status = bezier_piece(basis, i, knots, &made.items[i], error);
    }
    taut_free(knots);
    if (status != TAUT_OK) {
        taut_change_list_free(&made);
        return status;
    }
    *list = made;
    return TAUT_OK;
}

static taut_status bspline_halve(const taut_basis *basis, taut_change **change, taut_error *error)
{
    const int total = knot_count(basis);
    const int spans = basis->shape.span_count;
    double *knots = taut_alloc((size_t)total + (size_t)spans, sizeof(double));
    taut_status status = TAUT_OK;
    int n = 0;

    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < total && status == TAUT_OK; i++) {
        knots[n++] = basis->knots[i];
        if (i + 1 < total && basis->knots[i + 1] > basis->knots[i]) {
            const double a = basis->knots[i], b = basis->knots[i + 1];
            const double middle = a + (b - a) / 2;
            if (!(middle > a && middle < b)) {
                status = taut_fail(error, TAUT_NO_SOLUTION, "/knots", b - a, taut_none,
                                   "the span from %.17g to %.17g is too short to be halved", a, b);
            }
            knots[n++] = middle;
        }
    }
    if (status == TAUT_OK) {
        status = to_knots(basis, knots, n, change, error);
    }
    taut_free(knots);
    return status;
}

static taut_status bspline_insert(const taut_basis *basis, double t, int times,
                                  taut_change **change, taut_error *error)
{
    const int p = basis->spec.degree;
    const int total = knot_count(basis);
    double *knots = NULL;
    int below = 0, upto = 0;
    taut_status status = TAUT_OK;

    while (basis->knots[below] < t) {
        below++;
    }
    upto = below;
    while (basis->knots[upto] == t) {
        upto++;
    }
    if (times < 0 || times > p - (upto - below)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, NULL, times, p - (upto - below),
                         "knot %.17g is there %d times; with %d more it would pass the degree, %d",
                         t, upto - below, times, p);
    }
    knots = taut_alloc((size_t)total + (size_t)times, sizeof(double));
    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    memcpy(knots, basis->knots, (size_t)upto * sizeof(double));
    repeat(knots + upto, t, times);
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

static taut_status bspline_elevate(const taut_basis *basis, taut_change **change, taut_error *error)
{
    const int total = knot_count(basis);
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

/* A change of the knots alone: knot i becomes map(i); coefficients stay, or turn round. */
static taut_status moved(const taut_basis *basis, double lo, double hi, int reversed,
                         taut_change **change, taut_error *error)
{
    const int total = knot_count(basis);
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
    return moved(basis, taut_basis_lo(basis), taut_basis_hi(basis), 1, change, error);
}

static taut_status bspline_rerange(const taut_basis *basis, double lo, double hi,
                                   taut_change **change, taut_error *error)
{
    return moved(basis, lo, hi, 0, change, error);
}

static taut_status bspline_to_bspline(const taut_basis *basis, int panels, taut_change **change,
                                      taut_error *error)
{
    (void)panels;
    return taut_change_select(&basis->spec, basis->shape.count, 0, 0, change, error);
}

taut_status taut_bspline_of_bezier(const taut_basis *bezier, taut_basis **bspline,
                                   taut_error *error)
{
    const int p = bezier->spec.degree;
    double knots[2 * (TAUT_DEGREE_MAX + 1)];
    const taut_basis_spec spec = {
        .type = "bspline", .degree = p, .knots = knots, .knot_count = 2 * p + 2};

    repeat(repeat(knots, taut_basis_lo(bezier), p + 1), taut_basis_hi(bezier), p + 1);
    return taut_basis_new(&spec, p + 1, bspline, error);
}

const taut_change_ops taut_changes_bspline = {
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
