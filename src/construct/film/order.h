/* order.h -- corners that were given in the order of their names round the film, not as u and v have them. */
#ifndef TAUT_CONSTRUCT_FILM_ORDER_H
#define TAUT_CONSTRUCT_FILM_ORDER_H

#include "taut/film.h"

#include <stddef.h>

/* Nonzero where the edges of an open film whose corners are all given make a bow tie, and `text` says which corners to
 * exchange; of edges on curves and of corners that move nothing is said. */
int taut_film_order_note(const taut_film_problem *problem, char *text, size_t size);

#endif /* TAUT_CONSTRUCT_FILM_ORDER_H */
