/* complex.h -- films of many patches (docs/film.md). */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_COMPLEX_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_COMPLEX_H

#include "taut/film.h"

/* taut_film_make of a problem with patches. */
taut_status taut_film_complex_make(const taut_film_problem *problem,
                                   const taut_make_options *options, taut_model **model,
                                   taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_COMPLEX_H */
