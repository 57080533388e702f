/* stronger.h -- films of cables that are weak. */
#ifndef TAUT_CONSTRUCT_FILM_STRONGER_H
#define TAUT_CONSTRUCT_FILM_STRONGER_H

#include "construct/film/equilibrium.h"

/* w->net: the film, by way of one whose forces are larger. TAUT_NO_SOLUTION: cable-too-weak; else as taut_film_rest. */
taut_status taut_film_lower_forces(taut_film_work *w, taut_arena *arena, taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_STRONGER_H */
