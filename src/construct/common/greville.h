/* greville.h -- the parameter that belongs to each control point. */
#ifndef TAUT_CONSTRUCT_COMMON_GREVILLE_H
#define TAUT_CONSTRUCT_COMMON_GREVILLE_H

#include "taut/basis.h"

/* t double[count]: the coefficients of the function t, sum t[i] N_i(t) = t, where they lie in the
 * closed range, else the end they lie beyond (the outermost points of c- and h-bsplines); evenly
 * spread where t is not among the functions (ce-bezier). */
void taut_greville(const taut_basis *basis, double *t);

#endif /* TAUT_CONSTRUCT_COMMON_GREVILLE_H */
