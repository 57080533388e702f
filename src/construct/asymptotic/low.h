/* low.h -- the patch of bidegree n + 3 (docs page section 10.1).
 *
 * In homogeneous coordinates p = (W R, W) the tangent plane along an edge is spanned by p, p', p'',
 * so the cross derivative may be
 *     S_v = a p + b p' + c p''     with scalar cubics a, b, c,
 * of degree n + 3. Weights at the corners agree by themselves.
 *
 * At a corner the cross derivative of edge e is its partner's derivative, p_f' = a p + b p' + c p''
 * (4 equations, 3 unknowns, consistent by (C2)), and both edges must give the same
 *     S_uv = a' p + (a + b') p' + (b + c') p'' + c p'''
 * (consistent by (C3)). What is normal to the tangent plane in R_uv is forced; the tangential part
 *     R_uv = nu N + y_1 R_u + y_2 R_v,   W_uv = W_u W_v / W + y_3 W
 * is free at each corner. It is put in coordinates x such that |x|^2 is the squares of the slopes
 * of a, b, c on both edges less their minimum, which no affine or projective map changes.
 */
#ifndef TAUT_ASYMPTOTIC_LOW_H
#define TAUT_ASYMPTOTIC_LOW_H

#include "construct/asymptotic/patch.h"
#include "taut/monitor.h"

/* Fills patch->net; patch->m is n + 3. Inner weights are 1; the three free numbers of each corner's
 * twist and the inner points make A_2 = *energy least as far as Gauss-Newton steps go that keep
 * the weights positive and c away from 0. TAUT_NO_SOLUTION where nothing does, or where an edge has
 * an inflection. */
taut_status taut_low_fill(const taut_quad *quad, int report_singular, const taut_monitor *monitor,
                          taut_patch *patch, double *energy, taut_error *error);

/* ---- low_corner.c: the corners, what is forced there and what is free ---- */

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

/* ---- low_rows.c: the rows beside the edges as functions of the twelve free numbers x of the
 * corners, and the x that are allowed ---- */

enum {
    TAUT_LOW_LENGTH = TAUT_QUAD_DEGREE + 4, /* coefficients of degree n + 3 */
    TAUT_LOW_CONSTRAINTS = 4 * (TAUT_LOW_LENGTH + 2)
};

/* S_v (or S_u) along an edge at degree n + 3, homogeneous: affine in x. */
void taut_low_cross(const taut_low *low, int edge, const double *x, double (*out)[4]);

/* Writes the rows beside the edges, the inner weights 1, the twists and corner weights. The
 * boundary rows are in place. */
void taut_low_write(const taut_low *low, const double *x, taut_patch *patch);

/* What x must keep: half-spaces slack + gradient.x >= 0. Weights beside the boundary stay above a
 * share of the boundary weight, the inner coefficients of c above one of its end values. */
typedef struct taut_low_limits {
    int count;
    double slack[TAUT_LOW_CONSTRAINTS];
    double gradient[TAUT_LOW_FREE][TAUT_LOW_CONSTRAINTS];
} taut_low_limits;

void taut_low_limit(const taut_low *low, const taut_patch *patch, taut_low_limits *limits);

/* The allowed x nearest to `target`, |r (x - target)| least, by cyclic projections
 * ([Hildreth1957]); 0 if there is none. r: upper triangle double[12][12], column-major, or NULL for
 * the identity. */
int taut_low_nearest(const taut_low_limits *limits, const double *r, const double *target,
                     double *x);

#endif /* TAUT_ASYMPTOTIC_LOW_H */
