/* test_loop.c -- splines that go around: their clamped nets are the same functions, and meet at the seam with
 * all derivatives below the degree. */
#include "check.h"
#include "geometry/nurbs/loop.h"
#include "taut/curve.h"

#include <string.h>

enum { MOST = 40 };

/* Random knots over [2, 5], inner ones now and then repeated, less often than the degree. */
static taut_basis *random_basis(int *degree, int *count)
{
    double knots[2 * MOST];
    taut_basis *basis = NULL;
    const int p = *degree = random_int(2, 6), n = *count = random_int(2 * p + 1, 2 * p + 12);

    for (int k = 0; k <= p; k++) {
        knots[k] = 2;
        knots[n + k] = 5;
    }
    for (int k = p + 1, repeated = 1; k < n; k++) {
        const int again = k > p + 1 && repeated < p - 1 && random_int(0, 4) == 0;
        repeated = again ? repeated + 1 : 1;
        knots[k] = again ? knots[k - 1]
                         : knots[k - 1] + (5 - knots[k - 1]) * random_in(0.3, 1.2) / (n - k + 1);
    }
    const taut_basis_spec spec = {
        .type = "bspline", .degree = p, .knot_count = n + p + 1, .knots = knots};
    CHECK(taut_basis_new(&spec, n, &basis, NULL) == TAUT_OK, "degree %d, %d points", p, n);
    return basis;
}

static void random_points(const taut_loop *loop, double points[MOST][3])
{
    for (int j = 0; j < loop->count; j++) {
        for (int c = 0; c < 3; c++) {
            points[j][c] = j < loop->period ? random_in(-1, 1) : points[j - loop->period][c];
        }
    }
}

static void test_values(const taut_basis *basis, const taut_loop *loop, double points[MOST][3],
                        const taut_curve *curve)
{
    for (int k = 0; k < 20; k++) {
        const double t = k == 0 ? 2 : k == 1 ? 5 : random_in(2, 5);
        const int span = taut_basis_span(basis, t), first = taut_basis_first(basis, span);
        double values[TAUT_DEGREE_MAX + 1], x[3], y[3] = {0, 0, 0}, sum = 0;
        CHECK(taut_basis_eval(basis, span, t, 0, values) == TAUT_OK, "t %g", t);
        taut_loop_open(loop, first, values);
        for (int a = 0; a <= loop->degree; a++) {
            sum += values[a];
            CHECK(values[a] >= 0, "t %g: function %d is %g", t, first + a, values[a]);
            for (int c = 0; c < 3; c++) {
                y[c] += values[a] * points[first + a][c];
            }
        }
        CHECK_NEAR(sum, 1, 1e-14, "t %g", t);
        (void)taut_curve_eval(curve, t, 0, x);
        for (int c = 0; c < 3; c++) {
            CHECK_NEAR(x[c], y[c], 1e-14, "t %g", t);
        }
    }
}

/* Derivatives from both sides; those of order k grow by (degree / span)^k, and their rounding too. */
static void test_seam(const taut_basis *basis, const taut_curve *curve)
{
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis), p = taut_basis_degree(basis);
    const double least = fmin(breaks[1] - breaks[0], breaks[spans] - breaks[spans - 1]);
    double at[2][4][3], scale = 1;

    for (int end = 0; end < 2; end++) {
        CHECK(taut_curve_eval(curve, end == 0 ? 2 : 5, 3, at[end][0]) == TAUT_OK, "end %d", end);
    }
    for (int k = 0; k < p && k <= 3; k++) {
        for (int c = 0; c < 3; c++) {
            CHECK_NEAR(at[0][k][c], at[1][k][c], 1e-14 * scale, "degree %d, order %d", p, k);
        }
        scale *= 2 * p / least;
    }
    CHECK(memcmp(taut_curve_points(curve),
                 taut_curve_points(curve) + 3 * (taut_basis_count(basis) - 1),
                 3 * sizeof(double)) == 0,
          "the seam is one point, to the bit");
}

/* Back to the c, which are clamped to the same first points again (uneven knots cost the c digits, and so the copies at
 * the other end); and a sum over them as one over the clamped net. */
static void test_inverse(const taut_loop *loop, const double points[MOST][3],
                         const double clamped[MOST][3])
{
    double back[MOST][3], slopes[MOST][3] = {{0}}, sums[2] = {0, 0}, size = 0;
    memcpy(back, clamped, sizeof back);
    taut_loop_unclamp(loop, 1, back[0]);
    taut_loop_clamp(loop, 1, back[0]);
    for (int i = 0; i < loop->count; i++) {
        for (int c = 0; c < 3; c++) { /* 2e-16 was seen */
            if (i < loop->period) {
                CHECK_NEAR(back[i][c], clamped[i][c], 1e-15, "point %d", i);
            }
            slopes[i][c] = i < loop->period ? random_in(-1, 1) : 0;
            sums[0] += slopes[i][c] * points[i][c];
        }
    }
    taut_loop_unclamp_slopes(loop, 1, slopes[0]);
    for (int i = 0; i < loop->count; i++) {
        for (int c = 0; c < 3; c++) {
            sums[1] += slopes[i][c] * clamped[i][c];
            size += fabs(slopes[i][c] * clamped[i][c]);
        }
    }
    CHECK_NEAR(sums[1], sums[0], 1e-14 * (1 + size), "a sum over the net");
}

static void test_random(void)
{
    for (int trial = 0; trial < 200; trial++) {
        int degree = 0, count = 0;
        double points[MOST][3], clamped[MOST][3];
        taut_loop loop;
        taut_curve *curve = NULL;
        taut_arena *arena = taut_arena_new();
        taut_basis *basis = random_basis(&degree, &count);
        CHECK(taut_loop_new(basis, arena, &loop) == TAUT_OK && loop.period == count - degree,
              "degree %d, %d points", degree, count);
        random_points(&loop, points);
        memcpy(clamped, points, sizeof clamped);
        taut_loop_clamp(&loop, 1, clamped[0]);
        test_inverse(&loop, (const double(*)[3])points, (const double(*)[3])clamped);
        CHECK(taut_curve_new(NULL, basis, clamped[0], NULL, &curve, NULL) == TAUT_OK, "curve");
        test_values(basis, &loop, points, curve);
        test_seam(basis, curve);
        taut_curve_free(curve);
        taut_basis_free(basis);
        taut_arena_free(arena);
    }
}

/* t itself goes around but for the jump at the seam: functions whose abscissae are not carried across it have
 * it as coefficients. */
static void test_greville(void)
{
    const taut_basis_spec spec = {.type = "bspline", .degree = 3, .count = 11};
    taut_basis *basis = NULL;
    CHECK(taut_basis_new(&spec, 11, &basis, NULL) == TAUT_OK, "basis");
    for (int j = 0; j < 8; j++) {
        const double expected = (j - 1) / 8.0;
        CHECK_NEAR(taut_loop_greville(basis, j), expected < 0 ? expected + 1 : expected, 1e-15,
                   "function %d", j);
    }
    taut_basis_free(basis);
}

int main(void)
{
    random_seed(20);
    test_random();
    test_greville();
    return check_failures != 0;
}
