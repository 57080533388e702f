/* bonnet.c -- is this a minimal surface in isothermal parameters, and the one that was asked for?
 * Claims, over all surfaces of the model:
 *
 *   isothermal, harmonic, minimal   bounds of |E-G|/E and |F|/E, of |r_uu + r_vv| over the second
 *                 derivatives, of |H|/sqrt|K| over the whole of every span (proof.c); undecided on
 *                 bases that no such surface is told in
 *   smooth        the spans are one surface (smooth.c)
 *   algebraic     the relations that make a net on these bases minimal everywhere
 *                 (algebra.c); left out on other bases
 *   formula       with the problem: a bound of the distance from its surface over the largest
 *                 coordinate (closed.c)
 *   closed-form   with the problem: relative difference of area and total curvature, by quadrature,
 *                 from those in closed form (closed.c)
 *
 * Limit of each: min(c noise, 1e-6), c its number of `roundings` (4 of those in proof.c), noise what
 * rounding explains (parts.h). What lies between that limit and c noise is undecided; `algebraic` and
 * `closed-form`, which rounding spoils first, are left out where they could not hold the surface to
 * 1e-6. All is judged at size 1: surfaces far from it are brought there by a power of two first.
 */
#include "taut/bonnet.h"

#include "certify/bonnet/parts.h"
#include "certify/bonnet/proof.h"
#include "certify/certify_ops.h"
#include "certify/common/unit.h"
#include "certify/common/verdict.h"
#include "core/fail.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double largest_limit = 1e-6;

enum { ALGEBRAIC, FORMULA, CLOSED_FORM, CLAIMS };
enum { SMOOTH = TAUT_BONNET_PROVED, PROVED }; /* the claims with a proof each */

/* How many roundings the sums of sixteen products of three, and of all terms of a point, may add up
 * to, claim by claim. Over random problems of the whole range at most 0.8 of each was seen
 * (tests/property/test_bonnet.c). */
static const double roundings[CLAIMS] = {6, 2, 5};

/* Cuts of the integrals: of a surface that is none of these, few, as its area may have no end. */
enum { CUTS = 4000, FEW_CUTS = 100 };

/* A claim over several surfaces: the largest residual and noise, and where. */
typedef struct gathered {
    const char *claim;
    taut_bonnet_finding found;
    const char *surface;
    int seen;           /* surfaces that it was judged on */
    const char *hidden; /* one that rounding hides, or NULL */
} gathered;

typedef struct report {
    taut_bonnet_proof proofs[PROVED];
    const char *told[PROVED]; /* the surface that each tells of */
    gathered claims[CLAIMS];
    taut_record *figures; /* lists area, total_gaussian_curvature */
    taut_record *area, *curvature;
} report;

static void gather(gathered *all, const taut_bonnet_finding *one, const char *surface)
{
    if (all->seen == 0 || one->residual > all->found.residual) {
        all->surface = surface;
    }
    taut_bonnet_raise(&all->found, one->residual, one->noise, one->at[0], one->at[1]);
    all->seen++;
}

/* The lambda of surface i of n. */
static double lambda_of(const taut_bonnet_problem *problem, int i, int n)
{
    const double *l = problem->lambda;
    return n == 1 ? l[0] : i + 1 == n ? l[1] : l[0] + (l[1] - l[0]) * i / (n - 1);
}

static double relative(double a, double b)
{
    return a == b ? 0 : fabs(a - b) / fabs(b);
}

/* The figures of one surface against closed forms: of area and curvature, and over all surfaces,
 * the one that comes nearest to its limit is told. */
static void compare_closed(const taut_bonnet_frame *frame, const taut_bonnet_integrals *found,
                           const char *surface, gathered *all)
{
    double exact[2], noise[2];

    taut_bonnet_closed_area(frame, &exact[0], &noise[0]);
    taut_bonnet_closed_curvature(frame, &exact[1], &noise[1]);
    for (int k = 0; k < 2; k++) {
        taut_bonnet_finding one = {0, 0, {0, 0}};
        taut_bonnet_raise(&one, relative(found->value[k], exact[k]), noise[k] + found->noise[k], 0,
                          0);
        if (roundings[CLOSED_FORM] * one.noise > largest_limit) {
            continue;
        }
        if (all->seen == 0 || one.residual * all->found.noise > all->found.residual * one.noise) {
            all->found = one;
            all->surface = surface;
        }
        all->seen++;
    }
}

/* The claims that are proved, of one surface; points times 2^-unit are about 1. */
static void prove(const taut_surface *surface, const taut_bonnet_scale *scale, report *r)
{
    const char *name = taut_surface_name(surface);
    const taut_bonnet_proof before = r->proofs[SMOOTH];
    const int told = taut_bonnet_prove(surface, scale, 0, r->proofs);
    double sign = 0;

    for (int k = 0; k < TAUT_BONNET_PROVED; k++) {
        r->told[k] = r->told[k] == NULL || (told & 1 << k) ? name : r->told[k];
    }
    if (taut_bonnet_sign_of(taut_surface_u(surface), &sign) &&
        taut_bonnet_sign_of(taut_surface_v(surface), &sign)) {
        taut_bonnet_smooth(surface, scale, 0, &r->proofs[SMOOTH]);
    }
    if (r->told[SMOOTH] == NULL || before.holds != r->proofs[SMOOTH].holds ||
        before.residual != r->proofs[SMOOTH].residual) {
        r->told[SMOOTH] = name;
    }
}

static int is_refuted(const report *r)
{
    int refuted = 0;
    for (int k = 0; k < PROVED; k++) {
        refuted |= r->proofs[k].holds != TAUT_TRUE;
    }
    return refuted;
}

/* Area and total curvature of a surface that was made 2^-unit times as large. */
int taut_bonnet_is_algebraic(const taut_surface *surface)
{
    taut_bonnet_finding found = {0, 0, {0, 0}};
    taut_bonnet_proof smooth = {.holds = TAUT_TRUE};
    taut_bonnet_scale scale;
    double sign = 0;

    if (taut_surface_weights(surface) != NULL ||
        !taut_bonnet_sign_of(taut_surface_u(surface), &sign) ||
        !taut_bonnet_sign_of(taut_surface_v(surface), &sign)) {
        return 0;
    }
    taut_bonnet_scale_of(surface, 0, &scale);
    if (!taut_bonnet_algebra(surface, &scale, &found) ||
        !(found.residual <= fmin(roundings[ALGEBRAIC] * found.noise, largest_limit))) {
        return 0;
    }
    taut_bonnet_smooth(surface, &scale, 0, &smooth);
    return smooth.holds == TAUT_TRUE;
}

static taut_status measure(const taut_surface *surface, const taut_bonnet_scale *scale, int few,
                           taut_bonnet_integrals *integrals)
{
    taut_arena *arena = taut_arena_new();
    const taut_status status =
        arena != NULL
            ? taut_bonnet_integrate(surface, scale, arena, few ? FEW_CUTS : CUTS, integrals)
            : TAUT_NO_MEMORY;
    taut_arena_free(arena);
    return status;
}

/* One surface for all claims, its points about 1 in size, 2^-unit of the model's; frame NULL:
 * without the problem. */
static taut_status gather_unit(const taut_surface *surface, int unit,
                               const taut_bonnet_frame *frame, int is_exact, report *r)
{
    const char *name = taut_surface_name(surface);
    taut_bonnet_integrals integrals;
    taut_bonnet_finding other = {0, 0, {0, 0}};
    taut_bonnet_scale scale;
    taut_status status = TAUT_OK;

    taut_bonnet_scale_of(surface, is_exact, &scale);
    prove(surface, &scale, r);
    status = measure(surface, &scale, is_refuted(r), &integrals);
    if (status != TAUT_OK) {
        return status;
    }
    if (taut_bonnet_algebra(surface, &scale, &other)) {
        if (roundings[ALGEBRAIC] * other.noise <= largest_limit) {
            gather(&r->claims[ALGEBRAIC], &other, name);
        } else {
            r->claims[ALGEBRAIC].hidden = name;
        }
    }
    integrals.value[0] = ldexp(integrals.value[0], 2 * unit);
    if (frame != NULL) {
        compare_closed(frame, &integrals, name, &r->claims[CLOSED_FORM]);
    }
    taut_record_add_number(r->area, NULL, integrals.value[0]);
    taut_record_add_number(r->curvature, NULL, integrals.value[1]);
    return status;
}

/* Squares of coordinates up to this size, and those of their derivatives, are in range. */
enum { USUAL_UNIT = 256 };

static taut_status gather_surface(const taut_surface *surface, const taut_bonnet_frame *frame,
                                  int is_exact, report *r)
{
    const int unit = taut_certify_unit_of(surface);
    taut_surface *scaled = NULL;
    taut_status status = TAUT_OK;

    if (frame != NULL) {
        taut_bonnet_finding other = {0, 0, {0, 0}};
        taut_bonnet_scale scale;
        taut_bonnet_scale_of(surface, is_exact, &scale);
        taut_bonnet_against_formula(surface, &scale, frame, &other);
        gather(&r->claims[FORMULA], &other, taut_surface_name(surface));
    }
    if (abs(unit) <= USUAL_UNIT) {
        return gather_unit(surface, 0, frame, is_exact, r);
    }
    status = taut_certify_scaled(surface, unit, &scaled);
    if (status == TAUT_OK) {
        status = gather_unit(scaled, unit, frame, is_exact, r);
    }
    for (int k = 0; status == TAUT_OK && k < PROVED; k++) { /* names live as long as the model */
        r->told[k] =
            r->told[k] == taut_surface_name(scaled) ? taut_surface_name(surface) : r->told[k];
    }
    for (int k = 0; status == TAUT_OK && k < CLAIMS; k++) {
        gathered *all = &r->claims[k];
        all->surface =
            all->surface == taut_surface_name(scaled) ? taut_surface_name(surface) : all->surface;
        all->hidden =
            all->hidden == taut_surface_name(scaled) ? taut_surface_name(surface) : all->hidden;
    }
    taut_surface_free(scaled);
    return status;
}

static taut_status add_proof(const char *name, const taut_bonnet_proof *proof, const char *surface,
                             taut_certificate *certificate)
{
    char where[TAUT_NAME_MAX + 160];
    const taut_claim claim = {.claim = name,
                              .kind = TAUT_BOUND,
                              .residual = proof->residual,
                              .limit = proof->limit,
                              .holds = proof->holds,
                              .where = where};

    snprintf(where, sizeof where, "%s at (%.6g, %.6g)", surface, proof->at[0], proof->at[1]);
    if (proof->holds == TAUT_UNDECIDED) {
        snprintf(where, sizeof where, "%s in %s", proof->why, surface);
    } else if (strcmp(name, "smooth") == 0 && proof->residual == 0) {
        where[0] = '\0';
    }
    return taut_certificate_add(certificate, &claim);
}

static taut_status add_claim(const gathered *all, taut_claim_kind kind, double factor,
                             taut_certificate *certificate)
{
    const double noise = factor * all->found.noise;
    char where[TAUT_NAME_MAX + 96];
    taut_claim claim = {.claim = all->claim,
                        .kind = kind,
                        .residual = all->found.residual,
                        .limit = fmin(noise, largest_limit),
                        .holds = TAUT_FALSE,
                        .where = where};

    snprintf(where, sizeof where, "%s", all->surface);
    if (strcmp(all->claim, "closed-form") != 0) {
        snprintf(where, sizeof where, "%s at (%.6g, %.6g)", all->surface, all->found.at[0],
                 all->found.at[1]);
    }
    if (claim.residual <= claim.limit) {
        claim.holds = TAUT_TRUE;
    } else if (claim.residual <= noise) {
        claim.holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, "warning: rounding alone may leave %.3g in %s", noise,
                 all->surface);
    }
    if (claim.holds == TAUT_TRUE && all->hidden != NULL) {
        claim.holds = TAUT_UNDECIDED;
        snprintf(where, sizeof where, "warning: rounding hides it in %s", all->hidden);
    }
    return taut_certificate_add(certificate, &claim);
}

/* Figures: one number, or a list for several surfaces. */
static taut_status add_figures(const report *r, taut_certificate *certificate)
{
    static const char *const names[2] = {"area", "total_gaussian_curvature"};
    const taut_record *const lists[2] = {r->area, r->curvature};
    taut_record *figures = taut_record_new();
    taut_status status = TAUT_OK;

    for (int i = 0; i < 2; i++) {
        if (taut_record_count(lists[i]) == 1) {
            taut_record_add_number(figures, names[i],
                                   taut_record_number(taut_record_at(lists[i], 0)));
        } else {
            taut_record_add_record(figures, names[i], lists[i]);
        }
    }
    status = taut_record_status(figures);
    taut_certificate_set_figures(certificate, figures);
    return status;
}

static taut_status check_surfaces(const taut_model *model, const taut_bonnet_problem *problem,
                                  taut_error *error)
{
    const int count = taut_model_surface_count(model);
    const int wanted = problem == NULL ? count : problem->frames > 1 ? problem->frames : 1;

    if (count == 0 || count != wanted) {
        return taut_fail(error, TAUT_BAD_INPUT, "model", "/surfaces", count,
                         wanted > 0 ? wanted : 1,
                         "the model has %d surfaces, expected %d: they do not belong together",
                         count, wanted > 0 ? wanted : 1);
    }
    for (int i = 0; i < count; i++) {
        if (taut_surface_weights(taut_model_surface(model, i)) != NULL) {
            char where[64];
            snprintf(where, sizeof where, "/surfaces/%d/weights", i);
            return taut_fail(error, TAUT_BAD_INPUT, "model", where, taut_none, taut_none,
                             "a surface of this kind has no weights");
        }
    }
    return TAUT_OK;
}

static taut_status gather_all(const taut_model *model, const taut_bonnet_problem *problem,
                              report *r)
{
    const int count = taut_model_surface_count(model);
    const int is_exact =
        problem != NULL ? problem->normalize
                        : taut_record_bool(taut_record_get(taut_model_details(model), "normalize"));
    taut_status status = TAUT_OK;

    for (int i = 0; i < count && status == TAUT_OK; i++) {
        const taut_bonnet_frame frame = {problem,
                                         problem != NULL ? lambda_of(problem, i, count) : 0};
        status = gather_surface(taut_model_surface(model, i), problem != NULL ? &frame : NULL,
                                is_exact, r);
    }
    return status;
}

static taut_status add_all(const taut_model *model, const taut_bonnet_problem *problem,
                           taut_record *lists, taut_certificate *certificate)
{
    static const char *const proofs[PROVED] = {"isothermal", "harmonic", "minimal", "smooth"};
    static const char *const names[CLAIMS] = {"algebraic", "formula", "closed-form"};
    static const taut_claim_kind kinds[CLAIMS] = {TAUT_EXACT, TAUT_BOUND, TAUT_CHECK};
    report r;
    taut_status status = TAUT_OK;

    memset(&r, 0, sizeof r);
    taut_bonnet_proof_init(r.proofs);
    r.proofs[SMOOTH].holds = TAUT_TRUE;
    for (int i = 0; i < CLAIMS; i++) {
        r.claims[i].claim = names[i];
    }
    r.area = taut_record_add_list(lists, "area");
    r.curvature = taut_record_add_list(lists, "total_gaussian_curvature");
    status = gather_all(model, problem, &r);
    for (int i = 0; i < PROVED && status == TAUT_OK; i++) {
        status = add_proof(proofs[i], &r.proofs[i], r.told[i], certificate);
    }
    for (int i = 0; i < CLAIMS && status == TAUT_OK; i++) {
        status = r.claims[i].seen > 0 ? add_claim(&r.claims[i], kinds[i], roundings[i], certificate)
                                      : TAUT_OK;
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_record_status(lists);
    return status == TAUT_OK ? add_figures(&r, certificate) : status;
}

static taut_status certify(const taut_model *model, const void *data, const taut_audit *audit,
                           taut_certificate *certificate, taut_error *error)
{
    taut_record *lists = NULL;
    taut_status status = check_surfaces(model, data, error);

    (void)audit;
    if (status != TAUT_OK) {
        return status;
    }
    lists = taut_record_new();
    status = add_all(model, data, lists, certificate);
    taut_record_free(lists);
    if (status == TAUT_OK || status == TAUT_NO_MEMORY) {
        return status == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
    }
    return taut_fail(error, status, "fault", "/surfaces", taut_none, taut_none,
                     "a surface cannot be measured: %s", taut_status_text(status));
}

/* What the bases of frame i are to be. */
static void expect_bases(const taut_bonnet_problem *problem, int i, int frames,
                         taut_expected_basis expected[2])
{
    static const char *const types[2][2] = {{"c-bezier", "h-bezier"}, {"c-bspline", "h-bspline"}};
    const double lambda = lambda_of(problem, i, frames);
    for (int d = 0; d < 2; d++) {
        const int is_cubic = problem->normalize && lambda == 1;
        expected[d] =
            (taut_expected_basis){.type = is_cubic ? "bezier" : types[problem->bspline != 0][d],
                                  .degree = {is_cubic ? 3 : 0, is_cubic ? 3 : 0},
                                  .spans = problem->segments[d] > 0 ? problem->segments[d] : 1};
    }
}

static void identify(const taut_model *model, const void *data, taut_identity *identity)
{
    const taut_bonnet_problem *problem = data;
    const int frames = problem == NULL       ? taut_model_surface_count(model)
                       : problem->frames > 1 ? problem->frames
                                             : 1;
    for (int i = 0; i < frames; i++) {
        taut_expected_basis expected[2] = {{.same = NULL}, {.same = NULL}};
        char name[32] = "bonnet";
        if (frames > 1) {
            snprintf(name, sizeof name, "frame-%d", i);
        }
        if (problem != NULL) {
            expect_bases(problem, i, frames, expected);
        }
        taut_identity_surface(identity, i, problem != NULL ? name : NULL, &expected[0],
                              &expected[1]);
    }
}

const taut_certify_ops taut_certify_bonnet = {.certify = certify, .identify = identify};

taut_status taut_bonnet_certify(const taut_model *model, const taut_bonnet_problem *problem,
                                const taut_certify_options *options, taut_certificate **certificate,
                                taut_error *error)
{
    return taut_certify_with(&taut_certify_bonnet, "bonnet", model, problem, options, certificate,
                             error);
}
