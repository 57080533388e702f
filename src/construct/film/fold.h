/* fold.h -- where a net is folded. */
#ifndef TAUT_CONSTRUCT_FILM_FOLD_H
#define TAUT_CONSTRUCT_FILM_FOLD_H

#include "construct/film/space.h"

typedef struct taut_film_fold {
    int is_folded;   /* else the place is that of the least area element */
    double at[2];    /* u, v, of the knots' ranges */
    double point[3]; /* in the user's unit */
} taut_film_fold;

/* Looks for neighbours of a grid, four steps to a span, edges and corners too, whose normals look apart. net double[nu][nv][3],
 * scaled. Where functions have no direction (a pole, a corner that is none) nothing is said. TAUT_NO_MEMORY. */
taut_status taut_film_fold_find(const taut_film_space *space, const double *net,
                                taut_film_fold *fold);

#endif /* TAUT_CONSTRUCT_FILM_FOLD_H */
