/* extension.c -- construct `harmonic-extension`: the harmonic neighbour across an edge.
 *
 * Contact c1: equal derivatives leave one harmonic surface, and it is the polynomial itself carried
 * on ([NiWang2015] section 2.6), so its net is a de Casteljau extrapolation, as is that of the
 * merged surface. Contact g1: equal tangent planes leave three numbers free; the edge and the derivative
 * across it are completed (section 8.6).
 */
#include "construct/common/build.h"
#include "construct/construct_ops.h"
#include "construct/harmonic/complete.h"
#include "construct/harmonic/lidstone.h"
#include "construct/harmonic/neighbour.h"
#include "core/arena.h"
#include "core/elementary/elementary.h"
#include "core/exact.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "taut/harmonic.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A given surface counts as harmonic up to this scaled residual. */
static const double harmonic_limit = 1e-10;

/* The derivative across the neighbour's first edge, in its own normalised parameter:
 *     h (c P_u + (alpha + beta v) P_v),  P_u and P_v by parameter length on the shared edge. */
static void derive_g1(const taut_neighbour *e, const taut_extension_g1 *p, double *cross)
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

static taut_status complete_g1(const taut_neighbour *e, const taut_extension_g1 *g1, double *out,
                               double *amplification, taut_pulse *pulse, taut_error *error)
{
    const int n = e->n, m = e->m;
    const taut_twice ratio =
        taut_twice_over_number(taut_twice_product(e->ratio, e->across), e->along);
    const taut_twice mu = taut_twice_times(ratio, ratio);
    const size_t points = (size_t)(n + 1) * (size_t)(m + 1);
    const double limit = fmax(1e-10, 4 * ldexp(DBL_EPSILON, m) * taut_unit_map_reach(&e->map));
    double *cross = taut_arena_take(e->arena, 3 * (size_t)(m + 1), sizeof(double));
    taut_twice *net = taut_arena_take(e->arena, 3 * points, sizeof *net);
    double *sum = taut_arena_take(e->arena, points, sizeof *sum);
    double top[3];

    if (taut_arena_status(e->arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (n < m) {
        return taut_fail(
            error, TAUT_NO_SOLUTION, "degree", "/surface", n, m,
            "a neighbour with the same tangent planes needs degree %d across the edge, "
            "found %d",
            m, n);
    }
    derive_g1(e, g1, cross);
    taut_top_difference(m, cross, top);
    const double defect = taut_largest_coordinate(top);
    if (m % 2 == 0 && n == m && defect > limit) {
        return taut_fail(error, TAUT_NO_SOLUTION, "inconsistent", "/beta", defect * e->map.size,
                         limit * e->map.size,
                         "inconsistent derivative: the degree %d is even, so \"beta\" must be 0 "
                         "here (the top difference is %.6g)",
                         m, defect * e->map.size);
    }
    taut_harmonic_from_derivative(n, m, mu, e->net + 3 * n * (m + 1), 1, cross, net, out, pulse);
    *amplification = taut_harmonic_derivative_amplification(n, m, mu, net, sum, pulse);
    return TAUT_OK;
}

static double width_of(const taut_harmonic_extension_problem *problem)
{
    switch (problem->given) {
    case TAUT_EXTENSION_C1:
        return problem->c1.width;
    case TAUT_EXTENSION_G1:
        return problem->g1.width;
    case TAUT_EXTENSION_MERGE:
        break;
    }
    return 0;
}

static taut_status check_problem(const taut_harmonic_extension_problem *problem, int exact,
                                 taut_error *error)
{
    taut_status status = TAUT_OK;

    if (problem == NULL || problem->surface == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "an extension needs a surface");
    }
    if (problem->given == TAUT_EXTENSION_MERGE && problem->merge.neighbour == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a merge needs a neighbour");
    }
    status = taut_neighbour_check(problem->surface, width_of(problem), error);
    if (status != TAUT_OK || problem->given != TAUT_EXTENSION_G1) {
        return status;
    }
    const taut_extension_g1 *g1 = &problem->g1;
    if (!(g1->c > 0 && isfinite(g1->c) && isfinite(g1->alpha) && isfinite(g1->beta))) {
        return taut_fail_expected(error, TAUT_BAD_INPUT, "value", "/c", g1->c, "a positive number",
                                  "bad parameter: c is %.17g", g1->c);
    }
    if (exact) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "no-rationals", "/contact", taut_none, taut_none,
                         "contact \"g1\" is not done in rational arithmetic");
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

    if (status != TAUT_OK) {
        return status;
    }
    if (!ops->residual(taut_basis_degree(u), taut_basis_degree(v), &net, rectangle, &residual)) {
        /* not reached: the module that there is returns 1, FLINT sees to its own memory */
        return taut_fail_memory(error);
    }
    if (residual > 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "not-harmonic", "/surface", residual, 0,
                         "not harmonic in rational arithmetic: the surface's residual is %.3g, "
                         "not 0; coordinates written as texts such as \"3/4\" are not rounded",
                         residual);
    }
    return TAUT_OK;
}

/* The given surface, with its exact points only where they are worked with. */
static taut_status add_given(const taut_surface *given, int exact, taut_model *model,
                             taut_error *error)
{
    taut_surface *copy = NULL;
    const taut_status status = taut_surface_new_exact(
        taut_surface_name(given), taut_surface_u(given), taut_surface_v(given),
        taut_surface_points(given), NULL, exact ? taut_surface_exact(given) : NULL, &copy, error);
    return status == TAUT_OK ? taut_construct_add_surface(model, copy, error) : status;
}

/* A surface of a turned net, and its exact points where they are wanted. */
static taut_status make_surface(const taut_neighbour *e, const char *name, double *net, int merged,
                                int exact, taut_surface **surface, taut_error *error)
{
    taut_surface *made = NULL;
    taut_status status = taut_neighbour_surface(e, name, net, merged, &made, error);
    if (status == TAUT_OK && exact) {
        status = taut_neighbour_exact(e->surface, e->arena, &made, error);
    }
    if (status != TAUT_OK) {
        taut_surface_free(made);
        return status;
    }
    *surface = made;
    return TAUT_OK;
}

/* What lies beyond, which has to be what was given there. */
static taut_status add_beyond(const taut_neighbour *e, double *net, int exact, taut_model *model,
                              taut_error *error)
{
    taut_surface *beyond = NULL;
    taut_status status = make_surface(e, "extension", net, 0, exact, &beyond, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = e->other != NULL ? taut_neighbour_compare(e, beyond, exact, error) : TAUT_OK;
    if (status != TAUT_OK) {
        taut_surface_free(beyond);
        return status;
    }
    return taut_construct_add_surface(model, beyond, error);
}

/* Contact g1. */
static taut_status add_tangent(const taut_neighbour *e, const taut_extension_g1 *g1,
                               double *amplification, taut_pulse *pulse, taut_model *model,
                               taut_error *error)
{
    const size_t line = 3 * (size_t)(e->m + 1);
    double *net = taut_arena_take(e->arena, (size_t)(e->n + 1) * line, sizeof(double));
    taut_status status = TAUT_OK;

    if (net == NULL) {
        return taut_fail_memory(error);
    }
    status = complete_g1(e, g1, net, amplification, pulse, error);
    if (status != TAUT_OK) {
        return status;
    }
    memcpy(net, e->net + (size_t)e->n * line, line * sizeof(double));
    return add_beyond(e, net, 0, model, error);
}

/* The polynomial itself carried on, and it all as one surface. */
static taut_status add_carried(const taut_neighbour *e, int exact, taut_model *model,
                               taut_error *error)
{
    const size_t line = 3 * (size_t)(e->m + 1), numbers = (size_t)(e->n + 1) * line;
    double *net = taut_arena_take(e->arena, numbers, sizeof(double));
    double *merged = taut_arena_take(e->arena, numbers, sizeof(double));
    taut_surface *whole = NULL;
    taut_status status = TAUT_OK;

    if (taut_arena_status(e->arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_neighbour_extrapolate(e, 0, net);
    taut_neighbour_extrapolate(e, 1, merged);
    memcpy(net, e->net + (size_t)e->n * line, line * sizeof(double));
    status = add_beyond(e, net, exact, model, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = make_surface(e, "h", merged, 1, exact, &whole, error);
    return status == TAUT_OK ? taut_construct_add_surface(model, whole, error) : status;
}

static taut_status check_harmonic(const taut_neighbour *e, int exact, taut_error *error)
{
    const double limit = fmax(harmonic_limit, 4 * DBL_EPSILON * taut_unit_map_reach(&e->map));
    double *scratch =
        taut_arena_take(e->arena, 6 * (size_t)(e->n + 1) * (size_t)(e->m + 1), sizeof(double));
    double residual = 0;

    if (scratch == NULL) {
        return taut_fail_memory(error);
    }
    residual = taut_neighbour_residual(e, 1, scratch);
    if (!(residual <= limit)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "not-harmonic", "/surface", residual, limit,
                         "not harmonic: the surface's scaled residual is %.3g, expected at "
                         "most %.0e over its own rectangle",
                         residual, limit);
    }
    return exact ? check_exact(e->surface, error) : TAUT_OK;
}

/* The surface turned, and found to be harmonic. */
static taut_status turn_surface(taut_neighbour *e, double width, int exact, taut_error *error)
{
    taut_status status = e->other != NULL ? taut_neighbour_match(e, &width, error) : TAUT_OK;
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_neighbour_turn(e, width, error);
    return status == TAUT_OK ? check_harmonic(e, exact, error) : status;
}

typedef struct request {
    const taut_harmonic_extension_problem *problem;
    int exact;
    taut_pulse *pulse;
} request;

static taut_status fill_model(void *context, taut_arena *arena, taut_model *model,
                              taut_error *error)
{
    const request *asked = context;
    const taut_harmonic_extension_problem *problem = asked->problem;
    const int merge = problem->given == TAUT_EXTENSION_MERGE;
    taut_neighbour e = {.surface = problem->surface,
                        .edge = problem->edge,
                        .other = merge ? problem->merge.neighbour : NULL,
                        .arena = arena};
    taut_record *details = NULL;
    double amplification = 0;
    taut_status status = turn_surface(&e, width_of(problem), asked->exact, error);

    if (status != TAUT_OK) {
        return status;
    }
    amplification = taut_pow(1 + 2 * e.ratio, e.n);
    status = add_given(e.surface, asked->exact, model, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = problem->given == TAUT_EXTENSION_G1
                 ? add_tangent(&e, &problem->g1, &amplification, asked->pulse, model, error)
                 : add_carried(&e, asked->exact, model, error);
    if (asked->pulse->is_stopped) {
        return taut_fail_status(error, TAUT_INTERRUPTED);
    }
    if (status != TAUT_OK) {
        return status;
    }
    details = taut_record_new();
    taut_record_add_number(details, "amplification", amplification);
    taut_record_add_null(details, "repair");
    if (asked->exact) {
        taut_record_add_text(details, "arithmetic", "rational");
    }
    if (problem->given != TAUT_EXTENSION_G1) {
        taut_record_add_text(details, "whole", "h"); /* it lies on the two others */
    }
    return taut_construct_set_details(model, details, error);
}

taut_status taut_harmonic_extension_make(const taut_harmonic_extension_problem *problem,
                                         const taut_make_options *options, taut_model **model,
                                         taut_error *error)
{
    taut_pulse pulse = {.monitor = options != NULL ? &options->monitor : NULL,
                        .what = "solving",
                        .done = taut_none};
    request asked = {problem, options != NULL && options->exact, &pulse};
    const taut_status status = check_problem(problem, asked.exact, error);

    return status == TAUT_OK ? taut_construct_build(fill_model, &asked, model, error) : status;
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    return taut_harmonic_extension_make(data, options, model, error);
}

const taut_construct_ops taut_construct_harmonic_extension = {.make = make, .exact = 1};
