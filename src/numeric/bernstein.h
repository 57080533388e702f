/* bernstein.h -- the Bernstein polynomials of one degree: values and derivatives.
 *
 *     B[n,i](t) = C(n,i) t^i (1-t)^(n-i),    i = 0..n
 */
#ifndef TAUT_NUMERIC_BERNSTEIN_H
#define TAUT_NUMERIC_BERNSTEIN_H

/* values[k][i] = d^k/dt^k B[degree,i](t), k = 0..order, i = 0..degree; rows k > degree are zero.
 * Accuracy for t in [0, 1], u = 2^-53, underflow aside:
 *     row 0       relative error <= 3 degree u      (sums of non-negative terms, no cancellation)
 *     row k > 0   absolute error <= 3 degree 2^k degree!/(degree-k)! u
 * Cost: O(order degree^2). */
void taut_bernstein_eval(int degree, int order, double t, double *values);

#endif /* TAUT_NUMERIC_BERNSTEIN_H */
