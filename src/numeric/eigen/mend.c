/* The slow way to one eigenvector, for those that the fast one missed. */
#include "numeric/eigen/internal.h"

#include "core/memory.h"

#include <math.h>
#include <string.h>

enum { STEPS = 6 };

static const double unit_roundoff = 0x1p-53;

/* Banded L U with row interchanges ([GolubVanLoan2013] 4.3.4): row i of `u` starts at column i -
 * width before and at column i after elimination. */
struct pivoted {
    int n, width;
    double *u;     /* double[n][3*width + 1] */
    double *l;     /* double[n][width]: multipliers of column i */
    int *exchange; /* int[n]: the row that came to place i */
};

static void pivoted_factor(const taut_pencil *pencil, double shift, struct pivoted *f)
{
    const int n = f->n, w = f->width, length = 3 * w + 1;
    for (int i = 0; i < n; i++) {
        double *row = f->u + (size_t)i * (size_t)length;
        /* rows below w start at column 0, later ones at column i - w */
        const int start = i < w ? 0 : i - w;
        for (int c = 0; c < length; c++) {
            const int j = start + c;
            row[c] = j < n ? taut_band_at(&pencil->k, i, j) - shift * taut_band_at(&pencil->m, i, j)
                           : 0.0;
        }
    }
    for (int i = 0; i < n; i++) {
        const int last = i + w < n ? i + w : n - 1;
        double *row = f->u + (size_t)i * (size_t)length;
        int best = i;
        for (int r = i + 1; r <= last; r++) {
            best =
                fabs(f->u[(size_t)r * (size_t)length]) > fabs(f->u[(size_t)best * (size_t)length])
                    ? r
                    : best;
        }
        f->exchange[i] = best;
        double *other = f->u + (size_t)best * (size_t)length;
        for (int c = 0; c < length && best != i; c++) {
            const double swap = row[c];
            row[c] = other[c];
            other[c] = swap;
        }
        if (fabs(row[0]) < unit_roundoff * unit_roundoff * pencil->norm) {
            row[0] = unit_roundoff * unit_roundoff * pencil->norm;
        }
        /* every row i+1..last starts at column i by now; eliminate and move it one column on */
        for (int r = i + 1; r <= last; r++) {
            double *below = f->u + (size_t)r * (size_t)length;
            const double factor = below[0] / row[0];
            f->l[(size_t)i * (size_t)w + (size_t)(r - i - 1)] = factor;
            for (int c = 1; c < length; c++) {
                below[c - 1] = below[c] - factor * row[c];
            }
            below[length - 1] = 0.0;
        }
    }
}

static void pivoted_solve(const struct pivoted *f, double *x)
{
    const int n = f->n, w = f->width, length = 3 * w + 1;
    for (int i = 0; i < n; i++) {
        const double swap = x[f->exchange[i]];
        x[f->exchange[i]] = x[i];
        x[i] = swap;
        for (int r = i + 1; r <= i + w && r < n; r++) {
            x[r] -= f->l[(size_t)i * (size_t)w + (size_t)(r - i - 1)] * swap;
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        const double *row = f->u + (size_t)i * (size_t)length;
        for (int c = 1; c < length && i + c < n; c++) {
            x[i] -= row[c] * x[i + c];
        }
        x[i] /= row[0];
    }
}

/* values[j], noise[j] and residual[j] from vectors[j]; r and t are scratch. */
static void measure(const taut_pencil *pencil, int j, taut_eigenpairs *pairs, double *r, double *t)
{
    const int n = pairs->n;
    const double *x = taut_eigen_vector(pairs, j);
    memset(r, 0, (size_t)n * sizeof *r);
    taut_band_multiply_add(&pencil->k, 1.0, x, r);
    const double lambda = pencil->kernel->dot((size_t)n, x, r);
    taut_band_multiply_add(&pencil->m, -lambda, x, r);
    pairs->values[j] = lambda;
    pairs->residual[j] = sqrt(pencil->kernel->dot((size_t)n, r, r));
    for (int i = 0; i < n; i++) {
        r[i] = fabs(x[i]);
        t[i] = 0.0;
    }
    taut_band_multiply_add(&pencil->abs_k, 1.0, r, t);
    taut_band_multiply_add(&pencil->abs_m, fabs(lambda), r, t);
    pairs->noise[j] = sqrt(pencil->kernel->dot((size_t)n, t, t));
}

taut_status taut_eigen_mend(const taut_pencil *pencil, const taut_diagonals *m, int first, int j,
                            taut_eigenpairs *pairs)
{
    const size_t n = (size_t)pairs->n, w = (size_t)pencil->k.width;
    taut_status status = TAUT_NO_MEMORY;
    double *scratch = taut_alloc(2 * n, sizeof *scratch);
    struct pivoted factor = {pairs->n, pencil->k.width, taut_alloc(n * (3 * w + 1), sizeof(double)),
                             taut_alloc(n * w, sizeof(double)), taut_alloc(n, sizeof(int))};
    if (scratch == NULL || factor.u == NULL || factor.l == NULL || factor.exchange == NULL) {
        goto done;
    }
    double *x = taut_eigen_vector(pairs, j);
    for (size_t i = 0; i < n; i++) {
        x[i] = taut_eigen_scatter((unsigned long long)j * n + i);
    }
    pivoted_factor(pencil, pairs->values[j], &factor);
    for (int step = 0; step < STEPS; step++) {
        taut_eigen_purge(m, pairs, first, j, x, scratch);
        memset(scratch, 0, n * sizeof *scratch);
        taut_band_multiply_add(&pencil->m, 1.0, x, scratch);
        pivoted_solve(&factor, scratch);
        memcpy(x, scratch, n * sizeof *x);
    }
    taut_eigen_purge(m, pairs, first, j, x, scratch);
    taut_eigen_purge(m, pairs, first, j, x, scratch);
    measure(pencil, j, pairs, scratch, scratch + n);
    status = TAUT_OK;

done:
    taut_free(factor.exchange);
    taut_free(factor.l);
    taut_free(factor.u);
    taut_free(scratch);
    return status;
}
