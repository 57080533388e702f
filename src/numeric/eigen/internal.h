/* internal.h -- the parts of band.h. All work on a scaled pencil: M(i,i) = 1, and take their scratch
 * from the arena of the call. */
#ifndef TAUT_NUMERIC_EIGEN_INTERNAL_H
#define TAUT_NUMERIC_EIGEN_INTERNAL_H

#include "core/arena.h"
#include "core/pulse.h"
#include "numeric/band.h"
#include "numeric/kernel/kernel.h"

#include <stdint.h>

/* K - lambda M with M(i,i) = 1, equal widths. */
typedef struct taut_pencil {
    taut_band k, m;         /* K, M */
    taut_band abs_k, abs_m; /* |K|, |M|: what rounding errors are measured by */
    double norm;            /* max |K(i,j)| + max |M(i,j)|, > 0 */
    double tiny;            /* pivots nearer to zero are not divided by */
    const taut_kernel *kernel;
    taut_pulse *pulse; /* or NULL */
} taut_pencil;

/* Tells of so many factors of the pencil, all lanes of them. */
static inline int taut_pencil_beat(const taut_pencil *pencil, int factors)
{
    const double slots = pencil->k.width + 1;
    return taut_pulse_beat(pencil->pulse,
                           factors * TAUT_LANES * slots * slots * (double)pencil->k.n);
}

/* Eigenpairs on the way. */
typedef struct taut_eigenpairs {
    int n;
    double *values;   /* double[n], ascending */
    double *vectors;  /* double[n][n], row j belongs to values[j]; x.(M x) = 1 */
    double *noise;    /* double[n]: ||(|K| + |lambda| |M|) |x|||, rounding moves K x - lambda M x by
                         some u times it */
    double *residual; /* double[n]: ||(K - lambda M) x|| */
} taut_eigenpairs;

/* Where one eigenvalue lies: between low and high; `below` of all eigenvalues are < low, and
 * `inside` of them, counting itself, are in between. inside > 1 when they could not be told apart.
 */
typedef struct taut_bracket {
    double low, high;
    double low_log, high_log; /* log2 |det (K - s M)| at the ends, up to a constant */
    double guess;             /* the best value known, low < guess < high */
    int below, inside;
} taut_bracket;

/* Counts eigenvalues below any number of shifts, many at a time. */
typedef struct taut_counter {
    const taut_pencil *pencil;
    double *factor; /* scratch */
} taut_counter;

/* Takes the scratch; the arena's status tells whether it is there. */
taut_counter taut_counter_of(const taut_pencil *pencil, taut_arena *arena);
/* count[i] = eigenvalues below shift[i], log[i] = log2 |det (K - shift[i] M)|, i < shifts. TAUT_OK or TAUT_INTERRUPTED. */
taut_status taut_counter_run(const taut_counter *counter, int shifts, const double *shift,
                             int *count, double *log);

/* One bracket per eigenvalue in ascending order, into bracket[n]. TAUT_OK, TAUT_NO_MEMORY, or
 * TAUT_NOT_CONVERGED when the counts contradict each other. */
taut_status taut_eigen_isolate(const taut_pencil *pencil, taut_arena *arena, taut_bracket *bracket);

/* The j-th of `parts` - 1 places to cut a bracket: even steps of sqrt(s), in which the eigenvalues
 * of second order operators lie evenly, or of log(s) where the ends differ much. */
double taut_eigen_place(const taut_bracket *bracket, int j, int parts);

/* Better guesses, by the determinant as a function of the shift. TAUT_OK or TAUT_NO_MEMORY. */
taut_status taut_eigen_sharpen(const taut_pencil *pencil, taut_arena *arena, taut_bracket *bracket);

/* The distance of guess j to its neighbours; the length of its bracket when it has none. */
double taut_eigen_gap(int n, const taut_bracket *bracket, int j);

/* TAUT_LANES pairs at work. */
typedef struct taut_eigen_block {
    const taut_pencil *pencil;
    double *factor;    /* double[width + n][width + 1][lanes], the first rows zero; then scratch */
    double *x, *r, *m; /* double[n][lanes]: x, (K - lambda M) x, M x */
    double lambda[TAUT_LANES];
    double gap[TAUT_LANES]; /* about the distance of lambda to the next eigenvalue */
} taut_eigen_block;

/* Takes the scratch; the arena's status tells whether it is there. */
taut_eigen_block taut_eigen_block_of(const taut_pencil *pencil, taut_arena *arena);

/* Takes from each x the error that factors without row interchanges leave in it, moves lambda to
 * the Rayleigh quotient and stores the pairs as first..first+used-1, with their noise and residual.
 */
void taut_eigen_block_polish(taut_eigen_block *block, int first, int used, taut_eigenpairs *pairs);

/* Values and vectors by Rayleigh quotient iteration inside the brackets, polished; not yet in
 * order, orthogonalised or checked. TAUT_OK or TAUT_NO_MEMORY. */
taut_status taut_eigen_iterate(const taut_pencil *pencil, taut_arena *arena,
                               const taut_bracket *bracket, taut_eigenpairs *pairs);

/* Polishes pairs that come from elsewhere, values ascending. TAUT_OK or TAUT_NO_MEMORY. */
taut_status taut_eigen_polish(const taut_pencil *pencil, taut_arena *arena, taut_eigenpairs *pairs);

/* Makes vectors with close values M-orthogonal. Those that turn out to be copies of others are
 * computed again by inverse iteration with row interchanges. TAUT_OK or TAUT_NO_MEMORY. */
taut_status taut_eigen_orthogonalise(const taut_pencil *pencil, taut_arena *arena,
                                     taut_eigenpairs *pairs);

static inline double *taut_eigen_vector(const taut_eigenpairs *pairs, int j)
{
    return pairs->vectors + (size_t)j * (size_t)pairs->n;
}

/* Values and vectors by Cholesky reduction, Householder tridiagonalisation and QL iteration
 * ([GolubVanLoan2013] 8.7.2, 8.3.1, 8.3.3) in O(n^3). TAUT_OK, TAUT_NO_MEMORY, TAUT_NO_SOLUTION (M
 * not positive definite) or TAUT_NOT_CONVERGED. */
taut_status taut_eigen_dense(const taut_pencil *pencil, taut_arena *arena, taut_eigenpairs *pairs);

/* Numbers in [-1, 1) that depend on the seed only. */
double taut_eigen_scatter(uint64_t seed);

#endif /* TAUT_NUMERIC_EIGEN_INTERNAL_H */
