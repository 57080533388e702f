/* boundary.h -- four curves as the boundary of a surface: put in order, and on common bases.
 *
 * Sides are numbered as edges are named: u0 and u1 run along v, v0 and v1 along u.
 */
#ifndef TAUT_GEOMETRY_BOUNDARY_BOUNDARY_H
#define TAUT_GEOMETRY_BOUNDARY_BOUNDARY_H

#include "taut/curve.h"

enum { TAUT_SIDE_U0, TAUT_SIDE_U1, TAUT_SIDE_V0, TAUT_SIDE_V1, TAUT_SIDES };

/* Finds how four curves, in any order and direction, run around: the first one becomes v0 as it is,
 * the others are reversed where they must be. Corners lie within `tolerance` times the size (the
 * diagonal of the box around the curves' control points) of each other, and become one point, the
 * middle. TAUT_NO_SOLUTION: the best arrangement leaves a larger gap, error->found, between two
 * curves that the message names. The sides are new curves. */
taut_status taut_boundary_order(const taut_curve *const curves[TAUT_SIDES], double tolerance,
                                taut_curve *sides[TAUT_SIDES], taut_error *error);

/* Four curves out of any number, 1 or more, that make one loop: cut at their kinks and joined, as B-splines, between
 * the four sharpest corners (chain.c). TAUT_NO_SOLUTION: a gap is left, or a curve is no polynomial's;
 * TAUT_BAD_INPUT: the loop has fewer corners, or no four that are sharper than the others. */
taut_status taut_boundary_join(int count, const taut_curve *const *curves, double tolerance,
                               taut_curve *joined[TAUT_SIDES], taut_error *error);

/* Two curves as one B-spline: the second begins where the first ends. TAUT_NO_SOLUTION: one is no polynomial's. */
taut_status taut_boundary_link(const taut_curve *first, const taut_curve *second,
                               taut_curve **linked, taut_error *error);

/* The first inner knot at which a spline turns by more than an angle, in radians; NaN where there is none. */
double taut_boundary_first_kink(const taut_curve *curve, double angle);
/* Does a closed curve turn by no more than an angle where it closes, and at its knots as well? */
int taut_boundary_closes_smoothly(const taut_curve *closed, double angle);
int taut_boundary_is_smooth(const taut_curve *closed, double angle);

/* The same sides with u0 and u1 on one basis, and v0 and v1: exactly, by raising degrees and
 * putting knots in, over the ranges of u0 and v0. degree and halvings ask for at least these
 * degrees along u and v and for spans cut in two so often. Rational sides are scaled so that
 * weights agree at the corners. TAUT_NO_SOLUTION: opposite c- or h- bases that differ, a degree too
 * high, weights that do not agree at the corners while no side is of one span, which could be
 * changed. */
taut_status taut_boundary_fit(taut_curve *const sides[TAUT_SIDES], const int degree[2],
                              const int halvings[2], taut_curve *fitted[TAUT_SIDES],
                              taut_error *error);

/* The same sides on bezier bases over [0, 1], as asymptotic and harmonic surfaces want them: curves
 * of several spans are TAUT_NO_SOLUTION. Degrees and weights stay. */
taut_status taut_boundary_bezier(taut_curve *const sides[TAUT_SIDES], taut_curve *made[TAUT_SIDES],
                                 taut_error *error);

/* The net whose boundary rows are the fitted sides: points double[nu][nv][3], known [nu][nv], and
 * weights double[nu][nv] where a side has any (NULL: none has). Weights inside are blended from
 * those around, as Coons blends, in their logarithms: positive, and 1 where all are. */
void taut_boundary_net(taut_curve *const fitted[TAUT_SIDES], double *points, unsigned char *known,
                       double *weights);

/* Has one of them weights? */
int taut_boundary_is_rational(taut_curve *const sides[TAUT_SIDES]);
void taut_boundary_free(taut_curve *sides[TAUT_SIDES]);

/* Scales the weights of rational sides until those that share a corner have one weight there, in
 * place: what taut_boundary_fit begins with. */
taut_status taut_boundary_agree(taut_curve *sides[TAUT_SIDES], taut_error *error);

#endif /* TAUT_GEOMETRY_BOUNDARY_BOUNDARY_H */
