/* direction.h -- a direction in which a film is a graph over a convex domain. */
#ifndef TAUT_CONSTRUCT_PLATEAU_DIRECTION_H
#define TAUT_CONSTRUCT_PLATEAU_DIRECTION_H

#include "taut/surface.h"

/* A unit e with n . e > 0 at all samples of the normal n, along which the boundary projects onto a
 * convex curve, so far as samples show: a guess that the certificate judges. TAUT_NO_SOLUTION: none
 * was found. TAUT_NO_MEMORY. */
taut_status taut_plateau_direction(const taut_surface *surface, double e[3]);

/* Rows: two axes that make a right-handed orthonormal frame with e, and e. */
void taut_plateau_frame(const double e[3], double frame[3][3]);

#endif /* TAUT_CONSTRUCT_PLATEAU_DIRECTION_H */
