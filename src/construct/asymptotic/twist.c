/* twist.c -- one twist R_uv at each corner (docs page (5.3)). */
#include "construct/asymptotic/conditions.h"
#include "construct/asymptotic/ribbon.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/bernstein.h"
#include "numeric/dense.h"

#include <string.h>

static const double twist_match = 1e-9; /* relative: torsions that match to 1e-10 pass */

/* How much R_uv moves with the neighbour of the end alpha: +-(3n-5) w r'. */
static double neighbour_factor(const taut_quad *quad, const taut_quad_meeting *m)
{
    const double w = taut_quad_weight(quad, m->edge, m->end, 0);
    return (m->end == 0 ? 1.0 : -1.0) * (3 * quad->degree - 5) * w;
}

static void set_neighbour(const taut_quad *quad, const taut_quad_meeting *m, double alpha,
                          taut_ribbon ribbons[4])
{
    const int last = 3 * quad->degree - 5;
    ribbons[m->edge].alpha[m->end == 0 ? 1 : last - 1] = alpha;
}

/* Both edges curved:
 *     slope_e + f_e alpha_e r_e' = slope_f + f_f alpha_f r_f';
 * what is missed is |tau_e + tau_f| |r_e'| |r_f'| sin A. */
static taut_status match_twists(const taut_quad *quad, int c, taut_ribbon ribbons[4],
                                double twist[3], taut_error *error)
{
    const taut_quad_meeting *const m = taut_quad_corner[c];
    double slope[2][3], a[6], b[3], alpha[2], miss[3], noise = 0.0;
    for (int k = 0; k < 2; k++) {
        const double factor = (k == 0 ? 1.0 : -1.0) * neighbour_factor(quad, &m[k]);
        const double torsion = taut_quad_torsion(quad, m[k].edge, m[k].end);
        taut_ribbon_slope(quad, m[k].edge, m[k].end, &ribbons[m[k].edge], slope[k]);
        noise += taut_quad_torsion_rounding(quad, m[k].edge, m[k].end, torsion);
        for (int i = 0; i < 3; i++) {
            a[3 * k + i] = factor * ribbons[m[k].edge].tangent[m[k].end][i];
        }
    }
    taut_difference(slope[1], slope[0], b);
    (void)taut_least_norm(3, 2, a, b, 1e-12, alpha, NULL);
    for (int i = 0; i < 3; i++) {
        twist[i] = slope[0][i] + a[i] * alpha[0];
        miss[i] = twist[i] - (slope[1][i] - a[3 + i] * alpha[1]);
    }
    for (int k = 0; k < 2; k++) {
        set_neighbour(quad, &m[k], alpha[k], ribbons);
    }
    noise *= taut_norm(ribbons[m[0].edge].tangent[m[0].end]) *
             taut_norm(ribbons[m[1].edge].tangent[m[1].end]);
    if (!(taut_norm(miss) <= twist_match * fmax(taut_norm(twist), taut_norm(slope[0])) + noise)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "twist", "", taut_norm(miss), taut_none,
                         "the ribbons of %s and %s have no common twist at corner %s: they differ "
                         "by %.3g of it, because their torsions are not opposite",
                         taut_asymptotic_edge_name(m[0].edge), taut_asymptotic_edge_name(m[1].edge),
                         taut_asymptotic_corner_name(c), taut_norm(miss) / taut_norm(twist));
    }
    return TAUT_OK;
}

/* P_00 - P_10 - P_01 + P_11 of the four corner points. */
static void bilinear_twist(const taut_quad *quad, double twist[3])
{
    for (int k = 0; k < 3; k++) {
        twist[k] = taut_quad_point(quad, 0, 0, 0)[k] - taut_quad_point(quad, 0, 1, 0)[k] -
                   taut_quad_point(quad, 2, 0, 0)[k] + taut_quad_point(quad, 2, 1, 0)[k];
    }
}

/* N = W T with T the cubic that takes the partners' derivatives and the corner twists at its ends,
 * raised to degree m. */
static void straight_ribbon(const taut_quad *quad, int e, double twist[4][3],
                            taut_ribbon ribbons[4])
{
    const int n = quad->degree;
    double cubic[4][3], product[TAUT_QUAD_POINTS + 3][3];
    for (int end = 0; end < 2; end++) {
        const taut_quad_meeting *const f = &taut_quad_partner[e][end];
        const double *const value = ribbons[f->edge].tangent[f->end];
        memcpy(cubic[end == 0 ? 0 : 3], value, sizeof cubic[0]);
        memcpy(cubic[end == 0 ? 1 : 2], value, sizeof cubic[0]);
        taut_add_scaled(end == 0 ? 1.0 / 3 : -1.0 / 3, twist[f->corner], cubic[end == 0 ? 1 : 2]);
    }
    taut_bernstein_scale(n, quad->edges[e].weights, 3, 3, &cubic[0][0], &product[0][0]);
    taut_bernstein_raise(n + 3, 3, &product[0][0], 4 * n - 10, &ribbons[e].numerator[0][0]);
}

taut_status taut_ribbon_twists(const taut_quad *quad, taut_ribbon ribbons[4], double twist[4][3],
                               taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int c = 0; c < 4 && status == TAUT_OK; c++) {
        const taut_quad_meeting *const m = taut_quad_corner[c];
        const int s0 = ribbons[m[0].edge].straight, s1 = ribbons[m[1].edge].straight;
        if (s0 && s1) {
            bilinear_twist(quad, twist[c]);
        } else if (s0 || s1) {
            const taut_quad_meeting *const curved = &m[s0 ? 1 : 0];
            taut_ribbon_slope(quad, curved->edge, curved->end, &ribbons[curved->edge], twist[c]);
        } else {
            status = match_twists(quad, c, ribbons, twist[c], error);
        }
    }
    for (int e = 0; e < 4 && status == TAUT_OK; e++) {
        if (ribbons[e].straight) {
            straight_ribbon(quad, e, twist, ribbons);
        } else {
            taut_ribbon_numerator(quad->degree, &ribbons[e]);
        }
    }
    return status;
}
