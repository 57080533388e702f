#include "numeric/modes.h"

#include "core/memory.h"
#include "numeric/eigen/band.h"
#include "numeric/parity.h"

#include <math.h>
#include <string.h>

/* Matrices this nearly symmetric about the middle are taken to be so. Knots that mirror up to
 * rounding give about n 2^-53; what the average changes is of the size of the rounding errors of
 * the knots themselves. */
static const double parity_limit = 0x1p-40;

static size_t slivers(int count, int tile_rows)
{
    return ((size_t)count + (size_t)tile_rows - 1) / (size_t)tile_rows;
}

/* Fills part->synthesis and analysis from vectors double[count][rows]; pairs of mirrored points get
 * 1/sqrt(2). */
static taut_status pack(const double *vectors, int pairs, const taut_kernel *kernel,
                        taut_modes_part *part)
{
    const size_t t = (size_t)kernel->tile_rows, count = (size_t)part->count,
                 rows = (size_t)part->rows;
    part->synthesis =
        taut_alloc_aligned(slivers(part->rows, kernel->tile_rows) * count, t * sizeof(double));
    part->analysis =
        taut_alloc_aligned(slivers(part->count, kernel->tile_rows) * rows, t * sizeof(double));
    if (part->synthesis == NULL || part->analysis == NULL) {
        return TAUT_NO_MEMORY;
    }
    memset(part->synthesis + (slivers(part->rows, kernel->tile_rows) - 1) * count * t, 0,
           count * t * sizeof(double));
    memset(part->analysis + (slivers(part->count, kernel->tile_rows) - 1) * rows * t, 0,
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
                            int pairs)
{
    taut_modes_part *part = &modes->part[modes->parts++];
    *part = (taut_modes_part){k->n, k->n, first, NULL, NULL};
    double *vectors = taut_alloc((size_t)k->n * (size_t)k->n, sizeof *vectors);
    taut_status status =
        vectors == NULL ? TAUT_NO_MEMORY : taut_eigen_band(k, m, modes->values + first, vectors);
    if (status == TAUT_OK) {
        status = pack(vectors, pairs, modes->kernel, part);
    }
    taut_free(vectors);
    return status;
}

static taut_status add_halves(taut_modes *modes, const taut_band *k, const taut_band *m)
{
    const int pairs = modes->n / 2;
    taut_band half_k[2] = {{0, 0, NULL}, {0, 0, NULL}}, half_m[2] = {{0, 0, NULL}, {0, 0, NULL}};
    taut_status status = taut_parity_split(k, &half_k[0], &half_k[1]);
    if (status == TAUT_OK) {
        status = taut_parity_split(m, &half_m[0], &half_m[1]);
    }
    for (int p = 0; p < 2 && status == TAUT_OK; p++) {
        status = add_part(modes, &half_k[p], &half_m[p], p == 0 ? 0 : modes->n - pairs, pairs);
    }
    for (int p = 0; p < 2; p++) {
        taut_band_clear(&half_k[p]);
        taut_band_clear(&half_m[p]);
    }
    return status;
}

taut_status taut_modes_new(const taut_band *k, const taut_band *m, taut_modes **out)
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
    taut_status status = TAUT_NO_MEMORY;
    if (modes->values != NULL) {
        const int is_mirrored = k->n >= 2 && taut_parity_defect(k) <= parity_limit &&
                                taut_parity_defect(m) <= parity_limit;
        status = is_mirrored ? add_halves(modes, k, m) : add_part(modes, k, m, 0, 0);
    }
    if (status != TAUT_OK) {
        taut_modes_free(modes);
        return status;
    }
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
