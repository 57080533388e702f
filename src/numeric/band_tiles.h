/* band_tiles.h -- the factors of band.h for wide bands, with the matrix product kernel: columns are
 * taken in blocks K of DEPTH, and what is right of a block is mended by it at once,
 *
 *     u(i,j) = A(i,j) - sum_k u(i,k) L(j,k),    L(i,j) = u(i,j) / D(j),    j, k in K, k < j
 *     A(i,j) -= sum_k u(i,k) L(j,k),    k in K,    for all i >= j behind K
 *
 * ([GolubVanLoan2013] 4.2.9): the second line is a product of matrices, computed in tiles that stay
 * in registers.
 */
#ifndef TAUT_NUMERIC_BAND_TILES_H
#define TAUT_NUMERIC_BAND_TILES_H

#include "numeric/band.h"

enum { TAUT_BAND_TILES_LEAST = 64 }; /* half-width from which the tiles pay */

/* How many doubles taut_band_factor_tiled needs as `work`, aligned to 64 bytes, for this size. */
size_t taut_band_tiles_work(int n, int width);

/* As taut_band_factor, for a half-width >= TAUT_BAND_TILES_LEAST; the factors agree to rounding.
 * Nothing is allocated. */
taut_status taut_band_factor_tiled(taut_band *band, double *work);

#endif /* TAUT_NUMERIC_BAND_TILES_H */
