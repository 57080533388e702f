/* refine.h -- the same film of many patches in finer spaces. */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_REFINE_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_REFINE_H

#include "construct/film/complex/solve.h"

/* Finds the film problem->refine times more, each time with all spans of the one before halved, and adds the member `refinement` to
 * the details. Statuses as those of a film; TAUT_BAD_INPUT: size. */
taut_status taut_film_complex_refine(const taut_film_layout *layout, const taut_film_rest *rest,
                                     const taut_make_options *options, taut_record *details,
                                     taut_error *error);

/* A film in doubt, in finer spaces, until all coordinates find it there, which takes the doubt from it. Of a film that is none
 * of the continuous problem a finer space leaves nothing: TAUT_NO_SOLUTION, as of a film. Where it comes to no rest there, or ever finer
 * ones leave the doubt, that stays. TAUT_INTERRUPTED, TAUT_NO_MEMORY. */
taut_status taut_film_complex_confirm(const taut_film_layout *layout, taut_film_rest *rest,
                                      const taut_make_options *options, taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_REFINE_H */
