/* pole.h -- around a border of the window that is one place: the line at one distance from it, along parameter lines, which are geodesics
 * of a surface of revolution.
 */
#ifndef TAUT_CONSTRUCT_PATTERN_POLE_H
#define TAUT_CONSTRUCT_PATTERN_POLE_H

#include "construct/pattern/layout.h"

/* How far the border opposite to a pole is from it, at least, in the carrier's unit: at some places. */
double taut_pattern_pole_reach(const taut_pattern_ground *ground, int pole);
/* All places at a distance from it, below that: a side, its ends too, as u or v grows or backwards. TAUT_BAD_INPUT, reason curve:
 * parameter lines are too uneven. */
taut_status taut_pattern_pole_circle(const taut_pattern_ground *ground, int pole, double distance,
                                     int backwards, const char *where, taut_pattern_side *side,
                                     taut_error *error);
/* The place of a circle where the coordinate that grows along it is `value`. */
void taut_pattern_circle_at(const taut_pattern_side *circle, int along, double value, double at[2]);
/* The angle that parameter lines make at a pole from the first to the last. */
double taut_pattern_pole_turn(const taut_pattern_ground *ground, int pole);

#endif /* TAUT_CONSTRUCT_PATTERN_POLE_H */
