/* test_parts.c -- surfaces and nets as cells and strokes: where they lie, and how many. */
#include "cameras.h"
#include "check.h"
#include "shapes.h"

#include "draw/parts.h"
#include "draw/sheet.h"

#include <stdlib.h>

enum { WIDTH = 1000, HEIGHT = 800 };

/* The longest side of a cell, in page units. */
static double longest_side(const taut_sheet *sheet, const taut_camera *camera)
{
    const int nv = sheet->v.count, count = sheet->u.count * nv;
    double longest = 0;
    for (int i = 0; i < count; i++) {
        const double *p = sheet->points + 3 * i;
        for (int step = 1; step <= nv && i + step < count; step += nv - 1) {
            const double *q = p + 3 * step;
            const double d = hypot(hypot(q[0] - p[0], q[1] - p[1]), q[2] - p[2]);
            longest = step > 1 || (i + 1) % nv != 0 ? fmax(longest, d) : longest;
        }
    }
    return longest * camera->scale / camera->half;
}

/* The silhouette of a sphere of radius R is the circle of radius R about its centre. Its points lie
 * on sides of cells, chords of length c: up to c^2 / (8 R) inside the sphere; and at a boundary,
 * where the normal is the mean of cells on one side only, up to c/2 beside the circle, which is
 * again c^2 / (8 R) inside. */
static void test_silhouette(void)
{
    taut_surface *surface = shape_octant(2);
    size_t found = 0;
    for (int trial = 0; trial < 200; trial++) {
        const double origin[3] = {0, 0, 0};
        const taut_write_options options = {.no_net = 1};
        taut_arena *arena = taut_arena_new();
        taut_sheet sheet = {.surface = NULL};
        taut_camera camera;
        taut_scene scene;
        double centre[3], *page = NULL;
        CHECK(taut_sheet_new(surface, 400, 100000, &options, arena, &sheet) == TAUT_OK, "sheet");
        camera_on(&sheet, random_in(-180, 180), random_in(-80, 80), WIDTH, HEIGHT, &camera);
        CHECK(taut_scene_init(&scene, WIDTH, HEIGHT, arena) == TAUT_OK, "scene");
        CHECK(taut_parts_cells(&sheet, &camera, (taut_ink){0, 0, 0}, 1, arena, &scene, &page) ==
                  TAUT_OK,
              "cells");
        CHECK(taut_parts_silhouette(&sheet, page, arena, &scene) == TAUT_OK, "silhouette");
        taut_camera_project(&camera, origin, centre);
        const double radius = 2 * camera.scale / camera.half;
        const double side = longest_side(&sheet, &camera);
        for (size_t i = 0; i < scene.point_count; i++) {
            const double x = scene.points[i][0] - centre[0], y = scene.points[i][1] - centre[1];
            CHECK_NEAR(hypot(x, y), radius, side * side / (4 * radius), "trial %d", trial);
        }
        found += scene.point_count;
        taut_scene_clear(&scene);
        taut_arena_free(arena);
    }
    CHECK(found > 1000, "%zu points", found);
    taut_surface_free(surface);
}

static taut_surface *wide(int count)
{
    const taut_basis_spec spec = {.type = "bspline", .degree = 3, .count = count};
    double *points = calloc(3 * (size_t)count * (size_t)count, sizeof(double));
    taut_basis *basis = NULL;
    taut_surface *surface = NULL;
    for (int i = 0; i < count * count; i++) {
        points[3 * i] = i / count;
        points[3 * i + 1] = i % count;
    }
    CHECK(taut_basis_new(&spec, count, &basis, NULL) == TAUT_OK, "basis");
    CHECK(taut_surface_new("", basis, basis, points, NULL, &surface, NULL) == TAUT_OK, "surface");
    taut_basis_free(basis);
    free(points);
    return surface;
}

/* Every line of a small net is drawn, and every point; of a large one at most 34 lines a way, the
 * first and the last among them, and no points. */
static void test_thinning(void)
{
    static const int counts[] = {4, 33, 34, 35, 100, 131, 133, 500, 1000};
    for (int k = 0; k < 9; k++) {
        const int n = counts[k];
        const taut_write_options options = {.no_net = 0};
        taut_surface *surface = wide(n);
        taut_arena *arena = taut_arena_new();
        taut_sheet sheet = {.surface = NULL};
        taut_camera camera;
        taut_scene scene;
        size_t discs = 0, lines = 0;
        double low = INFINITY, high = -INFINITY;
        CHECK(taut_sheet_new(surface, 400, 1000, &options, arena, &sheet) == TAUT_OK, "sheet");
        camera_on(&sheet, -90, 90, WIDTH, HEIGHT, &camera);
        CHECK(taut_scene_init(&scene, WIDTH, HEIGHT, arena) == TAUT_OK, "scene");
        CHECK(taut_parts_net(n, n, taut_surface_points(surface), &camera, arena, &scene) == TAUT_OK,
              "net");
        taut_parts_net_points(n, n, taut_surface_points(surface), &camera, &scene);
        for (size_t i = 0; i < scene.stroke_count; i++) {
            const taut_stroke *s = &scene.strokes[i];
            discs += s->count == 1;
            lines += s->count > 1;
            CHECK(s->count <= 134, "%d points along", s->count);
            low = fmin(low, scene.points[s->first][0]);
            high = fmax(high, scene.points[s->first][0]);
        }
        CHECK(n > 33 || (lines == 2 * (size_t)n && discs == (size_t)(n * n)), "%d: %zu, %zu", n,
              lines, discs);
        CHECK(n <= 33 || (lines <= 68 && lines >= 34 && discs == 0), "%d: %zu, %zu", n, lines,
              discs);
        CHECK_NEAR(high - low, (n - 1) * camera.scale / camera.half, 1e-6, "first and last, n=%d",
                   n);
        taut_scene_clear(&scene);
        taut_arena_free(arena);
        taut_surface_free(surface);
    }
}

/* Cells are about as many as asked for, also with more spans than that; breaks are among the lines
 * as long as there is room; `divide` is obeyed up to `most`. */
static void test_cells(void)
{
    static const int counts[] = {4, 5, 20, 60, 61, 400};
    for (int k = 0; k < 6; k++) {
        const int spans = counts[k] - 3;
        taut_surface *surface = wide(counts[k]);
        for (int divide = 0; divide <= 3; divide++) {
            const taut_write_options options = {.divide = divide};
            taut_arena *arena = taut_arena_new();
            taut_sheet sheet = {.surface = NULL};
            CHECK(taut_sheet_new(surface, 3600, 40000, &options, arena, &sheet) == TAUT_OK, "n=%d",
                  counts[k]);
            const int u = sheet.u.count - 1, v = sheet.v.count - 1;
            CHECK(u == v, "%d by %d", u, v);
            if (divide > 0) {
                CHECK(u == (spans * divide <= 200 ? spans * divide : u) && u <= 200, "%d", u);
            } else {
                CHECK(u >= 40 && u <= 90, "n=%d: %d cells", counts[k], u);
            }
            for (int i = 0; i < u; i++) {
                CHECK(sheet.u.at[i] < sheet.u.at[i + 1] && sheet.u.middle[i] > sheet.u.at[i] &&
                          sheet.u.middle[i] < sheet.u.at[i + 1],
                      "lines in order at %d", i);
            }
            CHECK(sheet.u.at[0] == 0 && sheet.u.at[u] == 1, "the whole range");
            taut_arena_free(arena);
        }
        taut_surface_free(surface);
    }
}

int main(void)
{
    random_seed(20260413);
    test_silhouette();
    test_thinning();
    test_cells();
    return check_failures != 0;
}
