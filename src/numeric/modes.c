/* modes.c -- the eigenvectors of one direction, even and odd ones apart where that can be.
 *
 * When A(i, j) = A(n-1-i, n-1-j), as knots that mirror give, then with
 * e_i = (unit_i + unit_{n-1-i}) / sqrt(2), o_i the same with -, and the middle unit vector even, A
 * falls into two banded blocks of half the size and the same width.
 */
#include "numeric/modes.h"

#include "core/memory.h"
#include "numeric/eigen/band.h"

#include <math.h>
#include <string.h>

/* Matrices this nearly symmetric about the middle are taken to be so. Knots that mirror up to
 * rounding give about n 2^-53; what the average changes is of the size of the rounding errors of
 * the knots themselves. */
static const double parity_limit = 0x1p-40;

/* The largest |A(i,j) - A(n-1-i,n-1-j)| / sqrt(A(i,i) A(j,j)); infinite when a diagonal entry is
 * not positive. */
static double parity_defect(const taut_band *a)
{
    double worst = 0.0;
    for (int i = 0; i < a->n; i++) {
        for (int d = 0; d <= a->width && d <= i; d++) {
            const double size = sqrt(taut_band_at(a, i, i) * taut_band_at(a, i - d, i - d));
            const double here = taut_band_at(a, i, i - d);
            const double there = taut_band_at(a, a->n - 1 - i, a->n - 1 - i + d);
            if (!(size > 0.0)) {
                return INFINITY;
            }
            worst = fmax(worst, fabs(here - there) / size);
        }
    }
    return worst;
}

static double average_mirrored(const taut_band *a, int i, int j)
{
    return 0.5 * (taut_band_at(a, i, j) + taut_band_at(a, a->n - 1 - i, a->n - 1 - j));
}

/* even: (n+1)/2 rows, the last the middle one when n is odd; odd: n/2 rows. What is not quite
 * symmetric is averaged.
 *     e_i.A e_j = A(i,j) + A(i,n-1-j),    o_i.A o_j = A(i,j) - A(i,n-1-j)
 * off the middle; the middle row times sqrt(2). Clear both also after a failure. */
static taut_status split_by_parity(const taut_band *a, taut_band *even, taut_band *odd)
{
    const int n = a->n, pairs = n / 2;
    if (taut_band_init(n - pairs, a->width, even) != TAUT_OK ||
        taut_band_init(pairs, a->width, odd) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < n - pairs; i++) {
        for (int d = 0; d <= a->width && d <= i; d++) {
            const int j = i - d;
            const double direct = average_mirrored(a, i, j);
            const double across = average_mirrored(a, i, n - 1 - j);
            if (i < pairs) {
                taut_band_row(even, i)[d] = direct + across;
                taut_band_row(odd, i)[d] = direct - across;
            } else {
                taut_band_row(even, i)[d] = d == 0 ? direct : sqrt(2.0) * direct;
            }
        }
    }
    return TAUT_OK;
}

static size_t sliver_count(int count, int tile_rows)
{
    return ((size_t)count + (size_t)tile_rows - 1) / (size_t)tile_rows;
}

/* Fills part->synthesis and analysis from vectors double[count][rows]; pairs of mirrored points get
 * 1/sqrt(2). */
static taut_status pack_vectors(const double *vectors, int pairs, const taut_kernel *kernel,
                                taut_modes_part *part)
{
    const size_t t = (size_t)kernel->tile_rows, count = (size_t)part->count,
                 rows = (size_t)part->rows;
    part->synthesis =
        taut_alloc_aligned(sliver_count(part->rows, kernel->tile_rows) * count, t * sizeof(double));
    part->analysis =
        taut_alloc_aligned(sliver_count(part->count, kernel->tile_rows) * rows, t * sizeof(double));
    if (part->synthesis == NULL || part->analysis == NULL) {
        return TAUT_NO_MEMORY;
    }
    memset(part->synthesis + (sliver_count(part->rows, kernel->tile_rows) - 1) * count * t, 0,
           count * t * sizeof(double));
    memset(part->analysis + (sliver_count(part->count, kernel->tile_rows) - 1) * rows * t, 0,
           rows * t * sizeof(double));
    for (size_t j = 0; j < count; j++) {
        double *analysis = part->analysis + j / t * rows * t + j % t;
        double *synthesis = part->synthesis + j * t;
        for (size_t i = 0, q = 0; i < rows; i++, q++) {
            const double v = vectors[j * rows + i] * (i < (size_t)pairs ? sqrt(0.5) : 1.0);
            if (q == t) { /* the next sliver of rows */
                q = 0;
                synthesis += count * t;
            }
            synthesis[q] = v;
            analysis[i * t] = v;
        }
    }
    return TAUT_OK;
}

/* One part: the eigenpairs of (k, m), values from `first` on. */
static taut_status add_part(taut_modes *modes, const taut_band *k, const taut_band *m, int first,
                            int pairs, taut_pulse *pulse)
{
    taut_modes_part *part = &modes->part[modes->parts++];
    *part = (taut_modes_part){k->n, k->n, first, NULL, NULL};
    double *vectors = taut_alloc((size_t)k->n * (size_t)k->n, sizeof *vectors);
    if (vectors == NULL) {
        return TAUT_NO_MEMORY;
    }
    taut_status status = taut_eigen_band(k, m, pulse, modes->values + first, vectors);
    if (status == TAUT_OK) {
        status = pack_vectors(vectors, pairs, modes->kernel, part);
    }
    taut_free(vectors);
    return status;
}

/* half[0]: even, half[1]: odd; of K and of M. */
static taut_status add_halves(taut_modes *modes, const taut_band *k, const taut_band *m,
                              taut_band half_k[2], taut_band half_m[2], taut_pulse *pulse)
{
    const int pairs = modes->n / 2;
    if (split_by_parity(k, &half_k[0], &half_k[1]) != TAUT_OK ||
        split_by_parity(m, &half_m[0], &half_m[1]) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    const taut_status status = add_part(modes, &half_k[0], &half_m[0], 0, pairs, pulse);
    return status == TAUT_OK
               ? add_part(modes, &half_k[1], &half_m[1], modes->n - pairs, pairs, pulse)
               : status;
}

static taut_status add_parts(taut_modes *modes, const taut_band *k, const taut_band *m,
                             taut_pulse *pulse)
{
    const int is_mirrored =
        k->n >= 2 && parity_defect(k) <= parity_limit && parity_defect(m) <= parity_limit;
    taut_band half_k[2] = {{0, 0, NULL}, {0, 0, NULL}}, half_m[2] = {{0, 0, NULL}, {0, 0, NULL}};
    if (!is_mirrored) {
        return add_part(modes, k, m, 0, 0, pulse);
    }
    const taut_status status = add_halves(modes, k, m, half_k, half_m, pulse);
    for (int p = 0; p < 2; p++) {
        taut_band_clear(&half_k[p]);
        taut_band_clear(&half_m[p]);
    }
    return status;
}

/* Rounding leaves eigenvalues that are zero a little to either side; below zero they would spoil
 * definiteness. Those that are truly negative stay, for whoever looks whether a system is definite. */
static void clamp_values(taut_modes *modes)
{
    double most = 0.0;
    for (int i = 0; i < modes->n; i++) {
        most = fmax(most, fabs(modes->values[i]));
    }
    for (int i = 0; i < modes->n; i++) {
        if (modes->values[i] < 0.0 && modes->values[i] > -0x1p-40 * most) {
            modes->values[i] = 0.0;
        }
    }
}

taut_status taut_modes_new(const taut_band *k, const taut_band *m, taut_pulse *pulse,
                           taut_modes **out)
{
    if (!taut_band_is_legal(k) || !taut_band_is_legal(m) || k->n != m->n || out == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    taut_modes *modes = taut_alloc_zero(1, sizeof *modes);
    if (modes == NULL) {
        return TAUT_NO_MEMORY;
    }
    modes->n = k->n;
    modes->kernel = taut_kernel_best();
    modes->values = taut_alloc((size_t)k->n, sizeof *modes->values);
    const taut_status status =
        modes->values != NULL ? add_parts(modes, k, m, pulse) : TAUT_NO_MEMORY;
    if (status != TAUT_OK) {
        taut_modes_free(modes);
        return status;
    }
    clamp_values(modes);
    *out = modes;
    return TAUT_OK;
}

void taut_modes_free(taut_modes *modes)
{
    if (modes == NULL) {
        return;
    }
    for (int p = 0; p < 2; p++) {
        taut_free(modes->part[p].synthesis);
        taut_free(modes->part[p].analysis);
    }
    taut_free(modes->values);
    taut_free(modes);
}
