/* rounds.h -- what energies in nested spaces tell of the least of all.
 *
 *     E_0, E_1, ..: a geometric series, whose ratio is that of the last two falls, at most 1/4, seems to end at
 *         E = E_n - (E_n-1 - E_n) q / (1 - q)
 */
#ifndef TAUT_CONSTRUCT_FILM_ROUNDS_H
#define TAUT_CONSTRUCT_FILM_ROUNDS_H

#include "taut/record.h"

/* One space of several: how many numbers say how large it is, and the energy in it. */
typedef struct taut_film_stage {
    int sizes;
    double points[2]; /* nu, nv; of many patches, how many in all */
    double energy;
} taut_film_stage;

/* The member `refinement`, of the film itself and of the rounds after it: count of both. */
void taut_film_refinement(const taut_film_stage *rounds, int count, taut_record *details);

#endif /* TAUT_CONSTRUCT_FILM_ROUNDS_H */
