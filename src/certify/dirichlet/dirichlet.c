/* dirichlet.c -- is this the surface of least Dirichlet energy through its known points?
 *
 * D is convex in the points, so it is least exactly where its partial derivatives at the unknown
 * points vanish ([WuWang2011] section 2.4). Claims:
 *
 *   stationary  largest |dD/dP| at an unknown point over the largest at any point, by quadrature of
 *               the gradient (certify/dirichlet/gradient.h). Limit
 *
 *                   min(ROUNDINGS 2^-53 max(1, G/g), 1e-6),
 *
 *               G the largest gross sum at an unknown point, g the largest derivative: storing the
 *               points in doubles leaves 2^-53 G, and summing leaves a few times that.
 *               Where the problem passes through points, the part that holds the surface there is taken
 *               off first (certify/common/through.h).
 *   known       largest distance of a known point from the problem's, over their size; 0 exactly.
 *   through     the largest distance from a point to pass through (certify/common/through.h).
 *   aspect      where the aspect was searched for: |log(lambda^2 iint |x_u|^2 / iint |x_v|^2)|
 *               (section 7.3), with the remainder of the rule and rounding.
 *   regular     where the problem asks (certify/common/regular.h).
 */
#include "taut/dirichlet.h"

#include "certify/certify_ops.h"
#include "certify/common/figures.h"
#include "certify/common/known.h"
#include "certify/common/regular.h"
#include "certify/common/through.h"
#include "certify/common/verdict.h"
#include "certify/dirichlet/gradient.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "geometry/exponent.h"
#include "geometry/keep.h"
#include "geometry/nurbs/spread.h"
#include "measure/integrate/integrals.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ROUNDINGS = 4, SLACK = 2 };
static const double largest_limit = 1e-6;

/* What is certified. */
typedef struct request {
    const taut_surface *surface;
    const taut_dirichlet_problem *problem; /* or NULL */
    int nu, nv;
    int boundary_only; /* without a problem: the boundary is known; else every point is */
    double aspect;
    int has_aspect, is_searched;
    const taut_crew *crew;
    taut_arena *arena;    /* of what follows */
    taut_through *places; /* to pass through, with parameters; NULL: none */
    int place_count;
} request;

static int is_known(const request *r, int i, int j)
{
    if (r->problem != NULL) {
        return r->problem->known[(size_t)i * (size_t)r->nv + (size_t)j] != 0;
    }
    return !r->boundary_only || i == 0 || j == 0 || i == r->nu - 1 || j == r->nv - 1;
}

static taut_status ask_for_problem(const char *where, const char *why, taut_error *error)
{
    return taut_fail(error, TAUT_BAD_INPUT, "needs-problem", where, taut_none, taut_none,
                     "%s: give the problem the model was made from too", why);
}

/* Which points are known, when only the model is there. */
static taut_status read_details(const taut_model *model, request *r, taut_error *error)
{
    const taut_record *details = taut_model_details(model);
    const char *known = taut_record_text(taut_record_get(details, "known"));

    if (taut_record_get(details, "through") != NULL) {
        return ask_for_problem("/details/through", "the surface was to pass through points", error);
    }

    r->boundary_only = strcmp(known, "boundary") == 0;
    if (!r->boundary_only && strcmp(known, "all") != 0) {
        return ask_for_problem("/details/known", "the model does not say which points were known",
                               error);
    }
    return TAUT_OK;
}

/* The aspect the problem gives, or the one the model says was found. */
static taut_status read_aspect(const taut_model *model, request *r, taut_error *error)
{
    const taut_record *said = taut_record_get(taut_model_details(model), "aspect");
    const int given = r->problem != NULL && !r->problem->aspect_auto;

    r->aspect = given ? r->problem->aspect : taut_record_number(said);
    r->has_aspect = given ? r->problem->aspect > 0 : said != NULL;
    r->is_searched = r->problem != NULL && r->problem->aspect_auto;
    if (!r->has_aspect && !r->is_searched) {
        r->aspect = 1;
    }
    if (!(r->aspect > 0) || !isfinite(r->aspect)) {
        return taut_fail(error, TAUT_BAD_INPUT, "details", "/details/aspect", r->aspect, 0,
                         "the model does not say which aspect it was made with, expected a "
                         "positive number");
    }
    return TAUT_OK;
}

static taut_status read_request(const taut_model *model, const taut_dirichlet_problem *problem,
                                request *r, taut_error *error)
{
    taut_status status = TAUT_OK;

    if (problem != NULL && !taut_known_is_whole(problem)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "the problem needs two bases, points and which of them are known");
    }
    r->surface = taut_model_surface(model, 0);
    r->problem = problem;
    if (r->surface == NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "model", "/surfaces", 0, 1,
                         "the model has no surface, expected the one of its problem");
    }
    r->nu = taut_basis_count(taut_surface_u(r->surface));
    r->nv = taut_basis_count(taut_surface_v(r->surface));
    if (problem == NULL) {
        status = read_details(model, r, error);
        if (status != TAUT_OK) {
            return status;
        }
    } else if (taut_basis_count(problem->u) != r->nu || taut_basis_count(problem->v) != r->nv) {
        return taut_fail(error, TAUT_BAD_INPUT, "model", "/surfaces/0/points", taut_none, taut_none,
                         "the model's net is %d by %d, the problem's %d by %d: they do not "
                         "belong together",
                         r->nu, r->nv, taut_basis_count(problem->u), taut_basis_count(problem->v));
    }
    if (problem != NULL && problem->through_count > 0) {
        r->place_count = problem->through_count;
        r->arena = taut_arena_new();
        status = taut_certify_through_places(model, problem, r->arena, &r->places, error);
    }
    return status == TAUT_OK ? read_aspect(model, r, error) : status;
}

/* What a gradient says: the largest derivatives, and the rounding to be expected. */
typedef struct finding {
    double residual, limit, noise;
    double rounding; /* the residual may be that much more for rounding */
    double error;    /* proved: it is at most that much more for all that is not exact */
    int at_u, at_v;
    int unknowns;
    int nodes;     /* of the last rule, where none is bounded */
    int is_unseen; /* weights are too far apart for any */
} finding;

/* How much more than its own gradient says the point does: moves of a point of little weight are as
 * long as that is small, so that its homogeneous coordinates are what is compared. */
static double reach_of(const double *weights, double heaviest, size_t at)
{
    return weights != NULL ? heaviest / weights[at] : 1;
}

static finding judge_released(const request *r, const taut_dirichlet_gradient *gradient,
                              double held)
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
            const double size = taut_largest_coordinate(gradient->values + 3 * at);
            const double reach = reach_of(weights, heaviest, at);
            all = fmax(all, size);
            if (!is_known(r, i, j)) {
                found.unknowns++;
                longest = taut_certify_max(longest, reach);
                gross = taut_certify_max(gross, reach * gradient->gross[at]);
                if (!(reach * size <= unknown)) {
                    unknown = reach * size;
                    found.at_u = i;
                    found.at_v = j;
                }
            }
        }
    }
    const double roundings = TAUT_UNIT_ROUNDOFF * (gradient->roundings + ROUNDINGS);
    /* a net of any size that no derivative sees is out of range */
    const double none =
        taut_half_size(taut_point_count(r->surface), taut_surface_points(r->surface)) > 0 ? NAN : 0;
    found.residual = all > 0 ? unknown / all : none;
    found.rounding = all > 0 ? roundings * gross / all : 0;
    found.error = found.rounding + (all > 0 ? longest * gradient->remainder / all : 0);
    found.noise = SLACK * roundings * (all > 0 ? fmax(1, gross / all) : 1);
    found.limit = fmin(found.noise, largest_limit);
    return found;
}

/* TAUT_NO_MEMORY. */
static taut_status judge_gradient(const request *r, taut_dirichlet_gradient *gradient,
                                  finding *found)
{
    double held = 0;
    const taut_status status =
        r->place_count == 0
            ? TAUT_OK
            : taut_certify_release(r->surface, r->problem->known, NULL, r->places, r->place_count,
                                   gradient->values, gradient->gross, &held);

    if (status == TAUT_OK) {
        *found = judge_released(r, gradient, held);
    }
    return status;
}

/* Does what is proved about the residual decide the claim? */
static int is_decided(const finding *found)
{
    return found->residual + found->error <= found->limit ||
           found->residual - found->error > found->limit;
}

/* The gradient by a rule whose remainder is bounded. *kind is TAUT_BOUND where that decides. */
static taut_status find_bounded(const request *r, taut_dirichlet_gradient *gradient, finding *found,
                                taut_claim_kind *kind)
{
    taut_gradient_rule rule = {.nodes = 0};
    taut_status status = taut_gradient_plan(r->surface, 0, r->aspect, r->crew, &rule);

    if (status != TAUT_OK || rule.nodes == 0) {
        return status;
    }
    status = taut_dirichlet_gradient_new(r->surface, r->aspect, &rule, gradient);
    taut_gradient_rule_clear(&rule);
    if (status != TAUT_OK) {
        return status;
    }
    status = judge_gradient(r, gradient, found);
    if (status != TAUT_OK) {
        return status;
    }
    if (is_decided(found)) {
        *kind = TAUT_BOUND;
        found->residual += found->error;
    } else {
        taut_dirichlet_gradient_clear(gradient);
    }
    return TAUT_OK;
}

/* Where no bound decides: nodes raised by half until the judgement stays, within the limit twice, or
 * by a quarter of what is found or allowed. *settled tells whether it did. */
static taut_status find_settled(const request *r, taut_dirichlet_gradient *gradient, finding *found,
                                int *settled)
{
    const taut_basis *u = taut_surface_u(r->surface), *v = taut_surface_v(r->surface);
    const int local =
        taut_basis_local(u) > taut_basis_local(v) ? taut_basis_local(u) : taut_basis_local(v);
    taut_gradient_rule rule = {.nodes = local + 6, .crew = r->crew};
    taut_status status = taut_dirichlet_gradient_new(r->surface, r->aspect, &rule, gradient);

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
        status = taut_dirichlet_gradient_new(r->surface, r->aspect, &rule, gradient);
        if (status != TAUT_OK) {
            return status;
        }
        status = judge_gradient(r, gradient, found);
        if (status != TAUT_OK) {
            return status;
        }
        *settled = fabs(found->residual - before) <=
                       fmax(0.25 * found->limit, 0x1p-10 * fmin(found->residual, before)) ||
                   fmax(found->residual, before) <= found->limit;
    }
    found->nodes = rule.nodes;
    return TAUT_OK;
}

static taut_status find_gradient(const request *r, taut_dirichlet_gradient *gradient,
                                 finding *found, taut_claim_kind *kind, int *settled)
{
    if (taut_weight_spread(r->surface) > TAUT_SPREAD_MAX) {
        *found = (finding){.residual = NAN, .limit = largest_limit, .noise = NAN, .is_unseen = 1};
        *settled = 1;
        return TAUT_OK;
    }
    const taut_status status = find_bounded(r, gradient, found, kind);

    if (status != TAUT_OK || *kind == TAUT_BOUND) {
        *settled = 1;
        return status;
    }
    return find_settled(r, gradient, found, settled);
}

static taut_status add_stationary(const request *r, const finding *found, taut_claim_kind kind,
                                  int settled, taut_certificate *certificate)
{
    char where[128];
    taut_claim claim = {.claim = "stationary",
                        .kind = kind,
                        .residual = found->residual,
                        .limit = found->limit,
                        .holds = taut_certify_below(found->residual, found->limit),
                        .where = where};

    snprintf(where, sizeof where, "/surfaces/0/points/%d/%d%s", found->at_u, found->at_v,
             r->problem != NULL ? "" : TAUT_KNOWN_AS_TOLD);
    if (claim.holds == TAUT_UNDECIDED) {
        snprintf(where, sizeof where, TAUT_CERTIFY_OUT_OF_RANGE);
    } else if (claim.holds == TAUT_FALSE && found->residual <= found->noise) {
        claim.holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, "the rounding of the points alone may leave %.3g",
                 found->noise);
    }
    if (kind == TAUT_CHECK && claim.holds == TAUT_TRUE &&
        !(found->residual + found->rounding <= found->limit)) {
        claim.holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, "rounding may hide %.3g", found->rounding);
    }
    if (!settled) {
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

/* What the logarithm of lambda^2 iint |x_u|^2 / iint |x_v|^2 may be off by. As x_u = sum phi_u P, the
 * rule for iint |x_u|^2 = sum P . iint phi_u x_u misses no more than 3 count |P| times what it misses
 * of the gradient, whose bound is that of both parts apart; |P| < 1 about the first point. Then
 * rounding of the slopes, and of the sum of the terms. */
static double aspect_error(const request *r, const taut_dirichlet_gradient *g)
{
    const taut_basis *u = taut_surface_u(r->surface), *v = taut_surface_v(r->surface);
    const double form =
        r->aspect * (taut_basis_hi(v) - taut_basis_lo(v)) / (taut_basis_hi(u) - taut_basis_lo(u));
    const double roundings = TAUT_UNIT_ROUNDOFF * (g->roundings + ROUNDINGS);
    const double terms = TAUT_UNIT_ROUNDOFF * (g->points + 16);
    const double missed = 3.0 * r->nu * r->nv * g->remainder * fmax(form, 1 / form);
    const double a = (missed / r->aspect + roundings * g->halves_gross[0]) / g->halves[0] + terms;
    const double b = (missed * r->aspect + roundings * g->halves_gross[1]) / g->halves[1] + terms;
    /* |log(1 + x)| <= |x| / (1 - |x|); and rounding of the logarithms */
    return a < 0.5 && b < 0.5 ? a / (1 - a) + b / (1 - b) + 8 * TAUT_UNIT_ROUNDOFF : INFINITY;
}

/* lambda^2 iint |x_u|^2 = iint |x_v|^2. The points carry the rounding that `stationary` allows for;
 * it weighs more in the lesser integral, by the root of their ratio over the unit square. */
static taut_status add_aspect(const request *r, const taut_dirichlet_gradient *gradient,
                              const finding *found, taut_claim_kind kind,
                              taut_certificate *certificate)
{
    const taut_basis *u = taut_surface_u(r->surface), *v = taut_surface_v(r->surface);
    const double ratio =
        (taut_basis_hi(v) - taut_basis_lo(v)) / (taut_basis_hi(u) - taut_basis_lo(u)) * r->aspect;
    const double a = gradient->halves[0], b = gradient->halves[1];
    taut_claim claim = {.claim = "aspect", .kind = TAUT_CHECK, .where = ""};

    claim.residual =
        a == 0 && b == 0 ? 0 : fabs(2 * taut_log(r->aspect) + taut_log(a) - taut_log(b));
    claim.limit = fmin(found->noise * (1 + fmax(ratio, 1 / ratio)), largest_limit);
    claim.holds = taut_certify_below(claim.residual, claim.limit);
    if (kind == TAUT_BOUND) { /* the rule's remainder is known */
        const double error = a == 0 && b == 0 ? 0 : aspect_error(r, gradient);
        if (claim.residual + error <= claim.limit || claim.residual - error > claim.limit) {
            claim.kind = TAUT_BOUND;
            claim.residual += claim.holds == TAUT_TRUE ? error : 0;
        }
    }
    if (found->is_unseen) {
        claim.kind = TAUT_CHECK;
        claim.residual = NAN;
        claim.holds = TAUT_UNDECIDED;
        claim.where = TAUT_CERTIFY_WEIGHTS_APART;
    }
    return taut_certificate_add(certificate, &claim);
}

static taut_status add_figures(const request *r, const taut_dirichlet_gradient *gradient,
                               taut_certificate *certificate)
{
    const double a = gradient->halves[0], b = gradient->halves[1];
    taut_surface_integrals found;
    taut_status status = taut_surface_integrals_of(r->surface, 1, r->crew, &found);
    taut_record *figures = NULL;

    if (status != TAUT_OK) {
        return status;
    }
    figures = taut_record_new();
    taut_certify_add_integrals(figures, "dirichlet_energy", 1, &found.dirichlet,
                               &found.dirichlet_error);
    taut_certify_add_integrals(figures, "area", 1, &found.area, &found.area_error);
    taut_certify_add_integrals(figures, "isothermality", 1, &found.isothermality,
                               &found.isothermality_error);
    if (r->has_aspect) {
        const double share = a + b > 0 ? (r->aspect * a + b / r->aspect) / (a + b) : 1;
        taut_record_add_number(figures, "aspect_energy", found.dirichlet * share);
    }
    if (r->problem != NULL && r->problem->regular) {
        status = taut_certify_add_regular_of(r->surface, r->crew, certificate, figures);
    }
    status = status == TAUT_OK ? taut_record_status(figures) : status;
    taut_certificate_set_figures(certificate, figures);
    return status;
}

static taut_status add_claims(const request *r, taut_dirichlet_gradient *gradient,
                              taut_certificate *certificate)
{
    finding found = {.residual = 0};
    taut_claim_kind kind = TAUT_CHECK;
    int settled = 0;
    taut_status status = find_gradient(r, gradient, &found, &kind, &settled);

    if (status != TAUT_OK) {
        return status;
    }
    status = add_stationary(r, &found, kind, settled, certificate);
    if (status != TAUT_OK) {
        return status;
    }
    if (r->problem != NULL) {
        status = taut_certify_add_known(r->surface, r->problem, certificate);
        if (status != TAUT_OK) {
            return status;
        }
    }
    if (r->place_count > 0) {
        status = taut_certify_add_through(r->surface, r->problem, r->places, certificate);
        if (status != TAUT_OK) {
            return status;
        }
    }
    if (r->is_searched) {
        status = add_aspect(r, gradient, &found, kind, certificate);
        if (status != TAUT_OK) {
            return status;
        }
    }
    return add_figures(r, gradient, certificate);
}

static taut_status certify(const taut_model *model, const void *data, const taut_audit *audit,
                           taut_certificate *certificate, taut_error *error)
{
    taut_dirichlet_gradient gradient = {.unit = 0};
    request r = {.arena = NULL, .crew = &audit->crew};
    taut_status status = read_request(model, data, &r, error);

    if (status == TAUT_OK) {
        status = add_claims(&r, &gradient, certificate);
        taut_dirichlet_gradient_clear(&gradient);
        status = status == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
    }
    taut_arena_free(r.arena);
    return status;
}

static void identify(const taut_model *model, const void *data, taut_identity *identity)
{
    const taut_dirichlet_problem *problem = data;
    taut_expected_basis u = {.same = NULL}, v = u;
    const char *name = NULL;

    (void)model;
    if (problem != NULL) {
        u.same = problem->u;
        v.same = problem->v;
        name = problem->name != NULL ? problem->name : "dirichlet";
    }
    taut_identity_surface(identity, 0, name, &u, &v);
}

const taut_certify_ops taut_certify_dirichlet = {.certify = certify, .identify = identify};

taut_status taut_dirichlet_certify(const taut_model *model, const taut_dirichlet_problem *problem,
                                   const taut_certify_options *options,
                                   taut_certificate **certificate, taut_error *error)
{
    return taut_certify_with(&taut_certify_dirichlet, "dirichlet", model, problem, options,
                             certificate, error);
}
