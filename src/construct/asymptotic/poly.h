/* poly.h -- polynomials by their Bernstein coefficients on [0, 1].
 *
 * A polynomial of degree p with values in R^dim is double[p + 1][dim]. No power basis anywhere:
 * every operation keeps the coefficients' relative accuracy or says what it loses.
 */
#ifndef TAUT_ASYMPTOTIC_POLY_H
#define TAUT_ASYMPTOTIC_POLY_H

enum { TAUT_POLY_MAX = 64 }; /* highest degree of a product */

/* C(n, k), n <= TAUT_POLY_MAX. */
double taut_poly_binomial(int n, int k);

/* out = s a, degree p + q, for scalar s of degree p and a of degree q; out overlaps neither. */
void taut_poly_scale(int p, const double *s, int q, int dim, const double *a, double *out);
/* out = a x b, degree p + q, for vectors. */
void taut_poly_cross(int p, const double *a, int q, const double *b, double *out);
/* The same polynomial written at degree p + times; out does not overlap a. */
void taut_poly_elevate(int p, int dim, const double *a, int times, double *out);
/* a / (t - root), degree p - 1, where a(root) = 0 and 0 <= root <= 1. The recurrence runs from both
 * ends, each way as far as it damps its errors. */
void taut_poly_deflate(int p, int dim, const double *a, double root, double *out);
/* out[dim] = a(t), by de Casteljau. */
void taut_poly_eval(int p, int dim, const double *a, double t, double *out);

#endif /* TAUT_ASYMPTOTIC_POLY_H */
