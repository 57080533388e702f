/* roll.h -- the pieces placed on their roll by their outlines (pattern/sheet/nest.h), or, where that takes less, in rows across it by the
 * boxes around them, the widest piece first. */
#ifndef TAUT_CONSTRUCT_PATTERN_ROLL_H
#define TAUT_CONSTRUCT_PATTERN_ROLL_H

#include "construct/pattern/outline.h"
#include "pattern/sheet/nest.h"

typedef struct taut_pattern_roll {
    double size[2]; /* as long as it is used, and as wide as it is, or as the pieces need */
    taut_nest_place
        *places;  /* [pieces]: where the origin of a piece is, and whether it is turned */
    double waste; /* share of it that is cut off */
} taut_pattern_roll;

/* In the arena, in the carrier's unit; width 0: as wide as the widest piece. has_nap: none is turned. TAUT_NO_MEMORY. */
taut_status taut_pattern_roll_new(int count, const taut_pattern_outline *outlines, double width,
                                  double gap, int has_nap, taut_arena *arena,
                                  taut_pattern_roll *roll);

#endif /* TAUT_CONSTRUCT_PATTERN_ROLL_H */
