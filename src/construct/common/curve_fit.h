/* curve_fit.h -- a curve of any kind in a spline space, by its moments.
 *
 *     sum_j P_j int T_k N_j dt = int T_k x dt,    k = 1..n-2,      P_0 and P_(n-1) the curve's ends
 *
 * N the functions of the space, T those of the same degree without the first and the last inner
 * knot: n - 2 of them, as many as unknowns. Where fewer than two inner knots are there, or none at
 * all (bases other than bspline), T are the inner N: least squares. The moments matter, not the
 * values: the area of a surface with this edge is off by the product of the errors of x and of what
 * T can't express of the area's gradient, O(h^(2p)) or so, where interpolation gives O(h^(p+1)).
 */
#ifndef TAUT_CONSTRUCT_COMMON_CURVE_FIT_H
#define TAUT_CONSTRUCT_COMMON_CURVE_FIT_H

#include "geometry/nurbs/loop.h"
#include "taut/curve.h"

/* The ranges correspond by an affine map. points double[count of basis][3], its ends those given
 * here. *deviation: the largest distance at equal parameters, at the nodes of the moments.
 * TAUT_NO_MEMORY; TAUT_NOT_CONVERGED when the moments do not determine the points. */
taut_status taut_curve_fit(const taut_curve *curve, const taut_basis *basis,
                           const double ends[2][3], double *points, double *deviation);

/* The same of a closed curve by splines that go around, with T = N the functions of
 * geometry/nurbs/loop.h: points double[count of basis][3], the last of them copies. */
taut_status taut_curve_fit_around(const taut_curve *curve, const taut_basis *basis,
                                  const taut_loop *around, double *points, double *deviation);

#endif /* TAUT_CONSTRUCT_COMMON_CURVE_FIT_H */
