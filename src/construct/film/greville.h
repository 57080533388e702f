/* greville.h -- where the points of a net stand along their basis. */
#ifndef TAUT_CONSTRUCT_FILM_GREVILLE_H
#define TAUT_CONSTRUCT_FILM_GREVILLE_H

#include "taut/basis.h"

/* The Greville abscissae of a bezier or bspline basis, double[count], over [0, 1]: a linear
 * function has its values there as coefficients. */
static inline void taut_film_greville(const taut_basis *basis, double *at)
{
    const int n = taut_basis_count(basis), p = taut_basis_degree(basis);
    const double lo = taut_basis_lo(basis), length = taut_basis_hi(basis) - lo;
    taut_basis_spec spec;

    taut_basis_spec_of(basis, &spec);
    for (int i = 0; i < n; i++) {
        double sum = 0;
        for (int k = 1; k <= p; k++) {
            sum += spec.knots != NULL ? (spec.knots[i + k] - lo) / length : k <= i;
        }
        at[i] = i == 0 ? 0 : i == n - 1 ? 1 : sum / p;
    }
}

#endif /* TAUT_CONSTRUCT_FILM_GREVILLE_H */
