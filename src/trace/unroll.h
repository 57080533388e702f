/* unroll.h -- the axis of a lath's pattern: where it runs in the plane, and what the twist stretches.
 *
 * A fibre at height h of a strip that twists by tau is sqrt(1 + h^2 tau^2) as long as the axis. With
 * y = w tau / 2 the mean over the width is mu = (sqrt(1 + y^2) + asinh(y)/y) / 2: the length of a strip
 * that no force pulls.
 */
#ifndef TAUT_TRACE_UNROLL_H
#define TAUT_TRACE_UNROLL_H

#include "trace/bending.h"

/* How it unrolls. */
typedef struct taut_unroll_rule {
    int flat;         /* which curvature of a bending the pattern has, or -1: it is straight */
    double width;     /* what twists, in the carrier's unit; 0: nothing does */
    int is_stretched; /* lengths are cut as the mean over the width, not as the axis */
} taut_unroll_rule;

typedef struct taut_unrolled_segment taut_unrolled_segment;

typedef struct taut_unrolled {
    taut_unroll_rule rule;
    taut_unrolled_segment *segments; /* a segment of the lath each */
    const double *nodes, *weights;   /* of Gauss's rule within them */
} taut_unrolled;

/* A place of it. */
typedef struct taut_unrolled_point {
    double edge, stretch; /* what the edge, and the mean, are longer by than the axis up to there */
    double cut, x, y, theta; /* along it as it is cut, and in the plane, from the origin along x */
} taut_unrolled_point;

/* In the arena. TAUT_NO_MEMORY. */
taut_status taut_unroll(taut_arena *arena, taut_linefield_kind kind, const taut_lath *lath,
                        const taut_unroll_rule *rule, taut_unrolled *unrolled);

/* At t in [0, 1] of a segment; of the end of the lath at t = 1 of the last one. */
taut_unrolled_point taut_unrolled_at(const taut_unrolled *unrolled, int segment, double t);

#endif /* TAUT_TRACE_UNROLL_H */
