/* strip.h -- banded systems that are not symmetric, of matrices that need no pivoting.
 *
 * The collocation matrix of B-splines at points that satisfy Schoenberg and Whitney is totally positive: elimination without
 * exchanges of rows is then as stable as any ([PieglTiller1997] 9.2.1). Stored by rows,
 * a[i (2 width + 1) + width + j - i] = A(i, j), zero where |i - j| > width.
 */
#ifndef TAUT_NUMERIC_STRIP_H
#define TAUT_NUMERIC_STRIP_H

#include <stddef.h>

/* A becomes its factors L U. 1; 0 where a pivot vanishes but for rounding, or is none: A is then spoilt. */
int taut_strip_factor(int n, int width, double *a);

/* Solves A x = b in place for `count` right-hand sides: number k of row i is x[i step + k]. */
void taut_strip_solve(int n, int width, const double *a, size_t count, size_t step, double *x);

#endif /* TAUT_NUMERIC_STRIP_H */
