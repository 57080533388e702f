#include "construct/common/curve_fit.h"

#include "core/arena.h"
#include "core/vec3.h"
#include "geometry/keep.h"
#include "numeric/dense.h"
#include "numeric/quadrature.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NODES = 32 }; /* a cell: degree 20 and rational curves to rounding */
enum { LOCAL = TAUT_DEGREE_MAX + 1 };

typedef struct fit {
    const taut_curve *curve;
    const taut_basis *basis, *test;
    const taut_loop *around;     /* or NULL */
    int count, unknowns, offset; /* offset: of the first test function that is used */
    int cells;
    double *breaks;         /* [cells + 1] in the basis's range */
    double *samples;        /* [cells * NODES][3]: of the curve */
    taut_arena *arena;      /* of the arrays */
    double *triangle, *row; /* (unknowns + 3) columns */
    double *rows;           /* [unknowns][unknowns + 3] */
} fit;

static int compare_numbers(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The parameter of the curve that belongs to t. */
static double curve_parameter(const fit *f, double t)
{
    const taut_basis *c = taut_curve_t(f->curve);
    const double lo = taut_basis_lo(f->basis), hi = taut_basis_hi(f->basis);
    const double at = (t - lo) / (hi - lo), a = taut_basis_lo(c), b = taut_basis_hi(c);
    return fmin(b, fmax(a, at < 0.5 ? a + at * (b - a) : b - (1 - at) * (b - a)));
}

static void evaluate_curve(const fit *f, double t, double x[3])
{
    const taut_status status = taut_curve_eval(f->curve, curve_parameter(f, t), 0, x);
    assert(status == TAUT_OK); /* which it is in the curve's range */
    (void)status;
}

/* The breaks of both, without those that rounding parts. */
static taut_status merge_breaks(fit *f)
{
    const taut_basis *c = taut_curve_t(f->curve);
    const int own = taut_basis_span_count(f->basis), other = taut_basis_span_count(c);
    const double lo = taut_basis_lo(f->basis), hi = taut_basis_hi(f->basis);
    const double a = taut_basis_lo(c), b = taut_basis_hi(c);
    int count = 1;

    f->breaks = taut_arena_take(f->arena, (size_t)own + (size_t)other + 2, sizeof(double));
    if (f->breaks == NULL) {
        return TAUT_NO_MEMORY;
    }
    memcpy(f->breaks, taut_basis_breaks(f->basis), ((size_t)own + 1) * sizeof(double));
    for (int k = 0; k <= other; k++) {
        f->breaks[own + 1 + k] = lo + (hi - lo) * ((taut_basis_breaks(c)[k] - a) / (b - a));
    }
    qsort(f->breaks, (size_t)own + (size_t)other + 2, sizeof(double), compare_numbers);
    for (int k = 1; k < own + other + 2; k++) {
        if (f->breaks[k] - f->breaks[count - 1] > 1e-12 * (hi - lo)) {
            f->breaks[count++] = f->breaks[k];
        }
    }
    f->cells = count - 1;
    f->samples = taut_arena_take(f->arena, (size_t)f->cells * NODES, 3 * sizeof(double));
    return f->samples != NULL ? TAUT_OK : TAUT_NO_MEMORY;
}

/* The test functions: the basis without its first and its last inner knot; the inner functions of
 * the basis itself where it has not two. */
static taut_status choose_tests(fit *f)
{
    taut_basis_spec spec;
    taut_basis *test = NULL;
    double *knots = NULL;
    int inner = 0;
    taut_status status = TAUT_OK;

    f->test = f->basis;
    f->offset = 1;
    if (f->around != NULL) {
        return TAUT_OK;
    }
    taut_basis_spec_of(f->basis, &spec);
    inner = spec.knot_count - 2 * (spec.degree + 1);
    if (strcmp(taut_basis_type(f->basis), "bspline") != 0 || inner < 2) {
        return TAUT_OK;
    }
    knots = taut_arena_take(f->arena, (size_t)spec.knot_count, sizeof(double));
    if (knots == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0, next = 0; k < spec.knot_count; k++) {
        if (k != spec.degree + 1 && k != spec.degree + inner) {
            knots[next++] = spec.knots[k];
        }
    }
    spec.knots = knots;
    spec.knot_count -= 2;
    status = taut_basis_new(&spec, 0, &test, NULL);
    if (status != TAUT_OK) {
        return status;
    }
    f->test = test;
    f->offset = 0;
    return taut_keep_basis(f->arena, test) ? TAUT_OK : TAUT_NO_MEMORY;
}

/* The functions alive at t, and the first of them. */
static int look_up(const fit *f, double t, double n[LOCAL])
{
    const int span = taut_basis_span(f->basis, t), first = taut_basis_first(f->basis, span);

    taut_basis_eval(f->basis, span, t, 0, n);
    if (f->around != NULL) {
        taut_loop_open(f->around, first, n);
    }
    return first;
}

/* Where function j of the basis stands among the points. */
static int place_of(const fit *f, int j)
{
    return f->around != NULL ? j % f->around->period : j;
}

/* The same of a space that goes around: the functions are their own tests, and all are unknown. */
static void add_node_around(fit *f, double t, double weight, const double x[3])
{
    double n[LOCAL];
    const int first = look_up(f, t, n), local = taut_basis_local(f->basis);

    for (int a = 0; a < local; a++) {
        double *row = f->rows + (size_t)place_of(f, first + a) * (size_t)(f->unknowns + 3);
        for (int b = 0; b < local; b++) {
            row[place_of(f, first + b)] += weight * n[a] * n[b];
        }
        for (int c = 0; c < 3; c++) {
            row[f->unknowns + c] += weight * n[a] * x[c];
        }
    }
}

/* Adds what node t gives to the moments; x, the curve's point there, is spoilt. */
static void add_node(fit *f, double t, double weight, const double ends[2][3], double x[3])
{
    double n[LOCAL], m[LOCAL];
    const int span = taut_basis_span(f->basis, t), first = taut_basis_first(f->basis, span);
    const int tested = taut_basis_span(f->test, t), other = taut_basis_first(f->test, tested);
    const int width = f->unknowns + 3, local = taut_basis_local(f->basis);

    taut_basis_eval(f->basis, span, t, 0, n);
    taut_basis_eval(f->test, tested, t, 0, m);
    for (int b = 0; b < local; b++) {
        const int j = first + b;
        if (j == 0 || j == f->count - 1) {
            taut_add_scaled(-n[b], ends[j > 0], x);
        }
    }
    for (int a = 0; a < taut_basis_local(f->test); a++) {
        const int k = other + a - f->offset;
        double *row = NULL;
        if (k < 0 || k >= f->unknowns) {
            continue;
        }
        row = f->rows + (size_t)k * (size_t)width;
        for (int b = 0; b < local; b++) {
            const int j = first + b - 1;
            if (j >= 0 && j < f->unknowns) {
                row[j] += weight * m[a] * n[b];
            }
        }
        for (int c = 0; c < 3; c++) {
            row[f->unknowns + c] += weight * m[a] * x[c];
        }
    }
}

static void visit_nodes(fit *f, const double ends[2][3], const double *points, double *deviation)
{
    double node[NODES], weight[NODES];

    taut_gauss_rule(NODES, node, weight);
    for (int k = 0; k < f->cells * NODES; k++) {
        const double lo = f->breaks[k / NODES], hi = f->breaks[k / NODES + 1];
        const double t = lo + (hi - lo) * (0.5 + 0.5 * node[k % NODES]);
        double n[LOCAL], x[3];
        if (points == NULL) {
            evaluate_curve(f, t, f->samples + 3 * (size_t)k);
        }
        memcpy(x, f->samples + 3 * (size_t)k, sizeof x);
        if (points == NULL && f->around != NULL) {
            add_node_around(f, t, weight[k % NODES] * (hi - lo), x);
        } else if (points == NULL) {
            add_node(f, t, weight[k % NODES] * (hi - lo), ends, x);
        }
        if (points == NULL) {
            continue;
        }
        const int first = look_up(f, t, n);
        for (int b = 0; b < taut_basis_local(f->basis); b++) {
            taut_add_scaled(-n[b], points + 3 * place_of(f, first + b), x);
        }
        const double miss = taut_norm(x);
        if (!(miss <= *deviation || isnan(*deviation))) { /* fmax passes over what is no number */
            *deviation = miss;
        }
    }
}

/* The unknown points from the moments, by QR: row by row, each only as long as it has to be. */
static taut_status solve_moments(fit *f, double *points)
{
    const int width = f->unknowns + 3;
    const size_t size = (size_t)width;

    for (int k = 0; k < f->unknowns; k++) {
        memcpy(f->row, f->rows + (size_t)k * size, size * sizeof(double));
        taut_qr_append(width, f->triangle, 1, f->row);
    }
    for (int c = 0; c < 3; c++) {
        for (int i = 0; i < f->unknowns; i++) {
            f->row[i] = f->triangle[(size_t)(f->unknowns + c) * size + (size_t)i];
        }
        if (!taut_triangle_solve(f->unknowns, width, f->triangle, f->row)) {
            return TAUT_NOT_CONVERGED;
        }
        for (int i = 0; i < f->unknowns; i++) {
            points[3 * (i + (f->around == NULL)) + c] = f->row[i];
        }
    }
    return TAUT_OK;
}

static taut_status fit_points(fit *f, const double ends[2][3], double *points, double *deviation)
{
    const size_t size = (size_t)f->unknowns + 3;
    taut_status status = choose_tests(f);

    if (status != TAUT_OK) {
        return status;
    }
    f->triangle = taut_arena_take(f->arena, size, size * sizeof(double));
    f->row = taut_arena_take(f->arena, size, sizeof(double));
    f->rows = taut_arena_take(f->arena, (size_t)f->unknowns + 1, size * sizeof(double));
    status = f->rows != NULL ? merge_breaks(f) : TAUT_NO_MEMORY;
    if (status != TAUT_OK) {
        return status;
    }
    visit_nodes(f, ends, NULL, NULL);
    status = f->unknowns > 0 ? solve_moments(f, points) : TAUT_OK;
    if (status != TAUT_OK) {
        return status;
    }
    *deviation = 0;
    visit_nodes(f, ends, points, deviation);
    return isfinite(*deviation) ? TAUT_OK : TAUT_NOT_CONVERGED;
}

taut_status taut_curve_fit(const taut_curve *curve, const taut_basis *basis,
                           const double ends[2][3], double *points, double *deviation)
{
    const int count = taut_basis_count(basis);
    fit f = {.curve = curve, .basis = basis, .count = count, .arena = taut_arena_new()};
    taut_status status = TAUT_OK;

    f.unknowns = count > 2 ? count - 2 : 0;
    memcpy(points, ends[0], 3 * sizeof(double));
    memcpy(points + 3 * (count - 1), ends[1], 3 * sizeof(double));
    status = fit_points(&f, ends, points, deviation);
    taut_arena_free(f.arena);
    return status;
}

taut_status taut_curve_fit_around(const taut_curve *curve, const taut_basis *basis,
                                  const taut_loop *around, double *points, double *deviation)
{
    fit f = {.curve = curve,
             .basis = basis,
             .around = around,
             .count = taut_basis_count(basis),
             .unknowns = around->period,
             .arena = taut_arena_new()};
    const taut_status status = fit_points(&f, NULL, points, deviation);

    taut_arena_free(f.arena);
    for (int j = 0; j < around->degree; j++) {
        memcpy(points + 3 * (around->period + j), points + 3 * j, 3 * sizeof(double));
    }
    return status;
}
