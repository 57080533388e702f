#include "construct/asymptotic/patch.h"

#include "core/vec3.h"
#include "numeric/bernstein.h"

#include <math.h>
#include <string.h>

taut_status taut_patch_new(taut_arena *arena, int m, taut_patch *patch)
{
    memset(patch, 0, sizeof *patch);
    patch->m = m;
    patch->net = taut_arena_take(arena, (size_t)(m + 1) * (size_t)(m + 1), sizeof *patch->net);
    return patch->net != NULL ? TAUT_OK : TAUT_NO_MEMORY;
}

double *taut_patch_at(const taut_patch *patch, int edge, int depth, int k)
{
    const int m = patch->m;
    const int high = edge == TAUT_ASYMPTOTIC_V1 || edge == TAUT_ASYMPTOTIC_U1;
    const int across = high ? m - depth : depth;
    const int runs_with_u = edge == TAUT_ASYMPTOTIC_V0 || edge == TAUT_ASYMPTOTIC_V1;
    return runs_with_u ? patch->net[k * (m + 1) + across] : patch->net[across * (m + 1) + k];
}

void taut_quad_homogeneous(const taut_quad_edge *edge, int n, double (*h)[4])
{
    for (int j = 0; j <= n; j++) {
        for (int k = 0; k < 3; k++) {
            h[j][k] = edge->weights[j] * edge->points[j][k];
        }
        h[j][3] = edge->weights[j];
    }
}

/* Curvature squared of an edge at t: with p = (W r, W), r' = (p' - W' r) / W and r'' = p'' / W less
 * what lies along r and r'. */
static double bend_at(const taut_quad_edge *edge, int n, double t)
{
    double h[TAUT_QUAD_POINTS][4], p[3][4], d[2][3], normal[3], speed = 0.0;
    taut_quad_homogeneous(edge, n, h);
    for (int order = 0; order < 3; order++) {
        taut_bernstein_point(n - order, 4, &h[0][0], t, p[order], NULL);
        taut_bernstein_derivative(n - order, 4, &h[0][0], &h[0][0]);
    }
    for (int order = 1; order < 3; order++) {
        for (int k = 0; k < 3; k++) {
            d[order - 1][k] = (p[order][k] - p[order][3] * p[0][k] / p[0][3]) / p[0][3];
        }
    }
    taut_add_scaled(-2 * p[1][3] / p[0][3], d[0], d[1]);
    taut_cross(d[0], d[1], normal);
    speed = taut_dot(d[0], d[0]);
    return taut_dot(normal, normal) / (speed * speed * speed);
}

static void fill_shares(const taut_quad *quad, taut_patch *patch)
{
    double bend[4][2] = {{0}};
    for (int e = 0; e < 4; e++) {
        for (int k = 0; k < 6 && !quad->edges[e].straight; k++) {
            const double t = (double)(k / 2) / patch->m;
            bend[e][k % 2] += bend_at(&quad->edges[e], quad->degree, k % 2 == 0 ? t : 1.0 - t);
        }
    }
    for (int e = 0; e < 4; e++) {
        for (int end = 0; end < 2; end++) {
            const taut_quad_meeting *const f = &taut_quad_partner[e][end];
            const double share = bend[e][end] / (bend[e][end] + bend[f->edge][f->end]);
            patch->share[e][end] = share >= 0 && share <= 1 ? share : 0.5;
        }
    }
}

void taut_patch_boundary(const taut_quad *quad, taut_patch *patch)
{
    const int n = quad->degree, m = patch->m;
    for (int e = 0; e < 4; e++) {
        double low[TAUT_QUAD_POINTS][4], high[TAUT_QUAD_PATCH + 1][4];
        taut_quad_homogeneous(&quad->edges[e], n, low);
        taut_bernstein_raise(n, 4, &low[0][0], m - n, &high[0][0]);
        for (int k = 0; k <= m; k++) {
            memcpy(taut_patch_at(patch, e, 0, k), high[k], sizeof high[k]);
        }
    }
    fill_shares(quad, patch);
}
