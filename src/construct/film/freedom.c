#include "construct/film/freedom.h"

#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double parallel = 1e-9; /* sine: below it two planes are one, or none */
static const double meeting = 1e-9;  /* of the size: planes that are one are no further apart */

/* ---- places ---- */

static int make_unit(double x[3])
{
    const double size = taut_norm(x);
    for (int c = 0; c < 3; c++) {
        x[c] /= size;
    }
    return size > 0;
}

/* One plane more; 0 where it does not meet what is there already. */
static int add_plane(taut_film_place *place, const double normal[3], const double point[3],
                     double size)
{
    double n[3] = {normal[0], normal[1], normal[2]}, away[3];

    (void)make_unit(n);
    if (place->count == 0) {
        memcpy(place->point, point, sizeof place->point);
    }
    taut_difference(point, place->point, away);
    const double distance = taut_dot(n, away);
    for (int k = 0; k < place->count; k++) {
        taut_add_scaled(-taut_dot(n, place->normals[k]), place->normals[k], n);
    }
    const double sine = taut_norm(n);
    if (!(sine > parallel)) {
        return fabs(distance) <= meeting * size;
    }
    (void)make_unit(n);
    taut_add_scaled(distance / sine, n, place->point);
    memcpy(place->normals[place->count++], n, sizeof n);
    return 1;
}

/* A line is where two planes meet. */
static int add_line(taut_film_place *place, const taut_film_guide *line, double size)
{
    double d[3] = {line->direction[0], line->direction[1], line->direction[2]}, axis[3] = {0, 0, 0};
    double p[3], q[3];

    (void)make_unit(d);
    const double x = fabs(d[0]), y = fabs(d[1]), z = fabs(d[2]);
    axis[x <= y && x <= z ? 0 : y <= z ? 1 : 2] = 1;
    taut_cross(d, axis, p);
    taut_cross(d, p, q);
    return add_plane(place, p, line->point, size) && add_plane(place, q, line->point, size);
}

/* The edges that point (i, j) lies on; those that go around have none. */
static int edges_at(const taut_film_space *space, int i, int j, int edges[2])
{
    int count = 0;

    if (space->problem->ring != TAUT_FILM_RING_U && (i == 0 || i == space->nu - 1)) {
        edges[count++] = i > 0;
    }
    if (space->problem->ring != TAUT_FILM_RING_V && (j == 0 || j == space->nv - 1)) {
        edges[count++] = 2 + (j > 0);
    }
    return count;
}

static int corner_of(const taut_film_space *space, int i, int j)
{
    return space->problem->ring == TAUT_FILM_OPEN && (i == 0 || i == space->nu - 1) &&
                   (j == 0 || j == space->nv - 1)
               ? (i > 0) + 2 * (j > 0)
               : -1;
}

static int add_guide(const taut_film_space *space, int corner, taut_film_place *place)
{
    const taut_film_guide *guide = &space->problem->guides[corner];

    switch (space->problem->corner_kinds[corner]) {
    case TAUT_FILM_ON_LINE:
        return add_line(place, guide, space->size);
    case TAUT_FILM_ON_PLANE:
        return add_plane(place, guide->direction, guide->point, space->size);
    case TAUT_FILM_HELD:
    case TAUT_FILM_FREE:
        break;
    }
    return 1;
}

taut_status taut_film_place_of(const taut_film_space *space, int i, int j, taut_film_place *place,
                               taut_error *error)
{
    const int corner = corner_of(space, i, j);
    int edges[2], meets = 1;
    const int count = edges_at(space, i, j, edges);

    *place = (taut_film_place){.count = 0};
    for (int k = 0; k < count; k++) {
        const taut_film_edge *edge = &space->problem->edges[edges[k]];
        if (taut_film_has_plane(edge)) {
            meets =
                meets && add_plane(place, edge->plane.direction, edge->plane.point, space->size);
        }
    }
    meets = meets && (corner < 0 || add_guide(space, corner, place));
    if (!meets) {
        char where[32];
        snprintf(where, sizeof where, "/corners/%s", taut_film_corner_names[corner]);
        return taut_fail(error, TAUT_BAD_INPUT, "corner-conflict", where, taut_none, taut_none,
                         "what keeps corner %s does not meet: give planes and lines that do",
                         taut_film_corner_names[corner]);
    }
    return TAUT_OK;
}

void taut_film_place_onto(const taut_film_place *place, double x[3])
{
    for (int k = 0; k < place->count; k++) {
        double away[3];
        taut_difference(x, place->point, away);
        taut_add_scaled(-taut_dot(place->normals[k], away), place->normals[k], x);
    }
}

/* ---- the net ---- */

static void tie_points(taut_film_space *space)
{
    const int nu = space->nu, nv = space->nv;
    const int along_u = space->problem->ring == TAUT_FILM_RING_U;

    for (int i = 0; i < nu * nv; i++) {
        const int around = along_u ? i / nv : i % nv;
        const int copy = around >= space->around->period;
        space->leader[i] = !copy     ? i
                           : along_u ? i - space->around->period * nv
                                     : i - space->around->period;
    }
    for (int e = 0; e < 4; e++) {
        if (space->problem->edges[e].kind == TAUT_FILM_POLE) {
            size_t first = 0, step = 0;
            int count = 0;
            taut_film_edge_points(nu, nv, e, &first, &step, &count);
            for (int k = 0; k < count; k++) {
                space->leader[first + (size_t)k * step] = (int)first;
            }
        }
    }
    for (int i = 0; i < nu * nv; i++) {
        space->known[i] |= space->leader[i] != i;
    }
}

static void lay_projector(const taut_film_place *place, double p[6])
{
    for (int c = 0, at = 0; c < 3; c++) {
        for (int d = 0; d <= c; d++, at++) {
            p[at] = c == d;
            for (int k = 0; k < place->count; k++) {
                p[at] -= place->normals[k][c] * place->normals[k][d];
            }
        }
    }
}

/* A point that is held has to be where its planes are. */
static taut_status check_held(const taut_film_space *space, int i, int j,
                              const taut_film_place *place, taut_error *error)
{
    const double *x = space->points + 3 * ((size_t)i * (size_t)space->nv + (size_t)j);
    const int corner = corner_of(space, i, j);
    double onto[3] = {x[0], x[1], x[2]};

    taut_film_place_onto(place, onto);
    const double away = taut_distance(x, onto);
    if (corner < 0 || away <= meeting * space->size) {
        return TAUT_OK;
    }
    char where[32];
    snprintf(where, sizeof where, "/corners/%s", taut_film_corner_names[corner]);
    return taut_fail(error, TAUT_BAD_INPUT, "corner-conflict", where, away, meeting * space->size,
                     "corner %s is %.3g away from the plane of its edge, expected at most %.3g: "
                     "move the corner, or the plane",
                     taut_film_corner_names[corner], away, meeting * space->size);
}

static taut_status keep_points(taut_film_space *space, taut_error *error)
{
    for (int i = 0; i < space->nu; i++) {
        for (int j = 0; j < space->nv; j++) {
            const size_t at = (size_t)i * (size_t)space->nv + (size_t)j;
            taut_film_place place;
            taut_status status = taut_film_place_of(space, i, j, &place, error);
            if (status != TAUT_OK) {
                return status;
            }
            lay_projector(&place, space->allowed + 6 * at);
            if (space->known[at] && space->leader[at] == (int)at) {
                status = check_held(space, i, j, &place, error);
            } else {
                taut_film_place_onto(&place, space->points + 3 * at);
                space->known[at] |= place.count == 3;
            }
            if (status != TAUT_OK) {
                return status;
            }
        }
    }
    return TAUT_OK;
}

/* ---- is it held at all? ---- */

/* Do held points, lines and planes leave no translation? */
static taut_status check_floating(const taut_film_space *space, taut_error *error)
{
    taut_film_place all = {.count = 0};

    for (size_t i = 0; i < space->count && all.count < 3; i++) {
        if (space->known[i] && space->leader[i] == (int)i) {
            return TAUT_OK;
        }
        for (int c = 0; c < 3; c++) { /* I - P has the normals in its columns */
            const double *p = space->allowed + 6 * i;
            const double full[3][3] = {
                {1 - p[0], -p[1], -p[3]}, {-p[1], 1 - p[2], -p[4]}, {-p[3], -p[4], 1 - p[5]}};
            if (taut_norm(full[c]) > parallel) {
                (void)add_plane(&all, full[c], all.point, 1);
            }
        }
    }
    if (all.count == 3) {
        return TAUT_OK;
    }
    double free[3] = {1, 0, 0};
    for (int k = 0; k < 3 && all.count > 0; k++) {
        double axis[3] = {k == 0, k == 1, k == 2};
        for (int n = 0; n < all.count; n++) {
            taut_add_scaled(-taut_dot(axis, all.normals[n]), all.normals[n], axis);
        }
        if (k == 0 || taut_norm(axis) > taut_norm(free)) {
            memcpy(free, axis, sizeof free);
        }
    }
    (void)make_unit(free);
    return taut_fail(error, TAUT_NO_SOLUTION, "floating", "/edges", all.count, 3,
                     "nothing holds the film along (%.6g, %.6g, %.6g): hold a corner or an edge",
                     free[0], free[1], free[2]);
}

/* Does every point move by itself, and wherever it wants? */
static int is_plain(const taut_film_problem *problem)
{
    int plain = problem->ring == TAUT_FILM_OPEN;
    for (int k = 0; k < 4; k++) {
        plain = plain && !taut_film_has_plane(&problem->edges[k]) &&
                problem->corner_kinds[k] == TAUT_FILM_HELD;
    }
    return plain;
}

taut_status taut_film_freedom(taut_film_space *space, taut_arena *arena, taut_error *error)
{
    const int plain = is_plain(space->problem);
    taut_status status = TAUT_OK;

    if (!plain) {
        space->leader = taut_arena_take(arena, space->count, sizeof(int));
        space->allowed = taut_arena_take(arena, space->count, 6 * sizeof(double));
        if (taut_arena_status(arena) != TAUT_OK) {
            return taut_fail_memory(error);
        }
        for (size_t i = 0; i < space->count; i++) {
            space->leader[i] = (int)i;
        }
        if (space->around != NULL) {
            tie_points(space);
        }
        status = keep_points(space, error);
        if (status == TAUT_OK) {
            status = check_floating(space, error);
        }
    }
    if (status != TAUT_OK) {
        return status;
    }
    if (taut_mask_new(space->nu, space->nv, space->known, arena, &space->mask) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    space->mask.leader = space->leader;
    space->mask.allowed = space->allowed;
    return TAUT_OK;
}
