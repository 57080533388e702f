/* absolute.h -- polynomials through values at Gauss nodes, and integrals of their absolute values.
 */
#ifndef TAUT_MEASURE_INTEGRATE_ABSOLUTE_H
#define TAUT_MEASURE_INTEGRATE_ABSOLUTE_H

enum { TAUT_FIT_MAX = 32 }; /* nodes per direction */

/* p(x, y) = sum_ik c[i][k] P_i(x) P_k(y) on [-1, 1]^2, Legendre polynomials, i < nu, k < nv. */
typedef struct taut_fit {
    int nu, nv;
    double c[TAUT_FIT_MAX][TAUT_FIT_MAX];
} taut_fit;

/* table[k][j] = (2k+1)/2 w_j P_k(x_j): what takes values at the nodes x of a Gauss rule with
 * weights w to Legendre coefficients. count in 1..TAUT_FIT_MAX. */
void taut_fit_table(int count, const double *nodes, const double *weights, double *table);

/* The polynomial that takes the values f[nu][nv] at the nodes of two rules, given their tables.
 * Cost O(nu nv (nu + nv)). */
void taut_fit_init(int nu, const double *table_u, int nv, const double *table_v, const double *f,
                   taut_fit *fit);

/* A bound of iint |a - b| over [-1, 1]^2, from iint (a - b)^2. */
double taut_fit_distance(const taut_fit *a, const taut_fit *b);

/* iint |p| over [-1, 1]^2, to `relative` of itself. Kinks along p = 0 cost nothing: p need not be
 * known at more places for them. */
double taut_fit_absolute(const taut_fit *fit, double relative);

#endif /* TAUT_MEASURE_INTEGRATE_ABSOLUTE_H */
