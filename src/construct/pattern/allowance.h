/* allowance.h -- the line that a piece is cut along where cloth is left beyond the line that it is sewn along.
 *
 * The parallel curve of an edge y at the distance a outwards, x = y + a n, has
 *
 *     x' = v (1 + a k) T,   x'' = (v (1 + a k))' T + v (1 + a k) v k N,      T = y'/v, v = |y'|, k the curvature away from n
 *
 * and is one as long as 1 + a k > 0. At corners that point outwards its tangents are run on until they meet, or are cut off; at those that
 * point inwards the curves are cut where they cross.
 */
#ifndef TAUT_CONSTRUCT_PATTERN_ALLOWANCE_H
#define TAUT_CONSTRUCT_PATTERN_ALLOWANCE_H

#include "construct/pattern/outline.h"

/* What is left of a piece along each of its edges, in the carrier's unit. */
typedef struct taut_pattern_margin {
    double width[TAUT_FLAT_EDGES];
    int is_folded[TAUT_FLAT_EDGES]; /* over the edge: a hem */
} taut_pattern_margin;

/* The edge of the window that an edge of a piece is on; -1: a seam. */
int taut_pattern_border_of(const taut_pattern_layout *layout, int piece, int edge);
taut_pattern_margin taut_pattern_margin_of(const taut_pattern_problem *problem,
                                           const taut_pattern_layout *layout, int piece);
/* Does everything that is left along a seam of its own belong to a seam? TAUT_BAD_INPUT, reason "allowance". */
taut_status taut_pattern_check_seams(const taut_pattern_allowance *allowance,
                                     const taut_pattern_layout *layout, taut_error *error);
/* Moves outline->cut out, and its bounds. TAUT_NO_MEMORY; TAUT_BAD_INPUT and TAUT_NO_SOLUTION, reason
 * "allowance". */
taut_status taut_pattern_leave(const taut_pattern_piece *piece, const taut_pattern_margin *margin,
                               taut_pattern_corner corner, taut_arena *arena,
                               taut_pattern_outline *outline, taut_error *error);

#endif /* TAUT_CONSTRUCT_PATTERN_ALLOWANCE_H */
