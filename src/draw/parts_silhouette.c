/* parts_silhouette.c -- where a surface turns away from the viewer.
 *
 * g = the part of the normal towards the eye, at each grid point the mean of the cells around it;
 * the silhouette is g = 0, linear along the sides of the cells (marching squares).
 */
#include "draw/parts.h"

#include <math.h>

static const taut_ink silhouette_ink = {52, 60, 76};
static const double silhouette_width = 1.1;

/* The eye's part of a cell's normal in units of its length, from the diagonals; 0 where the cell
 * is a line to the eye or has no area. */
static double facing(const double *a, const double *b, const double *c, const double *d)
{
    const double p[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const double q[3] = {d[0] - b[0], d[1] - b[1], d[2] - b[2]};
    const double x = p[1] * q[2] - p[2] * q[1], y = p[2] * q[0] - p[0] * q[2];
    const double z = p[0] * q[1] - p[1] * q[0];
    const double length = hypot(hypot(x, y), z);
    return fabs(z) > 1e-9 * length ? z / length : 0;
}

static void fill_facing(size_t nu, size_t nv, const double *page, double *g)
{
    for (size_t i = 0; i + 1 < nu; i++) {
        for (size_t j = 0; j + 1 < nv; j++) {
            const size_t at = i * nv + j;
            const double f = facing(page + 3 * at, page + 3 * (at + nv), page + 3 * (at + nv + 1),
                                    page + 3 * (at + 1));
            if (isfinite(f)) {
                g[at] += f;
                g[at + nv] += f;
                g[at + nv + 1] += f;
                g[at + 1] += f;
            }
        }
    }
}

/* The points of g = 0 on the four sides of a cell, at most four; returns how many. */
static int crossings(const size_t corner[4], const double *page, const double *g, double at[4][3])
{
    int count = 0;
    for (int k = 0; k < 4; k++) {
        const size_t a = corner[k], b = corner[(k + 1) % 4];
        if ((g[a] < 0 && g[b] > 0) || (g[a] > 0 && g[b] < 0)) {
            const double t = g[a] / (g[a] - g[b]);
            for (int c = 0; c < 3; c++) {
                at[count][c] = page[3 * a + (size_t)c] +
                               t * (page[3 * b + (size_t)c] - page[3 * a + (size_t)c]);
            }
            count++;
        }
    }
    return count;
}

taut_status taut_parts_silhouette(const taut_sheet *sheet, const double *page, taut_arena *arena,
                                  taut_scene *scene)
{
    const size_t nu = (size_t)sheet->u.count, nv = (size_t)sheet->v.count;
    double *g = taut_arena_take(arena, nu * nv, sizeof(double));

    if (g == NULL) {
        return TAUT_NO_MEMORY;
    }
    fill_facing(nu, nv, page, g);
    for (size_t i = 0; i + 1 < nu; i++) {
        for (size_t j = 0; j + 1 < nv; j++) {
            const size_t first = i * nv + j;
            const size_t corner[4] = {first, first + nv, first + nv + 1, first + 1};
            double at[4][3];
            const int count = crossings(corner, page, g, at);
            for (int k = 0; k + 1 < count; k += 2) {
                taut_scene_line(scene, 2, at[k], silhouette_ink, silhouette_width);
            }
        }
    }
    return scene->status;
}
