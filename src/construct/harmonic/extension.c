/* extension.c -- construct `harmonic-extension`: the harmonic neighbour across an edge.
 *
 * Contact c1: equal derivatives leave one harmonic surface, and it is the polynomial itself carried
 * on
 * ([NiWang2015] section 2.6), so its net is a de Casteljau extrapolation, as is that of the merged
 * surface. Contact g1: equal tangent planes leave three numbers free; the edge and the derivative
 * across it are completed (section 8.6).
 */
#include "construct/construct_ops.h"
#include "construct/harmonic/complete.h"
#include "construct/harmonic/frame.h"
#include "construct/harmonic/lidstone.h"
#include "construct/harmonic/neighbour.h"
#include "core/arena.h"
#include "core/exact.h"
#include "core/fail.h"
#include "taut/harmonic.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A given surface counts as harmonic up to this scaled residual. */
static const double harmonic_limit = 1e-10;

/* The derivative across the neighbour's first edge, in its own normalised parameter:
 *     h (c P_u + (alpha + beta v) P_v),  P_u and P_v by parameter length on the shared edge. */
static void g1_derivative(const taut_neighbour *e, const taut_harmonic_extension_problem *p,
                          double *cross)
{
    const int n = e->n, m = e->m;
    const double *edge = e->net + 3 * n * (m + 1), *before = edge - 3 * (m + 1);
    const double width = e->ratio * e->across;

    for (int j = 0; j <= m; j++) {
        for (int c = 0; c < 3; c++) {
            /* (alpha + beta v) P_v: P_v has degree m-1 and points d_i; alpha P_v is raised to m,
             * beta v P_v is sum_i (i/m) d_{i-1} */
            const double lower = j > 0 ? m * (edge[3 * j + c] - edge[3 * (j - 1) + c]) : 0;
            const double upper = j < m ? m * (edge[3 * (j + 1) + c] - edge[3 * j + c]) : 0;
            const double s = (double)j / m;
            const double along = p->alpha * (s * lower + (1 - s) * upper) + p->beta * s * lower;
            const double across = n * (edge[3 * j + c] - before[3 * j + c]) / e->across;
            cross[3 * j + c] = width * (p->c * across + along / e->along);
        }
    }
}

static taut_status complete_g1(const taut_neighbour *e,
                               const taut_harmonic_extension_problem *problem, double *out,
                               double *amplification, taut_error *error)
{
    const int n = e->n, m = e->m;
    const taut_wide ratio = (taut_wide)e->ratio * e->across / e->along;
    const double limit = fmax(1e-10, 4 * ldexp(DBL_EPSILON, m) * taut_frame_reach(&e->frame));
    double *cross = taut_arena_take(e->arena, 3 * (size_t)(m + 1), sizeof(double));
    taut_wide *scratch =
        taut_arena_take(e->arena, 4 * (size_t)(n + 1) * (size_t)(m + 1), sizeof *scratch);
    double top[3];

    if (cross == NULL || scratch == NULL) {
        return taut_fail_memory(error);
    }
    if (n < m) {
        return taut_fail(
            error, TAUT_NO_SOLUTION, "no-solution", "/surface", n, m,
            "a neighbour with the same tangent planes needs degree %d across the edge, "
            "found %d",
            m, n);
    }
    g1_derivative(e, problem, cross);
    taut_top_difference(m, cross, top);
    const double defect = fmax(fabs(top[0]), fmax(fabs(top[1]), fabs(top[2])));
    if (m % 2 == 0 && n == m && defect > limit) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/beta", defect * e->frame.size,
                         limit * e->frame.size,
                         "inconsistent derivative: the degree %d is even, so \"beta\" must be 0 "
                         "here (the top difference is %.6g)",
                         m, defect * e->frame.size);
    }
    taut_harmonic_from_derivative(n, m, ratio * ratio, e->net + 3 * n * (m + 1), 1, cross, scratch,
                                  out);
    *amplification = taut_harmonic_derivative_amplification(n, m, ratio * ratio, scratch);
    return TAUT_OK;
}

static taut_status check_problem(const taut_harmonic_extension_problem *problem, taut_error *error)
{
    const taut_surface *surface = problem != NULL ? problem->surface : NULL;
    taut_status status = TAUT_OK;

    if (surface == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "an extension needs a surface");
    }
    status = taut_neighbour_check(surface, problem->width, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (problem->neighbour != NULL && (problem->width > 0 || problem->contact != TAUT_CONTACT_C1)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/neighbour", taut_none, taut_none,
                         "found \"neighbour\" beside \"width\" or contact \"g1\": it has a width, "
                         "and must be the surface carried on");
    }
    if (problem->contact == TAUT_CONTACT_G1 &&
        !(problem->c > 0 && isfinite(problem->c) && isfinite(problem->alpha) &&
          isfinite(problem->beta))) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/c", problem->c, 0,
                         "bad parameter: c is %.17g, expected a positive number", problem->c);
    }
    return TAUT_OK;
}

/* Rational arithmetic carries on what is given to the last digit: an error of rounding there would
 * stand in both other surfaces. */
static taut_status check_exact(const taut_surface *surface, taut_error *error)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double rectangle[4] = {taut_basis_lo(u), taut_basis_hi(u), taut_basis_lo(v),
                                 taut_basis_hi(v)};
    const taut_exact_numbers net = {taut_surface_points(surface), taut_surface_exact(surface)};
    const taut_exact_ops *ops = NULL;
    double residual = 0;
    taut_status status = taut_exact_load(&ops, error);

    if (status == TAUT_OK &&
        !ops->residual(taut_basis_degree(u), taut_basis_degree(v), &net, rectangle, &residual)) {
        /* not reached: the module that there is returns 1, FLINT sees to its own memory */
        return taut_fail_memory(error);
    }
    if (status == TAUT_OK && residual > 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/surface", residual, 0,
                         "not harmonic in rational arithmetic: the surface's residual is %.3g, "
                         "not 0; coordinates written as texts such as \"3/4\" are not rounded",
                         residual);
    }
    return status;
}

static taut_status fill_model(const taut_neighbour *e,
                              const taut_harmonic_extension_problem *problem, int exact,
                              taut_model *model, taut_error *error)
{
    const size_t numbers = 3 * (size_t)(e->n + 1) * (size_t)(e->m + 1);
    const int g1 = problem->contact == TAUT_CONTACT_G1;
    double *next = taut_arena_take(e->arena, numbers, sizeof(double));
    double *merged = taut_arena_take(e->arena, numbers, sizeof(double));
    double amplification = pow(1 + 2 * e->ratio, e->n);
    taut_surface *surfaces[3] = {NULL, NULL, NULL};
    taut_record *details = NULL;
    taut_status status = next != NULL && merged != NULL ? TAUT_OK : taut_fail_memory(error);

    if (status == TAUT_OK && g1) {
        status = complete_g1(e, problem, next, &amplification, error);
    } else if (status == TAUT_OK) {
        taut_neighbour_extrapolate(e, 0, next);
        taut_neighbour_extrapolate(e, 1, merged);
    }
    if (status == TAUT_OK) { /* with its exact points only where they are worked with */
        status = taut_surface_new_exact(taut_surface_name(e->surface), taut_surface_u(e->surface),
                                        taut_surface_v(e->surface), taut_surface_points(e->surface),
                                        NULL, exact ? taut_surface_exact(e->surface) : NULL,
                                        &surfaces[0], error);
    }
    if (status == TAUT_OK) {
        memcpy(next, e->net + 3 * e->n * (e->m + 1), (size_t)(3 * (e->m + 1)) * sizeof(double));
        status = taut_neighbour_surface(e, "extension", next, 0, &surfaces[1], error);
    }
    if (status == TAUT_OK && !g1) {
        status = taut_neighbour_surface(e, "h", merged, 1, &surfaces[2], error);
    }
    for (int i = 1; i < 3 && exact && status == TAUT_OK; i++) {
        status = taut_neighbour_exact(e->surface, e->arena, &surfaces[i], error);
    }
    if (status == TAUT_OK && e->other != NULL) {
        status = taut_neighbour_compare(e, surfaces[1], exact, error);
    }
    for (int i = 0; i < 3; i++) {
        if (status == TAUT_OK && surfaces[i] != NULL) {
            status = taut_model_add_surface(model, surfaces[i]);
            surfaces[i] = status == TAUT_OK ? NULL : surfaces[i];
        }
        taut_surface_free(surfaces[i]);
    }
    if (status == TAUT_OK) {
        details = taut_record_new();
        taut_record_add_number(details, "amplification", amplification);
        taut_record_add_null(details, "repair");
        if (exact) {
            taut_record_add_text(details, "arithmetic", "rational");
        }
        taut_model_set_details(model, details);
        status = taut_record_status(details) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
    }
    return status;
}

taut_status taut_harmonic_extension_make(const taut_harmonic_extension_problem *problem,
                                         const taut_make_options *options, taut_model **model,
                                         taut_error *error)
{
    taut_neighbour e = {.surface = NULL};
    double *scratch = NULL, width = problem != NULL ? problem->width : 0;
    taut_model *made = NULL;
    const int exact = options != NULL && options->exact;
    taut_status status = check_problem(problem, error);

    if (status == TAUT_OK && exact && problem->contact == TAUT_CONTACT_G1) {
        status = taut_fail(error, TAUT_BAD_ARGUMENT, "argument", "/contact", taut_none, taut_none,
                           "contact \"g1\" is not done in rational arithmetic");
    }
    if (status != TAUT_OK) {
        return status;
    }
    e.surface = problem->surface;
    e.edge = problem->edge;
    e.other = problem->neighbour;
    e.arena = taut_arena_new();
    status =
        e.arena != NULL && taut_model_new(&made) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
    if (status == TAUT_OK && e.other != NULL) {
        status = taut_neighbour_match(&e, &width, error);
    }
    if (status == TAUT_OK) {
        status = taut_neighbour_turn(&e, width, error);
    }
    if (status == TAUT_OK) {
        scratch =
            taut_arena_take(e.arena, 6 * (size_t)(e.n + 1) * (size_t)(e.m + 1), sizeof(double));
        status = scratch != NULL ? TAUT_OK : taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        const double residual = taut_neighbour_residual(&e, 1, scratch);
        const double limit = fmax(harmonic_limit, 4 * DBL_EPSILON * taut_frame_reach(&e.frame));
        if (!(residual <= limit)) {
            status = taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/surface", residual, limit,
                               "not harmonic: the surface's scaled residual is %.3g, expected at "
                               "most %.0e over its own rectangle",
                               residual, limit);
        }
    }
    if (status == TAUT_OK && exact) {
        status = check_exact(e.surface, error);
    }
    if (status == TAUT_OK) {
        status = fill_model(&e, problem, exact, made, error);
    }
    taut_arena_free(e.arena);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *model = made;
    return TAUT_OK;
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    return taut_harmonic_extension_make(data, options, model, error);
}

const taut_construct_ops taut_construct_harmonic_extension = {.make = make, .exact = 1};
