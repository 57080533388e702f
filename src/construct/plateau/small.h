/* small.h -- systems of as many unknowns as a film has cables: A = L L^T in place, x = A^-1 x. */
#ifndef TAUT_CONSTRUCT_PLATEAU_SMALL_H
#define TAUT_CONSTRUCT_PLATEAU_SMALL_H

#include <math.h>

enum { TAUT_SMALL_MAX = 4 };

/* The lower half of a becomes L. 0 where a is not positive definite. */
static inline int taut_small_factor(int n, double a[TAUT_SMALL_MAX][TAUT_SMALL_MAX])
{
    for (int i = 0; i < n; i++) {
        for (int j = 0; j <= i; j++) {
            double sum = a[i][j];
            for (int k = 0; k < j; k++) {
                sum -= a[i][k] * a[j][k];
            }
            if (i == j && !(sum > 0)) {
                return 0;
            }
            a[i][j] = i == j ? sqrt(sum) : sum / a[j][j];
        }
    }
    return 1;
}

static inline void taut_small_solve(int n, double a[TAUT_SMALL_MAX][TAUT_SMALL_MAX], double *x)
{
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < i; k++) {
            x[i] -= a[i][k] * x[k];
        }
        x[i] /= a[i][i];
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++) {
            x[i] -= a[k][i] * x[k];
        }
        x[i] /= a[i][i];
    }
}

#endif /* TAUT_CONSTRUCT_PLATEAU_SMALL_H */
