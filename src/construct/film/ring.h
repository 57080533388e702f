/* ring.h -- the edges of a film that goes around, before it is solved. */
#ifndef TAUT_CONSTRUCT_FILM_RING_H
#define TAUT_CONSTRUCT_FILM_RING_H

#include "construct/film/space.h"

/* Lays both edges of the space's points, and marks what is held: curves are fitted, a pole begins at
 * the middle of the other edge, a cable or a slide as the other edge moved into its plane.
 * TAUT_BAD_INPUT: corner-missing, curve-ends. TAUT_NO_SOLUTION: floating, collapses. TAUT_NOT_CONVERGED: curve-fit. */
taut_status taut_film_ring_lay(taut_film_space *space, taut_arena *arena, taut_error *error);

/* Refuses two held edges that no connected film spans: curves in the two nappes of a cone of half angle 56.47
 * degrees ([DierkesHildebrandtKuesterWohlrab1992] 6.2). TAUT_NO_SOLUTION: collapses. */
taut_status taut_film_ring_cone(const taut_film_space *space, taut_error *error);

/* The area of two films that each span one edge of the ring by itself, in the user's unit, at most: of cones
 * over the edges with their tips in the middle, which are the plane films of plane edges that are seen whole from there. points: of
 * the model. 0 where an edge is not held. TAUT_NO_MEMORY. */
taut_status taut_film_ring_discs(const taut_film_space *space, const double *points, double *area);

#endif /* TAUT_CONSTRUCT_FILM_RING_H */
