/* bernstein.h -- the Bernstein algebra of the certificates.
 *
 * Apart from numeric/bernstein.h on purpose, as that is what the constructions compute with: what is
 * proved does not rest on the code of what is checked.
 */
#ifndef TAUT_CERTIFY_COMMON_BERNSTEIN_H
#define TAUT_CERTIFY_COMMON_BERNSTEIN_H

/* C(n, k), 0 <= k <= n; exact below 2^53. */
double taut_certify_binomial(int n, int k);

/* The halves of a polynomial with coefficients double[degree + 1][dim], by de Casteljau's algorithm
 * at 1/2; high may be a. */
void taut_certify_halve(int degree, int dim, const double *a, double *low, double *high);

#endif /* TAUT_CERTIFY_COMMON_BERNSTEIN_H */
