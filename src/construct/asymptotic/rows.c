/* rows.c -- docs page section 5, steps 3 and 4. The weights' cross difference along an edge is
 * H W with H of degree h = 4n - 7; its end values come from the partners' weights, their
 * neighbours from the corner weight W_11, for which the two edges' proposals are averaged. */
#include "construct/asymptotic/ribbon.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/bernstein.h"

#include <string.h>

enum { LENGTH_H = 4 * TAUT_QUAD_DEGREE - 6 };

static int is_low(int e)
{
    return e == TAUT_ASYMPTOTIC_V0 || e == TAUT_ASYMPTOTIC_U0;
}

/* First difference of the boundary weights of edge f at its end, along its parameter. */
static double weight_step(const taut_patch *patch, int f, int end)
{
    const int m = patch->m;
    return end == 0 ? taut_patch_at(patch, f, 0, 1)[3] - taut_patch_at(patch, f, 0, 0)[3]
                    : taut_patch_at(patch, f, 0, m)[3] - taut_patch_at(patch, f, 0, m - 1)[3];
}

/* W_11 at an end of edge e as the edge alone would have it, with H zero but for its ends. */
static double proposed_weight(const taut_quad *quad, const taut_patch *patch, const double *h,
                              int e, int end)
{
    const int n = quad->degree, m = patch->m;
    double product[TAUT_QUAD_PATCH + 1];
    const int k = end == 0 ? 1 : m - 1;
    taut_bernstein_scale(4 * n - 7, h, n, 1, quad->edges[e].weights, product);
    return taut_patch_at(patch, e, 0, k)[3] + (is_low(e) ? product[k] : -product[k]);
}

static void fill_h(const taut_quad *quad, taut_patch *patch, double h[4][LENGTH_H])
{
    const int degree = 4 * quad->degree - 7;
    memset(h, 0, 4 * sizeof *h);
    for (int e = 0; e < 4; e++) {
        for (int end = 0; end < 2; end++) {
            const taut_quad_meeting *const f = &taut_quad_partner[e][end];
            h[e][end == 0 ? 0 : degree] =
                weight_step(patch, f->edge, f->end) / taut_quad_weight(quad, e, end, 0);
        }
    }
    for (int c = 0; c < 4; c++) {
        const taut_quad_meeting *const m = taut_quad_corner[c];
        double proposed[2];
        for (int k = 0; k < 2; k++) {
            proposed[k] = proposed_weight(quad, patch, h[m[k].edge], m[k].edge, m[k].end);
        }
        patch->weight[c] = 0.5 * (proposed[0] + proposed[1]);
        for (int k = 0; k < 2; k++) {
            const double w = taut_quad_weight(quad, m[k].edge, m[k].end, 0);
            const double step = patch->m / (degree * w) * (patch->weight[c] - proposed[k]);
            h[m[k].edge][m[k].end == 0 ? 1 : degree - 1] += is_low(m[k].edge) ? step : -step;
        }
    }
}

/* (5.4): the row beside edge e, entries 1 .. m-1; an entry that two edges give is their mean,
 * by their shares. */
static void fill_row(const taut_quad *quad, const taut_ribbon *ribbon, const double *h, int e,
                     taut_patch *patch)
{
    const int n = quad->degree, m = patch->m;
    const double sign = is_low(e) ? 1.0 : -1.0;
    double edge[TAUT_QUAD_POINTS][4], product[TAUT_QUAD_PATCH + 1][4];
    taut_quad_homogeneous(&quad->edges[e], n, edge);
    taut_bernstein_scale(4 * n - 7, h, n, 4, &edge[0][0], &product[0][0]);
    for (int k = 1; k < m; k++) {
        const double share = k == 1 ? patch->share[e][0] : k == m - 1 ? patch->share[e][1] : 1.0;
        double *const made = taut_patch_at(patch, e, 1, k);
        const double *const boundary = taut_patch_at(patch, e, 0, k);
        for (int d = 0; d < 4; d++) {
            const double ribbon_part = d < 3 ? ribbon->numerator[k][d] / m : 0.0;
            made[d] += share * (boundary[d] + sign * (product[k][d] + ribbon_part));
        }
    }
}

static taut_status check_weights(const taut_patch *patch, taut_error *error)
{
    for (int e = 0; e < 4; e++) {
        for (int k = 1; k < patch->m; k++) {
            const double w = taut_patch_at(patch, e, 1, k)[3];
            if (!(w > 0) || !isfinite(w)) {
                return taut_fail(error, TAUT_NO_SOLUTION, "negative-weight", "", w, 0.0,
                                 "weight %d beside edge %s comes out as %.3g: take end weights and "
                                 "curvatures that differ less, or surface \"n+3\"",
                                 k, taut_asymptotic_edge_name(e), w);
            }
        }
    }
    return TAUT_OK;
}

taut_status taut_ribbon_rows(const taut_quad *quad, const taut_ribbon ribbons[4], taut_patch *patch,
                             taut_error *error)
{
    double h[4][LENGTH_H];
    taut_patch_boundary(quad, patch);
    fill_h(quad, patch, h);
    for (int e = 0; e < 4; e++) {
        fill_row(quad, &ribbons[e], h[e], e, patch);
    }
    for (int i = 2; i <= patch->m - 2; i++) {
        for (int j = 2; j <= patch->m - 2; j++) {
            patch->net[i * (patch->m + 1) + j][3] = 1.0;
        }
    }
    return check_weights(patch, error);
}
