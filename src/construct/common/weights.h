/* weights.h -- is a table of weights a product w_ij = a_i b_j? */
#ifndef TAUT_CONSTRUCT_COMMON_WEIGHTS_H
#define TAUT_CONSTRUCT_COMMON_WEIGHTS_H

#include "taut/status.h"

typedef struct taut_weights {
    double *u;    /* [nu], the factors a_i; NULL where they are all the same */
    double *v;    /* [nv], the factors b_j; NULL where they are all the same */
    double *rest; /* [nu][nv], the weights over their largest; NULL where the product is exact */
} taut_weights;

/* Exact means to within 8 units of rounding of each weight. Otherwise u and v are the geometric
 * means of the rows and columns, the nearest product in the logarithms. weights NULL: all NULL.
 * TAUT_NO_MEMORY. */
taut_status taut_weights_split(int nu, int nv, const double *weights, taut_weights *split);
void taut_weights_clear(taut_weights *split);

#endif /* TAUT_CONSTRUCT_COMMON_WEIGHTS_H */
