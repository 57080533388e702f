/* curve_distance.h -- how far apart two curves are at equal parts of their ranges, proved.
 *
 * Both become rational Bezier pieces over common spans, c- and h- curves within a proved bound.
 * With a = X / v and b = Y / w there,
 *
 *     |a - b| <= max |X_i| / min d_i,    X w - Y v = sum_i X_i B[p+q,i]
 *                                        v w     = sum_i d_i B[p+q,i]
 *
 * after each piece was halved by de Casteljau, again and again where the bound is above 1.05 of
 * what the ends of halves show, 14 times at most. Rounding is added: 32 (p + q) 2^-53 of the size.
 */
#ifndef TAUT_CERTIFY_COMMON_CURVE_DISTANCE_H
#define TAUT_CERTIFY_COMMON_CURVE_DISTANCE_H

#include "taut/curve.h"
#include "taut/surface.h"

/* TAUT_NO_MEMORY; TAUT_NO_SOLUTION where a curve has no Bezier pieces. */
taut_status taut_certify_distance(const taut_curve *a, const taut_curve *b, double *bound,
                                  taut_error *error);

/* Edge u0, u1, v0, v1 (0..3) of a net as a curve: its outermost row or column. weights may be
 * NULL. */
taut_status taut_certify_edge(const taut_basis *u, const taut_basis *v, const double *points,
                              const double *weights, int edge, taut_curve **curve,
                              taut_error *error);

/* The largest distance of the curve's control points from x. */
double taut_certify_reach(const taut_curve *curve, const double *x);

#endif /* TAUT_CERTIFY_COMMON_CURVE_DISTANCE_H */
