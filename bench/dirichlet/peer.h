/* peer.h -- the same linear system for each library:  K X M + M X K = R. */
#ifndef TAUT_BENCH_DIRICHLET_PEER_H
#define TAUT_BENCH_DIRICHLET_PEER_H

#include "numeric/band.h"

typedef struct peer_task {
    int n;               /* unknowns per direction */
    taut_band k, m;      /* of both directions */
    const double *right; /* double[n][n][3] */
} peer_task;

/* Each goes from the banded matrices to x double[n][n][3] and returns the CPU seconds; negative: it
 * failed. */

/* The n^2 x n^2 matrix assembled and factored by CHOLMOD's supernodal method, its ordering of
 * choice. */
double peer_cholmod(const peer_task *task, double *x);
/* Fast diagonalisation: dsygvd for both directions, two matrix products there and two back. */
double peer_lapack(const peer_task *task, double *x);

/* Operations a second of a square dgemm of this size, and the name of the kernels in use. */
double peer_gemm_rate(int n);
const char *peer_blas_core(void);

#endif /* TAUT_BENCH_DIRICHLET_PEER_H */
