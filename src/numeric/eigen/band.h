/* band.h -- all eigenpairs of a banded symmetric pencil in O(n^2 width^2).
 *
 *     K x = lambda M x,    K symmetric, M symmetric positive definite,    x_i^T M x_j = delta_ij
 *
 * Eigenvalues are isolated by bisection on inertia counts and sharpened, with their vectors, by
 * Rayleigh quotient iteration, many at a time ([Parlett1998] 3.3 and 4.6). Vectors whose
 * eigenvalues are too close to be orthogonal by themselves are orthogonalised; a result that fails
 * its own check is computed again by dense methods, so that the answer never depends on luck.
 */
#ifndef TAUT_NUMERIC_EIGEN_BAND_H
#define TAUT_NUMERIC_EIGEN_BAND_H

#include "core/pulse.h"
#include "numeric/band.h"
#include "taut/status.h"

/* k, m     same n; widths may differ; k positive semidefinite for the accuracy below (not required)
 * values   double[n], ascending
 * vectors  double[n][n], row j belongs to values[j]; which of x and -x it is is left open
 *
 * Accuracy, u = 2^-53, with |A| for the matrix of absolute values; the first in the norm that
 * weighs row i by M(i,i)^(-1/2):
 *     ||(K - lambda M) x|| <= 64 u ||(|K| + |lambda| |M|) |x|||
 *     |x_i^T M x_j - delta_ij| <= 64 u (1 + |x_i|^T |M| |x_j|)
 *
 * pulse may be NULL. Returns TAUT_OK, TAUT_INTERRUPTED, TAUT_BAD_ARGUMENT (sizes, entries not finite; outputs untouched),
 * TAUT_NO_SOLUTION (M not positive definite), TAUT_CHECK_FAILED (the bounds above not met by any
 * method) or TAUT_NO_MEMORY: the outputs are the work space, and spoilt then. Memory: O(n width)
 * beside them. */
taut_status taut_eigen_band(const taut_band *k, const taut_band *m, taut_pulse *pulse,
                            double *values, double *vectors);

#endif /* TAUT_NUMERIC_EIGEN_BAND_H */
