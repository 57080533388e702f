/* test_rational.c -- integrals of patches whose weights are far apart: against the trapezoidal rule
 * of logistic.h, against each other for growing weights, and what is told where digits are missing.
 */
#include "check.h"
#include "logistic.h"
#include "shapes.h"

#include "taut/measure.h"

#include <string.h>

/* A biquadratic net with one weight W; its middle point at height z. */
static taut_surface *make_peak(double weight, int at, double z)
{
    const double points[9][3] = {{0, 0, 0}, {0, 1, 1}, {0, 2, 0}, {1, 0, 3}, {1, 1, z},
                                 {1, 2, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 1}};
    double weights[9] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
    weights[at] = weight;
    return shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), points[0], weights);
}

static taut_surface_measure measured(const taut_surface *s)
{
    taut_surface_measure m;
    memset(&m, 0, sizeof m);
    CHECK(taut_measure_surface(s, NULL, &m, NULL) == TAUT_OK, "measure");
    return m;
}

static void check_figures(const taut_surface *s, double tolerance, const char *what, double weight)
{
    const taut_surface_measure m = measured(s);
    const double found[4] = {m.area, m.dirichlet_energy, m.bending_energy, m.isothermality};
    double expected[LOGISTIC_FIGURES], area = 0, area_error = 0, energy = 0;

    logistic_integrals(s, 48, 0.125, expected);
    for (int f = 0; f < 4; f++) {
        CHECK_NEAR(found[f], expected[f], tolerance * expected[f], "%s %g, figure %d", what, weight,
                   f);
    }
    CHECK(m.area_error == 0 && m.dirichlet_energy_error == 0 && m.bending_energy_error == 0 &&
              m.isothermality_error == 0,
          "%s %g", what, weight);
    CHECK(taut_surface_area(s, &area, &area_error) == TAUT_OK && area_error == 0, "%s", what);
    CHECK_NEAR(area, m.area, 1e-12 * m.area, "%s %g", what, weight);
    CHECK(taut_surface_dirichlet_energy(s, &energy) == TAUT_OK, "%s", what);
    CHECK_NEAR(energy, m.dirichlet_energy, 1e-12 * energy, "%s %g", what, weight);
}

/* One weight from 1e2 to 1e8, in the middle, on an edge, in a corner: the layers it makes are as
 * thin as 1/W. */
static void test_one_weight(void)
{
    static const int places[3] = {4, 1, 0};
    for (int place = 0; place < 3; place++) {
        for (double weight = 1e2; weight < 2e8; weight *= 1000) {
            taut_surface *s = make_peak(weight, places[place], 0.55);
            check_figures(s, 1e-11, place == 0 ? "middle" : place == 1 ? "edge" : "corner", weight);
            taut_surface_free(s);
        }
        taut_surface *s = make_peak(1e-6, places[place], 0.55);
        check_figures(s, 1e-11, "light", 1e-6);
        taut_surface_free(s);
    }
}

/* With the weight W in the middle the energy is asymptotically e W, the bending energy b W^3. */
static void test_growth(void)
{
    double before[2] = {0, 0};
    for (double weight = 1e9; weight < 2e12; weight *= 10) {
        taut_surface *s = make_peak(weight, 4, 0.55);
        const taut_surface_measure m = measured(s);
        const double now[2] = {m.dirichlet_energy / weight,
                               m.bending_energy / weight / weight / weight};
        for (int k = 0; k < 2 && weight > 1e9; k++) {
            CHECK_NEAR(now[k], before[k], 1e-7 * now[k], "%g, %d", weight, k);
        }
        CHECK(m.dirichlet_energy_error == 0 && m.bending_energy_error == 0, "%g", weight);
        memcpy(before, now, sizeof before);
        taut_surface_free(s);
    }
}

/* A bicubic net with weights of three digits within 1e-2 and 1e2, on which two rules over the whole
 * span agree to twelve digits and are 8e-8 off. */
static void test_moderate(void)
{
    static const double points[16][3] = {
        {0.212, 0.0307, 0.0848}, {-0.104, 1.12, 0.0842}, {-0.0474, 2.21, -0.279},
        {0.261, 3.09, 0.404},    {0.887, -0.224, 1.13},  {0.88, 0.991, 0.451},
        {0.756, 1.94, -0.663},   {1.3, 3.07, 0.533},     {2.3, 0.283, -1.22},
        {1.66, 1.2, 0.617},      {1.95, 1.96, 0.434},    {1.63, 3.42, 0.578},
        {3.06, -0.266, -0.376},  {2.96, 1.21, 0.2},      {3.09, 1.9, -0.401},
        {3.03, 2.82, -1.18}};
    static const double weights[16] = {0.0132, 13.6, 8.49, 0.472, 0.0288, 0.152, 1.71, 37.9,
                                       0.844,  78.5, 1.28, 0.053, 2.89,   2.51,  2.49, 7.92};
    taut_surface *s =
        shape_surface(shape_bezier(3, 0, 1), shape_bezier(3, 0, 1), points[0], weights);
    double expected[LOGISTIC_FIGURES];
    const taut_surface_measure m = measured(s);
    logistic_integrals(s, 48, 0.0625, expected);
    CHECK_NEAR(expected[LOGISTIC_AREA], 11.275246736365, 1e-10, "the rule of the test");
    CHECK_NEAR(m.area, expected[LOGISTIC_AREA], 1e-11, "moderate");
    CHECK_NEAR(m.dirichlet_energy, expected[LOGISTIC_DIRICHLET], 1e-11 * m.dirichlet_energy,
               "energy");
    CHECK(m.area_error == 0, "moderate: %g", m.area_error);
    taut_surface_free(s);
}

/* A segment has the area 0 and rounding: an error is told, and it is one. A surface of size 1e-200
 * has an area below all doubles, one of 1e200 above: 0 and none, and isothermality of both. */
static void test_told(void)
{
    double points[9][3];
    for (int k = 0; k < 9; k++) {
        points[k][0] = 0.3 * (k / 3) + 0.7 * (k % 3);
        points[k][1] = points[k][0] / 3;
        points[k][2] = 1 - points[k][0];
    }
    taut_surface *s = shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), points[0], NULL);
    taut_surface_measure m = measured(s);
    CHECK(m.area_error > 0 && m.area <= m.area_error && m.area_error < 1e-11, "segment: %g +- %g",
          m.area, m.area_error);
    CHECK(m.dirichlet_energy_error == 0, "segment: %g", m.dirichlet_energy_error);
    taut_surface_free(s);

    taut_surface *peak = make_peak(1e3, 4, 0.55);
    const double turn[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, still[3] = {0, 0, 0};
    const double isothermality = measured(peak).isothermality;
    for (int sign = -1; sign <= 1; sign += 2) {
        s = shape_moved(peak, sign < 0 ? 0x1p-700 : 0x1p700, turn, still);
        m = measured(s);
        CHECK(sign < 0 ? m.area == 0 && m.dirichlet_energy == 0
                       : isnan(m.area) && isnan(m.dirichlet_energy) && isnan(m.bending_energy),
              "sign %d: %g %g", sign, m.area, m.dirichlet_energy);
        CHECK(m.isothermality == isothermality, "sign %d: %g", sign, m.isothermality);
        taut_surface_free(s);
    }
    taut_surface_free(peak);
}

/* Beyond 2^43 the layer is thinner than any cell: there is no number, not that of a surface without
 * it. Up to there the figures are whole; on one line of the net only, or in one span only. */
static void test_apart(void)
{
    static const int places[3] = {4, 1, 0};
    for (int place = 0; place < 3; place++) {
        for (int k = 0; k < 3; k++) {
            const double weight = k == 0 ? 0x1.8p43 : k == 1 ? 1e20 : 1e-30;
            taut_surface *s = make_peak(weight, places[place], 0.55);
            const taut_surface_measure m = measured(s);
            double area = 0, area_error = 0, figure = 0;
            CHECK(isnan(m.area) && isnan(m.area_error) && isnan(m.mean_abs_mean), "%g", weight);
            CHECK(isnan(m.dirichlet_energy) && isnan(m.dirichlet_energy_error), "%g", weight);
            CHECK(isnan(m.bending_energy) && isnan(m.bending_energy_error), "%g", weight);
            CHECK(isnan(m.isothermality) && isnan(m.isothermality_error), "%g", weight);
            CHECK(taut_surface_area(s, &area, &area_error) == TAUT_OK && isnan(area) &&
                      isnan(area_error),
                  "%g", weight);
            CHECK(taut_surface_isothermality(s, &figure) == TAUT_OK && isnan(figure), "%g", weight);
            taut_surface_free(s);
        }
    }
    double area = 0, area_error = 0;
    taut_surface *s = make_peak(0x1p43, 4, 0.55);
    CHECK(taut_surface_area(s, &area, &area_error) == TAUT_OK && area > 4 && area < 8 &&
              area_error < 1e-9 * area,
          "%g +- %g", area, area_error);
    taut_surface_free(s);
}

/* Far apart, but by one factor a row and one a column: lines do not meet such weights, only the whole
 * net does. The plane square has the area 1, whatever its weights. */
static void test_products(void)
{
    double points[9][3], weights[9];
    for (int k = 0; k < 9; k++) {
        points[k][0] = 0.5 * (k / 3);
        points[k][1] = 0.5 * (k % 3);
        points[k][2] = 0;
        weights[k] = ldexp(1, 16 * (k / 3) + 16 * (k % 3));
    }
    taut_surface *s =
        shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), points[0], weights);
    CHECK_NEAR(measured(s).area, 1, 1e-11, "products");
    taut_surface_free(s);
}

/* int sqrt(1 + h_v^2) dv over [0, 1], h_v = c (2 v - 1). */
static double arc_of_parabola(double c)
{
    return c > 0 ? 0.5 * sqrt(1 + c * c) + 0.5 * asinh(c) / c : 1;
}

/* (L u, v, h(u, v)) for L up to the end of the doubles, as far as L may be from the width 1: the area is
 * L times that of h_v alone, h_v = 5 u (1 - u) (2 v - 1). Coordinates are rounded each by itself: no
 * error is told. |H| is not where squares leave the range of doubles. */
static void test_long(void)
{
    static const double lengths[] = {1e10, 1e15, 1e100, 1e154, 1e160, 1e200, 1e300};
    enum { STEPS = 1000 };
    double raised = 0;

    for (int k = 0; k <= STEPS; k++) { /* Simpson's rule */
        const double u = (double)k / STEPS, weight = k % STEPS == 0 ? 1 : k % 2 == 1 ? 4 : 2;
        raised += weight / (3 * STEPS) * arc_of_parabola(5 * u * (1 - u));
    }
    for (int k = 0; k < 14; k++) {
        const double length = lengths[k / 2];
        double points[9][3];
        for (int i = 0; i < 9; i++) {
            points[i][0] = length * 0.5 * (i / 3);
            points[i][1] = 0.5 * (i % 3);
            points[i][2] = k % 2 == 0 || i / 3 != 1 ? 0 : i == 4 ? -0.25 : 1;
        }
        taut_surface *s =
            shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), points[0], NULL);
        const taut_surface_measure m = measured(s);
        CHECK_NEAR(m.area / length, k % 2 == 0 ? 1 : raised, 1e-11, "%g", length);
        CHECK(m.area_error == 0, "%g: %g", length, m.area_error);
        CHECK(length < 1e150 || isnan(m.mean_abs_mean), "%g: %g", length, m.mean_abs_mean);
        taut_surface_free(s);
    }
}

int main(void)
{
    test_one_weight();
    test_growth();
    test_moderate();
    test_told();
    test_apart();
    test_products();
    test_long();
    return check_failures != 0;
}
