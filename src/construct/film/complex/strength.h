/* strength.h -- cables of a film of many patches that are so many times as strong.
 *
 *     force     r times the factor
 *     elastic   shorter, until the force of its flat arc is
 *     length    its excess over the chord less, by the square
 *
 * The rungs of the ladder are quarters of a doubling of what the weakest cable is by itself, its force over its chord: the same
 * whatever multiple of its forces a document gives.
 */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_STRENGTH_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_STRENGTH_H

#include "construct/film/complex/energy.h"

/* Can all cables be so many times what is given? Closed ones, and lengths between ends that move, cannot. */
int taut_film_can_strengthen(const taut_film_layout *layout, const taut_film_drawn *given,
                             double factor);
/* layout->drawn, which the energy is of, becomes that. */
void taut_film_strengthen(taut_film_energy *energy, taut_film_layout *layout,
                          const taut_film_drawn *given, double factor);
/* The k-th factor of the ladder above 1. */
double taut_film_rung(const taut_film_layout *layout, const taut_film_drawn *given, int k);

/* The last film is found at so many times the forces. TAUT_NO_SOLUTION: cable-too-weak. */
taut_status taut_film_refuse_weak(const taut_film_complex *complex, const taut_film_drawn *given,
                                  double factor, taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_STRENGTH_H */
