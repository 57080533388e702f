/* layout.h -- a film of many patches before it is solved: its nodes, what is held, where the rest starts.
 *
 *     corners   held, or near where they are said to be, or at the mean of those their edges lead to; a pole opposite to a curve
 *               at the mean of its control points
 *     edges     held curves fitted by their moments; straight lines for the rest, bowed as curves opposite to them are, or, closed,
 *               what is opposite, moved onto planes
 *     inside    the net of Coons of the four edges
 *     all       as the starts of patches say, where they are given
 */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_LAYOUT_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_LAYOUT_H

#include "construct/common/scaling.h"
#include "construct/film/complex/laws.h"
#include "problem/film_complex.h"

typedef struct taut_film_layout {
    taut_film_complex complex; /* its holds in the user's unit */
    double *points;            /* [nodes][3]: held ones and the start, in the user's unit */
    unsigned char *known;      /* [nodes] */
    taut_scaling scaling;
    double *start;          /* [nodes][3], scaled */
    double *tensions;       /* [patch_count] */
    taut_film_drawn *drawn; /* [rope_count] */
    double *
        pressures; /* [cell_count]: given ones over the first tension, scaled; 0 of given volumes */
    double *volumes;  /* [cell_count]: given ones, scaled; 0 of given pressures */
    double *from;     /* [cell_count][3], scaled */
    double deviation; /* of fitted curves */
    int fitted;       /* how many of these */
} taut_film_layout;

/* class[2 p + d], of the edges of patch p along v (d = 0) or u: of one number are those that lie opposite to each other or in a seam. */
void taut_film_strips(const taut_film_problem *problem, int *class);

/* In the arena. Reasons as taut_film_complex_new, curve-fit, start, no-area, overflow, value. */
taut_status taut_film_layout_new(const taut_film_problem *problem, taut_arena *arena,
                                 taut_film_layout *layout, taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_LAYOUT_H */
