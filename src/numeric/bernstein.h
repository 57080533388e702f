/* bernstein.h -- the Bernstein algebra: polynomials by their Bernstein coefficients on [0, 1].
 *
 *     B[n,i](t) = C(n,i) t^i (1-t)^(n-i),    i = 0..n,        a(t) = sum_i a_i B[n,i](t)
 *
 * A polynomial of degree p with values in R^dim is double[p + 1][dim]. No power basis anywhere
 * ([Farouki2012] section 4): every operation keeps the coefficients' relative accuracy or says what
 * it loses. Nothing allocates. src/certify has its own algebra on purpose, so that what it proves
 * does not rest on what it checks.
 */
#ifndef TAUT_NUMERIC_BERNSTEIN_H
#define TAUT_NUMERIC_BERNSTEIN_H

enum { TAUT_BERNSTEIN_MAX = 128 }; /* highest degree of a polynomial that is evaluated or made */

/* C(n, k), 0 <= k <= n <= TAUT_BERNSTEIN_MAX; exact below 2^53. */
double taut_binomial(int n, int k);

/* values[k][i] = d^k/dt^k B[degree,i](t), k = 0..order, i = 0..degree; rows k > degree are zero.
 * Accuracy for t in [0, 1], u = 2^-53, underflow aside:
 *     row 0       relative error <= 3 degree u      (sums of non-negative terms, no cancellation)
 *     row k > 0   absolute error <= 3 degree 2^k degree!/(degree-k)! u
 * Any degree. Cost: O(order degree^2). */
void taut_bernstein_eval(int degree, int order, double t, double *values);

/* value[dim] = a(t) by de Casteljau's algorithm; derivative[dim] = a'(t), unless NULL. dim <= 4.
 * Cost O(dim p^2). */
void taut_bernstein_point(int p, int dim, const double *a, double t, double *value,
                          double *derivative);

/* The pieces over [0, t] and [t, 1], each written on [0, 1], or NULL: what is not wanted. Either
 * may be a itself; dim <= 4. */
void taut_bernstein_split(int p, int dim, const double *a, double t, double *low, double *high);

/* out = a', degree p - 1 (a constant's: degree 0); out may be a. */
void taut_bernstein_derivative(int p, int dim, const double *a, double *out);

/* The same polynomial at degree p + times: out double[p + times + 1][dim], may be a. */
void taut_bernstein_raise(int p, int dim, const double *a, int times, double *out);

/* out = s a, degree p + q <= TAUT_BERNSTEIN_MAX, for a scalar s of degree p and a of degree q; out
 * overlaps neither. */
void taut_bernstein_scale(int p, const double *s, int q, int dim, const double *a, double *out);

/* out = a x b, degree p + q <= TAUT_BERNSTEIN_MAX, for vectors of three; out overlaps neither. */
void taut_bernstein_cross(int p, const double *a, int q, const double *b, double *out);

/* a / (t - root), degree p - 1, where a(root) = 0 and 0 <= root <= 1. The recurrence runs from both
 * ends, each way as far as it damps its errors. */
void taut_bernstein_deflate(int p, int dim, const double *a, double root, double *out);

#endif /* TAUT_NUMERIC_BERNSTEIN_H */
