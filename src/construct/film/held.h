/* held.h -- edges that are held on a curve. */
#ifndef TAUT_CONSTRUCT_FILM_HELD_H
#define TAUT_CONSTRUCT_FILM_HELD_H

#include "construct/film/space.h"

/* Fits the curve of edge e to its basis, between its corners or around, and lays it into the points of the space, which are known then;
 * the deviation of the space is the largest so far. TAUT_NOT_CONVERGED (curve-fit), TAUT_NO_MEMORY. */
taut_status taut_film_lay_curve(taut_film_space *space, int e, taut_arena *arena,
                                taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_HELD_H */
