/* rational.h -- the Dirichlet form of rational functions whose weights are no product.
 *
 *     A(ij,st) = iint fu R_ij,u R_st,u + fv R_ij,v R_st,v,    R_ij = w_ij N_i N_j / w
 *
 * over the unit square, by Gauss quadrature ([WuWang2011] section 7.5). A is symmetric and banded
 * by blocks: it is stored, 8 nu nv k (2h-1) bytes for k and h functions alive in u and in v.
 */
#ifndef TAUT_CONSTRUCT_DIRICHLET_RATIONAL_H
#define TAUT_CONSTRUCT_DIRICHLET_RATIONAL_H

#include "taut/basis.h"

typedef struct taut_dirichlet_rational taut_dirichlet_rational;

/* Starts with two nodes more than functions alive, on every cell (geometry/nurbs/cells.h), and
 * (fu, fv) = (1, 1). The bases are borrowed, the weights, in (0, 1], copied. TAUT_NO_MEMORY;
 * TAUT_NOT_CONVERGED where they vary so much that the quadrature would be too much work. */
taut_status taut_dirichlet_rational_new(const taut_basis *u, const taut_basis *v,
                                        const double *weights, taut_dirichlet_rational **form,
                                        taut_error *error);
void taut_dirichlet_rational_free(taut_dirichlet_rational *form); /* NULL is fine */

/* Half as many nodes again: TAUT_OK, TAUT_NO_MEMORY, or TAUT_NOT_CONVERGED when there are
 * TAUT_GAUSS_MAX already or it would be too much work; the form stays as it was then. */
taut_status taut_dirichlet_rational_raise(taut_dirichlet_rational *form);
/* TAUT_NOT_CONVERGED, with that reason. */
taut_status taut_dirichlet_rational_refuse(const taut_dirichlet_rational *form, taut_error *error);

/* Other factors; nothing to do for those there are. */
void taut_dirichlet_rational_scale(taut_dirichlet_rational *form, double fu, double fv);

/* y = A x, nets double[nu][nv][3], apart. Cost O(nu nv k h). */
void taut_dirichlet_rational_apply(const taut_dirichlet_rational *form, const double *x, double *y);

/* halves[0] = 1/2 iint |x_u|^2, halves[1] = 1/2 iint |x_v|^2 over the unit square. */
void taut_dirichlet_rational_energies(const taut_dirichlet_rational *form, const double *x,
                                      double halves[2]);

/* The sum of |A(ij,st)| over s, t. */
double taut_dirichlet_rational_row_sum(const taut_dirichlet_rational *form, int i, int j);

/* A(ij,ij). */
double taut_dirichlet_rational_diagonal(const taut_dirichlet_rational *form, int i, int j);

/* The most that rounding one parameter does to the integrands, in units of 2^-53 of their size:
 * max 1 + |u| (1/du + |w_u|/w) + |v| (1/dv + |w_v|/w), du and dv the widths of a span. */
double taut_dirichlet_rational_roundings(const taut_dirichlet_rational *form);

#endif /* TAUT_CONSTRUCT_DIRICHLET_RATIONAL_H */
