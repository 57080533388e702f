/* jacobian_cell.h -- Bernstein coefficients of a Jacobian, each with a bound of its rounding. */
#ifndef TAUT_MEASURE_INTEGRATE_JACOBIAN_CELL_H
#define TAUT_MEASURE_INTEGRATE_JACOBIAN_CELL_H

#include <stddef.h>

/* J(s, t) = sum_ij value_ij B[du,i](s) B[dv,j](t) over the part lo..hi of the parameters, the true
 * coefficients within `error` of the stored ones. A coefficient of value and error 0 is exact. */
typedef struct taut_jacobian_cell {
    double lo[2], hi[2];
    double low;     /* the least of sign value - error: J >= low all over, times the sign */
    double *values; /* double[2][du+1][dv+1]: values, then errors */
} taut_jacobian_cell;

/* A planar polynomial patch on the unit square: x double[n+1][m+1][2], each coordinate within
 * `apart` of the true one. */
typedef struct taut_planar {
    int n, m;
    const double *x;
    double apart;
} taut_planar;

/* The coefficients of scale (x_u y_v - x_v y_u), du = 2n-1, dv = 2m-1: values double[2][2n][2m] as
 * above. scale > 0. Cost O(n^2 m^2). */
void taut_jacobian_coefficients(const taut_planar *patch, double scale, double *values);

/* Halves the cell along both directions: children [2][2], low u slowest, whose `values` are there.
 * Means only, so errors grow by one rounding a step. scratch double[2][du+1][dv+1]. */
void taut_jacobian_quarter(int du, int dv, const taut_jacobian_cell *cell, double *scratch,
                           taut_jacobian_cell children[4]);

#endif /* TAUT_MEASURE_INTEGRATE_JACOBIAN_CELL_H */
