/* greville.h -- the parameter that belongs to each control point. */
#ifndef TAUT_CONSTRUCT_GREVILLE_H
#define TAUT_CONSTRUCT_GREVILLE_H

#include "taut/basis.h"

/* t double[count] in the closed range: i / degree of the way (bezier), the mean of the inner knots
 * t_(i+1) .. t_(i+degree) of function i (bspline), and the centroid int t N_i / int N_i of the
 * others, whose points have no such mean. TAUT_NO_MEMORY. */
taut_status taut_greville(const taut_basis *basis, double *t);

#endif /* TAUT_CONSTRUCT_GREVILLE_H */
