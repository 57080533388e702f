/* curve.h -- a lath as quintic B-splines over arc length: in space, and in the window on the same
 * knots.
 *
 * Knots are triple where the curve is C2, fourfold where its curvature jumps, fivefold at a kink.
 */
#ifndef TAUT_TRACE_CURVE_H
#define TAUT_TRACE_CURVE_H

#include "taut/curve.h"
#include "trace/lath.h"

/* A stretch of a lath that does not pass a seam of the window. */
typedef struct taut_lath_part {
    const taut_carrier *on; /* of its window */
    taut_basis *basis;      /* the arena's */
    int count;
    double *space;  /* [count][3], in the surface's own unit */
    double *window; /* [count][2] */
} taut_lath_part;

/* The whole lath as one stretch in space (parts[0].space), and its stretches in the window: one,
 * unless it passes seams; then parts[1..] are those and parts[0].window is NULL. TAUT_NO_MEMORY. */
taut_status taut_lath_parts(const taut_carrier *carrier, const taut_lath *lath, taut_arena *arena,
                            taut_lath_part **parts, int *count, taut_error *error);

#endif /* TAUT_TRACE_CURVE_H */
