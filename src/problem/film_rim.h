/* film_rim.h -- a film of many patches whose boundary is one closed curve: its sides, and how that curve runs.
 *
 *     sign[p]   +1, -1: seen from sign x_u x x_v all sheets lie on one side of the film
 *     sides     edges in no seam, in turn, run so that the film is on the left seen from there
 */
#ifndef TAUT_PROBLEM_FILM_RIM_H
#define TAUT_PROBLEM_FILM_RIM_H

#include "problem/film_complex.h"

typedef struct taut_film_rim {
    const char *why; /* NULL: it is one; else in a word, and more of them, why not */
    int *sign;       /* [patch_count]; that of the first is 1 */
    int count;
    taut_film_side *sides;
} taut_film_rim;

/* Of films of one tension whose edges are held or in seams of two, without cells and cables: of all others `why` says what stands
 * in the way. In the arena. TAUT_NO_MEMORY. */
taut_status taut_film_rim_find(const taut_film_complex *complex, taut_arena *arena,
                               taut_film_rim *rim);

#endif /* TAUT_PROBLEM_FILM_RIM_H */
