/* test_thicken.c -- a mesh with a thickness is closed, looks outwards, and holds the volume of Steiner's formula
 *
 *     V = T A + T^3 / 12 int K dA      for a sheet, whose two sides share what its edges add
 *
 * in closed form for planes, boxes, tubes, spheres; sheets that fold over or have one side only are refused. */
#include "check.h"
#include "meshes.h"
#include "shapes.h"

#include "taut/measure.h"
#include "taut/mesh.h"
#include "taut/write.h"

#include <string.h>

static taut_mesh *thick_of(const taut_model *model, double tolerance, int divide, double thickness)
{
    const taut_mesh_options options = {
        .tolerance = tolerance, .divide = divide, .thickness = thickness};
    taut_error error = {.status = TAUT_OK};
    taut_mesh *mesh = NULL;
    CHECK(taut_mesh_new(model, &options, &mesh, &error) == TAUT_OK, "thickness %g: %s", thickness,
          error.message);
    return mesh;
}

static void check_volume(taut_surface *surface, double tolerance, double thickness, double volume,
                         double error, const char *what)
{
    taut_model *model = shape_model(surface);
    taut_mesh *mesh = thick_of(model, tolerance, 0, thickness);
    const mesh_body found = mesh_look_at(mesh);
    CHECK(found.open == 0, "%s: %zu open edges", what, found.open);
    CHECK_NEAR(found.volume, volume, error, "%s", what);
    taut_mesh_free(mesh);
    taut_model_free(model);
}

static taut_surface *plane(const double corner[3], const double a[3], const double b[3])
{
    double points[4][3];
    for (int i = 0; i < 4; i++) {
        for (int c = 0; c < 3; c++) {
            points[i][c] = corner[c] + (i / 2) * a[c] + (i % 2) * b[c];
        }
    }
    return shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), &points[0][0], NULL);
}

/* A plate of 2 x 3 x T, to rounding; its sides lie at T/2, its strips close it. */
static void test_plate(void)
{
    const double corner[3] = {1, 1, 1}, a[3] = {2, 0, 0}, b[3] = {0, 3, 0};
    taut_model *model = shape_model(plane(corner, a, b));
    taut_mesh *mesh = thick_of(model, 0, 4, 0.5);
    CHECK(taut_mesh_group_count(mesh) == 6, "%d groups", taut_mesh_group_count(mesh));
    CHECK_NEAR(mesh_look_at(mesh).volume, 3, 1e-14, "plate");
    CHECK(mesh_look_at(mesh).open == 0, "plate");
    for (size_t i = 0; i < taut_mesh_vertex_count(mesh); i++) {
        CHECK_NEAR(fabs(taut_mesh_positions(mesh)[3 * i + 2] - 1), 0.25, 0, "vertex %zu", i);
    }
    taut_mesh_free(mesh);
    taut_model_free(model);
}

/* Sides of a box: at its edges and corners both sides stay at T/2 from the planes, so that a box is a hollow of
 * (1 + T)^3 - (1 - T)^3, and without its lid one of (1 + T)^2 (1 + T/2) - (1 - T)^2 (1 - T/2), where the rim is at height 1. */
static void test_boxes(void)
{
    static const double axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, origin[3] = {0, 0, 0};
    const double t = 0.125;
    for (int sides = 5; sides <= 6; sides++) {
        taut_model *model = shape_model(NULL);
        for (int i = 0; i < sides; i++) {
            CHECK(taut_model_add_surface(model, plane(i < 3 ? origin : axes[i % 3],
                                                      axes[(i + 1) % 3], axes[(i + 2) % 3])) ==
                      TAUT_OK,
                  "side %d", i);
        }
        taut_mesh *mesh = thick_of(model, 0, 2, t);
        const double out = 1 + t, in = 1 - t, lid = sides == 5 ? t / 2 : t;
        CHECK(mesh_look_at(mesh).open == 0, "%d sides", sides);
        CHECK_NEAR(mesh_look_at(mesh).volume, out * out * (1 + lid) - in * in * (1 - lid), 1e-13,
                   "%d sides", sides);
        taut_mesh_free(mesh);
        taut_model_free(model);
    }
}

/* Walls: pi ((r + T/2)^2 - (r - T/2)^2) h; balls: 4/3 pi ((r + T/2)^3 - (r - T/2)^3). What chords cut off is a share of 2e-5
 * (tubes) to 4e-5 of these volumes at a tolerance of 1e-5. */
static void test_round(void)
{
    const double pi = acos(-1);
    taut_surface *tube = shape_cylinder(1, 2, 1);
    check_volume(shape_cylinder(1, 2, 1), 1e-5, 0.2, 0.8 * pi, 1e-4, "tube");
    check_volume(shape_transposed(tube), 1e-5, 1.9, 7.6 * pi, 1e-3, "tube");
    check_volume(shape_sphere(1), 1e-5, 0.5, 4 * pi / 3 * (1.953125 - 0.421875), 5e-4, "ball");
    check_volume(shape_torus(3, 1), 1e-4, 0.5, 6 * pi * pi * (1.5625 - 0.5625), 5e-2, "torus");
    taut_surface_free(tube);
}

/* Random bicubic nets: T A, by the area of the exact surface; 2e-4 of it seen, of which T^2 / 12 times the curvature is 1e-6. */
static void test_random(void)
{
    for (int trial = 0; trial < 8; trial++) {
        taut_surface *surface = shape_random(3, 3, trial % 2);
        taut_model *model = shape_model(surface);
        taut_mesh *mesh = NULL;
        const double t = 1e-3;
        const taut_mesh_options options = {.tolerance = 1e-4, .thickness = t};
        taut_error error = {.status = TAUT_OK};
        const taut_status status = taut_mesh_new(model, &options, &mesh, &error);
        CHECK(status == TAUT_OK || strcmp(error.reason, "fold") == 0, "trial %d: %s", trial,
              error.message);
        if (status == TAUT_OK) {
            double area = 0;
            CHECK(taut_surface_area(surface, &area, NULL) == TAUT_OK, "area");
            CHECK(mesh_look_at(mesh).open == 0, "trial %d", trial);
            CHECK_NEAR(mesh_look_at(mesh).volume, t * area, 4e-4 * t * area, "trial %d", trial);
        }
        taut_mesh_free(mesh);
        taut_model_free(model);
    }
}

static void check_refused(taut_surface *surface, double thickness, const char *reason)
{
    const taut_mesh_options options = {.thickness = thickness};
    taut_model *model = shape_model(surface);
    taut_mesh *mesh = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_mesh_new(model, &options, &mesh, &error) == TAUT_NO_SOLUTION && mesh == NULL, "%s",
          reason);
    CHECK(strcmp(error.reason, reason) == 0, "%s, expected %s", error.reason, reason);
    taut_model_free(model);
}

/* A tube of radius 1 folds at a thickness of 2, and its inside at one below is next to nothing. */
static void test_refused(void)
{
    check_refused(shape_cylinder(1, 2, 1), 2, "fold");
    check_refused(shape_sphere(1), 2.5, "fold");
    check_refused(shape_strip(), 0.01, "sheet");
    taut_model *tube = shape_model(shape_cylinder(1, 2, 1));
    taut_mesh *mesh = thick_of(tube, 0, 0, 1.999);
    CHECK(mesh_look_at(mesh).open == 0, "a thick tube");
    taut_mesh_free(mesh);
    taut_model_free(tube);
}

int main(void)
{
    test_plate();
    test_boxes();
    test_round();
    test_random();
    test_refused();
    return check_failures != 0;
}
