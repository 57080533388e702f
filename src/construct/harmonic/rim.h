/* rim.h -- of a space of polynomials, the one nearest to four boundary rows.
 *
 * Nearest: the sum over the four edges of int |P - given|^2 over the edge's normalised parameter is
 * least. Where the space holds a surface with these rows (biharmonic of bidegree (n, n): always) it
 * is that one.
 */
#ifndef TAUT_HARMONIC_RIM_H
#define TAUT_HARMONIC_RIM_H

#include "construct/harmonic/space.h"

typedef struct taut_rim {
    const taut_space *space;
    int count;            /* boundary points: 2 (n + m) */
    taut_twice *response; /* [space->count][count]: coefficients of the nearest for each point alone
                           */
} taut_rim;

/* The index (i, j) of boundary point k: row 0, row n, then the rest of column 0 and of column m. */
void taut_rim_place(int n, int m, int k, int *i, int *j);

/* Returns 0 when memory runs out, and when the pulse of the space says stop; it is told of what follows too. */
int taut_rim_solve(const taut_space *space, taut_arena *arena, taut_rim *boundary);

/* The nearest net to the boundary points of `given`, double[n+1][m+1][3], of which the others are
 * not read; net [n+1][m+1][3] may be the same array. scratch [3 (count + boundary count) + 3 (n+1)
 * (m+1)]. */
void taut_rim_net(const taut_rim *boundary, const double *given, taut_twice *scratch, double *net);

/* The largest growth from boundary points to net, in the largest-coordinate norm. */
double taut_rim_amplification(const taut_rim *boundary);

#endif /* TAUT_HARMONIC_RIM_H */
