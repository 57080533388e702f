/* test_mesh.c -- meshes: topology by counting, distance by evaluation between the lines, normals
 * against closed forms. */
#include "check.h"
#include "meshes.h"
#include "monitors.h"
#include "shapes.h"

#include "taut/mesh.h"

#include <stdlib.h>
#include <string.h>

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static taut_basis *bspline(int degree, int count)
{
    const taut_basis_spec spec = {.type = "bspline", .degree = degree, .count = count};
    taut_basis *basis = NULL;
    CHECK(taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK, "degree %d count %d", degree, count);
    return basis;
}

/* A net with random heights over the unit square. */
static taut_surface *hills(const char *name, int degree, int count, double height)
{
    taut_basis *basis = bspline(degree, count);
    double *points = malloc(sizeof(double) * 3 * (size_t)count * (size_t)count);
    taut_surface *surface = NULL;
    for (int i = 0; i < count * count; i++) {
        points[3 * i] = (double)(i / count) / (count - 1);
        points[3 * i + 1] = (double)(i % count) / (count - 1);
        points[3 * i + 2] = random_in(-height, height);
    }
    CHECK(taut_surface_new(name, basis, basis, points, NULL, &surface, NULL) == TAUT_OK, "hills");
    taut_basis_free(basis);
    free(points);
    return surface;
}

/* The squared distance of p from the triangle a b c: the nearest point is inside, on an edge or a
 * corner. */
static double distance_to(const double *p, const double *a, const double *b, const double *c)
{
    const double *corner[3] = {a, b, c};
    double best = INFINITY, ab[3], ac[3], ap[3];
    for (int k = 0; k < 3; k++) {
        ab[k] = b[k] - a[k];
        ac[k] = c[k] - a[k];
        ap[k] = p[k] - a[k];
    }
    const double bb = dot(ab, ab), bc = dot(ab, ac), cc = dot(ac, ac);
    const double pb = dot(ap, ab), pc = dot(ap, ac), det = bb * cc - bc * bc;
    const double s = (cc * pb - bc * pc) / det, t = (bb * pc - bc * pb) / det;
    if (det > 0 && s >= 0 && t >= 0 && s + t <= 1) {
        double off[3];
        for (int k = 0; k < 3; k++) {
            off[k] = ap[k] - s * ab[k] - t * ac[k];
        }
        return sqrt(dot(off, off));
    }
    for (int e = 0; e < 3; e++) {
        const double *x = corner[e], *y = corner[(e + 1) % 3];
        double xy[3], xp[3];
        for (int k = 0; k < 3; k++) {
            xy[k] = y[k] - x[k];
            xp[k] = p[k] - x[k];
        }
        const double length = dot(xy, xy);
        const double r = length > 0 ? fmin(1, fmax(0, dot(xp, xy) / length)) : 0;
        for (int k = 0; k < 3; k++) {
            xp[k] -= r * xy[k];
        }
        best = fmin(best, sqrt(dot(xp, xp)));
    }
    return best;
}

/* The largest distance of points of the surface inside the cells from the triangles of their
 * cell. */
static double worst_distance(const taut_model *model, const taut_mesh *mesh)
{
    const taut_mesh_group *group = taut_mesh_group_at(mesh, 0);
    const taut_surface *surface = taut_model_surface(model, group->surface);
    const double *x = taut_mesh_positions(mesh), *t = taut_mesh_parameters(mesh);
    double worst = 0;
    for (size_t q = 0; q < taut_mesh_quad_count(mesh); q++) {
        const uint32_t *quad = taut_mesh_quads(mesh) + 4 * q;
        const uint32_t *pair = taut_mesh_triangles(mesh) + 6 * q;
        const double *lo = t + 2 * quad[0], *hi = t + 2 * quad[2];
        for (int k = 1; k < 16; k++) {
            double p[3], d = INFINITY;
            const double u = lo[0] + (hi[0] - lo[0]) * (k / 4) / 4;
            const double v = lo[1] + (hi[1] - lo[1]) * (k % 4) / 4;
            CHECK(taut_surface_eval(surface, u, v, 0, p) == TAUT_OK, "u=%a v=%a", u, v);
            for (int i = 0; i < 2; i++) {
                d = fmin(d, distance_to(p, x + 3 * pair[3 * i], x + 3 * pair[3 * i + 1],
                                        x + 3 * pair[3 * i + 2]));
            }
            worst = fmax(worst, d);
        }
    }
    return worst;
}

/* The diagonal of the box of the vertices. */
static double size_of(const taut_mesh *mesh)
{
    const double *x = taut_mesh_positions(mesh);
    double sum = 0;
    for (int c = 0; c < 3; c++) {
        double lo = INFINITY, hi = -INFINITY;
        for (size_t i = 0; i < taut_mesh_vertex_count(mesh); i++) {
            lo = fmin(lo, x[3 * i + (size_t)c]);
            hi = fmax(hi, x[3 * i + (size_t)c]);
        }
        sum += (hi - lo) * (hi - lo);
    }
    return sqrt(sum);
}

/* The mesh keeps its tolerance and does not waste: it is not ten times as fine as needed. */
static void test_tolerance(void)
{
    for (int trial = 0; trial < 12; trial++) {
        const int degree = random_int(1, 5);
        const double tolerance = random_log(2e-4, 2e-2);
        taut_surface *surface = hills("hills", degree, degree + random_int(1, 6), 0.3);
        taut_model *model = shape_model(surface);
        taut_mesh *mesh = mesh_of(model, tolerance, 0);
        const double worst = worst_distance(model, mesh) / size_of(mesh);
        CHECK(worst <= tolerance, "degree %d: %g of %g", degree, worst, tolerance);
        CHECK(worst >= tolerance / 10 || degree == 1, "degree %d: only %g of %g", degree, worst,
              tolerance);
        taut_mesh_free(mesh);
        taut_model_free(model);
    }
}

/* Every vertex of the sphere lies on it, its normal is the radius, also at the pole. */
static void test_sphere(void)
{
    taut_model *model = shape_model(shape_octant(1));
    taut_mesh *mesh = mesh_of(model, 0, 0);
    const double *x = taut_mesh_positions(mesh), *n = taut_mesh_normals(mesh);
    const double worst = worst_distance(model, mesh) / sqrt(3);
    CHECK(worst <= 1e-3, "distance %g", worst);
    for (size_t i = 0; i < taut_mesh_vertex_count(mesh); i++) {
        const int is_pole = x[3 * i + 2] > 1 - 1e-12;
        CHECK_NEAR(dot(x + 3 * i, x + 3 * i), 1, 4e-15, "vertex %zu", i);
        CHECK_NEAR(dot(n + 3 * i, n + 3 * i), 1, 4e-15, "vertex %zu", i);
        /* faces beside the pole lean by half of their angle h: 1 - cos(h/2) is the chord error,
         * at most 1e-3 of the size */
        CHECK_NEAR(dot(x + 3 * i, n + 3 * i), 1, is_pole ? 1e-3 * sqrt(3) : 4e-14, "vertex %zu", i);
    }
    taut_mesh_free(mesh);
    taut_model_free(model);
}

/* A closed-form count, and each inner edge shared by two faces that run along it in opposite
 * directions: (quads, triangles) of a grid of 2 spans x 3 cells by 1 x 3. */
static void test_topology(void)
{
    taut_surface *surface = NULL;
    taut_basis *u = bspline(2, 4), *v = bspline(1, 2);
    const double points[8][3] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 1}, {1, 1, 0},
                                 {2, 0, 0}, {2, 1, 1}, {3, 0, 0}, {3, 1, 0}};
    CHECK(taut_surface_new("", u, v, &points[0][0], NULL, &surface, NULL) == TAUT_OK, "surface");
    taut_model *model = shape_model(surface);
    taut_mesh *mesh = mesh_of(model, 0, 3);
    const taut_mesh_group *group = taut_mesh_group_at(mesh, 0);
    const size_t quads = taut_mesh_quad_count(mesh), vertices = taut_mesh_vertex_count(mesh);
    signed char(*edges)[64] = calloc(64, sizeof *edges);

    CHECK(group->nu == 7 && group->nv == 4 && vertices == 28 && quads == 18, "%d x %d", group->nu,
          group->nv);
    CHECK(taut_mesh_group_count(mesh) == 1 && taut_mesh_group_at(mesh, 1) == NULL, "one group");
    for (size_t t = 0; t < 2 * quads; t++) {
        const uint32_t *c = taut_mesh_triangles(mesh) + 3 * t;
        for (int k = 0; k < 3; k++) {
            edges[c[k]][c[(k + 1) % 3]]++;
        }
    }
    int single = 0, paired = 0;
    for (int a = 0; a < 28; a++) {
        for (int b = 0; b < 28; b++) {
            CHECK(edges[a][b] <= 1, "edge %d %d runs twice", a, b);
            single += edges[a][b] && !edges[b][a];
            paired += edges[a][b] && edges[b][a];
        }
    }
    /* 28 - E + 36 = 1 (Euler) gives 63 edges, 2 (6 + 3) of them on the boundary */
    CHECK(single == 2 * (6 + 3) && paired == 2 * (63 - 18), "%d boundary, %d inner", single,
          paired / 2);
    for (size_t q = 0; q < quads; q++) {
        const uint32_t *c = taut_mesh_quads(mesh) + 4 * q;
        const double *x = taut_mesh_positions(mesh), *n = taut_mesh_normals(mesh) + 3 * c[0];
        double ab[3], ad[3];
        for (int k = 0; k < 3; k++) {
            ab[k] = x[3 * c[1] + (size_t)k] - x[3 * c[0] + (size_t)k];
            ad[k] = x[3 * c[3] + (size_t)k] - x[3 * c[0] + (size_t)k];
        }
        const double cross[3] = {ab[1] * ad[2] - ab[2] * ad[1], ab[2] * ad[0] - ab[0] * ad[2],
                                 ab[0] * ad[1] - ab[1] * ad[0]};
        CHECK(dot(cross, n) > 0, "quad %zu is seen from behind", q);
    }
    free(edges);
    taut_mesh_free(mesh);
    taut_model_free(model);
    taut_basis_free(u);
    taut_basis_free(v);
}

/* A point, a line, and a flat ruled surface need one cell a span; nothing is NaN. */
static void test_degenerate(void)
{
    for (int kind = 0; kind < 3; kind++) {
        taut_basis *basis = bspline(1, 3);
        double points[9][3] = {{0}};
        taut_surface *surface = NULL;
        for (int i = 0; i < 9; i++) {
            points[i][0] = kind > 0 ? i / 3 : 5;
            points[i][1] = kind > 1 ? i % 3 : 5;
        }
        CHECK(taut_surface_new("", basis, basis, &points[0][0], NULL, &surface, NULL) == TAUT_OK,
              "surface");
        taut_model *model = shape_model(surface);
        taut_mesh *mesh = mesh_of(model, 0, 0);
        const double *n = taut_mesh_normals(mesh);
        CHECK(taut_mesh_quad_count(mesh) == 4, "%zu quads", taut_mesh_quad_count(mesh));
        for (size_t i = 0; i < taut_mesh_vertex_count(mesh); i++) {
            CHECK(n[3 * i] == 0 && n[3 * i + 1] == 0 && n[3 * i + 2] == 1, "normal %zu", i);
        }
        taut_mesh_free(mesh);
        taut_model_free(model);
        taut_basis_free(basis);
    }
}

static void test_many_surfaces(void)
{
    taut_model *model = shape_model(hills("a", 3, 5, 0.1));
    taut_mesh *mesh = NULL;
    CHECK(taut_model_add_surface(model, hills("b", 2, 4, 0.1)) == TAUT_OK, "b");
    mesh = mesh_of(model, 0, 2);
    const taut_mesh_group *a = taut_mesh_group_at(mesh, 0), *b = taut_mesh_group_at(mesh, 1);
    CHECK(strcmp(a->name, "a") == 0 && strcmp(b->name, "b") == 0 && b->surface == 1, "names");
    CHECK(b->first_vertex == 25 && b->first_quad == 16 && taut_mesh_vertex_count(mesh) == 50,
          "second group at %zu", b->first_vertex);
    CHECK(taut_mesh_quads(mesh)[4 * 16] == 25, "its first corner");
    taut_mesh_free(mesh);
    CHECK(taut_mesh_new(model, &(taut_mesh_options){.surface = "b", .divide = 1}, &mesh, NULL) ==
                  TAUT_OK &&
              taut_mesh_group_count(mesh) == 1 && taut_mesh_group_at(mesh, 0)->surface == 1,
          "only b");
    taut_mesh_free(mesh);
    taut_model_free(model);
}

static void test_refusals(void)
{
    taut_model *model = shape_model(hills("a", 3, 5, 0.1)), *none = NULL;
    taut_mesh *mesh = NULL;
    taut_error error = {.status = TAUT_OK};
    watch once = {.stop_at = 1};
    CHECK(taut_model_new(&none) == TAUT_OK, "model");
    CHECK(taut_mesh_new(none, NULL, &mesh, &error) == TAUT_NO_SOLUTION, "no surface");
    CHECK(taut_mesh_new(model, &(taut_mesh_options){.tolerance = 1e-18}, &mesh, &error) ==
                  TAUT_BAD_ARGUMENT &&
              error.limit == TAUT_POINTS_MAX,
          "too fine: %s", error.message);
    CHECK(taut_mesh_new(model, &(taut_mesh_options){.tolerance = 1e-300}, &mesh, NULL) ==
              TAUT_BAD_ARGUMENT,
          "far too fine");
    CHECK(taut_mesh_new(model, &(taut_mesh_options){.divide = 2000000000}, &mesh, NULL) ==
              TAUT_BAD_ARGUMENT,
          "too many");
    CHECK(taut_mesh_new(model, &(taut_mesh_options){.tolerance = nan("")}, &mesh, NULL) ==
              TAUT_BAD_ARGUMENT,
          "NaN");
    CHECK(taut_mesh_new(model, &(taut_mesh_options){.divide = -1}, &mesh, NULL) ==
              TAUT_BAD_ARGUMENT,
          "divide");
    CHECK(taut_mesh_new(model, &(taut_mesh_options){.monitor = monitor_of(&once)}, &mesh, NULL) ==
              TAUT_INTERRUPTED,
          "stopped");
    CHECK(mesh == NULL && taut_mesh_new(NULL, NULL, &mesh, NULL) == TAUT_BAD_ARGUMENT, "NULL");
    taut_mesh_free(NULL);
    taut_model_free(model);
    taut_model_free(none);
}

/* A surface of degree 1 is made of the same bilinear pieces whatever its knots, and needs the same
 * vertices: knots graded over six decades at either end cost no more than uniform ones. */
static void test_graded_knots(void)
{
    enum { SPANS = 11, COUNT = SPANS + 1 };
    size_t counts[3] = {0, 0, 0};
    double points[COUNT * COUNT][3];
    for (int i = 0; i < COUNT * COUNT; i++) {
        points[i][0] = i / COUNT;
        points[i][1] = i % COUNT;
        points[i][2] = random_in(-1, 1);
    }
    for (int k = 0; k < 3; k++) {
        double knots[COUNT + 2] = {0};
        for (int i = 0; i < SPANS; i++) {
            knots[i + 2] = knots[i + 1] + ldexp(1, k == 0 ? 0 : k == 1 ? 2 * i : -2 * i);
        }
        knots[COUNT + 1] = knots[COUNT];
        const taut_basis_spec spec = {
            .type = "bspline", .degree = 1, .knots = knots, .knot_count = COUNT + 2};
        taut_basis *basis = NULL;
        taut_surface *surface = NULL;
        taut_mesh *mesh = NULL;
        CHECK(taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK, "basis %d", k);
        CHECK(taut_surface_new("", basis, basis, &points[0][0], NULL, &surface, NULL) == TAUT_OK,
              "surface %d", k);
        taut_model *model = shape_model(surface);
        CHECK(taut_mesh_new(model, NULL, &mesh, NULL) == TAUT_OK, "mesh %d", k);
        counts[k] = mesh != NULL ? taut_mesh_vertex_count(mesh) : 0;
        taut_mesh_free(mesh);
        taut_model_free(model);
        taut_basis_free(basis);
    }
    /* one cell a span more or less, where rounding decides */
    CHECK(counts[0] > 0 && counts[1] <= counts[0] + counts[0] / 5 &&
              counts[2] <= counts[0] + counts[0] / 5,
          "%zu %zu %zu", counts[0], counts[1], counts[2]);
}

/* Scaling by a power of two changes no vertex but by that power, near the ends of the range too. */
static void test_extreme_sizes(void)
{
    static const int powers[] = {-900, -520, 340, 500};
    for (int k = 0; k < 4; k++) {
        taut_mesh *meshes[2] = {NULL, NULL};
        taut_surface *surface = hills("hills", 3, 6, 0.7);
        double points[36][3];
        for (int i = 0; i < 36; i++) {
            for (int c = 0; c < 3; c++) {
                points[i][c] = ldexp(taut_surface_points(surface)[3 * i + c], powers[k]);
            }
        }
        taut_surface *large = NULL;
        CHECK(taut_surface_new("hills", taut_surface_u(surface), taut_surface_v(surface),
                               &points[0][0], NULL, &large, NULL) == TAUT_OK,
              "2^%d", powers[k]);
        taut_model *models[2] = {shape_model(surface), shape_model(large)};
        for (int m = 0; m < 2; m++) {
            taut_error error = {.status = TAUT_OK};
            CHECK(taut_mesh_new(models[m], NULL, &meshes[m], &error) == TAUT_OK, "2^%d: %s",
                  powers[k], error.message);
        }
        CHECK(meshes[0] != NULL && meshes[1] != NULL &&
                  taut_mesh_vertex_count(meshes[0]) == taut_mesh_vertex_count(meshes[1]),
              "2^%d", powers[k]);
        for (int m = 0; m < 2; m++) {
            taut_mesh_free(meshes[m]);
            taut_model_free(models[m]);
        }
    }
}

int main(void)
{
    random_seed(20240614);
    test_tolerance();
    test_sphere();
    test_topology();
    test_degenerate();
    test_many_surfaces();
    test_refusals();
    test_graded_knots();
    test_extreme_sizes();
    return check_failures != 0;
}
