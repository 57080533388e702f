/* solve.c -- from the start to the film that is asked for.
 *
 *     net = the start, brought to rest (equilibrium.h)
 *     failed, and it is a ring: led apart from nearer edges (apart.h)
 *     failed, and there are cables: lowered from larger forces (stronger.h)
 *     so often as is asked: the film becomes the reference of its prestress
 *     symmetric data: the film becomes symmetric (symmetry.h)
 */
#include "construct/film/solve.h"

#include "construct/film/apart.h"
#include "construct/film/coarse.h"
#include "construct/film/freedom.h"
#include "construct/film/ring.h"
#include "construct/film/stronger.h"
#include "construct/film/symmetry.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ITERATIONS_DEFAULT = 200, PATIENCE = 40, SEEKS = 40, SEEKS_NEAR = 8 };

static const double tolerance_default = 1e-10;
static const double tolerance_search = 1e-8; /* farther from rest no two rules agree */
static const double gain_enough =
    3e-10; /* of all coordinates: points that slide along themselves creep */
static const double residual_enough = 1e3,       /* of the tolerance: all coordinates there */
    residual_least = 3e-9, residual_most = 1e-7; /* its bounds: the certificate allows 1e-6 */
static const double moved_near = 0.1;            /* 0.05 of the size: a start that lies at a film */
static const double area_none = 1e-12;           /* of the size squared */
static const double theta_least = 1e-6;          /* of the metric operator in every step */
static const double work_most = 2e11;            /* flops of all films on the way: minutes */

/* Are there cables that a stronger film is known of: forces, or laws between ends that are held? */
static int has_strength(const taut_film_space *space)
{
    int cables = 0, others = 0;
    for (int e = 0; e < 4; e++) {
        cables += space->ratios[e] > 0;
        others += space->cables[e].start > 0;
    }
    return cables > 0 && (others == 0 || (space->leader == NULL && space->around == NULL));
}

static taut_status refuse_unstable(const taut_film_work *w, const taut_film_rest_point *at,
                                   taut_error *error)
{
    const int unit = w->space->scaling.outer + w->space->scaling.inner;
    const double value = taut_film_tension(w->space->problem) * ldexp(at->eigenvalue, -2 * unit);
    char waves[64] = "";

    if (at->waves >= 0) {
        snprintf(waves, sizeof waves, ", of a move with %d waves around", at->waves);
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "unstable",
                     w->space->has_inside ? "/start" : "/edges", value, 0,
                     "the film is at rest there and no minimum: the lowest eigenvalue of its "
                     "second variation is about %.6g%s; begin elsewhere, or \"accept\" what is "
                     "\"stationary\"",
                     value, waves);
}

/* A start that lies at a film: *done where that is what is asked for. One that is no minimum is refused unless it may be. */
static taut_status try_start(taut_film_work *w, int *done, taut_error *error)
{
    const size_t bytes = 3 * w->space->count * sizeof(double);
    const int any = w->space->problem->accepts_stationary;
    taut_error inner = {.status = TAUT_OK};
    taut_film_rest_point at;

    inner.status = taut_film_rest_any(w, any ? SEEKS : SEEKS_NEAR, &at, &inner);
    if (inner.status != TAUT_OK && inner.status != TAUT_NOT_CONVERGED) {
        return taut_film_pass_on(&inner, error);
    }
    *done = inner.status == TAUT_OK && any;
    w->negative = at.negative;
    if (inner.status == TAUT_OK && !any && at.moved <= moved_near && at.negative > 0) {
        return refuse_unstable(w, &at, error);
    }
    if (!*done) {
        memcpy(w->net, w->space->start, bytes);
    }
    return TAUT_OK;
}

/* No film is a minimum that gives way, nor is one whose springs push. */
static taut_status check_stable(taut_film_work *w, taut_error *error)
{
    taut_film_rest_point at;

    for (int k = 0; k < w->functional->cable_count; k++) {
        const taut_area_cable *cable = &w->cables[k];
        const double length = taut_area_cable_length(cable, w->net);
        if (cable->stiffness > 0 && cable->base == 0 && length < cable->target) {
            return taut_film_refuse_slack(w->space, w->edges[k], length, error);
        }
    }
    if (w->is_definite) {
        w->negative = 0;
        return TAUT_OK;
    }
    const taut_status judged = taut_film_judge(w, &at);
    if (judged != TAUT_OK) {
        return taut_fail_status(error, judged);
    }
    w->negative = at.negative;
    return at.negative > 0 && !w->space->problem->accepts_stationary
               ? refuse_unstable(w, &at, error)
               : TAUT_OK;
}

static taut_status find_net(taut_film_work *w, taut_arena *arena, taut_error *error)
{
    int done = 0;

    taut_film_start_laws(w, 1);
    taut_status status = taut_film_take_rule(w, 0, 1);

    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_area_density *const density = w->functional->density;
    w->functional->cable_count = 0; /* the area alone */
    w->functional->density = NULL;
    const double area = taut_area_functional_value(w->functional, w->net).area;
    w->functional->density = density;
    if (!(area > area_none)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-area", "/corners", area, area_none,
                         "the edges span no area: give corners that are not on one line");
    }
    if (w->space->has_inside || w->space->problem->accepts_stationary) {
        status = try_start(w, &done, error);
    }
    if (status != TAUT_OK || done) {
        return status;
    }
    const taut_status begun = taut_film_begin_coarse(w, 1);
    if (begun != TAUT_OK) {
        return taut_fail_status(error, begun);
    }
    taut_error inner = {.status = TAUT_OK};
    inner.status = taut_film_rest(w, 1, &inner);
    if (inner.status == TAUT_NOT_CONVERGED && w->space->around != NULL &&
        !taut_film_has_density(w->space->problem) &&
        w->region.iterations < w->region.max_iterations) {
        return taut_film_lead_apart(w, arena, error);
    }
    if (inner.status == TAUT_NOT_CONVERGED && has_strength(w->space) &&
        w->region.iterations < w->region.max_iterations) {
        return taut_film_lower_forces(w, arena, error);
    }
    return inner.status == TAUT_OK ? TAUT_OK : taut_film_pass_on(&inner, error);
}

/* From functions that go around to the clamped ones, line by line. */
static void clamp_points(const taut_film_space *space, double *points)
{
    const int along_u = space->problem->ring == TAUT_FILM_RING_U;
    const size_t nv = (size_t)space->nv;

    for (int k = 0; space->around != NULL && k < (along_u ? space->nv : space->nu); k++) {
        taut_loop_clamp(space->around, along_u ? nv : 1,
                        points + 3 * (along_u ? (size_t)k : (size_t)k * nv));
    }
}

/* Points that are kept somewhere are brought there, copies follow, and the net is clamped. */
static taut_status settle_points(const taut_film_space *space, double *points, taut_error *error)
{
    for (int i = 0; i < space->nu; i++) {
        for (int j = 0; j < space->nv; j++) {
            const size_t at = (size_t)i * (size_t)space->nv + (size_t)j;
            taut_film_place place;
            const taut_status status = taut_film_place_of(space, i, j, &place, error);
            if (status != TAUT_OK) {
                return status;
            }
            if (!space->known[at]) {
                taut_film_place_onto(&place, points + 3 * at);
            }
        }
    }
    taut_mask_follow(&space->mask, points);
    clamp_points(space, points);
    return TAUT_OK;
}

/* The film becomes the reference, and is found once more: how far it moves, over the size. */
static taut_status update_reference(taut_film_work *w, double *before, double *change,
                                    taut_arena *arena, taut_error *error)
{
    const taut_film_problem *problem = w->space->problem;
    taut_surface *made = NULL;

    memcpy(before, w->net, 3 * w->space->count * sizeof(double));
    double *points = taut_arena_copy(arena, w->net, w->space->count, 3 * sizeof(double));
    if (points == NULL) {
        return taut_fail_memory(error);
    }
    clamp_points(w->space, points);
    taut_status status =
        taut_surface_new("reference", problem->u, problem->v, points, NULL, &made, error);
    if (status != TAUT_OK) {
        return status;
    }
    taut_surface_free(w->reference);
    w->reference = made;
    status = find_net(w, arena, error);
    *change = 0;
    for (size_t i = 0; i < w->space->count; i++) {
        *change = fmax(*change, taut_distance(w->net + 3 * i, before + 3 * i));
    }
    *change /= 2; /* the boundary lies in [-1, 1] */
    return status;
}

static taut_status update(taut_film_work *w, taut_arena *arena, taut_film_solution *solution,
                          taut_error *error)
{
    const int updates = w->space->problem->updates;
    double *before = taut_arena_take(arena, w->space->count, 3 * sizeof(double));
    taut_status status = TAUT_OK;

    solution->changes = taut_arena_take(arena, (size_t)updates + 1, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int k = 0; status == TAUT_OK && k < updates; k++) {
        status = update_reference(w, before, &solution->changes[k], arena, error);
    }
    return status;
}

/* Of the film by its tension or its threads, and of cables by their laws. Their lengths and forces have been found. */
static double find_energy(taut_film_work *w, const taut_film_solution *solution)
{
    const taut_film_problem *problem = w->space->problem;
    const int cables = w->functional->cable_count;
    double energy = 0;

    w->functional->cable_count = 0;
    energy = taut_film_tension(problem) *
             taut_scaling_undo_square(&w->space->scaling,
                                      taut_area_functional_value(w->functional, w->net).area);
    w->functional->cable_count = cables;
    for (int e = 0; e < 4; e++) {
        const taut_film_edge *edge = &problem->edges[e];
        const double longer = solution->lengths[e] - edge->unstressed;
        if (edge->kind == TAUT_FILM_CABLE && edge->law == TAUT_FILM_FORCE) {
            energy += edge->force * solution->lengths[e];
        } else if (edge->kind == TAUT_FILM_CABLE && edge->law == TAUT_FILM_ELASTIC && longer > 0) {
            energy += edge->stiffness * longer * longer / (2 * edge->unstressed);
        }
    }
    return energy;
}

taut_status taut_film_fill_solution(taut_film_work *w, taut_arena *arena,
                                    taut_film_solution *solution, taut_error *error)
{
    const taut_film_space *space = w->space;
    const int unit = space->scaling.outer + space->scaling.inner;

    solution->points = taut_arena_take(arena, space->count, 3 * sizeof(double));
    if (solution->points == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < w->functional->cable_count; k++) {
        const int e = w->edges[k];
        solution->lengths[e] = ldexp(taut_area_cable_length(&w->cables[k], w->net), unit);
        solution->forces[e] = taut_film_force(space, e, w->cables[k].tension / space->ratios[e]);
    }
    solution->iterations = w->iterations;
    solution->residual = w->region.residual;
    solution->method = w->method;
    solution->by_moves = space->problem->method == TAUT_FILM_NORMAL;
    solution->negative = w->negative;
    solution->energy = find_energy(w, solution);
    w->functional->cable_count = 0;
    w->functional->density = NULL;
    solution->area = taut_scaling_undo_square(
        &space->scaling, taut_area_functional_value(w->functional, w->net).area);
    taut_status status = taut_scaling_undo(&space->scaling, space->count, space->points,
                                           space->known, w->net, solution->points, error);
    if (status == TAUT_OK && space->leader != NULL) {
        status = settle_points(space, solution->points, error);
    }
    if (status == TAUT_OK && space->around != NULL &&
        taut_film_ring_discs(space, solution->points, &solution->rival) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return status;
}

/* May it be that all coordinates fold the net, or come to no rest, of a film that there is? */
static int may_be_askew(const taut_film_work *w, const taut_error *found)
{
    const taut_film_problem *problem = w->space->problem;

    return problem->method == TAUT_FILM_FULL && !taut_film_has_density(problem) &&
           !problem->accepts_stationary && w->region.iterations < w->region.max_iterations &&
           (found->status == TAUT_NOT_CONVERGED || strcmp(found->reason, "cable-too-weak") == 0 ||
            (w->space->around != NULL && (strcmp(found->reason, "collapses") == 0 ||
                                          strcmp(found->reason, "slides-away") == 0)));
}

static taut_status begin_anew(taut_film_work *w, taut_error *error)
{
    taut_film_start_laws(w, 1);
    return taut_film_rest(w, 1, error);
}

/* The film by all coordinates, and where these lead to none by the method `normal`: *plain and *normal are room for that. */
static taut_status find_film(taut_film_work *w, taut_film_space *plain, taut_film_problem *normal,
                             taut_arena *arena, taut_error *error)
{
    taut_error first = {.status = TAUT_OK}, second = {.status = TAUT_OK};

    first.status = find_net(w, arena, &first);
    if (first.status == TAUT_OK) {
        return TAUT_OK;
    }
    if (may_be_askew(w, &first)) {
        const taut_film_space *whole = w->space;
        *normal = *whole->problem;
        normal->method = TAUT_FILM_NORMAL;
        *plain = *whole;
        plain->problem = normal;
        w->space = plain;
        memcpy(w->net, whole->start, 3 * whole->count * sizeof(double));
        taut_film_memory_clear(&w->memory);
        const int weak = strcmp(first.reason, "cable-too-weak") == 0;
        second.status = weak || first.status == TAUT_NOT_CONVERGED ? find_net(w, arena, &second)
                                                                   : begin_anew(w, &second);
        if (second.status == TAUT_OK || second.status == TAUT_NO_MEMORY ||
            second.status == TAUT_INTERRUPTED) {
            return second.status == TAUT_OK ? TAUT_OK : taut_film_pass_on(&second, error);
        }
        w->space = whole;
        const int nearer = weak && strcmp(second.reason, "cable-too-weak") == 0 &&
                           fabs(second.limit - second.found) < fabs(first.limit - first.found);
        if (nearer || (first.status == TAUT_NOT_CONVERGED && second.status == TAUT_NO_SOLUTION)) {
            return taut_film_pass_on(&second, error); /* why there is none */
        }
    }
    return taut_film_pass_on(&first, error);
}

taut_status taut_film_solve(const taut_film_space *space, const taut_make_options *options,
                            taut_arena *arena, taut_film_solution *solution, taut_error *error)
{
    const taut_film_problem *problem = space->problem;
    taut_film_work w = {.space = space,
                        .monitor = &options->monitor,
                        .threads = options->threads,
                        .method = "none"};
    taut_film_space plain;
    taut_film_problem normal;
    taut_status status = TAUT_OK;

    *solution = (taut_film_solution){.points = NULL};
    w.region.tolerance =
        problem->tolerance > 0 ? fmin(problem->tolerance, tolerance_search) : tolerance_default;
    w.region.max_iterations =
        problem->max_iterations > 0 ? problem->max_iterations : ITERATIONS_DEFAULT;
    w.region.work_max = work_most;
    w.region.theta_least = theta_least;
    if (space->leader != NULL) {
        w.region.gain_enough = gain_enough;
        w.region.patience = PATIENCE;
    } else {
        w.region.gain_enough = w.region.tolerance;
        w.region.residual_enough =
            fmin(residual_most, fmax(residual_least, residual_enough * w.region.tolerance));
        w.region.theta_enough = theta_least;
    }
    w.net = taut_arena_copy(arena, space->start, space->count, 3 * sizeof(double));
    if (w.net == NULL) {
        return taut_fail_memory(error);
    }
    status = taut_dirichlet_form_new(problem->u, problem->v, NULL, &w.form, error);
    if (status == TAUT_OK) {
        status = find_film(&w, &plain, &normal, arena, error);
    }
    if (status == TAUT_OK && problem->updates > 0) {
        status = update(&w, arena, solution, error);
    }
    if (status == TAUT_OK) {
        status = taut_film_make_symmetric(&w, arena, error);
    }
    if (status == TAUT_OK) {
        status = taut_film_report(&w, error);
    }
    if (status == TAUT_OK) {
        status = check_stable(&w, error);
    }
    if (status == TAUT_OK) {
        status = taut_film_fill_solution(&w, arena, solution, error);
    }
    if (status == TAUT_OK && taut_pulse_is_stopped(&w.pulse)) {
        status = taut_fail_status(error, TAUT_INTERRUPTED);
    }
    taut_dirichlet_form_clear(&w.form);
    taut_surface_free(w.reference);
    taut_film_memory_clear(&w.memory);
    taut_film_drop_rule(&w);
    return status;
}
