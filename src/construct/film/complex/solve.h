/* solve.h -- the film of least energy of many patches. */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_SOLVE_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_SOLVE_H

#include "construct/film/complex/layout.h"
#include "taut/construct.h"

/* Does the continuous problem have a film, too? */
typedef enum taut_film_doubt {
    TAUT_FILM_CERTAIN = 0,
    TAUT_FILM_NEAR_ITS_END, /* its rims are nearly too far apart, or its pressure nearly too high */
    TAUT_FILM_BY_NORMAL /* of such: the method `normal` alone finds one, and nothing asked for it */
} taut_film_doubt;

typedef struct taut_film_rest {
    double *points; /* [nodes][3], in the user's unit */
    int unknowns, iterations;
    double *pressures;        /* [cell_count], in the user's unit */
    double *forces, *lengths; /* [rope_count], in the user's unit */
    double residual;          /* largest free derivative over the largest */
    double area;              /* of a film of one tension without cables */
    double energy;            /* in the user's unit */
    double rival; /* of two films, one in each of two rims that bound such a film; else 0 */
    int negative; /* eigenvalues of the second variation below 0 */
    taut_film_method method; /* that it was found by */
    taut_film_doubt doubt;
} taut_film_rest;

/* TAUT_NO_SOLUTION: unstable, cable-too-weak, overflow; TAUT_NOT_CONVERGED: folds, not-converged; TAUT_INTERRUPTED, TAUT_NO_MEMORY. */
taut_status taut_film_rest_find(const taut_film_layout *layout, const taut_make_options *options,
                                taut_arena *arena, taut_film_rest *rest, taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_SOLVE_H */
