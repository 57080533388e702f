/* border.h -- a step of Newton's method where volumes are given.
 *
 *     [ B  -C' ] [ d ]   [   -g    ]
 *     [ -C  0  ] [ p ] = [ V - V_0 ]        C = dV of the cells of given volume, p their pressures
 *
 *     S = C B^-1 C',   S p = V_0 - V + C B^-1 g,   d = B^-1 (C' p - g)
 *
 * B is definite where C d = 0 if, and only if, the negative pivots of B and the positive ones of S are as many as the volumes
 * (Haynsworth's inertia additivity).
 */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_BORDER_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_BORDER_H

#include "construct/film/complex/energy.h"

typedef struct taut_film_border {
    int count;      /* of given volumes */
    int *cell;      /* [count] */
    double *p;      /* [count]: of the last step */
    double *z;      /* [count][nodes][3]: B^-1 C' */
    double *s;      /* [count][count] */
    double *excess; /* [count]: V - V_0 of the last look */
} taut_film_border;

/* In the arena. TAUT_NO_MEMORY. */
taut_status taut_film_border_new(const taut_film_layout *layout, taut_arena *arena,
                                 taut_film_border *border);
/* V - V_0 of the energy's last value; the largest over |V_0|. */
double taut_film_border_look(taut_film_border *border, const taut_film_energy *energy);
/* S of the last factor, which had `negative` pivots that are not positive: how many more directions lead down than volumes hold. */
int taut_film_border_factor(taut_film_border *border, const taut_film_energy *energy, int negative,
                            double *right);
/* d and p of that factor. */
void taut_film_border_step(taut_film_border *border, const taut_film_energy *energy,
                           const double *gradient, double *right, double *d);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_BORDER_H */
