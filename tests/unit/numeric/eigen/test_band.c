/* All eigenpairs of banded pencils: against a closed form, against LAPACK, and by their own
 * definition. links: lapacke
 */
#include "check.h"
#include "gram.h"

#include "numeric/eigen/band.h"

#include <lapacke.h>
#include <stdlib.h>
#include <string.h>

typedef struct problem {
    int n;
    taut_band k, m;
    double *values, *vectors;
    char label[96];
} problem;

/* Gram matrices of `count` functions, the first and last left out. */
static problem gram_problem(gram_knots kind, int degree, int count, unsigned seed, int is_free)
{
    problem p = {.n = is_free ? count : count - 2};
    double *knots = malloc((size_t)(count + degree + 1) * sizeof *knots);
    gram_knots_make(kind, degree, count, seed, knots);
    CHECK(gram_make(degree, count, knots, is_free ? 0 : 1, is_free ? count - 1 : count - 2, &p.k,
                    &p.m),
          "memory");
    free(knots);
    p.values = malloc((size_t)p.n * sizeof *p.values);
    p.vectors = malloc((size_t)p.n * (size_t)p.n * sizeof *p.vectors);
    snprintf(p.label, sizeof p.label, "%s degree=%d n=%d seed=%u free=%d", gram_names[kind], degree,
             p.n, seed, is_free);
    return p;
}

static void problem_clear(problem *p)
{
    taut_band_clear(&p->k);
    taut_band_clear(&p->m);
    free(p->values);
    free(p->vectors);
}

/* The two bounds of numeric/eigen/band.h, in its own norm. */
static void check_definition(const problem *p)
{
    const size_t n = (size_t)p->n;
    double *mx = calloc(n, sizeof *mx), *r = calloc(n, sizeof *r),
           *abs_mx = calloc(n, sizeof *abs_mx);
    for (size_t j = 0; j < n; j++) {
        const double *x = p->vectors + j * n, lambda = p->values[j];
        memset(mx, 0, n * sizeof *mx);
        memset(r, 0, n * sizeof *r);
        taut_band_multiply_add(&p->m, 1.0, x, mx);
        taut_band_multiply_add(&p->k, 1.0, x, r);
        double residual = 0.0, noise = 0.0;
        for (int i = 0; i < p->n; i++) {
            double sum = 0.0;
            abs_mx[i] = 0.0;
            const int reach = p->k.width;
            for (int c = i > reach ? i - reach : 0; c <= i + reach && c < p->n; c++) {
                sum += (fabs(taut_band_at(&p->k, i, c)) +
                        fabs(lambda) * fabs(taut_band_at(&p->m, i, c))) *
                       fabs(x[c]);
                abs_mx[i] += fabs(taut_band_at(&p->m, i, c)) * fabs(x[c]);
            }
            const double weight = taut_band_at(&p->m, i, i), ri = r[i] - lambda * mx[i];
            residual += ri * ri / weight;
            noise += sum * sum / weight;
        }
        CHECK(sqrt(residual) <= 64 * 0x1p-53 * sqrt(noise), "%s j=%zu: %.1f u", p->label, j,
              sqrt(residual / noise) * 0x1p53);
        CHECK(j == 0 || p->values[j] >= p->values[j - 1], "%s j=%zu ascending", p->label, j);
        for (size_t i = 0; i <= j; i++) {
            double sum = 0.0, size = 0.0;
            for (size_t c = 0; c < n; c++) {
                sum += p->vectors[i * n + c] * mx[c];
                size += fabs(p->vectors[i * n + c]) * abs_mx[c];
            }
            CHECK_NEAR(sum, i == j ? 1.0 : 0.0, 64 * 0x1p-53 * (1.0 + size), "%s i=%zu j=%zu",
                       p->label, i, j);
        }
    }
    free(mx);
    free(r);
    free(abs_mx);
}

/* LAPACK's values carry an error of about u n lambda_max / lambda_min(M), M scaled to a unit
 * diagonal; the largest |x|^2 of a scaled eigenvector stands for the last. */
static void check_against_lapack(const problem *p)
{
    const size_t n = (size_t)p->n;
    double *k = calloc(n * n, sizeof *k), *m = calloc(n * n, sizeof *m), *w = calloc(n, sizeof *w);
    for (int i = 0; i < p->n; i++) {
        for (int j = 0; j < p->n; j++) {
            const double scale = sqrt(taut_band_at(&p->m, i, i) * taut_band_at(&p->m, j, j));
            k[(size_t)i * n + (size_t)j] = taut_band_at(&p->k, i, j) / scale;
            m[(size_t)i * n + (size_t)j] = taut_band_at(&p->m, i, j) / scale;
        }
    }
    CHECK(LAPACKE_dsygv(LAPACK_COL_MAJOR, 1, 'N', 'L', p->n, k, p->n, m, p->n, w) == 0, "%s",
          p->label);
    double longest = 1.0;
    for (size_t j = 0; j < n; j++) {
        double square = 0.0;
        for (size_t i = 0; i < n; i++) {
            const double x = p->vectors[j * n + i];
            square += x * x * taut_band_at(&p->m, (int)i, (int)i);
        }
        longest = fmax(longest, square);
    }
    for (size_t j = 0; j < n; j++) {
        CHECK_NEAR(p->values[j], w[j], (double)(n + 10) * 0x1p-53 * w[n - 1] * longest, "%s j=%zu",
                   p->label, j);
    }
    free(k);
    free(m);
    free(w);
}

static void check_problem(gram_knots kind, int degree, int count, unsigned seed, int is_free)
{
    problem p = gram_problem(kind, degree, count, seed, is_free);
    const taut_status status = taut_eigen_band(&p.k, &p.m, NULL, p.values, p.vectors);
    CHECK(status == TAUT_OK, "%s status %d", p.label, (int)status);
    if (status == TAUT_OK) {
        check_definition(&p);
        check_against_lapack(&p);
    }
    problem_clear(&p);
}

/* Degree 1, h = 1, ends fixed: lambda_j = 6 (1 - cos a) / (2 + cos a), a = j pi / (n + 1), from the
 * Toeplitz rows
 * (-1, 2, -1) and (1, 4, 1)/6. */
static void test_linear_elements(void)
{
    for (int n = 1; n <= 200; n += 1 + n / 2) {
        problem p = gram_problem(GRAM_UNIFORM, 1, n + 2, 0, 0);
        CHECK(taut_eigen_band(&p.k, &p.m, NULL, p.values, p.vectors) == TAUT_OK, "n=%d", n);
        for (int j = 1; j <= n; j++) {
            const double s = sin(0.5 * j * acos(-1.0) / (n + 1)); /* 1 - cos a = 2 s^2 */
            const double expected = 12.0 * s * s / (3.0 - 2.0 * s * s);
            CHECK_NEAR(p.values[j - 1], expected, 16 * 0x1p-53 * 12.0, "n=%d j=%d", n, j);
        }
        problem_clear(&p);
    }
}

static void test_spline_pencils(void)
{
    const int sizes[] = {3, 4, 7, 12, 13, 25, 50, 90};
    for (int kind = 0; kind < GRAM_KINDS; kind++) {
        for (int degree = 1; degree <= 7; degree++) {
            for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
                const int count = sizes[s] + 2;
                if (count > degree) {
                    check_problem((gram_knots)kind, degree, count, (unsigned)random_int(1, 1000),
                                  0);
                    check_problem((gram_knots)kind, degree, count, (unsigned)random_int(1, 1000),
                                  1);
                }
            }
        }
    }
    check_problem(GRAM_GRADED, 3, 400, 1, 0);
    check_problem(GRAM_REPEATED, 7, 400, 1, 0);
    check_problem(GRAM_MIRRORED, 3, 300, 1, 0);
}

/* Copies of one block: every eigenvalue as many times as there are copies, exactly. */
static void test_multiple_eigenvalues(void)
{
    enum { BLOCK = 5, COPIES = 9, N = BLOCK * COPIES };
    problem p = {
        .n = N, .values = malloc(N * sizeof(double)), .vectors = malloc(N * N * sizeof(double))};
    snprintf(p.label, sizeof p.label, "copies");
    CHECK(taut_band_init(N, 2, &p.k) == TAUT_OK && taut_band_init(N, 2, &p.m) == TAUT_OK, "memory");
    double entry[BLOCK][3];
    for (int i = 0; i < BLOCK; i++) {
        for (int d = 0; d < 3; d++) {
            entry[i][d] = random_in(-1.0, 1.0);
        }
    }
    for (int i = 0; i < N; i++) {
        for (int d = 0; d <= 2 && d <= i % BLOCK; d++) {
            taut_band_row(&p.k, i)[d] = entry[i % BLOCK][d] + (d == 0 ? 5.0 : 0.0);
            taut_band_row(&p.m, i)[d] = d == 0 ? 1.0 + 0.1 * (i % BLOCK) : 0.1;
        }
    }
    CHECK(taut_eigen_band(&p.k, &p.m, NULL, p.values, p.vectors) == TAUT_OK, "copies");
    check_definition(&p);
    check_against_lapack(&p);
    problem_clear(&p);
}

static void test_refusals(void)
{
    problem p = gram_problem(GRAM_UNIFORM, 3, 12, 0, 0);
    p.values[0] = 7.0;
    taut_band other = {0, 0, NULL};
    CHECK(taut_band_init(9, 3, &other) == TAUT_OK, "memory");
    CHECK(taut_eigen_band(&p.k, &other, NULL, p.values, p.vectors) == TAUT_BAD_ARGUMENT, "sizes");
    taut_band_clear(&other);
    CHECK(taut_band_init(10, 3, &other) == TAUT_OK, "memory");
    CHECK(taut_eigen_band(&p.k, &other, NULL, p.values, p.vectors) == TAUT_NO_SOLUTION, "M = 0");
    CHECK(taut_eigen_band(&p.k, &p.k, NULL, NULL, p.vectors) == TAUT_BAD_ARGUMENT, "values");
    other.a[4] = INFINITY;
    CHECK(taut_eigen_band(&other, &p.m, NULL, p.values, p.vectors) == TAUT_BAD_ARGUMENT,
          "not finite");
    CHECK(p.values[0] == 7.0, "outputs are untouched on failure");
    taut_band_clear(&other);
    problem_clear(&p);
}

int main(void)
{
    random_seed(13);
    test_linear_elements();
    test_spline_pencils();
    test_multiple_eigenvalues();
    test_refusals();
    return check_failures != 0;
}
