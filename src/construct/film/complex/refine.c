#include "construct/film/complex/refine.h"

#include "construct/film/rounds.h"
#include "core/fail.h"
#include "geometry/keep.h"
#include "taut/operations.h"

#include <math.h>
#include <string.h>

enum { CONFIRMATIONS = 2 };

static taut_status halve(const taut_surface *surface, taut_arena *arena,
                         const taut_surface **halved, taut_error *error)
{
    taut_surface *along_u = NULL, *made = NULL;
    taut_status status = taut_surface_refine(surface, TAUT_ALONG_U, &along_u, error);

    if (status == TAUT_OK) {
        status = taut_surface_refine(along_u, TAUT_ALONG_V, &made, error);
    }
    taut_surface_free(along_u);
    *halved = made;
    return status != TAUT_OK || taut_keep_surface(arena, made) ? status : taut_fail_memory(error);
}

/* A patch of the film before on halved spans, from where it is; edges that are held on curves are laid anew. */
static taut_status halve_patch(const taut_film_complex *c, int p, const double *points,
                               taut_arena *arena, taut_film_problem *patch, taut_error *error)
{
    const taut_film_problem *before = &c->problem->patches[p];
    const int first = c->first[p], count = c->first[p + 1] - first;
    double *net = taut_arena_take(arena, (size_t)count, 3 * sizeof(double));
    taut_surface *surface = NULL;
    const taut_surface *halved = NULL;
    taut_status status = net != NULL ? TAUT_OK : taut_fail_memory(error);

    for (int k = 0; net != NULL && k < count; k++) {
        memcpy(net + 3 * k, points + 3 * c->node[first + k], 3 * sizeof(double));
    }
    if (status == TAUT_OK) {
        status = taut_surface_new(NULL, before->u, before->v, net, NULL, &surface, error);
    }
    if (status == TAUT_OK) {
        status = halve(surface, arena, &halved, error);
    }
    taut_surface_free(surface);
    if (status != TAUT_OK) {
        return status;
    }
    *patch = *before;
    patch->u = taut_surface_u(halved);
    patch->v = taut_surface_v(halved);
    double *start =
        taut_arena_copy(arena, taut_surface_points(halved),
                        (size_t)taut_basis_count(patch->u) * (size_t)taut_basis_count(patch->v),
                        3 * sizeof(double));
    for (int e = 0; start != NULL && e < 4; e++) {
        for (int k = 0; patch->edges[e].curve != NULL && k < taut_film_complex_along(patch, e);
             k++) {
            start[3 * taut_film_complex_point(patch, e, k)] = NAN;
        }
    }
    patch->start = start;
    if (start != NULL && before->reference != NULL) {
        return halve(before->reference, arena, &patch->reference, error);
    }
    return start != NULL ? TAUT_OK : taut_fail_memory(error);
}

/* The problem of the film before, on halved spans. */
static taut_status halve_all(const taut_film_complex *c, const double *points, taut_arena *arena,
                             taut_film_problem *problem, taut_error *error)
{
    const size_t count = (size_t)c->problem->patch_count;
    taut_film_problem *patches = taut_arena_take(arena, count, sizeof *patches);
    taut_status status = patches != NULL ? TAUT_OK : taut_fail_memory(error);
    double all = 0;

    for (size_t p = 0; status == TAUT_OK && p < count; p++) {
        status = halve_patch(c, (int)p, points, arena, &patches[p], error);
        all += status == TAUT_OK
                   ? (double)taut_basis_count(patches[p].u) * taut_basis_count(patches[p].v)
                   : 0;
    }
    if (status != TAUT_OK) {
        return status;
    }
    *problem = *c->problem;
    problem->patches = patches;
    return all <= TAUT_FILM_PATCHES_POINTS_MAX
               ? TAUT_OK
               : taut_fail(error, TAUT_BAD_INPUT, "size", "/refine", all,
                           TAUT_FILM_PATCHES_POINTS_MAX,
                           "%.0f control points of the finest space, expected at most %d: refine "
                           "less",
                           all, TAUT_FILM_PATCHES_POINTS_MAX);
}

/* The film before on halved spans. */
static taut_status find_finer(taut_film_layout *now, taut_film_rest *found,
                              const taut_make_options *options, taut_film_problem *finer,
                              taut_arena *arena, taut_error *error)
{
    taut_status status = halve_all(&now->complex, found->points, arena, finer, error);

    if (status == TAUT_OK) {
        status = taut_film_layout_new(finer, arena, now, error);
    }
    return status == TAUT_OK ? taut_film_rest_find(now, options, arena, found, error) : status;
}

taut_status taut_film_complex_confirm(const taut_film_layout *layout, taut_film_rest *rest,
                                      const taut_make_options *options, taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    taut_film_problem *finer = taut_arena_take(arena, CONFIRMATIONS, sizeof *finer);
    taut_film_layout now = *layout;
    taut_film_rest found = *rest;
    taut_status status = taut_arena_status(arena) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);

    for (int k = 0;
         status == TAUT_OK && k < CONFIRMATIONS && (k == 0 || found.doubt == TAUT_FILM_BY_NORMAL);
         k++) {
        status = find_finer(&now, &found, options, &finer[k], arena, error);
    }
    if (status == TAUT_OK && found.doubt != TAUT_FILM_BY_NORMAL) {
        rest->doubt = TAUT_FILM_CERTAIN;
    }
    taut_arena_free(arena);
    return status == TAUT_NOT_CONVERGED || status == TAUT_BAD_INPUT ? TAUT_OK : status;
}

static taut_film_stage stage_of(const taut_film_complex *c, const taut_film_rest *rest)
{
    return (taut_film_stage){.sizes = 1, .points = {c->points, 0}, .energy = rest->energy};
}

taut_status taut_film_complex_refine(const taut_film_layout *layout, const taut_film_rest *rest,
                                     const taut_make_options *options, taut_record *details,
                                     taut_error *error)
{
    const int rounds = layout->complex.problem->refine;
    taut_film_stage stages[TAUT_FILM_REFINE_MAX + 1] = {stage_of(&layout->complex, rest)};
    taut_arena *arena = taut_arena_new();
    taut_film_problem *finer = taut_arena_take(arena, (size_t)rounds, sizeof *finer);
    taut_film_layout now = *layout;
    taut_film_rest found = *rest;
    taut_status status = taut_arena_status(arena) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);

    for (int k = 0; status == TAUT_OK && k < rounds; k++) {
        status = find_finer(&now, &found, options, &finer[k], arena, error);
        if (status == TAUT_OK) {
            stages[k + 1] = stage_of(&now.complex, &found);
        }
    }
    if (status == TAUT_OK) {
        taut_film_refinement(stages, rounds + 1, details);
    }
    taut_arena_free(arena);
    return status;
}
