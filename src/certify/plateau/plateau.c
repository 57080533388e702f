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
 *   boundary    in its place with curves, or where knots were put in: largest distance of an edge
 *               from its curve, or from that of the problem's net, at equal parts of their ranges,
 *               proved (certify/common/curve_distance.h), over the size of the boundary: the
 *               largest distance of two control points of the curves from the first.
 *               Limit: 5/4 of the deviation that the model tells, which was found at samples, over
 *               the same, and rounding, 64 (p + q + n) 2^-53 for degrees p, q and n points on an
 *               edge.
 */
#include "taut/plateau.h"

#include "certify/certify_ops.h"
#include "certify/common/curve_distance.h"
#include "certify/common/known.h"
#include "certify/dirichlet/gradient.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "measure/integrate/integrals.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ROUNDINGS = 8, GRID = 101 /* as taut_measure_surface */ };
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

/* Is the net of the surface another one than the problem's? */
static int has_new_net(const taut_plateau_problem *problem)
{
    return problem->curves[0] != NULL || problem->tolerance_area > 0;
}

static int is_known(const request *r, int i, int j)
{
    if (r->problem != NULL && !r->boundary_only) {
        return r->problem->net.known[(size_t)i * (size_t)r->nv + (size_t)j] != 0;
    }
    return !r->boundary_only || i == 0 || j == 0 || i == r->nu - 1 || j == r->nv - 1;
}

static taut_status refuse_detail(const char *where, const char *what, taut_error *error)
{
    return taut_fail(error, TAUT_BAD_INPUT, "details", where, taut_none, taut_none,
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
        return refuse_detail("/details/directions", "the directions its points move in", error);
    }
    for (size_t i = 0; i < nu * nv; i++) {
        const taut_record *row = taut_record_at(rows, i / nv);
        const taut_record *point = taut_record_at(row, i % nv);
        double *d = r->directions + 3 * i;
        for (size_t c = 0; c < 3; c++) {
            d[c] = taut_record_number(taut_record_at(point, c));
        }
        if (taut_record_count(row) != nv || !(fabs(taut_norm(d) - 1) < 1e-12)) {
            return refuse_detail("/details/directions", "the unit directions its points move in",
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
        return taut_fail(error, TAUT_BAD_INPUT, "needs-problem", "/details/known", taut_none,
                         taut_none,
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

/* What the problem says, or without it the model; *is_normal: points moved along directions. */
static taut_status read_method(const taut_record *details, request *r, int *is_normal,
                               taut_error *error)
{
    const taut_plateau_problem *problem = r->problem;
    const char *method = taut_record_text(taut_record_get(details, "method"));
    taut_status status = TAUT_OK;

    if (problem == NULL) {
        status = read_details(details, r, error);
        *is_normal = strcmp(method, "normal") == 0 && r->boundary_only;
        return status;
    }
    r->tolerance = problem->tolerance;
    *is_normal = problem->method == TAUT_PLATEAU_NORMAL;
    if (has_new_net(problem)) {
        r->boundary_only = 1;
        return TAUT_OK;
    }
    if (taut_basis_count(problem->net.u) != r->nu || taut_basis_count(problem->net.v) != r->nv) {
        return taut_fail(error, TAUT_BAD_INPUT, "model", "/surfaces/0/points", taut_none, taut_none,
                         "the model's net is %d by %d, the problem's %d by %d: they do not "
                         "belong together",
                         r->nu, r->nv, taut_basis_count(problem->net.u),
                         taut_basis_count(problem->net.v));
    }
    *is_normal = *is_normal && memchr(problem->net.known, 0, (size_t)r->nu * (size_t)r->nv) != NULL;
    return TAUT_OK;
}

static taut_status read_request(const taut_model *model, const taut_plateau_problem *problem,
                                request *r, taut_error *error)
{
    const taut_record *details = taut_model_details(model);
    const double deviation = taut_record_number(taut_record_get(details, "deviation"));
    int is_normal = 0;
    taut_status status = TAUT_OK;

    if (problem != NULL && !has_boundary(problem)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "the problem needs four curves, or two bases, points and which of them "
                         "are known");
    }
    r->surface = taut_model_surface(model, 0);
    r->problem = problem;
    r->deviation = deviation > 0 && isfinite(deviation) ? deviation : 0;
    if (r->surface == NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "model", "/surfaces", 0, 1,
                         "the model has no surface, expected the one of its problem");
    }
    r->nu = taut_basis_count(taut_surface_u(r->surface));
    r->nv = taut_basis_count(taut_surface_v(r->surface));
    status = read_method(details, r, &is_normal, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (!(r->tolerance > 0)) {
        r->tolerance = tolerance_default;
    }
    return is_normal ? read_directions(details, r, error) : TAUT_OK;
}

static finding judge_gradient(const request *r, const taut_dirichlet_gradient *gradient)
{
    finding found = {0, 0, 0, 0};
    double unknown = 0, all = 0, gross = 0;

    for (int i = 0; i < r->nu; i++) {
        for (int j = 0; j < r->nv; j++) {
            const size_t at = (size_t)i * (size_t)r->nv + (size_t)j;
            const double *g = gradient->values + 3 * at;
            const double size = r->directions != NULL ? fabs(taut_dot(r->directions + 3 * at, g))
                                                      : taut_largest_coordinate(g);
            all = fmax(all, taut_largest_coordinate(g));
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
    found.noise = ROUNDINGS * TAUT_UNIT_ROUNDOFF * (all > 0 ? fmax(1, gross / all) : 1);
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

    if (status != TAUT_OK) {
        return status;
    }
    *settled = 0;
    *found = judge_gradient(r, gradient);
    while (!*settled && nodes < TAUT_GAUSS_MAX) {
        const double before = found->residual;
        nodes = nodes + nodes / 2 < TAUT_GAUSS_MAX ? nodes + nodes / 2 : TAUT_GAUSS_MAX;
        taut_dirichlet_gradient_clear(gradient);
        status = taut_area_gradient_new(r->surface, nodes, gradient);
        if (status != TAUT_OK) {
            return status;
        }
        *found = judge_gradient(r, gradient);
        const double apart = fabs(found->residual - before);
        const double enough = spans * nodes * nodes > many ? 0.25 * r->tolerance : 0;
        *settled = fmax(found->residual, before) <= found->noise ||
                   apart <= fmax(enough, fmax(found->noise, 1e-2 * found->residual));
    }
    return TAUT_OK;
}

/* out = the gradient where it may act: at unknown points, along the directions. */
static void find_free_part(const request *r, const taut_dirichlet_gradient *gradient, double *out)
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

/* The surface a small step along g away; TAUT_BAD_INPUT: no double is large enough. */
static taut_status move_surface(const request *r, const taut_dirichlet_gradient *gradient,
                                double step, const double *g, taut_surface **moved)
{
    const size_t count = 3 * (size_t)r->nu * (size_t)r->nv;
    double *points = taut_alloc(count, sizeof(double));
    taut_status status = TAUT_OK;

    if (points == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        points[i] = taut_surface_points(r->surface)[i] + ldexp(step * g[i], gradient->unit);
    }
    status = taut_surface_new("", taut_surface_u(r->surface), taut_surface_v(r->surface), points,
                              taut_surface_weights(r->surface), moved, NULL);
    taut_free(points);
    return status;
}

/* *change = g . (gradient a step away - gradient). */
static taut_status find_change(const request *r, const taut_dirichlet_gradient *gradient,
                               double step, const double *g, double *change)
{
    const size_t count = 3 * (size_t)r->nu * (size_t)r->nv;
    const int nodes = TAUT_GAUSS_MAX < 32 ? TAUT_GAUSS_MAX : 32;
    taut_dirichlet_gradient there = {NULL, NULL, {0, 0}, 0, 0};
    taut_surface *surface = NULL;
    taut_status status = move_surface(r, gradient, step, g, &surface);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_area_gradient_new(surface, nodes, &there);
    taut_surface_free(surface);
    if (status != TAUT_OK) {
        return status;
    }
    for (size_t i = 0; i < count; i++) {
        const double scale = ldexp(1, there.unit - gradient->unit);
        *change += g[i] * (scale * there.values[i] - gradient->values[i]);
    }
    taut_dirichlet_gradient_clear(&there);
    return TAUT_OK;
}

/* *gain = |g|^4 / (2 g.H g) over the area, from the gradient a small step away; INFINITY where
 * there is none, or no double is large enough for the step. */
static taut_status find_gain(const request *r, const taut_dirichlet_gradient *gradient,
                             double residual, double *gain)
{
    const size_t count = 3 * (size_t)r->nu * (size_t)r->nv;
    const double step = 1e-5 / (residual > 0 ? residual : 1); /* moves about 1e-5 of the unit */
    double *g = taut_alloc(count, sizeof(double));
    double square = 0, change = 0;
    taut_status status = TAUT_OK;

    if (g == NULL) {
        return TAUT_NO_MEMORY;
    }
    find_free_part(r, gradient, g);
    for (size_t i = 0; i < count; i++) {
        square += g[i] * g[i];
    }
    status = find_change(r, gradient, step, g, &change);
    *gain = change > 0 ? square * square * step / (2 * change * gradient->area) : INFINITY;
    taut_free(g);
    return status == TAUT_BAD_INPUT ? TAUT_OK : status;
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

/* What edge e has to be: to be freed. */
static taut_status make_wanted_edge(const taut_plateau_problem *problem, int e, taut_curve **curve,
                                    taut_error *error)
{
    const taut_dirichlet_problem *net = &problem->net;
    if (problem->curves[e] != NULL) {
        return taut_curve_copy(problem->curves[e], curve) == TAUT_OK ? TAUT_OK
                                                                     : taut_fail_memory(error);
    }
    return taut_certify_edge(net->u, net->v, net->points, net->weights, e, curve, error);
}

static int degree_of(const taut_curve *curve)
{
    const int degree = taut_basis_degree(taut_curve_t(curve));
    return degree >= 0 ? degree : 5; /* as a spline */
}

/* What is found of the edges, one after the other. */
typedef struct boundary {
    double origin[3]; /* the first control point of the first curve */
    double size, distance, roundings;
    int worst; /* the edge with that distance */
} boundary;

static taut_status compare_edges(const taut_curve *found, const taut_curve *wanted, int e,
                                 boundary *b, taut_error *error)
{
    double bound = INFINITY;
    const taut_status status = taut_certify_distance(found, wanted, &bound, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (e == 0) {
        memcpy(b->origin, taut_curve_points(wanted), sizeof b->origin);
    }
    b->size = fmax(b->size, taut_certify_reach(wanted, b->origin));
    b->roundings = fmax(b->roundings, degree_of(found) + degree_of(wanted) +
                                          taut_basis_count(taut_curve_t(found)));
    b->worst = bound <= b->distance ? b->worst : e;
    b->distance = bound <= b->distance ? b->distance : bound;
    return TAUT_OK;
}

static taut_status check_edge(const request *r, int e, boundary *b, taut_error *error)
{
    const taut_surface *surface = r->surface;
    taut_curve *wanted = NULL, *found = NULL;
    taut_status status = make_wanted_edge(r->problem, e, &wanted, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_certify_edge(taut_surface_u(surface), taut_surface_v(surface),
                               taut_surface_points(surface), taut_surface_weights(surface), e,
                               &found, error);
    if (status == TAUT_OK) {
        status = compare_edges(found, wanted, e, b, error);
    }
    taut_curve_free(wanted);
    taut_curve_free(found);
    return status;
}

static taut_status add_boundary(const request *r, taut_certificate *certificate, taut_error *error)
{
    static const char *const names[4] = {"u0", "u1", "v0", "v1"};
    boundary b = {{0, 0, 0}, 0, 0, 0, 0};

    for (int e = 0; e < 4; e++) {
        const taut_status status = check_edge(r, e, &b, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    b.roundings *= 1 + taut_norm(b.origin) / b.size; /* of points as they are stored */
    const double told = r->deviation / b.size, rounding = 64 * b.roundings * TAUT_UNIT_ROUNDOFF;
    const double proved = b.distance / b.size;
    const int holds = proved <= 1.25 * told + rounding && told <= proved + rounding;
    const taut_claim claim = {
        .claim = "boundary",
        .residual = proved,
        .limit = 1.25 * told + rounding,
        .holds = holds ? TAUT_TRUE : TAUT_FALSE,
        .where = names[b.worst],
    };
    return taut_certificate_add(certificate, &claim) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

/* The claim `stationary`. */
static taut_status prove_stationary(const request *r, taut_dirichlet_gradient *gradient,
                                    taut_certificate *certificate)
{
    finding found = {0, 0, 0, 0};
    double gain = INFINITY;
    int settled = 0;
    taut_status status = find_gradient(r, gradient, &found, &settled);

    if (status != TAUT_OK) {
        return status;
    }
    if (found.residual > r->tolerance && found.residual <= largest_limit) {
        status = find_gain(r, gradient, found.residual, &gain);
        if (status != TAUT_OK) {
            return status;
        }
    }
    return add_stationary(r, &found, gain < flat, settled, certificate);
}

static taut_status prove(const request *r, const taut_certify_options *options,
                         taut_certificate *certificate, taut_error *error)
{
    taut_dirichlet_gradient gradient = {NULL, NULL, {0, 0}, 0, 0};
    taut_status status = prove_stationary(r, &gradient, certificate);

    taut_dirichlet_gradient_clear(&gradient);
    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (r->problem != NULL && has_new_net(r->problem)) {
        status = add_boundary(r, certificate, error);
        if (status != TAUT_OK) {
            return status;
        }
    } else if (r->problem != NULL &&
               taut_certify_add_known(r->surface, &r->problem->net, certificate) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return add_figures(r, options, certificate, error);
}

static taut_status certify(const taut_model *model, const void *data,
                           const taut_certify_options *options, taut_certificate *certificate,
                           taut_error *error)
{
    request r = {.surface = NULL};
    taut_status status = read_request(model, data, &r, error);

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
