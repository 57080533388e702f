#include "machine.h"
#include "peer.h"

#include <cholmod.h>

static int least(int a, int b)
{
    return a < b ? a : b;
}

/* The lower triangle of K (x) M + M (x) K by columns; row and column of unknown (i, j) is i n + j.
 */
static cholmod_sparse *assemble(const peer_task *task, cholmod_common *common)
{
    const int n = task->n, w = task->k.width;
    const size_t size = (size_t)n * (size_t)n, span = 2 * (size_t)w + 1;
    cholmod_sparse *a = cholmod_allocate_sparse(size, size, size * (span * span / 2 + 1), 1, 1, -1,
                                                CHOLMOD_REAL, common);
    if (a == NULL) {
        return NULL;
    }
    int *start = a->p, *row = a->i, at = 0;
    double *value = a->x;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            start[i * n + j] = at;
            for (int s = i; s <= least(i + w, n - 1); s++) {
                const double ku = taut_band_at(&task->k, i, s), mu = taut_band_at(&task->m, i, s);
                for (int t = s > i ? (j > w ? j - w : 0) : j; t <= least(j + w, n - 1); t++) {
                    row[at] = s * n + t;
                    value[at++] =
                        ku * taut_band_at(&task->m, j, t) + mu * taut_band_at(&task->k, j, t);
                }
            }
        }
    }
    start[size] = at;
    return a;
}

double peer_cholmod(const peer_task *task, double *x)
{
    const double begun = bench_cpu_seconds();
    const size_t size = (size_t)task->n * (size_t)task->n;
    cholmod_common common;
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.print = 0;
    cholmod_sparse *a = assemble(task, &common);
    cholmod_factor *factor = a == NULL ? NULL : cholmod_analyze(a, &common);
    cholmod_dense *right = cholmod_allocate_dense(size, 3, size, CHOLMOD_REAL, &common),
                  *solution = NULL;
    if (factor != NULL && right != NULL && cholmod_factorize(a, factor, &common) &&
        factor->minor == size) {
        for (size_t i = 0; i < size; i++) {
            for (size_t c = 0; c < 3; c++) {
                ((double *)right->x)[c * size + i] = task->right[3 * i + c];
            }
        }
        solution = cholmod_solve(CHOLMOD_A, factor, right, &common);
    }
    for (size_t i = 0; i < size && solution != NULL; i++) {
        for (size_t c = 0; c < 3; c++) {
            x[3 * i + c] = ((const double *)solution->x)[c * size + i];
        }
    }
    const int is_solved = solution != NULL;
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&right, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_free_sparse(&a, &common);
    cholmod_finish(&common);
    return is_solved ? bench_cpu_seconds() - begun : -1.0;
}
