/* images.h -- the copies of a film by mirrors, turns and translations. */
#ifndef TAUT_CONSTRUCT_FILM_IMAGES_H
#define TAUT_CONSTRUCT_FILM_IMAGES_H

#include "core/arena.h"
#include "taut/film.h"

/* Of films whose patches have so many points in all. TAUT_BAD_INPUT: value, size. */
taut_status taut_film_images_check(const taut_film_problem *problem, double points,
                                   taut_error *error);
/* Adds the copies of all surfaces of the model, which is the film itself. TAUT_BAD_INPUT: image-twice. TAUT_NO_SOLUTION:
 * overflow. TAUT_NO_MEMORY. */
taut_status taut_film_images_add(const taut_film_problem *problem, taut_arena *arena,
                                 taut_model *model, taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_IMAGES_H */
