/* dirichlet_rational.h -- the Dirichlet form of rational functions whose weights are no product.
 *
 *     A(ij,st) = iint fu R_ij,u R_st,u + fv R_ij,v R_st,v,    R_ij = w_ij N_i N_j / w
 * ([WuWang2011] 7.5)
 *
 * over the unit square, applied to nets by Gauss quadrature without being stored.
 */
#ifndef TAUT_CONSTRUCT_DIRICHLET_RATIONAL_H
#define TAUT_CONSTRUCT_DIRICHLET_RATIONAL_H

#include "taut/basis.h"

typedef struct taut_dirichlet_rational taut_dirichlet_rational;

/* Starts with local+3 nodes a panel (geometry/panels.h) and direction. The bases are borrowed, the
 * weights (in (0, 1]) copied. TAUT_NO_MEMORY. */
taut_status taut_dirichlet_rational_new(const taut_basis *u, const taut_basis *v,
                                        const double *weights, taut_dirichlet_rational **form,
                                        taut_error *error);
void taut_dirichlet_rational_free(taut_dirichlet_rational *form); /* NULL is fine */

/* Half as many nodes again: TAUT_OK, TAUT_NO_MEMORY, or TAUT_NOT_CONVERGED when there are
 * TAUT_GAUSS_MAX already; the form stays as it was then. */
taut_status taut_dirichlet_rational_raise(taut_dirichlet_rational *form);

/* y = A x, nets double[nu][nv][3]. */
void taut_dirichlet_rational_apply(taut_dirichlet_rational *form, double fu, double fv,
                                   const double *x, double *y);

/* halves[0] = 1/2 iint |x_u|^2, halves[1] = 1/2 iint |x_v|^2 over the unit square. */
void taut_dirichlet_rational_energies(taut_dirichlet_rational *form, const double *x,
                                      double halves[2]);

/* sum over s, t of |A(ij,st)|, bounded from above, with each term of the integrals times what one
 * rounding of its parameters does to it: 1 + |u| (1/du + |w_u|/w) + |v| (1/dv + |w_v|/w), du and dv
 * the widths of its span. 2^-53 of it is what a product can be off by. */
double taut_dirichlet_rational_row_sum(const taut_dirichlet_rational *form, double fu, double fv,
                                       int i, int j);

#endif /* TAUT_CONSTRUCT_DIRICHLET_RATIONAL_H */
