/* ways.h -- the moves that the energy of a film of many patches sees.
 *
 *     inside   along iint N_a x_u x x_v, summed over the sheets, each turned to the side of those before it
 *     line     across the tangent at the Greville abscissa, as far as planes leave it
 *     vertex   all that planes leave, as of all points of patches of threads
 *
 * A move within the sheets changes the energy by what the discretisation errs alone: Newton's method in all coordinates creeps
 * along such moves, and in these it does not. */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_WAYS_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_WAYS_H

#include "construct/film/complex/energy.h"

/* What planes leave of a node: unit vectors, orthogonal; how many. */
int taut_film_ways_all(const taut_film_complex *complex, int node, double ways[9]);
/* Of the net of the last value: size[nodes], free[nodes][9] as in energy.h. moments: scratch, double[nodes][3]; local: of a
 * patch. */
void taut_film_ways_seen(const taut_film_energy *energy, double *moments, double *local,
                         unsigned char *size, double *ways);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_WAYS_H */
