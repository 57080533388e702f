/* freedom.h -- which points of a film move, which of them together, and where to.
 *
 *     held       curves, straight edges, corners that are given
 *     tied       copies of a net that goes around; the points of a pole
 *     kept       on a plane, that of a cable or a slide; at a corner on all planes that meet there, or on its guide
 */
#ifndef TAUT_CONSTRUCT_FILM_FREEDOM_H
#define TAUT_CONSTRUCT_FILM_FREEDOM_H

#include "construct/film/space.h"

/* Up to three planes n . x = n . p in general position, n unit and orthogonal: what a point is kept on. */
typedef struct taut_film_place {
    int count;
    double normals[3][3];
    double point[3]; /* on all of them; of none: anything */
} taut_film_place;

/* Where point (i, j) of the net is kept. TAUT_BAD_INPUT, corner-conflict: planes that do not meet. */
taut_status taut_film_place_of(const taut_film_space *space, int i, int j, taut_film_place *place,
                               taut_error *error);
/* x is moved onto the place by the shortest way. */
void taut_film_place_onto(const taut_film_place *place, double x[3]);

/* Fills known, leader and allowed of the space, and the mask. TAUT_BAD_INPUT: corner-conflict.
 * TAUT_NO_SOLUTION: floating. TAUT_NO_MEMORY. */
taut_status taut_film_freedom(taut_film_space *space, taut_arena *arena, taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_FREEDOM_H */
