/* nearest.h -- the point of a surface that is nearest to a point of space. */
#ifndef TAUT_GEOMETRY_NEAREST_H
#define TAUT_GEOMETRY_NEAREST_H

#include "taut/surface.h"

/* *u and *v of the least distance that Newton's method finds from the places of a grid, eight to a
 * span, that are nearer than their neighbours; the same for the same surface and point. TAUT_NO_MEMORY. */
taut_status taut_surface_nearest(const taut_surface *surface, const double point[3], double *u,
                                 double *v);

#endif /* TAUT_GEOMETRY_NEAREST_H */
