/* test_weld.c -- meshes of several surfaces are closed where the surfaces are: every edge between
 * two places is run once in each sense, and the volume is that of the body. */
#include "check.h"
#include "meshes.h"
#include "shapes.h"

#include "taut/mesh.h"
#include "taut/operations.h"

#include <string.h>

static taut_model *new_model(void)
{
    taut_model *model = NULL;
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    return model;
}

static void add(taut_model *model, taut_surface *surface)
{
    CHECK(taut_model_add_surface(model, surface) == TAUT_OK, "add");
}

/* Welded vertices are in the same place bit for bit, and each stands for itself or an earlier one.
 */
static void check_places(const taut_mesh *mesh)
{
    const uint32_t *welded = taut_mesh_welded(mesh);
    const double *x = taut_mesh_positions(mesh);
    for (size_t i = 0; i < taut_mesh_vertex_count(mesh); i++) {
        CHECK(welded[i] <= i && welded[welded[i]] == welded[i], "vertex %zu", i);
        CHECK(memcmp(x + 3 * i, x + 3 * (size_t)welded[i], 3 * sizeof(double)) == 0, "vertex %zu",
              i);
    }
}

static void check_closed(const taut_model *model, double tolerance, int divide, double volume,
                         double error, const char *what)
{
    taut_mesh *mesh = mesh_of(model, tolerance, divide);
    const mesh_body found = mesh_look_at(mesh);
    CHECK(found.open == 0, "%s: %zu open edges", what, found.open);
    CHECK_NEAR(found.volume, volume, error, "%s", what);
    check_places(mesh);
    taut_mesh_free(mesh);
}

/* One side of the unit cube, corner + s a + t b, after anything that leaves the points where they
 * are: other degrees, knots, ranges, senses and sides. */
static taut_surface *any_side(const double corner[3], const double a[3], const double b[3])
{
    double points[4][3];
    taut_surface *side = NULL, *next = NULL;
    for (int i = 0; i < 4; i++) {
        for (int c = 0; c < 3; c++) {
            points[i][c] = corner[c] + (i / 2) * a[c] + (i % 2) * b[c];
        }
    }
    side = shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), &points[0][0], NULL);
    for (int steps = random_int(0, 5); steps > 0; steps--) {
        const int way = random_int(0, 5), direction = random_int(0, 1);
        const taut_basis *basis = direction == 0 ? taut_surface_u(side) : taut_surface_v(side);
        const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
        const double inside = lo + (hi - lo) * random_in(0.01, 0.99);
        taut_status status = TAUT_OK;
        if (way == 0) {
            status = taut_surface_reverse(side, direction, &next, NULL);
        } else if (way == 1) {
            status = taut_surface_transpose(side, &next, NULL);
        } else if (way == 2) {
            status = taut_surface_elevate(side, direction, random_int(0, 3), &next, NULL);
        } else if (way == 3) {
            status = taut_surface_insert(side, direction, inside, 1, &next, NULL);
        } else if (way == 4) {
            status = taut_surface_rerange(side, direction, random_in(-3, 0), random_in(0.1, 9),
                                          &next, NULL);
        } else {
            status = taut_surface_refine(side, direction, &next, NULL);
        }
        CHECK(status == TAUT_OK, "way %d", way);
        taut_surface_free(side);
        side = next;
    }
    return side;
}

static taut_model *any_cube(int sides)
{
    static const double axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, origin[3] = {0, 0, 0};
    taut_model *model = new_model();
    for (int i = 0; i < sides; i++) {
        const double *corner = i < 3 ? origin : axes[i % 3];
        add(model, any_side(corner, axes[(i + 1) % 3], axes[(i + 2) % 3]));
    }
    return model;
}

/* Flat sides hold the volume exactly, to rounding and to vertices that moved by 1e-9 at breaks that
 * are taken as one. */
static void test_cubes(void)
{
    for (int trial = 0; trial < 200; trial++) {
        taut_model *cube = any_cube(6);
        check_closed(cube, 0, random_int(0, 3), 1, 1e-8, "cube");
        taut_model_free(cube);
    }
}

/* Five sides leave an edge around the hole, and nothing is turned. */
static void test_open(void)
{
    taut_model *box = any_cube(5);
    taut_mesh *mesh = mesh_of(box, 0, 1);
    CHECK(mesh_look_at(mesh).open > 0, "a box without a lid is closed");
    taut_mesh_free(mesh);
    taut_model_free(box);
}

/* A tube whose ends are open shows its outside, whichever way its parameters run. */
static void test_tubes(void)
{
    for (int way = 0; way < 2; way++) {
        taut_surface *tube = shape_cylinder(2, 3, 1), *other = shape_transposed(tube);
        taut_model *model = new_model();
        add(model, way ? other : tube);
        taut_surface_free(way ? tube : other);
        taut_mesh *mesh = mesh_of(model, 1e-3, 0);
        const taut_mesh_group *group = taut_mesh_group_at(mesh, 0);
        for (size_t i = 0; i < taut_mesh_vertex_count(mesh); i++) {
            const double *x = taut_mesh_positions(mesh) + 3 * i;
            const double *n = taut_mesh_normals(mesh) + 3 * i;
            const double out = (x[0] * n[0] + x[1] * n[1]) * (group->turned ? -1 : 1);
            CHECK(out > 1.999, "way %d, vertex %zu: %g", way, i, out);
        }
        taut_mesh_free(mesh);
        taut_model_free(model);
    }
}

/* With a chord error of 1e-3 of the size d a body's volume is off by at most 1e-3 d times its area,
 * and by much less; collapsed edges, seams of one surface with itself. */
static void test_bodies(void)
{
    const double pi = acos(-1);
    taut_model *sphere = new_model(), *torus = new_model();
    const double size = 2 * sqrt(3);
    add(sphere, shape_sphere(1));
    add(torus, shape_torus(3, 1));
    check_closed(sphere, 0, 0, 4 * pi / 3, 1e-3 * size * 4 * pi, "sphere");
    check_closed(sphere, 1e-5, 0, 4 * pi / 3, 1e-5 * size * 4 * pi, "sphere");
    check_closed(sphere, 0, 7, 4 * pi / 3, 0.3, "sphere");
    check_closed(torus, 1e-4, 0, 6 * pi * pi, 1e-4 * 12 * 12 * pi * pi, "torus");
    taut_model_free(sphere);
    taut_model_free(torus);
}

/* The pieces of a torus that was cut: chains that run around. */
static void test_pieces(void)
{
    const double pi = acos(-1);
    taut_model *torus = new_model(), *halves = NULL, *quarters = NULL;
    add(torus, shape_torus(3, 1));
    CHECK(taut_model_split(torus, NULL, TAUT_ALONG_U, 0.3, &halves, NULL) == TAUT_OK, "split");
    check_closed(halves, 1e-3, 0, 6 * pi * pi, 1e-3 * 12 * 12 * pi * pi, "halves");
    CHECK(taut_model_split(halves, NULL, TAUT_ALONG_V, 0.6, &quarters, NULL) == TAUT_OK, "split");
    check_closed(quarters, 1e-3, 0, 6 * pi * pi, 1e-3 * 12 * 12 * pi * pi, "quarters");
    taut_model_free(torus);
    taut_model_free(halves);
    taut_model_free(quarters);
}

/* A strip with a half twist: its edges u0 and u1 are one, reversed; v0 and v1 are
 * free, and run into each other. */
static void test_strip(void)
{
    taut_model *model = new_model();
    taut_mesh *mesh = NULL;
    const taut_mesh_group *group = NULL;
    add(model, shape_strip());
    mesh = mesh_of(model, 0, 4);
    group = taut_mesh_group_at(mesh, 0);
    for (int j = 0; j < group->nv; j++) {
        const uint32_t far = (uint32_t)((group->nu - 1) * group->nv + group->nv - 1 - j);
        CHECK(taut_mesh_welded(mesh)[far] == (uint32_t)j, "vertex %d", j);
    }
    taut_mesh_free(mesh);
    taut_model_free(model);
}

/* Edges that pass each other farther than the tolerance stay apart. */
static void test_gap(void)
{
    const double gaps[] = {1e-4, 1e-5, 1e-7};
    for (int i = 0; i < 3; i++) {
        const double points[2][4][3] = {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}},
                                        {{1, 0, gaps[i]}, {1, 1, gaps[i]}, {2, 0, 0}, {2, 1, 0}}};
        taut_model *model = new_model();
        taut_mesh *mesh = NULL;
        int joined = 0;
        for (int s = 0; s < 2; s++) {
            add(model, shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), &points[s][0][0],
                                     NULL));
        }
        mesh = mesh_of(model, 0, 1);
        for (uint32_t k = 0; k < taut_mesh_vertex_count(mesh); k++) {
            joined += taut_mesh_welded(mesh)[k] != k;
        }
        CHECK(joined == (gaps[i] < 1e-6 ? 2 : 0), "gap %g: %d vertices are welded", gaps[i],
              joined);
        taut_mesh_free(mesh);
        taut_model_free(model);
    }
}

/* Panels have their own vertices, digit by digit, however far their sizes are apart: an edge as
 * short as 1e-40 of the whole, opposite edges as near as 1e-15 of it, sums that cancel; and a net
 * that meets itself is closed. */
static void test_own(void)
{
    enum { N = 5, M = 9 };
    static const double far[] = {0, 10, 44};
    double points[N][M][3];
    for (int kind = 0; kind < 3; kind++) {
        const double from = kind == 1 ? -far[kind] : 0, turn = kind == 0 ? 2 : 0.8;
        taut_model *model = new_model();
        taut_mesh *mesh = NULL;
        int joined = 0;
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < M; j++) {
                const double v = from + far[kind] * i / 2, angle = turn * acos(-1) * j / (M - 1);
                points[i][j][0] = cosh(v) * cos(angle);
                points[i][j][1] = cosh(v) * sin(angle);
                points[i][j][2] = kind == 0 ? i : v;
            }
        }
        if (kind == 1) { /* as near beside the whole, not beside their own extent */
            for (int k = 0; k < N * M; k++) {
                points[k / M][k % M][0] *= 1e12;
                points[k / M][k % M][1] *= 1e12;
            }
        }
        add(model, shape_surface(shape_bspline(1, N), shape_bspline(1, M), points[0][0], NULL));
        mesh = mesh_of(model, 0, 1);
        CHECK(taut_mesh_vertex_count(mesh) == N * M, "kind %d: %zu vertices", kind,
              taut_mesh_vertex_count(mesh));
        for (uint32_t k = 0; k < N * M; k++) {
            joined += taut_mesh_welded(mesh)[k] != k;
            CHECK(taut_mesh_welded(mesh)[k] != k ||
                      memcmp(taut_mesh_positions(mesh) + 3 * k, points[k / M][k % M],
                             3 * sizeof(double)) == 0,
                  "kind %d: vertex %u has moved", kind, k);
        }
        CHECK(joined == (kind == 0 ? N : 0), "kind %d: %d vertices are welded", kind, joined);
        taut_mesh_free(mesh);
        taut_model_free(model);
    }
}

int main(void)
{
    random_seed(20260301);
    test_cubes();
    test_open();
    test_bodies();
    test_tubes();
    test_pieces();
    test_strip();
    test_gap();
    test_own();
    return check_failures != 0;
}
