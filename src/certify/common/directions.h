/* directions.h -- the directions of R_u and R_v at one place, in twice the precision of double. */
#ifndef TAUT_CERTIFY_COMMON_DIRECTIONS_H
#define TAUT_CERTIFY_COMMON_DIRECTIONS_H

#include "taut/surface.h"

/* x[0] = w X_u - w_u X, x[1] = w X_v - w_v X (certify/common/tangents.h) of span (i, j) of a surface
 * on bezier or bspline bases, its polynomials continued where (u, v) is outside; each coordinate is
 * within error[0], error[1] of the exact one. Points are moved by -origin, scaled by
 * 2^-exponent[0] and weights by 2^-exponent[1]. 0 where a basis is of another type. Cost O(p q) in
 * that precision. */
int taut_certify_directions(const taut_surface *surface, const int span[2], double u, double v,
                            const double origin[3], const int exponent[2], double x[2][3],
                            double error[2]);

#endif /* TAUT_CERTIFY_COMMON_DIRECTIONS_H */
