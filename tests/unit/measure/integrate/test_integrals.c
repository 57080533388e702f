/* test_integrals.c -- areas, energies and means against closed forms. */
#include "check.h"
#include "shapes.h"

#include "core/constants.h"
#include "taut/measure.h"

#include <string.h>

static taut_surface_measure measured(const taut_surface *surface)
{
    taut_surface_measure m;
    taut_error error = {.message = ""};
    memset(&m, 0, sizeof m);
    CHECK(taut_measure_surface(surface, NULL, &m, &error) == TAUT_OK, "%s", error.message);
    return m;
}

/* The four functions alone give what measuring everything gives. */
static void check_alone(const taut_surface *surface, const taut_surface_measure *m)
{
    double area = 0, error = 1, dirichlet = 0, bending = 0, iso = 0;
    CHECK(taut_surface_area(surface, &area, &error) == TAUT_OK, "area");
    CHECK(taut_surface_dirichlet_energy(surface, &dirichlet) == TAUT_OK, "dirichlet");
    CHECK(taut_surface_bending_energy(surface, &bending) == TAUT_OK, "bending");
    CHECK(taut_surface_isothermality(surface, &iso) == TAUT_OK, "isothermality");
    CHECK_NEAR(area, m->area, 2e-12 * m->area, "area");
    CHECK_NEAR(dirichlet, m->dirichlet_energy, 2e-12 * dirichlet, "dirichlet");
    CHECK_NEAR(bending, m->bending_energy, 2e-12 * bending, "bending");
    CHECK_NEAR(iso, m->isothermality, 1e-12, "isothermality");
    CHECK(error == m->area_error, "error %g", error);
}

/* Areas to 1e-13: adaptive sums of a few hundred nodes, each good to a few roundings. */
static void test_quadrics(void)
{
    taut_surface *s = shape_sphere(2);
    taut_surface_measure m = measured(s);
    CHECK_NEAR(m.area, 16 * TAUT_PI, 16 * TAUT_PI * 1e-13, "sphere");
    CHECK_NEAR(m.mean_abs_mean, 0.5, 1e-7, "sphere");
    CHECK(m.area_error == 0, "sphere");
    check_alone(s, &m);
    taut_surface_free(s);

    s = shape_torus(3, 1);
    m = measured(s);
    CHECK_NEAR(m.area, 12 * TAUT_PI * TAUT_PI, 12 * TAUT_PI * TAUT_PI * 1e-13, "torus");
    /* int H = pi (R - 0) per turn: iint H dA = int int (R + 2 r cos) / 2 = 2 pi^2 R */
    CHECK_NEAR(m.mean_abs_mean, 0.5, 1e-7, "torus");
    check_alone(s, &m);
    taut_surface_free(s);

    s = shape_cylinder(2, 3, 2);
    m = measured(s);
    CHECK_NEAR(m.area, 12 * TAUT_PI, 12 * TAUT_PI * 1e-13, "cylinder");
    CHECK_NEAR(m.mean_abs_mean, 0.25, 1e-7, "cylinder");
    check_alone(s, &m);
    taut_surface_free(s);
}

/* z = c u v: all integrals in closed form. */
static void test_saddle(void)
{
    for (double c = 0.25; c < 10; c *= 2) {
        const double c2 = c * c;
        taut_surface *s = shape_saddle(c);
        const taut_surface_measure m = measured(s);
        const double mean = ((1 + 2 * c2) * log1p(2 * c2) - 2 * (1 + c2) * log1p(c2)) / (4 * c);
        CHECK_NEAR(m.dirichlet_energy, 1 + c2 / 3, 1e-14 * (1 + c2), "c=%g", c);
        CHECK_NEAR(m.bending_energy, 2 * c2, 1e-14 * c2, "c=%g", c);
        CHECK_NEAR(m.isothermality, sqrt(28.0 / 45) * c2 / (2 + 2 * c2 / 3), 1e-14, "c=%g", c);
        CHECK_NEAR(m.mean_abs_mean * m.area, mean, 1e-7 * mean, "c=%g", c);
        CHECK_NEAR(m.min_gaussian, -c2, 1e-14 * c2, "c=%g", c);
        CHECK_NEAR(m.max_gaussian, -c2 / (1 + 2 * c2) / (1 + 2 * c2), 1e-14, "c=%g", c);
        if (c == 1) {
            CHECK_NEAR(m.area, (sqrt(3) + 4 * asinh(sqrt(0.5)) - TAUT_PI / 6) / 3, 2e-15, "c=1");
        }
        check_alone(s, &m);
        taut_surface_free(s);
    }
}

/* iint (1 + u^2 + v^2)^2, which is also the Dirichlet energy, as the parameters are isothermal;
 * H = 0 up to rounding. */
static double enneper_area(double u0, double u1, double v0, double v1)
{
    const double u = u1 - u0, v = v1 - v0;
    const double u2 = (pow(u1, 3) - pow(u0, 3)) / 3, v2 = (pow(v1, 3) - pow(v0, 3)) / 3;
    const double u4 = (pow(u1, 5) - pow(u0, 5)) / 5, v4 = (pow(v1, 5) - pow(v0, 5)) / 5;
    return u * v + u4 * v + u * v4 + 2 * u2 * v + 2 * u * v2 + 2 * u2 * v2;
}

static void test_enneper(void)
{
    taut_surface *s = shape_enneper(0, 1, 0, 1);
    taut_surface_measure m = measured(s);
    CHECK_NEAR(m.area, 133.0 / 45, 5e-15, "area");
    CHECK_NEAR(m.dirichlet_energy, 133.0 / 45, 5e-15, "energy");
    taut_surface_free(s);
    for (int trial = 0; trial < 50; trial++) {
        const double u0 = random_in(-1, 1), u1 = u0 + random_log(1e-3, 2);
        const double v0 = random_in(-1, 1), v1 = v0 + random_log(1e-3, 2);
        const double area = enneper_area(u0, u1, v0, v1);
        s = shape_enneper(u0, u1, v0, v1);
        m = measured(s);
        /* the closed form cancels by the ratio of the coordinates to the width */
        const double noise = 1e-14 * (1 + 4 / (u1 - u0) + 4 / (v1 - v0));
        CHECK_NEAR(m.area, area, area * noise, "u %g..%g v %g..%g", u0, u1, v0, v1);
        CHECK_NEAR(m.dirichlet_energy, area, area * noise, "u %g..%g", u0, u1);
        CHECK_NEAR(m.isothermality * sqrt((u1 - u0) * (v1 - v0)), 0, noise, "u %g..%g", u0, u1);
        CHECK_NEAR(m.mean_abs_mean, 0, noise / fmin(u1 - u0, v1 - v0), "u %g..%g", u0, u1);
        taut_surface_free(s);
    }
}

/* A quarter of a cone of radius 1 and height h, apex at u = 0: the edge u0 is a point. */
static void test_cone(void)
{
    for (double h = 0; h < 3; h += 0.5) {
        const double w = sqrt(0.5), weights[6] = {1, w, 1, 1, w, 1};
        const double points[6][3] = {{0, 0, h}, {0, 0, h}, {0, 0, h},
                                     {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        taut_surface *s =
            shape_surface(shape_bezier(1, 0, 1), shape_bezier(2, 0, 1), points[0], weights);
        const taut_surface_measure m = measured(s);
        const double area = TAUT_PI * sqrt(1 + h * h) / 4;
        CHECK_NEAR(m.area, area, 1e-13 * area, "h=%g", h);
        CHECK(m.area_error == 0, "h=%g", h);
        CHECK(m.singular_points == 101, "h=%g: %d", h, (int)m.singular_points);
        CHECK_NEAR(m.edges[0].length, 0, 1e-15, "h=%g", h);
        CHECK_NEAR(m.edges[1].length, TAUT_PI / 2, 1e-13, "h=%g", h);
        CHECK_NEAR(m.max_gaussian, 0, 1e-10, "h=%g", h);
        /* |H| = h / (2 rho sqrt(1 + h^2)), rho the distance from the axis; iint |H| = pi h / 4 */
        CHECK_NEAR(m.mean_abs_mean * area, TAUT_PI * h / 4, 1e-6, "h=%g", h);
        taut_surface_free(s);
    }
}

/* A plane folded along an oblique line: x = (u + v - c)^2, y = u - v, W = 4 |u + v - c|,
 * iint W = 4 (1 - c + c^3 / 3). The kink crosses cells between their nodes. */
static void test_fold(void)
{
    for (double c = 0.015625; c < 1; c += 0.32) {
        double points[3][3][3], area = 4 * (1 - c + c * c * c / 3);
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                /* blossom of (u + v - c)^2: u^2 -> i == 2, u -> i/2, u v -> i j / 4 */
                points[i][j][0] = (i == 2) + (j == 2) + c * c + 2.0 * i * j / 4 - c * i - c * j;
                points[i][j][1] = i / 2.0 - j / 2.0;
                points[i][j][2] = 0;
            }
        }
        taut_surface *s =
            shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), points[0][0], NULL);
        double found = 0, error = 0;
        CHECK(taut_surface_area(s, &found, &error) == TAUT_OK, "c=%g", c);
        CHECK_NEAR(found, area, 1e-10 * area, "c=%g error %g", c, error);
        CHECK(error < 1e-9 * area, "c=%g error %g", c, error);
        taut_surface_free(s);
    }
}

/* (u^2, v^2, u v): the normal vanishes in a corner, where W = 2 sqrt(u^4 + v^4 + 4 u^2 v^2) is not
 * smooth. In polar form iint W = int_0^1 sqrt(1 + t^4 + 4 t^2) dt = 1.52953191694937715 (mpmath).
 */
static void test_corner(void)
{
    double points[3][3][3];
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            points[i][j][0] = i == 2;
            points[i][j][1] = j == 2;
            points[i][j][2] = i * j / 4.0;
        }
    }
    taut_surface *s =
        shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), points[0][0], NULL);
    const taut_surface_measure m = measured(s);
    CHECK_NEAR(m.area, 1.5295319169493771, 1e-12, "corner");
    CHECK(m.area_error == 0 && m.singular_points == 1, "corner: %d", (int)m.singular_points);
    taut_surface_free(s);
}

/* A point and a segment have no area, and nothing that needs a normal. */
static void test_degenerate(void)
{
    double points[16][3] = {{0}};
    taut_surface *s = shape_surface(shape_bezier(3, 0, 1), shape_bezier(3, 0, 1), points[0], NULL);
    taut_surface_measure m = measured(s);
    CHECK(m.area == 0 && m.dirichlet_energy == 0 && m.bending_energy == 0, "point");
    CHECK(m.isothermality == 0 && m.area_error == 0, "point");
    CHECK(isnan(m.mean_abs_mean) && isnan(m.max_abs_mean) && isnan(m.min_gaussian), "point");
    CHECK(m.singular_points == 101 * 101, "point");
    taut_surface_free(s);
    for (int k = 0; k < 16; k++) {
        points[k][0] = 0.3 * (k / 4) + 0.7 * (k % 4);
        points[k][1] = 2 * points[k][0] + 0.1;
        points[k][2] = 0.7 - points[k][0];
    }
    s = shape_surface(shape_bezier(3, 0, 1), shape_bezier(3, 0, 1), points[0], NULL);
    m = measured(s);
    CHECK_NEAR(m.area, 0, 1e-13, "segment");
    CHECK(isnan(m.mean_abs_mean) && m.singular_points == 101 * 101, "segment");
    /* what rounding may leave of an area of 0 is more than 1e-10 of it */
    CHECK(m.area_error < 1e-11 && m.dirichlet_energy > 0, "segment: %g", m.area_error);
    taut_surface_free(s);
}

/* A cylinder over the cubic z = c (s - s0)^3, s = u + 2 v, x = s, y = v: H W = f'' / (2 (1 + f'^2))
 * changes sign along the oblique line s = s0. int_0^s |H W| is g(s) = (atan f'(0) -+ atan f'(s)) /
 * 2, and iint |H| W = int_0^1 g(1 + 2v) - g(2v) dv, smooth between the v where an end is s0. */
static double total(double c, double s0, double s)
{
    const double turn = atan(3 * c * (s - s0) * (s - s0));
    return (atan(3 * c * s0 * s0) + (s < s0 ? -turn : turn)) / 2;
}

static double simpson(double c, double s0, double lo, double hi)
{
    enum { N = 400 };
    double sum = 0;
    for (int i = 0; i <= N; i++) {
        const double v = lo + (hi - lo) * i / N;
        const double weight = i == 0 || i == N ? 1 : i % 2 == 1 ? 4 : 2;
        sum += weight * (total(c, s0, 1 + 2 * v) - total(c, s0, 2 * v));
    }
    return sum * (hi - lo) / (3 * N);
}

static void test_zero_line(void)
{
    for (double s0 = 0.01; s0 < 3; s0 += 0.23) {
        const double c = 0.4;
        double points[4][4][3], area = 0;
        for (int i = 0; i < 4; i++) {
            for (int j = 0; j < 4; j++) {
                /* the blossom of (u + 2 v - s0)^3 at i ones for u and j for v: the mean, over the
                 * ways to pair them, of the product of three factors u_k + 2 v_k - s0 */
                double sum = 0;
                for (int pick = 0; pick < 8; pick++) {
                    double product = 1;
                    const int ones = (pick & 1) + (pick >> 1 & 1) + (pick >> 2 & 1);
                    for (int k = 0; k < 3; k++) {
                        product *= (k < i) + 2 * (pick >> k & 1) - s0;
                    }
                    sum += ones == j ? product : 0;
                }
                points[i][j][0] = i / 3.0 + 2 * j / 3.0;
                points[i][j][1] = j / 3.0;
                points[i][j][2] = c * sum / (j == 0 || j == 3 ? 1 : 3);
            }
        }
        taut_surface *s =
            shape_surface(shape_bezier(3, 0, 1), shape_bezier(3, 0, 1), points[0][0], NULL);
        const double cuts[4] = {0, fmin(1, fmax(0, (s0 - 1) / 2)), fmin(1, s0 / 2), 1};
        double expected = 0;
        for (int k = 0; k < 3; k++) {
            expected += simpson(c, s0, cuts[k], cuts[k + 1]);
        }
        const taut_surface_measure m = measured(s);
        CHECK(taut_surface_area(s, &area, NULL) == TAUT_OK, "s0=%g", s0);
        CHECK_NEAR(m.mean_abs_mean * area, expected, 1e-7 * expected, "s0=%g", s0);
        CHECK_NEAR(m.max_gaussian, 0, 1e-13, "s0=%g", s0);
        taut_surface_free(s);
    }
}

/* (N_0(u), v, 0) on one segment of an h-bspline: N_0 = (sinh s - s) / (2 b (cosh b - 1)), s = b - u
 * ([XuWang2006] section 4), falls from N_0(0) to 0 within a layer of width 1, so
 *     area = N_0(0) b,   length of v0 = N_0(0),
 *     iint x_u^2 = (3 b / 2 + sinh(2 b) / 4 - 2 sinh b) / (4 b (cosh b - 1)^2),
 * here with numerators and denominators divided by e^(2 b). */
static void test_layer(void)
{
    static const double lengths[] = {3, 30, 100, 200, 300, 700};
    for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++) {
        const double b = lengths[k], e = exp(-b);
        const taut_basis_spec spec = {.type = "h-bspline", .beta = b, .segments = 1};
        const double top = 0.5 * (1 - e * e) - b * e, bottom = 0.5 * (1 + e * e) - e;
        const double drop = top / (2 * b * bottom);
        const double bend = (1.5 * b * e * e + (1 - e * e * e * e) / 8 - e * (1 - e * e)) /
                            (4 * b * bottom * bottom);
        double points[4][4][3] = {{{0}}};
        for (int i = 0; i < 4; i++) {
            for (int j = 0; j < 4; j++) {
                points[i][j][0] = i == 0;
                points[i][j][1] = (j - 1) * b;
            }
        }
        double energy = 0;
        taut_surface *s = shape_surface(shape_basis(&spec), shape_basis(&spec), points[0][0], NULL);
        const taut_surface_measure m = measured(s);
        CHECK_NEAR(m.area, drop * b, 1e-10 * drop * b, "b=%g", b);
        CHECK_NEAR(m.edges[2].length, drop, 1e-11 * drop, "b=%g", b);
        taut_surface_free(s);

        for (int i = 0; i < 16; i++) {
            points[i / 4][i % 4][1] = 0;
        }
        s = shape_surface(shape_basis(&spec), shape_basis(&spec), points[0][0], NULL);
        CHECK(taut_surface_dirichlet_energy(s, &energy) == TAUT_OK, "b=%g", b);
        CHECK_NEAR(2 * energy, bend, 1e-10 * bend, "b=%g", b);
        taut_surface_free(s);
    }
}

static void test_refusals(void)
{
    taut_surface *s = shape_saddle(1);
    taut_surface_measure m = {.area = 7};
    taut_measure_options options = {.grid = 1};
    double number = 7;
    taut_error error;
    CHECK(taut_measure_surface(NULL, NULL, &m, &error) == TAUT_BAD_ARGUMENT, "surface");
    CHECK(taut_measure_surface(s, &options, &m, &error) == TAUT_BAD_ARGUMENT, "grid");
    CHECK(strcmp(error.where, "/grid") == 0 && error.found == 1, "%s", error.where);
    options.grid = TAUT_GRID_MAX + 1;
    CHECK(taut_measure_surface(s, &options, &m, NULL) == TAUT_BAD_ARGUMENT, "grid");
    options = (taut_measure_options){.threads = -1};
    CHECK(taut_measure_surface(s, &options, &m, NULL) == TAUT_BAD_ARGUMENT, "threads");
    CHECK(taut_surface_area(NULL, &number, NULL) == TAUT_BAD_ARGUMENT, "area");
    CHECK(taut_surface_bending_energy(s, NULL) == TAUT_BAD_ARGUMENT, "bending");
    CHECK(m.area == 7 && number == 7, "outputs are untouched on failure");
    taut_surface_free(s);
}

int main(void)
{
    random_seed(20260302);
    test_quadrics();
    test_saddle();
    test_enneper();
    test_cone();
    test_fold();
    test_corner();
    test_zero_line();
    test_degenerate();
    test_layer();
    test_refusals();
    return check_failures != 0;
}
