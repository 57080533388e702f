/* develop.h -- pieces without Gauss curvature, laid flat without strain.
 *
 *     the axis t = 1/2 by its geodesic curvature, then each line s = const from the axis by its own
 *
 * by quadrature: no ruling is looked for, as a flat metric has one development.
 */
#ifndef TAUT_CONSTRUCT_PATTERN_DEVELOP_H
#define TAUT_CONSTRUCT_PATTERN_DEVELOP_H

#include "construct/pattern/piece.h"

/* Fills piece->curvature and piece->is_developable. pulse may be NULL. */
void taut_pattern_look_at_curvature(taut_pattern_piece *piece, taut_pulse *pulse);
/* K where |K| is largest, of places on a grid that has the border, and in (s, t) where; 0 where there is none. */
double taut_pattern_largest_curvature(const taut_pattern_piece *piece, double at[2]);
/* Into piece->alone, in the arena, on as many spans as it needs; piece->is_developable falls where splines do not come near enough.
 * TAUT_NO_MEMORY. */
taut_status taut_pattern_develop(taut_pattern_piece *piece, const taut_flat_options *options,
                                 taut_arena *arena);

#endif /* TAUT_CONSTRUCT_PATTERN_DEVELOP_H */
