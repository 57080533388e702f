#include "construct/asymptotic/patch.h"

#include "construct/asymptotic/poly.h"

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

void taut_patch_boundary(const taut_quad *quad, taut_patch *patch)
{
    const int n = quad->degree, m = patch->m;
    for (int e = 0; e < 4; e++) {
        double low[TAUT_QUAD_POINTS][4], high[TAUT_QUAD_PATCH + 1][4];
        taut_quad_homogeneous(&quad->edges[e], n, low);
        taut_poly_elevate(n, 4, &low[0][0], m - n, &high[0][0]);
        for (int k = 0; k <= m; k++) {
            memcpy(taut_patch_at(patch, e, 0, k), high[k], sizeof high[k]);
        }
    }
}
