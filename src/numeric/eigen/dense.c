/* dense.c -- all eigenpairs by the methods for full matrices: slow, and sure. */
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "numeric/eigen/internal.h"

#include <math.h>
#include <string.h>

enum { QL_STEPS_MAX = 60 };

static double *entry_at(double *a, int n, int i, int j)
{
    return a + (size_t)i * (size_t)n + (size_t)j;
}

/* a = L^-1 K L^-T for M = L L^T: columns by forward substitution, then rows, by symmetry the same
 * loop on the transpose. `l` is the banded factor L D L^T of M, used as (L D^(1/2)). */
static void reduce_pencil(const taut_band *l, double *a)
{
    const int n = l->n, w = l->width;
    for (int pass = 0; pass < 2; pass++) {
        for (int j = 0; j < n; j++) {
            for (int i = 0; i < n; i++) {
                double *row =
                    entry_at(a, n, j, 0); /* symmetric before, transposed after the first pass */
                double sum = row[i];
                for (int d = 1; d <= w && d <= i; d++) {
                    sum -= taut_band_row(l, i)[d] * sqrt(taut_band_row(l, i - d)[0]) * row[i - d];
                }
                row[i] = sum / sqrt(taut_band_row(l, i)[0]);
            }
        }
        for (int j = 0; j < n; j++) {
            for (int i = 0; i < j; i++) {
                const double swap = *entry_at(a, n, i, j);
                *entry_at(a, n, i, j) = *entry_at(a, n, j, i);
                *entry_at(a, n, j, i) = swap;
            }
        }
    }
}

/* a = Q T Q^T, T tridiagonal: diagonal d[n], off-diagonal e[n-1] (e[n-1] is scratch). Row i of `a`
 * is left as the i-th row of Q^T. Householder vectors v annihilate row by row: H = I - beta v v^T.
 */
static void tridiagonalise(int n, double *a, double *d, double *e, double *v, double *p, double *q)
{
    memset(q, 0, (size_t)n * (size_t)n * sizeof *q);
    for (int i = 0; i < n; i++) {
        *entry_at(q, n, i, i) = 1.0;
    }
    for (int k = 0; k < n - 1; k++) {
        double norm = 0.0;
        for (int i = k + 1; i < n; i++) {
            v[i] = *entry_at(a, n, k, i);
            norm = taut_hypot(norm, v[i]);
        }
        const double alpha = v[k + 1] > 0.0 ? -norm : norm;
        d[k] = *entry_at(a, n, k, k);
        e[k] = norm > 0.0 ? alpha : 0.0;
        v[k + 1] -= alpha;
        double vv = 0.0;
        for (int i = k + 1; i < n; i++) {
            vv += v[i] * v[i];
        }
        if (!(vv > 0.0)) {
            continue;
        }
        /* A <- H A H = A - v r^T - r v^T with r = beta A v - (beta^2 v.A v / 2) v */
        const double beta = 2.0 / vv;
        double vp = 0.0;
        for (int i = k + 1; i < n; i++) {
            p[i] = 0.0;
            for (int j = k + 1; j < n; j++) {
                p[i] += *entry_at(a, n, i, j) * v[j];
            }
            p[i] *= beta;
            vp += v[i] * p[i];
        }
        for (int i = k + 1; i < n; i++) {
            p[i] -= 0.5 * beta * vp * v[i];
        }
        for (int i = k + 1; i < n; i++) {
            for (int j = k + 1; j < n; j++) {
                *entry_at(a, n, i, j) -= v[i] * p[j] + p[i] * v[j];
            }
        }
        /* Q^T <- H Q^T */
        memset(p, 0, (size_t)n * sizeof *p);
        for (int i = k + 1; i < n; i++) {
            for (int j = 0; j < n; j++) {
                p[j] += v[i] * *entry_at(q, n, i, j);
            }
        }
        for (int i = k + 1; i < n; i++) {
            for (int j = 0; j < n; j++) {
                *entry_at(q, n, i, j) -= beta * v[i] * p[j];
            }
        }
    }
    d[n - 1] = *entry_at(a, n, n - 1, n - 1);
    e[n - 1] = 0.0;
}

/* One implicit QL sweep on rows l..m of T, shifted towards d[l] (Wilkinson), rotations applied to
 * q. */
static void ql_sweep(int n, int l, int m, double *d, double *e, double *q)
{
    double g = (d[l + 1] - d[l]) / (2.0 * e[l]);
    g = d[m] - d[l] + e[l] / (g + copysign(taut_hypot(g, 1.0), g));
    double s = 1.0, c = 1.0, p = 0.0;
    for (int i = m - 1; i >= l; i--) {
        const double f = s * e[i], b = c * e[i], r = taut_hypot(f, g);
        e[i + 1] = r;
        if (!(r > 0.0)) {
            d[i + 1] -= p;
            e[m] = 0.0;
            return;
        }
        s = f / r;
        c = g / r;
        g = d[i + 1] - p;
        const double t = (d[i] - g) * s + 2.0 * c * b;
        p = s * t;
        d[i + 1] = g + p;
        g = c * t - b;
        for (int j = 0; j < n; j++) {
            const double upper = *entry_at(q, n, i, j), lower = *entry_at(q, n, i + 1, j);
            *entry_at(q, n, i + 1, j) = s * upper + c * lower;
            *entry_at(q, n, i, j) = c * upper - s * lower;
        }
    }
    d[l] -= p;
    e[l] = g;
    e[m] = 0.0;
}

static int diagonalise(int n, double *d, double *e, double *q)
{
    for (int l = 0; l < n; l++) {
        for (int steps = 0;; steps++) {
            int m = l;
            while (m < n - 1 && fabs(e[m]) > TAUT_UNIT_ROUNDOFF * (fabs(d[m]) + fabs(d[m + 1]))) {
                m++;
            }
            if (m == l) {
                break;
            }
            if (steps == QL_STEPS_MAX) {
                return 0;
            }
            ql_sweep(n, l, m, d, e, q);
        }
    }
    return 1;
}

/* Ascending, rows of q along with d. */
static void sort_pairs(int n, double *d, double *q)
{
    for (int i = 0; i < n - 1; i++) {
        int least = i;
        for (int j = i + 1; j < n; j++) {
            least = d[j] < d[least] ? j : least;
        }
        const double swap = d[i];
        d[i] = d[least];
        d[least] = swap;
        for (int j = 0; j < n && least != i; j++) {
            const double entry = *entry_at(q, n, i, j);
            *entry_at(q, n, i, j) = *entry_at(q, n, least, j);
            *entry_at(q, n, least, j) = entry;
        }
    }
}

/* x = L^-T y for each row y of q. */
static void back_transform(const taut_band *l, double *q)
{
    const int n = l->n, w = l->width;
    for (int j = 0; j < n; j++) {
        double *x = entry_at(q, n, j, 0);
        for (int i = n - 1; i >= 0; i--) {
            x[i] /= sqrt(taut_band_row(l, i)[0]);
            for (int d = 1; d <= w && i + d < n; d++) {
                x[i] -= taut_band_row(l, i + d)[d] * x[i + d];
            }
        }
    }
}

taut_status taut_eigen_dense(const taut_pencil *pencil, taut_arena *arena, taut_eigenpairs *pairs)
{
    double *values = pairs->values, *vectors = pairs->vectors;
    const int n = pencil->k.n;
    const size_t size = (size_t)n;
    const taut_band *m = &pencil->m;
    taut_band l = {n, m->width,
                   taut_arena_copy(arena, m->a, size * ((size_t)m->width + 1), sizeof *m->a)};
    double *a = taut_arena_take(arena, size * size, sizeof *a);
    double *scratch = taut_arena_take(arena, 3 * size, sizeof *scratch);
    taut_status status = taut_arena_status(arena);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_band_factor(&l);
    if (status != TAUT_OK) {
        return status;
    }
    for (int i = 0; i < n; i++) {
        for (int d = 0; d <= pencil->k.width && d <= i; d++) {
            *entry_at(a, n, i, i - d) = *entry_at(a, n, i - d, i) = taut_band_row(&pencil->k, i)[d];
        }
    }
    reduce_pencil(&l, a);
    tridiagonalise(n, a, values, scratch, scratch + size, scratch + 2 * size, vectors);
    if (!diagonalise(n, values, scratch, vectors)) {
        return TAUT_NOT_CONVERGED;
    }
    sort_pairs(n, values, vectors);
    back_transform(&l, vectors);
    return TAUT_OK;
}
