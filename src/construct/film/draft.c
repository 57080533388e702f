#include "construct/film/draft.h"

#include "construct/plateau/draft.h"
#include "core/fail.h"
#include "problem/film_complex.h"

#include <math.h>
#include <string.h>

int taut_film_has_draft(const taut_film_problem *problem)
{
    int has = !taut_film_is_complex(problem) && problem->image_count == 0 &&
              problem->updates == 0 && problem->start == NULL && problem->refine == 0;

    for (int e = 0; e < 4; e++) {
        const taut_film_edge *edge = &problem->edges[e];
        has = has && problem->corner_kinds[e] != TAUT_FILM_FREE && !taut_film_has_plane(edge) &&
              edge->kind != TAUT_FILM_POLE;
    }
    return has;
}

/* What is held at edge e stands where the problem puts it; a corner that glides goes on from where it was. */
static void leave_out(const taut_film_problem *problem, int e, int nu, int nv, double *start)
{
    size_t first = 0, step = 0;
    int count = 0;

    taut_film_edge_points(nu, nv, e, &first, &step, &count);
    for (int k = 0; k < count; k++) {
        const int is_corner = (k == 0 || k == count - 1) && problem->ring == TAUT_FILM_OPEN;
        const int corner = taut_film_corner_of(e, k > 0);
        double *x = start + 3 * (first + (size_t)k * step);
        if (is_corner ? problem->corner_kinds[corner] == TAUT_FILM_HELD
                      : problem->edges[e].kind == TAUT_FILM_FIXED) {
            x[0] = x[1] = x[2] = NAN;
        }
    }
}

taut_status taut_film_draft_begin(const taut_film_problem *problem, const taut_surface *before,
                                  taut_arena *arena, taut_film_problem *begun)
{
    const int nu = taut_basis_count(problem->u), nv = taut_basis_count(problem->v);
    double *start = taut_arena_copy(arena, taut_surface_points(before), (size_t)nu * (size_t)nv,
                                    3 * sizeof(double));

    if (start == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int e = 0; e < 4; e++) {
        if (taut_film_has_edge(problem, e)) {
            leave_out(problem, e, nu, nv, start);
        }
    }
    *begun = *problem;
    begun->start = start;
    return TAUT_OK;
}

/* Cables draw as they did before. */
static void take_forces(taut_film_work *w, const double forces[4])
{
    const double tension = taut_film_tension(w->space->problem);

    taut_film_start_laws(w, 1);
    for (int e = 0; e < 4; e++) {
        const taut_film_cable *cable = &w->space->cables[e];
        if (cable->stiffness > 0) {
            w->laws[e] = (taut_film_pull){.stiffness = cable->stiffness, .target = cable->target};
        } else if (cable->length > 0 && forces[e] > 0) {
            const double unit = taut_film_force(w->space, e, 1) / w->space->ratios[e];
            w->laws[e].force = forces[e] / (unit > 0 ? unit : tension);
        }
    }
}

/* Held points of an open film, and its corners, stand where they did in the film before: they move with the first step. */
static void take_net(const taut_film_space *space, const taut_surface *before, double *net)
{
    for (size_t i = 0; space->around == NULL && i < space->count; i++) {
        const size_t row = i / (size_t)space->nv, column = i % (size_t)space->nv;
        if (space->known[i] || ((row == 0 || row == (size_t)space->nu - 1) &&
                                (column == 0 || column == (size_t)space->nv - 1))) {
            taut_scaling_apply(&space->scaling, 1, taut_surface_points(before) + 3 * i, NULL,
                               net + 3 * i);
        }
    }
}

taut_status taut_film_draft(const taut_film_space *space, const taut_surface *before,
                            const double forces[4], int steps, taut_arena *arena,
                            taut_film_solution *solution, taut_error *error)
{
    taut_film_work w = {.space = space, .method = "draft", .negative = -1};
    taut_status status = TAUT_OK;

    *solution = (taut_film_solution){.points = NULL};
    w.net = taut_arena_copy(arena, space->start, space->count, 3 * sizeof(double));
    if (w.net == NULL) {
        return taut_fail_memory(error);
    }
    take_net(space, before, w.net);
    take_forces(&w, forces);
    status = taut_film_take_nodes(&w, TAUT_AREA_DRAFT_EXTRA, 1);
    if (status == TAUT_OK) {
        status = taut_area_draft(w.functional, &space->mask, space->start, steps, w.net);
    }
    if (status != TAUT_OK) {
        taut_film_drop_rule(&w);
        return taut_fail_status(error, status);
    }
    status = taut_film_fill_solution(&w, arena, solution, error);
    taut_film_drop_rule(&w);
    return status;
}
