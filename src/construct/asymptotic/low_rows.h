/* low_rows.h -- the rows beside the edges of the patch of bidegree n + 3 as functions of the twelve
 * free numbers x of its corners, and the x that are allowed.
 */
#ifndef TAUT_ASYMPTOTIC_LOW_ROWS_H
#define TAUT_ASYMPTOTIC_LOW_ROWS_H

#include "construct/asymptotic/low_corner.h"

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

#endif /* TAUT_ASYMPTOTIC_LOW_ROWS_H */
