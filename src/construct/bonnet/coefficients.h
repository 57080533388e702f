/* coefficients.h -- the coefficients of 1, t and the trigonometric or hyperbolic pair on a window,
 * in the quasi-Bezier or quasi-B-spline basis of one direction ([XuWang2006] sections 3, 4, 9). */
#ifndef TAUT_BONNET_COEFFICIENTS_H
#define TAUT_BONNET_COEFFICIENTS_H

/* One direction. Each pointer is double[count], the caller's. */
typedef struct taut_bonnet_rows {
    int count;
    double *t; /* of the parameter itself */
    double *s; /* of sin, or sinh */
    double *c; /* of cos, or cosh */
    double *f; /* of t - sin t, or sinh t - t (bezier only; else NULL) */
    double *g; /* of 1 - cos t, or cosh t - 1 (bezier only; else NULL) */
} taut_bonnet_rows;

/* Four coefficients on [start, start + length]; circular or hyperbolic. */
void taut_bonnet_bezier_rows(int hyperbolic, double start, double length, taut_bonnet_rows *rows);
/* segments + 3 coefficients on [start, start + segments length]. */
void taut_bonnet_bspline_rows(int hyperbolic, double start, double length, int segments,
                              taut_bonnet_rows *rows);

#endif /* TAUT_BONNET_COEFFICIENTS_H */
