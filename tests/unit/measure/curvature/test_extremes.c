/* test_extremes.c -- extremes over the grid: which points count, from which side, and how often. */
#include "check.h"
#include "shapes.h"

#include "taut/measure.h"

/* A torus of tube radius 1 about a circle of radius 3: K from -1/2 (inner equator) to 1/4, |H| up
 * to 5/8 (outer equator), both on the grid. */
static void test_torus(void)
{
    taut_surface *s = shape_torus(3, 1);
    taut_surface_measure m;
    CHECK(taut_measure_surface(s, NULL, &m, NULL) == TAUT_OK, "torus");
    CHECK_NEAR(m.min_gaussian, -0.5, 1e-14, "torus");
    CHECK_NEAR(m.max_gaussian, 0.25, 1e-14, "torus");
    CHECK_NEAR(m.max_abs_mean, 0.625, 1e-14, "torus");
    CHECK_NEAR(fmod(m.max_abs_mean_at[1], 4), 0, 0, "the outer equator, v=%g",
               m.max_abs_mean_at[1]);
    CHECK(m.singular_points == 0, "torus");
    CHECK_NEAR(m.max_f, 0, 5e-14, "orthogonal parameters");
    taut_surface_free(s);
}

/* A quadratic B-spline profile z(u) over x = u, straight in v: z = left u^2 / 2 up to u = 1/2, from
 * there second derivative `right`, joined C^1. Both one-sided curvatures count there. */
static taut_surface *two_parabolas(double left, double right)
{
    const double z[4] = {0, 0, left / 4, left / 8 + left / 4 + right / 8};
    const double x[4] = {0, 0.25, 0.75, 1};
    double points[8][3];
    for (int k = 0; k < 8; k++) {
        points[k][0] = x[k / 2];
        points[k][1] = k % 2;
        points[k][2] = z[k / 2];
    }
    return shape_surface(shape_bspline(2, 4), shape_bezier(1, 0, 1), points[0], NULL);
}

static void test_knots(void)
{
    for (int swap = 0; swap < 2; swap++) {
        taut_surface *s = two_parabolas(swap ? 0.125 : 4, swap ? 4 : 0.125);
        double left[6][3], right[6][3];
        taut_surface_measure m;
        taut_forms forms;
        double expected = 0;
        /* from the right at the knot, from the left a hair before it */
        CHECK(taut_surface_eval(s, 0.5, 0, 2, &right[0][0]) == TAUT_OK, "eval");
        CHECK(taut_surface_eval(s, nextafter(0.5, 0), 0, 2, &left[0][0]) == TAUT_OK, "eval");
        CHECK(fabs(left[TAUT_XUU][2] - right[TAUT_XUU][2]) > 1, "the curvature jumps");
        const taut_measure_options three = {.grid = 3};
        CHECK(taut_measure_surface(s, &three, &m, NULL) == TAUT_OK, "measure");
        for (int i = 0; i < 3; i++) {
            double values[6][3];
            CHECK(taut_surface_eval(s, 0.5 * i, 0, 2, &values[0][0]) == TAUT_OK, "eval");
            taut_forms_of((const double(*)[3])values, &forms);
            expected = fmax(expected, fabs(forms.mean));
        }
        taut_forms_of((const double(*)[3])left, &forms);
        expected = fmax(expected, fabs(forms.mean));
        CHECK_NEAR(m.max_abs_mean, expected, 1e-14 * expected, "swap=%d", swap);
        taut_surface_free(s);
    }
}

/* Knots in decimals: 1/3 written to 16 digits is still a knot of the grid of 4. */
static void test_decimal_knot(void)
{
    const double knots[8] = {0, 0, 0, 0.3333333333333333, 0.6666666666666666, 1, 1, 1};
    const taut_basis_spec spec = {.type = "bspline", .degree = 2, .knot_count = 8, .knots = knots};
    const double z[5] = {0, 0, 1, 0, 0};
    const double x[5] = {0, 1.0 / 6, 0.5, 5.0 / 6, 1};
    double points[10][3], largest = 0;
    for (int k = 0; k < 10; k++) {
        points[k][0] = x[k / 2];
        points[k][1] = k % 2;
        points[k][2] = z[k / 2];
    }
    taut_surface *s = shape_surface(shape_basis(&spec), shape_bezier(1, 0, 1), points[0], NULL);
    for (int side = -1; side <= 1; side += 2) {
        double values[6][3];
        taut_forms forms;
        CHECK(taut_surface_eval(s, 1.0 / 3 + side * 1e-12, 0, 2, &values[0][0]) == TAUT_OK, "eval");
        taut_forms_of((const double(*)[3])values, &forms);
        largest = fmax(largest, fabs(forms.mean));
    }
    const taut_measure_options four = {.grid = 4};
    taut_surface_measure m;
    CHECK(taut_measure_surface(s, &four, &m, NULL) == TAUT_OK, "measure");
    CHECK(m.max_abs_mean >= largest * (1 - 1e-9), "%g, one-sided %g", m.max_abs_mean, largest);
    taut_surface_free(s);
}

/* Both poles of a sphere are singular all along, and counted once a grid point; so is a crease
 * whose one side has no normal. */
static void test_singular(void)
{
    for (int grid = 2; grid < 20; grid++) {
        const taut_measure_options options = {.grid = grid};
        taut_surface *s = shape_sphere(1);
        taut_surface_measure m;
        CHECK(taut_measure_surface(s, &options, &m, NULL) == TAUT_OK, "sphere");
        CHECK(m.singular_points == 2 * grid, "grid=%d: %d", grid, (int)m.singular_points);
        if (grid > 2) {
            CHECK_NEAR(m.max_gaussian, 1, 1e-9, "grid=%d", grid);
        } else {
            CHECK(isnan(m.max_gaussian) && isnan(m.max_abs_mean_at[0]), "only poles");
        }
        taut_surface_free(s);
    }
}

/* A hill of size 1, up to 2^52 from the origin, where its points are still whole: the figures stay, with
 * weights and without. */
static void test_far(void)
{
    static const double weights[9] = {1, 1, 1, 1, 2, 1, 1, 1, 1};
    for (int rational = 0; rational < 2; rational++) {
        taut_surface_measure near = {0};
        for (int k = 0; k <= 52; k += 13) {
            const double away = k > 0 ? ldexp(1, k) : 0;
            double points[9][3];
            for (int i = 0; i < 9; i++) {
                points[i][0] = away + i / 3;
                points[i][1] = away + i % 3;
                points[i][2] = away + (i == 4);
            }
            taut_surface *s = shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), points[0],
                                            rational ? weights : NULL);
            taut_surface_measure m;
            CHECK(taut_measure_surface(s, NULL, &m, NULL) == TAUT_OK, "2^%d", k);
            near = k == 0 ? m : near;
            CHECK_NEAR(m.max_abs_mean, rational ? 1 : 0.5, 1e-13, "2^%d", k);
            CHECK_NEAR(m.max_abs_mean, near.max_abs_mean, 1e-13, "2^%d", k);
            CHECK_NEAR(m.max_gaussian, near.max_gaussian, 1e-13, "2^%d", k);
            CHECK_NEAR(m.min_gaussian, near.min_gaussian, 1e-13, "2^%d", k);
            CHECK(m.singular_points == 0 && m.mean_abs_mean < m.max_abs_mean, "2^%d: %d", k,
                  (int)m.singular_points);
            taut_surface_free(s);
        }
    }
}

int main(void)
{
    test_torus();
    test_knots();
    test_decimal_knot();
    test_singular();
    test_far();
    return check_failures != 0;
}
