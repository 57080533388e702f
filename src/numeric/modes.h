/* modes.h -- the eigenvectors of one direction of a tensor product, laid out for matrix products.
 *
 *     K V = M V Lambda,    V^T M V = I
 *
 * When K and M are symmetric about the middle the vectors are even or odd, and only half of each is
 * kept: the products with V and V^T then cost half.
 */
#ifndef TAUT_NUMERIC_MODES_H
#define TAUT_NUMERIC_MODES_H

#include "core/pulse.h"
#include "numeric/band.h"
#include "numeric/kernel/kernel.h"

/* One family of modes: all of them, the even ones, or the odd ones. With v(j, i) the entry of mode
 * j at point i, halves scaled so that V is orthonormal as a whole, and t = kernel->tile_rows,
 *
 *     synthesis[i / t][j][i % t] = v(j, i)
 *     analysis [j / t][i][j % t] = v(j, i)
 *
 * padded with zeros to whole slivers of t. */
typedef struct taut_modes_part {
    int count; /* modes */
    int rows;  /* points kept: all, or one of each mirrored pair and, for even modes, the middle */
    int first; /* index of the first mode in values */
    double *synthesis, *analysis;
} taut_modes_part;

typedef struct taut_modes {
    int n;
    int parts;      /* 1, or 2: even, odd */
    double *values; /* double[n], ascending within each part */
    taut_modes_part part[2];
    const taut_kernel *kernel;
} taut_modes;

/* Negative eigenvalues that are rounding are 0. Statuses as taut_eigen_band; *out untouched on failure. Cost O(n^2 width^2), 16 n^2 bytes, half
 * with parity. */
taut_status taut_modes_new(const taut_band *k, const taut_band *m, taut_pulse *pulse,
                           taut_modes **out);
void taut_modes_free(taut_modes *modes); /* NULL is fine */

#endif /* TAUT_NUMERIC_MODES_H */
