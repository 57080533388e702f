#include "draw/depth.h"

#include <math.h>
#include <string.h>

enum { TILE = 8 /* page units */, ROOM = 256 };

int taut_depth_new(int width, int height, taut_arena *arena, taut_depth *depth)
{
    const size_t count = (size_t)width * (size_t)height;
    const int columns = (width + TILE - 1) / TILE, rows = (height + TILE - 1) / TILE;
    *depth = (taut_depth){
        .width = width, .height = height, .columns = columns, .rows = rows, .arena = arena};
    depth->nearest = taut_arena_take(arena, count, sizeof(float));
    depth->tiles = taut_arena_take(arena, (size_t)columns * (size_t)rows, sizeof *depth->tiles);
    for (size_t i = 0; depth->nearest != NULL && i < count; i++) {
        depth->nearest[i] = -INFINITY;
    }
    return depth->tiles != NULL;
}

/* x in [0, limit - 1] */
static int clamp_index(double x, int limit)
{
    return (int)fmin(fmax(x, 0), limit - 1);
}

/* The cells of `size` that the triangle's box meets: x0, x1, y0, y1. */
static void find_box(const double t[9], double size, int columns, int rows, int box[4])
{
    box[0] = clamp_index(floor(fmin(t[0], fmin(t[3], t[6])) / size), columns);
    box[1] = clamp_index(floor(fmax(t[0], fmax(t[3], t[6])) / size), columns);
    box[2] = clamp_index(floor(fmin(t[1], fmin(t[4], t[7])) / size), rows);
    box[3] = clamp_index(floor(fmax(t[1], fmax(t[4], t[7])) / size), rows);
}

/* Twice the signed area of a, b, (x, y). */
static double side_of(const double a[3], const double b[3], double x, double y)
{
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

/* The depth of the triangle at (x, y), -INFINITY beside it. The weights of the corners are the areas of the opposite triangles; all
 * of one sign means inside, border included, so that neighbours leave no crack. */
static double depth_at(const double t[9], double x, double y)
{
    const double area = side_of(t, t + 3, t[6], t[7]);
    const double wa = side_of(t + 3, t + 6, x, y) / area, wb = side_of(t + 6, t, x, y) / area;
    const double wc = 1 - wa - wb;
    return wa >= 0 && wb >= 0 && wc >= -1e-9 ? wa * t[2] + wb * t[5] + wc * t[8] : -INFINITY;
}

/* In front of the list of every tile that its box meets. */
static int keep_triangle(taut_depth *depth, const double t[9])
{
    int box[4];
    find_box(t, TILE, depth->columns, depth->rows, box);
    for (int y = box[2]; y <= box[3]; y++) {
        for (int x = box[0]; x <= box[1]; x++) {
            const taut_depth_entry **tile =
                &depth->tiles[(size_t)y * (size_t)depth->columns + (size_t)x];
            if (depth->left == 0) {
                depth->room = taut_arena_take_raw(depth->arena, ROOM, sizeof *depth->room);
                depth->left = ROOM;
            }
            if (depth->room == NULL) {
                return 0;
            }
            taut_depth_entry *entry = &depth->room[--depth->left];
            memcpy(entry->corners, t, sizeof entry->corners);
            entry->next = *tile;
            *tile = entry;
        }
    }
    return 1;
}

int taut_depth_triangle(taut_depth *depth, const double a[3], const double b[3], const double c[3])
{
    const double t[9] = {a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]};
    int box[4];

    if (!(fabs(side_of(a, b, c[0], c[1])) > 1e-12)) {
        return 1;
    }
    find_box(t, 1, depth->width, depth->height, box);
    for (int y = box[2]; y <= box[3]; y++) {
        float *row = depth->nearest + (size_t)y * (size_t)depth->width;
        for (int x = box[0]; x <= box[1]; x++) {
            row[x] = fmaxf(row[x], (float)depth_at(t, x + 0.5, y + 0.5));
        }
    }
    return keep_triangle(depth, t);
}

double taut_depth_at(const taut_depth *depth, double x, double y)
{
    const int column = clamp_index(floor(x), depth->width),
              row = clamp_index(floor(y), depth->height);
    return (double)depth->nearest[(size_t)row * (size_t)depth->width + (size_t)column];
}

static int is_behind(const taut_depth *depth, double x, double y, double z)
{
    if (!(x >= 0 && y >= 0 && x < depth->width && y < depth->height)) {
        return 0;
    }
    const taut_depth_entry *entry =
        depth->tiles[(size_t)(y / TILE) * (size_t)depth->columns + (size_t)(x / TILE)];
    while (entry != NULL && !(depth_at(entry->corners, x, y) > z)) {
        entry = entry->next;
    }
    return entry != NULL;
}

int taut_depth_hides(const taut_depth *depth, const double at[3], double reach, double slack)
{
    const double around[5][2] = {{0, 0}, {reach, 0}, {0, reach}, {-reach, 0}, {0, -reach}};
    for (int k = 0; k < 5; k++) {
        if (!is_behind(depth, at[0] + around[k][0], at[1] + around[k][1], at[2] + slack)) {
            return 0;
        }
    }
    return 1;
}
