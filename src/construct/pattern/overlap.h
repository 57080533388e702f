/* overlap.h -- does a flat piece lie over itself? */
#ifndef TAUT_CONSTRUCT_PATTERN_OVERLAP_H
#define TAUT_CONSTRUCT_PATTERN_OVERLAP_H

#include "construct/pattern/outline.h"

/* Do chords of the line to cut along cross, two a span? Where they do is in at, in the carrier's unit. What is narrower than them is
 * left to the certificate. TAUT_NO_MEMORY. */
taut_status taut_pattern_overlap(const taut_pattern_outline *outline, taut_arena *arena,
                                 int *is_crossed, double at[2]);

#endif /* TAUT_CONSTRUCT_PATTERN_OVERLAP_H */
