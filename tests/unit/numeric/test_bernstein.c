/* test_bernstein.c -- two ways to each number of the Bernstein algebra. */
#include "check.h"

#include "core/constants.h"
#include "numeric/bernstein.h"

#include <math.h>

enum { TRIALS = 200, DIM = 3 };

static void fill(int p, double (*a)[DIM])
{
    for (int i = 0; i <= p; i++) {
        for (int k = 0; k < DIM; k++) {
            a[i][k] = random_in(-1, 1);
        }
    }
}

/* By the functions' values, which share no code with de Casteljau's algorithm. */
static void sum_up(int p, const double (*a)[DIM], double t, double value[DIM], double slope[DIM])
{
    double b[2][TAUT_BERNSTEIN_MAX + 1];
    taut_bernstein_eval(p, 1, t, &b[0][0]);
    for (int k = 0; k < DIM; k++) {
        value[k] = slope[k] = 0;
        for (int i = 0; i <= p; i++) {
            value[k] += (&b[0][0])[i] * a[i][k];
            slope[k] += (&b[0][0])[p + 1 + i] * a[i][k];
        }
    }
}

static void test_point_and_derivative(void)
{
    double a[TAUT_BERNSTEIN_MAX + 1][DIM], d[TAUT_BERNSTEIN_MAX + 1][DIM];
    for (int trial = 0; trial < TRIALS; trial++) {
        const int p = (int)random_in(0, 21);
        const double t = random_in(0, 1), near = 8.0 * (p + 1) * TAUT_UNIT_ROUNDOFF;
        double value[DIM], slope[DIM], other[DIM], rate[DIM], by_net[DIM];
        fill(p, a);
        taut_bernstein_point(p, DIM, &a[0][0], t, value, slope);
        sum_up(p, (const double(*)[DIM])a, t, other, rate);
        taut_bernstein_derivative(p, DIM, &a[0][0], &d[0][0]);
        taut_bernstein_point(p > 0 ? p - 1 : 0, DIM, &d[0][0], t, by_net, NULL);
        for (int k = 0; k < DIM; k++) {
            CHECK_NEAR(value[k], other[k], near, "p=%d t=%a", p, t);
            CHECK_NEAR(slope[k], rate[k], 4 * p * near, "p=%d t=%a", p, t);
            CHECK_NEAR(slope[k], by_net[k], 4 * p * near, "p=%d t=%a", p, t);
        }
    }
}

/* The pieces and the raised polynomial are the same function. */
static void test_split_and_raise(void)
{
    double a[TAUT_BERNSTEIN_MAX + 1][DIM], low[TAUT_BERNSTEIN_MAX + 1][DIM],
        high[TAUT_BERNSTEIN_MAX + 1][DIM], raised[TAUT_BERNSTEIN_MAX + 1][DIM];
    for (int trial = 0; trial < TRIALS; trial++) {
        const int p = (int)random_in(0, 13), times = (int)random_in(0, 5);
        const double cut = random_in(0, 1), s = random_in(0, 1);
        const double near = 16.0 * (p + times + 1) * TAUT_UNIT_ROUNDOFF;
        double whole[DIM], piece[DIM];
        fill(p, a);
        taut_bernstein_split(p, DIM, &a[0][0], cut, &low[0][0], &high[0][0]);
        taut_bernstein_raise(p, DIM, &a[0][0], times, &raised[0][0]);
        for (int part = 0; part < 3; part++) {
            const double t = part == 0 ? cut * s : part == 1 ? cut + (1 - cut) * s : s;
            taut_bernstein_point(p, DIM, &a[0][0], t, whole, NULL);
            taut_bernstein_point(part < 2 ? p : p + times, DIM,
                                 part == 0   ? &low[0][0]
                                 : part == 1 ? &high[0][0]
                                             : &raised[0][0],
                                 s, piece, NULL);
            for (int k = 0; k < DIM; k++) {
                CHECK_NEAR(whole[k], piece[k], near, "p=%d part %d at %a", p, part, t);
            }
        }
        taut_bernstein_split(p, DIM, &a[0][0], cut, &a[0][0], NULL);
        taut_bernstein_split(p, DIM, &low[0][0], 1, &low[0][0], NULL);
        CHECK(a[p][0] == low[p][0], "in place, p=%d", p);
    }
}

static void test_products(void)
{
    double a[TAUT_BERNSTEIN_MAX + 1][DIM], b[TAUT_BERNSTEIN_MAX + 1][DIM],
        s[TAUT_BERNSTEIN_MAX + 1][DIM], scaled[TAUT_BERNSTEIN_MAX + 1][DIM],
        cross[TAUT_BERNSTEIN_MAX + 1][DIM], one[TAUT_BERNSTEIN_MAX + 1];
    for (int trial = 0; trial < TRIALS; trial++) {
        const int p = (int)random_in(0, 9), q = (int)random_in(0, 9);
        const double t = random_in(0, 1), near = 4.0 * (p + q + 1) * TAUT_UNIT_ROUNDOFF;
        double x[DIM], y[DIM], factor = 0, found[DIM];
        fill(p, s);
        fill(p, a);
        fill(q, b);
        for (int i = 0; i <= p; i++) {
            one[i] = s[i][0];
        }
        taut_bernstein_scale(p, one, q, DIM, &b[0][0], &scaled[0][0]);
        taut_bernstein_cross(p, &a[0][0], q, &b[0][0], &cross[0][0]);
        taut_bernstein_point(p, 1, one, t, &factor, NULL);
        taut_bernstein_point(p, DIM, &a[0][0], t, x, NULL);
        taut_bernstein_point(q, DIM, &b[0][0], t, y, NULL);
        taut_bernstein_point(p + q, DIM, &scaled[0][0], t, found, NULL);
        for (int k = 0; k < DIM; k++) {
            CHECK_NEAR(found[k], factor * y[k], near, "p=%d q=%d", p, q);
        }
        taut_bernstein_point(p + q, DIM, &cross[0][0], t, found, NULL);
        for (int k = 0; k < DIM; k++) {
            const int l = (k + 1) % 3, m = (k + 2) % 3;
            CHECK_NEAR(found[k], x[l] * y[m] - x[m] * y[l], near, "p=%d q=%d", p, q);
        }
    }
}

/* (t - root) a, divided by t - root again, for roots all over [0, 1] and its ends. */
static void test_deflate(void)
{
    double a[TAUT_BERNSTEIN_MAX + 1][DIM], product[TAUT_BERNSTEIN_MAX + 1][DIM],
        found[TAUT_BERNSTEIN_MAX + 1][DIM];
    for (int trial = 0; trial < 500; trial++) {
        const int q = (int)random_in(0, 9);
        const double root = trial % 10 == 0 ? trial % 20 / 10.0 : random_in(0, 1);
        const double linear[2] = {-root, 1 - root};
        fill(q, a);
        taut_bernstein_scale(1, linear, q, DIM, &a[0][0], &product[0][0]);
        taut_bernstein_deflate(q + 1, DIM, &product[0][0], root, &found[0][0]);
        for (int i = 0; i < (q + 1) * DIM; i++) {
            CHECK_NEAR(found[i / DIM][i % DIM], a[i / DIM][i % DIM], 1e-12, "q=%d i=%d root=%a", q,
                       i / DIM, root);
        }
    }
    CHECK(taut_binomial(10, 3) == 120 && taut_binomial(52, 26) == 495918532948104.0, "C(n, k)");
}

int main(void)
{
    test_point_and_derivative();
    test_split_and_raise();
    test_products();
    test_deflate();
    return check_failures != 0;
}
