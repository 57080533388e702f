/* asymptotic.c -- the certificate of `asymptotic`: from the finished patch and curves alone.
 *
 *     boundary          largest distance from the given data, over its size
 *     asymptotic        largest |k_n| on the edges; it holds if the bound for the whole of every
 *                       edge, from the Bernstein coefficients of its numerator, is within the limit
 *     osculating        largest sine between N and b on the curved edges
 *     regular           least sine between R_u and R_v over the closed patch
 *     positive-weights  least weight of the patch
 *
 * Limits are `factor` times what rounding of the control points explains (docs/asymptotic.md), and
 * never above 1e-6, of `asymptotic` 1e-6 over the size: what lies between is undecided.
 */
#include "certify/asymptotic/parts.h"
#include "certify/certify_ops.h"
#include "core/fail.h"
#include "taut/measure.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double factor = 2.0; /* over the noise of one rounding per control point */
static const double limit_most = 1e-6;
static const double regular_least = 1e-6; /* sine */
static const double weight_least = 1e-6;

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
            const long at = e % 2 == 0 ? (long)(k / 2) * nv + held : (long)held * nv + k / 2;
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
    fill_sizes(parts);
    return TAUT_OK;
}

static taut_status add_claim(taut_certificate *certificate, const char *name, double residual,
                             double limit, int holds, const char *where)
{
    const taut_claim claim = {name, residual, limit, holds ? TAUT_TRUE : TAUT_FALSE, where};
    return taut_certificate_add(certificate, &claim);
}

/* A claim on what is at most `bound`, held against what rounding explains but no more than `most`;
 * open where rounding explains more than that, or the data does: what the curves leave any patch.
 */
static taut_status add_within(taut_certificate *certificate, const char *name, double residual,
                              double bound, double noise, double data, double most,
                              const char *where)
{
    const double limit = fmin(noise, most);
    const int hidden = bound > limit && bound <= noise;
    const int open = bound > limit && bound <= noise + data;
    const taut_claim claim = {name, residual, limit,
                              bound <= limit ? TAUT_TRUE
                              : open         ? TAUT_UNDECIDED
                                             : TAUT_FALSE,
                              hidden ? "the rounding of the points hides it"
                              : open
                                  ? "the curves' planes and torsions at the corners agree no better"
                                  : where};
    return taut_certificate_add(certificate, &claim);
}

static taut_status add_boundary(const taut_asymptotic_model *parts,
                                const taut_asymptotic_problem *problem,
                                taut_certificate *certificate)
{
    char where[TAUT_PLACE_TEXT];
    double distance = 0.0, noise = 0.0;
    taut_boundary_distance(parts, problem, &distance, &noise, where);
    return add_within(certificate, "boundary", distance, distance, factor * noise, 0.0, limit_most,
                      where);
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
static taut_status add_edges(const taut_edge_proof proofs[4], double size,
                             taut_certificate *certificate)
{
    char where[2][TAUT_PLACE_TEXT] = {"", ""};
    double bound = 0.0, noise = 0.0, noise_sine = 0.0, sine = 0.0, given = 0.0, given_sine = 0.0;
    int worst = 0, worst_sine = 0;
    taut_status status = TAUT_OK;
    for (int e = 0; e < 4; e++) {
        bound = fmax(bound, proofs[e].bound);
        noise = fmax(noise, proofs[e].noise);
        noise_sine = fmax(noise_sine, proofs[e].noise_sine);
        given = fmax(given, proofs[e].given);
        given_sine = fmax(given_sine, proofs[e].given_sine);
        worst = proofs[e].sampled > proofs[worst].sampled ? e : worst;
        worst_sine = proofs[e].osculating > proofs[worst_sine].osculating ? e : worst_sine;
    }
    sine = fmax(proofs[worst_sine].osculating, 0.0);
    (void)snprintf(where[0], TAUT_PLACE_TEXT, "%s, t = %.2f; on no edge above %.3g",
                   taut_asymptotic_edge_name(worst), proofs[worst].at, bound);
    (void)snprintf(where[1], TAUT_PLACE_TEXT, "%s, t = %.2f", taut_asymptotic_edge_name(worst_sine),
                   proofs[worst_sine].sine_at);
    status = add_within(certificate, "asymptotic", proofs[worst].sampled, bound, factor * noise,
                        factor * given, limit_most / size, where[0]);
    if (status != TAUT_OK) {
        return status;
    }
    return add_within(certificate, "osculating", sine, sine, factor * noise_sine,
                      factor * given_sine, limit_most, where[1]);
}

static taut_status add_regular(const taut_asymptotic_model *parts, int threads,
                               taut_certificate *certificate)
{
    char where[TAUT_PLACE_TEXT];
    double sine = 0.0, at[2] = {0, 0};
    const taut_status status = taut_regular_least(parts->patch, threads, &sine, at);
    if (status != TAUT_OK) {
        return status;
    }
    (void)snprintf(where, sizeof where, "u = %.6f, v = %.6f", at[0], at[1]);
    return add_claim(certificate, "regular", sine, regular_least, sine > regular_least, where);
}

static double smallest_weight(const taut_surface *patch, char where[TAUT_PLACE_TEXT])
{
    const int nu = taut_basis_count(taut_surface_u(patch));
    const int nv = taut_basis_count(taut_surface_v(patch));
    const double *const weights = taut_surface_weights(patch);
    double least = weights != NULL ? INFINITY : 1.0;
    where[0] = '\0';
    for (long k = 0; weights != NULL && k < (long)nu * nv; k++) {
        if (weights[k] < least) {
            least = weights[k];
            (void)snprintf(where, TAUT_PLACE_TEXT, "/surfaces/0/weights/%ld/%ld", k / nv, k % nv);
        }
    }
    return least;
}

static taut_status add_figures(const taut_asymptotic_model *parts, const taut_edge_proof proofs[4],
                               double weight, taut_certificate *certificate)
{
    taut_record *const figures = taut_record_new();
    taut_record *edges = NULL;
    double energy = 0.0, bound = 0.0, sine = 1.0;
    taut_status status = taut_surface_bending_energy(parts->patch, &energy);
    for (int e = 0; e < 4; e++) {
        bound = fmax(bound, proofs[e].bound);
        sine = fmin(sine, proofs[e].least_sine);
    }
    taut_record_add_number(figures, "bending_energy", energy);
    taut_record_add_number(figures, "smallest_weight", weight);
    taut_record_add_number(figures, "asymptotic_bound", bound);
    taut_record_add_number(figures, "least_edge_sine", sine);
    edges = taut_record_add_object(figures, "edges");
    for (int e = 0; e < 4; e++) {
        taut_record *const edge = taut_record_add_object(edges, taut_asymptotic_edge_name(e));
        taut_record_add_number(edge, "max_abs_normal_curvature", proofs[e].sampled);
        taut_record_add_number(edge, "bound", proofs[e].bound);
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

static taut_status add_all(const taut_asymptotic_model *parts,
                           const taut_asymptotic_problem *problem, int threads,
                           taut_certificate *certificate)
{
    taut_edge_proof proofs[4];
    char where[TAUT_PLACE_TEXT];
    const double weight = smallest_weight(parts->patch, where);
    taut_status status = TAUT_OK;
    for (int e = 0; e < 4 && status == TAUT_OK; e++) {
        status = taut_edge_prove(parts, e, &proofs[e]);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = add_boundary(parts, problem, certificate);
    if (status != TAUT_OK) {
        return status;
    }
    status = add_edges(proofs, size_of(parts), certificate);
    if (status != TAUT_OK) {
        return status;
    }
    status = add_regular(parts, threads, certificate);
    if (status != TAUT_OK) {
        return status;
    }
    status = add_claim(certificate, "positive-weights", weight, weight_least, weight > weight_least,
                       where);
    return status == TAUT_OK ? add_figures(parts, proofs, weight, certificate) : status;
}

static taut_status certify(const taut_model *model, const void *data,
                           const taut_certify_options *options, taut_certificate *certificate,
                           taut_error *error)
{
    taut_asymptotic_model parts;
    taut_status status = find_parts(model, &parts, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = add_all(&parts, data, options->threads, certificate);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}

const taut_certify_ops taut_certify_asymptotic = {.certify = certify};

taut_status taut_asymptotic_certify(const taut_model *model, const taut_asymptotic_problem *problem,
                                    const taut_certify_options *options,
                                    taut_certificate **certificate, taut_error *error)
{
    return taut_certify_with(&taut_certify_asymptotic, "asymptotic", model, problem, options,
                             certificate, error);
}
