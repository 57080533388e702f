/* layout.h -- the pieces that the rules cut a surface in. */
#ifndef TAUT_CONSTRUCT_PATTERN_LAYOUT_H
#define TAUT_CONSTRUCT_PATTERN_LAYOUT_H

#include "construct/pattern/piece.h"
#include "taut/pattern.h"

typedef struct taut_pattern_layout {
    const taut_carrier *carrier;
    taut_arena *arena;
    taut_pattern_side *sides;
    int side_count;
    taut_pattern_piece *pieces;
    int piece_count;
} taut_pattern_layout;

/* Cuts by a rule that says how many strips it makes. TAUT_NO_SOLUTION, reasons no-geodesic, crossing, singular, crease. */
taut_status taut_pattern_lay_out(const taut_carrier *carrier, const taut_pattern_rule *rule,
                                 int count, const taut_monitor *monitor, taut_arena *arena,
                                 taut_pattern_layout *layout, taut_error *error);

#endif /* TAUT_CONSTRUCT_PATTERN_LAYOUT_H */
