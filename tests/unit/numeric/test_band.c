/* Banded matrices against their dense meaning. */
#include "check.h"

#include "numeric/band.h"

#include <stdlib.h>

enum { N_MAX = 24, TRIALS = 400 };

/* Diagonally dominant, so positive definite; random entries in [-1, 1]. */
static taut_band random_band(int n, int width)
{
    taut_band band = {0, 0, NULL};
    CHECK(taut_band_init(n, width, &band) == TAUT_OK, "n=%d", n);
    for (int i = 0; i < n; i++) {
        taut_band_row(&band, i)[0] = 2.0 * width + random_in(0.5, 2.0);
        for (int d = 1; d <= width && d <= i; d++) {
            taut_band_row(&band, i)[d] = random_in(-1.0, 1.0);
        }
    }
    return band;
}

static double entry(const taut_band *a, int i, int j)
{
    const int low = i < j ? i : j, high = i < j ? j : i;
    return high - low > a->width ? 0.0 : a->a[high * (a->width + 1) + high - low];
}

/* A x by the definition against multiply_add; then solving gives x back. */
static void test_multiply_and_solve(void)
{
    for (int trial = 0; trial < TRIALS; trial++) {
        const int n = random_int(1, N_MAX), width = random_int(0, 7);
        double x[N_MAX], y[N_MAX] = {0}, sums[N_MAX][2];
        taut_band a = random_band(n, width);
        for (int i = 0; i < n; i++) {
            x[i] = random_in(-1.0, 1.0);
        }
        taut_band_multiply_add(&a, -0.5, x, y);
        for (int i = 0; i < n; i++) {
            double sum = 0.0;
            for (int j = 0; j < n; j++) {
                sum += entry(&a, i, j) * x[j];
                CHECK(taut_band_at(&a, i, j) == entry(&a, i, j), "i=%d j=%d", i, j);
            }
            /* 15 terms of size <= 17 */
            CHECK_NEAR(y[i], -0.5 * sum, 16 * 17 * 0x1p-53, "n=%d width=%d i=%d", n, width, i);
            sums[i][0] = sum;
            sums[i][1] = -sum;
        }
        CHECK(taut_band_factor(&a) == TAUT_OK, "n=%d width=%d", n, width);
        taut_band_solve(&a, 2, &sums[0][0]);
        for (int i = 0; i < n; i++) {
            /* cond(A) < 60 by Gershgorin, backward error <= 3 (width + 1) u */
            CHECK_NEAR(sums[i][0], x[i], 60 * 24 * 0x1p-53, "n=%d width=%d i=%d", n, width, i);
            CHECK(sums[i][1] == -sums[i][0], "columns are solved alike");
        }
        taut_band_clear(&a);
    }
}

/* Wide bands have loops of their own, for one right-hand side. */
static void test_wide(void)
{
    enum { ROWS = 150 };
    for (int trial = 0; trial < 40; trial++) {
        const int n = random_int(1, ROWS), width = random_int(28, 60);
        double x[ROWS], one[ROWS] = {0}, two[ROWS][2];
        taut_band a = random_band(n, width);
        for (int i = 0; i < n; i++) {
            x[i] = random_in(-1.0, 1.0);
        }
        taut_band_multiply_add(&a, 1.0, x, one);
        for (int i = 0; i < n; i++) {
            two[i][0] = two[i][1] = one[i];
        }
        CHECK(taut_band_factor(&a) == TAUT_OK, "n=%d width=%d", n, width);
        taut_band_solve(&a, 1, one);
        taut_band_solve(&a, 2, &two[0][0]);
        for (int i = 0; i < n; i++) {
            /* cond(A) < 2 (4 width + 2) by Gershgorin, backward error <= 3 (width + 1) u */
            const double bound = 2 * (4 * 60 + 2) * 3 * 61 * 0x1p-53;
            CHECK_NEAR(one[i], x[i], bound, "n=%d width=%d i=%d", n, width, i);
            CHECK_NEAR(two[i][0], x[i], bound, "n=%d width=%d i=%d", n, width, i);
        }
        taut_band_clear(&a);
    }
}

/* The tiles against the rows, factor by factor, and against the product L D L^T by its definition;
 * sizes around those of the blocks. */
static void test_tiles(void)
{
    for (int trial = 0; trial < 40; trial++) {
        const int width = random_int(TAUT_BAND_TILES_LEAST, TAUT_BAND_TILES_LEAST + 40);
        const int n = trial < 20 ? random_int(1, 80) : random_int(width, 4 * width);
        taut_band given = random_band(n, width), rows = {0, 0, NULL}, tiles = {0, 0, NULL};
        double *work = aligned_alloc(64, (taut_band_tiles_work(n, width) + 7) / 8 * 64);
        CHECK(work != NULL && taut_band_widen(&given, width, &rows) == TAUT_OK &&
                  taut_band_widen(&given, width, &tiles) == TAUT_OK,
              "n=%d width=%d", n, width);
        CHECK(taut_band_factor(&rows) == TAUT_OK, "rows: n=%d width=%d", n, width);
        CHECK(taut_band_factor_tiled(&tiles, work, NULL) == TAUT_OK, "n=%d width=%d", n, width);
        CHECK(taut_band_is_legal(&tiles), "n=%d width=%d", n, width);
        for (int i = 0; i < n; i++) {
            for (int d = 0; d <= width && d <= i; d++) {
                const int from = i > width ? i - width : 0;
                double sum = 0.0;
                for (int k = from; k <= i - d; k++) {
                    const double l = k == i ? 1.0 : entry(&tiles, i, k);
                    const double m = k == i - d ? 1.0 : entry(&tiles, i - d, k);
                    sum += l * m * tiles.a[(size_t)k * (size_t)(width + 1)];
                }
                /* [Higham2002] 10.1.1: (width + 1) u |L| |D| |L|^T, that product <= 3 A(i, i) for
                 * diagonally dominant A, and the same again for the sum here */
                CHECK_NEAR(sum, entry(&given, i, i - d),
                           2 * (width + 2) * 0x1p-53 * 3 * (2 * width + 2), "n=%d width=%d i=%d", n,
                           width, i);
                CHECK_NEAR(entry(&tiles, i, i - d), entry(&rows, i, i - d),
                           (width + 2) * 0x1p-53 * 3 * (2 * width + 2), "n=%d width=%d i=%d", n,
                           width, i);
            }
        }
        free(work);
        taut_band_clear(&given);
        taut_band_clear(&rows);
        taut_band_clear(&tiles);
    }
}

/* A pivot that vanishes, in every row of a block and behind it. */
static void test_tiles_refuse(void)
{
    enum { ROWS = 110, WIDTH = 70 };
    double *work = aligned_alloc(64, (taut_band_tiles_work(ROWS, WIDTH) + 7) / 8 * 64);
    for (int bad = 1; bad < ROWS; bad++) {
        taut_band a = {0, 0, NULL};
        CHECK(work != NULL && taut_band_init(ROWS, WIDTH, &a) == TAUT_OK, "bad=%d", bad);
        for (int i = 0; i < ROWS; i++) {
            taut_band_row(&a, i)[0] = 1.0;
        }
        const int from = bad > WIDTH ? bad - WIDTH : 0;
        taut_band_row(&a, bad)[bad - from] = 1.0; /* two equal rows */
        CHECK(taut_band_factor_tiled(&a, work, NULL) == TAUT_NO_SOLUTION, "bad=%d", bad);
        taut_band_clear(&a);
    }
    free(work);
}

static void test_widen(void)
{
    taut_band a = random_band(6, 2), wide = {0, 0, NULL}, narrow = {1, 2, NULL};
    CHECK(taut_band_widen(&a, 4, &wide) == TAUT_OK, "widen");
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            CHECK(taut_band_at(&wide, i, j) == taut_band_at(&a, i, j), "i=%d j=%d", i, j);
        }
    }
    CHECK(taut_band_widen(&a, 1, &narrow) == TAUT_BAD_ARGUMENT && narrow.width == 2, "narrower");
    CHECK(!taut_band_equal(&a, &wide) && taut_band_equal(&a, &a), "equal");
    taut_band_clear(&wide);
    taut_band_clear(&a);
}

/* The second difference with free ends has constants in its kernel. */
static void test_refuses_singular(void)
{
    for (int n = 2; n <= 1000; n += 1 + n / 4) {
        taut_band a = {0, 0, NULL};
        CHECK(taut_band_init(n, 1, &a) == TAUT_OK, "n=%d", n);
        for (int i = 0; i < n; i++) {
            taut_band_row(&a, i)[0] = i == 0 || i == n - 1 ? 1.0 : 2.0;
            taut_band_row(&a, i)[1] = i == 0 ? 0.0 : -1.0;
        }
        CHECK(taut_band_factor(&a) == TAUT_NO_SOLUTION, "n=%d", n);
        taut_band_clear(&a);
    }
}

static void test_refuses_bad_arguments(void)
{
    taut_band a = {7, 7, NULL};
    CHECK(taut_band_init(0, 1, &a) == TAUT_BAD_ARGUMENT, "n = 0");
    CHECK(taut_band_init(3, -1, &a) == TAUT_BAD_ARGUMENT, "width < 0");
    CHECK(taut_band_init(2147483647, 2147483646, &a) == TAUT_BAD_ARGUMENT, "too large");
    CHECK(a.n == 7 && a.a == NULL, "outputs are untouched on failure");
    taut_band b = random_band(4, 2);
    CHECK(taut_band_is_legal(&b), "legal");
    b.a[5] = nan("");
    CHECK(!taut_band_is_legal(&b), "not a number");
    b.a[5] = 0.0;
    b.a[1] = 1.0;
    CHECK(!taut_band_is_legal(&b), "an entry outside the matrix");
    taut_band_clear(&b);
}

/* The second differences less a shift: their eigenvalues are 2 - 2 cos(k pi / (n + 1)) - shift. Wider: two of them apart. */
static void test_signed(void)
{
    enum { N = 60 };
    for (int trial = 0; trial < 40; trial++) {
        const int apart = trial % 2 == 0 ? 1 : 40;
        const double shift = random_in(0, 1.5);
        taut_band band;
        double x[N], b[N];
        int negative = -1, expected = 0;
        CHECK(taut_band_init(N, apart, &band) == TAUT_OK, "trial %d", trial);
        for (int i = 0; i < N; i++) {
            taut_band_row(&band, i)[0] = 2 - shift;
            if (i >= apart) {
                taut_band_row(&band, i)[apart] = -1;
            }
            b[i] = random_in(-1, 1);
        }
        for (int c = 0; c < apart; c++) { /* chains of every apart-th row */
            const int n = (N - c + apart - 1) / apart;
            for (int k = 1; k <= n; k++) {
                expected += 2 - 2 * cos(k * 3.14159265358979324 / (n + 1)) < shift;
            }
        }
        taut_band copy;
        CHECK(taut_band_widen(&band, apart, &copy) == TAUT_OK, "trial %d", trial);
        CHECK(taut_band_factor_signed(&copy, &negative, NULL) == TAUT_OK && negative == expected,
              "trial %d: %d below 0, expected %d", trial, negative, expected);
        for (int i = 0; i < N; i++) {
            x[i] = b[i];
        }
        taut_band_solve(&copy, 1, x);
        double largest = 0;
        for (int i = 0; i < N; i++) {
            b[i] = -b[i];
            largest = fmax(largest, fabs(x[i]));
        }
        taut_band_multiply_add(&band, 1, x, b);
        for (int i = 0; i < N; i++) {
            CHECK_NEAR(b[i], 0, 1e-11 * (1 + largest), "trial %d", trial);
        }
        taut_band_clear(&band);
        taut_band_clear(&copy);
    }
}

int main(void)
{
    random_seed(11);
    test_multiply_and_solve();
    test_wide();
    test_tiles();
    test_tiles_refuse();
    test_widen();
    test_refuses_singular();
    test_refuses_bad_arguments();
    test_signed();
    return check_failures != 0;
}
