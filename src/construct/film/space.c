/* space.c -- corners, edges and the start of a film.
 *
 *     corners   as given, or the ends of the curves that meet there
 *     held      curves fitted by their moments (construct/common/curve_fit.h), straight edges at the
 *               Greville abscissae, which is the line itself
 *     start     chords for cables, and inside the net of Coons,
 *               (1-a) P_0j + a P_nj + (1-b) P_i0 + b P_im - bilinear(corners),
 *               a, b the Greville abscissae: the surface of Coons of the four edges, exactly
 */
#include "construct/film/space.h"

#include "construct/film/arc.h"
#include "construct/film/begin.h"
#include "construct/film/freedom.h"
#include "construct/film/greville.h"
#include "construct/film/held.h"
#include "construct/film/ring.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* An end of a curve and a corner are one when they are this close, over the size of the boundary. */
static const double chord_shorter = 0.95; /* of a given length: a chord to begin with */
static const double gap_meeting = 1e-9;
/* Corners are two when they are further apart than this, over the size. */
static const double gap_apart = 1e-9;

/* ---- corners ---- */

static void evaluate_end(const taut_curve *curve, int end, double x[3])
{
    const taut_basis *t = taut_curve_t(curve);
    (void)taut_curve_eval(curve, end == 0 ? taut_basis_lo(t) : taut_basis_hi(t), 0, x);
}

/* Where the problem's start has corner c, if it moves and the start does; else NULL. */
static const double *started_at(const taut_film_space *space, int c)
{
    const taut_film_problem *problem = space->problem;
    const size_t at =
        (size_t)(c % 2 * (space->nu - 1)) * (size_t)space->nv + (size_t)(c / 2 * (space->nv - 1));

    return problem->start != NULL && problem->corner_kinds[c] != TAUT_FILM_HELD &&
                   isfinite(taut_norm(problem->start + 3 * at))
               ? problem->start + 3 * at
               : NULL;
}

/* The two edges that end at corner c, and which end that is. */
static void edges_at(int c, int edge[2], int end[2])
{
    edge[0] = c % 2; /* u0 or u1 */
    end[0] = c / 2;
    edge[1] = 2 + c / 2; /* v0 or v1 */
    end[1] = c % 2;
}

static taut_status take_corner(const taut_film_space *space, int c, double corner[3],
                               taut_error *error)
{
    const taut_film_problem *problem = space->problem;
    const double *start = started_at(space, c);
    int edge[2], end[2];

    if (start != NULL) {
        memcpy(corner, start, 3 * sizeof(double));
        return TAUT_OK;
    }
    if (problem->has_corner[c]) {
        memcpy(corner, problem->corners[c], 3 * sizeof(double));
        return TAUT_OK;
    }
    if (problem->corner_kinds[c] != TAUT_FILM_HELD) {
        return TAUT_OK; /* find_starts */
    }
    edges_at(c, edge, end);
    for (int k = 0; k < 2; k++) {
        const taut_film_edge *e = &problem->edges[edge[k]];
        if (e->kind == TAUT_FILM_FIXED && e->curve != NULL) {
            evaluate_end(e->curve, end[k], corner);
            return TAUT_OK;
        }
    }
    char where[32];
    snprintf(where, sizeof where, "/corners/%s", taut_film_corner_names[c]);
    return taut_fail_expected(error, TAUT_BAD_INPUT, "corner-missing", where, taut_none,
                              "a point, or a curve that ends there", "corner %s is not given",
                              taut_film_corner_names[c]);
}

/* The largest distance of a held point from the first corner. */
static double boundary_size(const taut_film_space *space)
{
    double size = 0;
    for (int c = 1; c < 4; c++) {
        size = fmax(size, taut_distance(space->corners[c], space->corners[0]));
    }
    for (int e = 0; e < 4; e++) {
        const taut_curve *curve = space->problem->edges[e].curve;
        const int n = curve != NULL ? taut_basis_count(taut_curve_t(curve)) : 0;
        for (int i = 0; i < n; i++) {
            size = fmax(size, taut_distance(taut_curve_points(curve) + 3 * i, space->corners[0]));
        }
    }
    return size;
}

static taut_status check_ends(const taut_film_space *space, int e, double size, taut_error *error)
{
    for (int end = 0; end < 2; end++) {
        const int c = taut_film_corner_of(e, end);
        char where[32];
        double x[3];
        evaluate_end(space->problem->edges[e].curve, end, x);
        const double gap = taut_distance(x, space->corners[c]);
        if (!(gap <= gap_meeting * size)) {
            snprintf(where, sizeof where, "/edges/%s/fixed", taut_film_edge_names[e]);
            return taut_fail(error, TAUT_BAD_INPUT, "curve-ends", where, gap, gap_meeting * size,
                             "the curve of edge %s misses corner %s by %.3g, expected at most "
                             "%.3g: u0 and u1 run with v, v0 and v1 with u",
                             taut_film_edge_names[e], taut_film_corner_names[c], gap,
                             gap_meeting * size);
        }
    }
    return TAUT_OK;
}

static taut_status check_apart(const taut_film_space *space, double size, taut_error *error)
{
    for (int a = 0; a < 4; a++) {
        for (int b = a + 1; b < 4; b++) {
            const double gap = taut_distance(space->corners[a], space->corners[b]);
            if (!(gap > gap_apart * size)) {
                return taut_fail(
                    error, TAUT_NO_SOLUTION, "no-area", "/corners", gap, gap_apart * size,
                    "corners %s and %s are %.3g apart, expected more than %.3g: give "
                    "corners that differ",
                    taut_film_corner_names[a], taut_film_corner_names[b], gap, gap_apart * size);
            }
        }
    }
    return TAUT_OK;
}

/* Corners that move and do not say where they start: the mean of those that their edges lead to. */
static void find_starts(taut_film_space *space)
{
    const taut_film_problem *problem = space->problem;
    unsigned char is_known[4];

    for (int c = 0; c < 4; c++) {
        is_known[c] = problem->has_corner[c] || problem->corner_kinds[c] == TAUT_FILM_HELD ||
                      started_at(space, c) != NULL;
    }
    for (int round = 0; round < 2; round++) {
        for (int c = 0; c < 4; c++) {
            const int next[2] = {c ^ 1, c ^ 2};
            const int count = is_known[next[0]] + is_known[next[1]];
            if (is_known[c] || count == 0) {
                continue;
            }
            memset(space->corners[c], 0, sizeof space->corners[c]);
            for (int k = 0; k < 2; k++) {
                taut_add_scaled(is_known[next[k]] ? 1.0 / count : 0, space->corners[next[k]],
                                space->corners[c]);
            }
            is_known[c] = 1;
        }
    }
}

/* Moving corners go where their planes and lines are. */
static taut_status place_corners(taut_film_space *space, taut_error *error)
{
    for (int c = 0; c < 4; c++) {
        taut_film_place place;
        const taut_status status = taut_film_place_of(space, c % 2 * (space->nu - 1),
                                                      c / 2 * (space->nv - 1), &place, error);
        if (status != TAUT_OK) {
            return status;
        }
        if (space->problem->corner_kinds[c] != TAUT_FILM_HELD) {
            taut_film_place_onto(&place, space->corners[c]);
        }
    }
    return TAUT_OK;
}

static taut_status find_corners(taut_film_space *space, taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int c = 0; status == TAUT_OK && c < 4; c++) {
        status = take_corner(space, c, space->corners[c], error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    find_starts(space);
    const double size = space->size = boundary_size(space);
    if (!isfinite(size)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "overflow", "/corners", size, taut_none,
                         "the corners are farther apart than doubles reach: scale them down");
    }
    for (int e = 0; status == TAUT_OK && e < 4; e++) {
        if (space->problem->edges[e].curve != NULL) {
            status = check_ends(space, e, size, error);
        }
    }
    if (status == TAUT_OK) {
        status = place_corners(space, error);
    }
    return status == TAUT_OK ? check_apart(space, size, error) : status;
}

/* ---- held edges ---- */

static void lay_chord(const double a[3], const double b[3], int count, const double *at,
                      size_t step, double *points)
{
    for (int k = 0; k < count; k++, points += 3 * step) {
        for (int c = 0; c < 3; c++) {
            points[c] = k == 0 ? a[c] : k == count - 1 ? b[c] : (1 - at[k]) * a[c] + at[k] * b[c];
        }
    }
}

/* Edge e of the points: its curve, or its chord; a cable is its chord for now. */
static taut_status lay_edge(taut_film_space *space, int e, taut_arena *arena, taut_error *error)
{
    size_t first = 0, step = 0;
    int count = 0;

    taut_film_edge_points(space->nu, space->nv, e, &first, &step, &count);
    if (space->problem->edges[e].kind == TAUT_FILM_FIXED) {
        for (int k = 0; k < count; k++) {
            space->known[first + (size_t)k * step] = 1;
        }
        if (space->problem->edges[e].curve != NULL) {
            return taut_film_lay_curve(space, e, arena, error);
        }
    }
    lay_chord(space->corners[taut_film_corner_of(e, 0)], space->corners[taut_film_corner_of(e, 1)],
              count, space->greville[e < 2], step, space->points + 3 * first);
    return TAUT_OK;
}

/* ---- the start ---- */

static void blend(const taut_film_space *space, const double *net, double a, double b, size_t i,
                  size_t j, double x[3])
{
    const size_t nv = (size_t)space->nv, last_u = (size_t)space->nu - 1, last_v = nv - 1;
    const double *at[8] = {net + 3 * j,
                           net + 3 * (last_u * nv + j),
                           net + 3 * (i * nv),
                           net + 3 * (i * nv + last_v),
                           net,
                           net + 3 * (last_u * nv),
                           net + 3 * last_v,
                           net + 3 * (last_u * nv + last_v)};
    const double share[8] = {1 - a,        a,     1 - b, b, -(1 - a) * (1 - b), -a * (1 - b),
                             -(1 - a) * b, -a * b};
    memset(x, 0, 3 * sizeof(double));
    for (int k = 0; k < 8; k++) {
        taut_add_scaled(share[k], at[k], x);
    }
}

/* sum over k of the sides of a closed polygon by those of another, which is turned by so many points. */
static double compare_sides(const double *a, const double *b, size_t line, int period, int turn)
{
    double sum = 0;
    for (int k = 0; k < period; k++) {
        double side[3], other[3];
        const double *x = a + (size_t)((k + turn) % period) * line, *y = b + (size_t)k * line;
        taut_difference(x + line, x, side);
        taut_difference(y + line, y, other);
        sum += taut_dot(side, other);
    }
    return sum;
}

/* x += share of the place on a closed polygon after so many sides. */
static void add_place(const double *a, size_t line, int period, double share, double at,
                      double x[3])
{
    const double whole = floor(at), part = at - whole;
    const size_t k = (size_t)(((int)whole + 2 * period) % period);
    taut_add_scaled(share * (1 - part), a + k * line, x);
    taut_add_scaled(share * part, a + (k + 1) * line, x);
}

/* Between the two edges of a ring, on straight lines, which would all meet where the edges begin on opposite sides: these turn
 * along with the edges then. */
static void fill_ring(const taut_film_space *space, double *net)
{
    const int along_u = space->problem->ring == TAUT_FILM_RING_U, period = space->around->period;
    const int across = along_u ? space->nv : space->nu, around = along_u ? space->nu : space->nv;
    const size_t nv = (size_t)space->nv, step = 3 * (along_u ? 1 : nv),
                 line = 3 * (along_u ? nv : 1);
    const double *last = net + (size_t)(across - 1) * step;
    int turn = 0;

    if (compare_sides(net, last, line, period, 0) < 0) {
        for (int k = 1; k < period; k++) {
            turn = compare_sides(net, last, line, period, k) >
                           compare_sides(net, last, line, period, turn)
                       ? k
                       : turn;
        }
        turn -= 2 * turn > period ? period : 0;
    }
    for (int k = 0; k < around; k++) {
        for (int j = 1; j < across - 1; j++) {
            const double t = space->greville[along_u][j];
            double *x = net + (size_t)k * line + (size_t)j * step;
            memset(x, 0, 3 * sizeof *x);
            add_place(net, line, period, 1 - t, k + t * turn, x);
            add_place(last, line, period, t, k - (1 - t) * turn, x);
        }
    }
}

void taut_film_space_fill(const taut_film_space *space, double *net)
{
    if (space->around != NULL) {
        fill_ring(space, net);
        return;
    }
    for (int i = 1; i < space->nu - 1; i++) {
        for (int j = 1; j < space->nv - 1; j++) {
            blend(space, net, space->greville[0][i], space->greville[1][j], (size_t)i, (size_t)j,
                  net + 3 * ((size_t)i * (size_t)space->nv + (size_t)j));
        }
    }
}

/* ---- cables ---- */

static taut_status check_ratio(int e, const char *member, double ratio, double given,
                               taut_error *error)
{
    char where[48];

    if (ratio >= TAUT_FILM_FORCE_MIN && ratio <= TAUT_FILM_FORCE_MAX) {
        return TAUT_OK;
    }
    snprintf(where, sizeof where, "/edges/%s/cable/%s", taut_film_edge_names[e], member);
    return taut_fail(error, TAUT_BAD_INPUT, "value", where, given, taut_none,
                     "the %s of cable %s is %.3g of the film's tension times its size, "
                     "expected %.0e to %.0e",
                     member, taut_film_edge_names[e], ratio, TAUT_FILM_FORCE_MIN,
                     TAUT_FILM_FORCE_MAX);
}

static int ends_move(const taut_film_problem *problem, int e)
{
    return problem->corner_kinds[taut_film_corner_of(e, 0)] != TAUT_FILM_HELD ||
           problem->corner_kinds[taut_film_corner_of(e, 1)] != TAUT_FILM_HELD;
}

/* A length of which the arc of a circle has the radius, and so the force, `ratio`. */
static taut_status take_length(taut_film_space *space, int e, double chord, double length,
                               taut_error *error)
{
    const taut_film_edge *edge = &space->problem->edges[e];
    const int unit = space->scaling.outer + space->scaling.inner;
    if (ends_move(space->problem, e)) { /* where they start says nothing of where they stay */
        chord = fmin(chord, chord_shorter * length);
    }
    const double a = length > chord ? taut_film_arc_angle(chord, length) : 0;
    const double radius = a > 0 ? chord / (2 * taut_sin(a)) : INFINITY;

    if (!(radius <= TAUT_FILM_FORCE_MAX)) {
        const int by_sag = edge->law == TAUT_FILM_SAG;
        char where[48];
        snprintf(where, sizeof where, "/edges/%s/cable/%s", taut_film_edge_names[e],
                 by_sag ? "sag" : "length");
        return taut_fail(error, TAUT_NO_SOLUTION, "cable-too-short", where,
                         by_sag ? edge->sag : edge->length, ldexp(chord, unit),
                         "cable %s is %.17g long, expected more than the distance of its ends, "
                         "%.17g: give it more length",
                         taut_film_edge_names[e], ldexp(length, unit), ldexp(chord, unit));
    }
    space->ratios[e] = radius;
    space->is_arc[e] = a <= 0.5 * TAUT_PI;
    space->cables[e].length = space->cables[e].start = length;
    return TAUT_OK;
}

static taut_status take_elastic(taut_film_space *space, int e, double chord, double unstressed,
                                taut_error *error)
{
    const taut_film_edge *edge = &space->problem->edges[e];
    const double s = taut_film_tension(space->problem);
    const int unit = space->scaling.outer + space->scaling.inner;
    const double k = edge->stiffness / s / edge->unstressed;
    taut_film_cable *cable = &space->cables[e];
    const taut_status status =
        check_ratio(e, "stiffness", ldexp(edge->stiffness / s, -unit), edge->stiffness, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (!(k <= TAUT_FILM_FORCE_MAX) || !(unstressed > 0)) {
        return check_ratio(e, "unstressed", unstressed, edge->unstressed, error);
    }
    const double radius = taut_film_arc_elastic(chord, unstressed, k);
    space->is_arc[e] = radius > 0;
    space->ratios[e] = radius > 0 ? radius : 0.5 * chord;
    *cable = (taut_film_cable){
        .stiffness = k, .target = unstressed, .start = unstressed + space->ratios[e] / k};
    return space->ratios[e] <= TAUT_FILM_FORCE_MAX
               ? TAUT_OK
               : check_ratio(e, "unstressed", space->ratios[e], edge->unstressed, error);
}

/* A cable that closes: by its length or its law a circle, as it is in a flat film around it. */
static taut_status find_closed_cable(taut_film_space *space, int e, taut_error *error)
{
    const taut_film_edge *edge = &space->problem->edges[e];
    const double s = taut_film_tension(space->problem);
    const int unit = space->scaling.outer + space->scaling.inner;
    taut_film_cable *cable = &space->cables[e];

    if (edge->law == TAUT_FILM_LENGTH) {
        cable->length = cable->start = ldexp(edge->length, -unit);
        space->ratios[e] = cable->length / (2 * TAUT_PI);
        return check_ratio(e, "length", space->ratios[e], edge->length, error);
    }
    if (edge->law == TAUT_FILM_ELASTIC) {
        const double k = ldexp(edge->stiffness / s, -unit) / ldexp(edge->unstressed, -unit);
        const double unstressed = ldexp(edge->unstressed, -unit), turn = 2 * TAUT_PI;
        space->ratios[e] = turn * k > 2 ? k * unstressed / (turn * k - 1) : unstressed;
        *cable = (taut_film_cable){
            .stiffness = k, .target = unstressed, .start = unstressed + space->ratios[e] / k};
        return check_ratio(e, "stiffness", ldexp(edge->stiffness / s, -unit), edge->stiffness,
                           error);
    }
    space->ratios[e] = ldexp(edge->force / s, -unit);
    return check_ratio(e, "force", space->ratios[e], edge->force, error);
}

static taut_status find_cable(taut_film_space *space, int e, taut_error *error)
{
    const taut_film_edge *edge = &space->problem->edges[e];
    const double s = taut_film_tension(space->problem);
    const int unit = space->scaling.outer + space->scaling.inner;
    const double chord = ldexp(taut_distance(space->corners[taut_film_corner_of(e, 0)],
                                             space->corners[taut_film_corner_of(e, 1)]),
                               -unit);

    if (space->around != NULL) {
        return find_closed_cable(space, e, error);
    }
    switch (edge->law) {
    case TAUT_FILM_LENGTH:
        return take_length(space, e, chord, ldexp(edge->length, -unit), error);
    case TAUT_FILM_SAG:
        return take_length(space, e, chord, taut_film_arc_of_sag(chord, edge->sag), error);
    case TAUT_FILM_ELASTIC:
        return take_elastic(space, e, chord, ldexp(edge->unstressed, -unit), error);
    case TAUT_FILM_FORCE:
        break;
    }
    space->ratios[e] = ldexp(edge->force / s, -unit);
    space->is_arc[e] = 1;
    return check_ratio(e, "force", space->ratios[e], edge->force, error);
}

static taut_status find_cables(taut_film_space *space, taut_error *error)
{
    taut_status status = TAUT_OK;

    for (int e = 0; status == TAUT_OK && e < 4; e++) {
        if (space->problem->edges[e].kind == TAUT_FILM_CABLE) {
            status = find_cable(space, e, error);
        }
    }
    return status;
}

double taut_film_force(const taut_film_space *space, int e, double share)
{
    const taut_film_edge *edge = &space->problem->edges[e];
    const double s = taut_film_tension(space->problem);

    return edge->law == TAUT_FILM_FORCE
               ? share * edge->force
               : s * ldexp(share * space->ratios[e], space->scaling.outer + space->scaling.inner);
}

static void mark_boundary(const taut_film_space *space, unsigned char *laid)
{
    for (int e = 0; e < 4; e++) {
        size_t first = 0, step = 0;
        int count = 0;
        taut_film_edge_points(space->nu, space->nv, e, &first, &step, &count);
        for (int k = 0; taut_film_has_edge(space->problem, e) && k < count; k++) {
            laid[first + (size_t)k * step] = 1;
        }
    }
}

static taut_status lay_open(taut_film_space *space, taut_arena *arena, taut_error *error)
{
    taut_status status = find_corners(space, error);

    for (int e = 0; status == TAUT_OK && e < 4; e++) {
        status = lay_edge(space, e, arena, error);
    }
    for (int c = 0; c < 4; c++) {
        const size_t at = (size_t)(c % 2 * (space->nu - 1)) * (size_t)space->nv +
                          (size_t)(c / 2 * (space->nv - 1));
        space->known[at] |= space->problem->corner_kinds[c] == TAUT_FILM_HELD;
    }
    return status;
}

static taut_status lay_ring(taut_film_space *space, taut_arena *arena, taut_error *error)
{
    const taut_film_problem *problem = space->problem;
    const int along_u = problem->ring == TAUT_FILM_RING_U;
    taut_loop *around = taut_arena_take(arena, 1, sizeof *around);

    if (around == NULL ||
        taut_loop_new(along_u ? problem->u : problem->v, arena, around) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    space->around = around;
    return taut_film_ring_lay(space, arena, error);
}

taut_status taut_film_space_new(const taut_film_problem *problem, taut_arena *arena,
                                taut_film_space *space, taut_error *error)
{
    unsigned char *laid = NULL;
    taut_status status = TAUT_OK;

    *space = (taut_film_space){
        .problem = problem, .nu = taut_basis_count(problem->u), .nv = taut_basis_count(problem->v)};
    space->count = (size_t)space->nu * (size_t)space->nv;
    space->points = taut_arena_take(arena, space->count, 3 * sizeof(double));
    space->start = taut_arena_take(arena, space->count, 3 * sizeof(double));
    space->known = taut_arena_take(arena, space->count, 1);
    laid = taut_arena_take(arena, space->count, 1);
    space->greville[0] = taut_arena_take(arena, (size_t)space->nu, sizeof(double));
    space->greville[1] = taut_arena_take(arena, (size_t)space->nv, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    mark_boundary(space, laid);
    taut_film_greville(problem->u, space->greville[0]);
    taut_film_greville(problem->v, space->greville[1]);
    status = problem->ring == TAUT_FILM_OPEN ? lay_open(space, arena, error)
                                             : lay_ring(space, arena, error);
    if (status == TAUT_OK) {
        status = taut_film_begin(space, arena, error);
    }
    if (status == TAUT_OK) {
        status = taut_film_freedom(space, arena, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    space->scaling =
        taut_scaling_of(space->count, space->points, space->leader == NULL ? space->known : laid);
    taut_scaling_apply(&space->scaling, space->count, space->points, NULL, space->start);
    taut_film_space_fill(space, space->start);
    taut_film_begin_inside(space);
    return find_cables(space, error);
}
