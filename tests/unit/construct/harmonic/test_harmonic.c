/* test_harmonic.c -- harmonic completion and extension: against exact rationals, against the
 * numbers of [NiWang2015] sections 4 and 7, and by their own identities. links: gmp
 */
#include "check.h"

#include "construct/harmonic/complete.h"
#include "taut/harmonic.h"

#include <gmp.h>

enum { SIZE = 34 };

static mpq_t power[SIZE][SIZE]; /* [l][k]: of v^l u^k */
static mpq_t half_way[SIZE][SIZE];
static mpq_t scratch[4];

static void start(void)
{
    for (int i = 0; i < SIZE; i++) {
        for (int j = 0; j < SIZE; j++) {
            mpq_init(power[i][j]);
            mpq_init(half_way[i][j]);
        }
    }
    for (int i = 0; i < 4; i++) {
        mpq_init(scratch[i]);
    }
}

/* C(i,k) / C(n,k) */
static void ratio(int i, int n, int k, mpq_t out)
{
    mpz_bin_uiui(mpq_numref(out), (unsigned long)i, (unsigned long)k);
    mpz_bin_uiui(mpq_denref(out), (unsigned long)n, (unsigned long)k);
    mpq_canonicalize(out);
}

/* The v^l coefficient of a row of degree m: C(m,l) Delta^l. */
static void coefficient(int m, int l, const double *row, mpq_t out)
{
    mpq_set_ui(out, 0, 1);
    for (int j = 0; j <= l; j++) {
        mpq_set_d(scratch[0], row[3 * j]);
        mpz_bin_uiui(mpq_numref(scratch[1]), (unsigned long)l, (unsigned long)j);
        mpz_set_ui(mpq_denref(scratch[1]), 1);
        mpq_mul(scratch[0], scratch[0], scratch[1]);
        if ((l - j) % 2 != 0) {
            mpq_neg(scratch[0], scratch[0]);
        }
        mpq_add(out, out, scratch[0]);
    }
    mpz_bin_uiui(mpq_numref(scratch[1]), (unsigned long)m, (unsigned long)l);
    mpz_set_ui(mpq_denref(scratch[1]), 1);
    mpq_mul(out, out, scratch[1]);
}

/* power[l][k], k >= 2, of f_l'' = -mu (l+1)(l+2) f_{l+2}. */
static void integrate(int n, int m, int l, double mu)
{
    for (int k = 2; k <= n; k++) {
        mpq_set_ui(power[l][k], 0, 1);
        if (l + 2 <= m) {
            mpq_set_si(scratch[0], -(l + 1) * (l + 2), (unsigned long)(k * (k - 1)));
            mpq_canonicalize(scratch[0]);
            mpq_set_d(scratch[1], mu);
            mpq_mul(scratch[0], scratch[0], scratch[1]);
            mpq_mul(power[l][k], scratch[0], power[l + 2][k - 2]);
        }
    }
}

/* The exact net of coordinate 0, by the chain of section 2.4, rounded to doubles. */
static void exact_rows(int n, int m, double mu, const double *row0, const double *row1, double *net)
{
    for (int l = m; l >= 0; l--) {
        integrate(n, m, l, mu);
        coefficient(m, l, row0, power[l][0]);
        coefficient(m, l, row1, scratch[2]);
        mpq_sub(power[l][1], scratch[2], power[l][0]);
        for (int k = 2; k <= n; k++) {
            mpq_sub(power[l][1], power[l][1], power[l][k]);
        }
    }
    for (int j = 0; j <= m; j++) {
        for (int k = 0; k <= n; k++) {
            mpq_set_ui(half_way[j][k], 0, 1);
            for (int l = 0; l <= j; l++) {
                ratio(j, m, l, scratch[0]);
                mpq_mul(scratch[0], scratch[0], power[l][k]);
                mpq_add(half_way[j][k], half_way[j][k], scratch[0]);
            }
        }
    }
    for (int i = 0; i <= n; i++) {
        for (int j = 0; j <= m; j++) {
            mpq_set_ui(scratch[1], 0, 1);
            for (int k = 0; k <= i; k++) {
                ratio(i, n, k, scratch[0]);
                mpq_mul(scratch[0], scratch[0], half_way[j][k]);
                mpq_add(scratch[1], scratch[1], scratch[0]);
            }
            net[i * (m + 1) + j] = mpq_get_d(scratch[1]);
        }
    }
}

/* Random rows, n to 31: within 1e-15 of the largest point ([NiWang2015] section 7: 5e-16). */
static void test_against_rationals(void)
{
    static double net[SIZE * SIZE * 3], exact[SIZE * SIZE];
    static taut_twice work[SIZE * SIZE * 3];
    for (int m = 1; m <= 30; m++) {
        const int n = m % 2 != 0 ? m : m + 1;
        const double mu = m % 3 == 0 ? 0.75 : 1;
        double row0[3 * SIZE] = {0}, row1[3 * SIZE] = {0}, largest = 0, apart = 0;
        for (int j = 0; j <= m; j++) {
            row0[3 * j] = random_in(-1, 1);
            row1[3 * j] = random_in(-1, 1);
        }
        taut_harmonic_from_rows(n, m, taut_twice_of(mu), row0, row1, work, net, NULL);
        exact_rows(n, m, mu, row0, row1, exact);
        for (int k = 0; k < (n + 1) * (m + 1); k++) {
            largest = fmax(largest, fabs(exact[k]));
            apart = fmax(apart, fabs(net[3 * k] - exact[k]));
        }
        CHECK(apart <= 1e-15 * largest, "n=%d m=%d: %.3g of the largest", n, m, apart / largest);
    }
}

/* The table of section 7, to the digits printed there; of even degree the two rows alone. */
static void test_amplification(void)
{
    static const struct {
        int n;
        double rows, derivative, half;
    } table[] = {{3, 5, 11, 0.5},          {5, 45, 81, 0.5},         {7, 745, 491, 0.5},
                 {9, 2.1e4, 2.9e3, 0.05},  {11, 9.1e5, 1.8e4, 0.05}, {13, 5.7e7, 1.0e5, 0.05},
                 {15, 4.8e9, 6.2e5, 0.05}, {8, 4.0e3, 0, 0.05},      {10, 1.4e5, 0, 0.05},
                 {12, 7.5e6, 0, 0.05},     {16, 5.2e10, 0, 0.05},    {20, 9.9e14, 0, 0.05}};
    static taut_twice work[3 * SIZE * SIZE];
    static double sum[SIZE * SIZE];
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        const int n = table[i].n;
        const int across = n % 2 != 0 ? n : n + 1; /* even: the unconstrained bidegree */
        const double rows = taut_harmonic_rows_amplification(across, n, 1, NULL);
        const double derivative =
            taut_harmonic_derivative_amplification(across, n, taut_twice_of(1), work, sum, NULL);
        const double unit = table[i].half < 0.5 ? table[i].half : 0;
        const double scale_r = unit > 0 ? pow(10, floor(log10(table[i].rows))) : 1;
        const double scale_d = unit > 0 ? pow(10, floor(log10(table[i].derivative))) : 1;
        CHECK_NEAR(rows, table[i].rows, 1.001 * table[i].half * scale_r, "n=%d", n);
        if (table[i].derivative > 0) {
            CHECK_NEAR(derivative, table[i].derivative, 1.001 * table[i].half * scale_d, "n=%d", n);
        }
    }
}

/* Rows that agree, bidegree (n, n): by hand 3 = 1 + 2! 4 / 4 at n = 2, 17 at n = 4; within 17 % of
 * the unconstrained bidegree's, from n = 12 on within 2 % ([NiWang2015] section 7), where it is to
 * be warned about. */
static void test_amplification_of_even(void)
{
    CHECK_NEAR(taut_harmonic_rows_amplification(2, 2, 1, NULL), 3, 1e-12, "n=2");
    CHECK_NEAR(taut_harmonic_rows_amplification(4, 4, 1, NULL), 17, 1e-12, "n=4");
    for (int n = 4; n <= 20; n += 2) {
        const double even = taut_harmonic_rows_amplification(n, n, 1, NULL);
        const double free = taut_harmonic_rows_amplification(n + 1, n, 1, NULL);
        CHECK(fabs(even / free - 1) <= (n < 12 ? 0.17 : 0.02), "n=%d: %g, %g", n, even, free);
    }
    CHECK(taut_harmonic_rows_amplification(12, 12, 1, NULL) >= 5e6, "n=12");
}

/* A net from rows and the same net from its first row and the derivative there. */
static void test_two_routes(void)
{
    static double net[SIZE * SIZE * 3], again[SIZE * SIZE * 3];
    static taut_twice work[3 * SIZE * SIZE];
    static double sum[SIZE * SIZE];
    for (int trial = 0; trial < 200; trial++) {
        const int m = random_int(1, 9),
                  n = m % 2 != 0 ? m + random_int(0, 2) : m + random_int(1, 3);
        const double mu = random_log(0.1, 10);
        double rows[2][3 * SIZE], cross[3 * SIZE], largest = 0, apart = 0;
        for (int j = 0; j < 3 * (m + 1); j++) {
            rows[0][j] = random_in(-1, 1);
            rows[1][j] = random_in(-1, 1);
        }
        taut_harmonic_from_rows(n, m, taut_twice_of(mu), rows[0], rows[1], work, net, NULL);
        for (int j = 0; j < 3 * (m + 1); j++) {
            cross[j] = n * (net[3 * (m + 1) + j] - net[j]);
        }
        taut_harmonic_from_derivative(n, m, taut_twice_of(mu), rows[0], 1, cross, work, again,
                                      NULL);
        for (int k = 0; k < 3 * (n + 1) * (m + 1); k++) {
            largest = fmax(largest, fabs(net[k]));
            apart = fmax(apart, fabs(net[k] - again[k]));
        }
        /* the derivative carries a rounding of the net, which the second route amplifies */
        const double grows =
            taut_harmonic_derivative_amplification(n, m, taut_twice_of(mu), work, sum, NULL);
        CHECK(apart <= 4 * 0x1p-53 * grows * largest,
              "n=%d m=%d mu=%g: %.3g of the largest, growth %.3g", n, m, mu, apart / largest,
              grows);
    }
}

/* What leaves the range of numbers is infinite, not lost; what does not leave it is told, though powers of mu do. */
static void test_range(void)
{
    static taut_twice work[3 * SIZE * SIZE];
    static double sum[SIZE * SIZE];
    static const double huge[2] = {1e60, 1e300};
    for (int k = 0; k < 2; k++) {
        const double mu = huge[k];
        CHECK(isinf(taut_harmonic_rows_amplification(13, 12, mu, NULL)), "rows, mu=%g", mu);
        CHECK(isinf(taut_harmonic_derivative_amplification(13, 12, taut_twice_of(mu), work, sum,
                                                           NULL)),
              "derivative, mu=%g", mu);
    }
    /* m = 2: 1 and u, and 2 mu (u - u^3) / 6 or the like, are all that there is */
    CHECK(taut_harmonic_rows_amplification(3, 2, 1e300, NULL) > 1e299, "rows");
    CHECK(taut_harmonic_derivative_amplification(3, 2, taut_twice_of(1e300), work, sum, NULL) >
                  1e299 &&
              taut_harmonic_derivative_amplification(3, 2, taut_twice_of(1e300), work, sum, NULL) <
                  1e303,
          "derivative");
    /* mu^13 is no number any more, and its term is nothing */
    double row[3 * SIZE] = {0}, net[3 * SIZE * SIZE];
    for (int j = 0; j <= 30; j++) {
        row[3 * j] = j % 2 == 0 ? 1 : -1;
    }
    taut_harmonic_from_rows(31, 30, taut_twice_of(1e-30), row, row, work, net, NULL);
    for (int i = 0; i <= 31; i++) {
        for (int j = 0; j <= 30; j++) {
            CHECK_NEAR(net[3 * (31 * i + j)], row[3 * j], 1e-15, "i=%d j=%d", i, j);
        }
    }
}

int main(void)
{
    random_seed(20260301);
    start();
    test_against_rationals();
    test_range();
    test_amplification();
    test_amplification_of_even();
    test_two_routes();
    return check_failures != 0;
}
