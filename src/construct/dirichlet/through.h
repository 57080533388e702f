/* through.h -- the solution that meets linear conditions besides.
 *
 *     A x = sum_k lambda_k c_k at the unknown points,    c_k . P = X_k
 *
 * With x_0 the solution without conditions and y_k = A^-1 c_k, x = x_0 + sum lambda_k y_k where
 * S lambda = X - c . x_0, S_kl = c_k . y_l (the Schur complement, symmetric and positive definite
 * where the conditions are independent: [GolubVanLoan2013] 4.4.6).
 */
#ifndef TAUT_CONSTRUCT_DIRICHLET_THROUGH_H
#define TAUT_CONSTRUCT_DIRICHLET_THROUGH_H

#include "construct/common/through.h"
#include "construct/dirichlet/system.h"

/* net double[nu][nv][3]: the solution without conditions, in the units of their points; then the one
 * with them. system NULL: every point is known, and the conditions are only looked at.
 * TAUT_NO_SOLUTION, "through": the one that error->where names contradicts what is known or those
 * before it by more than 1e-10 of the unit. Cost: a solve for each three conditions, and two. */
taut_status taut_dirichlet_through_solve(taut_dirichlet_system *system, double aspect,
                                         const taut_mask *mask, const taut_conditions *conditions,
                                         taut_arena *arena, double *net, taut_error *error);

#endif /* TAUT_CONSTRUCT_DIRICHLET_THROUGH_H */
