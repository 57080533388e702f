/* low_corner.h -- the corners of the patch of bidegree n + 3: what is forced there and what is
 * free.
 *
 * At a corner the cross derivative of edge e is its partner's derivative, p_f' = a p + b p' + c p''
 * (4 equations, 3 unknowns, consistent by (C2)), and both edges must give the same
 *     S_uv = a' p + (a + b') p' + (b + c') p'' + c p'''
 * (consistent by (C3)). What is normal to the tangent plane in R_uv is forced; the tangential part
 *     R_uv = nu N + y_1 R_u + y_2 R_v,   W_uv = W_u W_v / W + y_3 W
 * is free at each corner. It is put in coordinates x such that |x|^2 is the squares of the slopes
 * of a, b, c on both edges less their minimum, which no affine or projective map changes.
 */
#ifndef TAUT_ASYMPTOTIC_LOW_CORNER_H
#define TAUT_ASYMPTOTIC_LOW_CORNER_H

#include "construct/asymptotic/patch.h"

enum { TAUT_LOW_FREE = 12 }; /* three per corner */

/* An edge at one of its ends: p and its derivatives, the same with the corner as the origin, and
 * (a, b, c) there. */
typedef struct taut_low_end {
    double p[4][4];
    double near[4][4];
    double abc[3];
} taut_low_end;

typedef struct taut_low {
    const taut_quad *quad;
    taut_low_end ends[4][2];
    double base[4][4];                   /* S_uv at the corners for x = 0 */
    double move[4][3][4];                /* its derivatives by the corner's x */
    double plane_u[4][3], plane_v[4][3]; /* R_u, R_v there */
} taut_low;

/* TAUT_NO_SOLUTION where the two edges of a corner have no common twist. */
taut_status taut_low_corners(const taut_quad *quad, taut_low *low, taut_error *error);

/* S_uv at a corner, affine in x[12]. */
void taut_low_s(const taut_low *low, int corner, const double *x, double s[4]);
/* R_uv from S_uv. */
void taut_low_twist(const taut_low *low, int corner, const double s[4], double twist[3]);
/* The Bernstein coefficients of a, b, c on a curved edge, affine in x. */
void taut_low_cubics(const taut_low *low, int edge, const double *x, double abc[3][4]);

#endif /* TAUT_ASYMPTOTIC_LOW_CORNER_H */
