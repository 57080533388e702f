/* fit.h -- what a spline space can do for a curve: least squares of the certificate's own.
 *
 *     sum_j P_j sum_g w_g N_i(t_g) N_j(t_g) = sum_g w_g N_i(t_g) x(t_g),   i = 1..n-2
 *
 * with the ends of the curve kept, at Gauss nodes of the spans. How far it is from the curve is for
 * others to prove; a fit that another hand made should not be much farther.
 */
#ifndef TAUT_CERTIFY_PLATEAU_FIT_H
#define TAUT_CERTIFY_PLATEAU_FIT_H

#include "taut/curve.h"

/* The ranges correspond by an affine map. TAUT_NO_MEMORY; TAUT_NO_SOLUTION where the nodes do not
 * determine the points safely. */
taut_status taut_certify_fit(const taut_curve *curve, const taut_basis *basis, taut_curve **fit);

#endif /* TAUT_CERTIFY_PLATEAU_FIT_H */
