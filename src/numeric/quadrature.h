/* quadrature.h -- Gauss-Legendre rules. */
#ifndef TAUT_NUMERIC_QUADRATURE_H
#define TAUT_NUMERIC_QUADRATURE_H

enum { TAUT_GAUSS_MAX = 256 };

/* The rule of `count` nodes on [-1, 1], exact to degree 2 count - 1: nodes increasing, weights
 * positive; both double[count], count in 1..TAUT_GAUSS_MAX. Errors below 3e-16 absolute in the
 * nodes and 1e-15 in the sum of the weights. Cost O(count^2). */
void taut_gauss_rule(int count, double *nodes, double *weights);

#endif /* TAUT_NUMERIC_QUADRATURE_H */
