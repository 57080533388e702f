/* test_curve.c -- curves against the circle, and their refusals. */
#include "check.h"

#include "taut/curve.h"

#include <string.h>

static taut_basis *basis_of(taut_basis_spec spec)
{
    taut_basis *basis = NULL;
    CHECK(taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK, "basis");
    return basis;
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* x.x = 1 on a rational quarter circle, so by differentiating
 *     x.x' = 0,   x.x'' = -x'.x',   x.x''' = -3 x'.x''. */
static void test_circle(void)
{
    const double points[3][3] = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const double weights[3] = {1, sqrt(0.5), 1};
    taut_basis *basis = basis_of((taut_basis_spec){.type = "bezier", .degree = 2});
    taut_curve *curve = NULL;
    CHECK(taut_curve_new("circle", basis, &points[0][0], weights, &curve, NULL) == TAUT_OK, "new");
    for (int trial = 0; trial < 300; trial++) {
        const double t = trial < 2 ? trial : random_in(0, 1);
        double x[4][3];
        CHECK(taut_curve_eval(curve, t, 3, &x[0][0]) == TAUT_OK, "t=%a", t);
        CHECK_NEAR(dot(x[0], x[0]), 1, 2e-15, "t=%a", t);
        CHECK_NEAR(dot(x[0], x[1]), 0, 1e-14, "t=%a", t);
        CHECK_NEAR(dot(x[0], x[2]), -dot(x[1], x[1]), 1e-13, "t=%a", t);
        CHECK_NEAR(dot(x[0], x[3]), -3 * dot(x[1], x[2]), 1e-12, "t=%a", t);
    }
    taut_curve_free(curve);
    taut_basis_free(basis);
}

/* The product rule on A = w x, with A and w from curves without weights:
 *     A^(k) = sum_i C(k,i) w^(i) x^(k-i)
 * (On the circle above a tangential error would not show.) */
static void test_product_rule(void)
{
    enum { COUNT = 7 };
    static const double binomial[4][4] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
    taut_basis *basis = basis_of((taut_basis_spec){.type = "bspline", .degree = 4, .count = COUNT});
    for (int trial = 0; trial < 300; trial++) {
        double points[3][COUNT][3], weights[COUNT];
        double values[3][4][3]; /* of x, A, w */
        const double t = random_in(0, 1);
        for (int i = 0; i < COUNT; i++) {
            weights[i] = random_log(0.25, 4);
            for (int c = 0; c < 3; c++) {
                points[0][i][c] = random_in(-1, 1);
                points[1][i][c] = weights[i] * points[0][i][c];
                points[2][i][c] = weights[i];
            }
        }
        for (int k = 0; k < 3; k++) {
            taut_curve *curve = NULL;
            CHECK(taut_curve_new("", basis, &points[k][0][0], k == 0 ? weights : NULL, &curve,
                                 NULL) == TAUT_OK,
                  "k=%d", k);
            CHECK(taut_curve_eval(curve, t, 3, &values[k][0][0]) == TAUT_OK, "k=%d", k);
            taut_curve_free(curve);
        }
        for (int k = 0; k <= 3; k++) {
            for (int c = 0; c < 3; c++) {
                double sum = 0, size = 1;
                for (int i = 0; i <= k; i++) {
                    const double term = binomial[k][i] * values[2][i][c] * values[0][k - i][c];
                    sum += term;
                    size += fabs(term);
                }
                /* derivative k of the basis is a sum of terms up to 2^k times its own size */
                CHECK_NEAR(values[1][k][c], sum, (40 << k) * 0x1p-53 * size, "k=%d t=%a", k, t);
            }
        }
    }
    taut_basis_free(basis);
}

/* Points on a line at the Greville abscissae reproduce the parameter itself. */
static void test_linear_precision(void)
{
    static const double knots[] = {0, 0, 0, 0, 0.5, 1, 1, 3, 3, 3, 3};
    taut_basis *basis = basis_of(
        (taut_basis_spec){.type = "bspline", .degree = 3, .knots = knots, .knot_count = 11});
    double points[7][3];
    taut_curve *curve = NULL;
    for (int i = 0; i < 7; i++) {
        const double greville = (knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3;
        points[i][0] = greville;
        points[i][1] = 2 - greville;
        points[i][2] = 5;
    }
    CHECK(taut_curve_new(NULL, basis, &points[0][0], NULL, &curve, NULL) == TAUT_OK, "new");
    for (int trial = 0; trial < 300; trial++) {
        const double t = trial < 2 ? 3.0 * trial : random_in(0, 3);
        double x[4][3];
        CHECK(taut_curve_eval(curve, t, 3, &x[0][0]) == TAUT_OK, "t=%a", t);
        CHECK_NEAR(x[0][0], t, 4e-15, "t=%a", t);
        CHECK_NEAR(x[0][1], 2 - t, 4e-15, "t=%a", t);
        CHECK_NEAR(x[1][0], 1, 2e-14, "t=%a", t);
        CHECK_NEAR(x[2][0], 0, 2e-13, "t=%a", t);
        CHECK_NEAR(x[3][0], 0, 2e-12, "t=%a", t);
    }
    taut_curve_free(curve);
    taut_basis_free(basis);
}

/* At a knot of multiplicity 3 a cubic has a corner: the derivative is the one from the right. */
static void test_side_of_knot(void)
{
    static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2};
    taut_basis *basis = basis_of(
        (taut_basis_spec){.type = "bspline", .degree = 3, .knots = knots, .knot_count = 11});
    const double points[7][3] = {{0}, {1}, {2}, {3}, {3, 1}, {3, 2}, {3, 3}};
    taut_curve *curve = NULL;
    double x[2][3];
    CHECK(taut_curve_new("corner", basis, &points[0][0], NULL, &curve, NULL) == TAUT_OK, "new");
    CHECK(taut_curve_eval(curve, 1, 1, &x[0][0]) == TAUT_OK, "at the knot");
    CHECK_NEAR(x[1][0], 0, 1e-14, "from the right");
    CHECK_NEAR(x[1][1], 3, 1e-14, "from the right");
    CHECK(taut_curve_eval(curve, nextafter(1, 0), 1, &x[0][0]) == TAUT_OK, "before the knot");
    CHECK_NEAR(x[1][0], 3, 1e-14, "from the left");
    taut_curve_free(curve);
    taut_basis_free(basis);
}

static void refuse(const taut_basis *basis, const char *name, const double *points,
                   const double *weights, taut_status expected, const char *where)
{
    taut_curve *curve = NULL;
    taut_error error = {.where = ""};
    CHECK(taut_curve_new(name, basis, points, weights, &curve, &error) == expected, "%s", where);
    CHECK(curve == NULL, "%s: the output is untouched", where);
    CHECK(strcmp(error.where, where) == 0, "where is %s, expected %s", error.where, where);
}

static void test_refusals(void)
{
    taut_basis *basis = basis_of((taut_basis_spec){.type = "bezier", .degree = 1});
    const double good[6] = {0, 0, 0, 1, 1, 1};
    const double not_a_number[6] = {0, 0, 0, 1, nan(""), 1};
    const double infinite[6] = {HUGE_VAL, 0, 0, 1, 1, 1};
    const double zero[2] = {1, 0}, negative[2] = {-1, 1}, unbounded[2] = {1, HUGE_VAL};
    char name[TAUT_NAME_MAX + 2];
    taut_curve *curve = NULL;
    double x[3] = {7};

    memset(name, 'n', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    refuse(basis, "a", not_a_number, NULL, TAUT_BAD_INPUT, "/points/1");
    refuse(basis, "a", infinite, NULL, TAUT_BAD_INPUT, "/points/0");
    refuse(basis, "a", good, zero, TAUT_BAD_INPUT, "/weights/1");
    refuse(basis, "a", good, negative, TAUT_BAD_INPUT, "/weights/0");
    refuse(basis, "a", good, unbounded, TAUT_BAD_INPUT, "/weights/1");
    refuse(basis, name, good, NULL, TAUT_BAD_INPUT, "/name");
    refuse(NULL, "a", good, NULL, TAUT_BAD_ARGUMENT, "");
    refuse(basis, "a", NULL, NULL, TAUT_BAD_ARGUMENT, "");

    CHECK(taut_curve_new(name + 1, basis, good, NULL, &curve, NULL) == TAUT_OK, "longest name");
    CHECK(taut_curve_eval(curve, nextafter(1, 2), 0, x) == TAUT_BAD_ARGUMENT, "t too large");
    CHECK(taut_curve_eval(curve, nan(""), 0, x) == TAUT_BAD_ARGUMENT, "t is NaN");
    CHECK(taut_curve_eval(curve, 0, TAUT_ORDER_MAX + 1, x) == TAUT_BAD_ARGUMENT, "order");
    CHECK(taut_curve_eval(curve, 0, -1, x) == TAUT_BAD_ARGUMENT, "order");
    CHECK(x[0] == 7, "nothing is written on failure");
    taut_curve_free(curve);
    taut_basis_free(basis);
}

/* Places in no order: those of single calls bit for bit, for any number of threads; one out of range
 * anywhere, and nothing is written. */
static void test_points(void)
{
    enum { COUNT = 19 };
    const double points[3][3] = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, weights[3] = {1, 0.7, 1};
    taut_basis *basis = basis_of((taut_basis_spec){.type = "bezier", .degree = 2});
    taut_curve *curve = NULL;
    double t[COUNT], all[COUNT * 12], alone[12];
    CHECK(taut_curve_new("", basis, &points[0][0], weights, &curve, NULL) == TAUT_OK, "new");
    for (int i = 0; i < COUNT; i++) {
        t[i] = i < 2 ? i : random_in(0, 1);
    }
    for (int order = 0; order <= 3; order++) {
        const size_t numbers = 3 * (size_t)(order + 1);
        for (int threads = 0; threads <= 3; threads++) {
            memset(all, 0xff, sizeof all);
            CHECK(taut_curve_eval_points(curve, COUNT, t, order, threads, all) == TAUT_OK, "all");
            for (size_t i = 0; i < COUNT; i++) {
                CHECK(taut_curve_eval(curve, t[i], order, alone) == TAUT_OK, "alone");
                CHECK(memcmp(alone, all + i * numbers, numbers * sizeof(double)) == 0,
                      "order %d, %d threads, place %zu", order, threads, i);
            }
        }
    }
    all[0] = 7;
    CHECK(taut_curve_eval_points(curve, COUNT, t, 4, 1, all) == TAUT_BAD_ARGUMENT, "order");
    CHECK(taut_curve_eval_points(curve, -1, t, 0, 1, all) == TAUT_BAD_ARGUMENT, "count");
    CHECK(taut_curve_eval_points(curve, COUNT, t, 0, TAUT_THREADS_MAX + 1, all) ==
              TAUT_BAD_ARGUMENT,
          "threads");
    t[COUNT - 1] = NAN;
    CHECK(taut_curve_eval_points(curve, COUNT, t, 0, 1, all) == TAUT_BAD_ARGUMENT, "NaN");
    CHECK(all[0] == 7, "nothing is written");
    taut_curve_free(curve);
    taut_basis_free(basis);
}

int main(void)
{
    random_seed(20260104);
    test_circle();
    test_product_rule();
    test_linear_precision();
    test_side_of_knot();
    test_refusals();
    test_points();
    return check_failures != 0;
}
