/* parts_silhouette.c -- where a surface turns away from the viewer.
 *
 * g = the part of the normal towards the eye, at each grid point the mean of the cells around it;
 * the silhouette is g = 0, linear along the sides of the cells (marching squares).
 */
#include "core/elementary/elementary.h"
#include "draw/parts.h"

#include <math.h>

static const taut_ink silhouette_ink = {52, 60, 76};
static const double silhouette_width = 1.1, silhouette_reach = 1.5;

/* The eye's part of a cell's normal in units of its length, from the diagonals; 0 where the cell
 * is a line to the eye or has no area. */
static double facing_of(const double *a, const double *b, const double *c, const double *d)
{
    const double p[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const double q[3] = {d[0] - b[0], d[1] - b[1], d[2] - b[2]};
    const double x = p[1] * q[2] - p[2] * q[1], y = p[2] * q[0] - p[0] * q[2];
    const double z = p[0] * q[1] - p[1] * q[0];
    const double length = taut_hypot(taut_hypot(x, y), z);
    return fabs(z) > 1e-9 * length ? z / length : 0;
}

static void fill_facing(size_t nu, size_t nv, const double *page, double *g)
{
    for (size_t i = 0; i + 1 < nu; i++) {
        for (size_t j = 0; j + 1 < nv; j++) {
            const size_t at = i * nv + j;
            const double f = facing_of(page + 3 * at, page + 3 * (at + nv),
                                       page + 3 * (at + nv + 1), page + 3 * (at + 1));
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
static int find_crossings(const size_t corner[4], const double *page, const double *g,
                          double at[4][3])
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

/* Does the page fall away, by more than 2 units of depth or to nothing, beyond a piece of
 * silhouette? The surface lies to its `side`; beyond is the other. On the branch that goes back
 * from a cusp a nearer sheet covers that, so closely that the branch alone would count as lying on
 * it. */
static int falls_away(const taut_depth *depth, const double a[3], const double b[3],
                      const double side[2])
{
    const double d[2] = {b[0] - a[0], b[1] - a[1]}, length = taut_hypot(d[0], d[1]);
    const double away = d[0] * side[1] - d[1] * side[0] > 0 ? -2.5 : 2.5;
    if (!(length > 0)) {
        return 0;
    }
    return taut_depth_at(depth, (a[0] + b[0]) / 2 - away * d[1] / length,
                         (a[1] + b[1]) / 2 + away * d[0] / length) < (a[2] + b[2]) / 2 - 2;
}

/* The grid and g on it. */
typedef struct field {
    size_t nu, nv;
    const double *page;
    double *g;
} field;

/* Where the surface lies beside its fold in cell (i, j), as a direction on the page. At a fold x_u
 * and x_v are parallel on the page, and w = (|x_v|, -+|x_u|) is the way in the parameters that
 * stands still there; the surface turns to the side of x_ww. Differences at the grid point next to
 * the cell. 0 where the grid is too small to tell. */
static void fold_side(const field *f, size_t i, size_t j, double side[2])
{
    const size_t r = i > 0 ? i : 1, s = j > 0 ? j : 1, nv = f->nv;
    double du[2], dv[2];

    side[0] = side[1] = 0;
    if (r + 1 >= f->nu || s + 1 >= nv) {
        return;
    }
    const double *here = f->page + 3 * (r * nv + s);
    const double *before = here - 3 * nv, *after = here + 3 * nv; /* along u */
    const double *left = here - 3, *right = here + 3;             /* along v */
    for (size_t c = 0; c < 2; c++) {
        du[c] = (after[c] - before[c]) / 2;
        dv[c] = (right[c] - left[c]) / 2;
    }
    const double a = taut_hypot(dv[0], dv[1]);
    const double b = taut_hypot(du[0], du[1]) * (du[0] * dv[0] + du[1] * dv[1] > 0 ? -1 : 1);
    for (size_t c = 0; c < 2; c++) {
        const double uu = after[c] - 2 * here[c] + before[c];
        const double vv = right[c] - 2 * here[c] + left[c];
        const double uv = ((after + 3)[c] - (after - 3)[c] - (before + 3)[c] + (before - 3)[c]) / 4;
        side[c] = a * a * uu + 2 * a * b * uv + b * b * vv;
    }
}

/* The silhouette in cell (i, j). */
static void add_cell(const field *f, size_t i, size_t j, taut_scene *scene)
{
    const size_t first = i * f->nv + j;
    const size_t corner[4] = {first, first + f->nv, first + f->nv + 1, first + 1};
    double at[4][3], side[2];
    const int count = find_crossings(corner, f->page, f->g, at);

    for (int k = 0; k + 1 < count; k += 2) {
        fold_side(f, i, j, side);
        if (falls_away(&scene->depth, at[k], at[k + 1], side)) {
            taut_scene_fold(scene, 2, at[k], silhouette_ink, silhouette_width, silhouette_reach);
        }
    }
}

taut_status taut_parts_silhouette(const taut_sheet *sheet, const double *page, taut_arena *arena,
                                  taut_scene *scene)
{
    const size_t nu = (size_t)sheet->u.count, nv = (size_t)sheet->v.count;
    const field f = {nu, nv, page, taut_arena_take(arena, nu * nv, sizeof(double))};

    if (f.g == NULL) {
        return TAUT_NO_MEMORY;
    }
    fill_facing(nu, nv, page, f.g);
    for (size_t i = 0; i + 1 < nu; i++) {
        for (size_t j = 0; j + 1 < nv; j++) {
            add_cell(&f, i, j, scene);
        }
    }
    return scene->status;
}
