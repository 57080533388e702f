/* ring.c -- edges of films that go around.
 *
 * By the theorem of the cone (cone.h) the control points of what is held tell that there is no film, and the curves themselves the
 * distance at which there would be one.
 */
#include "construct/film/ring.h"

#include "construct/film/cone.h"
#include "construct/film/held.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "taut/operations.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SAMPLES = 720, REFINEMENTS = 6 };
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

static int take_points(const taut_film_space *space, const int edges[2], taut_arena *arena,
                       taut_film_rims *r)
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
                        taut_film_rims *r)
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
    taut_film_rims held = {.height = 0}, told = {.height = 0};

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
    if (taken) {
        gap = taut_film_cone_widest(&held, axis);
    }
    if (gap > 0) {
        (void)taut_film_cone_gap(&told, axis);
    }
    taut_arena_free(arena);
    if (!taken) {
        return taut_fail_memory(error);
    }
    return gap > 0 ? taut_film_cone_refuse(&told, 15, "/edges", error) : TAUT_OK;
}

/* ---- rivals ---- */

static double cone_area(const taut_curve *curve)
{
    const double *points = taut_curve_points(curve);
    const int n = taut_basis_count(taut_curve_t(curve));
    double tip[3] = {0, 0, 0};

    for (int k = 0; k < n; k++) {
        taut_add_scaled(1.0 / n, points + 3 * k, tip);
    }
    return taut_film_cone_area(curve, tip);
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
