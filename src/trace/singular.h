/* singular.h -- where the directions of an asymptotic or a principal net vanish: flat points and umbilics.
 *
 * With e1 = x_u / |x_u| and the second form p, q, r in e1, n x e1, the principal directions turn half as fast as
 * the vector (p - r, 2 q), whose zeros they are; asymptotic ones turn with them.
 */
#ifndef TAUT_TRACE_SINGULAR_H
#define TAUT_TRACE_SINGULAR_H

#include "trace/carrier.h"

enum { TAUT_SINGULAR_MAX = 256 };

typedef struct taut_singular {
    double at[2];
    double index; /* turns of the directions round it, counter-clockwise: -1/2 at a monkey saddle */
} taut_singular;

/* Those inside the window that turn the directions, by the turns round the cells of a grid (two opposite ones in a cell
 * are missed); flat: only where both curvatures vanish. Returns how many. */
int taut_singular_find(const taut_carrier *carrier, int flat,
                       taut_singular list[TAUT_SINGULAR_MAX]);

#endif /* TAUT_TRACE_SINGULAR_H */
