/* direction.h -- a direction in which a film is a graph over a convex domain. */
#ifndef TAUT_CONSTRUCT_PLATEAU_DIRECTION_H
#define TAUT_CONSTRUCT_PLATEAU_DIRECTION_H

#include "taut/surface.h"

/* One of the sheets of a film. */
typedef struct taut_direction_sheet {
    const taut_surface *surface;
    int sign; /* 1, -1: of its normals x_u x x_v, that all sheets are seen from one side */
} taut_direction_sheet;

/* Edge u0, u1, v0, v1 (0..3) of a sheet. */
typedef struct taut_direction_side {
    int sheet, edge, is_backward;
} taut_direction_side;

/* Sheets, and the sides of their boundary in turn, run so that the film is on the left. */
typedef struct taut_direction_film {
    int sheet_count;
    const taut_direction_sheet *sheets;
    int side_count;
    const taut_direction_side *sides;
} taut_direction_film;

/* A unit e with n . e > 0 at all samples of the normal n, along which the boundary projects onto a
 * convex curve, so far as samples show: a guess that the certificate judges. TAUT_NO_SOLUTION: none
 * was found. TAUT_NO_MEMORY. */
taut_status taut_plateau_direction_of(const taut_direction_film *film, double e[3]);
/* Of one surface, by its four edges. */
taut_status taut_plateau_direction(const taut_surface *surface, double e[3]);

/* Rows: two axes that make a right-handed orthonormal frame with e, and e. */
void taut_plateau_frame(const double e[3], double frame[3][3]);

#endif /* TAUT_CONSTRUCT_PLATEAU_DIRECTION_H */
