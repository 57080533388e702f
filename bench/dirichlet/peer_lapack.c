#include "machine.h"
#include "peer.h"

#include <cblas.h>
#include <lapacke.h>
#include <stdlib.h>
#include <string.h>

char *openblas_get_corename(void);

/* Eigenvectors as columns of v (column-major), values in lambda. */
static int diagonalise(const taut_band *k, const taut_band *m, double *v, double *mass,
                       double *lambda)
{
    const size_t n = (size_t)k->n;
    memset(v, 0, n * n * sizeof *v);
    memset(mass, 0, n * n * sizeof *mass);
    for (int i = 0; i < k->n; i++) {
        for (int d = 0; d <= k->width && d <= i; d++) {
            v[(size_t)(i - d) * n + (size_t)i] = taut_band_row(k, i)[d];
            mass[(size_t)(i - d) * n + (size_t)i] = taut_band_row(m, i)[d];
        }
    }
    return LAPACKE_dsygvd(LAPACK_COL_MAJOR, 1, 'V', 'L', k->n, v, k->n, mass, k->n, lambda) == 0;
}

static void product(CBLAS_TRANSPOSE ta, CBLAS_TRANSPOSE tb, int n, const double *a, const double *b,
                    double *c)
{
    cblas_dgemm(CblasColMajor, ta, tb, n, n, n, 1.0, a, n, b, n, 0.0, c, n);
}

double peer_lapack(const peer_task *task, double *x)
{
    const double begun = bench_cpu_seconds();
    const int n = task->n;
    const size_t square = (size_t)n * (size_t)n;
    double *block = malloc((5 * square + 2 * (size_t)n) * sizeof *block);
    if (block == NULL) {
        return -1.0;
    }
    double *vu = block, *vv = vu + square, *a = vv + square, *b = a + square, *mass = b + square;
    double *lambda = mass + square, *mu = lambda + n;
    const int is_solved = diagonalise(&task->k, &task->m, vu, mass, lambda) &&
                          diagonalise(&task->k, &task->m, vv, mass, mu);
    for (size_t c = 0; c < 3 && is_solved; c++) {
        for (size_t i = 0; i < square; i++) { /* seen by columns, a is the transposed net */
            a[i] = task->right[3 * i + c];
        }
        product(CblasTrans, CblasNoTrans, n, vv, a, b);
        product(CblasNoTrans, CblasNoTrans, n, b, vu, a);
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                a[i * n + j] /= lambda[i] + mu[j];
            }
        }
        product(CblasNoTrans, CblasNoTrans, n, vv, a, b);
        product(CblasNoTrans, CblasTrans, n, b, vu, a);
        for (size_t i = 0; i < square; i++) {
            x[3 * i + c] = a[i];
        }
    }
    free(block);
    return is_solved ? bench_cpu_seconds() - begun : -1.0;
}

double peer_gemm_rate(int n)
{
    const size_t square = (size_t)n * (size_t)n;
    double *a = malloc(3 * square * sizeof *a), best = 0.0;
    for (size_t i = 0; a != NULL && i < 3 * square; i++) {
        a[i] = (double)(i % 7);
    }
    for (int round = 0; round < 3 && a != NULL; round++) {
        const double begun = bench_cpu_seconds();
        product(CblasNoTrans, CblasNoTrans, n, a, a + square, a + 2 * square);
        const double rate = 2.0 * n * n * n / (bench_cpu_seconds() - begun);
        best = rate > best ? rate : best;
    }
    free(a);
    return best;
}

const char *peer_blas_core(void)
{
    return openblas_get_corename();
}
