/* border_distance.h -- how far a place in space is from an edge of a surface. */
#ifndef TAUT_GEOMETRY_BORDER_DISTANCE_H
#define TAUT_GEOMETRY_BORDER_DISTANCE_H

#include "core/arena.h"
#include "taut/surface.h"

enum { TAUT_BORDER_CELLS = 256 };

/* An edge (0 to 3: u0, u1, v0, v1) with places of it, at equal steps of its parameter. */
typedef struct taut_border {
    const taut_surface *surface;
    int edge;
    double (*places)[3]; /* [TAUT_BORDER_CELLS + 1], the arena's */
} taut_border;

/* TAUT_NO_MEMORY. */
taut_status taut_border_new(taut_arena *arena, const taut_surface *surface, int edge,
                            taut_border *border);
/* From the place of the edge that is nearest, in the surface's unit: Newton's method from the nearest of its places. */
double taut_border_distance(const taut_border *border, const double x[3]);
/* And that place. */
double taut_border_nearest(const taut_border *border, const double x[3], double nearest[3]);

#endif /* TAUT_GEOMETRY_BORDER_DISTANCE_H */
