/* parameters.h -- the closed uniform grid of one direction, one-sided at knots.
 *
 * A grid parameter that is an inner knot comes twice: once seen from the span on its left, once
 * from the right, so that where derivatives jump both values count.
 */
#ifndef TAUT_MEASURE_INTEGRATE_PARAMETERS_H
#define TAUT_MEASURE_INTEGRATE_PARAMETERS_H

#include "taut/basis.h"

typedef struct taut_parameters {
    int grid;   /* parameters of the grid */
    int count;  /* entries: grid + the inner knots among them */
    double *t;  /* [count] */
    int *span;  /* [count] */
    int *first; /* [grid + 1]: entries of parameter i are first[i] .. first[i+1]-1 */
} taut_parameters;

/* grid >= 2, or 1 for the single parameter `only` (an end of the range). TAUT_NO_MEMORY. */
taut_status taut_parameters_new(const taut_basis *basis, int grid, double only,
                                taut_parameters **lines);
void taut_parameters_free(taut_parameters *lines); /* NULL is fine */

#endif /* TAUT_MEASURE_INTEGRATE_PARAMETERS_H */
