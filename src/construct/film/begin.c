/* begin.c -- the start of a film where it is given: points of the clamped net, NaN where there is none.
 *
 * Of a film that goes around each line becomes the nearest that does (construct/common/curve_fit.h).
 */
#include "construct/film/begin.h"

#include "construct/common/curve_fit.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double gap_held = 1e-9; /* of the size: a held point and the start's */

static int is_given(const double x[3])
{
    return isfinite(x[0]) && isfinite(x[1]) && isfinite(x[2]);
}

/* A line of points, `step` apart, of a clamped net: that of the functions that go around. row: scratch. */
static taut_status open_line(const taut_film_space *space, double *line, size_t step, double *row)
{
    const int along_u = space->problem->ring == TAUT_FILM_RING_U;
    const taut_basis *basis = along_u ? space->problem->u : space->problem->v;
    const int count = taut_basis_count(basis);
    int given = 1;
    double deviation = 0;
    taut_curve *curve = NULL;

    for (int k = 0; k < count; k++) {
        memcpy(row + 3 * k, line + 3 * (size_t)k * step, 3 * sizeof(double));
        given = given && is_given(row + 3 * k);
    }
    if (!given) {
        return TAUT_OK;
    }
    taut_status status = taut_curve_new(NULL, basis, row, NULL, &curve, NULL);
    if (status == TAUT_OK) {
        status = taut_curve_fit_around(curve, basis, space->around, row, &deviation);
    }
    for (int k = 0; status == TAUT_OK && k < count; k++) {
        memcpy(line + 3 * (size_t)k * step, row + 3 * k, 3 * sizeof(double));
    }
    taut_curve_free(curve);
    return status;
}

static taut_status open_lines(taut_film_space *space, taut_arena *arena, taut_error *error)
{
    const int along_u = space->problem->ring == TAUT_FILM_RING_U;
    const size_t nv = (size_t)space->nv;
    double *row = taut_arena_take(arena, (size_t)(space->nu + space->nv), 3 * sizeof(double));

    if (row == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < (along_u ? space->nv : space->nu); k++) {
        double *line = space->given + 3 * (along_u ? (size_t)k : (size_t)k * nv);
        const taut_status status = open_line(space, line, along_u ? nv : 1, row);
        if (status == TAUT_NO_MEMORY) {
            return taut_fail_memory(error);
        }
        if (status != TAUT_OK) {
            return taut_fail(error, TAUT_BAD_INPUT, "start", "/start", taut_none, taut_none,
                             "the start does not go around as the film does: leave it out");
        }
    }
    return TAUT_OK;
}

/* Held points have to be where the start has them. */
static taut_status check_held(const taut_film_space *space, taut_error *error)
{
    const double most = gap_held * space->size;

    for (size_t i = 0; i < space->count; i++) {
        const double *x = space->given + 3 * i;
        const double gap = taut_distance(x, space->points + 3 * i);
        if (space->known[i] && is_given(x) && !(gap <= most)) {
            const int a = (int)i / space->nv, b = (int)i % space->nv;
            return taut_fail(error, TAUT_BAD_INPUT, "start", "/start", gap, most,
                             "point (%d, %d) of the start is %.3g away from what holds the film "
                             "there, expected at most %.3g",
                             a, b, gap, most);
        }
    }
    return TAUT_OK;
}

/* Edges that move start as they are given, if all their points are. */
static void take_edge(taut_film_space *space, int e)
{
    size_t first = 0, step = 0;
    int count = 0, given = 1;

    taut_film_edge_points(space->nu, space->nv, e, &first, &step, &count);
    for (int k = 0; k < count; k++) {
        const size_t at = first + (size_t)k * step;
        given = given && (space->known[at] || is_given(space->given + 3 * at));
    }
    for (int k = 0; given && k < count; k++) {
        const size_t at = first + (size_t)k * step;
        if (!space->known[at]) {
            memcpy(space->points + 3 * at, space->given + 3 * at, 3 * sizeof(double));
        }
    }
}

taut_status taut_film_begin(taut_film_space *space, taut_arena *arena, taut_error *error)
{
    taut_status status = TAUT_OK;

    if (space->problem->start == NULL) {
        return TAUT_OK;
    }
    space->given = taut_arena_copy(arena, space->problem->start, space->count, 3 * sizeof(double));
    if (space->given == NULL) {
        return taut_fail_memory(error);
    }
    if (space->around != NULL) {
        status = open_lines(space, arena, error);
    }
    if (status == TAUT_OK) {
        status = check_held(space, error);
    }
    for (int e = 0; status == TAUT_OK && e < 4; e++) {
        if (taut_film_has_edge(space->problem, e)) {
            take_edge(space, e);
        }
    }
    return status;
}

void taut_film_begin_inside(taut_film_space *space)
{
    const int nu = space->nu, nv = space->nv;

    if (space->given == NULL) {
        return;
    }
    for (int i = 0; i < nu * nv; i++) {
        const double *x = space->given + 3 * i;
        const int at_u =
            space->problem->ring != TAUT_FILM_RING_U && (i / nv == 0 || i / nv == nu - 1);
        const int at_v =
            space->problem->ring != TAUT_FILM_RING_V && (i % nv == 0 || i % nv == nv - 1);
        if (!at_u && !at_v && is_given(x)) {
            taut_scaling_apply(&space->scaling, 1, x, NULL, space->start + 3 * i);
            space->has_inside = 1;
        }
    }
}
