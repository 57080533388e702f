/* updates.h -- references that follow the film of many patches. */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_UPDATES_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_UPDATES_H

#include "construct/film/complex/solve.h"

/* How often the reference of a patch is updated, at most. */
int taut_film_complex_updates(const taut_film_problem *problem);

/* In round k, from 1 on, what has been found becomes the reference of each patch that has k updates or more, and the film is found
 * again from there: layout and rest are those of the last. changes[updates]: how far each round moved a point, over the size. All of it
 * in the arena. Statuses as those of a film. */
taut_status taut_film_complex_update(taut_film_layout *layout, taut_film_rest *rest,
                                     const taut_make_options *options, double *changes,
                                     taut_arena *arena, taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_UPDATES_H */
