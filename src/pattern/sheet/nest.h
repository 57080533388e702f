/* nest.h -- flat pieces on a roll by their own outlines, so that they lie into each other.
 *
 * The roll runs along x and is `width` wide. One piece after the other, by falling width, those of one width in their order: of all
 * places across, in steps of width/256, and of both ways round, half a turn apart, the one where it ends nearest to the roll's
 * beginning, moved there until it is `gap` before what lies there already. Outlines and the gap are rounded up to strips of that step.
 */
#ifndef TAUT_PATTERN_NEST_H
#define TAUT_PATTERN_NEST_H

#include "core/arena.h"

typedef struct taut_nest_shape {
    size_t count;
    const double (
        *points)[2];        /* a closed polygon around the piece, without its first point again */
    double low[2], high[2]; /* of the piece */
} taut_nest_shape;

typedef struct taut_nest_place {
    double at[2];  /* where the shape's origin goes */
    int is_turned; /* by half a turn about it */
} taut_nest_place;

/* `slack`: how far an outline may be outside of its polygon. *length: of the roll that is used; INFINITY where a piece is wider than it.
 * TAUT_NO_MEMORY. */
taut_status taut_nest(taut_arena *arena, int count, const taut_nest_shape *shapes, double width,
                      double gap, double slack, int may_turn, taut_nest_place *places,
                      double *length);

#endif /* TAUT_PATTERN_NEST_H */
