/* parity.h -- the even and odd halves of a matrix that is symmetric about its middle.
 *
 *     A(i, j) = A(n-1-i, n-1-j)
 *
 * Knots that mirror give such Gram matrices. With e_i = (unit_i + unit_{n-1-i}) / sqrt(2), o_i the
 * same with -, and the middle unit vector even, A falls into two banded blocks of half the size and
 * the same width.
 */
#ifndef TAUT_NUMERIC_PARITY_H
#define TAUT_NUMERIC_PARITY_H

#include "numeric/band.h"

/* The largest |A(i,j) - A(n-1-i,n-1-j)| / sqrt(A(i,i) A(j,j)); infinite when a diagonal entry is
 * not positive. */
double taut_parity_defect(const taut_band *a);

/* even: (n+1)/2 rows, the last the middle one when n is odd; odd: n/2 rows (n >= 2). What is not
 * quite symmetric is averaged. TAUT_OK or TAUT_NO_MEMORY, then both are left alone. */
taut_status taut_parity_split(const taut_band *a, taut_band *even, taut_band *odd);

#endif /* TAUT_NUMERIC_PARITY_H */
