/* dirichlet.c -- the surface of least Dirichlet energy through the known points of a net.
 *
 *     1. check the data; find the mask of the unknown points
 *     2. move and scale the known points to [-1, 1]^3 (construct/common/scaling.h)
 *     3. Gram matrices of both bases (geometry/nurbs/gram.h), the form made of them (form.h)
 *     4. solve A x = 0 at the unknown points (system.h), for the aspect given or the best
 *     5. with points to pass through, find their parameters and the multipliers that hold the
 *        surface there (through.h)
 *     6. put the solution back between the known points, which stay bit for bit
 *
 * [WuWang2011] section 3; aspect 7.3, weights 7.5, masks 7.6. The system is positive definite as
 * soon as one point is known: D(x) = 0 makes x constant, so it vanishes with that point.
 */
#include "taut/dirichlet.h"

#include "construct/common/mask.h"
#include "construct/common/scaling.h"
#include "construct/construct_ops.h"
#include "construct/dirichlet/system.h"
#include "construct/dirichlet/through.h"
#include "core/arena.h"
#include "core/fail.h"
#include "geometry/nearest.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* What was decided on the way. */
typedef struct outcome {
    double aspect;
    double energy; /* D_aspect, in the user's units; NaN where no aspect was asked for */
    const char *method;
    int iterations;
} outcome;

/* The basis serves surfaces of this kind. */
static taut_status check_basis(const taut_basis *basis, const char *where, taut_error *error)
{
    if (strcmp(taut_basis_type(basis), "ce-bezier") == 0) {
        return taut_fail_expected(error, TAUT_BAD_INPUT, "basis", where, taut_none,
                                  "any other type", "a basis of type \"ce-bezier\" is for curves");
    }
    return TAUT_OK;
}

static taut_status refuse_number(const char *member, size_t index, int nv, double found,
                                 const char *expected, taut_error *error)
{
    char where[64];
    snprintf(where, sizeof where, "/%s/%zu/%zu", member, index / (size_t)nv, index % (size_t)nv);
    return taut_fail_expected(error, TAUT_BAD_INPUT, "value", where, found, expected, "found %.17g",
                              found);
}

static taut_status check_numbers(const taut_dirichlet_problem *problem, taut_error *error)
{
    const int nv = taut_basis_count(problem->v);
    const size_t count = (size_t)taut_basis_count(problem->u) * (size_t)nv;
    size_t known = 0;

    for (size_t i = 0; i < count; i++) {
        const double *p = problem->points + 3 * i;
        for (int c = 0; problem->known[i] && c < 3; c++) {
            if (!isfinite(p[c])) {
                return refuse_number("points", i, nv, p[c], "a finite number", error);
            }
        }
        known += problem->known[i] != 0;
        if (problem->weights != NULL &&
            !(problem->weights[i] > 0 && isfinite(problem->weights[i]))) {
            return refuse_number("weights", i, nv, problem->weights[i], "a positive number", error);
        }
    }
    if (known == 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "nothing-known", "/points", 0, 1,
                         "no point of the net is known, so every surface that is a single point "
                         "has the least energy: give at least one point");
    }
    return TAUT_OK;
}

static taut_status check_problem(const taut_dirichlet_problem *problem, taut_error *error)
{
    taut_status status = TAUT_OK;
    if (problem == NULL || problem->u == NULL || problem->v == NULL || problem->points == NULL ||
        problem->known == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a dirichlet problem needs two bases, points and which of them are known");
    }
    if (problem->aspect < 0 || !isfinite(problem->aspect)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/aspect", problem->aspect, 0,
                         "aspect is %.17g, expected a positive number or \"auto\"",
                         problem->aspect);
    }
    const double count =
        (double)taut_basis_count(problem->u) * (double)taut_basis_count(problem->v);
    if (count > TAUT_POINTS_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/points", count, TAUT_POINTS_MAX,
                         "%.0f control points, expected at most %d", count, TAUT_POINTS_MAX);
    }
    status = check_basis(problem->u, "/u", error);
    if (status != TAUT_OK) {
        return status;
    }
    status = check_basis(problem->v, "/v", error);
    if (status != TAUT_OK) {
        return status;
    }
    if (problem->weights != NULL &&
        !(taut_basis_allows_weights(problem->u) && taut_basis_allows_weights(problem->v))) {
        return taut_fail(
            error, TAUT_BAD_INPUT, "conflict", "/weights", taut_none, taut_none,
            "a basis of type \"%s\" carries no weights",
            taut_basis_type(taut_basis_allows_weights(problem->u) ? problem->v : problem->u));
    }
    if (problem->through_count > 0 && problem->aspect_auto) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict", "/through", taut_none, taut_none,
                         "points to pass through want an aspect that is given, not \"auto\"");
    }
    status =
        taut_through_check(problem->u, problem->v, problem->through, problem->through_count, error);
    return status == TAUT_OK ? check_numbers(problem, error) : status;
}

static int has_aspect(const taut_dirichlet_problem *problem)
{
    return problem->aspect > 0 || problem->aspect_auto;
}

/* Solves the scaled net in place. */
static taut_status solve_net(const taut_dirichlet_problem *problem, taut_dirichlet_system *system,
                             double *net, outcome *out, taut_error *error)
{
    taut_status status = TAUT_OK;

    out->aspect = problem->aspect > 0 ? problem->aspect : 1;
    status = problem->aspect_auto ? taut_dirichlet_system_aspect(system, net, &out->aspect, error)
                                  : taut_dirichlet_system_solve(system, out->aspect, net, error);
    if (status != TAUT_OK) {
        return status;
    }
    out->method = taut_dirichlet_system_method(system);
    out->iterations = taut_dirichlet_system_iterations(system);
    return TAUT_OK;
}

/* What a make holds on the way. */
typedef struct work {
    taut_arena *arena;
    taut_mask mask;
    taut_dirichlet_form form;
    taut_dirichlet_system *system;
    double *net;           /* [nu][nv][3]: the finished control points in the end */
    taut_through *through; /* the problem's, every one with its parameters */
    outcome out;
} work;

/* The scaling of known points and points to pass through together. */
static taut_status find_scaling(const taut_dirichlet_problem *problem, work *w,
                                taut_scaling *scaling)
{
    const size_t count = (size_t)w->mask.nu * (size_t)w->mask.nv;
    const size_t all = count + (size_t)problem->through_count;

    if (problem->through_count == 0) {
        *scaling = taut_scaling_of(count, problem->points, problem->known);
        return TAUT_OK;
    }
    double *points = taut_arena_take(w->arena, 3 * all, sizeof(double));
    unsigned char *known = taut_arena_take(w->arena, all, 1);
    if (points == NULL || known == NULL) {
        return TAUT_NO_MEMORY;
    }
    memcpy(points, problem->points, 3 * count * sizeof(double));
    memcpy(known, problem->known, count);
    for (int k = 0; k < problem->through_count; k++) {
        memcpy(points + 3 * (count + (size_t)k), problem->through[k].point, 3 * sizeof(double));
        known[count + (size_t)k] = 1;
    }
    *scaling = taut_scaling_of(all, points, known);
    return TAUT_OK;
}

/* w->through: in the units of the scaled net, its missing parameters those of the nearest point. */
static taut_status find_parameters(const taut_dirichlet_problem *problem,
                                   const taut_scaling *scaling, work *w, taut_error *error)
{
    const size_t count = (size_t)problem->through_count;
    taut_surface *surface = NULL; /* made where parameters are missing */
    taut_status status = TAUT_OK;

    w->through = taut_arena_take(w->arena, count, sizeof *w->through);
    if (w->through == NULL) {
        return taut_fail_memory(error);
    }
    for (size_t k = 0; status == TAUT_OK && k < count; k++) {
        taut_through *to = &w->through[k];
        *to = problem->through[k];
        taut_scaling_apply(scaling, 1, problem->through[k].point, NULL, to->point);
        if (isnan(to->u) && surface == NULL) {
            status = taut_surface_new("free", problem->u, problem->v, w->net, problem->weights,
                                      &surface, error);
        }
        if (isnan(to->u) && status == TAUT_OK &&
            taut_surface_nearest(surface, to->point, &to->u, &to->v) != TAUT_OK) {
            status = taut_fail_memory(error);
        }
    }
    taut_surface_free(surface);
    return status;
}

/* The scaled net passes through the points. */
static taut_status pass_through(const taut_dirichlet_problem *problem, const taut_scaling *scaling,
                                work *w, taut_error *error)
{
    taut_conditions conditions;

    if (problem->through_count == 0) {
        return TAUT_OK;
    }
    taut_status status = find_parameters(problem, scaling, w, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (taut_conditions_new(problem->u, problem->v, problem->weights, w->through,
                            problem->through_count, w->arena, &conditions) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return taut_dirichlet_through_solve(w->system, w->out.aspect, &w->mask, &conditions, w->arena,
                                        w->net, error);
}

/* D_aspect of the scaled net, where an aspect was asked for. */
static double energy_of(const taut_dirichlet_problem *problem, const work *w)
{
    double halves[2] = {0, 0};

    if (!has_aspect(problem)) {
        return taut_none;
    }
    taut_dirichlet_system_energies(w->system, w->net, halves);
    return w->out.aspect * halves[0] + halves[1] / w->out.aspect;
}

/* Every point is known: the net is the problem's, and points to pass through are only looked at. */
static taut_status fill_known(const taut_dirichlet_problem *problem, work *w, taut_error *error)
{
    const size_t count = (size_t)w->mask.nu * (size_t)w->mask.nv;
    taut_scaling scaling;

    memcpy(w->net, problem->points, 3 * count * sizeof(double));
    w->out.aspect = problem->aspect > 0 ? problem->aspect : 1;
    if (problem->through_count == 0) {
        return TAUT_OK;
    }
    if (find_scaling(problem, w, &scaling) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_scaling_apply(&scaling, count, problem->points, problem->known, w->net);
    const taut_status status = pass_through(problem, &scaling, w, error);
    memcpy(w->net, problem->points, 3 * count * sizeof(double));
    return status;
}

/* Fills the net with the finished control points. */
static taut_status fill_net(const taut_dirichlet_problem *problem, const taut_make_options *options,
                            work *w, taut_error *error)
{
    const size_t count = (size_t)w->mask.nu * (size_t)w->mask.nv;
    taut_scaling scaling;
    taut_status status = TAUT_OK;

    if (w->mask.unknowns == 0) {
        return fill_known(problem, w, error);
    }
    status = taut_dirichlet_form_new(problem->u, problem->v, problem->weights, &w->form, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_dirichlet_system_new(&w->form, &w->mask, &options->monitor, options->threads,
                                       &w->system, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (find_scaling(problem, w, &scaling) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_scaling_apply(&scaling, count, problem->points, problem->known, w->net);
    status = solve_net(problem, w->system, w->net, &w->out, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = pass_through(problem, &scaling, w, error);
    if (status != TAUT_OK) {
        return status;
    }
    w->out.energy = taut_scaling_undo_square(&scaling, energy_of(problem, w));
    return taut_scaling_undo(&scaling, count, problem->points, problem->known, w->net, w->net,
                             error);
}

static taut_record *details_of(const taut_dirichlet_problem *problem, const work *w)
{
    const taut_mask *mask = &w->mask;
    const outcome *out = &w->out;
    taut_record *details = taut_record_new();
    taut_record_add_number(details, "unknowns", (double)mask->unknowns);
    taut_record_add_text(details, "known",
                         mask->unknowns == 0 ? "all"
                         : mask->is_interior ? "boundary"
                                             : "pattern");
    taut_record_add_text(details, "method", out->method);
    taut_record_add_number(details, "iterations", out->iterations);
    if (has_aspect(problem)) {
        taut_record_add_number(details, "aspect", out->aspect);
        taut_record_add_number(details, "aspect_energy", out->energy);
    }
    if (problem->through_count > 0) {
        taut_through_describe(w->through, problem->through_count, details);
    }
    return details;
}

/* The model of the finished net. */
static taut_status make_model(const taut_dirichlet_problem *problem, const work *w,
                              taut_model **model, taut_error *error)
{
    const char *name = problem->name != NULL ? problem->name : "dirichlet";
    taut_surface *surface = NULL;
    taut_model *made = NULL;
    taut_record *details = NULL;
    taut_status status =
        taut_surface_new(name, problem->u, problem->v, w->net, problem->weights, &surface, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (taut_model_new(&made) != TAUT_OK || taut_model_add_surface(made, surface) != TAUT_OK) {
        taut_surface_free(surface);
        taut_model_free(made);
        return taut_fail_memory(error);
    }
    details = details_of(problem, w);
    status = taut_record_status(details);
    taut_model_set_details(made, details);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return taut_fail_memory(error);
    }
    *model = made;
    return TAUT_OK;
}

static taut_status find_model(const taut_dirichlet_problem *problem,
                              const taut_make_options *options, work *w, taut_model **model,
                              taut_error *error)
{
    const int nu = taut_basis_count(problem->u), nv = taut_basis_count(problem->v);
    taut_status status = TAUT_OK;

    w->net = taut_arena_take(w->arena, (size_t)nu * (size_t)nv, 3 * sizeof(double));
    if (w->net == NULL || taut_mask_new(nu, nv, problem->known, w->arena, &w->mask) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = fill_net(problem, options, w, error);
    return status == TAUT_OK ? make_model(problem, w, model, error) : status;
}

taut_status taut_dirichlet_make(const taut_dirichlet_problem *problem,
                                const taut_make_options *options, taut_model **model,
                                taut_error *error)
{
    static const taut_make_options none;
    const taut_make_options *chosen = options != NULL ? options : &none;
    work w = {.out = {1, taut_none, "none", 0}};
    taut_status status = check_problem(problem, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_dirichlet_make needs a place for the model");
    }
    w.arena = taut_arena_new();
    status = find_model(problem, chosen, &w, model, error);
    taut_dirichlet_system_free(w.system);
    taut_dirichlet_form_clear(&w.form);
    taut_arena_free(w.arena);
    return status;
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    return taut_dirichlet_make(data, options, model, error);
}

const taut_construct_ops taut_construct_dirichlet = {.make = make};
