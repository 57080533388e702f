/* small.h -- systems of as many unknowns as a film has cables: A in place, x = A^-1 x. */
#ifndef TAUT_CONSTRUCT_PLATEAU_SMALL_H
#define TAUT_CONSTRUCT_PLATEAU_SMALL_H

#include <math.h>

enum { TAUT_SMALL_MAX = 4 };

/* The lower half of a becomes L, A = L L^T. 0 where a is not positive definite. */
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

/* The same as A = L D L^T, D on the diagonal, for A of any signs: how many of D are below 0; -1 where one is 0. */
static inline int taut_small_factor_signed(int n, double a[TAUT_SMALL_MAX][TAUT_SMALL_MAX])
{
    int negative = 0;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j <= i; j++) {
            double sum = a[i][j];
            for (int k = 0; k < j; k++) {
                sum -= a[i][k] * a[j][k] * a[k][k];
            }
            a[i][j] = i == j ? sum : sum / a[j][j];
        }
        if (!(fabs(a[i][i]) > 0)) {
            return -1;
        }
        negative += a[i][i] < 0;
    }
    return negative;
}

static inline void taut_small_solve_signed(int n, double a[TAUT_SMALL_MAX][TAUT_SMALL_MAX],
                                           double *x)
{
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < i; k++) {
            x[i] -= a[i][k] * x[k];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        x[i] /= a[i][i];
        for (int k = i + 1; k < n; k++) {
            x[i] -= a[k][i] * x[k];
        }
    }
}

#endif /* TAUT_CONSTRUCT_PLATEAU_SMALL_H */
