/* quasi.h -- the functions of a c- or h- basis on a span, as polynomials and what they lack.
 *
 *     f_a(lo + (hi - lo) s) = sum_k c_ak B[d,k](s) + delta_a(s),       a = 0..3, 0 <= s <= 1
 *
 * with |delta_a| <= missed_a, and derivatives of delta_a by s, up to the second, no larger than the
 * coefficients of a polynomial could make them that are each off by missed_a:
 *
 *     |delta_a'| <= 2 d missed_a,    |delta_a''| <= 4 d (d - 1) missed_a
 *
 * So `missed` may be counted among the errors of coefficients (certify/common/field.h), whatever is
 * then made of them by sums, products and halves, and by derivatives of at most the second order.
 */
#ifndef TAUT_CERTIFY_COMMON_QUASI_H
#define TAUT_CERTIFY_COMMON_QUASI_H

#include "taut/basis.h"

enum { TAUT_QUASI_FUNCTIONS = 4, TAUT_QUASI_DEGREE = 24 };

typedef struct taut_quasi_span {
    int degree;
    double c[TAUT_QUASI_FUNCTIONS][TAUT_QUASI_DEGREE + 1];
    double missed[TAUT_QUASI_FUNCTIONS];
} taut_quasi_span;

/* 0 where the basis is no c- or h- basis, or its spans are so wide that no degree will do. */
int taut_certify_quasi(const taut_basis *basis, int span, taut_quasi_span *out);

/* The degree that it has on any span, or that of polynomials; -1 where there is none. */
int taut_certify_degree(const taut_basis *basis);

#endif /* TAUT_CERTIFY_COMMON_QUASI_H */
