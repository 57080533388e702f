/* orthogonalise.c -- vectors with close values, made M-orthogonal.
 *
 * Exact eigenvectors are M-orthogonal; computed ones are so up to the rounding error of K x -
 * lambda M x over the distance of their values ([Parlett1998] 11.7.1). Pairs nearer than that
 * allows are orthogonalised by Gram-Schmidt: x_j loses its parts along the earlier vectors of its
 * neighbourhood. */
#include "numeric/eigen/internal.h"

#include "core/constants.h"
#include <math.h>
#include <stdint.h>
#include <string.h>

/* Largest loss of orthogonality left to itself, as bounded by the worst case; rounding errors have
 * random signs, so what is seen is smaller by about sqrt(n). */
static const double tolerated = 0x1p-46;

enum { STEPS = 6 }; /* of inverse iteration, for a vector that is computed again */

/* M by diagonals: a[d*n + i] = M(i, i-d), so that products run along vectors. */
typedef struct taut_diagonals {
    const taut_kernel *kernel;
    size_t n, width;
    double *a;
} taut_diagonals;

static taut_diagonals diagonals_of(const taut_pencil *pencil, taut_arena *arena)
{
    const size_t n = (size_t)pencil->m.n, slots = (size_t)pencil->m.width + 1;
    double *a = taut_arena_take(arena, n * slots, sizeof *a);
    for (size_t i = 0; a != NULL && i < n * slots; i++) {
        a[i % slots * n + i / slots] = pencil->m.a[i];
    }
    return (taut_diagonals){pencil->kernel, n, slots - 1, a};
}

/* Takes the parts along vectors first..j-1 out of x, then M-normalises x; mx is scratch. Returns
 * the share of x, by M-norm, that was left. */
static double purge_vector(const taut_diagonals *m, const taut_eigenpairs *pairs, int first, int j,
                           double *x, double *mx)
{
    const taut_kernel *kernel = m->kernel;
    kernel->diagonals_multiply(m->n, m->width, m->a, x, mx);
    const double before = sqrt(kernel->dot(m->n, x, mx));
    int changed = 0;
    for (int i = first; i < j; i++) {
        const double *xi = taut_eigen_vector(pairs, i);
        const double part = kernel->dot(m->n, xi, mx);
        if (fabs(part) > 4.0 * TAUT_UNIT_ROUNDOFF * before) {
            changed = 1;
            kernel->add_scaled(m->n, -part, xi, x);
        }
    }
    double after = before;
    if (changed) {
        kernel->diagonals_multiply(m->n, m->width, m->a, x, mx);
        after = sqrt(kernel->dot(m->n, x, mx));
    }
    for (size_t i = 0; i < m->n; i++) {
        x[i] /= after;
    }
    return after / before;
}

/* Banded L U with row interchanges ([GolubVanLoan2013] 4.3.4): row i of `u` starts at column i -
 * width before and at column i after elimination. */
struct pivoted {
    int n, width;
    double *u;     /* double[n][3*width + 1] */
    double *l;     /* double[n][width]: multipliers of column i */
    int *exchange; /* int[n]: the row that came to place i */
};

static void factor_pivoted(const taut_pencil *pencil, double shift, struct pivoted *f)
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
        if (fabs(row[0]) < TAUT_UNIT_ROUNDOFF * TAUT_UNIT_ROUNDOFF * pencil->norm) {
            row[0] = TAUT_UNIT_ROUNDOFF * TAUT_UNIT_ROUNDOFF * pencil->norm;
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

static void solve_pivoted(const struct pivoted *f, double *x)
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
static void measure_pair(const taut_pencil *pencil, int j, taut_eigenpairs *pairs, double *r,
                         double *t)
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

/* Computes values[j] and vectors[j] again by inverse iteration with row interchanges near
 * values[j], kept M-orthogonal to vectors first..j-1: the slow way, for those that the fast one
 * missed. `scratch` is double[2][n]. */
static void recompute_pair(const taut_pencil *pencil, const taut_diagonals *m, int first, int j,
                           struct pivoted *factor, double *scratch, taut_eigenpairs *pairs)
{
    const size_t n = (size_t)pairs->n;
    double *x = taut_eigen_vector(pairs, j);
    for (size_t i = 0; i < n; i++) {
        x[i] = taut_eigen_scatter((uint64_t)j * n + i);
    }
    factor_pivoted(pencil, pairs->values[j], factor);
    for (int step = 0; step < STEPS; step++) {
        purge_vector(m, pairs, first, j, x, scratch);
        memset(scratch, 0, n * sizeof *scratch);
        taut_band_multiply_add(&pencil->m, 1.0, x, scratch);
        solve_pivoted(factor, scratch);
        memcpy(x, scratch, n * sizeof *x);
    }
    purge_vector(m, pairs, first, j, x, scratch);
    purge_vector(m, pairs, first, j, x, scratch);
    measure_pair(pencil, j, pairs, scratch, scratch + n);
}

/* The first vector that x_j has to be orthogonalised against; j when none. */
static int first_neighbour(const taut_eigenpairs *pairs, int j)
{
    int first = j;
    const double noise = TAUT_UNIT_ROUNDOFF * pairs->noise[j];
    while (first > 0 && pairs->values[j] - pairs->values[first - 1] <=
                            (noise + TAUT_UNIT_ROUNDOFF * pairs->noise[first - 1]) / tolerated) {
        first--;
    }
    return first;
}

taut_status taut_eigen_orthogonalise(const taut_pencil *pencil, taut_arena *arena,
                                     taut_eigenpairs *pairs)
{
    const size_t n = (size_t)pairs->n, w = (size_t)pencil->k.width;
    const taut_diagonals m = diagonals_of(pencil, arena);
    double *scratch = taut_arena_take(arena, 2 * n, sizeof *scratch);
    struct pivoted factor = {
        pairs->n, pencil->k.width, taut_arena_take(arena, n * (3 * w + 1), sizeof(double)),
        taut_arena_take(arena, n * w, sizeof(double)), taut_arena_take(arena, n, sizeof(int))};
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int j = 1; j < pairs->n; j++) {
        const int first = first_neighbour(pairs, j);
        if (first == j) {
            continue;
        }
        if (taut_pulse_beat(pencil->pulse, 8.0 * (double)n * (double)((size_t)(j - first) + w))) {
            return TAUT_INTERRUPTED;
        }
        const double left = purge_vector(&m, pairs, first, j, taut_eigen_vector(pairs, j), scratch);
        if (!(left > 0.5)) {
            recompute_pair(pencil, &m, first, j, &factor, scratch, pairs);
        } else if (left < 1.0 - 0x1p-20) {
            purge_vector(&m, pairs, first, j, taut_eigen_vector(pairs, j), scratch);
        }
    }
    return TAUT_OK;
}
