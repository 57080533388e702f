/* asymptotic_edge.c -- k_n and the angle between N and b along one edge.
 *
 * k_n is taken from the identity in twice the precision (certify/asymptotic_identity.h); the angle
 * from points: N from the patch's derivatives, b from the model's curve.
 */
#include "certify/asymptotic_identity.h"
#include "certify/asymptotic_parts.h"
#include "core/memory.h"
#include "core/vec3.h"

#include <float.h>
#include <string.h>

/* 128 pieces bring the bound within some per cent of the maximum; where |M| is small but not zero
 * they are cut further. */
enum { LEVELS = 7, MORE = 10 };
static const double inflection_cut = 1e-4; /* of the largest curvature: nearer there is no b */
/* Points count as beside a singular point, and |M| as small, below this: sine of R_u, R_v, and
 * share of the largest |M|, on edges that have one. */
static const double singular_cut = 0.02;
static const double normal_cut = 1e-9; /* sine below which there is no normal */

/* Points of one parameter: the patch's derivatives along and across, and the curve's. */
typedef struct sample {
    double x[6][3];
    double c[4][3];
    const double *along, *across, *second;
    double normal[3]; /* along x across */
    double sine;
} sample;

static void take(const taut_asymptotic_model *model, int edge, double t, sample *s)
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

/* Moving a control point by a rounding error r = 2^-53 times its size moves R_tt by 4 m^2 r at
 * most, R_c by 2 m r, and with it the normal by 2 m r / (|R_c| sine): dk_n <= (4 m^2 + 2 m |R_tt| /
 * (|R_c| sine)) r / |R_t|^2 */
static double noise_of(const taut_asymptotic_model *model, int edge, const sample *s)
{
    const taut_basis *const basis =
        edge % 2 == 0 ? taut_surface_u(model->patch) : taut_surface_v(model->patch);
    const double m = taut_basis_count(basis) - 1;
    const double turn = 2 * m * taut_norm(s->second) / (taut_norm(s->across) * s->sine);
    return (4 * m * m + turn) * 0.5 * DBL_EPSILON * model->row_size[edge] /
           taut_dot(s->along, s->along);
}

static double largest_curvature(const taut_asymptotic_model *model, int edge)
{
    double most = 0.0;
    for (int k = 0; k < TAUT_EDGE_SAMPLES; k++) {
        sample s;
        double b[3];
        take(model, edge, k / (TAUT_EDGE_SAMPLES - 1.0), &s);
        most = fmax(most, curvature(&s, b));
    }
    return most;
}

/* A curve whose curvature is nothing but rounding: no b, no angle. */
static int is_straight(const taut_asymptotic_model *model, int edge, double most)
{
    double chord[2][4][3];
    (void)taut_curve_eval(model->curves[edge], 0.0, 0, &chord[0][0][0]);
    (void)taut_curve_eval(model->curves[edge], 1.0, 0, &chord[1][0][0]);
    return most * taut_distance(chord[0][0], chord[1][0]) <= 1e-10;
}

static void add_sample(const taut_asymptotic_model *model, int edge, double t,
                       const taut_identity *identity, double most, taut_edge_proof *proof)
{
    sample s;
    double b[3], angle[3], k_n = 0.0, k = 0.0, sine = 0.0;
    take(model, edge, t, &s);
    if (!(s.sine > (proof->covered < 1.0 ? singular_cut : normal_cut))) {
        proof->singular++;
        return;
    }
    k_n = fabs(taut_identity_at(identity, t));
    if (k_n > proof->sampled) {
        proof->sampled = k_n;
        proof->at = t;
    }
    proof->noise = fmax(proof->noise, noise_of(model, edge, &s));
    k = curvature(&s, b);
    if (proof->osculating < 0 || !(k > inflection_cut * most)) {
        return;
    }
    taut_cross(s.normal, b, angle);
    sine = taut_norm(angle) / (taut_norm(s.normal) * taut_norm(b));
    proof->noise_sine = fmax(proof->noise_sine, noise_of(model, edge, &s) / k);
    if (sine > proof->osculating) {
        proof->osculating = sine;
        proof->sine_at = t;
    }
}

taut_status taut_edge_prove(const taut_asymptotic_model *model, int edge, taut_edge_proof *proof)
{
    taut_arena *const arena = taut_arena_new();
    taut_identity identity;
    double *scratch = NULL;
    const double most = largest_curvature(model, edge);
    taut_status status =
        arena != NULL ? taut_identity_fill(model->patch, edge, arena, &identity) : TAUT_NO_MEMORY;
    memset(proof, 0, sizeof *proof);
    proof->osculating = is_straight(model, edge, most) ? -1.0 : 0.0;
    if (status == TAUT_OK) {
        scratch = taut_arena_take(
            arena, (size_t)taut_identity_size(&identity) * (LEVELS + MORE + 1), sizeof *scratch);
        status = scratch != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    }
    if (status == TAUT_OK) {
        proof->bound =
            taut_identity_bound(&identity, LEVELS, MORE, singular_cut, scratch, &proof->covered);
        for (int k = 0; k < TAUT_EDGE_SAMPLES; k++) {
            add_sample(model, edge, k / (TAUT_EDGE_SAMPLES - 1.0), &identity, most, proof);
        }
    }
    taut_arena_free(arena);
    return status;
}
