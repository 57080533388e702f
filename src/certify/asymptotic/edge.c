/* edge.c -- k_n and the angle between N and b along one edge.
 *
 * k_n is taken from the identity in twice the precision (certify/asymptotic/identity.h); the angle
 * from points: N from the patch's derivatives, b from the model's curve.
 */
#include "certify/asymptotic/identity.h"
#include "certify/asymptotic/parts.h"
#include "certify/common/verdict.h"
#include "core/vec3.h"

#include <float.h>
#include <stdint.h>
#include <string.h>

/* 64 pieces to begin with; halved again where the bound is far above what the samples show. */
enum { LEVELS = 6, MORE = 11 };
static const double close_enough = 1.25;   /* bound over sampled maximum */
static const double inflection_cut = 5e-3; /* of the largest curvature: nearer there is no b */
/* On an edge with a singular point, what is beside it is left out: sines of R_u, R_v below the
 * first at the samples, |M| below the second of its largest in the bound. */
static const double singular_cut = 0.08, normal_share = 0.02;
static const double normal_cut = 1e-9; /* sine below which there is no normal */

/* Points of one parameter: the patch's derivatives along and across, and the curve's. */
typedef struct sample {
    double x[6][3];
    double c[4][3];
    const double *along, *across, *second;
    double normal[3]; /* along x across */
    double sine;
} sample;

static void evaluate_sample(const taut_asymptotic_model *model, int edge, double t, sample *s)
{
    double u = 0.0, v = 0.0;
    taut_edge_parameters(edge, t, &u, &v);
    (void)taut_surface_eval(model->patch, u, v, 2, &s->x[0][0]);
    (void)taut_curve_eval(model->curves[edge], t, 2, &s->c[0][0]);
    s->along = edge % 2 == 0 ? s->x[TAUT_XU] : s->x[TAUT_XV];
    s->across = edge % 2 == 0 ? s->x[TAUT_XV] : s->x[TAUT_XU];
    s->second = edge % 2 == 0 ? s->x[TAUT_XUU] : s->x[TAUT_XVV];
    taut_cross(s->along, s->across, s->normal);
    s->sine = taut_norm(s->normal) / (taut_norm(s->along) * taut_norm(s->across));
}

/* k = |r' x r''| / |r'|^3 of the curve. */
static double curvature(const sample *s, double binormal[3])
{
    const double speed = taut_norm(s->c[1]);
    taut_cross(s->c[1], s->c[2], binormal);
    return taut_norm(binormal) / (speed * speed * speed);
}

/* How much derivatives along and across the edge answer to its control points: sum_j |phi_j''| and
 * sum_j of the factors of both rows in R_c, with phi_j = W_j B_j / W. */
static void responses(const taut_surface *patch, int edge, double t, double *second, double *across)
{
    const int with_u = edge % 2 == 0;
    const taut_basis *const basis = with_u ? taut_surface_u(patch) : taut_surface_v(patch);
    const int count = taut_basis_count(basis);
    const int last = taut_basis_count(with_u ? taut_surface_v(patch) : taut_surface_u(patch)) - 1;
    const double *const weights = taut_surface_weights(patch);
    double values[3 * (TAUT_DEGREE_MAX + 1)], w[3] = {0}, next = 0.0;
    (void)taut_basis_eval(basis, 0, t, 2, values);
    for (int pass = 0; pass < 2; pass++) {
        *second = 0.0;
        for (int j = 0; j < count; j++) {
            const int64_t row = edge >= 2 ? last : 0, beside = edge >= 2 ? last - 1 : 1;
            const int64_t at = with_u ? (int64_t)j * (last + 1) + row : row * count + j;
            const int64_t to = with_u ? (int64_t)j * (last + 1) + beside : beside * count + j;
            const double wj = weights != NULL ? weights[at] : 1.0;
            const double b0 = values[j], b1 = values[count + j], b2 = values[2 * count + j];
            if (pass == 0) {
                w[0] += wj * b0;
                w[1] += wj * b1;
                w[2] += wj * b2;
                next += (weights != NULL ? weights[to] : 1.0) * b0;
            } else {
                const double phi = wj * b0 / w[0], phi1 = (wj * b1 - w[1] * phi) / w[0];
                *second += fabs((wj * b2 - 2 * w[1] * phi1 - w[2] * phi) / w[0]);
            }
        }
    }
    *across = last * (2 * next / w[0] + 1.0);
}

/* Moving every control point of the two rows by a rounding error r = 2^-53 times their size moves
 * R_tt by A r and R_c by C r at most, and the normal by C r / (|R_c| sine):
 *     dk_n <= (A + C |R_tt| / (|R_c| sine)) r / |R_t|^2                                           */
static double noise_of(const taut_asymptotic_model *model, int edge, double t, const sample *s)
{
    double second = 0.0, across = 0.0;
    responses(model->patch, edge, t, &second, &across);
    return (second + across * taut_norm(s->second) / (taut_norm(s->across) * s->sine)) * 0.5 *
           DBL_EPSILON * model->row_size[edge] / taut_dot(s->along, s->along);
}

static double largest_curvature(const taut_asymptotic_model *model, int edge)
{
    double most = 0.0;
    for (int k = 0; k < TAUT_EDGE_SAMPLES; k++) {
        sample s;
        double b[3];
        evaluate_sample(model, edge, k / (TAUT_EDGE_SAMPLES - 1.0), &s);
        most = fmax(most, curvature(&s, b));
    }
    return most;
}

/* A curve whose curvature, or whose points' distance from the chord, is nothing but rounding: no b,
 * no angle. */
static int is_straight(const taut_asymptotic_model *model, int edge, double most)
{
    const double *const p = taut_curve_points(model->curves[edge]);
    const int last = taut_basis_count(taut_curve_t(model->curves[edge])) - 1;
    return most * taut_distance(p, p + 3 * last) <= 1e-10 || taut_edge_on_chord(model, edge);
}

/* The larger end weight over W(t). */
static double weight_ratio(const taut_curve *curve, double t)
{
    const int n = taut_basis_count(taut_curve_t(curve)) - 1;
    const double *const w = taut_curve_weights(curve);
    double values[TAUT_DEGREE_MAX + 1], sum = 0.0;
    if (w == NULL) {
        return 1.0;
    }
    (void)taut_basis_eval(taut_curve_t(curve), 0, t, 0, values);
    for (int j = 0; j <= n; j++) {
        sum += w[j] * values[j];
    }
    return fmax(w[0], w[n]) / sum;
}

static void add_sample(const taut_asymptotic_model *model, int edge, double t,
                       const taut_identity *identity, double most, taut_edge_proof *proof)
{
    const taut_edge_data data = taut_edge_data_of(model, edge);
    sample s;
    double b[3], angle[3], k_n = 0.0, k = 0.0, sine = 0.0, tilt = 0.0;
    evaluate_sample(model, edge, t, &s);
    if (!isfinite(taut_norm(s.along) + taut_norm(s.across) + taut_norm(s.second))) {
        proof->sampled = NAN; /* nothing is known of the edge */
        return;
    }
    proof->least_sine = fmin(proof->least_sine, s.sine);
    if (!(s.sine > (proof->covered < 1.0 ? singular_cut : normal_cut))) {
        proof->singular++;
        return;
    }
    k_n = fabs(taut_identity_at(identity, t));
    if (k_n > proof->sampled || isnan(k_n)) {
        proof->sampled = k_n;
        proof->at = t;
    }
    proof->noise = taut_certify_max(proof->noise, noise_of(model, edge, t, &s));
    k = curvature(&s, b);
    tilt = weight_ratio(model->curves[edge], t) * taut_edge_data_at(&data, identity->degree[3], t) /
           (taut_norm(s.across) * s.sine);
    proof->given = taut_certify_max(proof->given, k * tilt);
    if (proof->osculating < 0 || !(k > inflection_cut * most)) {
        return;
    }
    taut_cross(s.normal, b, angle);
    sine = taut_certify_max(taut_norm(angle) / (taut_norm(s.normal) * taut_norm(b)), k_n / k);
    proof->given_sine = taut_certify_max(proof->given_sine, tilt);
    proof->noise_sine = taut_certify_max(proof->noise_sine, noise_of(model, edge, t, &s) / k);
    if (sine > proof->osculating || isnan(sine)) {
        proof->osculating = sine;
        proof->sine_at = t;
    }
}

static taut_status prove(const taut_asymptotic_model *model, int edge, taut_arena *arena,
                         taut_edge_proof *proof)
{
    taut_bounding bounding = {LEVELS, MORE, INFINITY, normal_share, INFINITY, INFINITY};
    double sine = 0.0;
    taut_identity identity;
    double *scratch = NULL;
    const double most = largest_curvature(model, edge);
    const taut_status status = taut_identity_fill(model->patch, edge, arena, &identity);
    if (status != TAUT_OK) {
        return status;
    }
    scratch = taut_arena_take(arena, (size_t)taut_identity_size(&identity) * (LEVELS + MORE + 1),
                              sizeof *scratch);
    if (scratch == NULL) {
        return TAUT_NO_MEMORY;
    }
    memset(proof, 0, sizeof *proof);
    proof->least_sine = 1.0;
    proof->osculating = is_straight(model, edge, most) ? -1.0 : 0.0;
    /* a first bound tells whether the edge is singular, which the samples must know */
    (void)taut_identity_bound(&identity, &bounding, scratch, &proof->covered, &sine);
    for (int k = 0; k < TAUT_EDGE_SAMPLES; k++) {
        add_sample(model, edge, k / (TAUT_EDGE_SAMPLES - 1.0), &identity, most, proof);
    }
    bounding.target = close_enough * proof->sampled;
    bounding.sine = close_enough * proof->osculating;
    bounding.bent = proof->osculating < 0 ? INFINITY : inflection_cut * most;
    proof->bound =
        taut_identity_bound(&identity, &bounding, scratch, &proof->covered, &proof->sine_bound);
    return TAUT_OK;
}

taut_status taut_edge_prove(const taut_asymptotic_model *model, int edge, taut_edge_proof *proof)
{
    taut_arena *const arena = taut_arena_new();
    const taut_status status = prove(model, edge, arena, proof);
    taut_arena_free(arena);
    return status;
}
