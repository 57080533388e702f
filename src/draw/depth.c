#include "draw/depth.h"

#include <math.h>

int taut_depth_new(int width, int height, taut_arena *arena, taut_depth *depth)
{
    const size_t count = (size_t)width * (size_t)height;
    depth->width = width;
    depth->height = height;
    depth->nearest = taut_arena_take(arena, count, sizeof(float));
    for (size_t i = 0; depth->nearest != NULL && i < count; i++) {
        depth->nearest[i] = -INFINITY;
    }
    return depth->nearest != NULL;
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

int taut_depth_hides(const taut_depth *depth, const double at[3], double slack)
{
    const int x = clamp_index(floor(at[0]), depth->width),
              y = clamp_index(floor(at[1]), depth->height);
    float farthest = INFINITY;
    for (int dy = -1; dy <= 1; dy++) {
        const int row = clamp_index(y + dy, depth->height);
        for (int dx = -1; dx <= 1; dx++) {
            const int column = clamp_index(x + dx, depth->width);
            farthest = fminf(farthest,
                             depth->nearest[(size_t)row * (size_t)depth->width + (size_t)column]);
        }
    }
    return at[2] + slack < (double)farthest;
}
