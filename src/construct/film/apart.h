/* apart.h -- films of rings whose edges are far apart. */
#ifndef TAUT_CONSTRUCT_FILM_APART_H
#define TAUT_CONSTRUCT_FILM_APART_H

#include "construct/film/equilibrium.h"

/* w->net: the film, by way of one whose edges are nearer. TAUT_NO_SOLUTION: collapses, slides-away; else as taut_film_rest. */
taut_status taut_film_lead_apart(taut_film_work *w, taut_arena *arena, taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_APART_H */
