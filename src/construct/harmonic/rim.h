/* rim.h -- of a space of polynomials, the one nearest to four boundary rows.
 *
 * Nearest: the sum over the four edges of int |P - given|^2 over the edge's normalised parameter is
 * least. Where the space holds a surface with these rows (biharmonic of bidegree (n, n): always) it
 * is that one. Functions that are odd and even in different ways are orthogonal, and each way is solved for by itself: on a quarter
 * of the boundary, for a quarter of the functions.
 */
#ifndef TAUT_HARMONIC_RIM_H
#define TAUT_HARMONIC_RIM_H

#include "construct/harmonic/space.h"

typedef struct taut_rim {
    const taut_space *space;
    int orbits; /* boundary points that u <-> 1 - u and v <-> 1 - v do not make of others */
    taut_twice *
        response; /* [space->count][orbits]: coefficients of the nearest, for each orbit alone where boundary points are
                             odd and even as the function is */
} taut_rim;

/* Returns 0 when memory runs out, and when the pulse of the space says stop; it is told of what follows too. */
int taut_rim_solve(const taut_space *space, taut_arena *arena, taut_rim *boundary);

/* The nearest net to the boundary points of `given`, double[n+1][m+1][3], of which the others are
 * not read; net [n+1][m+1][3] may be the same array. Returns 0 when memory runs out. */
int taut_rim_net(const taut_rim *boundary, taut_arena *arena, const double *given, double *net);

/* The largest growth from boundary points to net, in the largest-coordinate norm. */
double taut_rim_amplification(const taut_rim *boundary);

#endif /* TAUT_HARMONIC_RIM_H */
