/* border.h -- a step of Newton's method where volumes and lengths are given, and springs stiffen it.
 *
 *     [ B  -C' ] [ d ]   [   -g    ]
 *     [ -C  -D ] [ p ] = [ c - c_0 ]        C = dV, dL; p the pressures, less the forces; D = 0
 *
 *     S = C B^-1 C' + D,   S p = c_0 - c + C B^-1 g,   d = B^-1 (C' p - g)
 *
 * B is definite where C d = 0 if, and only if, the negative pivots of B and the positive ones of S are as many as the rows
 * (Haynsworth's inertia additivity). A spring of stiffness k is a row with D = 1 / k and c = c_0, by which B + k dL dL' is solved
 * (Woodbury); its p is no multiplier.
 */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_BORDER_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_BORDER_H

#include "construct/film/complex/energy.h"

typedef struct taut_film_border {
    int count;       /* of given volumes, then of cables whose force is not given */
    int cells;       /* of volumes */
    int *which;      /* [count]: cell, rope */
    double *p;       /* [count]: of the last step */
    double *z;       /* [count][nodes][3]: B^-1 C' */
    double *s;       /* [count][count] */
    double *excess;  /* [count]: c - c_0 of the last look; 0 of springs */
    double *springs; /* [count]: D of the last factor */
} taut_film_border;

/* In the arena. TAUT_NO_MEMORY. */
taut_status taut_film_border_new(const taut_film_layout *layout, taut_arena *arena,
                                 taut_film_border *border);
/* dV or dL of row i: [nodes][3]. */
const double *taut_film_border_row(const taut_film_border *border, const taut_film_energy *energy,
                                   int i);
/* Is row i a spring's, as cables are taken now? */
int taut_film_border_is_spring(const taut_film_border *border, const taut_film_energy *energy,
                               int i);
/* c - c_0 of the energy's last value; the largest over |c_0|. */
double taut_film_border_look(taut_film_border *border, const taut_film_energy *energy);
/* S of the last factor, which had `negative` pivots that are not positive: how many more directions lead down than rows hold. */
int taut_film_border_factor(taut_film_border *border, const taut_film_energy *energy, int negative,
                            double *right);
/* d and p of that factor. */
void taut_film_border_step(taut_film_border *border, const taut_film_energy *energy,
                           const double *gradient, double *right, double *d);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_BORDER_H */
