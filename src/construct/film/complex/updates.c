#include "construct/film/complex/updates.h"

#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/keep.h"

#include <math.h>
#include <string.h>

int taut_film_complex_updates(const taut_film_problem *problem)
{
    int most = 0;

    for (int p = 0; p < problem->patch_count; p++) {
        most = problem->patches[p].updates > most ? problem->patches[p].updates : most;
    }
    return most;
}

/* A patch that begins where it was found; edges that are held on curves are laid anew. */
static taut_status update_patch(const taut_film_complex *c, int p, int round, const double *points,
                                taut_arena *arena, taut_film_problem *patch, taut_error *error)
{
    const int first = c->first[p], count = c->first[p + 1] - first;
    double *net = taut_arena_take(arena, (size_t)count, 3 * sizeof(double));
    taut_surface *surface = NULL;

    *patch = c->problem->patches[p];
    if (net == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < count; k++) {
        memcpy(net + 3 * k, points + 3 * c->node[first + k], 3 * sizeof(double));
    }
    if (patch->updates >= round) {
        const taut_status status =
            taut_surface_new(NULL, patch->u, patch->v, net, NULL, &surface, error);
        if (status != TAUT_OK) {
            return status;
        }
        if (!taut_keep_surface(arena, surface)) {
            return taut_fail_memory(error);
        }
        patch->reference = surface;
    }
    for (int e = 0; e < 4; e++) {
        for (int k = 0; patch->edges[e].curve != NULL && k < taut_film_complex_along(patch, e);
             k++) {
            net[3 * taut_film_complex_point(patch, e, k)] = NAN;
        }
    }
    patch->start = net;
    return TAUT_OK;
}

taut_status taut_film_complex_update(taut_film_layout *layout, taut_film_rest *rest,
                                     const taut_make_options *options, double *changes,
                                     taut_arena *arena, taut_error *error)
{
    const taut_film_problem *problem = layout->complex.problem;
    const size_t count = (size_t)problem->patch_count;
    const int updates = taut_film_complex_updates(problem);
    const double size = taut_film_complex_size(problem);
    taut_status status = TAUT_OK;

    for (int round = 1; status == TAUT_OK && round <= updates; round++) {
        taut_film_problem *next = taut_arena_take(arena, 1, sizeof *next);
        taut_film_problem *patches = taut_arena_take(arena, count, sizeof *patches);
        const double *before = rest->points;
        const int iterations = rest->iterations;
        if (taut_arena_status(arena) != TAUT_OK) {
            return taut_fail_memory(error);
        }
        for (int p = 0; status == TAUT_OK && p < problem->patch_count; p++) {
            status = update_patch(&layout->complex, p, round, before, arena, &patches[p], error);
        }
        if (status != TAUT_OK) {
            return status;
        }
        *next = *problem;
        next->patches = patches;
        status = taut_film_layout_new(next, arena, layout, error);
        if (status == TAUT_OK) {
            status = taut_film_rest_find(layout, options, arena, rest, error);
        }
        changes[round - 1] = 0;
        for (int a = 0; status == TAUT_OK && a < layout->complex.nodes; a++) {
            const double moved = taut_distance(rest->points + 3 * a, before + 3 * a) / size;
            changes[round - 1] = fmax(changes[round - 1], moved);
        }
        rest->iterations += iterations;
    }
    return status;
}
