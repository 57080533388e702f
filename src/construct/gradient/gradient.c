/* gradient.c -- from a problem to its derivatives: which construction has some. */
#include "construct/gradient/gradient.h"
#include "core/fail.h"
#include "problem/problem.h"
#include "taut/biharmonic.h"
#include "taut/harmonic.h"

/* ---- harmonic and biharmonic ---- */

static taut_status remake_harmonic(const void *context, const double *points,
                                   const taut_make_options *options, taut_model **model,
                                   taut_error *error)
{
    taut_harmonic_problem problem = *(const taut_harmonic_problem *)context;
    if (problem.given == TAUT_HARMONIC_BOUNDARY) {
        problem.boundary.points = points;
    } else {
        problem.rows.points = points;
        problem.rows.exact = NULL;
    }
    return taut_harmonic_make(&problem, options, model, error);
}

/* Two rows that do not agree are mended where that was asked for, and a fit is near its boundary. */
static taut_gradient_net net_of_harmonic(const taut_harmonic_problem *problem)
{
    taut_gradient_net net = {.u = problem->u, .v = problem->v};
    if (problem->given == TAUT_HARMONIC_BOUNDARY) {
        net.points = problem->boundary.points;
        net.known = problem->boundary.known;
        net.is_near = 1;
    } else {
        net.points = problem->rows.points;
        net.known = problem->rows.known;
        net.is_near = problem->rows.even != TAUT_EVEN_REFUSE;
    }
    return net;
}

static taut_status pull_harmonic(const void *context, const taut_surface *surface,
                                 const taut_gradient_request *request, taut_arena *arena,
                                 double *seed, taut_error *error)
{
    const taut_gradient_net net = net_of_harmonic(context);
    (void)surface;
    return taut_gradient_pull_linear(&net, remake_harmonic, context, &request->monitor, arena, seed,
                                     error);
}

static taut_status derive_harmonic(const void *data, const taut_model *model,
                                   const taut_gradient_request *request, double *gradient,
                                   taut_error *error)
{
    const taut_harmonic_problem *problem = data;
    if (problem->given == TAUT_HARMONIC_DERIVATIVE) {
        return taut_gradient_refuse("an edge and the derivative across it are no net", error);
    }
    const taut_gradient_net net = net_of_harmonic(problem);
    return taut_gradient_run(&net, model, request, pull_harmonic, problem, gradient, error);
}

static taut_status remake_biharmonic(const void *context, const double *points,
                                     const taut_make_options *options, taut_model **model,
                                     taut_error *error)
{
    taut_biharmonic_problem problem = *(const taut_biharmonic_problem *)context;
    problem.rows.points = points;
    return taut_biharmonic_make(&problem, options, model, error);
}

static taut_status pull_biharmonic(const void *context, const taut_surface *surface,
                                   const taut_gradient_request *request, taut_arena *arena,
                                   double *seed, taut_error *error)
{
    const taut_biharmonic_rows *rows = &((const taut_biharmonic_problem *)context)->rows;
    const taut_gradient_net net = {rows->u, rows->v, rows->points, rows->known, 0};
    (void)surface;
    return taut_gradient_pull_linear(&net, remake_biharmonic, context, &request->monitor, arena,
                                     seed, error);
}

static taut_status derive_biharmonic(const void *data, const taut_model *model,
                                     const taut_gradient_request *request, double *gradient,
                                     taut_error *error)
{
    const taut_biharmonic_problem *problem = data;
    if (problem->given != TAUT_BIHARMONIC_ROWS) {
        return taut_gradient_refuse("a neighbour of least bending has no net of its own", error);
    }
    const taut_gradient_net net = {problem->rows.u, problem->rows.v, problem->rows.points,
                                   problem->rows.known, 0};
    return taut_gradient_run(&net, model, request, pull_biharmonic, problem, gradient, error);
}

/* ---- of a problem that was read ---- */

static taut_status derive_dirichlet(const void *data, const taut_model *model,
                                    const taut_gradient_request *request, double *gradient,
                                    taut_error *error)
{
    return taut_dirichlet_gradient(data, model, request, gradient, error);
}

static taut_status derive_plateau(const void *data, const taut_model *model,
                                  const taut_gradient_request *request, double *gradient,
                                  taut_error *error)
{
    return taut_plateau_gradient(data, model, request, gradient, error);
}

/* Those that have derivatives; not a part of construct_ops.h, so that who asks for none links none. */
static taut_status (*const derive[TAUT_CONSTRUCT_COUNT])(const void *data, const taut_model *model,
                                                         const taut_gradient_request *request,
                                                         double *gradient, taut_error *error) = {
    [TAUT_CONSTRUCT_INDEX_biharmonic] = derive_biharmonic,
    [TAUT_CONSTRUCT_INDEX_dirichlet] = derive_dirichlet,
    [TAUT_CONSTRUCT_INDEX_harmonic] = derive_harmonic,
    [TAUT_CONSTRUCT_INDEX_plateau] = derive_plateau,
};

taut_status taut_gradient(const taut_problem *problem, const taut_model *model,
                          const taut_gradient_request *request, double *gradient, taut_error *error)
{
    if (problem == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_gradient needs a problem");
    }
    if (problem->construct == TAUT_CONSTRUCT_INDEX_film) {
        return taut_gradient_refuse("a film is derived by its corners and cables: call "
                                    "taut_gradient_of_film (Python: taut.film_gradient)",
                                    error);
    }
    if (derive[problem->construct] == NULL) {
        return taut_fail(
            error, TAUT_BAD_ARGUMENT, "no-gradient", NULL, taut_none, taut_none,
            "%s has no derivatives yet; dirichlet, plateau, harmonic and biharmonic from rows, "
            "and films of one patch have",
            taut_construct_name(problem->construct));
    }
    return derive[problem->construct](problem->data, model, request, gradient, error);
}
