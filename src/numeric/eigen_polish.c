/* One step of inverse iteration, written as a correction ([Parlett1998] 4.3):
 *     r = (K - lambda M) x,    (K - s M) z = r,    x' = x - z  is parallel to  (K - s M)^-1 M x
 * An error in the factors of K - s M, which has no row interchanges and may grow, now spoils the
 * small z, not x. The shift s stays a little away from lambda, so that z has no large part along x.
 */
#include "numeric/eigen_internal.h"

#include "core/memory.h"

#include <math.h>
#include <string.h>

enum { CORRECTIONS = 4, ROUNDS_MAX = 4 };

/* s - lambda as a share of the gap to the next eigenvalue, and as a share of lambda at least. What
 * is left of an error is about the first of them. */
static const double offset = 0x1p-22, least_offset = 0x1p-46;

/* An error in a vector that is not worth another correction. */
static const double small_error = 0x1p-54;

struct block {
    const taut_pencil *pencil;
    double *factor;    /* double[width + n][width + 1][lanes], the first rows zero */
    double *x, *r, *m; /* double[n][lanes]: x, (K - lambda M) x, M x */
    double lambda[TAUT_LANES_MAX];
};

/* M-normalises x, moves lambda to its Rayleigh quotient and fills r and m. */
static void take_residual(struct block *block)
{
    const taut_pencil *p = block->pencil;
    const int n = p->k.n, w = p->k.width;
    const size_t lanes = (size_t)p->kernel->lanes, entries = (size_t)n * lanes;
    double scale[TAUT_LANES_MAX], rx[TAUT_LANES_MAX], unused[TAUT_LANES_MAX];

    p->kernel->band_multiply(n, w, p->m.a, block->x, block->m);
    p->kernel->band_multiply(n, w, p->k.a, block->x, block->r);
    p->kernel->lane_dot(n, block->x, block->m, scale, unused);
    for (size_t l = 0; l < lanes; l++) {
        scale[l] = 1.0 / sqrt(scale[l]);
    }
    for (size_t i = 0; i < entries; i += lanes) {
        for (size_t l = 0; l < lanes; l++) {
            block->x[i + l] *= scale[l];
            block->m[i + l] *= scale[l];
            block->r[i + l] = block->r[i + l] * scale[l] - block->lambda[l] * block->m[i + l];
        }
    }
    p->kernel->lane_dot(n, block->x, block->r, rx, unused);
    for (size_t i = 0; i < entries; i += lanes) {
        for (size_t l = 0; l < lanes; l++) {
            block->r[i + l] -= rx[l] * block->m[i + l];
        }
    }
    for (size_t l = 0; l < lanes; l++) {
        block->lambda[l] += rx[l];
    }
}

/* x -= z with z of the formula above; spoils r. size[l] = ||z|| without its part along x. */
static void correct(struct block *block, double *size)
{
    const taut_pencil *p = block->pencil;
    const size_t lanes = (size_t)p->kernel->lanes, entries = (size_t)p->k.n * lanes;
    double along[TAUT_LANES_MAX], zz[TAUT_LANES_MAX], xx[TAUT_LANES_MAX], unused[TAUT_LANES_MAX];
    double *z = block->r;

    p->kernel->band_substitute(p->k.n, p->k.width, 1, block->factor, z);
    p->kernel->lane_dot(p->k.n, z, block->x, along, zz);
    p->kernel->lane_dot(p->k.n, block->x, block->x, xx, unused);
    for (size_t i = 0; i < entries; i++) {
        block->x[i] -= z[i];
    }
    for (size_t l = 0; l < lanes; l++) {
        size[l] = sqrt(fmax(zz[l] - along[l] * along[l] / xx[l], 0.0));
    }
}

/* Factors K - s M. The quotient of a vector with residual r is off by about ||r||^2 / gap, which s
 * must not come near. */
static void factor(struct block *block, const double *gap, double *share)
{
    const taut_pencil *p = block->pencil;
    double minus[TAUT_LANES_MAX], negative[TAUT_LANES_MAX] = {0}, rr[TAUT_LANES_MAX],
                                  unused[TAUT_LANES_MAX];
    p->kernel->lane_dot(p->k.n, block->r, block->r, rr, unused);
    for (int l = 0; l < p->kernel->lanes; l++) {
        const double lambda = block->lambda[l];
        const double away = fmax(offset * gap[l], least_offset * fabs(lambda));
        const double distance = fmax(away, fmin(64.0 * rr[l] / gap[l], 0x1p-4 * gap[l]));
        minus[l] = -(lambda + distance);
        share[l] = distance / gap[l];
    }
    p->kernel->band_factor(0, p->k.n, p->k.width, p->k.a, p->m.a, 1.0, minus, p->tiny,
                           block->factor, negative);
}

/* One factorisation and a few corrections by it. Returns 1 when no lane would gain from another:
 * its correction left little, or no longer shrank, being rounding. */
static int correct_few(struct block *block, const double *gap)
{
    const size_t lanes = (size_t)block->pencil->kernel->lanes;
    double before[TAUT_LANES_MAX], size[TAUT_LANES_MAX], share[TAUT_LANES_MAX];
    int done = 0;
    for (size_t l = 0; l < lanes; l++) {
        before[l] = INFINITY;
    }
    factor(block, gap, share);
    for (int c = 0; c < CORRECTIONS && !done; c++) {
        correct(block, size);
        done = 1;
        for (size_t l = 0; l < lanes; l++) {
            const int is_rounding = share[l] < 0x1p-8 && size[l] > 0.25 * before[l];
            done = done && (size[l] * share[l] <= small_error || is_rounding);
            before[l] = size[l];
        }
        take_residual(block);
    }
    return done;
}

/* noise and residual of kernel->lanes pairs, into arrays of that length; spoils r and m. */
static void measure(struct block *block, double *noise, double *residual)
{
    const taut_pencil *p = block->pencil;
    const int n = p->k.n, w = p->k.width;
    const size_t lanes = (size_t)p->kernel->lanes, entries = (size_t)n * lanes;
    double *absolute = block->factor; /* free by now: |x| and (|K| + |lambda| |M|) |x| */
    double *sum = block->factor + entries;

    p->kernel->lane_dot(n, block->r, block->r, residual, noise);
    for (size_t i = 0; i < entries; i++) {
        absolute[i] = fabs(block->x[i]);
    }
    p->kernel->band_multiply(n, w, p->abs_k.a, absolute, sum);
    p->kernel->band_multiply(n, w, p->abs_m.a, absolute, block->m);
    for (size_t i = 0; i < entries; i += lanes) {
        for (size_t l = 0; l < lanes; l++) {
            sum[i + l] += fabs(block->lambda[l]) * block->m[i + l];
        }
    }
    double unused[TAUT_LANES_MAX];
    p->kernel->lane_dot(n, sum, sum, noise, unused);
    for (size_t l = 0; l < lanes; l++) {
        noise[l] = sqrt(noise[l]);
        residual[l] = sqrt(residual[l]);
    }
}

static double gap_of(const taut_eigenpairs *pairs, int j)
{
    const double *values = pairs->values;
    const double up = j < pairs->n - 1 ? values[j + 1] - values[j] : INFINITY;
    const double down = j > 0 ? values[j] - values[j - 1] : INFINITY;
    const double gap = fmin(up, down);
    return isfinite(gap) ? gap : fabs(values[j]);
}

/* The next pairs, from `first` on; `old` holds the values before any was polished. */
static void polish_block(struct block *block, const taut_eigenpairs *old, int first,
                         taut_eigenpairs *pairs)
{
    const taut_pencil *p = block->pencil;
    const int n = p->k.n, w = p->k.width, lanes = p->kernel->lanes;
    double gap[TAUT_LANES_MAX];
    double noise[TAUT_LANES_MAX], residual[TAUT_LANES_MAX];

    memset(block->factor, 0, (size_t)w * ((size_t)w + 1) * (size_t)lanes * sizeof(double));
    for (int l = 0; l < lanes; l++) {
        const int j = first + l < n ? first + l : n - 1;
        block->lambda[l] = old->values[j];
        gap[l] = gap_of(old, j);
        for (int i = 0; i < n; i++) {
            block->x[i * lanes + l] = pairs->vectors[(size_t)j * (size_t)n + (size_t)i];
        }
    }
    take_residual(block);
    for (int round = 0; round < ROUNDS_MAX && !correct_few(block, gap); round++) {
    }
    measure(block, noise, residual);
    for (int l = 0; l < lanes && first + l < n; l++) {
        pairs->values[first + l] = block->lambda[l];
        pairs->noise[first + l] = noise[l];
        pairs->residual[first + l] = residual[l];
        for (int i = 0; i < n; i++) {
            pairs->vectors[(size_t)(first + l) * (size_t)n + (size_t)i] = block->x[i * lanes + l];
        }
    }
}

taut_status taut_eigen_polish(const taut_pencil *pencil, taut_eigenpairs *pairs)
{
    const size_t n = (size_t)pairs->n, w = (size_t)pencil->k.width;
    const size_t lane_bytes = (size_t)pencil->kernel->lanes * sizeof(double);
    taut_status status = TAUT_NO_MEMORY;
    taut_eigenpairs old = {.n = pairs->n, .values = taut_alloc(n, sizeof *old.values)};
    struct block block = {.pencil = pencil,
                          .factor = taut_alloc_aligned((n + w) * (w + 1) + n, lane_bytes),
                          .x = taut_alloc_aligned(n, lane_bytes),
                          .r = taut_alloc_aligned(n, lane_bytes),
                          .m = taut_alloc_aligned(n, lane_bytes)};
    if (old.values == NULL || block.factor == NULL || block.x == NULL || block.r == NULL ||
        block.m == NULL) {
        goto done;
    }
    memcpy(old.values, pairs->values, n * sizeof *old.values);
    for (int first = 0; first < pairs->n; first += pencil->kernel->lanes) {
        polish_block(&block, &old, first, pairs);
    }
    status = TAUT_OK;

done:
    taut_free(block.m);
    taut_free(block.r);
    taut_free(block.x);
    taut_free(block.factor);
    taut_free(old.values);
    return status;
}
