/* descent.h -- what the area would gain by going along one direction, bounded.
 *
 *     A(x + t d) = A(x) + t dA d + t^2 d.H d / 2 + ..:   gain = (dA d)^2 / (2 d.H d)
 *
 * as a share of the area. Its three numbers are bounded: |dA d| from above, by the gradient and its
 * error; d.H d from below, by a Gauss rule and its remainder (certify/dirichlet/remainder.h); the
 * area from below, as 2 A = sum P . dA/dP, the area being of degree 2 in the points.
 */
#ifndef TAUT_CERTIFY_PLATEAU_DESCENT_H
#define TAUT_CERTIFY_PLATEAU_DESCENT_H

#include "certify/dirichlet/gradient.h"

/* rule       of taut_gradient_plan, with its cells
 * gradient   of the area, by that rule
 * error      no derivative of it is off by more
 * moves      [nu][nv][3]: d, of any size
 * *gain      no less than the gain; INFINITY where that is not shown to be a number
 * TAUT_NO_MEMORY. */
taut_status taut_certify_descent(const taut_surface *surface, const taut_gradient_rule *rule,
                                 const taut_dirichlet_gradient *gradient, double error,
                                 const double *moves, double *gain);

#endif /* TAUT_CERTIFY_PLATEAU_DESCENT_H */
