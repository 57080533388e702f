/* test_near_zero.c -- figures do not depend on where a range begins: surfaces over ranges far from
 * 0, where a parameter has few digits, against the same over ranges that begin at 0. */
#include "check.h"
#include "shapes.h"

#include "measure/integrate/near_zero.h"
#include "taut/measure.h"

#include <stddef.h>

enum { DEGREE = 7 };

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

/* Degree p by 3 over [0, 1], one inner knot at `knot` in u, or the same seen from the other end,
 * all that is subtracted exact: (p + 2) x 4 points, moved a little off a plane grid. Most of the
 * energy is in the short span. */
static taut_surface *graded(int p, double knot, const double *shift, const double *weights,
                            int mirrored)
{
    double knots[2 * DEGREE + 3], turned[3 * 4 * (DEGREE + 2)], factors[4 * (DEGREE + 2)];
    const taut_basis_spec spec = {
        .type = "bspline", .degree = p, .knots = knots, .knot_count = 2 * p + 3};

    for (int i = 0; i < 2 * p + 3; i++) {
        knots[i] = i <= p ? 0 : i > p + 1 ? 1 : mirrored ? 1 - knot : knot;
    }
    for (int k = 0; k < 4 * (p + 2); k++) {
        const int at = 4 * (mirrored ? p + 1 - k / 4 : k / 4) + k % 4;
        turned[3 * at] = k / 4 + shift[3 * k];
        turned[3 * at + 1] = k % 4 + shift[3 * k + 1];
        turned[3 * at + 2] = shift[3 * k + 2];
        factors[at] = weights != NULL ? weights[k] : 1;
    }
    return shape_surface(shape_basis(&spec), shape_bezier(3, 0, 1), turned,
                         weights != NULL ? factors : NULL);
}

/* A span 1e-6 wide beside 1, where parameters are rounded to 1e-10 of it, against the same span
 * beside 0. */
static void test_graded(int p, int rational)
{
    double shift[3 * 4 * (DEGREE + 2)], weights[4 * (DEGREE + 2)];
    const double knot = 0x1p-52 * floor(random_in(0x1p31, 0x1.8p32));
    taut_surface *near = NULL, *far = NULL;
    double a = 0, b = 0;

    for (int k = 0; k < 3 * 4 * (DEGREE + 2); k++) {
        shift[k] = random_in(-0.1, 0.1);
        weights[k / 3] = random_in(0.8, 1.25);
    }
    near = graded(p, knot, shift, rational ? weights : NULL, 0);
    far = graded(p, knot, shift, rational ? weights : NULL, 1);
    CHECK(taut_surface_dirichlet_energy(near, &a) == TAUT_OK, "p=%d knot %g", p, knot);
    CHECK(taut_surface_dirichlet_energy(far, &b) == TAUT_OK, "p=%d knot %g", p, knot);
    same(b, a, "Dirichlet energy", 1 - knot, rational);
    CHECK(taut_surface_bending_energy(near, &a) == TAUT_OK, "p=%d knot %g", p, knot);
    CHECK(taut_surface_bending_energy(far, &b) == TAUT_OK, "p=%d knot %g", p, knot);
    same(b, a, "bending energy", 1 - knot, rational);
    CHECK(taut_surface_area(near, &a, NULL) == TAUT_OK, "p=%d knot %g", p, knot);
    CHECK(taut_surface_area(far, &b, NULL) == TAUT_OK, "p=%d knot %g", p, knot);
    same(b, a, "area", 1 - knot, rational);
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
    for (int p = 2; p <= DEGREE; p++) {
        test_graded(p, 0);
        test_graded(p, p % 2);
    }
    test_which();
    return check_failures != 0;
}
