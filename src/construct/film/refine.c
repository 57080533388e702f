/* refine.c -- the same film in finer spaces.
 *
 *     halve all spans of the film and of the reference, and let that be the start
 */
#include "construct/film/refine.h"

#include "construct/film/ring.h"
#include "construct/film/rounds.h"
#include "core/fail.h"
#include "taut/operations.h"

#include <math.h>

enum { ROUNDS = TAUT_FILM_REFINE_MAX + 1 };

static taut_status halve_spans(const taut_surface *surface, taut_surface **halved,
                               taut_error *error)
{
    taut_surface *along_u = NULL;
    taut_status status = taut_surface_refine(surface, TAUT_ALONG_U, &along_u, error);

    if (status == TAUT_OK) {
        status = taut_surface_refine(along_u, TAUT_ALONG_V, halved, error);
    }
    taut_surface_free(along_u);
    return status;
}

/* Edges that are held on curves come nearer to them in a finer space: they are laid anew. */
static void forget_curves(const taut_film_problem *problem, int nu, int nv, double *start)
{
    for (int e = 0; e < 4; e++) {
        size_t first = 0, step = 0;
        int count = 0;
        taut_film_edge_points(nu, nv, e, &first, &step, &count);
        for (int k = 0; problem->edges[e].curve != NULL && k < 3 * count; k++) {
            start[3 * (first + (size_t)(k / 3) * step) + (size_t)(k % 3)] = NAN;
        }
    }
}

/* The film that begins as `halved`; *surface: what it becomes. */
static taut_status solve_halved(const taut_film_problem *problem, const taut_surface *halved,
                                const taut_surface *reference, const taut_make_options *options,
                                taut_surface **surface, double *energy, taut_error *error)
{
    taut_film_problem finer = *problem;
    taut_arena *arena = taut_arena_new();
    taut_film_space space;
    taut_film_solution solution;

    finer.u = taut_surface_u(halved);
    finer.v = taut_surface_v(halved);
    finer.reference = reference;
    const int nu = taut_basis_count(finer.u), nv = taut_basis_count(finer.v);
    double *start = taut_arena_copy(arena, taut_surface_points(halved), (size_t)nu * (size_t)nv,
                                    3 * sizeof(double));
    taut_status status = start != NULL ? TAUT_OK : taut_fail_memory(error);
    if (status == TAUT_OK) {
        forget_curves(problem, nu, nv, start);
        finer.start = start;
        status = taut_film_space_new(&finer, arena, &space, error);
    }
    if (status == TAUT_OK) {
        status = taut_film_solve(&space, options, arena, &solution, error);
    }
    if (status == TAUT_OK) {
        *energy = solution.energy;
        status = taut_surface_new("film", finer.u, finer.v, solution.points, NULL, surface, error);
    }
    taut_arena_free(arena);
    return status;
}

static void take_size(const taut_surface *surface, taut_film_stage *stage)
{
    stage->sizes = 2;
    stage->points[0] = taut_basis_count(taut_surface_u(surface));
    stage->points[1] = taut_basis_count(taut_surface_v(surface));
}

/* One round more: *surface and *reference become finer. */
static taut_status add_round(const taut_film_problem *problem, const taut_make_options *options,
                             taut_surface **surface, taut_surface **reference,
                             taut_film_stage *found, taut_error *error)
{
    taut_surface *halved = NULL, *made = NULL, *other = NULL;
    taut_status status = halve_spans(*surface, &halved, error);

    if (status == TAUT_OK && *reference != NULL) {
        status = halve_spans(*reference, &other, error);
    }
    if (status == TAUT_OK) {
        status = solve_halved(problem, halved, other, options, &made, &found->energy, error);
    }
    if (status == TAUT_OK) {
        taut_surface_free(*surface);
        taut_surface_free(*reference);
        *surface = made;
        *reference = other;
        other = NULL;
        take_size(made, found);
    }
    taut_surface_free(other);
    taut_surface_free(halved);
    return status;
}

taut_status taut_film_refine(const taut_film_problem *problem, const taut_surface *surface,
                             double energy, const taut_make_options *options, taut_record *details,
                             taut_error *error)
{
    taut_film_stage rounds[ROUNDS] = {{.energy = energy}};
    taut_surface *now = NULL, *reference = NULL;
    taut_status status = taut_surface_copy(surface, &now);

    take_size(surface, &rounds[0]);
    if (status == TAUT_OK && problem->reference != NULL) {
        status = taut_surface_copy(problem->reference, &reference);
    }
    if (status != TAUT_OK) {
        taut_surface_free(now);
        return taut_fail_memory(error);
    }
    for (int k = 1; status == TAUT_OK && k <= problem->refine; k++) {
        status = add_round(problem, options, &now, &reference, &rounds[k], error);
    }
    if (status == TAUT_OK) {
        taut_film_refinement(rounds, problem->refine + 1, details);
    }
    taut_surface_free(now);
    taut_surface_free(reference);
    return status;
}
