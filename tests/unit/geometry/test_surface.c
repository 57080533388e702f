/* test_surface.c -- evaluation against closed forms and of one route against the other. */
#include "check.h"
#include "shapes.h"

#include "taut/surface.h"

#include <stddef.h>
#include <string.h>

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void test_sphere(void)
{
    taut_surface *surface = shape_octant(2);
    for (int trial = 0; trial < 500; trial++) {
        const double u = random_in(0, 1), v = random_in(0, 1);
        double x[6][3];
        CHECK(taut_surface_eval(surface, u, v, 2, &x[0][0]) == TAUT_OK, "u=%a v=%a", u, v);
        CHECK_NEAR(dot(x[0], x[0]), 4, 4e-15, "u=%a v=%a", u, v);
        CHECK_NEAR(dot(x[0], x[TAUT_XU]), 0, 2e-14, "u=%a v=%a", u, v);
        /* x.x_uv = -x_u.x_v and so on, from differentiating x.x = 4 twice */
        CHECK_NEAR(dot(x[0], x[TAUT_XUV]), -dot(x[TAUT_XU], x[TAUT_XV]), 1e-13, "u=%a", u);
        CHECK_NEAR(dot(x[0], x[TAUT_XUU]), -dot(x[TAUT_XU], x[TAUT_XU]), 1e-13, "u=%a", u);
        CHECK_NEAR(dot(x[0], x[TAUT_XVV]), -dot(x[TAUT_XV], x[TAUT_XV]), 1e-13, "u=%a", u);
    }
    taut_surface_free(surface);
}

/* The surfaces A = w x and (w, 0, 0) of a rational surface x, both without weights. */
static void split_rational(const taut_surface *surface, taut_surface **a, taut_surface **w)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const int count = taut_basis_count(u) * taut_basis_count(v);
    const double *points = taut_surface_points(surface);
    const double *weights = taut_surface_weights(surface);
    double product[64 * 3], weight[64 * 3] = {0};
    for (int i = 0; i < count; i++) {
        weight[3 * i] = weights[i];
        for (int c = 0; c < 3; c++) {
            product[3 * i + c] = weights[i] * points[3 * i + c];
        }
    }
    CHECK(taut_surface_new("A", u, v, product, NULL, a, NULL) == TAUT_OK, "A");
    CHECK(taut_surface_new("w", u, v, weight, NULL, w, NULL) == TAUT_OK, "w");
}

static taut_surface *random_rational(void)
{
    enum { NU = 6, NV = 5 };
    double points[NU * NV * 3], weights[NU * NV];
    taut_basis_spec spec_u = {.type = "bspline", .degree = 3, .count = NU};
    taut_basis_spec spec_v = {.type = "bezier", .degree = NV - 1};
    taut_basis *u = NULL, *v = NULL;
    taut_surface *surface = NULL;
    for (int i = 0; i < NU * NV; i++) {
        weights[i] = random_log(0.25, 4);
        for (int c = 0; c < 3; c++) {
            points[3 * i + c] = random_in(-1, 1);
        }
    }
    CHECK(taut_basis_new(&spec_u, NU, &u, NULL) == TAUT_OK, "u");
    CHECK(taut_basis_new(&spec_v, NV, &v, NULL) == TAUT_OK, "v");
    CHECK(taut_surface_new("x", u, v, points, weights, &surface, NULL) == TAUT_OK, "surface");
    taut_basis_free(u);
    taut_basis_free(v);
    return surface;
}

/* The product rule on A = w x, by routes that know nothing of quotients:
 *     A_u = w_u x + w x_u,  A_uu = w_uu x + 2 w_u x_u + w x_uu,
 *     A_uv = w_uv x + w_u x_v + w_v x_u + w x_uv
 * (On the sphere above a tangential error would not show: there x.x_u = 0.) */
static void test_product_rule(void)
{
    for (int trial = 0; trial < 300; trial++) {
        taut_surface *surface = random_rational();
        taut_surface *product = NULL, *weight = NULL;
        const double u = random_in(0, 1), v = random_in(0, 1);
        double x[6][3], a[6][3], w[6][3];
        split_rational(surface, &product, &weight);
        CHECK(taut_surface_eval(surface, u, v, 2, &x[0][0]) == TAUT_OK, "x");
        CHECK(taut_surface_eval(product, u, v, 2, &a[0][0]) == TAUT_OK, "A");
        CHECK(taut_surface_eval(weight, u, v, 2, &w[0][0]) == TAUT_OK, "w");
        for (int c = 0; c < 3; c++) {
            const double w0 = w[TAUT_X][0], wu = w[TAUT_XU][0], wv = w[TAUT_XV][0];
            const double expected[6] = {
                w0 * x[0][c],
                wu * x[0][c] + w0 * x[TAUT_XU][c],
                wv * x[0][c] + w0 * x[TAUT_XV][c],
                w[TAUT_XUU][0] * x[0][c] + 2 * wu * x[TAUT_XU][c] + w0 * x[TAUT_XUU][c],
                w[TAUT_XUV][0] * x[0][c] + wu * x[TAUT_XV][c] + wv * x[TAUT_XU][c] +
                    w0 * x[TAUT_XUV][c],
                w[TAUT_XVV][0] * x[0][c] + 2 * wv * x[TAUT_XV][c] + w0 * x[TAUT_XVV][c]};
            for (int k = 0; k < 6; k++) {
                double size = 1; /* of the terms that cancel */
                for (int l = 0; l < 6; l++) {
                    size = fmax(size, fabs(w[k][0] * x[l][c]) + fabs(w[l][0] * x[k][c]));
                }
                /* some 40 roundings a side, each at most u times the largest term */
                CHECK_NEAR(a[k][c], expected[k], 80 * 0x1p-53 * size, "k=%d u=%a v=%a", k, u, v);
            }
        }
        taut_surface_free(surface);
        taut_surface_free(product);
        taut_surface_free(weight);
    }
}

/* At a double inner knot of a quadratic there is a crease, and the side is the right one. */
static void test_side_of_knot(void)
{
    static const double knots[] = {0, 0, 0, 1, 1, 2, 2, 2};
    const double points[5][2][3] = {{{0}, {0, 1}},
                                    {{1}, {1, 1}},
                                    {{2}, {2, 1}},
                                    {{2, 0, 1}, {2, 1, 1}},
                                    {{2, 0, 2}, {2, 1, 2}}};
    taut_basis_spec spec = {.type = "bspline", .degree = 2, .knots = knots, .knot_count = 8};
    taut_basis_spec line = {.type = "bezier", .degree = 1};
    const double u[3] = {0.5, 1, 1.5}, v[1] = {0.5};
    taut_basis *basis_u = NULL, *basis_v = NULL;
    taut_surface *surface = NULL;
    double one[3][3], grid[3][3][3];
    CHECK(taut_basis_new(&spec, 5, &basis_u, NULL) == TAUT_OK, "u");
    CHECK(taut_basis_new(&line, 2, &basis_v, NULL) == TAUT_OK, "v");
    CHECK(taut_surface_new("crease", basis_u, basis_v, &points[0][0][0], NULL, &surface, NULL) ==
              TAUT_OK,
          "surface");
    CHECK(taut_surface_eval(surface, 1, 0.5, 1, &one[0][0]) == TAUT_OK, "one");
    CHECK_NEAR(one[TAUT_XU][0], 0, 1e-15, "x_u from the right");
    CHECK_NEAR(one[TAUT_XU][2], 2, 1e-15, "z_u from the right");
    CHECK(taut_surface_eval_grid(surface, 3, u, 1, v, 1, 1, &grid[0][0][0]) == TAUT_OK, "grid");
    CHECK_NEAR(grid[0][TAUT_XU][0], 2, 1e-15, "before");
    CHECK_NEAR(grid[1][TAUT_XU][2], 2, 1e-15, "at the knot, from the right");
    taut_surface_free(surface);
    taut_basis_free(basis_u);
    taut_basis_free(basis_v);
}

static void refuse(const taut_basis *u, const taut_basis *v, const double *points,
                   const double *weights, taut_status expected, const char *where)
{
    taut_surface *surface = NULL;
    taut_error error = {.where = ""};
    CHECK(taut_surface_new("name", u, v, points, weights, &surface, &error) == expected, "%s",
          where);
    CHECK(surface == NULL, "%s: the output is untouched", where);
    CHECK(strcmp(error.where, where) == 0, "where is %s, expected %s", error.where, where);
}

static void test_refusals(void)
{
    taut_basis_spec spec = {.type = "bezier", .degree = 1};
    taut_basis_spec wide = {.type = "bspline", .degree = 1, .count = 10000};
    const double good[12] = {0}, bad[12] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, HUGE_VAL};
    const double zero[4] = {1, 1, 0, 1};
    const double inside[2] = {0, 1}, outside[2] = {0, 1.5};
    double values[4 * 18] = {7};
    taut_basis *basis = NULL, *large = NULL;
    taut_surface *surface = NULL;
    CHECK(taut_basis_new(&spec, 2, &basis, NULL) == TAUT_OK, "basis");
    CHECK(taut_basis_new(&wide, 10000, &large, NULL) == TAUT_OK, "large");
    refuse(basis, basis, bad, NULL, TAUT_BAD_INPUT, "/points/1/1");
    refuse(basis, basis, good, zero, TAUT_BAD_INPUT, "/weights/1/0");
    refuse(large, large, good, NULL, TAUT_BAD_INPUT, "/points"); /* before any point is read */
    refuse(basis, NULL, good, NULL, TAUT_BAD_ARGUMENT, "");
    refuse(basis, basis, NULL, NULL, TAUT_BAD_ARGUMENT, "");

    CHECK(taut_surface_new("s", basis, basis, good, NULL, &surface, NULL) == TAUT_OK, "good");
    CHECK(taut_surface_eval(surface, 1.5, 0, 0, values) == TAUT_BAD_ARGUMENT, "u outside");
    CHECK(taut_surface_eval(surface, 0, nan(""), 0, values) == TAUT_BAD_ARGUMENT, "v NaN");
    CHECK(taut_surface_eval(surface, 0, 0, 3, values) == TAUT_BAD_ARGUMENT, "order");
    CHECK(taut_surface_eval_grid(surface, 2, inside, 2, outside, 2, 1, values) == TAUT_BAD_ARGUMENT,
          "grid outside");
    CHECK(taut_surface_eval_grid(surface, -1, inside, 2, inside, 2, 1, values) == TAUT_BAD_ARGUMENT,
          "negative count");
    CHECK(values[0] == 7, "nothing is written on failure");
    CHECK(taut_surface_eval_grid(surface, 0, inside, 2, inside, 2, 1, values) == TAUT_OK, "empty");
    CHECK(values[0] == 7, "an empty grid writes nothing");
    taut_surface_free(surface);
    taut_basis_free(basis);
    taut_basis_free(large);
}

/* The grid gives what single points give. */
static void test_grid(void)
{
    enum { NU = 7, NV = 5 };
    const double u[NU] = {0, 0.125, 0.3, 0.5, 0.75, 0.9, 1}, v[NV] = {0, 0.2, 0.5, 0.7, 1};
    taut_surface *surface = shape_octant(2);
    for (int order = 0; order <= 2; order++) {
        const int vectors = TAUT_SURFACE_VECTORS(order);
        double grid[NU * NV * 18], one[18];
        CHECK(taut_surface_eval_grid(surface, NU, u, NV, v, order, 1, grid) == TAUT_OK, "grid");
        for (int i = 0; i < NU * NV; i++) {
            CHECK(taut_surface_eval(surface, u[i / NV], v[i % NV], order, one) == TAUT_OK, "one");
            for (int c = 0; c < 3 * vectors; c++) {
                CHECK_NEAR(grid[3 * vectors * i + c], one[c], 1e-13, "order=%d c=%d", order, c);
            }
        }
    }
    taut_surface_free(surface);
}

/* Texts that are rational numbers are kept; others are refused by their place, before rational
 * arithmetic would divide by their 0. */
static void test_exact_texts(void)
{
    static const char *const legal[] = {"7/3", "-0", "-5/12", "007/3", "12345678901234567890/11"};
    static const char *const other[] = {"1/0", "-1/00", "1/-3",  "1/",  "/3",   "",    "-",
                                        " 1",  "1 ",    "1/2/3", "1e5", "0x10", "nan", "+3"};
    const double points[12] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1};
    const char *exact[12] = {NULL};
    taut_basis_spec spec = {.type = "bezier", .degree = 1};
    taut_basis *line = NULL;
    taut_surface *surface = NULL;

    CHECK(taut_basis_new(&spec, 2, &line, NULL) == TAUT_OK, "line");
    for (size_t i = 0; i < sizeof other / sizeof *other; i++) {
        taut_error error = {.status = TAUT_OK};
        exact[7] = other[i];
        CHECK(taut_surface_new_exact("", line, line, points, NULL, exact, &surface, &error) ==
                  TAUT_BAD_INPUT,
              "\"%s\"", other[i]);
        CHECK(strcmp(error.where, "/points/1/0/1") == 0, "\"%s\" at %s", other[i], error.where);
        CHECK(surface == NULL, "nothing is made");
    }
    for (size_t i = 0; i < sizeof legal / sizeof *legal; i++) {
        exact[7] = legal[i];
        CHECK(taut_surface_new_exact("", line, line, points, NULL, exact, &surface, NULL) ==
                  TAUT_OK,
              "\"%s\"", legal[i]);
        CHECK(strcmp(taut_surface_exact(surface)[7], legal[i]) == 0, "kept");
        taut_surface_free(surface);
        surface = NULL;
    }
    taut_basis_free(line);
}

/* Places in no order: those of single calls bit for bit, for any number of threads, ends included. */
static void test_points(void)
{
    enum { COUNT = 37 };
    taut_surface *surface = random_rational();
    double u[COUNT], v[COUNT], all[COUNT * 18], alone[18];
    for (int i = 0; i < COUNT; i++) {
        u[i] = i == 5 ? 0 : i == 6 ? 1 : random_in(0, 1);
        v[i] = i == 5 ? 1 : i == 7 ? 0 : random_in(0, 1);
    }
    for (int order = 0; order <= 2; order++) {
        const size_t numbers = 3 * (size_t)TAUT_SURFACE_VECTORS(order);
        for (int threads = 0; threads <= 3; threads++) {
            memset(all, 0xff, sizeof all);
            CHECK(taut_surface_eval_points(surface, COUNT, u, v, order, threads, all) == TAUT_OK,
                  "order %d", order);
            for (size_t i = 0; i < COUNT; i++) {
                CHECK(taut_surface_eval(surface, u[i], v[i], order, alone) == TAUT_OK, "alone");
                CHECK(memcmp(alone, all + i * numbers, numbers * sizeof(double)) == 0,
                      "order %d, %d threads, place %zu", order, threads, i);
            }
        }
    }
    CHECK(taut_surface_eval_points(surface, 0, u, v, 0, 0, all) == TAUT_OK, "none");
    taut_surface_free(surface);
}

/* One parameter out of range, wherever it stands, and nothing is written. */
static void test_points_refused(void)
{
    enum { COUNT = 4 };
    static const double beyond[] = {-1e-300, 1.0000000000000002, NAN, INFINITY};
    taut_surface *surface = random_rational();
    double t[COUNT] = {0.25, 0.5, 0.75, 1}, wrong[COUNT], all[COUNT][3] = {{7}};
    for (size_t i = 0; i < COUNT; i++) {
        memcpy(wrong, t, sizeof t);
        wrong[i] = beyond[i];
        CHECK(taut_surface_eval_points(surface, COUNT, wrong, t, 0, 1, all[0]) == TAUT_BAD_ARGUMENT,
              "u[%zu]", i);
        CHECK(taut_surface_eval_points(surface, COUNT, t, wrong, 0, 1, all[0]) == TAUT_BAD_ARGUMENT,
              "v[%zu]", i);
    }
    CHECK(taut_surface_eval_points(surface, COUNT, t, t, 3, 1, all[0]) == TAUT_BAD_ARGUMENT, "3");
    CHECK(taut_surface_eval_points(surface, COUNT, t, t, -1, 1, all[0]) == TAUT_BAD_ARGUMENT, "-1");
    CHECK(taut_surface_eval_points(surface, -1, t, t, 0, 1, all[0]) == TAUT_BAD_ARGUMENT, "count");
    CHECK(taut_surface_eval_points(surface, COUNT, t, t, 0, -1, all[0]) == TAUT_BAD_ARGUMENT, "t");
    CHECK(taut_surface_eval_points(surface, COUNT, t, t, 0, TAUT_THREADS_MAX + 1, all[0]) ==
              TAUT_BAD_ARGUMENT,
          "threads");
    CHECK(taut_surface_eval_points(surface, COUNT, t, NULL, 0, 1, all[0]) == TAUT_BAD_ARGUMENT,
          "NULL");
    CHECK(all[0][0] == 7 && all[3][2] == 0, "nothing is written");
    taut_surface_free(surface);
}

int main(void)
{
    random_seed(20260102);
    test_sphere();
    test_product_rule();
    test_side_of_knot();
    test_grid();
    test_refusals();
    test_exact_texts();
    test_points();
    test_points_refused();
    return check_failures != 0;
}
