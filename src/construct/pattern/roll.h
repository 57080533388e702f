/* roll.h -- the pieces placed on their roll: shelves along it, the widest piece first. */
#ifndef TAUT_CONSTRUCT_PATTERN_ROLL_H
#define TAUT_CONSTRUCT_PATTERN_ROLL_H

#include "construct/pattern/outline.h"

typedef struct taut_pattern_roll {
    double size[2];  /* as long as it is used, and as wide as it is, or as the pieces need */
    double (*at)[2]; /* [pieces]: where the origin of a piece is */
    double waste;    /* share of it that is cut off */
} taut_pattern_roll;

/* In the arena, in the carrier's unit; width 0: as wide as the widest piece, one after the other. cut_area: of all pieces. TAUT_NO_MEMORY. */
taut_status taut_pattern_roll_new(int count, const taut_pattern_outline *outlines, double width,
                                  double gap, double cut_area, taut_arena *arena,
                                  taut_pattern_roll *roll);

#endif /* TAUT_CONSTRUCT_PATTERN_ROLL_H */
