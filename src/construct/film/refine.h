/* refine.h -- energies in nested spaces, and what they tell of the least of all. */
#ifndef TAUT_CONSTRUCT_FILM_REFINE_H
#define TAUT_CONSTRUCT_FILM_REFINE_H

#include "construct/film/solve.h"

/* Finds the film `problem->refine` times more, each time with all spans of the one before halved, and adds the member
 * `refinement` to the details. surface, energy: of the film. Statuses as those of a film. */
taut_status taut_film_refine(const taut_film_problem *problem, const taut_surface *surface,
                             double energy, const taut_make_options *options, taut_record *details,
                             taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_REFINE_H */
