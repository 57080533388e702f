/* test_gram.c -- Gram matrices against closed forms, sums that are known, and one another. */
#include "check.h"
#include "problems.h"

#include "core/constants.h"
#include "geometry/nurbs/cells.h"
#include "geometry/nurbs/gram.h"

#include <string.h>

static double binomial(int n, int k)
{
    double value = 1;
    for (int i = 1; i <= k; i++) {
        value *= (double)(n - k + i) / i;
    }
    return value;
}

static taut_basis *bezier(int degree, double lo, double hi)
{
    const taut_basis_spec spec = {
        .type = "bezier", .degree = degree, .has_range = 1, .range = {lo, hi}};
    taut_basis *basis = NULL;
    CHECK(taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK, "degree=%d", degree);
    return basis;
}

/* int B[p,i] B[p,s] = C(p,i) C(p,s) / (C(2p,i+s) (2p+1)), and B' = p (B[p-1,i-1]
 * - B[p-1,i]) gives the slopes; independent of the range after scaling. */
static double mass_of(int p, int i, int s)
{
    return i < 0 || s < 0 || i > p || s > p
               ? 0
               : binomial(p, i) * binomial(p, s) / (binomial(2 * p, i + s) * (2 * p + 1));
}

static void test_bernstein(void)
{
    for (int p = 1; p <= 20; p++) {
        taut_basis *basis = bezier(p, -1.5, 4);
        taut_gram gram;
        CHECK(taut_gram_new(basis, NULL, &gram, NULL) == TAUT_OK, "p=%d", p);
        CHECK_NEAR(gram.length, 5.5, 0, "p=%d", p);
        for (int i = 0; i <= p; i++) {
            for (int s = 0; s <= i; s++) {
                const int q = p - 1;
                const double stiff = p * p *
                                     (mass_of(q, i - 1, s - 1) - mass_of(q, i - 1, s) -
                                      mass_of(q, i, s - 1) + mass_of(q, i, s));
                CHECK_NEAR(taut_band_at(&gram.mass, i, s), mass_of(p, i, s),
                           32 * p * TAUT_UNIT_ROUNDOFF * mass_of(p, i, i), "p=%d i=%d s=%d", p, i,
                           s);
                CHECK_NEAR(taut_band_at(&gram.stiffness, i, s), stiff,
                           64 * p * p * TAUT_UNIT_ROUNDOFF * p, "p=%d i=%d s=%d", p, i, s);
            }
        }
        taut_gram_clear(&gram);
        taut_basis_free(basis);
    }
}

/* The functions sum to 1: all entries of mass add up to 1, each row of stiffness to 0 relative to
 * its absolute values ([WuWang2011] section 6). With weights the same holds. */
static void check_sums(const taut_gram *gram, double tolerance)
{
    double all = 0;
    for (int i = 0; i < gram->mass.n; i++) {
        double row = 0, size = 0;
        for (int s = 0; s < gram->mass.n; s++) {
            all += taut_band_at(&gram->mass, i, s);
            row += taut_band_at(&gram->stiffness, i, s);
            size += fabs(taut_band_at(&gram->stiffness, i, s));
        }
        CHECK_NEAR(row, 0, tolerance * size, "row %d of %d", i, gram->mass.n);
    }
    CHECK_NEAR(all, 1, tolerance, "n=%d", gram->mass.n);
}

static void test_sums(void)
{
    for (int trial = 0; trial < 200; trial++) {
        taut_basis *basis = basis_random(8, 30);
        const int count = taut_basis_count(basis);
        double weights[64];
        taut_gram gram;
        CHECK(taut_gram_new(basis, NULL, &gram, NULL) == TAUT_OK, "trial=%d", trial);
        check_sums(&gram, 64 * TAUT_UNIT_ROUNDOFF);
        taut_gram_clear(&gram);
        for (int i = 0; i < count; i++) {
            weights[i] = random_log(0.1, 10);
        }
        CHECK(taut_gram_new(basis, weights, &gram, NULL) == TAUT_OK, "trial=%d", trial);
        check_sums(&gram, 256 * TAUT_UNIT_ROUNDOFF * gram.roundings);
        taut_gram_clear(&gram);
        taut_basis_free(basis);
    }
}

/* Weights that are all the same change nothing but the rule. */
static void test_equal_weights(void)
{
    for (int trial = 0; trial < 50; trial++) {
        taut_basis *basis = basis_random(6, 12);
        const int count = taut_basis_count(basis);
        double weights[64];
        taut_gram plain, weighted;
        for (int i = 0; i < count; i++) {
            weights[i] = 0.7;
        }
        CHECK(taut_gram_new(basis, NULL, &plain, NULL) == TAUT_OK, "trial=%d", trial);
        CHECK(taut_gram_new(basis, weights, &weighted, NULL) == TAUT_OK, "trial=%d", trial);
        for (int i = 0; i < count; i++) {
            for (int s = 0; s < count; s++) {
                const double size = sqrt(taut_band_at(&plain.stiffness, i, i) *
                                         taut_band_at(&plain.stiffness, s, s));
                CHECK_NEAR(taut_band_at(&weighted.stiffness, i, s),
                           taut_band_at(&plain.stiffness, i, s),
                           64 * TAUT_UNIT_ROUNDOFF * plain.roundings * size, "i=%d s=%d", i, s);
            }
        }
        taut_gram_clear(&plain);
        taut_gram_clear(&weighted);
        taut_basis_free(basis);
    }
}

/* Linear functions with weights a and b: R_1 = b t / w, w = a (1-t) + b t, so
 *     int R_1'^2 = int a^2 b^2 / w^4 = a^2 b^2 (1/a^3 - 1/b^3) / (3 (b-a)) = (a^2 + a b + b^2)/(3 a
 * b) also where w varies by a factor of a million. */
static void test_rational_linear(void)
{
    taut_basis *basis = bezier(1, 0, 1);
    for (double ratio = 1.5; ratio < 2e6; ratio *= 3) {
        const double weights[2] = {1, ratio};
        const double exact = (1 + ratio + ratio * ratio) / (3 * ratio);
        taut_gram gram;
        CHECK(taut_gram_new(basis, weights, &gram, NULL) == TAUT_OK, "ratio=%g", ratio);
        CHECK_NEAR(taut_band_at(&gram.stiffness, 1, 1), exact, 256 * TAUT_UNIT_ROUNDOFF * exact,
                   "ratio=%g", ratio);
        CHECK_NEAR(taut_band_at(&gram.stiffness, 1, 0), -exact, 256 * TAUT_UNIT_ROUNDOFF * exact,
                   "ratio=%g", ratio);
        taut_gram_clear(&gram);
    }
    taut_basis_free(basis);
}

/* A bump of the weight beside the end of one span, low at both ends and in the middle: its poles
 * are 1/300 of the span away. Raised without being cut, 256 nodes do not settle it. */
static void test_hidden_bump(void)
{
    const double weights[8] = {0.273286, 0.1, 0.95583, 0.1, 0.1, 0.809596, 8.55489, 0.248999};
    taut_basis *basis = bezier(7, 0, 1);
    taut_cells *cells = NULL;
    taut_gram gram;
    CHECK(taut_cells_new(basis, 1, weights, 1, 0, &cells) == TAUT_OK, "cells");
    CHECK(cells->count > 2 && cells->hi[cells->count - 1] == 1, "%d cells", cells->count);
    CHECK(taut_gram_new(basis, weights, &gram, NULL) == TAUT_OK, "gram");
    check_sums(&gram, 64 * TAUT_UNIT_ROUNDOFF * gram.roundings);
    taut_gram_clear(&gram);
    taut_cells_free(cells);
    taut_basis_free(basis);
}

/* Cells tile the range in order, each inside its span. */
static void test_panels(void)
{
    int cut = 0;
    for (int trial = 0; trial < 100; trial++) {
        taut_basis *basis = basis_random(5, 12);
        double weights[64], end = taut_basis_lo(basis);
        taut_cells *cells = NULL;
        for (int i = 0; i < taut_basis_count(basis); i++) {
            weights[i] = random_log(1e-3, 1e3);
        }
        CHECK(taut_cells_new(basis, 1, weights, 1, 0, &cells) == TAUT_OK, "trial=%d", trial);
        for (int k = 0; k < cells->count; k++) {
            const double *span = taut_basis_breaks(basis) + cells->span[k];
            CHECK(cells->lo[k] == end && cells->hi[k] > end, "trial=%d k=%d", trial, k);
            CHECK(cells->lo[k] >= span[0] && cells->hi[k] <= span[1], "trial=%d k=%d", trial, k);
            end = cells->hi[k];
        }
        CHECK(end == taut_basis_hi(basis), "trial=%d", trial);
        cut += cells->count > taut_basis_span_count(basis);
        taut_cells_free(cells);
        taut_basis_free(basis);
    }
    CHECK(cut > 80, "only %d of 100 were cut", cut); /* a few have weights that hardly differ */
}

static void test_select(void)
{
    taut_basis *basis = basis_uniform(3, 9);
    const int index[4] = {0, 2, 3, 8};
    taut_gram gram, part;
    CHECK(taut_gram_new(basis, NULL, &gram, NULL) == TAUT_OK, "gram");
    CHECK(taut_gram_select(&gram, 4, index, &part) == TAUT_OK, "select");
    for (int a = 0; a < 4; a++) {
        for (int b = 0; b < 4; b++) {
            CHECK(taut_band_at(&part.mass, a, b) == taut_band_at(&gram.mass, index[a], index[b]),
                  "a=%d b=%d", a, b);
        }
    }
    taut_gram_clear(&gram);
    taut_gram_clear(&part);
    taut_basis_free(basis);
}

/* Cubic, N uniform spans, far from the ends: the diagonals are 151/315 / N and 2/3 N, and the
 * matrices mirror, however many spans there are and wherever they lie: parameters far from 0 are
 * rounded to N u of a span, lengths are not. */
static void test_many_uniform_spans(void)
{
    enum { SPANS = 1000, COUNT = SPANS + 3 };
    for (int shift = 0; shift <= 1; shift++) {
        double knots[COUNT + 4];
        for (int i = 0; i < COUNT + 4; i++) {
            const int inner = i < 3 ? 0 : i > COUNT ? SPANS : i - 3;
            knots[i] = shift == 0 ? inner / (double)SPANS : 4096.0 + inner;
        }
        const taut_basis_spec spec = {
            .type = "bspline", .degree = 3, .knots = knots, .knot_count = COUNT + 4};
        taut_basis *basis = NULL;
        taut_gram gram;
        CHECK(taut_basis_new(&spec, COUNT, &basis, NULL) == TAUT_OK, "shift=%d", shift);
        CHECK(taut_gram_new(basis, NULL, &gram, NULL) == TAUT_OK, "shift=%d", shift);
        for (int i = 0; i < COUNT; i++) {
            const double mass = taut_band_at(&gram.mass, i, i);
            const double stiff = taut_band_at(&gram.stiffness, i, i);
            /* 16 terms, each from a recurrence of three steps */
            CHECK_NEAR(taut_band_at(&gram.mass, COUNT - 1 - i, COUNT - 1 - i), mass,
                       64 * TAUT_UNIT_ROUNDOFF * mass, "shift=%d i=%d", shift, i);
            CHECK_NEAR(taut_band_at(&gram.stiffness, COUNT - 1 - i, COUNT - 1 - i), stiff,
                       64 * TAUT_UNIT_ROUNDOFF * stiff, "shift=%d i=%d", shift, i);
            if (shift == 1 && i >= 6 && i < COUNT - 6) {
                CHECK_NEAR(mass * SPANS, 151.0 / 315, 64 * TAUT_UNIT_ROUNDOFF, "i=%d", i);
                CHECK_NEAR(stiff / SPANS, 2.0 / 3, 64 * TAUT_UNIT_ROUNDOFF, "i=%d", i);
            }
        }
        taut_gram_clear(&gram);
        taut_basis_free(basis);
    }
}

/* Linear, spans that grow from 1e-6 to 1 and shrink again, so that knots mirror to their rounding
 * and lengths do not: mass(i,i) = (h_i + h_(i+1)) / 3 L,   stiffness(i,i) = L (1/h_i + 1/h_(i+1))
 * with the differences of the knots themselves, which are exact to a rounding. */
static void test_nearly_mirrored(void)
{
    enum { SPANS = 13, COUNT = SPANS + 1 };
    double knots[COUNT + 2] = {0};
    for (int i = 0; i < SPANS; i++) {
        knots[i + 2] = knots[i + 1] + pow(10, i < 7 ? i - 6 : 6 - i);
    }
    knots[COUNT + 1] = knots[COUNT];
    const taut_basis_spec spec = {
        .type = "bspline", .degree = 1, .knots = knots, .knot_count = COUNT + 2};
    taut_basis *basis = NULL;
    taut_gram gram;
    CHECK(taut_basis_new(&spec, COUNT, &basis, NULL) == TAUT_OK, "basis");
    CHECK(taut_gram_new(basis, NULL, &gram, NULL) == TAUT_OK, "gram");
    for (int i = 1; i < COUNT - 1; i++) {
        const double h[2] = {knots[i + 1] - knots[i], knots[i + 2] - knots[i + 1]};
        const double mass = (h[0] + h[1]) / 3 / gram.length;
        const double stiff = gram.length / h[0] + gram.length / h[1];
        CHECK_NEAR(taut_band_at(&gram.mass, i, i), mass, 16 * TAUT_UNIT_ROUNDOFF * mass, "i=%d", i);
        CHECK_NEAR(taut_band_at(&gram.stiffness, i, i), stiff, 16 * TAUT_UNIT_ROUNDOFF * stiff,
                   "i=%d", i);
    }
    taut_gram_clear(&gram);
    taut_basis_free(basis);
}

/* Weights over 60 decades have a pole nearer than cells go; weights of 1e-300 on a span of 1e-12
 * have slopes no double holds. Both are refused, and nothing is touched. */
static void test_extremes(void)
{
    const double steep[3] = {1, 1e30, 1e60}, slight[2] = {1e-300, 1e-300};
    taut_basis *bases[2] = {bezier(2, 0, 1), bezier(1, 0, 1e-12)};
    taut_gram gram = {.length = -1};
    taut_error error = {.where = "", .message = ""};
    CHECK(taut_gram_new(bases[0], steep, &gram, &error) == TAUT_NOT_CONVERGED, "steep");
    CHECK(error.found > error.limit && strcmp(error.reason, "not-converged") == 0, "%s",
          error.reason);
    CHECK(taut_gram_new(bases[1], slight, &gram, &error) == TAUT_BAD_INPUT, "slight");
    CHECK(strcmp(error.reason, "short-span") == 0, "%s", error.reason);
    CHECK(gram.length == -1, "the output was touched");
    taut_basis_free(bases[0]);
    taut_basis_free(bases[1]);
}

int main(void)
{
    random_seed(20260301);
    test_bernstein();
    test_sums();
    test_equal_weights();
    test_rational_linear();
    test_panels();
    test_hidden_bump();
    test_select();
    test_many_uniform_spans();
    test_nearly_mirrored();
    test_extremes();
    return check_failures != 0;
}
