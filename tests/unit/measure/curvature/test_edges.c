/* test_edges.c -- figures along edges, and those of curves. */
#include "check.h"
#include "shapes.h"

#include "core/constants.h"
#include "taut/measure.h"

#include <string.h>

static taut_surface_measure measured(const taut_surface *surface)
{
    taut_surface_measure m;
    memset(&m, 0, sizeof m);
    CHECK(taut_measure_surface(surface, NULL, &m, NULL) == TAUT_OK, "measure");
    return m;
}

/* The meridian and the equators of a torus are lines of curvature. u0, u1: circle of the tube, k_n
 * = 1 throughout and the normal in its plane. v0, v1 (the outer equator): k_n = 1/4. */
static void test_torus(void)
{
    taut_surface *s = shape_torus(3, 1);
    const taut_surface_measure m = measured(s);
    for (int edge = 0; edge < 4; edge++) {
        const taut_edge_measure *e = &m.edges[edge];
        CHECK_NEAR(e->length, edge < 2 ? 2 * TAUT_PI : 8 * TAUT_PI, 1e-13 * e->length, "edge %d",
                   edge);
        CHECK_NEAR(e->max_abs_normal_curvature, edge < 2 ? 1 : 0.25, 1e-14, "edge %d", edge);
        CHECK_NEAR(e->max_angle_normal_binormal, TAUT_PI / 2, 1e-7, "edge %d", edge);
    }
    taut_surface_free(s);
}

/* Straight lines on a saddle: asymptotic, no binormal. */
static void test_straight(void)
{
    for (int raise = 1; raise < 6; raise++) {
        taut_surface *s = shape_cylinder(1, 2, raise), *saddle = shape_saddle(3);
        taut_surface_measure m = measured(s);
        for (int edge = 0; edge < 2; edge++) {
            CHECK_NEAR(m.edges[edge].length, 2, 1e-15 * 4, "ruling");
            CHECK_NEAR(m.edges[edge].max_abs_normal_curvature, 0, 1e-14, "ruling");
            CHECK(isnan(m.edges[edge].max_angle_normal_binormal), "degree %d", raise);
        }
        m = measured(saddle);
        for (int edge = 0; edge < 4; edge++) {
            CHECK_NEAR(m.edges[edge].length, edge % 2 == 1 ? sqrt(10) : 1, 1e-14, "saddle");
            CHECK(m.edges[edge].max_abs_normal_curvature == 0, "saddle");
            CHECK(isnan(m.edges[edge].max_angle_normal_binormal), "saddle");
        }
        taut_surface_free(s);
        taut_surface_free(saddle);
    }
}

/* Enneper's edge v = 0 is the plane curve (u - u^3/3, 0, u^2), a line of curvature, of length
 * u + u^3/3 and k_n = 2/(1+u^2)^2; its image rotated by 45 degrees in the parameters is an
 * asymptotic line. A rotated window has one for an edge: x(s, t) = X((s-t)/sqrt2, (s+t)/sqrt2). */
static void test_enneper(void)
{
    taut_surface *s = shape_enneper(0, 1, 0, 1);
    const taut_surface_measure m = measured(s);
    CHECK_NEAR(m.edges[2].length, 4.0 / 3, 2e-15, "v0");
    CHECK_NEAR(m.edges[2].max_abs_normal_curvature, 2, 1e-14, "v0");
    CHECK_NEAR(m.edges[2].max_angle_normal_binormal, TAUT_PI / 2, 1e-7, "v0");
    taut_surface_free(s);
}

/* z = x y over a parabola in its tangent plane at the origin: the ruled surface between an
 * asymptotic curve and another. The helicoid-like strip x(u, v) = c(u) + v n'(u) ... is not needed:
 * any strip c(u) + v (b x c')(u) has its edge v = 0 asymptotic with the normal along b. For the
 * twisted cubic c = (u, u^2, u^3): b = (3 u^2, -3 u, 1) up to a factor, c' x b has degree 4. */
static void test_asymptotic(void)
{
    /* c' x b = (2u + 9u^3, 9 u^4 - 1, -3u - 6u^3) */
    const double c[3][5] = {{0, 1}, {0, 0, 1}, {0, 0, 0, 1}};
    const double d[3][5] = {{0, 2, 0, 9}, {-1, 0, 0, 0, 9}, {0, -3, 0, -6}};
    double points[5][2][3], row[5], across[5];
    for (int k = 0; k < 3; k++) {
        shape_bernstein(4, 5, c[k], 0.25, 1, row);
        shape_bernstein(4, 5, d[k], 0.25, 1, across);
        for (int i = 0; i < 5; i++) {
            points[i][0][k] = row[i];
            points[i][1][k] = row[i] + 0.1 * across[i];
        }
    }
    taut_surface *s =
        shape_surface(shape_bezier(4, 0.25, 1), shape_bezier(1, 0, 1), points[0][0], NULL);
    const taut_surface_measure m = measured(s);
    CHECK_NEAR(m.edges[2].max_abs_normal_curvature, 0, 2e-14, "v0");
    CHECK_NEAR(m.edges[2].max_angle_normal_binormal, 0, 2e-14, "v0");
    CHECK(m.edges[3].max_angle_normal_binormal > 1e-3, "v1 is none");
    taut_surface_free(s);
}

/* Circle, twisted cubic, straight lines, a point, a cusp. */
static void test_curves(void)
{
    taut_curve_measure m;
    const double w = sqrt(0.5), weights[3] = {1, w, 1};
    const double arc[9] = {2, 0, 0, 2, 2, 0, 0, 2, 0};
    taut_curve *c = shape_curve(shape_bezier(2, 0, 1), arc, weights);
    CHECK(taut_measure_curve(c, NULL, &m, NULL) == TAUT_OK, "arc");
    CHECK_NEAR(m.length, TAUT_PI, 4e-15, "arc");
    CHECK_NEAR(m.max_curvature, 0.5, 2e-15, "arc");
    CHECK_NEAR(m.max_torsion, 0, 1e-14, "arc");
    taut_curve_free(c);

    /* (t, t^2, t^3): curvature 2 at 0, torsion 3 at 0, length int sqrt(1 + 4 t^2 + 9 t^4) =
     * 1.86302298251225139 (mpmath) */
    const double cubic[12] = {0, 0, 0, 1. / 3, 0, 0, 2. / 3, 1. / 3, 0, 1, 1, 1};
    c = shape_curve(shape_bezier(3, 0, 1), cubic, NULL);
    CHECK(taut_measure_curve(c, NULL, &m, NULL) == TAUT_OK, "cubic");
    CHECK_NEAR(m.length, 1.86302298251225139, 2e-15, "cubic");
    CHECK_NEAR(m.max_torsion, 3, 1e-14, "cubic");
    taut_curve_free(c);

    /* straight, at uneven speed; then a point */
    double line[12];
    for (int k = 0; k < 12; k++) {
        line[k] = (k % 3 + 1) * (double)((k / 3) * (k / 3)) + 0.1;
    }
    c = shape_curve(shape_bezier(3, 0, 1), line, NULL);
    CHECK(taut_measure_curve(c, NULL, &m, NULL) == TAUT_OK, "line");
    CHECK_NEAR(m.length, 9 * sqrt(14), 1e-13, "line");
    CHECK_NEAR(m.max_curvature, 0, 1e-13, "line");
    CHECK(isnan(m.max_torsion), "line: torsion %g", m.max_torsion);
    taut_curve_free(c);
    memset(line, 0, sizeof line);
    c = shape_curve(shape_bezier(3, 0, 1), line, NULL);
    CHECK(taut_measure_curve(c, NULL, &m, NULL) == TAUT_OK, "point");
    CHECK(m.length == 0 && isnan(m.max_curvature) && isnan(m.max_torsion), "point");
    taut_curve_free(c);

    /* the cusp (s^2, s^3), s = 2t - 1, length 2 (13^1.5 - 8) / 27 */
    double cusp[4][3] = {{0}};
    const double x[4] = {1, -4, 4, 0}, y[4] = {-1, 6, -12, 8};
    double b[4];
    shape_bernstein(3, 4, x, 0, 1, b);
    for (int i = 0; i < 4; i++) {
        cusp[i][0] = b[i];
    }
    shape_bernstein(3, 4, y, 0, 1, b);
    for (int i = 0; i < 4; i++) {
        cusp[i][1] = b[i];
    }
    c = shape_curve(shape_bezier(3, 0, 1), cusp[0], NULL);
    CHECK(taut_measure_curve(c, NULL, &m, NULL) == TAUT_OK, "cusp");
    CHECK_NEAR(m.length, 2 * (pow(13, 1.5) - 8) / 27, 1e-13, "cusp");
    CHECK(isfinite(m.max_curvature) && m.max_curvature > 10, "the cusp itself is left out");
    taut_curve_free(c);
}

/* Length is of the size of the points, curvatures of its inverse, at any size. */
static void test_sizes(void)
{
    const double cubic[12] = {0, 0, 0, 1, 0, 0.5, 2, 1, 0, 1, 1, 1};
    taut_curve_measure unit, m;
    taut_curve *c = shape_curve(shape_bezier(3, 0, 1), cubic, NULL);
    CHECK(taut_measure_curve(c, NULL, &unit, NULL) == TAUT_OK, "unit");
    taut_curve_free(c);
    for (int k = -500; k <= 500; k += 100) {
        double points[12];
        for (int i = 0; i < 12; i++) {
            points[i] = ldexp(cubic[i], k);
        }
        c = shape_curve(shape_bezier(3, -ldexp(1, k / 10), ldexp(1, k / 10)), points, NULL);
        CHECK(taut_measure_curve(c, NULL, &m, NULL) == TAUT_OK, "k=%d", k);
        CHECK_NEAR(ldexp(m.length, -k), unit.length, 4e-15, "k=%d", k);
        CHECK_NEAR(ldexp(m.max_curvature, k), unit.max_curvature, 1e-13, "k=%d", k);
        CHECK_NEAR(ldexp(m.max_torsion, k), unit.max_torsion, 1e-13, "k=%d", k);
        taut_curve_free(c);
    }
    CHECK(taut_measure_curve(NULL, NULL, &m, NULL) == TAUT_BAD_ARGUMENT, "refused");
}

int main(void)
{
    test_torus();
    test_straight();
    test_enneper();
    test_asymptotic();
    test_curves();
    test_sizes();
    return check_failures != 0;
}
