/* test_forms.c -- fundamental forms against closed forms, over all sizes, and where there is no
 * normal. */
#include "check.h"
#include "shapes.h"

#include "taut/measure.h"

#include <string.h>

/* The graph z = (a x^2 + 2 b x y + c y^2) / 2 at the origin, in parameters of the given speeds:
 * H = (a + c) / 2, K = a c - b^2. */
static void graph(double a, double b, double c, double su, double sv, double size,
                  double values[6][3])
{
    memset(values, 0, 18 * sizeof(double));
    values[TAUT_XU][0] = su * size;
    values[TAUT_XV][1] = sv * size;
    values[TAUT_XUU][2] = a * su * su * size;
    values[TAUT_XUV][2] = b * su * sv * size;
    values[TAUT_XVV][2] = c * sv * sv * size;
}

/* Coordinates of any size, parameters of any speed: H scales with 1/size, K with its square, and
 * both keep their digits (a dozen roundings). */
static void test_sizes(void)
{
    for (int trial = 0; trial < 2000; trial++) {
        const double a = random_in(-2, 2), b = random_in(-2, 2), c = random_in(-2, 2);
        const double size = ldexp(1, random_int(-500, 500));
        const double su = ldexp(1, random_int(-20, 20)), sv = ldexp(1, random_int(-20, 20));
        double values[6][3];
        taut_forms forms;
        graph(a, b, c, su, sv, size, values);
        taut_forms_of((const double(*)[3])values, &forms);
        CHECK(forms.regular, "size=%g", size);
        CHECK_NEAR(forms.mean * size, (a + c) / 2, 2e-15, "size=%g su=%g sv=%g", size, su, sv);
        CHECK_NEAR(ldexp(forms.gaussian * size, 0) * size, a * c - b * b, 1e-14, "size=%g", size);
        CHECK_NEAR(forms.normal[2], 1, 1e-15, "size=%g", size);
        CHECK(!isnan(forms.w) && !isnan(forms.e), "size=%g", size);
    }
}

/* Every point of a sphere: |H| = 1/r, K = 1/r^2; of a torus H = (R + 2 r cos) / (2 r (R + r
 * cos)).*/
static void test_surfaces(void)
{
    taut_surface *sphere = shape_sphere(2), *torus = shape_torus(3, 1);
    for (int trial = 0; trial < 500; trial++) {
        double values[6][3];
        taut_forms forms;
        CHECK(taut_surface_eval(sphere, random_in(0, 4), random_in(0.1, 1.9), 2, &values[0][0]) ==
                  TAUT_OK,
              "eval");
        taut_forms_of((const double(*)[3])values, &forms);
        CHECK_NEAR(fabs(forms.mean), 0.5, 5e-13, "sphere");
        CHECK_NEAR(forms.gaussian, 0.25, 5e-13, "sphere");

        CHECK(taut_surface_eval(torus, random_in(0, 4), random_in(0, 4), 2, &values[0][0]) ==
                  TAUT_OK,
              "eval");
        taut_forms_of((const double(*)[3])values, &forms);
        const double rho = hypot(values[0][0], values[0][1]), cosine = rho - 3;
        CHECK_NEAR(fabs(forms.mean), (3 + 2 * cosine) / (2 * rho), 2e-14, "torus");
        CHECK_NEAR(forms.gaussian, cosine / rho, 2e-14, "torus");
    }
    taut_surface_free(sphere);
    taut_surface_free(torus);
}

static void check_singular(const double values[6][3], const char *what)
{
    taut_forms forms;
    taut_forms_of(values, &forms);
    CHECK(!forms.regular, "%s", what);
    CHECK(isnan(forms.mean) && isnan(forms.gaussian) && isnan(forms.normal[0]), "%s", what);
    CHECK(isnan(forms.l) && isnan(forms.m) && isnan(forms.n), "%s", what);
    CHECK(!isnan(forms.e) && !isnan(forms.f) && !isnan(forms.g) && !isnan(forms.w), "%s", what);
}

/* The poles of a sphere anywhere, of any size: the edge is collapsed up to rounding, never exactly.
 */
static void test_no_normal(void)
{
    double values[6][3] = {{0}};
    check_singular((const double(*)[3])values, "a point");
    values[TAUT_XU][0] = 1;
    values[TAUT_XV][0] = -3;
    check_singular((const double(*)[3])values, "parallel");
    values[TAUT_XV][1] = 1e-13;
    check_singular((const double(*)[3])values, "parallel but for rounding");
    for (int trial = 0; trial < 200; trial++) {
        double rotation[3][3];
        const double size = random_log(1e-100, 1e100);
        const double shift[3] = {random_in(-1e3, 1e3) * size, random_in(-1, 1) * size, 0};
        taut_surface *sphere = shape_sphere(1), *moved = NULL;
        taut_forms forms;
        shape_rotation(rotation);
        moved = shape_moved(sphere, size, (const double(*)[3])rotation, shift);
        CHECK(taut_surface_eval(moved, random_in(0, 4), 2, 2, &values[0][0]) == TAUT_OK, "eval");
        check_singular((const double(*)[3])values, "pole");
        CHECK(taut_surface_eval(moved, random_in(0, 4), 1.999, 2, &values[0][0]) == TAUT_OK,
              "eval");
        taut_forms_of((const double(*)[3])values, &forms);
        CHECK(forms.regular, "near the pole, size=%g", size);
        taut_surface_free(sphere);
        taut_surface_free(moved);
    }
}

int main(void)
{
    random_seed(20260301);
    test_sizes();
    test_surfaces();
    test_no_normal();
    return check_failures != 0;
}
