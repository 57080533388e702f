/* plateau.c -- is the area of this surface at rest in its spline space?
 *
 * Claims:
 *
 *   stationary  largest |dA/dP| at an unknown point over the largest at any point, by quadrature of
 *               the metric form of the gradient (certify/dirichlet/gradient.h) at nodes of its own.
 *               With the method "normal": largest |d . dA/dP|, d the direction the point moves in,
 *               found here from the Dirichlet surface that the model carries as a witness
 *               (certify/plateau/normals.h): known points as they are, its energy at rest at all
 *               others, within limits 1 and 2.
 *               Limit: the first of these that the residual is within, else the last,
 *                   1. the rounding that storing the points leaves, as for dirichlet,
 *                   2. the tolerance of the problem (default 1e-10), at most 1e-6,
 *                   3. 1e-6 where the area is flat: going along its steepest descent g at the
 *                      unknown points would gain |g|^4 / (2 g.H g) < 1e-15 of it: bounded
 *                      (certify/plateau/descent.h), or else judged with H g from the difference of
 *                      two gradients, kind `check`.
 *   known       certify/common/known.h: of a net that was kept.
 *   boundary    in its place with curves, or where knots were put in: largest distance of an edge
 *               from its curve, or from that of the problem's net, at equal parts of their ranges,
 *               proved (certify/common/curve_distance.h), over the size of the boundary: the
 *               largest distance of two control points of the curves from the first.
 *               Limit: FIT of what a least squares fit of its own in the problem's space is proved
 *               to be off by (certify/plateau/fit.h), over the same, and rounding,
 *               64 (p + q + n) 2^-53 for degrees p, q and n points on an edge. Where knots were put
 *               into a net's edge it is kept as it is: rounding alone. A deviation that the model
 *               tells and that is not so is false too.
 *   regular     where the problem asks (certify/common/regular.h).
 */
#include "taut/plateau.h"

#include "certify/certify_ops.h"
#include "certify/common/curve_distance.h"
#include "certify/common/figures.h"
#include "certify/common/known.h"
#include "certify/common/regular.h"
#include "certify/common/through.h"
#include "certify/common/verdict.h"
#include "certify/dirichlet/gradient.h"
#include "certify/plateau/descent.h"
#include "certify/plateau/fit.h"
#include "certify/plateau/least.h"
#include "certify/plateau/normals.h"
#include "core/arena.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "geometry/exponent.h"
#include "geometry/nurbs/spread.h"
#include "measure/integrate/integrals.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ROUNDINGS = 8, SLACK = 2, GRID = 101 /* as taut_measure_surface */, FIT = 2 };
static const double many = 4e4; /* Gauss points */
/* A share of the largest weight. */
static const double little_weight = 0x1p-20;
static const double largest_limit = 1e-6, tolerance_default = 1e-10, flat = 1e-15;

typedef struct request {
    const taut_surface *surface;
    const taut_plateau_problem *problem; /* or NULL */
    int nu, nv;
    int boundary_only;        /* the boundary is known; without a problem else every point is */
    int is_normal;            /* the method */
    double *directions;       /* [nu][nv][3] for the method "normal", or NULL */
    const char *unproved;     /* why these are not known to be what they should be; or NULL */
    const taut_record *least; /* the witness that the model carries, or NULL */
    double tolerance;
    double deviation; /* of the edges from the curves, that the model tells; else 0 */
    const taut_crew *crew;
    taut_arena *arena;             /* of what follows: */
    taut_dirichlet_problem net;    /* the points that are known, and those to pass through, */
    taut_through *places;          /* all with parameters; NULL: none */
    taut_dirichlet_gradient freed; /* the last gradient less what holds the surface there */
} request;

typedef struct finding {
    double residual, noise;
    double rounding; /* the residual may be that much more for rounding */
    double error;    /* proved: it is at most that much more for all that is not exact */
    double largest;  /* derivative of any point */
    int at_u, at_v;
    int unknowns;
    int nodes;     /* of the last rule, where none is bounded */
    int is_unseen; /* weights are too far apart for any */
} finding;

/* Is the net of the surface another one than the problem's? */
static int has_new_net(const taut_plateau_problem *problem)
{
    return problem->curves[0] != NULL || problem->tolerance_area > 0 || problem->gap > 0;
}

static int is_known(const request *r, int i, int j)
{
    if (r->problem != NULL && !r->boundary_only) {
        return r->problem->net.known[(size_t)i * (size_t)r->nv + (size_t)j] != 0;
    }
    return !r->boundary_only || i == 0 || j == 0 || i == r->nu - 1 || j == r->nv - 1;
}

/* The boundary is known, and nothing else. */
static int knows_boundary_only(const request *r)
{
    int is_so = 1;

    for (int i = 0; i < r->nu; i++) {
        for (int j = 0; j < r->nv; j++) {
            const int on_edge = i == 0 || j == 0 || i == r->nu - 1 || j == r->nv - 1;
            is_so &= is_known(r, i, j) == on_edge;
        }
    }
    return is_so;
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

/* What the problem says, or without it the model. */
static taut_status read_method(const taut_record *details, request *r, taut_error *error)
{
    const taut_plateau_problem *problem = r->problem;
    const char *method = taut_record_text(taut_record_get(details, "method"));
    taut_status status = TAUT_OK;

    if (problem == NULL) {
        status = read_details(details, r, error);
        r->is_normal = strcmp(method, "normal") == 0 && r->boundary_only;
        return status;
    }
    r->tolerance = problem->tolerance;
    r->is_normal =
        problem->method == TAUT_PLATEAU_NORMAL ||
        (problem->method == TAUT_PLATEAU_EITHER && method != NULL && strcmp(method, "normal") == 0);
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
    r->is_normal =
        r->is_normal && memchr(problem->net.known, 0, (size_t)r->nu * (size_t)r->nv) != NULL;
    return TAUT_OK;
}

static taut_status read_request(const taut_model *model, const taut_plateau_problem *problem,
                                request *r, taut_error *error)
{
    const taut_record *details = taut_model_details(model);
    const double deviation = taut_record_number(taut_record_get(details, "deviation"));
    taut_status status = TAUT_OK;

    if (problem != NULL && !has_boundary(problem)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "the problem needs four curves, or two bases, points and which of them "
                         "are known");
    }
    r->least = taut_record_get(details, "least");
    r->surface = taut_model_surface(model, 0);
    r->problem = problem;
    r->deviation = deviation > 0 && isfinite(deviation) ? deviation : 0;
    if (r->surface == NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "model", "/surfaces", 0, 1,
                         "the model has no surface, expected the one of its problem");
    }
    r->nu = taut_basis_count(taut_surface_u(r->surface));
    r->nv = taut_basis_count(taut_surface_v(r->surface));
    status = read_method(details, r, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (!(r->tolerance > 0)) {
        r->tolerance = tolerance_default;
    }
    return TAUT_OK;
}

/* Where the surface passes through points. A net of its own has the known points that the surface has: that they are right is
 * another claim's. */
static taut_status read_places(const taut_model *model, request *r, taut_error *error)
{
    const size_t count = (size_t)r->nu * (size_t)r->nv;
    const taut_record *told = taut_record_get(taut_model_details(model), "through");

    if (r->problem == NULL && told != NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "needs-problem", "/details/through", taut_none,
                         taut_none,
                         "the surface was to pass through points: give the problem the model was "
                         "made from too");
    }
    if (r->problem == NULL || r->problem->net.through_count == 0) {
        return TAUT_OK;
    }
    r->arena = taut_arena_new();
    unsigned char *known = taut_arena_take(r->arena, count, 1);
    r->freed.values = taut_arena_take(r->arena, 3 * count, sizeof(double));
    r->freed.gross = taut_arena_take(r->arena, count, sizeof(double));
    if (taut_arena_status(r->arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (size_t i = 0; i < count; i++) {
        known[i] = is_known(r, (int)(i / (size_t)r->nv), (int)(i % (size_t)r->nv)) != 0;
    }
    r->net = r->problem->net;
    r->net.known = known;
    if (has_new_net(r->problem)) {
        r->net.u = taut_surface_u(r->surface);
        r->net.v = taut_surface_v(r->surface);
        r->net.points = taut_surface_points(r->surface);
    }
    return taut_certify_through_places(model, &r->net, r->arena, &r->places, error);
}

/* How much more than its own gradient says a point does: the moves of one of very little weight are as
 * long as that is small, and there its homogeneous coordinates are what is compared. */
static double reach_of(const double *weights, double heaviest, size_t at)
{
    return weights != NULL && weights[at] < little_weight * heaviest ? heaviest / weights[at] : 1;
}

static finding judge_freed(const request *r, const taut_dirichlet_gradient *gradient, double held)
{
    const double *weights = taut_surface_weights(r->surface);
    finding found = {.residual = 0};
    double unknown = 0, all = held, gross = 0, longest = 1, heaviest = 0;

    for (int k = 0; weights != NULL && k < r->nu * r->nv; k++) {
        heaviest = fmax(heaviest, weights[k]);
    }
    for (int i = 0; i < r->nu; i++) {
        for (int j = 0; j < r->nv; j++) {
            const size_t at = (size_t)i * (size_t)r->nv + (size_t)j;
            const double *g = gradient->values + 3 * at;
            const double reach = reach_of(weights, heaviest, at);
            const double size =
                reach * (r->directions != NULL ? fabs(taut_dot(r->directions + 3 * at, g))
                                               : taut_largest_coordinate(g));
            all = fmax(all, taut_largest_coordinate(g));
            if (!is_known(r, i, j)) {
                found.unknowns++;
                longest = taut_certify_max(longest, reach);
                gross = taut_certify_max(gross, reach * gradient->gross[at]);
                if (!(size <= unknown)) {
                    unknown = size;
                    found.at_u = i;
                    found.at_v = j;
                }
            }
        }
    }
    const double roundings = TAUT_UNIT_ROUNDOFF * (gradient->roundings + ROUNDINGS);
    const double parts = r->directions != NULL ? 2 : 1; /* of a vector along a direction */
    found.largest = all;
    /* a film of any size that no derivative sees is out of range */
    const double none =
        taut_half_size(taut_point_count(r->surface), taut_surface_points(r->surface)) > 0 ? NAN : 0;
    found.residual = all > 0 ? unknown / all : none;
    found.rounding = all > 0 ? parts * roundings * gross / all : 0;
    found.error = found.rounding + (all > 0 ? parts * longest * gradient->remainder / all : 0);
    found.noise = SLACK * parts * roundings * (all > 0 ? fmax(1, gross / all) : 1);
    return found;
}

/* TAUT_NO_MEMORY. */
static taut_status judge_gradient(request *r, const taut_dirichlet_gradient *gradient,
                                  finding *found)
{
    const size_t count = (size_t)r->nu * (size_t)r->nv;
    double *values = r->freed.values, *gross = r->freed.gross, held = 0;

    if (r->places == NULL) {
        *found = judge_freed(r, gradient, 0);
        return TAUT_OK;
    }
    r->freed = *gradient;
    r->freed.values = values;
    r->freed.gross = gross;
    memcpy(values, gradient->values, 3 * count * sizeof(double));
    memcpy(gross, gradient->gross, count * sizeof(double));
    const taut_status status =
        taut_certify_release(r->surface, r->net.known, r->directions, r->places,
                             r->net.through_count, values, gross, &held);
    if (status == TAUT_OK) {
        *found = judge_freed(r, &r->freed, held);
    }
    return status;
}

/* The limits that the residual may be within: rounding, the tolerance. */
static double allowed_of(const request *r, const finding *found)
{
    return fmin(fmax(found->noise, r->tolerance), largest_limit);
}

/* Are the known points of a witness those of the film, bit for bit? */
static int has_same_known(const request *r, const taut_surface *witness)
{
    const double *a = taut_surface_points(r->surface), *b = taut_surface_points(witness);
    int is_same = 1;

    for (int i = 0; i < r->nu; i++) {
        for (int j = 0; j < r->nv; j++) {
            const size_t at = 3 * ((size_t)i * (size_t)r->nv + (size_t)j);
            is_same &= !is_known(r, i, j) || memcmp(a + at, b + at, 3 * sizeof *a) == 0;
        }
    }
    return is_same;
}

/* Is the Dirichlet energy of the witness at rest where nothing is known? If not, r->unproved. */
static taut_status prove_witness(request *r, const taut_surface *witness)
{
    const double told = r->problem != NULL ? r->problem->net.aspect : 0;
    request other = *r;
    taut_gradient_rule rule = {.nodes = 0};
    taut_dirichlet_gradient gradient = {.unit = 0};
    taut_status status = taut_gradient_plan(witness, 0, told > 0 ? told : 1, r->crew, &rule);

    r->unproved = "witness: the energy of details.dirichlet is not shown to be at rest";
    other.surface = witness;
    other.directions = NULL;
    other.places = NULL; /* it passes through no points */
    if (status == TAUT_OK && rule.nodes > 0) {
        status = taut_dirichlet_gradient_new(witness, told > 0 ? told : 1, &rule, &gradient);
    }
    if (status == TAUT_OK && gradient.values != NULL) {
        finding found;
        status = judge_gradient(&other, &gradient, &found);
        if (status == TAUT_OK && found.residual + found.error <= allowed_of(r, &found)) {
            r->unproved = NULL;
        }
    }
    if (status == TAUT_OK && !has_same_known(r, witness)) {
        r->unproved = "witness: the known points of details.dirichlet are not those of the film";
    }
    taut_gradient_rule_clear(&rule);
    taut_dirichlet_gradient_clear(&gradient);
    return status;
}

/* The directions of the method "normal", from its witness. */
static taut_status find_directions(const taut_record *details, request *r, taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    const taut_surface *witness =
        taut_certify_read_net(taut_record_get(details, "dirichlet"), r->surface, arena);
    taut_status status = taut_arena_status(arena);

    if (status == TAUT_OK && witness == NULL) {
        taut_arena_free(arena);
        return taut_fail(error, TAUT_BAD_INPUT, "details", "/details/dirichlet", taut_none,
                         taut_none,
                         "the model does not tell the Dirichlet surface that its points moved "
                         "from: make it again");
    }
    r->directions = taut_alloc(3 * (size_t)r->nu * (size_t)r->nv, sizeof(double));
    if (status == TAUT_OK && r->directions != NULL) {
        status = prove_witness(r, witness);
    }
    if (status == TAUT_OK && r->directions != NULL) {
        status = taut_certify_normals(witness, r->directions);
    }
    taut_arena_free(arena);
    return status == TAUT_OK && r->directions != NULL ? TAUT_OK : taut_fail_memory(error);
}

/* The gradient by a rule whose remainder is bounded. *kind is TAUT_BOUND where that decides: what is
 * proved is within the limits, or beyond the largest of them, or its error is small beside it. */
static taut_status find_bounded(request *r, taut_gradient_rule *rule,
                                taut_dirichlet_gradient *gradient, finding *found,
                                taut_claim_kind *kind)
{
    taut_status status = taut_gradient_plan(r->surface, 1, 1, r->crew, rule);

    if (status != TAUT_OK || rule->nodes == 0) {
        return status;
    }
    status = taut_area_gradient_new(r->surface, rule, gradient);
    if (status != TAUT_OK) {
        return status;
    }
    status = judge_gradient(r, gradient, found);
    if (status != TAUT_OK) {
        return status;
    }
    if (found->residual + found->error <= allowed_of(r, found) ||
        found->error <= 0.1 * found->residual) {
        *kind = TAUT_BOUND;
        found->residual += found->error;
    } else {
        taut_dirichlet_gradient_clear(gradient);
    }
    return TAUT_OK;
}

/* Where no bound decides: nodes raised by half until the judgement stays, within the noise, or a
 * hundredth of itself; above so many Gauss points that more cost much, within a quarter of the
 * tolerance. *settled tells whether it did. */
static taut_status find_settled(request *r, taut_dirichlet_gradient *gradient, finding *found,
                                int *settled)
{
    const taut_basis *u = taut_surface_u(r->surface), *v = taut_surface_v(r->surface);
    const int local =
        taut_basis_local(u) > taut_basis_local(v) ? taut_basis_local(u) : taut_basis_local(v);
    const double spans = (double)taut_basis_span_count(u) * taut_basis_span_count(v);
    taut_gradient_rule rule = {.nodes = local + 5, .crew = r->crew};
    taut_status status = taut_area_gradient_new(r->surface, &rule, gradient);

    if (status != TAUT_OK) {
        return status;
    }
    status = judge_gradient(r, gradient, found);
    if (status != TAUT_OK) {
        return status;
    }
    while (!*settled && isfinite(found->residual) && taut_gradient_raise(&rule, gradient)) {
        const double before = found->residual;
        taut_dirichlet_gradient_clear(gradient);
        status = taut_area_gradient_new(r->surface, &rule, gradient);
        if (status != TAUT_OK) {
            return status;
        }
        status = judge_gradient(r, gradient, found);
        if (status != TAUT_OK) {
            return status;
        }
        const double apart = fabs(found->residual - before);
        const double enough = spans * rule.nodes * rule.nodes > many ? 0.25 * r->tolerance : 0;
        *settled = fmax(found->residual, before) <= found->noise ||
                   apart <= fmax(enough, fmax(found->noise, 1e-2 * found->residual));
    }
    found->nodes = rule.nodes;
    return TAUT_OK;
}

static taut_status find_gradient(request *r, taut_gradient_rule *rule,
                                 taut_dirichlet_gradient *gradient, finding *found,
                                 taut_claim_kind *kind, int *settled)
{
    if (taut_weight_spread(r->surface) > TAUT_SPREAD_MAX) {
        *found = (finding){.residual = NAN, .noise = NAN, .is_unseen = 1};
        *settled = 1;
        return TAUT_OK;
    }
    const taut_status status = find_bounded(r, rule, gradient, found, kind);

    if (status != TAUT_OK || *kind == TAUT_BOUND) {
        *settled = 1;
        return status;
    }
    return find_settled(r, gradient, found, settled);
}

/* out = the gradient where it may act: at unknown points, along the directions. */
static void find_free_part(const request *r, const taut_dirichlet_gradient *gradient, double *out)
{
    for (int i = 0; i < r->nu; i++) {
        for (int j = 0; j < r->nv; j++) {
            const size_t at = 3 * ((size_t)i * (size_t)r->nv + (size_t)j);
            const double *g = (r->places != NULL ? &r->freed : gradient)->values + at;
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
    const taut_gradient_rule rule = {.nodes = 32, .crew = r->crew};
    taut_dirichlet_gradient there = {.unit = 0};
    taut_surface *surface = NULL;
    taut_status status = move_surface(r, gradient, step, g, &surface);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_area_gradient_new(surface, &rule, &there);
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

/* *gain: no less than the same by its first and second derivatives along g, bounded. */
static taut_status find_gain_bound(const request *r, const taut_gradient_rule *rule,
                                   const taut_dirichlet_gradient *gradient, const finding *found,
                                   double *gain)
{
    const size_t count = 3 * (size_t)r->nu * (size_t)r->nv;
    double *g = taut_alloc(count, sizeof(double));
    taut_status status = TAUT_NO_MEMORY;

    if (g != NULL) {
        find_free_part(r, gradient, g);
        status = taut_certify_descent(r->surface, rule, gradient, found->error * found->largest, g,
                                      gain);
    }
    taut_free(g);
    return status;
}

static taut_status add_stationary(const request *r, const finding *found, int is_flat,
                                  taut_claim_kind kind, int settled, taut_certificate *certificate)
{
    const double given = fmin(r->tolerance, largest_limit);
    char where[128];
    taut_claim claim = {.claim = "stationary",
                        .kind = kind,
                        .residual = found->residual,
                        .limit = given,
                        .holds = TAUT_FALSE,
                        .where = where};

    snprintf(where, sizeof where, "/surfaces/0/points/%d/%d%s", found->at_u, found->at_v,
             r->problem != NULL ? "" : TAUT_KNOWN_AS_TOLD);
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
    if (kind == TAUT_CHECK && !is_flat && claim.holds == TAUT_TRUE &&
        !(found->residual + found->rounding <= claim.limit)) {
        claim.holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, "rounding may hide %.3g", found->rounding);
    }
    if (r->unproved != NULL) {
        claim.holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, "%s", r->unproved);
    }
    if (!isfinite(found->residual)) {
        claim.holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, TAUT_CERTIFY_OUT_OF_RANGE);
    }
    if (!settled && claim.holds == TAUT_FALSE) {
        claim.holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, "%d Gauss nodes do not settle the integrals", found->nodes);
    }
    if (found->unknowns == 0) {
        claim.holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, "%s%s", TAUT_KNOWN_ALL,
                 r->problem != NULL ? "" : TAUT_KNOWN_AS_TOLD);
    }
    if (found->is_unseen) {
        claim.holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, TAUT_CERTIFY_WEIGHTS_APART);
    }
    return taut_certificate_add(certificate, &claim);
}

static taut_status add_least(const request *r, const taut_mean_figures *measure,
                             taut_record *figures, taut_certificate *certificate)
{
    const taut_plateau_problem *problem = r->problem;
    const taut_least_request wanted = {
        .surface = r->surface,
        .witness = r->least,
        .boundary_only = knows_boundary_only(r),
        .is_held = r->places != NULL,
        .is_declined = problem != NULL && problem->without_least,
        .gap = problem != NULL ? problem->gap : 0,
        .area = isfinite(measure->area_error) ? measure->area : (double)NAN,
        .area_error = isfinite(measure->area_error) ? measure->area_error : 0,
        .crew = r->crew,
    };

    return taut_certify_add_least(&wanted, figures, certificate);
}

static taut_status add_figures(const request *r, taut_certificate *certificate, taut_error *error)
{
    taut_mean_figures measure;
    taut_record *figures = NULL;
    taut_status status = taut_mean_figures_of(r->surface, GRID, r->crew, &measure);

    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    figures = taut_record_new();
    taut_certify_add_integrals(figures, "area", 1, &measure.area, &measure.area_error);
    taut_record_add_number(figures, "mean_abs_mean_curvature", measure.mean_abs);
    taut_record_add_number(figures, "rms_mean_curvature", measure.rms);
    taut_record_add_number(figures, "max_abs_mean_curvature", measure.max_abs);
    status = taut_record_status(figures);
    if (status == TAUT_OK) {
        status = add_least(r, &measure, figures, certificate);
    }
    if (status == TAUT_OK && r->problem != NULL && r->problem->net.regular) {
        status = taut_certify_add_regular_of(r->surface, r->crew, certificate, figures);
    }
    status = status == TAUT_OK ? taut_record_status(figures) : status;
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
    double fitted; /* the largest distance of the certificate's own fits */
    int worst;     /* the edge with the largest distance */
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

/* How near to its curve the space of the problem lets an edge come. */
static taut_status fit_edge(const taut_plateau_problem *problem, const taut_curve *wanted, int e,
                            boundary *b, taut_error *error)
{
    taut_curve *fit = NULL;
    double bound = INFINITY;
    taut_status status = taut_certify_fit(wanted, e < 2 ? problem->net.v : problem->net.u, &fit);

    if (status == TAUT_OK) {
        status = taut_certify_distance(fit, wanted, &bound, error);
    } else if (status == TAUT_NO_MEMORY) {
        status = taut_fail_memory(error);
    } else {
        status = TAUT_OK; /* none: the limit is not known */
    }
    taut_curve_free(fit);
    b->fitted = taut_certify_max(b->fitted, bound);
    return status;
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
    if (status == TAUT_OK && r->problem->curves[e] != NULL) {
        status = fit_edge(r->problem, wanted, e, b, error);
    }
    taut_curve_free(wanted);
    taut_curve_free(found);
    return status;
}

static taut_status add_boundary(const request *r, taut_certificate *certificate, taut_error *error)
{
    static const char *const names[4] = {"u0", "u1", "v0", "v1"};
    boundary b = {.size = 0};

    for (int e = 0; e < 4; e++) {
        const taut_status status = check_edge(r, e, &b, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    b.roundings *= 1 + taut_norm(b.origin) / b.size; /* of points as they are stored */
    const double told = r->deviation / b.size, rounding = 64 * b.roundings * TAUT_UNIT_ROUNDOFF;
    taut_claim claim = {
        .claim = "boundary",
        .kind = TAUT_BOUND,
        .residual = b.distance / b.size,
        .limit = FIT * b.fitted / b.size + rounding,
        .where = names[b.worst],
    };
    claim.holds = taut_certify_below(claim.residual, claim.limit);
    if (claim.holds == TAUT_UNDECIDED) {
        claim.where = "the certificate's own fit fails";
    } else if (claim.holds == TAUT_TRUE && r->deviation > 0 &&
               !(told <= claim.residual + rounding && claim.residual <= 1.25 * told + rounding)) {
        claim.holds = TAUT_FALSE;
        claim.where = "/details/deviation is not what is found";
    }
    return taut_certificate_add(certificate, &claim) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

/* Is the area flat along the steepest descent? By a bound where there is one, else by a difference
 * of gradients: then *kind becomes TAUT_CHECK. */
static taut_status judge_flatness(const request *r, const taut_gradient_rule *rule,
                                  const taut_dirichlet_gradient *gradient, const finding *found,
                                  int *is_flat, taut_claim_kind *kind)
{
    double gain = INFINITY;
    taut_status status = TAUT_OK;

    if (*kind == TAUT_BOUND) {
        status = find_gain_bound(r, rule, gradient, found, &gain);
        *is_flat = gain < flat;
    }
    if (status == TAUT_OK && !*is_flat) {
        status = find_gain(r, gradient, found->residual, &gain);
        *is_flat = gain < flat;
        *kind = *is_flat ? TAUT_CHECK : *kind;
    }
    return status;
}

/* The claim `stationary`. */
static taut_status prove_stationary(request *r, taut_dirichlet_gradient *gradient,
                                    taut_certificate *certificate)
{
    finding found = {.residual = 0};
    taut_gradient_rule rule = {.nodes = 0};
    taut_claim_kind kind = TAUT_CHECK;
    int settled = 0, is_flat = 0;
    taut_status status = find_gradient(r, &rule, gradient, &found, &kind, &settled);

    if (status == TAUT_OK && found.residual > r->tolerance && found.residual <= largest_limit) {
        status = judge_flatness(r, &rule, gradient, &found, &is_flat, &kind);
    }
    taut_gradient_rule_clear(&rule);
    return status == TAUT_OK ? add_stationary(r, &found, is_flat, kind, settled, certificate)
                             : status;
}

static taut_status prove(request *r, taut_certificate *certificate, taut_error *error)
{
    taut_dirichlet_gradient gradient = {.unit = 0};
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
    if (r->places != NULL &&
        taut_certify_add_through(r->surface, &r->net, r->places, certificate) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return add_figures(r, certificate, error);
}

static taut_status certify(const taut_model *model, const void *data, const taut_audit *audit,
                           taut_certificate *certificate, taut_error *error)
{
    request r = {.crew = &audit->crew};
    taut_status status = read_request(model, data, &r, error);

    if (status == TAUT_OK) {
        status = read_places(model, &r, error);
    }
    if (status == TAUT_OK && r.is_normal) {
        status = find_directions(taut_model_details(model), &r, error);
    }
    if (status == TAUT_OK) {
        status = prove(&r, certificate, error);
    }
    taut_free(r.directions);
    taut_arena_free(r.arena);
    return status;
}

/* Knots may have been put in; where the problem has no such wish, `known` compares the bases. */
static void identify(const taut_model *model, const void *data, taut_identity *identity)
{
    const taut_plateau_problem *problem = data;
    taut_expected_basis u = {.same = NULL}, v = u;
    const char *name = NULL;

    (void)model;
    if (problem != NULL && has_new_net(problem)) {
        u.refined = problem->net.u;
        v.refined = problem->net.v;
    } else if (problem != NULL) {
        u.same = problem->net.u;
        v.same = problem->net.v;
    }
    if (problem != NULL) {
        name = problem->net.name != NULL ? problem->net.name : "plateau";
    }
    taut_identity_surface(identity, 0, name, &u, &v);
}

const taut_certify_ops taut_certify_plateau = {.certify = certify, .identify = identify};

taut_status taut_plateau_certify(const taut_model *model, const taut_plateau_problem *problem,
                                 const taut_certify_options *options,
                                 taut_certificate **certificate, taut_error *error)
{
    return taut_certify_with(&taut_certify_plateau, "plateau", model, problem, options, certificate,
                             error);
}
