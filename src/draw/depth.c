#include "draw/depth.h"

#include "core/memory.h"

#include <math.h>
#include <string.h>

enum { TILE = 8 }; /* page units */

int taut_depth_new(int width, int height, taut_arena *arena, taut_depth *depth)
{
    const size_t count = (size_t)width * (size_t)height;
    memset(depth, 0, sizeof *depth);
    depth->width = width;
    depth->height = height;
    depth->nearest = taut_arena_take(arena, count, sizeof(float));
    for (size_t i = 0; depth->nearest != NULL && i < count; i++) {
        depth->nearest[i] = -INFINITY;
    }
    return depth->nearest != NULL;
}

void taut_depth_clear(taut_depth *depth)
{
    taut_free(depth->triangles);
    taut_free(depth->first);
    taut_free(depth->on);
    memset(depth, 0, sizeof *depth);
}

static void keep_triangle(taut_depth *depth, const double a[3], const double b[3],
                          const double c[3])
{
    if (depth->count == depth->room && depth->status == TAUT_OK) {
        const size_t wanted = 2 * depth->room + 1024;
        void *grown = taut_realloc(depth->triangles, wanted, sizeof *depth->triangles);
        depth->status = grown == NULL ? TAUT_NO_MEMORY : TAUT_OK;
        depth->triangles = grown == NULL ? depth->triangles : grown;
        depth->room = grown == NULL ? depth->room : wanted;
    }
    if (depth->status == TAUT_OK) {
        double *t = depth->triangles[depth->count++];
        memcpy(t, a, 3 * sizeof(double));
        memcpy(t + 3, b, 3 * sizeof(double));
        memcpy(t + 6, c, 3 * sizeof(double));
    }
}

/* x in [0, limit - 1] */
static int clamp_index(double x, int limit)
{
    return (int)fmin(fmax(x, 0), limit - 1);
}

/* Twice the signed area of a, b, (x, y). */
static double side_of(const double a[3], const double b[3], double x, double y)
{
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

/* At the middle (x, y) of each cell the weights of the corners are the areas of the opposite
 * triangles; all of one sign means inside, border included, so that neighbours leave no crack. */
void taut_depth_triangle(taut_depth *depth, const double a[3], const double b[3], const double c[3])
{
    const double area = side_of(a, b, c[0], c[1]);
    const int x0 = clamp_index(floor(fmin(a[0], fmin(b[0], c[0]))), depth->width);
    const int x1 = clamp_index(ceil(fmax(a[0], fmax(b[0], c[0]))), depth->width);
    const int y0 = clamp_index(floor(fmin(a[1], fmin(b[1], c[1]))), depth->height);
    const int y1 = clamp_index(ceil(fmax(a[1], fmax(b[1], c[1]))), depth->height);

    if (!(fabs(area) > 1e-12)) {
        return;
    }
    keep_triangle(depth, a, b, c);
    for (int y = y0; y <= y1; y++) {
        float *row = depth->nearest + (size_t)y * (size_t)depth->width;
        for (int x = x0; x <= x1; x++) {
            const double wa = side_of(b, c, x + 0.5, y + 0.5) / area;
            const double wb = side_of(c, a, x + 0.5, y + 0.5) / area;
            const double wc = 1 - wa - wb;
            if (wa >= 0 && wb >= 0 && wc >= -1e-9) {
                row[x] = fmaxf(row[x], (float)(wa * a[2] + wb * b[2] + wc * c[2]));
            }
        }
    }
}

double taut_depth_at(const taut_depth *depth, double x, double y)
{
    const int column = clamp_index(floor(x), depth->width),
              row = clamp_index(floor(y), depth->height);
    return (double)depth->nearest[(size_t)row * (size_t)depth->width + (size_t)column];
}

/* The tiles that a triangle's box meets: x0, x1, y0, y1. */
static void tiles_of(const taut_depth *depth, const double *t, int box[4])
{
    box[0] = clamp_index(floor(fmin(t[0], fmin(t[3], t[6])) / TILE), depth->columns);
    box[1] = clamp_index(floor(fmax(t[0], fmax(t[3], t[6])) / TILE), depth->columns);
    box[2] = clamp_index(floor(fmin(t[1], fmin(t[4], t[7])) / TILE), depth->rows);
    box[3] = clamp_index(floor(fmax(t[1], fmax(t[4], t[7])) / TILE), depth->rows);
}

/* Goes over the triangles, from the last, and the tiles of each: counts it in first[tile], or, once these are where the
 * tiles end, puts it in front of what a tile has. */
static void sort_triangles(taut_depth *depth, int puts)
{
    for (size_t k = depth->count; k-- > 0;) {
        int box[4];
        tiles_of(depth, depth->triangles[k], box);
        for (int y = box[2]; y <= box[3]; y++) {
            for (int x = box[0]; x <= box[1]; x++) {
                size_t *at = &depth->first[(size_t)y * (size_t)depth->columns + (size_t)x];
                if (puts) {
                    depth->on[--*at] = k;
                } else {
                    ++*at;
                }
            }
        }
    }
}

/* Triangles by tiles, by counting. */
static void fill_tiles(taut_depth *depth)
{
    depth->columns = (depth->width + TILE - 1) / TILE;
    depth->rows = (depth->height + TILE - 1) / TILE;
    const size_t tiles = (size_t)depth->columns * (size_t)depth->rows;
    depth->first = taut_alloc_zero(tiles + 1, sizeof *depth->first);
    if (depth->first == NULL) {
        depth->status = TAUT_NO_MEMORY;
        return;
    }
    sort_triangles(depth, 0);
    for (size_t k = 1; k <= tiles; k++) {
        depth->first[k] += depth->first[k - 1];
    }
    depth->on = taut_alloc_zero(depth->first[tiles] + 1, sizeof *depth->on);
    if (depth->on == NULL) {
        depth->status = TAUT_NO_MEMORY;
        return;
    }
    sort_triangles(depth, 1);
}

/* Does a ray through (x, y) meet the triangle nearer than z? Its border counts, so that neighbours leave no crack. */
static int meets_nearer(const double *t, double x, double y, double z)
{
    const double area = side_of(t, t + 3, t[6], t[7]);
    const double wa = side_of(t + 3, t + 6, x, y) / area, wb = side_of(t + 6, t, x, y) / area;
    const double wc = 1 - wa - wb;
    return wa >= 0 && wb >= 0 && wc >= -1e-9 && wa * t[2] + wb * t[5] + wc * t[8] > z;
}

static int is_behind(const taut_depth *depth, double x, double y, double z)
{
    if (!(x >= 0 && y >= 0 && x < depth->width && y < depth->height)) {
        return 0;
    }
    const size_t tile = (size_t)(y / TILE) * (size_t)depth->columns + (size_t)(x / TILE);
    for (size_t k = depth->first[tile]; k < depth->first[tile + 1]; k++) {
        if (meets_nearer(depth->triangles[depth->on[k]], x, y, z)) {
            return 1;
        }
    }
    return 0;
}

int taut_depth_hides(taut_depth *depth, const double at[3], double reach, double slack)
{
    const double around[5][2] = {{0, 0}, {reach, 0}, {0, reach}, {-reach, 0}, {0, -reach}};
    if (depth->first == NULL && depth->status == TAUT_OK) {
        fill_tiles(depth);
    }
    for (int k = 0; k < 5; k++) {
        if (depth->status != TAUT_OK ||
            !is_behind(depth, at[0] + around[k][0], at[1] + around[k][1], at[2] + slack)) {
            return 0;
        }
    }
    return 1;
}
