/* remainder.h -- what Gauss rules may miss of a gradient: a bound, not an agreement of two rules.
 *
 * On a cell the integrand is analytic in either parameter beyond the cell. With |f| <= M within the
 * ellipse of foci -1, 1 whose half axes add up to rho, the rule of n nodes is off by at most
 *
 *     (64/15) M rho^(2 - 2n) / (1 - rho^-2)                          ([Trefethen2008] theorem 4.5)
 *
 * and the tensor rule by the sum over both directions, the other parameter being real. M comes from
 * the coefficients of the cell's net: Chebyshev's for polynomials, |T_j| <= (rho^j + rho^-j) / 2 and
 * |T_j'| <= j (rho^j - rho^-j) / (rho - 1/rho) on the ellipse; Taylor's for c- and h- functions,
 *
 *     f(m + s) = f + f' s + f'' (1 - cos s) + f''' (s - sin s)   (cosh s - 1, sinh s - s)
 *
 * bounded by those of |s|. Denominators, w and W = |x_u x x_v|, are bounded from below by their
 * constant part less all others; no ellipse on which that is not positive counts.
 */
#ifndef TAUT_CERTIFY_DIRICHLET_REMAINDER_H
#define TAUT_CERTIFY_DIRICHLET_REMAINDER_H

#include "core/arena.h"
#include "core/crew.h"
#include "geometry/nurbs/cells.h"

enum { TAUT_REMAINDER_RULES = 12, TAUT_REMAINDER_FEW = 6 /* the rule of 16 nodes */ };
extern const int taut_remainder_nodes[TAUT_REMAINDER_RULES]; /* increasing */

/* The integrand of certify/dirichlet/gradient.h over the unit square. */
typedef struct taut_remainder_request {
    const taut_basis *basis[2];
    const taut_cells *cells[2];
    const double *points;  /* [nu][nv][3], centred and of about unit size */
    const double *weights; /* [nu][nv] or NULL */
    double fu, fv;         /* factors of the Dirichlet energy */
    int is_area;
    const taut_crew *crew; /* or NULL */
    const double *moves; /* [nu][nv][3] at most about 1, or NULL: the second derivative of the area
                          * along them instead, of which the remainders are */
    double
        *missed; /* out, or NULL: [cells u][cells v][2], what the rule TAUT_REMAINDER_FEW misses on
                     * a cell along u and along v; INFINITY where no bound is known */
} taut_remainder_request;

/* remainder[r]: the largest over the points, of the rule of taut_remainder_nodes[r] nodes a cell;
 * *scale: the same of a bound of the integral of the absolute value, INFINITY where a cell has
 * none; with moves, of what a relative error of all that the integrand is made of makes of it.
 * Scratch from the arena. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_gradient_remainder(const taut_remainder_request *request, taut_arena *arena,
                                    double remainder[TAUT_REMAINDER_RULES], double *scale);

#endif /* TAUT_CERTIFY_DIRICHLET_REMAINDER_H */
