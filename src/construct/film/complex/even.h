/* even.h -- films, and patches of them, in a plane whose nets fold over where no Gauss node is.
 *
 * There the energy is the area, whatever the net inside: it pushes a fold out only where it sees one. A net in a plane that folds
 * gives way to the one in which each free point is at the mean of its neighbours, of which an edge between two patches is half of
 * either: as a drawing of a graph [Tutte1963] it has no folds in a convex boundary. Of a film whose patches are in several planes each patch
 * own, and what is in several stays in them all; what is in a sheet that is not flat, or of a cable, stays where it is. */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_EVEN_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_EVEN_H

#include "construct/film/complex/layout.h"

/* *made = 1: x[nodes][3], scaled, had a patch in a plane that folded, and is the even net, which does not. Else it stays. TAUT_NO_MEMORY. */
taut_status taut_film_even(const taut_film_layout *layout, double *x, int *made);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_EVEN_H */
