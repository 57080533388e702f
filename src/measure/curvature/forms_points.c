/* forms_points.c -- fundamental forms and curvatures at parameters in no order: the surface's six vectors
 * at each, sums of differences of points along v first. */
#include "geometry/net.h"
#include "platform/parallel.h"
#include "taut/limits.h"
#include "taut/measure.h"

#include <stdint.h>
#include <string.h>

typedef struct places {
    const taut_surface *surface;
    const double *u, *v;
    taut_forms *forms;
} places;

/* h[k] = sum_ab d^kN (w (x - o), w)_ab, o the first point alive, w over its weight: what is small beside
 * the distance from the origin keeps its digits. */
static void sum_net(const taut_surface *surface, int su, int sv, double u, double v,
                    double origin[3], double h[6][4])
{
    const taut_basis *bu = taut_surface_u(surface), *bv = taut_surface_v(surface);
    const int64_t columns = taut_basis_count(bv);
    const int64_t first = taut_basis_first(bu, su) * columns + taut_basis_first(bv, sv);
    const int local_u = taut_basis_local(bu), local_v = taut_basis_local(bv);
    const double *points = taut_surface_points(surface) + 3 * first;
    const double *weights = taut_surface_weights(surface);
    double nu[3 * (TAUT_DEGREE_MAX + 1)], nv[3 * (TAUT_DEGREE_MAX + 1)];

    memcpy(origin, points, 3 * sizeof *origin);
    memset(h, 0, 6 * sizeof h[0]);
    taut_basis_eval(bu, su, u, 2, nu);
    taut_basis_eval(bv, sv, v, 2, nv);
    for (int a = 0; a < local_u; a++) {
        double row[3][4] = {{0}};
        for (int b = 0; b < local_v; b++) {
            const double *point = points + 3 * (a * columns + b);
            const double w =
                weights != NULL ? weights[first + a * columns + b] / weights[first] : 1;
            for (int c = 0; c < 3; c++) { /* halves apart: neither overflows */
                const double away = 2 * (point[c] / 2 - origin[c] / 2) * w;
                row[0][c] += nv[b] * away;
                row[1][c] += nv[local_v + b] * away;
                row[2][c] += nv[2 * local_v + b] * away;
            }
            for (int l = 0; l < 3; l++) {
                row[l][3] += nv[l * local_v + b] * w;
            }
        }
        const double n[3] = {nu[a], nu[local_u + a], nu[2 * local_u + a]};
        for (int c = 0; c < 4; c++) {
            h[TAUT_X][c] += n[0] * row[0][c];
            h[TAUT_XU][c] += n[1] * row[0][c];
            h[TAUT_XV][c] += n[0] * row[1][c];
            h[TAUT_XUU][c] += n[2] * row[0][c];
            h[TAUT_XUV][c] += n[1] * row[1][c];
            h[TAUT_XVV][c] += n[0] * row[2][c];
        }
    }
}

static void find_forms(void *context, int part, int from, int to)
{
    const places *p = context;
    const taut_basis *bu = taut_surface_u(p->surface), *bv = taut_surface_v(p->surface);
    (void)part;
    for (int i = from; i < to; i++) {
        const int su = taut_basis_span(bu, p->u[i]), sv = taut_basis_span(bv, p->v[i]);
        double h[6][4], values[6][3], origin[3];
        sum_net(p->surface, su, sv, p->u[i], p->v[i], origin, h);
        for (int k = 0; k < 6; k++) {
            memcpy(values[k], h[k], sizeof values[k]);
        }
        if (taut_surface_weights(p->surface) != NULL) {
            taut_net_project(2, h[0], values[0]);
        }
        for (int c = 0; c < 3; c++) {
            values[TAUT_X][c] += origin[c];
        }
        taut_forms_of((const double(*)[3])values, &p->forms[i]);
    }
}

static int are_inside(const taut_basis *basis, int count, const double *t)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    for (int i = 0; i < count; i++) {
        if (!(t[i] >= lo && t[i] <= hi)) {
            return 0;
        }
    }
    return 1;
}

taut_status taut_surface_forms_points(const taut_surface *surface, int count, const double *u,
                                      const double *v, int threads, taut_forms *forms)
{
    if (surface == NULL || u == NULL || v == NULL || forms == NULL || count < 0 || threads < 0 ||
        threads > TAUT_THREADS_MAX || !are_inside(taut_surface_u(surface), count, u) ||
        !are_inside(taut_surface_v(surface), count, v)) {
        return TAUT_BAD_ARGUMENT;
    }
    places all = {surface, u, v, forms};
    taut_parallel_for(count, threads, find_forms, &all);
    return TAUT_OK;
}
