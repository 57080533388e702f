/* test_marks.c -- isothermality, isolines, reflections, combs and reactions against closed forms.
 *
 * The saddle (x, y, x y), x = 2u - 1, y = 2v - 1, has E = 4 (1 + y^2), G = 4 (1 + x^2), F = 4 x y,
 * so isothermality = sqrt((E-G)^2 + 4 F^2) / (E+G) = (x^2 + y^2) / (2 + x^2 + y^2) K = -1 / (1 +
 * x^2 + y^2)^2 and its edges are straight. */
#include "cameras.h"
#include "check.h"
#include "sails.h"
#include "shapes.h"

#include "draw/parts.h"

#include <stdlib.h>
#include <string.h>

enum { WIDTH = 800, HEIGHT = 600 };
static const double PI = 3.141592653589793;

static taut_surface *saddle(void)
{
    static const double points[4][3] = {{-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {1, 1, 1}};
    return shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), &points[0][0], NULL);
}

static double exact(taut_colour colour, double x, double y)
{
    const double r = x * x + y * y;
    return colour == TAUT_COLOUR_ISOTHERMALITY ? r / (2 + r) : -1 / ((1 + r) * (1 + r));
}

/* Values in the middle and at the corners of cells; the corners are looked at a millionth of a cell
 * within, which moves a value by at most that times its slope, below 4 a cell. */
static void test_values(void)
{
    static const taut_colour colours[] = {TAUT_COLOUR_ISOTHERMALITY, TAUT_COLOUR_GAUSSIAN};
    static const int du[4] = {0, 1, 1, 0}, dv[4] = {0, 0, 1, 1};
    taut_surface *surface = saddle();
    for (int k = 0; k < 2; k++) {
        const taut_write_options options = {.colour = colours[k], .divide = 7};
        taut_arena *arena = taut_arena_new();
        taut_sheet s = {.surface = NULL};
        CHECK(taut_sheet_new(surface, 49, 1000, &options, arena, &s) == TAUT_OK, "sheet");
        CHECK(taut_sheet_corners(&options, arena, &s) == TAUT_OK, "corners");
        for (int i = 0; i + 1 < s.u.count; i++) {
            for (int j = 0; j + 1 < s.v.count; j++) {
                const size_t cell = (size_t)(i * (s.v.count - 1) + j);
                CHECK_NEAR(s.values[cell],
                           exact(colours[k], 2 * s.u.middle[i] - 1, 2 * s.v.middle[j] - 1), 1e-14,
                           "colour %d cell %d %d", k, i, j);
                for (int c = 0; c < 4; c++) {
                    CHECK_NEAR(
                        s.corners[4 * cell + (size_t)c],
                        exact(colours[k], 2 * s.u.at[i + du[c]] - 1, 2 * s.v.at[j + dv[c]] - 1),
                        4e-6, "colour %d cell %d %d corner %d", k, i, j, c);
                }
            }
        }
        taut_arena_free(arena);
    }
    taut_surface_free(surface);
}

/* Seen from above (x, y) can be read off the page. Along the lines isothermality is a level: the
 * circles x^2 + y^2 = 2 l / (1 - l). Between corners of a cell of side h the value is off its
 * linear interpolant by at most h^2 / 8 times twice the second derivative, which is at most 1: h^2
 * / 4. */
static void test_isolines(void)
{
    const taut_write_options options = {.colour = TAUT_COLOUR_ISOTHERMALITY, .divide = 40};
    const double step = 0.05, h = 2.0 / 40;
    taut_surface *surface = saddle();
    taut_arena *arena = taut_arena_new();
    taut_sheet s = {.surface = NULL};
    taut_camera camera;
    taut_scene scene;
    double *page = NULL;
    int met[11] = {0};

    CHECK(taut_sheet_new(surface, 1600, 10000, &options, arena, &s) == TAUT_OK, "sheet");
    CHECK(taut_sheet_corners(&options, arena, &s) == TAUT_OK, "corners");
    camera_on(&s, -90, 90, WIDTH, HEIGHT, &camera);
    CHECK(taut_scene_init(&scene, WIDTH, HEIGHT, arena) == TAUT_OK, "scene");
    CHECK(taut_parts_cells(&s, &camera, (taut_ink){0, 0, 0}, 1, arena, &scene, &page) == TAUT_OK,
          "cells");
    CHECK(taut_parts_isolines(&s, page, step, 1, 9, &scene) == TAUT_OK, "lines");
    CHECK(scene.stroke_count > 500, "%zu pieces", scene.stroke_count);
    for (size_t i = 0; i < scene.point_count; i++) {
        const double x = (scene.points[i][0] - camera.origin[0]) / camera.scale;
        const double y = (camera.origin[1] - scene.points[i][1]) / camera.scale;
        const double level = exact(TAUT_COLOUR_ISOTHERMALITY, x, y) / step;
        CHECK_NEAR(level, round(level), (h * h / 4 + 4e-6) / step, "at %g %g", x, y);
        met[(int)fmin(fmax(round(level), 0), 10)]++;
    }
    for (int k = 1; k <= 9; k++) {
        CHECK(met[k] > 0, "no line at level %d", k);
    }
    CHECK(met[0] == 0 && met[10] == 0, "levels that were not asked for");
    taut_scene_clear(&scene);
    taut_arena_free(arena);
    taut_surface_free(surface);
}

/* The ray is mirrored here as a vector, r = 2 (n.e) n - e, and its angle taken about `up`. */
static void test_stripes(void)
{
    const taut_write_options options = {.reflections = 7, .divide = 12};
    const int lights = 7;
    taut_surface *surface = saddle();
    taut_arena *arena = taut_arena_new();
    taut_sheet s = {.surface = NULL};
    taut_camera camera;

    CHECK(taut_sheet_new(surface, 144, 10000, &options, arena, &s) == TAUT_OK, "sheet");
    camera_on(&s, 20, 40, WIDTH, HEIGHT, &camera);
    CHECK(taut_sheet_stripes(&options, &camera, arena, &s) == TAUT_OK, "stripes");
    for (int i = 0; i + 1 < s.u.count; i++) {
        for (int j = 0; j + 1 < s.v.count; j++) {
            const double x = 2 * s.u.at[i] - 1, y = 2 * s.v.at[j] - 1;
            const double size = sqrt(1 + x * x + y * y);
            const double n[3] = {-y / size, -x / size, 1 / size};
            const double ne = n[0] * camera.eye[0] + n[1] * camera.eye[1] + n[2] * camera.eye[2];
            double across = 0, toward = 0;
            for (int c = 0; c < 3; c++) {
                const double r = 2 * ne * n[c] - camera.eye[c];
                across += r * camera.right[c];
                toward += r * camera.eye[c];
            }
            /* where the ray runs along `up` the angle turns fast: the last factor */
            CHECK_NEAR(sin(s.stripes[4 * (i * (s.v.count - 1) + j)]),
                       sin(lights * atan2(across, toward)),
                       1e-5 / fmax(hypot(across, toward), 1e-3), "cell %d %d", i, j);
        }
    }
    taut_arena_free(arena);
    taut_surface_free(surface);
}

/* The pieces that are painted over cell (i, j) of a sheet; the far side of the cell on the page. */
static int pieces_over(const taut_sheet *s, int i, int j, const taut_camera *camera,
                       taut_arena *arena, taut_scene *scene, double *side)
{
    const taut_ink ink = {100, 120, 140};
    double points[4][3], *page = NULL;
    taut_sheet cell = *s;
    cell.u.count = cell.v.count = 2;
    cell.points = points[0];
    cell.stripes = s->stripes + 4 * (i * (s->v.count - 1) + j);
    for (int k = 0; k < 4; k++) {
        memcpy(points[k], s->points + 3 * ((i + k / 2) * s->v.count + j + k % 2), sizeof points[k]);
    }
    scene->cell_count = 0;
    CHECK(taut_parts_cells(&cell, camera, ink, 1, arena, scene, &page) == TAUT_OK, "cells");
    *side = hypot(page[9] - page[6], page[10] - page[7]);
    return (int)scene->cell_count - 1;
}

/* The cone over a parabola: normals fan out at its point, where all lamps come together. Where they are nearer to each other
 * than 8 units of the page none is drawn, so that nothing scribbles; farther out they are. */
static void test_fan(void)
{
    static const double points[6][3] = {{0, 0, 1},  {0, 0, 1}, {0, 0, 1},
                                        {-1, 0, 0}, {0, 2, 0}, {1, 0, 0}};
    const taut_write_options options = {.reflections = 24, .divide = 60};
    taut_surface *surface =
        shape_surface(shape_bezier(1, 0, 1), shape_bezier(2, 0, 1), &points[0][0], NULL);
    taut_arena *arena = taut_arena_new();
    taut_sheet s = {.surface = NULL};
    taut_scene scene;
    taut_camera camera;
    int crowded = 0, drawn = 0;

    CHECK(taut_sheet_new(surface, 3600, 10000, &options, arena, &s) == TAUT_OK, "sheet");
    camera_on(&s, 20, 60, WIDTH, HEIGHT, &camera);
    CHECK(taut_sheet_stripes(&options, &camera, arena, &s) == TAUT_OK, "stripes");
    CHECK(taut_scene_init(&scene, WIDTH, HEIGHT, arena) == TAUT_OK, "scene");
    for (int i = 0; i + 1 < s.u.count; i++) {
        for (int j = 0; j + 1 < s.v.count;
             j++) { /* turns from lamp to lamp along the far side of a cell */
            const double *phase = s.stripes + 4 * (i * (s.v.count - 1) + j);
            const double turns = fabs(remainder(phase[2] - phase[1], 2 * PI)) / (2 * PI);
            double length = 0;
            const int pieces = pieces_over(&s, i, j, &camera, arena, &scene, &length);
            if (length < 7.99 * turns && length > 0.5) { /* what is smaller is no line */
                CHECK(pieces == 0, "%d pieces over cell %d %d, lamps %g apart", pieces, i, j,
                      length / turns);
                crowded++;
            }
            drawn += pieces;
        }
    }
    CHECK(crowded > 100 && drawn > 100, "%d crowded cells, %d pieces", crowded, drawn);
    taut_scene_clear(&scene);
    taut_arena_free(arena);
    taut_surface_free(surface);
}

/* A parallel of the cylinder of radius r bends by 1/r toward the axis, so that a comb of scale c is
 * the circle of radius r + c / r; the generators do not bend. */
static void test_combs(void)
{
    const double r = 2, scale = 0.5;
    taut_surface *surface = shape_cylinder(r, 3, 2);
    taut_surface *flat = saddle();
    taut_combs *combs = calloc(1, sizeof *combs);
    double most = 0;
    int circles = 0, straight = 0;

    CHECK(taut_combs_fill(surface, combs, &most) == TAUT_OK, "fill");
    CHECK_NEAR(most, 1 / r, 1e-13, "largest curvature");
    taut_combs_scale(combs, scale);
    for (int edge = 0; edge < 4; edge++) {
        const double *b = combs->bend[edge][40];
        const int bends = hypot(hypot(b[0], b[1]), b[2]) > 1e-12;
        for (int i = 0; i < TAUT_COMB_TEETH; i++) {
            const double *tip = combs->tip[edge][i];
            const double *foot = combs->foot[edge][i];
            CHECK_NEAR(hypot(tip[0], tip[1]), bends ? r + scale / r : hypot(foot[0], foot[1]),
                       1e-12, "edge %d tooth %d", edge, i);
        }
        circles += bends;
        straight += !bends;
    }
    CHECK(circles == 2 && straight == 2, "%d circles, %d lines", circles, straight);
    most = 0;
    CHECK(taut_combs_fill(flat, combs, &most) == TAUT_OK && most < 1e-14, "straight edges: %g",
          most);
    free(combs);
    taut_surface_free(surface);
    taut_surface_free(flat);
}

/* A cable of force 2 between corners of the square of side 2 leaves its chord by 30 degrees: two pull by 4 cos 15 degrees at a
 * corner, along its diagonal. Degree 4 on 8 spans errs by the fourth power of a span in the slope of its end, 2e-7. */
static void test_arrows(void)
{
    const double force = 3.8637033051562731, scale = 0.5;
    sail s = sail_new(4, 12, sail_square, 2);
    taut_certificate *proof = NULL;
    taut_model *model = sail_make(&s, &proof);
    taut_arrows arrows = {.count = 9};
    double most = 0;

    taut_arrows_fill(model, NULL, &arrows, &most);
    CHECK(arrows.count == 0 && !(most > 0), "without a certificate");
    taut_model_set_certificate(model, proof);
    taut_arrows_fill(model, NULL, &arrows, &most);
    taut_arrows_scale(&arrows, scale);
    CHECK(arrows.count == 4, "%d arrows", arrows.count);
    CHECK_NEAR(most, force, 1e-6, "the largest");
    for (int k = 0; k < arrows.count; k++) {
        for (int c = 0; c < 2; c++) {
            const double corner = sail_square[k][c];
            CHECK_NEAR(arrows.head[k][c], corner, 0, "corner %d", k);
            CHECK_NEAR(arrows.tail[k][c], corner + copysign(scale * force * sqrt(0.5), corner - 1),
                       1e-6, "tail %d", k);
        }
    }
    taut_surface *other = saddle();
    taut_arrows_fill(model, other, &arrows, &most);
    CHECK(arrows.count == 0, "%d arrows on another surface", arrows.count);
    taut_surface_free(other);
    taut_model_free(model);
    sail_free(&s);
}

int main(void)
{
    test_values();
    test_isolines();
    test_stripes();
    test_fan();
    test_combs();
    test_arrows();
    return check_failures != 0;
}
