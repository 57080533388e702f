/* plateau.c -- the surface of least area through the known points of a net, or between four curves.
 *
 *     1. a spline space and a boundary in it (construct/plateau/space.h)
 *     2. the surface of least area there (construct/plateau/solve.h)
 *     3. more spaces, to say how far it is from the least area of all, or to come as near as was
 *        asked for (construct/plateau/refine.h)
 *
 * [WuWang2011] sections 6, 7.1 to 7.4; docs/plateau.md.
 */
#include "taut/plateau.h"

#include "construct/common/through.h"
#include "construct/construct_ops.h"
#include "construct/plateau/draft_model.h"
#include "construct/plateau/refine.h"
#include "construct/plateau/solve.h"
#include "construct/plateau/space.h"
#include "construct/plateau/witness.h"
#include "core/fail.h"
#include "core/pace.h"
#include "geometry/nearest.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static taut_status check_start(const taut_plateau_problem *problem, taut_error *error)
{
    const int nv = taut_basis_count(problem->net.v);
    const size_t count = (size_t)taut_basis_count(problem->net.u) * (size_t)nv;

    for (size_t i = 0; problem->start != NULL && i < 3 * count; i++) {
        const size_t at = i / 3;
        char where[64];
        snprintf(where, sizeof where, "/start/points/%zu/%zu", at / (size_t)nv, at % (size_t)nv);
        if (!isfinite(problem->start[i])) {
            return taut_fail_expected(error, TAUT_BAD_INPUT, "value", where, problem->start[i],
                                      "a finite number", "found %.17g", problem->start[i]);
        }
        if (problem->net.known[at] && problem->start[i] != problem->net.points[i]) {
            return taut_fail(error, TAUT_BAD_INPUT, "conflict", where, problem->start[i],
                             problem->net.points[i],
                             "the start has %.17g where the known point of the net has %.17g",
                             problem->start[i], problem->net.points[i]);
        }
    }
    return TAUT_OK;
}

static taut_status check_spaces(const taut_plateau_problem *problem, taut_error *error)
{
    const double tolerance = problem->tolerance_area;
    const int nu = taut_basis_count(problem->net.u), nv = taut_basis_count(problem->net.v);

    if (tolerance != 0 && !(tolerance >= TAUT_PLATEAU_AREA_MIN && tolerance < 1)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/tolerance_area", tolerance,
                         TAUT_PLATEAU_AREA_MIN,
                         "tolerance_area is %.17g, expected a number from %g on and below 1",
                         tolerance, TAUT_PLATEAU_AREA_MIN);
    }
    if (tolerance != 0 && (problem->refine > 0 || problem->start != NULL)) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict", "/tolerance_area", taut_none, taut_none,
                         "tolerance_area finds its own spaces: expected neither refine nor start "
                         "beside it");
    }
    if (tolerance != 0 && (double)nu * nv > TAUT_PLATEAU_ADAPTED_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/tolerance_area", (double)nu * nv,
                         TAUT_PLATEAU_ADAPTED_MAX,
                         "tolerance_area cannot put knots into a net of %d by %d points, expected "
                         "at most %d: take fewer, or refine",
                         nu, nv, TAUT_PLATEAU_ADAPTED_MAX);
    }
    if (problem->gap != 0 && !(problem->gap > TAUT_PLATEAU_GAP_MIN && problem->gap < 1)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/gap", problem->gap, TAUT_PLATEAU_GAP_MIN,
                         "gap is %.17g, expected a number above %g and below 1", problem->gap,
                         TAUT_PLATEAU_GAP_MIN);
    }
    if (problem->gap != 0 && (problem->refine > 0 || tolerance != 0 || problem->start != NULL ||
                              problem->without_least)) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict", "/gap", taut_none, taut_none,
                         "gap finds its own spaces and needs a witness: expected none of refine, "
                         "tolerance_area, start, and not least false");
    }
    if (problem->curves[0] != NULL && problem->start != NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict", "/start", taut_none, taut_none,
                         "found a start beside curves, expected none: its boundary would not be "
                         "theirs");
    }
    return problem->curves[0] == NULL && problem->start != NULL ? check_start(problem, error)
                                                                : TAUT_OK;
}

/* How many points the last net of an estimate has: each time all spans are halved. */
static taut_status check_refine(const taut_plateau_problem *problem, taut_error *error)
{
    const taut_basis *u = problem->net.u, *v = problem->net.v;
    const double more = ldexp(1, problem->refine) - 1;
    const double points = (taut_basis_count(u) + more * taut_basis_span_count(u)) *
                          (taut_basis_count(v) + more * taut_basis_span_count(v));

    if (problem->refine > 0 && points > TAUT_PLATEAU_REFINED_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/refine", points, TAUT_PLATEAU_REFINED_MAX,
                         "refine is %d, and makes a net of %.0f points, expected at most %d",
                         problem->refine, points, TAUT_PLATEAU_REFINED_MAX);
    }
    return TAUT_OK;
}

static taut_status check_through(const taut_plateau_problem *problem, taut_error *error)
{
    const taut_dirichlet_problem *net = &problem->net;

    if (net->through_count > 0 &&
        (problem->refine > 0 || problem->tolerance_area > 0 || problem->gap > 0)) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict", "/through", taut_none, taut_none,
                         "a point holds an area by a spike as wide as its knots, and finer spaces "
                         "end at the surface that passes it by: expected none of refine, "
                         "tolerance_area and gap beside through");
    }
    return taut_through_check(net->u, net->v, net->through, net->through_count, error);
}

/* What dirichlet does not check, or is needed before it does. */
static taut_status check_problem(const taut_plateau_problem *problem, taut_error *error)
{
    const taut_dirichlet_problem *net = &problem->net;
    const int curves = (problem->curves[0] != NULL) + (problem->curves[1] != NULL) +
                       (problem->curves[2] != NULL) + (problem->curves[3] != NULL);

    if (net->u == NULL || net->v == NULL || (curves != 0 && curves != 4) ||
        (curves == 0 && (net->points == NULL || net->known == NULL))) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a problem of least area needs two bases, and a net or four curves");
    }
    if (!(problem->tolerance >= 0) || problem->tolerance >= 1) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/tolerance", problem->tolerance, 1,
                         "tolerance is %.17g, expected a number above 0 and below 1",
                         problem->tolerance);
    }
    if (problem->max_iterations < 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/max_iterations", problem->max_iterations,
                         0, "max_iterations is %d, expected at least 1", problem->max_iterations);
    }
    if (problem->method != TAUT_PLATEAU_FULL && problem->method != TAUT_PLATEAU_NORMAL &&
        problem->method != TAUT_PLATEAU_EITHER) {
        return taut_fail(error, TAUT_BAD_INPUT, "name", "/method", taut_none, taut_none,
                         "expected the method \"full\" or \"normal\"");
    }
    if (problem->refine < 0 || problem->refine > TAUT_PLATEAU_REFINE_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/refine", problem->refine,
                         TAUT_PLATEAU_REFINE_MAX, "refine is %d, expected 0 to %d", problem->refine,
                         TAUT_PLATEAU_REFINE_MAX);
    }
    if (check_refine(problem, error) != TAUT_OK || check_through(problem, error) != TAUT_OK) {
        return TAUT_BAD_INPUT;
    }
    return check_spaces(problem, error);
}

static taut_status make_model(taut_plateau_solution *solution, taut_model **model,
                              taut_error *error)
{
    taut_model *made = NULL;

    if (taut_model_new(&made) != TAUT_OK ||
        taut_model_add_surface(made, solution->surface) != TAUT_OK) {
        taut_model_free(made);
        return taut_fail_memory(error);
    }
    solution->surface = NULL; /* the model's now */
    if (taut_record_status(solution->details) != TAUT_OK) {
        taut_model_free(made);
        return taut_fail_memory(error);
    }
    taut_model_set_details(made, solution->details);
    solution->details = NULL;
    *model = made;
    return TAUT_OK;
}

/* What a make holds on the way. */
typedef struct parts {
    taut_arena *arena;
    taut_through *through; /* the problem's, every one with its parameters; or NULL */
    taut_plateau_space *space;
    taut_plateau_solution solution;
    taut_plateau_witness *witness; /* or NULL */
} parts;

/* The member `least` of details, where the boundary is all that is known. */
static taut_status add_witness(const taut_plateau_problem *problem,
                               const taut_make_options *options, parts *p, taut_error *error)
{
    const int is_fit = problem->net.through_count == 0 &&
                       (problem->curves[0] != NULL || taut_plateau_knows_boundary(&problem->net));

    if (p->witness == NULL && is_fit && !problem->without_least) {
        const taut_status status =
            taut_plateau_witness_new(p->solution.surface, &options->monitor, &p->witness);
        if (status != TAUT_OK) {
            return taut_plateau_witness_fail(status, error);
        }
    }
    if (p->witness != NULL) {
        taut_plateau_witness_describe(p->witness, p->solution.details);
    }
    return TAUT_OK;
}

/* A point that holds the inside of an area is a statement about the space. */
static void add_warning(const taut_dirichlet_problem *net, taut_record *details)
{
    int inside = 0;

    for (int k = 0; k < net->through_count; k++) {
        const taut_through *at = &net->through[k];
        inside += at->u > taut_basis_lo(net->u) && at->u < taut_basis_hi(net->u) &&
                  at->v > taut_basis_lo(net->v) && at->v < taut_basis_hi(net->v);
    }
    if (inside > 0) {
        taut_record_add_text(
            taut_record_add_list(details, "warnings"), NULL,
            "a point inside holds the area by a spike as wide as its knots, which finer nets make "
            "narrower and lower in area: for a mast, give a ring around it, or cables that carry "
            "it (`film`)");
    }
}

static void describe(const parts *p)
{
    const taut_dirichlet_problem *net = &p->space->problem.net;

    taut_plateau_space_describe(p->space, p->solution.details);
    if (net->through_count > 0) {
        taut_through_describe(net->through, net->through_count, p->solution.details);
        add_warning(net, p->solution.details);
    }
}

/* The finer spaces that are asked for, and the witness of the last. */
static taut_status refine_parts(const taut_plateau_problem *problem,
                                const taut_make_options *options, parts *p, taut_error *error)
{
    taut_status status = TAUT_OK;

    if (problem->refine > 0) {
        status = taut_plateau_estimate(problem, options, &p->solution, error);
    } else if (problem->tolerance_area > 0) {
        status = taut_plateau_adapt(problem, options, &p->space, &p->solution, error);
    } else if (problem->gap > 0) {
        status =
            taut_plateau_close_gap(problem, options, &p->space, &p->solution, &p->witness, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    describe(p);
    return add_witness(problem, options, p, error);
}

/* The parameters of points that have none: those of the nearest point of the surface that passes through no point. */
static taut_status find_nearest(const taut_plateau_problem *problem,
                                const taut_make_options *options, parts *p, taut_error *error)
{
    taut_plateau_problem freed = *problem;
    taut_plateau_space *space = NULL;
    taut_plateau_solution solution = {NULL, NULL, 0};

    freed.net.through_count = 0;
    taut_status status = taut_plateau_space_new(&freed, NULL, &space, error);
    if (status == TAUT_OK) {
        status = taut_plateau_solve(&space->problem, options, &solution, error);
    }
    for (int k = 0; k < problem->net.through_count && status == TAUT_OK; k++) {
        taut_through *to = &p->through[k];
        if (isnan(to->u) &&
            taut_surface_nearest(solution.surface, to->point, &to->u, &to->v) != TAUT_OK) {
            status = taut_fail_memory(error);
        }
    }
    taut_plateau_solution_clear(&solution);
    taut_plateau_space_free(space);
    return status;
}

/* p->through. */
static taut_status find_through(const taut_plateau_problem *problem,
                                const taut_make_options *options, parts *p, taut_error *error)
{
    const size_t count = (size_t)problem->net.through_count;
    int missing = 0;

    if (count == 0) {
        return TAUT_OK;
    }
    p->arena = taut_arena_new();
    p->through = taut_arena_copy(p->arena, problem->net.through, count, sizeof *p->through);
    if (p->through == NULL) {
        return taut_fail_memory(error);
    }
    for (size_t k = 0; k < count; k++) {
        missing += isnan(p->through[k].u) != 0; /* not 1 everywhere: MinGW says -1 */
    }
    return missing > 0 ? find_nearest(problem, options, p, error) : TAUT_OK;
}

static taut_status solve_first(const taut_plateau_problem *problem,
                               const taut_make_options *options, parts *p, taut_error *error)
{
    const taut_status status = taut_plateau_space_new(problem, NULL, &p->space, error);
    return status == TAUT_OK ? taut_plateau_solve(&p->space->problem, options, &p->solution, error)
                             : status;
}

static taut_status make_parts(const taut_plateau_problem *given, const taut_make_options *options,
                              parts *p, taut_error *error)
{
    taut_plateau_problem held = *given;
    const taut_plateau_problem *problem = &held;
    taut_error found = {.status = TAUT_OK};
    taut_status status = find_through(given, options, p, error);

    if (status != TAUT_OK) {
        return status;
    }
    held.net.through = p->through;
    if (given->method == TAUT_PLATEAU_EITHER) {
        held.method = TAUT_PLATEAU_FULL;
    }
    status = solve_first(problem, options, p, &found);
    const int again = status == TAUT_NOT_CONVERGED && given->method == TAUT_PLATEAU_EITHER &&
                      (given->max_iterations == 0 || strcmp(found.reason, "folds") == 0);
    if (again) {
        held.method = TAUT_PLATEAU_NORMAL;
        taut_plateau_solution_clear(&p->solution);
        taut_plateau_space_free(p->space);
        p->space = NULL;
        status = solve_first(problem, options, p, &found);
    }
    if (status != TAUT_OK) {
        if (error != NULL) {
            *error = found;
        }
        return status;
    }
    if (again) {
        taut_record_add_text(taut_record_add_list(p->solution.details, "warnings"), NULL,
                             "by the method \"full\" no film is found: it is made by \"normal\"");
    }
    return refine_parts(problem, options, p, error);
}

taut_status taut_plateau_make(const taut_plateau_problem *problem, const taut_make_options *options,
                              taut_model **model, taut_error *error)
{
    static const taut_make_options none;
    parts p = {.arena = NULL};
    taut_pace pace;
    taut_status status = TAUT_OK;

    if (problem == NULL || model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_plateau_make needs a problem and a place for the model");
    }
    status = check_problem(problem, error);
    if (status != TAUT_OK) {
        return status;
    }
    const taut_make_options own = taut_pace_options(&pace, options != NULL ? options : &none);
    status = make_parts(problem, &own, &p, error);
    /* what there is then: the surface of the last space that was done, or the first as far as it came, without a witness */
    if (p.solution.surface != NULL && taut_pace_ends(&pace, status, p.solution.details)) {
        describe(&p);
        status = TAUT_OK;
    }
    status = taut_pace_end(&pace, status, error);
    if (status == TAUT_OK) {
        status = make_model(&p.solution, model, error);
    }
    taut_plateau_witness_free(p.witness);
    taut_plateau_solution_clear(&p.solution);
    taut_plateau_space_free(p.space);
    taut_arena_free(p.arena);
    return status;
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    return taut_plateau_make(data, options, model, error);
}

static taut_status draft(const void *data, const taut_model *before, int steps, taut_model **model,
                         taut_error *error)
{
    const taut_status status = check_problem(data, error);
    return status == TAUT_OK ? taut_plateau_draft(data, before, steps, model, error) : status;
}

const taut_construct_ops taut_construct_plateau = {.make = make, .draft = draft, .ends_early = 1};
