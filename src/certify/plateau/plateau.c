/* plateau.c -- is the area of this surface at rest in its spline space?
 *
 * Claims:
 *
 *   stationary  largest |dA/dP| at an unknown point over the largest at any point, by quadrature of
 *               the metric form of the gradient (certify/dirichlet/gradient.h) at nodes of its own.
 *               With the method "normal": largest |d . dA/dP|, d the direction the point moves in,
 *               which the model tells.
 *               Limit: the first of these that the residual is within, else the last,
 *                   1. the rounding that storing the points leaves, as for dirichlet,
 *                   2. the tolerance of the problem (default 1e-10), at most 1e-6,
 *                   3. 1e-6 where the area is flat: going along its steepest descent g at the
 *                      unknown points would gain |g|^4 / (2 g.H g) < 1e-15 of it, with H g from
 *                      the difference of two gradients.
 *   known       certify/common/known.h: of a net that was kept.
 *   boundary    in its place with curves, or where knots were put in: largest proved distance of an
 *               edge from its curve, or from that of the problem's net, over the size of the
 *               boundary (certify/plateau/boundary.h).
 */
#include "taut/plateau.h"

#include "certify/certify_ops.h"
#include "certify/common/known.h"
#include "certify/dirichlet/gradient.h"
#include "certify/plateau/boundary.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "measure/integrate/integrals.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ROUNDINGS = 8, GRID = 101 /* as taut_measure_surface */ };
static const double unit_roundoff = 0x1p-53;
static const double many = 4e4; /* Gauss points */
static const double largest_limit = 1e-6, tolerance_default = 1e-10, flat = 1e-15;

typedef struct request {
    const taut_surface *surface;
    const taut_plateau_problem *problem; /* or NULL */
    int nu, nv;
    int boundary_only;  /* the boundary is known; without a problem else every point is */
    double *directions; /* [nu][nv][3] for the method "normal", or NULL */
    double tolerance;
    double deviation; /* of the edges from the curves, that the model tells; else 0 */
} request;

typedef struct finding {
    double residual, noise;
    int at_u, at_v;
} finding;

static int is_known(const request *r, int i, int j)
{
    if (r->problem != NULL && !r->boundary_only) {
        return r->problem->net.known[(size_t)i * (size_t)r->nv + (size_t)j] != 0;
    }
    return !r->boundary_only || i == 0 || j == 0 || i == r->nu - 1 || j == r->nv - 1;
}

static taut_status wrong_detail(const char *where, const char *what, taut_error *error)
{
    return taut_fail(error, TAUT_BAD_INPUT, "value", where, taut_none, taut_none,
                     "the model does not tell %s: make it again", what);
}

/* details.directions, each of length 1. */
static taut_status read_directions(const taut_record *details, request *r, taut_error *error)
{
    const taut_record *rows = taut_record_get(details, "directions");
    const size_t nu = (size_t)r->nu, nv = (size_t)r->nv;

    r->directions = taut_alloc(3 * nu * nv, sizeof(double));
    if (r->directions == NULL) {
        return taut_fail_memory(error);
    }
    if (taut_record_count(rows) != nu) {
        return wrong_detail("/details/directions", "the directions its points move in", error);
    }
    for (size_t i = 0; i < nu * nv; i++) {
        const taut_record *row = taut_record_at(rows, i / nv);
        const taut_record *point = taut_record_at(row, i % nv);
        double *d = r->directions + 3 * i;
        for (size_t c = 0; c < 3; c++) {
            d[c] = taut_record_number(taut_record_at(point, c));
        }
        if (taut_record_count(row) != nv || !(fabs(taut_norm(d) - 1) < 1e-12)) {
            return wrong_detail("/details/directions", "the unit directions its points move in",
                                error);
        }
    }
    return TAUT_OK;
}

/* Which points are known, and the tolerance, when only the model is there. */
static taut_status read_details(const taut_record *details, request *r, taut_error *error)
{
    const char *known = taut_record_text(taut_record_get(details, "known"));

    r->tolerance = taut_record_number(taut_record_get(details, "tolerance"));
    r->boundary_only = strcmp(known, "boundary") == 0;
    if (!r->boundary_only && strcmp(known, "all") != 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/details/known", taut_none, taut_none,
                         "the model does not say which points were known: give the problem the "
                         "model was made from too");
    }
    return TAUT_OK;
}

/* Four curves, or a net. */
static int has_boundary(const taut_plateau_problem *problem)
{
    const taut_curve *const *curves = problem->curves;
    return taut_known_is_whole(&problem->net) ||
           (curves[0] != NULL && curves[1] != NULL && curves[2] != NULL && curves[3] != NULL);
}

static taut_status read_request(const taut_model *model, const taut_plateau_problem *problem,
                                request *r, taut_error *error)
{
    const taut_record *details = taut_model_details(model);
    int is_normal = strcmp(taut_record_text(taut_record_get(details, "method")), "normal") == 0;
    taut_status status = TAUT_OK;

    const double deviation = taut_record_number(taut_record_get(details, "deviation"));

    if (problem != NULL && !has_boundary(problem)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "the problem needs four curves, or two bases, points and which of them "
                         "are known");
    }
    r->surface = taut_model_surface(model, 0);
    r->problem = problem;
    r->deviation = deviation > 0 && isfinite(deviation) ? deviation : 0;
    if (r->surface == NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/surfaces", 0, 1,
                         "the model has no surface, expected the one of its problem");
    }
    r->nu = taut_basis_count(taut_surface_u(r->surface));
    r->nv = taut_basis_count(taut_surface_v(r->surface));
    if (problem == NULL) {
        status = read_details(details, r, error);
        is_normal = is_normal && r->boundary_only;
    } else if (taut_plateau_has_new_net(problem)) {
        r->tolerance = problem->tolerance;
        r->boundary_only = 1;
        is_normal = problem->method == TAUT_PLATEAU_NORMAL;
    } else if (taut_basis_count(problem->net.u) != r->nu ||
               taut_basis_count(problem->net.v) != r->nv) {
        status = taut_fail(
            error, TAUT_BAD_INPUT, "value", "/surfaces/0/points", taut_none, taut_none,
            "the model's net is %d by %d, the problem's %d by %d: they do not "
            "belong together",
            r->nu, r->nv, taut_basis_count(problem->net.u), taut_basis_count(problem->net.v));
    } else {
        r->tolerance = problem->tolerance;
        is_normal = problem->method == TAUT_PLATEAU_NORMAL &&
                    memchr(problem->net.known, 0, (size_t)r->nu * (size_t)r->nv) != NULL;
    }
    if (!(r->tolerance > 0)) {
        r->tolerance = tolerance_default;
    }
    if (status == TAUT_OK && is_normal) {
        status = read_directions(details, r, error);
    }
    return status;
}

static double largest_of(const double *p)
{
    return fmax(fabs(p[0]), fmax(fabs(p[1]), fabs(p[2])));
}

static finding judge(const request *r, const taut_dirichlet_gradient *gradient)
{
    finding found = {0, 0, 0, 0};
    double unknown = 0, all = 0, gross = 0;

    for (int i = 0; i < r->nu; i++) {
        for (int j = 0; j < r->nv; j++) {
            const size_t at = (size_t)i * (size_t)r->nv + (size_t)j;
            const double *g = gradient->values + 3 * at;
            const double size =
                r->directions != NULL ? fabs(taut_dot(r->directions + 3 * at, g)) : largest_of(g);
            all = fmax(all, largest_of(g));
            if (!is_known(r, i, j)) {
                gross = fmax(gross, gradient->gross[at]);
                if (size > unknown) {
                    unknown = size;
                    found.at_u = i;
                    found.at_v = j;
                }
            }
        }
    }
    found.residual = unknown > 0 ? unknown / all : 0;
    found.noise = ROUNDINGS * unit_roundoff * (all > 0 ? fmax(1, gross / all) : 1);
    return found;
}

/* With nodes raised by half until the judgement stays: within the noise, or a hundredth of itself;
 * above so many Gauss points that more cost much, within a quarter of the tolerance. *settled tells
 * whether it did. */
static taut_status find_gradient(const request *r, taut_dirichlet_gradient *gradient,
                                 finding *found, int *settled)
{
    const taut_basis *u = taut_surface_u(r->surface), *v = taut_surface_v(r->surface);
    const int local =
        taut_basis_local(u) > taut_basis_local(v) ? taut_basis_local(u) : taut_basis_local(v);
    const double spans = (double)taut_basis_span_count(u) * taut_basis_span_count(v);
    int nodes = local + 5;
    taut_status status = taut_area_gradient_new(r->surface, nodes, gradient);

    *settled = 0;
    *found = status == TAUT_OK ? judge(r, gradient) : (finding){0, 0, 0, 0};
    while (status == TAUT_OK && !*settled && nodes < TAUT_GAUSS_MAX) {
        const double before = found->residual;
        nodes = nodes + nodes / 2 < TAUT_GAUSS_MAX ? nodes + nodes / 2 : TAUT_GAUSS_MAX;
        taut_dirichlet_gradient_clear(gradient);
        status = taut_area_gradient_new(r->surface, nodes, gradient);
        if (status == TAUT_OK) {
            *found = judge(r, gradient);
            const double apart = fabs(found->residual - before);
            const double enough = spans * nodes * nodes > many ? 0.25 * r->tolerance : 0;
            *settled = fmax(found->residual, before) <= found->noise ||
                       apart <= fmax(enough, fmax(found->noise, 1e-2 * found->residual));
        }
    }
    return status;
}

/* out = the gradient where it may act: at unknown points, along the directions. */
static void free_part(const request *r, const taut_dirichlet_gradient *gradient, double *out)
{
    for (int i = 0; i < r->nu; i++) {
        for (int j = 0; j < r->nv; j++) {
            const size_t at = 3 * ((size_t)i * (size_t)r->nv + (size_t)j);
            const double *g = gradient->values + at;
            const double *d = r->directions != NULL ? r->directions + at : NULL;
            for (size_t c = 0; c < 3; c++) {
                out[at + c] = is_known(r, i, j) ? 0 : d != NULL ? taut_dot(d, g) * d[c] : g[c];
            }
        }
    }
}

/* *gain = |g|^4 / (2 g.H g) over the area, from the gradient a small step away; INFINITY where
 * there is none, or no double is large enough for the step. */
static taut_status find_gain(const request *r, const taut_dirichlet_gradient *gradient,
                             double residual, double *gain)
{
    const size_t count = 3 * (size_t)r->nu * (size_t)r->nv;
    const int nodes = TAUT_GAUSS_MAX < 32 ? TAUT_GAUSS_MAX : 32;
    double *g = taut_alloc(count, sizeof(double)), *moved = taut_alloc(count, sizeof(double));
    double square = 0, change = 0, step = 0;
    taut_dirichlet_gradient there = {NULL, NULL, {0, 0}, 0, 0};
    taut_surface *surface = NULL;
    taut_status status = g != NULL && moved != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    if (status == TAUT_OK) {
        free_part(r, gradient, g);
        step = 1e-5 / (residual > 0 ? residual : 1); /* largest move about 1e-5 of the unit */
        for (size_t i = 0; i < count; i++) {
            moved[i] = taut_surface_points(r->surface)[i] + ldexp(step * g[i], gradient->unit);
            square += g[i] * g[i];
        }
        status = taut_surface_new("", taut_surface_u(r->surface), taut_surface_v(r->surface), moved,
                                  taut_surface_weights(r->surface), &surface, NULL);
    }
    if (status == TAUT_OK) {
        status = taut_area_gradient_new(surface, nodes, &there);
    }
    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        const double scale = ldexp(1, there.unit - gradient->unit);
        change += g[i] * (scale * there.values[i] - gradient->values[i]);
    }
    *gain = change > 0 ? square * square * step / (2 * change * gradient->area) : INFINITY;
    status = status == TAUT_BAD_INPUT ? TAUT_OK : status;
    taut_dirichlet_gradient_clear(&there);
    taut_surface_free(surface);
    taut_free(g);
    taut_free(moved);
    return status;
}

static taut_status add_stationary(const request *r, const finding *found, int is_flat, int settled,
                                  taut_certificate *certificate)
{
    const double given = fmin(r->tolerance, largest_limit);
    char where[128];
    taut_claim claim = {"stationary", found->residual, given, TAUT_FALSE, where};

    snprintf(where, sizeof where, "/surfaces/0/points/%d/%d", found->at_u, found->at_v);
    if (found->residual <= fmin(found->noise, largest_limit)) {
        claim.limit = fmin(found->noise, largest_limit);
        claim.holds = TAUT_TRUE;
    } else if (found->residual <= given) {
        claim.holds = TAUT_TRUE;
    } else if (is_flat) {
        claim.limit = largest_limit;
        claim.holds = TAUT_TRUE;
    } else if (found->residual <= found->noise) {
        claim.holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, "the rounding of the points alone may leave %.3g",
                 found->noise);
    }
    if (!settled && claim.holds == TAUT_FALSE) {
        claim.holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, "%d Gauss nodes do not settle the integrals", TAUT_GAUSS_MAX);
    }
    return taut_certificate_add(certificate, &claim);
}

static taut_status add_figures(const request *r, const taut_certify_options *options,
                               taut_certificate *certificate, taut_error *error)
{
    const int threads = options->threads > 0 ? options->threads : 1;
    taut_mean_figures measure;
    taut_record *figures = NULL;
    taut_status status = taut_mean_figures_of(r->surface, GRID, threads, &measure);

    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    figures = taut_record_new();
    taut_record_add_number(figures, "area", measure.area);
    taut_record_add_number(figures, "mean_abs_mean_curvature", measure.mean_abs);
    taut_record_add_number(figures, "max_abs_mean_curvature", measure.max_abs);
    status = taut_record_status(figures);
    taut_certificate_set_figures(certificate, figures);
    return status == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

static taut_status add_boundary(const request *r, const taut_certify_options *options,
                                taut_certificate *certificate, taut_error *error)
{
    const taut_status status =
        taut_certify_plateau_boundary(r->surface, r->problem, r->deviation, certificate, error);
    return status == TAUT_OK ? add_figures(r, options, certificate, error) : status;
}

static taut_status prove(const request *r, const taut_certify_options *options,
                         taut_certificate *certificate, taut_error *error)
{
    taut_dirichlet_gradient gradient = {NULL, NULL, {0, 0}, 0, 0};
    finding found;
    double gain = INFINITY;
    int settled = 0;
    taut_status status = find_gradient(r, &gradient, &found, &settled);

    if (status == TAUT_OK && found.residual > r->tolerance && found.residual <= largest_limit) {
        status = find_gain(r, &gradient, found.residual, &gain);
    }
    if (status == TAUT_OK) {
        status = add_stationary(r, &found, gain < flat, settled, certificate);
    }
    taut_dirichlet_gradient_clear(&gradient);
    if (status == TAUT_OK && r->problem != NULL && taut_plateau_has_new_net(r->problem)) {
        return add_boundary(r, options, certificate, error);
    }
    if (status == TAUT_OK && r->problem != NULL) {
        status = taut_certify_add_known(r->surface, &r->problem->net, certificate);
    }
    return status == TAUT_OK ? add_figures(r, options, certificate, error)
                             : taut_fail_memory(error);
}

static taut_status certify(const taut_model *model, const void *data,
                           const taut_certify_options *options, taut_certificate *certificate,
                           taut_error *error)
{
    request r;
    taut_status status = TAUT_OK;

    memset(&r, 0, sizeof r);
    status = read_request(model, data, &r, error);
    if (status == TAUT_OK) {
        status = prove(&r, options, certificate, error);
    }
    taut_free(r.directions);
    return status;
}

const taut_certify_ops taut_certify_plateau = {.certify = certify};

taut_status taut_plateau_certify(const taut_model *model, const taut_plateau_problem *problem,
                                 const taut_certify_options *options,
                                 taut_certificate **certificate, taut_error *error)
{
    return taut_certify_with(&taut_certify_plateau, "plateau", model, problem, options, certificate,
                             error);
}
