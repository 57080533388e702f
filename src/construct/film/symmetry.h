/* symmetry.h -- films of symmetric data are symmetric to rounding. */
#ifndef TAUT_CONSTRUCT_FILM_SYMMETRY_H
#define TAUT_CONSTRUCT_FILM_SYMMETRY_H

#include "construct/film/equilibrium.h"

/* w->net, a film at rest, becomes symmetric in all ways in which its data are; of data that are not it stays as it is, bit for
 * bit, and so it does where the film itself is not symmetric. TAUT_INTERRUPTED, TAUT_NO_MEMORY. */
taut_status taut_film_make_symmetric(taut_film_work *w, taut_arena *arena, taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_SYMMETRY_H */
