/* places.h -- normals of a patch of the complex at places of a grid. */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_PLACES_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_PLACES_H

#include "core/arena.h"
#include "taut/basis.h"

/* Functions and slopes at places of one direction. */
typedef struct taut_film_places {
    int count, local;
    double *at;     /* [count], parameters */
    int *first;     /* [count], the first function that is not 0 */
    double *values; /* [count][2][local] */
} taut_film_places;

/* Room for so many, each to be put. TAUT_NO_MEMORY. */
taut_status taut_film_places_take(const taut_basis *basis, int count, taut_arena *arena,
                                  taut_film_places *places);
/* Place k is in a span, share of the way along it. */
void taut_film_places_put(const taut_basis *basis, int span, double share, int k,
                          taut_film_places *places);

/* x_u x x_v at place (i, j) of nodes x double[][3]; node: int[nu][nv] */
void taut_film_normal(const double *x, const int *node, int nv, const taut_film_places *u, int i,
                      const taut_film_places *v, int j, double normal[3]);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_PLACES_H */
