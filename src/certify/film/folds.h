/* folds.h -- does a sheet fold over? Moves along normals do not see it: a flat film that is laid three times is at rest to them.
 *
 * Normals of neighbouring places, degree + 3 a span each way and some right at the edges, are to be less than a right angle apart.
 */
#ifndef TAUT_CERTIFY_FILM_FOLDS_H
#define TAUT_CERTIFY_FILM_FOLDS_H

#include "taut/surface.h"

/* *folds: nonzero where it does, *u and *v the place. TAUT_NO_MEMORY. */
taut_status taut_film_find_fold(const taut_surface *surface, int *folds, double *u, double *v);

#endif /* TAUT_CERTIFY_FILM_FOLDS_H */
