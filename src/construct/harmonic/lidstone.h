/* lidstone.h -- the pieces of the closed forms of harmonic completion, in Bernstein coefficients.
 *
 * All arrays hold Bernstein coefficients on [0, 1]; curves are [degree+1][3]. Those that are called weighted hold
 * C(d,i) c_i in place of c_i: raising them is adding
 * neighbours. Sums of up to a hundred terms follow one another sixty times at the highest degrees: in twice the
 * precision the net comes out to a rounding or two.
 */
#ifndef TAUT_HARMONIC_LIDSTONE_H
#define TAUT_HARMONIC_LIDSTONE_H

#include "core/twice.h"

/* c[0..d] with c'' = b (degree d-2), c_0 = c_d = 0, d >= 2:
 *     c_i = -1/(d(d-1)) sum_{j=1}^{d-1} min(i,j) (d - max(i,j)) / d  b_{j-1}
 * All terms of one sign where b is, so the coefficients of Lidstone's polynomials come out to full
 * relative accuracy ([NiWang2015] section 3, B.2). */
void taut_lidstone_next(int d, const taut_twice *b, taut_twice *c);

/* C(d,i), i = 0..d. */
void taut_binomials(int d, taut_twice *c);

/* Raises a weighted polynomial from degree d to degree n in place; `stride` numbers a coefficient (1, or 3
 * for curves); room for n+1. */
void taut_raise_weighted(int d, int n, int stride, taut_twice *c);

/* `scale` times the second derivative of a weighted curve of degree d >= 2, in place, degree d-2, weighted. */
void taut_second_derivative(int d, taut_twice scale, taut_twice *curve);

/* The v^m coefficient of a curve of degree m: Delta^m, one number per coordinate. */
void taut_top_difference(int m, const double *curve, double top[3]);

/* u^e in degree n: C(i,e) / C(n,e), i = 0..n. */
void taut_power_coefficients(int e, int n, taut_twice *c);

#endif /* TAUT_HARMONIC_LIDSTONE_H */
