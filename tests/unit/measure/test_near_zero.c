/* test_near_zero.c -- figures do not depend on where a range begins: surfaces over ranges far from
 * 0, where a parameter has few digits, against the same over ranges that begin at 0. */
#include "check.h"
#include "shapes.h"

#include "measure/near_zero.h"
#include "taut/measure.h"

#include <stddef.h>

static double points[3 * 6 * 6];

static void fill(void)
{
    for (int k = 0; k < 3 * 6 * 6; k++) {
        const int i = k / 3 / 6, j = k / 3 % 6;
        const double base[3] = {i, j, 0};
        points[k] = base[k % 3] + random_in(-0.4, 0.4);
    }
}

/* Bicubic over [at, at + length] twice; with knots, 6 x 6 points. */
static taut_surface *patch(double at, double length, int with_knots)
{
    double knots[10];
    for (int i = 0; i < 10; i++) {
        knots[i] = at + length * (i < 4 ? 0 : i > 5 ? 1 : i == 4 ? 0.375 : 0.5);
    }
    const taut_basis_spec spec = {.type = "bspline", .degree = 3, .knots = knots, .knot_count = 10};
    return with_knots ? shape_surface(shape_basis(&spec), shape_basis(&spec), points, NULL)
                      : shape_surface(shape_bezier(5, at, at + length),
                                      shape_bezier(5, at, at + length), points, NULL);
}

static void same(double a, double b, const char *what, double at, int with_knots)
{
    CHECK_NEAR(a, b, 1e-12 * fabs(b), "%s over a range from %.17g, knots %d", what, at, with_knots);
}

static void test_figures(double at, int with_knots)
{
    const double length = ldexp(1, random_int(-3, 3));
    taut_surface *near = patch(0, length, with_knots), *far = patch(at, length, with_knots);
    double a = 0, b = 0;

    CHECK(taut_surface_dirichlet_energy(near, &a) == TAUT_OK, "at %g", at);
    CHECK(taut_surface_dirichlet_energy(far, &b) == TAUT_OK, "at %g", at);
    same(b, a, "Dirichlet energy", at, with_knots);
    CHECK(taut_surface_isothermality(near, &a) == TAUT_OK, "at %g", at);
    CHECK(taut_surface_isothermality(far, &b) == TAUT_OK, "at %g", at);
    same(b, a, "isothermality", at, with_knots);
    CHECK(taut_surface_area(near, &a, NULL) == TAUT_OK, "at %g", at);
    CHECK(taut_surface_area(far, &b, NULL) == TAUT_OK, "at %g", at);
    same(b, a, "area", at, with_knots);
    taut_surface_free(near);
    taut_surface_free(far);
}

/* Only where subtraction is exact. */
static void test_which(void)
{
    static const struct {
        double lo, hi;
        int moves;
    } cases[] = {{0, 1, 0},      {-1, 1, 0},  {0.5, 2, 0}, {1, 2, 1},
                 {-2, -1, 1},    {-3, -1, 0}, {-1, 0, 0},  {0x1p40, 0x1p40 + 3, 1},
                 {1e59, 2e59, 1}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        taut_basis *basis = shape_bezier(2, cases[i].lo, cases[i].hi), *moved = NULL;
        CHECK(taut_near_zero(basis, &moved), "case %zu", i);
        CHECK((moved != NULL) == cases[i].moves, "[%g, %g]", cases[i].lo, cases[i].hi);
        if (moved != NULL) {
            CHECK(taut_basis_lo(moved) == 0 && taut_basis_hi(moved) == cases[i].hi - cases[i].lo,
                  "[%g, %g]", cases[i].lo, cases[i].hi);
        }
        taut_basis_free(moved);
        taut_basis_free(basis);
    }
}

int main(void)
{
    random_seed(20261127);
    fill();
    for (int with_knots = 0; with_knots < 2; with_knots++) {
        test_figures(0x1p23, with_knots);
        test_figures(-0x1p30 - 8, with_knots);
        test_figures(1e7, with_knots);
    }
    test_which();
    return check_failures != 0;
}
