/* parameters.h -- the closed uniform grid of one direction, one-sided at knots.
 *
 * A grid parameter that is an inner knot comes twice: once seen from the span on its left, once
 * from the right, so that where derivatives jump both values count.
 */
#ifndef TAUT_MEASURE_INTEGRATE_PARAMETERS_H
#define TAUT_MEASURE_INTEGRATE_PARAMETERS_H

#include "core/arena.h"
#include "taut/basis.h"

typedef struct taut_parameters {
    int grid;   /* parameters of the grid */
    int count;  /* entries: grid + the inner knots among them */
    double *t;  /* [count] */
    int *span;  /* [count] */
    int *first; /* [grid + 1]: entries of parameter i are first[i] .. first[i+1]-1 */
} taut_parameters;

/* In the arena, NULL when memory runs out. grid >= 2, or 1 for the single parameter `only` (an end
 * of the range). */
taut_parameters *taut_parameters_new(taut_arena *arena, const taut_basis *basis, int grid,
                                     double only);

#endif /* TAUT_MEASURE_INTEGRATE_PARAMETERS_H */
