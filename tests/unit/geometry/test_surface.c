/* test_surface.c -- evaluation against closed forms and of one route against the other. */
#include "check.h"

#include "taut/surface.h"

#include <stddef.h>

/* A quarter of a sphere of radius 2 as a rational biquadratic patch: |x| = 2 everywhere, and
 * the derivatives are tangent. */
static taut_surface *sphere(void)
{
    const double r = sqrt(0.5);
    const double circle[3][2] = {{1, 0}, {1, 1}, {0, 1}};
    const double w[3] = {1, r, 1};
    double points[9][3], weights[9];
    taut_basis_spec spec = {.type = "bezier", .degree = 2};
    taut_basis *basis = NULL;
    taut_surface *surface = NULL;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            points[3 * i + j][0] = 2 * circle[i][0] * circle[j][0];
            points[3 * i + j][1] = 2 * circle[i][1] * circle[j][0];
            points[3 * i + j][2] = 2 * circle[j][1];
            weights[3 * i + j] = w[i] * w[j];
        }
    }
    CHECK(taut_basis_new(&spec, 3, &basis, NULL) == TAUT_OK, "basis");
    CHECK(taut_surface_new("sphere", basis, basis, &points[0][0], weights, &surface, NULL) ==
              TAUT_OK,
          "surface");
    taut_basis_free(basis);
    return surface;
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void test_sphere(void)
{
    taut_surface *surface = sphere();
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

/* The grid gives what single points give. */
static void test_grid(void)
{
    enum { NU = 7, NV = 5 };
    const double u[NU] = {0, 0.125, 0.3, 0.5, 0.75, 0.9, 1}, v[NV] = {0, 0.2, 0.5, 0.7, 1};
    taut_surface *surface = sphere();
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
    CHECK(taut_surface_eval(surface, 1.5, 0, 0, NULL) == TAUT_BAD_ARGUMENT, "outside");
    taut_surface_free(surface);
}

int main(void)
{
    random_seed(20260102);
    test_sphere();
    test_grid();
    return check_failures != 0;
}
