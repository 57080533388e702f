/* begin.h -- a net that a film is to begin with. */
#ifndef TAUT_CONSTRUCT_FILM_BEGIN_H
#define TAUT_CONSTRUCT_FILM_BEGIN_H

#include "construct/film/space.h"

/* space->given = problem->start on the functions of the space, or NULL: points that the film holds are where
 * they were laid, and edges that move start as it has them. Edges have been laid.
 * TAUT_BAD_INPUT: start; TAUT_NO_MEMORY. */
taut_status taut_film_begin(taut_film_space *space, taut_arena *arena, taut_error *error);

/* The inside of space->start as it is given. *has: is there any? */
void taut_film_begin_inside(taut_film_space *space);

#endif /* TAUT_CONSTRUCT_FILM_BEGIN_H */
