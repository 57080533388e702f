/* test_eight.c -- integrals of first derivatives by eight cells at a time, against those that take one
 * after another; and the same bits from every kernel and any number of threads. */
#include "bases.h"
#include "check.h"
#include "shapes.h"

#include "measure/integrate/integrals.h"
#include "taut/measure.h"
#include "taut/operations.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SPANS = 20, FOLDED_SPANS = 4, COUNT_MAX = 120 };

static taut_basis *random_spline(int spans)
{
    double knots[COUNT_MAX + 8];
    const int degree = random_int(1, 5);
    const taut_basis_spec spec = {.type = "bspline",
                                  .degree = degree,
                                  .knots = knots,
                                  .knot_count = random_knots(degree, spans, -1, knots)};
    return shape_basis(&spec);
}

/* About over a rectangle, thin ones too; `fold`: so rough that x_u x x_v vanishes here and there. */
static taut_surface *random_net(int fold, int collapsed)
{
    static double points[COUNT_MAX * COUNT_MAX][3];
    const int spans = fold ? FOLDED_SPANS : SPANS;
    taut_basis *u = random_spline(spans), *v = random_spline(spans);
    const int nu = taut_basis_count(u), nv = taut_basis_count(v);
    const double rough = fold ? 1 : 0.2, wide = random_log(0.1, 10);

    for (int i = 0; i < nu * nv; i++) {
        points[i][0] = (i / nv + random_in(-rough, rough)) / nu * wide;
        points[i][1] = collapsed && i / nv == 0 ? 0 : (i % nv + random_in(-rough, rough)) / nv;
        points[i][2] = collapsed && i / nv == 0 ? 0 : random_in(-rough, rough) / nv;
        points[i][0] = collapsed && i / nv == 0 ? 0 : points[i][0];
    }
    return shape_surface(u, v, points[0], NULL);
}

static void check_alone(const taut_surface *s, int trial)
{
    taut_surface_integrals all;
    double area = 0, dirichlet = 0, isothermality = 0;

    CHECK(taut_surface_integrals_of(s, 1, 1, &all) == TAUT_OK, "all");
    CHECK(taut_surface_area(s, &area, NULL) == TAUT_OK, "area");
    CHECK(taut_surface_dirichlet_energy(s, &dirichlet) == TAUT_OK, "energy");
    CHECK(taut_surface_isothermality(s, &isothermality) == TAUT_OK, "isothermality");
    CHECK_NEAR(all.area, area, 2e-11 * area + all.area_error, "area of trial %d", trial);
    CHECK_NEAR(all.dirichlet, dirichlet, 1e-14 * dirichlet, "energy of trial %d", trial);
    CHECK_NEAR(all.isothermality, isothermality, 1e-11, "isothermality of trial %d", trial);
}

static void test_one_by_one(void)
{
    for (int trial = 0; trial < random_trials(24); trial++) {
        taut_surface *s = random_net(trial % 4 == 3, trial % 4 == 2);
        check_alone(s, trial);
        taut_surface_free(s);
    }
}

/* Knots put in where the surface has its own, so that the columns of a cell do not follow those of the one before. */
static taut_surface *repeat_knots(const taut_surface *s, int direction)
{
    const taut_basis *basis = direction == 0 ? taut_surface_u(s) : taut_surface_v(s);
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis), degree = taut_basis_degree(basis);
    taut_surface *out = NULL;

    CHECK(taut_surface_insert(s, direction, breaks[spans] - (breaks[spans] - breaks[0]) / 128,
                              degree, &out, NULL) == TAUT_OK,
          "degree %d", degree);
    return out;
}

/* The same surface on more knots has the same integrals. */
static void test_repeated_knots(void)
{
    for (int trial = 0; trial < random_trials(12); trial++) {
        taut_surface *s = random_net(0, 0), *rows = repeat_knots(s, 0);
        taut_surface *both = repeat_knots(rows, 1);
        taut_surface_integrals one, other;
        CHECK(taut_surface_integrals_of(s, 1, 1, &one) == TAUT_OK, "of its own knots");
        CHECK(taut_surface_integrals_of(both, 1, 1, &other) == TAUT_OK, "of more knots");
        CHECK_NEAR(other.area, one.area, 1e-13 * one.area + one.area_error, "area of trial %d",
                   trial);
        CHECK_NEAR(other.dirichlet, one.dirichlet, 1e-13 * one.dirichlet, "energy of trial %d",
                   trial);
        taut_surface_free(both);
        taut_surface_free(rows);
        taut_surface_free(s);
    }
}

static void test_same_bits(void)
{
    static const char *const kernels[3] = {"baseline", "avx2", "avx512"};
    for (int trial = 0; trial < random_trials(8); trial++) {
        taut_surface *s = random_net(0, trial % 2);
        taut_surface_integrals first, again;
        CHECK(taut_surface_integrals_of(s, 1, 1, &first) == TAUT_OK, "all");
        for (int k = 0; k < 3; k++) {
            setenv("TAUT_KERNEL", kernels[k], 1); /* one that is not there is passed over */
            CHECK(taut_surface_integrals_of(s, 1, k + 1, &again) == TAUT_OK, "%s", kernels[k]);
            CHECK(memcmp(&first, &again, sizeof first) == 0, "%s, trial %d", kernels[k], trial);
        }
        unsetenv("TAUT_KERNEL");
        taut_surface_free(s);
    }
}

int main(void)
{
    test_one_by_one();
    test_repeated_knots();
    test_same_bits();
    return check_failures != 0;
}
