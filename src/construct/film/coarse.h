/* coarse.h -- a film's first steps in a space of half the spans, where they cost little. */
#ifndef TAUT_CONSTRUCT_FILM_COARSE_H
#define TAUT_CONSTRUCT_FILM_COARSE_H

#include "construct/film/equilibrium.h"

/* w->net, where it is the start, comes nearer to the film with all cables `factor` times as strong as they are, and
 * w->region.theta fits what is left; spaces that have no half stay as they are. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_film_begin_coarse(taut_film_work *w, double factor);

#endif /* TAUT_CONSTRUCT_FILM_COARSE_H */
