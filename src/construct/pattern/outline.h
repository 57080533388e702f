/* outline.h -- the lines that a flat piece is sewn and cut along.
 *
 * The edge of a held seam is not that of the spline, which has its length weakly, but the curve of exact speed
 *
 *     y(s) = y(0) + int l (cos theta, sin theta) ds,    theta = arg y_s of the spline
 *
 * which ends within rounding of the spline's corner, as the constraint is orthogonal to the splines that its tangent is made of.
 * So both pieces of a seam are equally long at every point. Where strain is singular at a corner and it is not rounding, the edges are
 * laid end to end, and one that is free ends where they do.
 */
#ifndef TAUT_CONSTRUCT_PATTERN_OUTLINE_H
#define TAUT_CONSTRUCT_PATTERN_OUTLINE_H

#include "construct/pattern/flatten.h"

typedef struct taut_pattern_outline {
    const taut_curve *edges
        [TAUT_FLAT_EDGES]; /* as s or t grows, t in [0, 1]; points (y_1, y_2, 0), the arena's */
    const taut_curve *cut; /* counter-clockwise and closed, from the corner of right and start */
    double closure;        /* how far an edge of exact speed ended from its corner */
    double longer;         /* and by how much it is longer or shorter for it, over its length */
    double low[2], high[2], area; /* of the cut */
} taut_pattern_outline;

/* Which edges a way around the piece, counter-clockwise, runs backwards along. */
static const int taut_pattern_edge_is_back[TAUT_FLAT_EDGES] = {0, 0, 1, 1};

/* In the arena, in the carrier's unit. TAUT_NO_MEMORY. */
taut_status taut_pattern_outline_new(const taut_pattern_layout *layout, const taut_pattern_cut *cut,
                                     int piece, taut_arena *arena, taut_pattern_outline *outline);

/* low, high and area, of another line to cut along. */
void taut_pattern_outline_bound(taut_pattern_outline *outline);

#endif /* TAUT_CONSTRUCT_PATTERN_OUTLINE_H */
