/* asymptotic.c -- the certificate of `asymptotic`: from the finished patch and curves alone.
 *
 *     boundary          largest distance from the given data, over its size; of curves it holds if
 *                       a bound for every parameter is within the limit
 *     asymptotic        largest |k_n| on the edges; it holds if the bound for the whole of every
 *                       edge, from the Bernstein coefficients of its numerator, is within the limit
 *     osculating        largest sine between N and b on the curved edges, in the same way
 *     regular           least sine between R_u and R_v over the closed patch, bounded from below
 *     positive-weights  least weight of the patch
 *
 * Limits are `factor` times what rounding of the control points explains (docs/asymptotic.md), and
 * never above 1e-6, of `asymptotic` 1e-6 over the size: what lies between is undecided.
 */
#include "certify/asymptotic/parts.h"
#include "certify/asymptotic/unit.h"
#include "certify/certify_ops.h"
#include "certify/common/figures.h"
#include "certify/common/regular.h"
#include "certify/common/verdict.h"
#include "core/fail.h"
#include "measure/integrate/integrals.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static const double factor = 2.0; /* over the noise of one rounding per control point */
static const double limit_most = 1e-6;
static const double weight_least = 1e-6;
static const double covered_least = 0.5; /* of an edge: less is not the edge */

static const taut_curve *find_curve(const taut_model *model, const char *name)
{
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        if (strcmp(taut_curve_name(taut_model_curve(model, i)), name) == 0) {
            return taut_model_curve(model, i);
        }
    }
    return NULL;
}

static int is_unit_bezier(const taut_basis *basis)
{
    return strcmp(taut_basis_type(basis), "bezier") == 0 && taut_basis_lo(basis) == 0.0 &&
           taut_basis_hi(basis) == 1.0;
}

static void fill_sizes(taut_asymptotic_model *parts)
{
    const int nu = taut_basis_count(taut_surface_u(parts->patch));
    const int nv = taut_basis_count(taut_surface_v(parts->patch));
    const double *const points = taut_surface_points(parts->patch);
    parts->curve_size = 0.0;
    for (int e = 0; e < 4; e++) {
        const int count = taut_basis_count(taut_curve_t(parts->curves[e]));
        const int along = e % 2 == 0 ? nu : nv, across = e % 2 == 0 ? nv : nu;
        parts->row_size[e] = 0.0;
        for (int k = 0; k < 2 * along; k++) {
            const int held = e >= 2 ? across - 1 - k % 2 : k % 2;
            const int64_t at =
                e % 2 == 0 ? (int64_t)(k / 2) * nv + held : (int64_t)held * nv + k / 2;
            for (int d = 0; d < 3; d++) {
                parts->row_size[e] = fmax(parts->row_size[e], fabs(points[3 * at + d]));
            }
        }
        for (int k = 0; k < 3 * count; k++) {
            parts->curve_size =
                fmax(parts->curve_size, fabs(taut_curve_points(parts->curves[e])[k]));
        }
    }
}

/* The parts of the model, or TAUT_BAD_INPUT that says which is missing. */
static taut_status find_parts(const taut_model *model, taut_asymptotic_model *parts,
                              taut_error *error)
{
    int nu = 0, nv = 0;
    parts->patch = taut_model_surface_count(model) > 0 ? taut_model_surface(model, 0) : NULL;
    if (parts->patch == NULL || !is_unit_bezier(taut_surface_u(parts->patch)) ||
        !is_unit_bezier(taut_surface_v(parts->patch))) {
        return taut_fail(error, TAUT_BAD_INPUT, "model", "/surfaces", taut_none, taut_none,
                         "the model's first surface must be the patch, on bezier bases over "
                         "[0, 1]");
    }
    nu = taut_basis_count(taut_surface_u(parts->patch));
    nv = taut_basis_count(taut_surface_v(parts->patch));
    if (nu < 3 || nv < 3) {
        return taut_fail(error, TAUT_BAD_INPUT, "model", "/surfaces/0", fmin(nu, nv) - 1, 2,
                         "the patch must have degree 2 at least in each direction");
    }
    for (int e = 0; e < 4; e++) {
        parts->curves[e] = find_curve(model, taut_asymptotic_edge_name(e));
        if (parts->curves[e] == NULL || !is_unit_bezier(taut_curve_t(parts->curves[e]))) {
            return taut_fail(error, TAUT_BAD_INPUT, "model", "/curves", taut_none, taut_none,
                             "the model must have a bezier curve %s over [0, 1]",
                             taut_asymptotic_edge_name(e));
        }
    }
    return TAUT_OK;
}

/* What a claim is about: residual is at most `bound`, proved or seen; `noise` is what rounding of
 * the points explains, `data` what the curves leave any patch. */
typedef struct finding {
    double residual, bound, noise, data;
    int exponent; /* residual and limit are told 2^-exponent times as large */
    const char *where;
    double covered; /* the least share of an edge that it is about */
    int elsewhere;  /* nonzero: the edges are not the curves that it takes b from */
} finding;

/* Held against what rounding explains but no more than `most`; open where rounding, or the data,
 * explains more than that, and where a number is none. */
static taut_status add_within(taut_certificate *certificate, const char *name, taut_claim_kind kind,
                              const finding *found, double most)
{
    const double limit = taut_certify_min(found->noise, most);
    const double reach = found->noise + found->data;
    taut_claim claim = {.claim = name,
                        .kind = kind,
                        .residual = ldexp(found->residual, -found->exponent),
                        .limit = ldexp(limit, -found->exponent),
                        .holds = taut_certify_below(found->bound, limit),
                        .where = found->where};
    if (!isfinite(found->residual + found->bound + limit + claim.residual + claim.limit)) {
        claim.holds = TAUT_UNDECIDED;
        claim.where = TAUT_CERTIFY_OUT_OF_RANGE;
    } else if (claim.holds == TAUT_FALSE && found->bound <= found->noise) {
        claim.holds = TAUT_UNDECIDED;
        claim.where = "the rounding of the points hides it";
    } else if (claim.holds == TAUT_FALSE && found->bound <= reach) {
        claim.holds = TAUT_UNDECIDED;
        claim.where = "the curves' planes and torsions at the corners agree no better";
    } else if (claim.holds == TAUT_TRUE && !(found->covered >= covered_least)) {
        claim.holds = TAUT_UNDECIDED;
        claim.where = "rounding leaves no bound on most of an edge";
    } else if (claim.holds == TAUT_TRUE && found->elsewhere) {
        claim.holds = TAUT_UNDECIDED;
        claim.where = "the edges are not the curves, whose binormals it takes";
    }
    return taut_certificate_add(certificate, &claim);
}

static taut_status add_boundary(const taut_asymptotic_model *parts,
                                const taut_asymptotic_problem *problem,
                                taut_certificate *certificate)
{
    char where[TAUT_PLACE_TEXT];
    double distance = 0.0, bound = 0.0, noise = 0.0;
    taut_boundary_distance(parts, problem, &distance, &bound, &noise, where);
    {
        const finding found = {distance, bound, factor * noise, 0.0, 0, where, 1.0, 0};
        return add_within(certificate, "boundary", TAUT_BOUND, &found, limit_most);
    }
}

/* A straight curve has no b: what is its edge then must be straight too, and a bump that is hardly there
 * has a binormal of its own. */
static int edges_are_elsewhere(const taut_asymptotic_model *parts)
{
    char where[TAUT_PLACE_TEXT];
    double distance = 0.0, bound = 0.0, noise = 0.0;
    taut_boundary_distance(parts, NULL, &distance, &bound, &noise, where);
    return !(bound <= fmin(factor * noise, limit_most));
}

/* The largest extent of the curves' corners: a curvature is compared with one over it. */
static double size_of(const taut_asymptotic_model *parts)
{
    double size = 0.0;
    for (int d = 0; d < 3; d++) {
        double low = INFINITY, high = -INFINITY;
        for (int k = 0; k < 8; k++) {
            const taut_curve *const curve = parts->curves[k / 2];
            const int last = taut_basis_count(taut_curve_t(curve)) - 1;
            const double x = taut_curve_points(curve)[3 * (k % 2) * last + d];
            low = fmin(low, x);
            high = fmax(high, x);
        }
        size = fmax(size, high - low);
    }
    return size > 0 ? size : 1.0;
}

/* `asymptotic` and `osculating`, over all edges. */
static taut_status add_edges(const taut_edge_proof proofs[4], double size, int exponent,
                             int elsewhere, taut_certificate *certificate)
{
    char where[2][TAUT_PLACE_TEXT] = {"", ""};
    finding flat = {0, 0, 0, 0, exponent, where[0], 1, 0};
    finding sine = {0, 0, 0, 0, 0, where[1], 1, elsewhere};
    int worst = 0, worst_sine = 0;
    taut_status status = TAUT_OK;
    for (int e = 0; e < 4; e++) {
        const double angle = proofs[e].osculating < 0 ? 0 : proofs[e].osculating;
        flat.bound = taut_certify_max(flat.bound, proofs[e].bound);
        flat.noise = taut_certify_max(flat.noise, factor * proofs[e].noise);
        flat.data = taut_certify_max(flat.data, factor * proofs[e].given);
        flat.residual = taut_certify_max(flat.residual, proofs[e].sampled);
        sine.noise = taut_certify_max(sine.noise, factor * proofs[e].noise_sine);
        sine.data = taut_certify_max(sine.data, factor * proofs[e].given_sine);
        sine.residual = taut_certify_max(sine.residual, angle);
        sine.bound = taut_certify_max(sine.bound, proofs[e].sine_bound);
        flat.covered = sine.covered = fmin(flat.covered, proofs[e].covered);
        worst = proofs[e].sampled > proofs[worst].sampled ? e : worst;
        worst_sine = proofs[e].osculating > proofs[worst_sine].osculating ? e : worst_sine;
    }
    /* samples see more of a singular edge than the bound covers */
    flat.bound = taut_certify_max(flat.bound, flat.residual);
    sine.bound = taut_certify_max(sine.bound, sine.residual);
    (void)snprintf(where[0], TAUT_PLACE_TEXT, "%s, t = %.2f; on no edge above %.3g",
                   taut_asymptotic_edge_name(worst), proofs[worst].at,
                   ldexp(flat.bound, -exponent));
    (void)snprintf(where[1], TAUT_PLACE_TEXT, "%s, t = %.2f; on no edge above %.3g",
                   taut_asymptotic_edge_name(worst_sine), proofs[worst_sine].sine_at, sine.bound);
    status = add_within(certificate, "asymptotic", TAUT_BOUND, &flat, limit_most / size);
    return status == TAUT_OK ? add_within(certificate, "osculating", TAUT_BOUND, &sine, limit_most)
                             : status;
}

static double smallest_weight(const taut_surface *patch, char where[TAUT_PLACE_TEXT])
{
    const int nu = taut_basis_count(taut_surface_u(patch));
    const int nv = taut_basis_count(taut_surface_v(patch));
    const double *const weights = taut_surface_weights(patch);
    double least = weights != NULL ? INFINITY : 1.0;
    where[0] = '\0';
    for (int64_t k = 0; weights != NULL && k < (int64_t)nu * nv; k++) {
        if (weights[k] < least) {
            least = weights[k];
            (void)snprintf(where, TAUT_PLACE_TEXT, "/surfaces/0/weights/%d/%d", (int)(k / nv),
                           (int)(k % nv));
        }
    }
    return least;
}

static taut_status add_figures(const taut_asymptotic_model *parts, const taut_edge_proof proofs[4],
                               double weight, const taut_regular *regular, int exponent,
                               const taut_crew *crew, taut_certificate *certificate)
{
    taut_record *const figures = taut_record_new();
    taut_record *edges = NULL;
    double energy = 0.0, error = 0.0, bound = 0.0, sine = 1.0;
    taut_status status = taut_surface_bending_of(parts->patch, crew, &energy, &error);
    for (int e = 0; e < 4; e++) {
        bound = taut_certify_max(bound, proofs[e].bound);
        sine = taut_certify_min(sine, proofs[e].least_sine);
    }
    energy = ldexp(energy, 2 * exponent);
    error = ldexp(error, 2 * exponent);
    taut_certify_add_integrals(figures, "bending_energy", 1, &energy, &error);
    taut_record_add_number(figures, "smallest_weight", weight);
    taut_record_add_number(figures, "asymptotic_bound", ldexp(bound, -exponent));
    taut_certify_regular_figure(regular, figures);
    taut_record_add_number(figures, "least_edge_sine", sine);
    edges = taut_record_add_object(figures, "edges");
    for (int e = 0; e < 4; e++) {
        taut_record *const edge = taut_record_add_object(edges, taut_asymptotic_edge_name(e));
        taut_record_add_number(edge, "max_abs_normal_curvature",
                               ldexp(proofs[e].sampled, -exponent));
        taut_record_add_number(edge, "bound", ldexp(proofs[e].bound, -exponent));
        taut_record_add_number(edge, "bound_covers", proofs[e].covered);
        if (proofs[e].osculating >= 0) {
            taut_record_add_number(edge, "max_sine_normal_binormal", proofs[e].osculating);
        } else {
            taut_record_add_null(edge, "max_sine_normal_binormal");
        }
    }
    taut_certificate_set_figures(certificate, figures);
    return status == TAUT_OK ? taut_record_status(figures) : status;
}

static taut_status add_weights(double weight, const char *where, taut_certificate *certificate)
{
    const taut_claim claim = {.claim = "positive-weights",
                              .kind = TAUT_EXACT,
                              .residual = weight,
                              .limit = weight_least,
                              .holds = taut_certify_above(weight, weight_least),
                              .where = where};
    return taut_certificate_add(certificate, &claim);
}

/* parts and problem: at unit size, by 2^exponent; weight: of the model itself. */
static taut_status add_all(const taut_asymptotic_model *parts,
                           const taut_asymptotic_problem *problem, int exponent, double weight,
                           const char *where, const taut_crew *crew, taut_certificate *certificate)
{
    taut_edge_proof proofs[4];
    taut_regular regular;
    taut_status status = TAUT_OK;
    for (int e = 0; e < 4 && status == TAUT_OK; e++) {
        status = taut_edge_prove(parts, e, &proofs[e]);
    }
    if (status == TAUT_OK) {
        status = add_boundary(parts, problem, certificate);
    }
    if (status == TAUT_OK) {
        status =
            add_edges(proofs, size_of(parts), exponent, edges_are_elsewhere(parts), certificate);
    }
    if (status == TAUT_OK) {
        status = taut_certify_regular(parts->patch, crew, &regular);
    }
    if (status == TAUT_OK) {
        status = taut_certify_add_regular(&regular, certificate);
    }
    if (status == TAUT_OK) {
        status = add_weights(weight, where, certificate);
    }
    return status == TAUT_OK
               ? add_figures(parts, proofs, weight, &regular, exponent, crew, certificate)
               : status;
}

static taut_status certify(const taut_model *model, const void *data, const taut_audit *audit,
                           taut_certificate *certificate, taut_error *error)
{
    taut_asymptotic_model parts, unit;
    taut_asymptotic_problem scaled;
    taut_arena *arena = NULL;
    char where[TAUT_PLACE_TEXT];
    int exponent = 0;
    taut_status status = find_parts(model, &parts, error);
    if (status != TAUT_OK) {
        return status;
    }
    arena = taut_arena_new();
    status = taut_asymptotic_unit(&parts, data, arena, &unit, &scaled, &exponent);
    if (status == TAUT_OK) {
        const double weight = smallest_weight(parts.patch, where);
        fill_sizes(&unit);
        status = add_all(&unit, data != NULL ? &scaled : NULL, exponent, weight, where,
                         &audit->crew, certificate);
    }
    taut_arena_free(arena);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}

/* The degree of the four curves: the one asked for, or the highest of those given. */
static int degree_of(const taut_asymptotic_problem *problem)
{
    int degree = 3; /* lower ones are raised */
    if (problem->given == TAUT_ASYMPTOTIC_CORNERS) {
        return problem->corners.degree;
    }
    for (int e = 0; e < 4; e++) {
        const int n = taut_basis_degree(taut_curve_t(problem->curves[e]));
        degree = n > degree ? n : degree;
    }
    return degree;
}

static void identify(const taut_model *model, const void *data, taut_identity *identity)
{
    const taut_asymptotic_problem *problem = data;
    taut_expected_basis patch = {.type = "bezier"}, curve = {.type = "bezier"};

    (void)model;
    if (problem != NULL) {
        const int n = degree_of(problem);
        const int m = problem->surface == TAUT_BIDEGREE_N_PLUS_3 ? n + 3 : 5 * n - 7;
        curve.degree[0] = curve.degree[1] = n;
        patch.degree[0] = patch.degree[1] = m;
    }
    taut_identity_surface(identity, 0, "patch", &patch, &patch);
    for (int e = 0; e < 4; e++) {
        const char *name = taut_asymptotic_edge_name(e);
        taut_identity_curve(identity, taut_identity_find_curve(identity, name), name, &curve);
    }
}

const taut_certify_ops taut_certify_asymptotic = {.certify = certify, .identify = identify};

taut_status taut_asymptotic_certify(const taut_model *model, const taut_asymptotic_problem *problem,
                                    const taut_certify_options *options,
                                    taut_certificate **certificate, taut_error *error)
{
    return taut_certify_with(&taut_certify_asymptotic, "asymptotic", model, problem, options,
                             certificate, error);
}
