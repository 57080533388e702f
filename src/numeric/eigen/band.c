#include "numeric/eigen/band.h"

#include "core/memory.h"
#include "numeric/eigen/internal.h"

#include <math.h>
#include <string.h>

/* What band.h promises. */
static const double residual_limit = 64 * 0x1p-53;

/* For the sum of all that is lost to rounding and to orthogonality: twice the promise. */
static const double completeness_limit = 128 * 0x1p-53;

/* ---- the scaled pencil
 * -------------------------------------------------------------------------------- */

static void pencil_clear(taut_pencil *pencil)
{
    taut_band_clear(&pencil->k);
    taut_band_clear(&pencil->m);
    taut_band_clear(&pencil->abs_k);
    taut_band_clear(&pencil->abs_m);
}

/* scaled = A(i,j) root[i] root[j], absolute = |scaled|, both new. Returns the largest entry of
 * absolute. */
static taut_status scale_band(const taut_band *from, int width, const double *root,
                              taut_band *scaled, taut_band *absolute, double *largest)
{
    taut_status status = taut_band_widen(from, width, scaled);
    if (status == TAUT_OK) {
        status = taut_band_widen(from, width, absolute);
    }
    for (int i = 0; i < from->n && status == TAUT_OK; i++) {
        double *row = taut_band_row(scaled, i), *abs_row = taut_band_row(absolute, i);
        for (int d = 0; d <= width && d <= i; d++) {
            row[d] *= root[i] * root[i - d];
            abs_row[d] = fabs(row[d]);
            *largest = fmax(*largest, abs_row[d]);
        }
    }
    return status;
}

/* x of the pencil given is root x of the pencil made. */
static taut_status pencil_init(const taut_band *k, const taut_band *m, double *root,
                               taut_pencil *out)
{
    const int width = k->width > m->width ? k->width : m->width;
    taut_pencil p = {.kernel = taut_kernel_best()};
    double most_k = 0.0, most_m = 0.0;

    for (int i = 0; i < m->n; i++) {
        root[i] = 1.0 / sqrt(taut_band_row(m, i)[0]);
        if (!isfinite(root[i]) || !isfinite(root[i] * root[i])) {
            return TAUT_NO_SOLUTION;
        }
    }
    taut_status status = scale_band(k, width, root, &p.k, &p.abs_k, &most_k);
    if (status == TAUT_OK) {
        status = scale_band(m, width, root, &p.m, &p.abs_m, &most_m);
    }
    p.norm = most_k + most_m;
    p.tiny = 0x1p-200 * p.norm;
    if (status == TAUT_OK && !isfinite(p.norm * p.norm)) {
        status = TAUT_BAD_ARGUMENT;
    }
    if (status != TAUT_OK) {
        pencil_clear(&p);
        return status;
    }
    *out = p;
    return TAUT_OK;
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

/* ---- the pairs
 * ---------------------------------------------------------------------------------------- */

/* Ascending by insertion: polished values are all but sorted. A vector is moved when its value is.
 */
static taut_status sort(taut_eigenpairs *pairs)
{
    const size_t n = (size_t)pairs->n;
    double *held = NULL;
    for (size_t j = 1; j < n; j++) {
        size_t to = j;
        while (to > 0 && pairs->values[to - 1] > pairs->values[j]) {
            to--;
        }
        if (to == j) {
            continue;
        }
        held = held == NULL ? taut_alloc(n, sizeof *held) : held;
        if (held == NULL) {
            return TAUT_NO_MEMORY;
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
    taut_free(held);
    return TAUT_OK;
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
static taut_status finish(const taut_pencil *pencil, taut_eigenpairs *pairs)
{
    taut_status status = sort(pairs);
    if (status == TAUT_OK) {
        status = taut_eigen_orthogonalise(pencil, pairs);
    }
    return status == TAUT_OK ? sort(pairs) : status;
}

/* The fast way. */
static taut_status solve_banded(const taut_pencil *pencil, taut_eigenpairs *pairs)
{
    taut_bracket *bracket = taut_alloc((size_t)pairs->n, sizeof *bracket);
    taut_status status = bracket == NULL ? TAUT_NO_MEMORY : taut_eigen_isolate(pencil, bracket);
    if (status == TAUT_OK) {
        status = taut_eigen_sharpen(pencil, bracket);
    }
    if (status == TAUT_OK) {
        status = taut_eigen_iterate(pencil, bracket, pairs);
    }
    taut_free(bracket);
    return status == TAUT_OK ? finish(pencil, pairs) : status;
}

/* The sure way. */
static taut_status solve_dense(const taut_pencil *pencil, taut_eigenpairs *pairs)
{
    taut_status status = taut_eigen_dense(pencil, pairs);
    if (status == TAUT_OK) {
        status = taut_eigen_polish(pencil, pairs);
    }
    return status == TAUT_OK ? finish(pencil, pairs) : status;
}

/* Back to the pencil given. */
static void unscale(taut_eigenpairs *pairs, const double *root)
{
    const size_t n = (size_t)pairs->n;
    for (size_t j = 0; j < n; j++) {
        double *x = pairs->vectors + j * n;
        for (size_t i = 0; i < n; i++) {
            x[i] *= root[i];
        }
    }
}

taut_status taut_eigen_band(const taut_band *k, const taut_band *m, double *values, double *vectors)
{
    if (!taut_band_is_legal(k) || !taut_band_is_legal(m) || k->n != m->n || values == NULL ||
        vectors == NULL || (size_t)k->n > ((size_t)1 << 30) / (size_t)k->n) {
        return TAUT_BAD_ARGUMENT;
    }
    const size_t n = (size_t)k->n;
    taut_pencil pencil = {.kernel = NULL};
    double *single =
        taut_alloc(7 * n, sizeof *single); /* values, noise, residual, root, scratch[3] */
    taut_status status = single == NULL ? TAUT_NO_MEMORY : check_definite(m);
    if (status != TAUT_OK) {
        goto done;
    }
    double *root = single + 2 * n, *scratch = single + 3 * n;
    taut_eigenpairs pairs = {k->n, values, vectors, single, single + n};
    status = pencil_init(k, m, root, &pencil);
    if (status != TAUT_OK) {
        goto done;
    }
    status = solve_banded(&pencil, &pairs);
    if (status == TAUT_NOT_CONVERGED ||
        (status == TAUT_OK && !is_right(&pencil, &pairs, scratch))) {
        status = solve_dense(&pencil, &pairs);
        if (status == TAUT_OK && !is_right(&pencil, &pairs, scratch)) {
            status = TAUT_CHECK_FAILED;
        }
    }
    if (status == TAUT_OK) {
        unscale(&pairs, root);
    }

done:
    pencil_clear(&pencil);
    taut_free(single);
    return status;
}
