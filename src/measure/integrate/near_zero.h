/* near_zero.h -- a basis moved along its parameter to where parameters have all their digits.
 *
 * Over [1e7, 1e7 + 1] a double tells only 5e8 parameters apart. Values there are those of a rounded
 * parameter, two quadrature rules never agree to more than 1e-9, and cells are cut until nothing is
 * left of them. An integral does not depend on where the range begins.
 */
#ifndef TAUT_MEASURE_INTEGRATE_NEAR_ZERO_H
#define TAUT_MEASURE_INTEGRATE_NEAR_ZERO_H

#include "taut/surface.h"

/* *moved: the basis with its range moved to begin at 0, where the range is at least as far from 0
 * as it is long, so that subtraction is exact; else, and where the moved basis is not legal, NULL:
 * take the basis as it is. 0 when memory runs out. */
int taut_near_zero(const taut_basis *basis, taut_basis **moved);

/* The same of both ranges of a surface; NULL where neither moves. */
int taut_surface_near_zero(const taut_surface *surface, taut_surface **moved);

#endif /* TAUT_MEASURE_INTEGRATE_NEAR_ZERO_H */
