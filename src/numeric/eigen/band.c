/* band.c -- all eigenpairs of a banded symmetric pencil.
 *
 *     scale the pencil so that M(i,i) = 1
 *     isolate: bisect until each eigenvalue has a bracket of its own (isolate.c), by counting
 *         the negative pivots of K - s M for many shifts s at a time (count.c)
 *     sharpen: narrow the brackets by false position on det (K - s M) (sharpen.c)
 *     for lanes eigenvalues at a time:
 *         Rayleigh quotient iteration within the brackets (iterate.c)
 *         correct x by (K - s M) z = (K - lambda M) x, x -= z, until z is rounding (polish.c)
 *     sort the pairs
 *     for each x_j with close values before it (orthogonalise.c):
 *         take out its parts along their vectors
 *         if it was a copy of them: compute it again by inverse iteration with row interchanges
 *     sort the pairs, because that may move values
 *     if a bracket was not found, a residual is above its bound, or the x_j are not complete:
 *         Cholesky, Householder, QL (dense.c), then polish, sort and orthogonalise as above
 *         if a bound still fails: TAUT_CHECK_FAILED
 *     undo the scaling
 */
#include "numeric/eigen/band.h"

#include "core/arena.h"
#include "core/constants.h"
#include "numeric/eigen/internal.h"

#include <math.h>
#include <string.h>

/* What band.h promises. */
static const double residual_limit = 64 * TAUT_UNIT_ROUNDOFF;

/* For the sum of all that is lost to rounding and to orthogonality: twice the promise. */
static const double completeness_limit = 128 * TAUT_UNIT_ROUNDOFF;

static void clear_pencil(taut_pencil *pencil)
{
    taut_band_clear(&pencil->k);
    taut_band_clear(&pencil->m);
    taut_band_clear(&pencil->abs_k);
    taut_band_clear(&pencil->abs_m);
}

/* scaled = A(i,j) root[i] root[j], absolute = |scaled|, both new; *largest: of absolute. */
static taut_status scale_band(const taut_band *from, int width, const double *root,
                              taut_band *scaled, taut_band *absolute, double *largest)
{
    if (taut_band_widen(from, width, scaled) != TAUT_OK ||
        taut_band_widen(from, width, absolute) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < from->n; i++) {
        double *row = taut_band_row(scaled, i), *abs_row = taut_band_row(absolute, i);
        for (int d = 0; d <= width && d <= i; d++) {
            row[d] *= root[i] * root[i - d];
            abs_row[d] = fabs(row[d]);
            *largest = fmax(*largest, abs_row[d]);
        }
    }
    return TAUT_OK;
}

/* x of the pencil given is root x of the pencil made; clear it also after a failure. */
static taut_status scale_pencil(const taut_band *k, const taut_band *m, double *root,
                                taut_pencil *p)
{
    const int width = k->width > m->width ? k->width : m->width;
    double most_k = 0.0, most_m = 0.0;

    for (int i = 0; i < m->n; i++) {
        root[i] = 1.0 / sqrt(taut_band_row(m, i)[0]);
        if (!isfinite(root[i]) || !isfinite(root[i] * root[i])) {
            return TAUT_NO_SOLUTION;
        }
    }
    if (scale_band(k, width, root, &p->k, &p->abs_k, &most_k) != TAUT_OK ||
        scale_band(m, width, root, &p->m, &p->abs_m, &most_m) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    p->kernel = taut_kernel_best();
    p->norm = most_k + most_m;
    p->tiny = 0x1p-200 * p->norm;
    return isfinite(p->norm * p->norm) ? TAUT_OK : TAUT_BAD_ARGUMENT;
}

static taut_status check_definite(const taut_band *m)
{
    taut_band factor = {0, 0, NULL};
    taut_status status = taut_band_widen(m, m->width, &factor);
    if (status == TAUT_OK) {
        status = taut_band_factor(&factor);
    }
    taut_band_clear(&factor);
    return status;
}

/* Ascending by insertion: polished values are all but sorted. A vector is moved when its value is;
 * `held` is double[n]. */
static void sort_pairs(taut_eigenpairs *pairs, double *held)
{
    const size_t n = (size_t)pairs->n;
    for (size_t j = 1; j < n; j++) {
        size_t to = j;
        while (to > 0 && pairs->values[to - 1] > pairs->values[j]) {
            to--;
        }
        if (to == j) {
            continue;
        }
        double *const single[] = {pairs->values, pairs->noise, pairs->residual};
        for (size_t s = 0; s < sizeof single / sizeof *single; s++) {
            const double value = single[s][j];
            memmove(single[s] + to + 1, single[s] + to, (j - to) * sizeof(double));
            single[s][to] = value;
        }
        double *x = pairs->vectors;
        memcpy(held, x + j * n, n * sizeof *x);
        memmove(x + (to + 1) * n, x + to * n, (j - to) * n * sizeof *x);
        memcpy(x + to * n, held, n * sizeof *x);
    }
}

/* Are the x_j a complete M-orthonormal set? Then sum_j x_j (x_j . M v) = v for any v: one scattered
 * v tells, for a missing or doubled vector leaves a part of v behind. `scratch` is double[3][n]. */
static int is_complete(const taut_pencil *pencil, const taut_eigenpairs *pairs, double *scratch)
{
    const taut_kernel *kernel = pencil->kernel;
    const size_t n = (size_t)pairs->n;
    double *v = scratch, *mv = scratch + n, *rest = scratch + 2 * n;
    double longest = 1.0;

    memset(mv, 0, n * sizeof *mv);
    for (size_t i = 0; i < n; i++) {
        v[i] = rest[i] = taut_eigen_scatter(i + 1);
    }
    taut_band_multiply_add(&pencil->m, 1.0, v, mv);
    for (size_t j = 0; j < n; j++) {
        const double *x = pairs->vectors + j * n;
        longest = fmax(longest, kernel->dot(n, x, x));
        kernel->add_scaled(n, -kernel->dot(n, x, mv), x, rest);
    }
    return sqrt(kernel->dot(n, rest, rest)) <=
           completeness_limit * longest * sqrt((double)n * kernel->dot(n, v, v));
}

static int is_right(const taut_pencil *pencil, const taut_eigenpairs *pairs, double *scratch)
{
    for (int j = 0; j < pairs->n; j++) {
        if (!(pairs->residual[j] <= residual_limit * pairs->noise[j])) {
            return 0;
        }
    }
    return is_complete(pencil, pairs, scratch);
}

/* Puts pairs in order, orthogonalises them, and puts them in order again, for that may move values.
 */
static taut_status finish_pairs(const taut_pencil *pencil, taut_arena *arena,
                                taut_eigenpairs *pairs)
{
    double *held = taut_arena_take(arena, (size_t)pairs->n, sizeof *held);
    if (held == NULL) {
        return TAUT_NO_MEMORY;
    }
    sort_pairs(pairs, held);
    if (taut_eigen_orthogonalise(pencil, arena, pairs) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    sort_pairs(pairs, held);
    return TAUT_OK;
}

/* The fast way. */
static taut_status solve_banded(const taut_pencil *pencil, taut_arena *arena, taut_bracket *bracket,
                                taut_eigenpairs *pairs)
{
    const taut_status status = taut_eigen_isolate(pencil, arena, bracket);
    if (status != TAUT_OK) {
        return status;
    }
    if (taut_eigen_sharpen(pencil, arena, bracket) != TAUT_OK ||
        taut_eigen_iterate(pencil, arena, bracket, pairs) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    return finish_pairs(pencil, arena, pairs);
}

/* The sure way. */
static taut_status solve_dense(const taut_pencil *pencil, taut_arena *arena, taut_eigenpairs *pairs)
{
    const taut_status status = taut_eigen_dense(pencil, arena, pairs);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_eigen_polish(pencil, arena, pairs) == TAUT_OK ? finish_pairs(pencil, arena, pairs)
                                                              : TAUT_NO_MEMORY;
}

/* Back to the pencil given. */
static void unscale_vectors(taut_eigenpairs *pairs, const double *root)
{
    const size_t n = (size_t)pairs->n;
    for (size_t j = 0; j < n; j++) {
        double *x = pairs->vectors + j * n;
        for (size_t i = 0; i < n; i++) {
            x[i] *= root[i];
        }
    }
}

/* All that one call takes. */
struct work {
    taut_arena *arena;
    taut_pulse *pulse;
    taut_pencil pencil;
    taut_bracket *bracket;           /* [n] */
    double *noise, *residual, *root; /* [n] */
    double *scratch;                 /* [3][n] */
};

static taut_status solve_pencil(const taut_band *k, const taut_band *m, struct work *work,
                                taut_eigenpairs *pairs)
{
    taut_status status = check_definite(m);
    if (status != TAUT_OK) {
        return status;
    }
    status = scale_pencil(k, m, work->root, &work->pencil);
    if (status != TAUT_OK) {
        return status;
    }
    work->pencil.pulse = work->pulse;
    status = solve_banded(&work->pencil, work->arena, work->bracket, pairs);
    if (taut_pulse_is_stopped(work->pulse)) {
        return TAUT_INTERRUPTED;
    }
    if (status != TAUT_OK && status != TAUT_NOT_CONVERGED) {
        return status;
    }
    if (status != TAUT_OK || !is_right(&work->pencil, pairs, work->scratch)) {
        status = solve_dense(&work->pencil, work->arena, pairs);
        if (status != TAUT_OK) {
            return status;
        }
        if (!is_right(&work->pencil, pairs, work->scratch)) {
            return TAUT_CHECK_FAILED;
        }
    }
    unscale_vectors(pairs, work->root);
    return TAUT_OK;
}

taut_status taut_eigen_band(const taut_band *k, const taut_band *m, taut_pulse *pulse,
                            double *values, double *vectors)
{
    if (!taut_band_is_legal(k) || !taut_band_is_legal(m) || k->n != m->n || values == NULL ||
        vectors == NULL || (size_t)k->n > ((size_t)1 << 30) / (size_t)k->n) {
        return TAUT_BAD_ARGUMENT;
    }
    const size_t n = (size_t)k->n;
    taut_arena *arena = taut_arena_new();
    struct work work = {
        .arena = arena,
        .pulse = pulse,
        .bracket = taut_arena_take(arena, n, sizeof *work.bracket),
        .noise = taut_arena_take(arena, n, sizeof(double)),
        .residual = taut_arena_take(arena, n, sizeof(double)),
        .root = taut_arena_take(arena, n, sizeof(double)),
        .scratch = taut_arena_take(arena, 3 * n, sizeof(double)),
    };
    taut_eigenpairs pairs = {k->n, values, vectors, work.noise, work.residual};
    taut_status status = taut_arena_status(arena);
    if (status == TAUT_OK) {
        status = solve_pencil(k, m, &work, &pairs);
    }
    clear_pencil(&work.pencil);
    taut_arena_free(arena);
    return status;
}
