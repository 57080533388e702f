/* turned.h -- does a patch turn over at its edges, where no Gauss node looks and rules settle all the same?
 *
 * It does at a corner where held edges meet at more than 180 degrees, whatever the net inside. Normals of neighbouring places, some
 * a span and some right at the edges, are to be less than a right angle apart, as the certificate asks by code of its own. */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_TURNED_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_TURNED_H

#include "construct/film/complex/layout.h"

typedef struct taut_film_turned {
    int patch; /* the first that turns over, or -1 */
    double u, v;
} taut_film_turned;

/* x double[nodes][3], scaled. TAUT_NO_MEMORY. */
taut_status taut_film_find_turned(const taut_film_complex *c, const double *x,
                                  taut_film_turned *turned);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_TURNED_H */
