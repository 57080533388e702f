/* One step of inverse iteration, written as a correction ([Parlett1998] 4.3):
 *     r = (K - lambda M) x,    (K - s M) z = r,    x' = x - z  is parallel to  (K - s M)^-1 M x
 * An error in the factors of K - s M, which has no row interchanges and may grow, now spoils the
 * small z, not x. The shift s stays a little away from lambda, so that x and z do not cancel. */
#include "numeric/eigen/internal.h"

#include <math.h>
#include <string.h>

enum { CORRECTIONS = 4, ROUNDS_MAX = 4 };

/* s - lambda as a share of the gap to the next eigenvalue, and as a share of lambda at least. What
 * is left of an error is about the first of them. */
static const double offset = 0x1p-22, least_offset = 0x1p-46;

/* An error in a vector that is not worth another correction. */
static const double small_error = 0x1p-54;

taut_eigen_block taut_eigen_block_of(const taut_pencil *pencil, taut_arena *arena)
{
    const size_t n = (size_t)pencil->k.n, w = (size_t)pencil->k.width;
    const size_t lane_bytes = TAUT_LANES * sizeof(double);
    return (taut_eigen_block){
        .pencil = pencil,
        .factor = taut_arena_take(arena, (n + w) * (w + 1) + n, lane_bytes),
        .x = taut_arena_take(arena, n, lane_bytes),
        .r = taut_arena_take(arena, n, lane_bytes),
        .m = taut_arena_take(arena, n, lane_bytes),
    };
}

/* What band_pencil tells of x: x . M x, and the move of lambda to its Rayleigh quotient; the square
 * of the residual, all for x of length 1. */
struct quotient {
    double length[TAUT_LANES], move[TAUT_LANES], square[TAUT_LANES];
};

/* Fills r, for lambda as it is, and m; then moves lambda. */
static void find_residual(taut_eigen_block *block, struct quotient *quotient)
{
    const taut_pencil *p = block->pencil;
    const int lanes = TAUT_LANES;
    double dot[3 * TAUT_LANES];

    p->kernel->band_pencil(p->k.n, p->k.width, p->k.a, p->m.a, block->lambda, block->x, block->r,
                           block->m, dot);
    for (int l = 0; l < lanes; l++) {
        quotient->length[l] = dot[l];
        quotient->move[l] = dot[lanes + l] / dot[l];
        quotient->square[l] = dot[2 * lanes + l] / dot[l];
        block->lambda[l] += quotient->move[l];
    }
}

/* Factors K - s M. A quotient is off by about ||r||^2 / gap, which s must not come near. share[l]:
 * what a correction leaves of an error. */
static void factor_shifted(taut_eigen_block *block, const double *square, double *share)
{
    const taut_pencil *p = block->pencil;
    double minus[TAUT_LANES], negative[TAUT_LANES] = {0};
    for (int l = 0; l < TAUT_LANES; l++) {
        const double lambda = block->lambda[l], gap = block->gap[l];
        const double away = fmax(offset * gap, least_offset * fabs(lambda));
        const double distance = fmax(away, fmin(64.0 * square[l] / gap, 0x1p-4 * gap));
        minus[l] = -(lambda + distance);
        share[l] = distance / gap;
    }
    p->kernel->band_factor(0, p->k.n, p->k.width, p->k.a, p->m.a, 1.0, minus, p->tiny,
                           block->factor, negative);
}

/* x -= z with z of the formula above; spoils r. size[l]: ||z|| / ||x||, the part along x left out.
 */
static void correct_vectors(taut_eigen_block *block, double *size)
{
    const taut_kernel *kernel = block->pencil->kernel;
    const int n = block->pencil->k.n;
    const size_t entries = (size_t)n * (size_t)TAUT_LANES;
    double along[TAUT_LANES], zz[TAUT_LANES], xz[TAUT_LANES], xx[TAUT_LANES];
    double *z = block->r;

    kernel->band_substitute(n, block->pencil->k.width, 1, block->factor, z);
    kernel->lane_dot(n, z, block->x, along, zz);
    kernel->lane_dot(n, block->x, z, xz, xx);
    for (size_t i = 0; i < entries; i++) {
        block->x[i] -= z[i];
    }
    for (int l = 0; l < TAUT_LANES; l++) {
        size[l] = sqrt(fmax(zz[l] / xx[l] - along[l] / xx[l] * (along[l] / xx[l]), 0.0));
    }
}

/* One factorisation and a few corrections by it. Returns 1 when no lane would gain from another:
 * its correction left little, or no longer shrank, being rounding. */
static int correct_few(taut_eigen_block *block, struct quotient *quotient)
{
    const int lanes = TAUT_LANES;
    double before[TAUT_LANES], size[TAUT_LANES], share[TAUT_LANES];
    int done = 0;
    for (int l = 0; l < lanes; l++) {
        before[l] = INFINITY;
    }
    factor_shifted(block, quotient->square, share);
    for (int c = 0; c < CORRECTIONS && !done; c++) {
        correct_vectors(block, size);
        done = 1;
        for (int l = 0; l < lanes; l++) {
            const int is_rounding = share[l] < 0x1p-8 && size[l] > 0.25 * before[l];
            done = done && (size[l] * share[l] <= small_error || is_rounding);
            before[l] = size[l];
        }
        find_residual(block, quotient);
    }
    return done;
}

/* Stores the first `used` lanes with their noise and residual; spoils r, m and factor but its first
 * rows. */
static void store_pairs(taut_eigen_block *block, const struct quotient *quotient, int first,
                        int used, taut_eigenpairs *pairs)
{
    const taut_pencil *p = block->pencil;
    const size_t n = (size_t)p->k.n, w = (size_t)p->k.width, lanes = TAUT_LANES;
    double minus[TAUT_LANES], dot[3 * TAUT_LANES], rm[TAUT_LANES], mm[TAUT_LANES];
    double *absolute = block->factor + w * (w + 1) * lanes;

    /* r is for lambda before its last move */
    p->kernel->lane_dot(p->k.n, block->m, block->r, rm, mm);
    for (size_t l = 0; l < lanes; l++) {
        minus[l] = -fabs(block->lambda[l]);
    }
    for (size_t i = 0; i < n * lanes; i++) {
        absolute[i] = fabs(block->x[i]);
    }
    p->kernel->band_pencil(p->k.n, p->k.width, p->abs_k.a, p->abs_m.a, minus, absolute, block->r,
                           block->m, dot);
    for (size_t l = 0; l < (size_t)used; l++) {
        const size_t j = (size_t)first + l;
        const double scale = 1.0 / sqrt(quotient->length[l]), move = quotient->move[l];
        const double square =
            quotient->square[l] + scale * scale * move * (move * mm[l] - 2.0 * rm[l]);
        pairs->values[j] = block->lambda[l];
        pairs->noise[j] = scale * sqrt(dot[2 * lanes + l]);
        pairs->residual[j] = sqrt(fmax(square, 0.0));
        for (size_t i = 0; i < n; i++) {
            pairs->vectors[j * n + i] = scale * block->x[i * lanes + l];
        }
    }
}

void taut_eigen_block_polish(taut_eigen_block *block, int first, int used, taut_eigenpairs *pairs)
{
    const int lanes = TAUT_LANES;
    const size_t entries = (size_t)block->pencil->k.n * (size_t)lanes;
    struct quotient quotient;

    find_residual(block, &quotient);
    for (size_t i = 0; i < entries;
         i += (size_t)lanes) { /* r for the new lambda: the move may be large */
        for (int l = 0; l < lanes; l++) {
            block->r[i + (size_t)l] -= quotient.move[l] * block->m[i + (size_t)l];
        }
    }
    for (int round = 0; round < ROUNDS_MAX && !correct_few(block, &quotient); round++) {
    }
    store_pairs(block, &quotient, first, used, pairs);
}

taut_status taut_eigen_polish(const taut_pencil *pencil, taut_arena *arena, taut_eigenpairs *pairs)
{
    const size_t n = (size_t)pairs->n;
    const int lanes = TAUT_LANES;
    taut_eigen_block block = taut_eigen_block_of(pencil, arena);
    /* the values before any was polished */
    const double *old = taut_arena_copy(arena, pairs->values, n, sizeof *old);
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int first = 0; first < pairs->n; first += lanes) {
        const int used = pairs->n - first < lanes ? pairs->n - first : lanes;
        for (int l = 0; l < lanes; l++) {
            const int j = first + (l < used ? l : used - 1);
            const double up = j < pairs->n - 1 ? old[j + 1] - old[j] : INFINITY;
            const double gap = fmin(up, j > 0 ? old[j] - old[j - 1] : INFINITY);
            block.lambda[l] = old[j];
            block.gap[l] = fmax(isfinite(gap) ? gap : fabs(old[j]), least_offset * fabs(old[j]));
            for (size_t i = 0; i < n; i++) {
                block.x[i * (size_t)lanes + (size_t)l] = pairs->vectors[(size_t)j * n + i];
            }
        }
        taut_eigen_block_polish(&block, first, used, pairs);
    }
    return TAUT_OK;
}
