/* neighbour.c -- the biharmonic surface of least bending that meets another C^1 or C^2.
 *
 *  1. Rows 0..r of the neighbour, from the given surface: its polynomial carried on has them
 *     ([NiWang2015] section 2.6 (3)).
 *  2. Among the biharmonic polynomials of the bidegree over the neighbour's rectangle these rows
 *     are linear conditions of known rank (section 8.4): one solution, and a basis of what is free.
 *  3. The free part that makes the bending energy least: a linear least-squares problem over Gauss
 *     points, exact for the polynomials.
 */
#include "construct/harmonic/neighbour.h"
#include "construct/biharmonic/biharmonic.h"
#include "construct/common/build.h"
#include "construct/harmonic/growth.h"
#include "construct/harmonic/space.h"
#include "construct/harmonic/wide_solve.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "numeric/quadrature.h"
#include "numeric/wide.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A given surface counts as biharmonic up to this scaled residual. */
static const double biharmonic_limit = 1e-10;
/* Past this growth the net of least bending is no longer found within its rounding: on squares from
 * degree 26 with C^2 contact on; past this degree, 33^2 points, finding it takes seconds to minutes
 * to learn as much. */
static const double amplification_limit = 2e9;
enum { DEGREE_MAX = 32 };
/* The rows that meet must be met within some roundings of the coordinates; no rectangle is known
 * where they are not. */
static const double meeting_limit = 4 * DBL_EPSILON;

typedef struct neighbour {
    taut_neighbour given;
    taut_pulse *pulse;
    int contact, n, free; /* numbers that are free, a coordinate */
    int lines;            /* rows that are given */
    int sides;            /* right-hand sides: three coordinates, then unit rows: 1 at a point */
    double across, along; /* of the neighbour */
    taut_twice slender;   /* along / across */
    taut_twice root_of_2;
    taut_space space;
    taut_twice *fixed;  /* [sides][n+1][n+1]: a net for each, with the rows */
    taut_twice *moving; /* [free][n+1][n+1]: nets that leave the rows alone */
} neighbour;

static size_t numbers_of(const neighbour *b)
{
    return (size_t)(b->n + 1) * (size_t)(b->n + 1);
}

/* Nonzero when it is to end; so many operations in twice the precision. */
static int beat(const neighbour *b, double operations)
{
    return taut_pulse_beat(b->pulse, TAUT_TWICE_WORK * operations);
}

/* to = sum_f factors[f] net_f */
static void combine_nets(const neighbour *b, const taut_twice *factors, taut_twice *to)
{
    const size_t numbers = numbers_of(b);
    memset(to, 0, numbers * sizeof *to);
    for (int f = 0; f < b->space.count && !beat(b, (double)numbers); f++) {
        taut_wide_gain((int)numbers, factors[f], b->space.nets + (size_t)f * numbers, to);
    }
}

/* Row k of the neighbour is sum_a share(k, a) of row n - a of the given net:
 *     share = sum_l C(k,l) C(l,a) (-1)^a h^l,  as Delta^l q_0 = h^l nabla^l p_n  (section 2.6 (3)).
 */
static taut_twice share_of(double h, int k, int a)
{
    taut_twice sum = {0, 0}, power = {1, 0}; /* power: h^l */
    double outer = a % 2 != 0 ? -1 : 1;      /* (-1)^a C(k,l), k <= 2 */
    for (int l = 0; l <= k; l++) {
        double inner = l >= a ? 1 : 0; /* C(l,a) */
        for (int i = 0; i < a && l >= a; i++) {
            inner = inner * (l - i) / (i + 1);
        }
        sum = taut_twice_gain(sum, taut_twice_of(outer * inner), power);
        power = taut_twice_scale(h, power);
        outer = outer * (k - l) / (l + 1);
    }
    return sum;
}

/* What the rows are to be: d[rows][sides]. */
static void fill_sides(const neighbour *b, const double *beyond, taut_twice *d)
{
    const int columns = b->n + 1;
    for (int k = 0; k < b->lines * columns; k++) {
        for (int side = 0; side < 3; side++) {
            d[k * b->sides + side] = taut_twice_of(beyond[3 * k + side]);
        }
        for (int a = 0; a < b->lines; a++) {
            d[k * b->sides + 3 + a * columns + k % columns] =
                share_of(b->given.ratio, k / columns, a);
        }
    }
}

/* Step 2. `beyond` double[n+1][n+1][3] has the rows that are wanted. */
static taut_status meet_rows(neighbour *b, const double *beyond, taut_error *error)
{
    taut_arena *arena = b->given.arena;
    const int unknowns = b->space.count, rank = unknowns - b->free, rows = b->lines * (b->n + 1);
    const size_t n = (size_t)unknowns, numbers = numbers_of(b);
    taut_twice *c = taut_arena_take(arena, (size_t)rows * n, sizeof *c);
    taut_twice *d = taut_arena_take(arena, (size_t)rows * (size_t)b->sides, sizeof *d);
    taut_twice *basis = taut_arena_take(arena, n * n, sizeof *basis);
    taut_twice *x = taut_arena_take(arena, (size_t)b->sides * n, sizeof *x);

    b->fixed = taut_arena_take(arena, (size_t)b->sides * numbers, sizeof(taut_twice));
    b->moving = taut_arena_take(arena, (size_t)b->free * numbers, sizeof(taut_twice));
    if (c == NULL || d == NULL || basis == NULL || x == NULL || b->fixed == NULL ||
        b->moving == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < rows; k++) {
        for (int f = 0; f < unknowns; f++) {
            c[k * unknowns + f] = b->space.nets[(size_t)f * numbers + (size_t)k];
        }
    }
    fill_sides(b, beyond, d);
    taut_wide_constrain(rows, unknowns, rank, b->sides, c, d, basis, x, b->pulse);
    for (int side = 0; side < b->sides; side++) {
        combine_nets(b, x + side * unknowns, b->fixed + (size_t)side * numbers);
    }
    for (int k = 0; k < b->free; k++) {
        combine_nets(b, basis + (rank + k) * unknowns, b->moving + (size_t)k * numbers);
    }
    return TAUT_OK;
}

/* B, B', B'' of degree n at t, [3][n+1]. */
static void basis_at(int n, taut_twice t, taut_twice *b)
{
    const taut_twice zero = {0, 0}, rest = taut_twice_less(taut_twice_of(1), t);
    taut_twice low[TAUT_SPACE_DEGREE_MAX + 3] = {{0, 0}};
    const int size = n + 1;

    memset(b, 0, 3 * (size_t)size * sizeof *b);
    for (int order = 0; order < 3 && order <= n; order++) { /* degree n - order, then differences */
        const int d = n - order;
        taut_twice *to = b + order * size;
        double factor = 1;
        memset(low, 0, sizeof low);
        low[0] = taut_twice_of(1);
        for (int k = 1; k <= d; k++) {
            for (int i = k; i > 0; i--) {
                low[i] =
                    taut_twice_gain(taut_twice_times(t, low[i - 1]), rest, i < k ? low[i] : zero);
            }
            low[0] = taut_twice_times(rest, low[0]);
        }
        for (int k = 0; k < order; k++) {
            factor *= n - k;
        }
        for (int i = 0; i <= n; i++) { /* (-1)^order Delta^order of the shifted functions */
            const taut_twice a = i - order >= 0 && i - order <= d ? low[i - order] : zero;
            const taut_twice m = i - 1 >= 0 && i - 1 <= d ? low[i - 1] : zero;
            const taut_twice z = i <= d ? low[i] : zero;
            const taut_twice bend = taut_twice_gain(taut_twice_add(a, z), taut_twice_of(-2), m);
            to[i] = taut_twice_scale(factor, order == 0   ? z
                                             : order == 1 ? taut_twice_less(a, z)
                                                          : bend);
        }
    }
}

/* polygons[3][n+1]: the net along the line where the functions across have the values bu, of its
 * second derivative across, its first and itself. */
static void fill_polygons(const neighbour *b, const taut_twice *net, const taut_twice *bu,
                          taut_twice *polygons)
{
    const int size = b->n + 1;
    memset(polygons, 0, 3 * (size_t)size * sizeof *polygons);
    for (int order = 0; order < 3; order++) {
        for (int i = 0; i < size; i++) {
            taut_wide_gain(size, bu[order * size + i], net + i * size,
                           polygons + (2 - order) * size);
        }
    }
}

/* weight times (P_uu, sqrt 2 P_uv, P_vv) by parameter length and times the area, at a point of that
 * line; out[row] is `stride` apart. */
static void evaluate_bend(const neighbour *b, const taut_twice *polygons, const taut_twice *bv,
                          taut_twice weight, ptrdiff_t stride, taut_twice *out)
{
    const int size = b->n + 1;
    taut_twice sum[3] = {{0, 0}, {0, 0}, {0, 0}};
    for (int k = 0; k < 3; k++) {
        for (int j = 0; j < size; j++) {
            sum[k] = taut_twice_gain(sum[k], bv[k * size + j], polygons[k * size + j]);
        }
    }
    out[0] = taut_twice_times(weight, taut_twice_times(b->slender, sum[0]));
    out[stride] = taut_twice_times(weight, taut_twice_times(b->root_of_2, sum[1]));
    out[2 * stride] = taut_twice_times(weight, taut_twice_over(sum[2], b->slender));
}

/* Step 3: y[side][free]. */
static taut_status minimise_bending(const neighbour *b, taut_twice *y, taut_error *error)
{
    taut_arena *arena = b->given.arena;
    const int nodes = b->n + 1, width = b->free + b->sides, size = b->n + 1;
    const size_t numbers = numbers_of(b);
    double t[TAUT_GAUSS_MAX], w[TAUT_GAUSS_MAX];
    taut_twice polygons[3 * (TAUT_SPACE_DEGREE_MAX + 1)];
    taut_twice *r = taut_arena_take(arena, (size_t)b->free * (size_t)width, sizeof *r);
    taut_twice *block = taut_arena_take(arena, 3 * (size_t)nodes * (size_t)width, sizeof *block);
    taut_twice *table = taut_arena_take(arena, 3 * (size_t)nodes * (size_t)size, sizeof *table);
    taut_twice *scratch = taut_arena_take(arena, (size_t)width, sizeof *scratch);

    if (r == NULL || block == NULL || table == NULL || scratch == NULL) {
        return taut_fail_memory(error);
    }
    taut_gauss_rule(nodes, t, w);
    for (int s = 0; s < nodes; s++) {
        basis_at(b->n, taut_twice_sum(t[s] / 2, 0.5), table + 3 * s * size);
    }
    for (int s = 0; s < nodes; s++) {
        for (int k = 0; k < width && !beat(b, 6.0 * nodes * size); k++) {
            fill_polygons(b,
                          k < b->free ? b->moving + (size_t)k * numbers
                                      : b->fixed + (size_t)(k - b->free) * numbers,
                          table + 3 * s * size, polygons);
            for (int q = 0; q < nodes; q++) {
                evaluate_bend(b, polygons, table + 3 * q * size,
                              taut_twice_root(taut_twice_product(w[s], w[q])), width,
                              block + 3 * q * width + k);
            }
        }
        taut_wide_append(b->free, width, r, 3 * nodes, block, scratch, b->pulse);
    }
    taut_wide_back(b->free, width, r, b->pulse);
    for (int side = 0; side < b->sides; side++) {
        for (int k = 0; k < b->free; k++) {
            y[side * b->free + k] = taut_twice_negative(r[k * width + b->free + side]);
        }
    }
    return TAUT_OK;
}

/* Point k of the neighbour that a right-hand side leads to. */
static taut_twice point_of(const neighbour *b, const taut_twice *y, int side, size_t k)
{
    const size_t numbers = numbers_of(b);
    taut_twice sum = b->fixed[(size_t)side * numbers + k];
    for (int f = 0; f < b->free; f++) {
        sum = taut_twice_gain(sum, y[side * b->free + f], b->moving[(size_t)f * numbers + k]);
    }
    return sum;
}

/* The largest growth from the given surface's rows to the neighbour's net, in the
 * largest-coordinate norm: all of it is linear, the unit rows are its columns. */
static double amplification_of(const neighbour *b, const taut_twice *y)
{
    double most = 0;
    for (size_t k = 0; k < numbers_of(b) && !beat(b, (double)b->sides * b->free); k++) {
        double sum = 0;
        for (int side = 3; side < b->sides; side++) {
            sum += fabs(taut_twice_round(point_of(b, y, side, k)));
        }
        most = taut_larger_growth(most, sum);
    }
    return most;
}

static double size_of(const double *net, size_t points)
{
    double size = 0;
    for (size_t i = 0; i < 3 * points; i++) {
        size = fmax(size, fabs(net[i]));
    }
    return size;
}

/* How far the rows that were to be met were missed, over the size of the given net. */
static double miss_of(const neighbour *b, const double *net, const taut_twice *y)
{
    const double size = size_of(b->given.net, numbers_of(b));
    double miss = 0;
    const size_t end = (size_t)(b->lines * (b->n + 1));
    for (size_t k = (size_t)(b->n + 1); k < end && !beat(b, 3.0 * b->free); k++) {
        for (int side = 0; side < 3; side++) {
            const taut_twice wanted = taut_twice_of(net[3 * k + (size_t)side]);
            const taut_twice apart = taut_twice_less(point_of(b, y, side, k), wanted);
            miss = fmax(miss, fabs(taut_twice_round(apart)));
        }
    }
    return size > 0 ? miss / size : 0;
}

/* Refused where rounding leaves nothing of what the certificate claims. */
static taut_status check_digits(const neighbour *b, double amplification, double miss,
                                taut_error *error)
{
    /* rows of a neighbour h times as wide are up to h^k as large */
    const double limit = meeting_limit * fmax(1, taut_unit_map_reach(&b->given.map)) *
                         taut_pow(fmax(1, b->given.ratio), b->contact);

    if (!(amplification <= amplification_limit)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "ill-conditioned", "/surface", amplification,
                         amplification_limit,
                         "rounding in the surface of degree %d would grow %.3g times in its "
                         "neighbour, past %.0e: least bending would not be found (a narrower "
                         "neighbour or a lower degree is better; \"allow_ill_conditioned\": true "
                         "builds it all the same)",
                         b->n, amplification, amplification_limit);
    }
    if (!(miss <= limit)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "ill-conditioned", "/width", miss, limit,
                         "the rows that meet would be missed by %.3g of the size, past %.1e: on a "
                         "rectangle of %.3g by %.3g too few digits are left at degree %d (a width "
                         "nearer to the length of the edge or a lower degree is better; "
                         "\"allow_ill_conditioned\": true builds it all the same)",
                         miss, limit, b->across, b->along, b->n);
    }
    return TAUT_OK;
}

/* Steps 1 to 3: the net, in unit size. */
static taut_status solve_net(neighbour *b, double *net, double *amplification, int allow,
                             taut_error *error)
{
    taut_arena *arena = b->given.arena;
    taut_twice *y = taut_arena_take(arena, (size_t)b->sides * (size_t)b->free, sizeof *y);
    taut_status status = TAUT_OK;

    taut_neighbour_extrapolate(&b->given, 0, net);
    memcpy(net, b->given.net + 3 * b->n * (b->n + 1), 3 * (size_t)(b->n + 1) * sizeof(double));
    if (y == NULL ||
        !taut_space_biharmonic(b->n, b->across, b->along, arena, b->pulse, &b->space)) {
        return taut_fail_memory(error);
    }
    status = meet_rows(b, net, error);
    if (status == TAUT_OK && b->free > 0) {
        status = minimise_bending(b, y, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    *amplification = amplification_of(b, y);
    status = allow ? TAUT_OK : check_digits(b, *amplification, miss_of(b, net, y), error);
    if (status != TAUT_OK) {
        return status;
    }
    for (size_t k = (size_t)(b->n + 1); k < numbers_of(b) && !beat(b, 3.0 * b->free); k++) {
        for (int side = 0; side < 3; side++) {
            net[3 * k + (size_t)side] = taut_twice_round(point_of(b, y, side, k));
        }
    }
    return TAUT_OK;
}

static taut_status check_given(const taut_neighbour *given, int allow, taut_error *error)
{
    const size_t numbers = (size_t)(given->n + 1) * (size_t)(given->m + 1);
    const double limit =
        fmax(biharmonic_limit, 16 * DBL_EPSILON * taut_unit_map_reach(&given->map));
    double *scratch = taut_arena_take(given->arena, 6 * numbers, sizeof(double));
    double residual = 0;

    if (scratch == NULL) {
        return taut_fail_memory(error);
    }
    if (given->n != given->m || given->n > TAUT_SPACE_DEGREE_MAX) {
        return taut_fail(error, TAUT_NO_SOLUTION, "degree", "/surface", given->n, given->m,
                         "a biharmonic neighbour needs one degree both ways, at most %d, found %d "
                         "and %d",
                         TAUT_SPACE_DEGREE_MAX, given->n, given->m);
    }
    if (given->n > DEGREE_MAX && !allow) {
        return taut_fail(error, TAUT_NO_SOLUTION, "degree", "/surface", given->n, DEGREE_MAX,
                         "a neighbour of degree %d, expected at most %d: rounding leaves little of "
                         "least bending beyond, and finding it takes up to minutes (a lower degree "
                         "is better; \"allow_ill_conditioned\": true builds it all the same, up to "
                         "degree %d)",
                         given->n, DEGREE_MAX, TAUT_SPACE_DEGREE_MAX);
    }
    residual = taut_neighbour_residual(given, 2, scratch);
    if (!(residual <= limit)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "not-biharmonic", "/surface", residual, limit,
                         "not biharmonic: the surface's scaled residual is %.3g, expected at most "
                         "%.0e over its own rectangle",
                         residual, limit);
    }
    return TAUT_OK;
}

static taut_status add_surfaces(const neighbour *b, double *net, taut_model *model,
                                taut_error *error)
{
    taut_surface *given = NULL, *extension = NULL;
    taut_status status = taut_surface_copy(b->given.surface, &given);

    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = taut_construct_add_surface(model, given, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_neighbour_surface(&b->given, "extension", net, 0, &extension, error);
    return status == TAUT_OK ? taut_construct_add_surface(model, extension, error) : status;
}

/* The given surface turned and checked, and all numbers of things. */
static taut_status turn_surface(const taut_biharmonic_neighbour *asked, neighbour *b,
                                taut_error *error)
{
    taut_status status = taut_neighbour_check(asked->surface, asked->width, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_neighbour_turn(&b->given, asked->width, error);
    if (status != TAUT_OK) {
        return status;
    }
    b->n = b->given.n;
    b->free = b->contact == 1 ? 2 * (b->n - 1) : 2 * ((b->n - 1) / 2);
    b->lines = b->contact < b->n ? b->contact + 1 : b->n + 1;
    b->sides = 3 + b->lines * (b->n + 1);
    b->across = b->given.ratio * b->given.across;
    b->along = b->given.along;
    b->slender = taut_twice_over_number(taut_twice_of(b->along), b->across);
    b->root_of_2 = taut_twice_root(taut_twice_of(2));
    return check_given(&b->given, asked->allow_ill_conditioned, error);
}

taut_status taut_biharmonic_add_neighbour(const taut_biharmonic_neighbour *asked, taut_arena *arena,
                                          taut_pulse *pulse, taut_model *model,
                                          taut_record *details, double *amplification,
                                          taut_error *error)
{
    neighbour b = {
        .given = {.surface = asked->surface, .edge = asked->edge, .arena = arena},
        .contact = asked->contact,
        .pulse = pulse,
    };
    double *net = NULL;
    taut_status status = turn_surface(asked, &b, error);

    if (status != TAUT_OK) {
        return status;
    }
    net = taut_arena_take(arena, 3 * numbers_of(&b), sizeof(double));
    if (net == NULL) {
        return taut_fail_memory(error);
    }
    status = solve_net(&b, net, amplification, asked->allow_ill_conditioned, error);
    if (taut_pulse_is_stopped(pulse)) {
        return taut_fail_status(error, TAUT_INTERRUPTED);
    }
    if (status != TAUT_OK) {
        return status;
    }
    taut_record_add_text(details, "contact", b.contact == 1 ? "c1" : "c2");
    taut_record_add_number(details, "free", b.free);
    return add_surfaces(&b, net, model, error);
}
