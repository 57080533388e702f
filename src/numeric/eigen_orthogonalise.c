/* Exact eigenvectors are M-orthogonal; computed ones are so up to the rounding error of K x -
 * lambda M x over the distance of their values ([Parlett1998] 11.7.1). Pairs nearer than that
 * allows are orthogonalised by Gram-Schmidt: x_j loses its parts along the earlier vectors of its
 * neighbourhood. */
#include "numeric/eigen_internal.h"

#include "core/memory.h"

#include <math.h>
#include <string.h>

/* Largest loss of orthogonality left to itself, as bounded by the worst case; rounding errors have
 * random signs, so what is seen is smaller by about sqrt(n). */
static const double tolerated = 0x1p-46;

static const double unit_roundoff = 0x1p-53;

enum { MEND_STEPS = 6 };

static double dot(int n, const double *x, const double *y)
{
    double sum[4] = {0};
    int i = 0;
    for (; i + 4 <= n; i += 4) {
        for (int l = 0; l < 4; l++) {
            sum[l] += x[i + l] * y[i + l];
        }
    }
    for (; i < n; i++) {
        sum[0] += x[i] * y[i];
    }
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

static double *vector(const taut_eigenpairs *pairs, int j)
{
    return pairs->vectors + (size_t)j * (size_t)pairs->n;
}

/* Takes the parts along vectors first..j-1 out of x, then M-normalises x; mx is scratch. Returns
 * the share of x, by M-norm, that was left. */
static double purge(const taut_pencil *pencil, const taut_eigenpairs *pairs, int first, int j,
                    double *x, double *mx)
{
    const int n = pairs->n;
    memset(mx, 0, (size_t)n * sizeof *mx);
    taut_band_multiply_add(&pencil->m, 1.0, x, mx);
    const double before = sqrt(dot(n, x, mx));
    int changed = 0;
    for (int i = first; i < j; i++) {
        const double *xi = vector(pairs, i);
        const double part = dot(n, xi, mx);
        if (fabs(part) > 4.0 * unit_roundoff * before) {
            changed = 1;
            for (int r = 0; r < n; r++) {
                x[r] -= part * xi[r];
            }
        }
    }
    double after = before;
    if (changed) {
        memset(mx, 0, (size_t)n * sizeof *mx);
        taut_band_multiply_add(&pencil->m, 1.0, x, mx);
        after = sqrt(dot(n, x, mx));
    }
    for (int r = 0; r < n; r++) {
        x[r] /= after;
    }
    return after / before;
}

/* The first vector that x_j has to be orthogonalised against; j when none. */
static int neighbourhood(const taut_eigenpairs *pairs, int j)
{
    int first = j;
    const double noise = unit_roundoff * pairs->noise[j];
    while (first > 0 && pairs->values[j] - pairs->values[first - 1] <=
                            (noise + unit_roundoff * pairs->noise[first - 1]) / tolerated) {
        first--;
    }
    return first;
}

taut_status taut_eigen_orthogonalise(const taut_pencil *pencil, taut_eigenpairs *pairs)
{
    double *mx = taut_alloc((size_t)pairs->n, sizeof *mx);
    taut_status status = mx == NULL ? TAUT_NO_MEMORY : TAUT_OK;
    for (int j = 1; j < pairs->n && status == TAUT_OK; j++) {
        const int first = neighbourhood(pairs, j);
        if (first == j) {
            continue;
        }
        double left = purge(pencil, pairs, first, j, vector(pairs, j), mx);
        if (!(left > 0.5)) {
            status = taut_eigen_mend(pencil, first, j, pairs);
        } else if (left < 1.0 - 0x1p-20) {
            purge(pencil, pairs, first, j, vector(pairs, j), mx);
        }
    }
    taut_free(mx);
    return status;
}

/* Banded L U with row interchanges ([GolubVanLoan2013] 4.3.4): row i of `u` starts at column i -
 * width before and at column i after elimination. */
typedef struct pivoted {
    int n, width;
    double *u;     /* double[n][3*width + 1] */
    double *l;     /* double[n][width]: multipliers of column i */
    int *exchange; /* int[n]: the row that came to place i */
} pivoted;

static void pivoted_factor(const taut_pencil *pencil, double shift, pivoted *f)
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
            const double m = below[0] / row[0];
            f->l[(size_t)i * (size_t)w + (size_t)(r - i - 1)] = m;
            for (int c = 1; c < length; c++) {
                below[c - 1] = below[c] - m * row[c];
            }
            below[length - 1] = 0.0;
        }
    }
}

static void pivoted_solve(const pivoted *f, double *x)
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
    const double *x = vector(pairs, j);
    memset(r, 0, (size_t)n * sizeof *r);
    taut_band_multiply_add(&pencil->k, 1.0, x, r);
    const double lambda = dot(n, x, r);
    taut_band_multiply_add(&pencil->m, -lambda, x, r);
    pairs->values[j] = lambda;
    pairs->residual[j] = sqrt(dot(n, r, r));
    for (int i = 0; i < n; i++) {
        r[i] = fabs(x[i]);
        t[i] = 0.0;
    }
    taut_band_multiply_add(&pencil->abs_k, 1.0, r, t);
    taut_band_multiply_add(&pencil->abs_m, fabs(lambda), r, t);
    pairs->noise[j] = sqrt(dot(n, t, t));
}

taut_status taut_eigen_mend(const taut_pencil *pencil, int first, int j, taut_eigenpairs *pairs)
{
    const size_t n = (size_t)pairs->n, w = (size_t)pencil->k.width;
    taut_status status = TAUT_NO_MEMORY;
    double *scratch = taut_alloc(2 * n, sizeof *scratch);
    pivoted factor = {pairs->n, pencil->k.width, taut_alloc(n * (3 * w + 1), sizeof(double)),
                      taut_alloc(n * w, sizeof(double)), taut_alloc(n, sizeof(int))};
    if (scratch == NULL || factor.u == NULL || factor.l == NULL || factor.exchange == NULL) {
        goto done;
    }
    double *x = vector(pairs, j);
    for (size_t i = 0; i < n; i++) {
        x[i] = taut_eigen_scatter((unsigned long long)j * n + i);
    }
    pivoted_factor(pencil, pairs->values[j], &factor);
    for (int step = 0; step < MEND_STEPS; step++) {
        purge(pencil, pairs, first, j, x, scratch);
        memset(scratch, 0, n * sizeof *scratch);
        taut_band_multiply_add(&pencil->m, 1.0, x, scratch);
        pivoted_solve(&factor, scratch);
        memcpy(x, scratch, n * sizeof *x);
    }
    purge(pencil, pairs, first, j, x, scratch);
    purge(pencil, pairs, first, j, x, scratch);
    measure(pencil, j, pairs, scratch, scratch + n);
    status = TAUT_OK;

done:
    taut_free(factor.exchange);
    taut_free(factor.l);
    taut_free(factor.u);
    taut_free(scratch);
    return status;
}
