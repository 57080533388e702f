/* test_eight.c -- integrals of first derivatives by eight cells at a time, against those that take one
 * after another; and the same bits from every kernel and any number of threads. */
#include "bases.h"
#include "check.h"
#include "shapes.h"

#include "measure/integrate/integrals.h"
#include "taut/measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SPANS = 20, FOLDED_SPANS = 4, COUNT_MAX = 120 };

typedef struct random_axis {
    taut_basis *basis;
    double at[COUNT_MAX]; /* Greville abscissae */
} random_axis;

static random_axis random_spline(int spans)
{
    double knots[COUNT_MAX + 8];
    const int degree = random_int(1, 5);
    const taut_basis_spec spec = {.type = "bspline",
                                  .degree = degree,
                                  .knots = knots,
                                  .knot_count = random_knots(degree, spans, -1, knots)};
    random_axis axis = {.basis = shape_basis(&spec)};
    for (int i = 0; i < taut_basis_count(axis.basis); i++) {
        for (int k = 1; k <= degree; k++) {
            axis.at[i] += knots[i + k] / degree;
        }
    }
    return axis;
}

/* About over a rectangle, thin ones too, and smooth, so that eight cells side by side are enough;
 * `fold`: so rough that x_u x x_v vanishes here and there. */
static taut_surface *random_net(int fold, int collapsed)
{
    static double points[COUNT_MAX * COUNT_MAX][3];
    const int spans = fold ? FOLDED_SPANS : SPANS;
    const random_axis u = random_spline(spans), v = random_spline(spans);
    const int nu = taut_basis_count(u.basis), nv = taut_basis_count(v.basis);
    const double wide = random_log(0.1, 10), bend = random_in(0, 0.3), rough = fold ? 1 : 0;

    for (int i = 0; i < nu * nv; i++) {
        const double s = u.at[i / nv], t = v.at[i % nv];
        const double shrink = collapsed ? s - u.at[0] : 1;
        points[i][0] = shrink * wide * (s + 2 + bend * sin(t) + random_in(-rough, rough));
        points[i][1] = shrink * (t + bend * sin(2 * s) + random_in(-rough, rough));
        points[i][2] = shrink * bend * (cos(s + t) + random_in(-rough, rough));
    }
    return shape_surface(u.basis, v.basis, points[0], NULL);
}

static void check_alone(const taut_surface *s, int trial)
{
    taut_surface_integrals all;
    double area = 0, dirichlet = 0, isothermality = 0;

    CHECK(taut_surface_integrals_of(s, 1, NULL, &all) == TAUT_OK, "all");
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

/* The same net with weights of 1, which is integrated as rational ones are: cell by cell. */
static taut_surface *weighted(const taut_surface *s)
{
    static double ones[COUNT_MAX * COUNT_MAX];
    const taut_basis *u = taut_surface_u(s), *v = taut_surface_v(s);
    taut_surface *out = NULL;
    for (int k = 0; k < taut_basis_count(u) * taut_basis_count(v); k++) {
        ones[k] = 1;
    }
    CHECK(taut_surface_new("ones", u, v, taut_surface_points(s), ones, &out, NULL) == TAUT_OK,
          "weights of 1");
    return out;
}

static void test_cell_by_cell(void)
{
    for (int trial = 0; trial < random_trials(24); trial++) {
        taut_surface *s = random_net(trial % 4 == 3, trial % 4 == 2), *one = weighted(s);
        taut_surface_integrals eight, other;
        CHECK(taut_surface_integrals_of(s, 1, NULL, &eight) == TAUT_OK, "by eights");
        CHECK(taut_surface_integrals_of(one, 1, NULL, &other) == TAUT_OK, "cell by cell");
        const double known = eight.area_error + other.area_error;
        /* 1.6e-13 was seen */
        CHECK_NEAR(eight.area, other.area, 5e-13 * other.area + known, "area of trial %d", trial);
        CHECK_NEAR(eight.dirichlet, other.dirichlet, 1e-13 * other.dirichlet, "energy of trial %d",
                   trial);
        taut_surface_free(one);
        taut_surface_free(s);
    }
}

static void test_same_bits(void)
{
    static const char *const kernels[3] = {"baseline", "avx2", "avx512"};
    for (int trial = 0; trial < random_trials(8); trial++) {
        taut_surface *s = random_net(0, trial % 2);
        taut_surface_integrals first, again;
        CHECK(taut_surface_integrals_of(s, 1, NULL, &first) == TAUT_OK, "all");
        for (int k = 0; k < 3; k++) {
            setenv("TAUT_KERNEL", kernels[k], 1); /* one that is not there is passed over */
            CHECK(taut_surface_integrals_of(s, 1, &(taut_crew){k + 1, NULL}, &again) == TAUT_OK,
                  "%s", kernels[k]);
            CHECK(memcmp(&first, &again, sizeof first) == 0, "%s, trial %d", kernels[k], trial);
        }
        unsetenv("TAUT_KERNEL");
        taut_surface_free(s);
    }
}

int main(void)
{
    test_one_by_one();
    test_cell_by_cell();
    test_same_bits();
    return check_failures != 0;
}
