/* gram.h -- Gram matrices of a basis: integrals of products of its functions and of their slopes.
 *
 *     mass(i,s) = 1/L int N_i N_s dt,     stiffness(i,s) = L int N_i' N_s' dt,     L = hi - lo
 *
 * that is, the integrals over the range moved to [0, 1]: no range is too short or too long for
 * them. With weights a_i > 0 the rational functions R_i = a_i N_i / sum_s a_s N_s take the place of
 * N_i. Both are symmetric and banded (half-width local-1); mass is positive definite, stiffness
 * semidefinite with the constants as its kernel ([WuWang2011] section 2.4).
 */
#ifndef TAUT_GEOMETRY_NURBS_GRAM_H
#define TAUT_GEOMETRY_NURBS_GRAM_H

#include "numeric/band.h"
#include "taut/basis.h"

typedef struct taut_gram {
    double length;    /* L */
    double roundings; /* 1 + max |t| over the width of its span: what a rounding of t is there */
    taut_band mass;
    taut_band stiffness;
} taut_gram;

/* Exact to rounding on polynomial bases (Gauss rule of `local` nodes a span); on others, and with
 * weights, the nodes are raised until nothing moves by more than the rounding of parameters does.
 * weights  double[count], positive, or NULL
 * TAUT_NO_MEMORY; TAUT_BAD_INPUT when a span is too short for finite slopes; TAUT_NOT_CONVERGED
 * when TAUT_GAUSS_MAX nodes a span do not settle it. *gram is untouched on failure. */
taut_status taut_gram_new(const taut_basis *basis, const double *weights, taut_gram *gram,
                          taut_error *error);
/* The same with local+3 nodes and no more: near the exact matrices, positive (semi)definite like
 * them, good for a preconditioner. */
taut_status taut_gram_new_rough(const taut_basis *basis, const double *weights, taut_gram *gram,
                                taut_error *error);
/* Frees what is in *gram and zeroes it. */
void taut_gram_clear(taut_gram *gram);

/* The principal submatrices of the `count` functions index[0] < index[1] < ...: TAUT_NO_MEMORY. */
taut_status taut_gram_select(const taut_gram *gram, int count, const int *index, taut_gram *part);

#endif /* TAUT_GEOMETRY_NURBS_GRAM_H */
