/* arc.h -- arcs of circles as curves. */
#ifndef TAUT_GEOMETRY_ARC_H
#define TAUT_GEOMETRY_ARC_H

#include "taut/curve.h"

/* The arc from points[0] through points[1] to points[2], with equal angles: exact, as a c-bspline of
 * four segments; its ends are P and R to rounding, 4e-13 of the chord. TAUT_NO_SOLUTION where no circle in reach of doubles goes through the points: two of
 * them are one, or the arc is flatter than TAUT_ARC_ANGLE or more than a full turn less that;
 * TAUT_NO_MEMORY. */
taut_status taut_arc_new(const double points[3][3], taut_curve **curve);

/* A circle with equal angles, counter-clockwise about `normal`, from center + radius * start made unit
 * and perpendicular to it: exact, as a c-bspline of eight segments; its ends meet to rounding.
 * start NULL: the first axis, the second where that is as good as along the normal. TAUT_NO_SOLUTION: radius not above 0, a direction of
 * no length, start along normal; TAUT_NO_MEMORY. */
taut_status taut_circle_new(const double center[3], const double normal[3], double radius,
                            const double *start, taut_curve **curve);

/* The least angle of an arc, and of what it leaves of a full turn: the centre of a flatter one
 * is a thousand chords away, and as many digits are lost. */
#define TAUT_ARC_ANGLE 1e-3

#endif /* TAUT_GEOMETRY_ARC_H */
