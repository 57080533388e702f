/* ring.c -- edges of films that go around, and the theorem of the cone.
 *
 * A connected minimal surface is bounded by no two curves of which one lies in each nappe of the open
 * cone  rho < |z| sinh(t0),  t0 tanh(t0) = 1, whatever its apex and its axis. With heights along the axis
 * there is an apex between them when
 *
 *     max (z + rho / sinh t0) over the lower curve  <  min (z - rho / sinh t0) over the upper
 *
 * A nappe is convex: the control points of what is held will do for the proof, and the curves
 * themselves tell the distance that would. The axis is looked for by steps from the one through the middles.
 */
#include "construct/film/ring.h"

#include "construct/film/held.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "taut/operations.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SAMPLES = 720, HALVINGS = 24, NODES = 16, REFINEMENTS = 6 };
static const double sinh_t0 = 1.5088795615383199;
static const double near_enough = 0.2; /* of the widths: room that a better axis may make */
static const double gap_closed = 1e-9; /* of the size: ends of a closed curve */

static int other_of(int e)
{
    return e ^ 1;
}

/* ---- edges ---- */

static taut_status refuse_open(int e, taut_error *error)
{
    char where[32];
    snprintf(where, sizeof where, "/edges/%s", taut_film_edge_names[e]);
    return taut_fail(
        error, TAUT_BAD_INPUT, "corner-missing", where, taut_none, taut_none,
        "edge %s goes around and has no corners: give it a circle or a closed curve, a "
        "cable in a plane, a slide or a pole",
        taut_film_edge_names[e]);
}

static taut_status check_closed(const taut_film_space *space, int e, taut_error *error)
{
    const taut_curve *curve = space->problem->edges[e].curve;
    const taut_basis *t = taut_curve_t(curve);
    double ends[2][3];

    (void)taut_curve_eval(curve, taut_basis_lo(t), 0, ends[0]);
    (void)taut_curve_eval(curve, taut_basis_hi(t), 0, ends[1]);
    const double gap = taut_distance(ends[0], ends[1]), most = gap_closed * space->size;
    if (gap <= most) {
        return TAUT_OK;
    }
    char where[32];
    snprintf(where, sizeof where, "/edges/%s/fixed", taut_film_edge_names[e]);
    return taut_fail(error, TAUT_BAD_INPUT, "curve-ends", where, gap, most,
                     "the curve of edge %s ends %.3g from where it begins, expected at most %.3g: "
                     "the film goes around, give a closed curve",
                     taut_film_edge_names[e], gap, most);
}

static taut_status lay_held(taut_film_space *space, int e, taut_arena *arena, taut_error *error)
{
    const taut_status status = check_closed(space, e, error);
    return status == TAUT_OK ? taut_film_lay_curve(space, e, arena, error) : status;
}

static void find_middle(const taut_film_space *space, int e, double middle[3])
{
    size_t first = 0, step = 0;
    int count = 0;

    taut_film_edge_points(space->nu, space->nv, e, &first, &step, &count);
    memset(middle, 0, 3 * sizeof(double));
    for (int k = 0; k < space->around->period; k++) {
        taut_add_scaled(1.0 / space->around->period, space->points + 3 * (first + (size_t)k * step),
                        middle);
    }
}

/* Edge e starts as the other, moved into its plane later, or as its middle. */
static taut_status lay_moving(taut_film_space *space, int e, taut_error *error)
{
    const taut_film_edge *edge = &space->problem->edges[e];
    size_t first = 0, step = 0, from = 0;
    int count = 0;
    double middle[3];

    if (edge->kind == TAUT_FILM_CABLE && !edge->has_plane) {
        char where[32];
        snprintf(where, sizeof where, "/edges/%s", taut_film_edge_names[e]);
        return taut_fail(error, TAUT_NO_SOLUTION, "collapses", where, taut_none, taut_none,
                         "the closed cable %s is drawn onto the other edge: give it a plane",
                         taut_film_edge_names[e]);
    }
    find_middle(space, other_of(e), middle);
    taut_film_edge_points(space->nu, space->nv, other_of(e), &from, &step, &count);
    taut_film_edge_points(space->nu, space->nv, e, &first, &step, &count);
    for (int k = 0; k < count; k++) {
        double *x = space->points + 3 * (first + (size_t)k * step);
        memcpy(x,
               edge->kind == TAUT_FILM_POLE ? middle
                                            : space->points + 3 * (from + (size_t)k * step),
               3 * sizeof(double));
    }
    return TAUT_OK;
}

static double size_of_curve(const taut_curve *curve, const double from[3])
{
    double size = 0;
    for (int k = 0; k < taut_basis_count(taut_curve_t(curve)); k++) {
        size = fmax(size, taut_distance(taut_curve_points(curve) + 3 * k, from));
    }
    return size;
}

taut_status taut_film_ring_lay(taut_film_space *space, taut_arena *arena, taut_error *error)
{
    const taut_film_problem *problem = space->problem;
    const int edges[2] = {problem->ring == TAUT_FILM_RING_U ? 2 : 0,
                          problem->ring == TAUT_FILM_RING_U ? 3 : 1};
    const double *from = NULL;
    taut_status status = TAUT_OK;

    for (int k = 0; k < 2; k++) {
        const taut_film_edge *edge = &problem->edges[edges[k]];
        if (edge->kind == TAUT_FILM_FIXED && edge->curve == NULL) {
            return refuse_open(edges[k], error);
        }
        if (edge->kind == TAUT_FILM_FIXED) {
            from = from != NULL ? from : taut_curve_points(edge->curve);
            space->size = fmax(space->size, size_of_curve(edge->curve, from));
        }
    }
    if (from == NULL) {
        return taut_fail(error, TAUT_NO_SOLUTION, "floating", "/edges", 0, 1,
                         "no edge of the film is held: hold one on a circle or a closed curve");
    }
    if (!isfinite(space->size)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "overflow", "/edges", space->size, taut_none,
                         "the edges are farther apart than doubles reach: scale them down");
    }
    for (int k = 0; status == TAUT_OK && k < 4; k++) { /* what is held first */
        const int e = edges[k % 2], is_held = problem->edges[e].kind == TAUT_FILM_FIXED;
        if (is_held == (k < 2)) {
            status = is_held ? lay_held(space, e, arena, error) : lay_moving(space, e, error);
        }
    }
    return status;
}

/* ---- the cone ---- */

typedef struct rims {
    int count[2];
    double *points[2]; /* [count][3] */
    double span[2];    /* by find_gap: the largest rho / sinh t0 of each */
    double height;     /* the least distance between them along the axis */
} rims;

/* How much room for the apex there is on the axis: above 0, and there is no film. */
static double find_gap(rims *r, const double axis[6])
{
    double n[3] = {axis[3], axis[4], axis[5]}, low[2] = {INFINITY, INFINITY},
           high[2] = {-INFINITY, -INFINITY}, end[2] = {-INFINITY, INFINITY};
    const double size = taut_norm(n);

    for (int c = 0; c < 3; c++) {
        n[c] /= size;
    }
    r->span[0] = r->span[1] = 0;
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < r->count[k]; i++) {
            double from[3], across[3];
            taut_difference(r->points[k] + 3 * i, axis, from);
            taut_cross(n, from, across);
            const double z = taut_dot(n, from), wide = taut_norm(across) / sinh_t0;
            r->span[k] = fmax(r->span[k], wide);
            low[k] = fmin(low[k], z);
            high[k] = fmax(high[k], z);
            end[k] = k == 0 ? fmax(end[k], z + wide) : fmin(end[k], z - wide);
        }
    }
    r->height = low[1] - high[0];
    return end[1] - end[0];
}

/* The axis with the most room, by steps along its six numbers that are halved. */
static double widen_gap(rims *r, double axis[6], double size)
{
    double best = find_gap(r, axis), step = 0.1 * size;

    for (int halved = 0; halved < HALVINGS;) {
        int better = 0;
        for (int k = 0; k < 12; k++) {
            double tried[6];
            memcpy(tried, axis, sizeof tried);
            tried[k / 2] += k % 2 == 0 ? step : -step;
            const double gap = find_gap(r, tried);
            if (gap > best) {
                best = gap;
                memcpy(axis, tried, sizeof tried);
                better = 1;
            }
        }
        if (!better) {
            step *= 0.5;
            halved++;
        }
    }
    return best;
}

/* The edge as it is held, its spans halved often enough that its points lie near it. */
static taut_status take_curve(const taut_film_space *space, int e, taut_curve **curve)
{
    const taut_film_problem *problem = space->problem;
    size_t first = 0, step = 0;
    int count = 0;
    taut_arena *arena = taut_arena_new();

    taut_film_edge_points(space->nu, space->nv, e, &first, &step, &count);
    double *row = taut_arena_take(arena, (size_t)count, 3 * sizeof(double));
    taut_status status = row != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    if (status == TAUT_OK) {
        for (int i = 0; i < count; i++) {
            memcpy(row + 3 * i, space->points + 3 * (first + (size_t)i * step), 3 * sizeof(double));
        }
        taut_loop_clamp(space->around, 1, row);
        status = taut_curve_new(NULL, e < 2 ? problem->v : problem->u, row, NULL, curve, NULL);
    }
    for (int k = 0; k < REFINEMENTS && status == TAUT_OK; k++) {
        taut_curve *fine = NULL;
        status = taut_curve_refine(*curve, &fine, NULL);
        if (status == TAUT_OK) {
            taut_curve_free(*curve);
            *curve = fine;
        }
    }
    taut_arena_free(arena);
    return status;
}

static int take_points(const taut_film_space *space, const int edges[2], taut_arena *arena, rims *r)
{
    for (int k = 0; k < 2; k++) {
        taut_curve *curve = NULL;
        const taut_status status = take_curve(space, edges[k], &curve);
        if (status == TAUT_OK) {
            r->count[k] = taut_basis_count(taut_curve_t(curve));
            r->points[k] = taut_arena_copy(arena, taut_curve_points(curve), (size_t)r->count[k],
                                           3 * sizeof(double));
        }
        taut_curve_free(curve);
        if (status != TAUT_OK || r->points[k] == NULL) {
            return 0;
        }
    }
    return 1;
}

/* The problem's own curves, at many places. */
static int take_samples(const taut_film_space *space, const int edges[2], taut_arena *arena,
                        rims *r)
{
    for (int k = 0; k < 2; k++) {
        const taut_curve *curve = space->problem->edges[edges[k]].curve;
        const taut_basis *t = taut_curve_t(curve);
        const double lo = taut_basis_lo(t), hi = taut_basis_hi(t);
        r->points[k] = taut_arena_take(arena, SAMPLES, 3 * sizeof(double));
        r->count[k] = SAMPLES;
        if (r->points[k] == NULL) {
            return 0;
        }
        for (int i = 0; i < SAMPLES; i++) {
            (void)taut_curve_eval(curve, lo + (hi - lo) * i / SAMPLES, 0, r->points[k] + 3 * i);
        }
    }
    return 1;
}

taut_status taut_film_ring_cone(const taut_film_space *space, taut_error *error)
{
    const taut_film_problem *problem = space->problem;
    const int edges[2] = {problem->ring == TAUT_FILM_RING_U ? 2 : 0,
                          problem->ring == TAUT_FILM_RING_U ? 3 : 1};
    double axis[6];
    rims held = {.height = 0}, told = {.height = 0};

    if (taut_film_has_density(problem) || problem->edges[edges[0]].kind != TAUT_FILM_FIXED ||
        problem->edges[edges[1]].kind != TAUT_FILM_FIXED) {
        return TAUT_OK;
    }
    taut_arena *arena = taut_arena_new();
    const int taken =
        take_points(space, edges, arena, &held) && take_samples(space, edges, arena, &told);
    double middle[3], gap = -1;
    find_middle(space, edges[0], axis);
    find_middle(space, edges[1], middle);
    taut_difference(middle, axis, axis + 3);
    const double size = taut_norm(axis + 3);
    if (taken && size > 0) {
        gap = find_gap(&held, axis);
        if (gap <= 0 && gap > -near_enough * (held.span[0] + held.span[1])) {
            gap = widen_gap(&held, axis, size);
        }
        (void)find_gap(&told, axis);
    }
    taut_arena_free(arena);
    if (!taken) {
        return taut_fail_memory(error);
    }
    if (!(gap > 0)) {
        return TAUT_OK;
    }
    const double most = told.span[0] + told.span[1];
    return taut_fail(error, TAUT_NO_SOLUTION, "collapses", "/edges", told.height, most,
                     "no film spans both edges, which is proved: they are %.15g apart, and lie in "
                     "the two halves of a cone that no film connects; edges as wide as these are "
                     "joined up to %.15g at most: bring them together",
                     told.height, most);
}

/* ---- rivals ---- */

/* 1/2 int |(x - m) x x_t| dt, m the mean of the points. */
static double cone_area(const taut_curve *curve)
{
    const taut_basis *t = taut_curve_t(curve);
    const double *breaks = taut_basis_breaks(t), *points = taut_curve_points(curve);
    const int n = taut_basis_count(t);
    double node[NODES], weight[NODES], tip[3] = {0, 0, 0}, area = 0;

    taut_gauss_rule(NODES, node, weight);
    for (int k = 0; k < n; k++) {
        taut_add_scaled(1.0 / n, points + 3 * k, tip);
    }
    for (int k = 0; k < taut_basis_span_count(t) * NODES; k++) {
        const double lo = breaks[k / NODES], half = 0.5 * (breaks[k / NODES + 1] - lo);
        double x[2][3], from[3], turned[3];
        (void)taut_curve_eval(curve, lo + half * (1 + node[k % NODES]), 1, x[0]);
        taut_difference(x[0], tip, from);
        taut_cross(from, x[1], turned);
        area += 0.5 * half * weight[k % NODES] * taut_norm(turned);
    }
    return area;
}

taut_status taut_film_ring_discs(const taut_film_space *space, const double *points, double *area)
{
    const taut_film_problem *problem = space->problem;
    const int along_u = problem->ring == TAUT_FILM_RING_U;
    taut_arena *arena = taut_arena_new();
    taut_status status = TAUT_OK;

    *area = 0;
    for (int e = along_u ? 2 : 0; status == TAUT_OK && e < (along_u ? 4 : 2); e++) {
        size_t first = 0, step = 0;
        int count = 0;
        taut_curve *curve = NULL;
        taut_film_edge_points(space->nu, space->nv, e, &first, &step, &count);
        double *row = taut_arena_take(arena, (size_t)count, 3 * sizeof(double));
        for (int k = 0; row != NULL && k < count; k++) {
            memcpy(row + 3 * k, points + 3 * (first + (size_t)k * step), 3 * sizeof(double));
        }
        status = row != NULL ? taut_curve_new(NULL, along_u ? problem->u : problem->v, row, NULL,
                                              &curve, NULL)
                             : TAUT_NO_MEMORY;
        if (status == TAUT_OK) {
            *area += cone_area(curve);
        }
        taut_curve_free(curve);
    }
    taut_arena_free(arena);
    for (int e = along_u ? 2 : 0; e < (along_u ? 4 : 2); e++) {
        *area = problem->edges[e].kind == TAUT_FILM_FIXED ? *area : 0;
    }
    return status;
}
