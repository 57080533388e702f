/* outline.h -- does the boundary of a film project onto a convex curve, run through once?
 *
 * With c the projection of the boundary, run through with the film on its left, c = (X, Y) / w and
 * a = w (X, Y)' - w' (X, Y), which is w^2 c':
 *
 *     turned back = sum over edges of int max(0, -a x a') / |a|^2 dt
 *                 + sum over knots of max(0, -angle between the tangents before and after)
 *
 * bounded from above by Bernstein coefficients. J of one sign makes the corners turn left by less
 * than pi, and the film an immersed disc, whose boundary turns by 2 pi in all. If it turns back by
 * no more than theta, and encloses more than 6 theta (its length)^2, it is simple, and so the
 * projection is one to one; and two points of the domain are joined inside it by a path at most
 * 1 / cos(theta / 2) times as long as the line between them (docs/least.md). theta = 0 is a convex
 * curve; what straight edges leave in rounding is counted, not forgiven.
 */
#ifndef TAUT_CERTIFY_PLATEAU_OUTLINE_H
#define TAUT_CERTIFY_PLATEAU_OUTLINE_H

#include "certify/plateau/flux.h"

typedef struct taut_outline_bound {
    double turned_back; /* theta is no more; INFINITY or NaN where nothing is proved */
    double length;      /* of the projected boundary, no more, in units of 2^exponent */
} taut_outline_bound;

/* task->sign is that of J. TAUT_NO_MEMORY. */
taut_status taut_certify_outline(const taut_flux_task *task, taut_outline_bound *bound);

/* A number and how far it may be off. */
typedef struct taut_outline_number {
    double value, error;
} taut_outline_number;

/* One side of a boundary that is run through over sides of many films. */
typedef struct taut_outline_side {
    taut_outline_bound bound;
    double
        turned; /* the angle from its first tangent to its last, with its turns, to 1e-6 for each span; infinite or NaN where that is not known */
    taut_outline_number begin[2], end[2]; /* tangents, as it is run */
} taut_outline_side;

/* Edge u0, u1, v0, v1 (0..3), run with its parameter or backwards. TAUT_NO_MEMORY. */
taut_status taut_certify_outline_side(const taut_flux_task *task, int edge, int is_backward,
                                      taut_outline_side *side);
/* The angle that the boundary turns back by from one side to the next; sense 1: it is to turn left, -1: right. *turned grows by the
 * angle to the left, infinite where it is near pi. */
double taut_certify_outline_corner(const taut_outline_side *before, const taut_outline_side *after,
                                   double sense, double *turned);

#endif /* TAUT_CERTIFY_PLATEAU_OUTLINE_H */
