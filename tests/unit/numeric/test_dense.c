/* test_dense.c -- the small dense kernels against what defines them: products give the matrix back,
 * columns are orthonormal, gradients of least squares vanish. */
#include "check.h"

#include "numeric/dense.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

static void fill_random(int count, double *a)
{
    for (int i = 0; i < count; i++) {
        a[i] = random_in(-1, 1);
    }
}

/* r'r = a'a for the stack of all blocks, to rounding: |error| <= c rows eps |a|^2. */
static void test_qr_append(void)
{
    enum { N = 7, BLOCKS = 5, ROWS = 6 };
    for (int trial = 0; trial < 50; trial++) {
        double r[N * N] = {0}, block[ROWS * N], gram[N * N] = {0};
        for (int b = 0; b < BLOCKS; b++) {
            fill_random(ROWS * N, block);
            if (b == 2) { /* a zero column and equal ones must do no harm */
                memset(block, 0, ROWS * sizeof *block);
                memcpy(block + ROWS, block + 2 * ROWS, ROWS * sizeof *block);
            }
            for (int i = 0; i < N; i++) {
                for (int j = 0; j < N; j++) {
                    for (int k = 0; k < ROWS; k++) {
                        gram[i + j * N] += block[k + i * ROWS] * block[k + j * ROWS];
                    }
                }
            }
            taut_qr_append(N, r, ROWS, block);
        }
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                double product = 0.0;
                for (int k = 0; k <= (i < j ? i : j); k++) {
                    product += r[k + i * N] * r[k + j * N];
                }
                CHECK_NEAR(product, gram[i + j * N], 40 * ROWS * BLOCKS * DBL_EPSILON,
                           "trial %d entry %d %d", trial, i, j);
            }
        }
    }
}

/* Least squares as further columns: the solution of an overdetermined system with a known one, and
 * the residual below it. */
static void test_least_squares(void)
{
    enum { N = 5, ROWS = 9 };
    for (int trial = 0; trial < 50; trial++) {
        double a[(N + 1) * ROWS], r[(N + 1) * (N + 1)] = {0}, x[N], found[N];
        fill_random(N * ROWS, a);
        fill_random(N, x);
        for (int i = 0; i < ROWS; i++) {
            a[N * ROWS + i] = 0.0;
            for (int j = 0; j < N; j++) {
                a[N * ROWS + i] += a[j * ROWS + i] * x[j];
            }
        }
        taut_qr_append(N + 1, r, ROWS, a);
        memcpy(found, r + (long)N * (N + 1), sizeof found);
        CHECK(taut_triangle_solve(N, N + 1, r, found), "trial %d", trial);
        for (int j = 0; j < N; j++) {
            CHECK_NEAR(found[j], x[j], 1e-12, "trial %d", trial);
        }
        CHECK_NEAR(r[N * (N + 1) + N], 0.0, 1e-14, "the residual of a consistent system");
    }
}

static void test_triangle_refuses(void)
{
    const double r[4] = {1, 0, 3, 1e-15};
    double x[2] = {5, 7};
    CHECK(!taut_triangle_solve(2, 2, r, x), "a dependent column");
    CHECK(x[0] == 5 && x[1] == 7, "untouched");
}

/* a = u s v', u and v orthonormal, s decreasing; columns scaled over twelve decades. */
static void test_svd(void)
{
    enum { ROWS = 6, N = 4 };
    for (int trial = 0; trial < 200; trial++) {
        double a[ROWS * N], u[ROWS * N], s[N], v[N * N];
        fill_random(ROWS * N, a);
        for (int j = 0; j < N; j++) {
            const double scale = trial % 2 == 0 ? 1.0 : random_log(1e-6, 1e6);
            for (int i = 0; i < ROWS; i++) {
                a[i + j * ROWS] *= scale;
            }
        }
        memcpy(u, a, sizeof a);
        taut_svd(ROWS, N, u, s, v);
        for (int j = 0; j < N; j++) {
            CHECK(j == 0 || s[j] <= s[j - 1], "trial %d: decreasing", trial);
            for (int k = 0; k <= j; k++) {
                double uu = 0.0, vv = 0.0;
                for (int i = 0; i < ROWS; i++) {
                    uu += u[i + j * ROWS] * u[i + k * ROWS];
                }
                for (int i = 0; i < N; i++) {
                    vv += v[i + j * N] * v[i + k * N];
                }
                CHECK_NEAR(uu, j == k, 1e-14, "trial %d u %d %d", trial, j, k);
                CHECK_NEAR(vv, j == k, 1e-14, "trial %d v %d %d", trial, j, k);
            }
        }
        for (int i = 0; i < ROWS; i++) {
            for (int j = 0; j < N; j++) {
                double product = 0.0;
                for (int k = 0; k < N; k++) {
                    product += u[i + k * ROWS] * s[k] * v[j + k * N];
                }
                CHECK_NEAR(product, a[i + j * ROWS], 1e-14 * s[0], "trial %d", trial);
            }
        }
    }
}

/* A wide system: the solution solves it, is orthogonal to the null space, and the null space is
 * what the matrix sends to 0. */
static void test_least_norm(void)
{
    enum { ROWS = 3, N = 5 };
    for (int trial = 0; trial < 200; trial++) {
        double a[ROWS * N], b[ROWS], x[N], null[N * N];
        int rank = 0;
        fill_random(ROWS * N, a);
        fill_random(ROWS, b);
        rank = taut_least_norm(ROWS, N, a, b, 1e-10, x, null);
        CHECK(rank == ROWS, "trial %d rank %d", trial, rank);
        for (int i = 0; i < ROWS; i++) {
            double miss = -b[i];
            for (int j = 0; j < N; j++) {
                miss += a[i + j * ROWS] * x[j];
            }
            CHECK_NEAR(miss, 0.0, 1e-12, "trial %d", trial);
        }
        for (int k = 0; k < N - rank; k++) {
            double along = 0.0;
            for (int j = 0; j < N; j++) {
                along += x[j] * null[j + k * N];
            }
            CHECK_NEAR(along, 0.0, 1e-13, "trial %d", trial);
            for (int i = 0; i < ROWS; i++) {
                double image = 0.0;
                for (int j = 0; j < N; j++) {
                    image += a[i + j * ROWS] * null[j + k * N];
                }
                CHECK_NEAR(image, 0.0, 1e-14, "trial %d", trial);
            }
        }
    }
}

/* A matrix of rank 1 has rank 1. */
static void test_rank(void)
{
    const double a[6] = {1, 2, 3, 2, 4, 6}, b[3] = {1, 2, 3};
    double x[2];
    CHECK(taut_least_norm(3, 2, a, b, 1e-12, x, NULL) == 1, "rank 1");
    CHECK_NEAR(x[0], 0.2, 1e-15, "x0 + 2 x1 = 1 of least norm");
    CHECK_NEAR(x[1], 0.4, 1e-15, "x0 + 2 x1 = 1 of least norm");
}

/* a v = v diag(values), v'v = 1: random ones of every size; diagonal, of equal eigenvalues, of rank
 * one, parted, and of every magnitude. Seen: 2.4e-15 sqrt(n) of the largest entry. */
static void check_eigen(int n, const double *a, double size)
{
    static double copy[TAUT_EIGEN_MAX * TAUT_EIGEN_MAX], v[TAUT_EIGEN_MAX * TAUT_EIGEN_MAX];
    double values[TAUT_EIGEN_MAX];
    memcpy(copy, a, (size_t)n * (size_t)n * sizeof *a);
    taut_symmetric_eigen(n, copy, values, v);
    for (int k = 0; k < n; k++) {
        CHECK(k == 0 || values[k] >= values[k - 1], "increasing");
        for (int i = 0; i < n; i++) {
            double image = -values[k] * v[i + k * n], product = i == k ? -1.0 : 0.0;
            for (int j = 0; j < n; j++) {
                image += a[i + j * n] * v[j + k * n];
                product += v[j + i * n] * v[j + k * n];
            }
            CHECK_NEAR(image / size, 0.0, 5e-15 * sqrt((double)n), "n=%d %d", n, k);
            CHECK_NEAR(product, 0.0, 5e-15 * sqrt((double)n), "n=%d %d %d", n, i, k);
        }
    }
}

static void test_eigen(void)
{
    static double a[TAUT_EIGEN_MAX * TAUT_EIGEN_MAX];
    for (int trial = 0; trial < 120; trial++) {
        const int n = trial < 100 ? 1 + trial % 20 : trial == 119 ? TAUT_EIGEN_MAX : 2 * trial / 10;
        const double size = ldexp(1.0, trial % 5 == 0 ? 900 : trial % 5 == 1 ? -900 : 0);
        for (int j = 0; j < n; j++) {
            for (int i = 0; i <= j; i++) {
                const double x = trial % 7 == 0   ? (i == j ? floor(random_in(-2, 2)) : 0.0)
                                 : trial % 7 == 1 ? 1.0
                                 : trial % 7 == 2 ? (i + 1 == j || i == j ? random_in(-1, 1) : 0.0)
                                 : trial % 7 == 3 && i < n / 2 && j >= n / 2 ? 0.0
                                                                             : random_in(-1, 1);
                a[i + j * n] = a[j + i * n] = size * x;
            }
        }
        check_eigen(n, a, size);
    }
}

int main(void)
{
    test_qr_append();
    test_least_squares();
    test_triangle_refuses();
    test_svd();
    test_least_norm();
    test_rank();
    test_eigen();
    return check_failures != 0;
}
