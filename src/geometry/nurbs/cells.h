/* cells.h -- where to place Gauss nodes: spans, cut further where functions vary fast.
 *
 * A rational function has poles where w = sum w_i N_i vanishes, beside the range; the rule of n
 * nodes on an interval of width h converges like (1 + d/h + ..)^(-2n), d the distance of the
 * nearest pole ([DLMF] 3.5(v)). Spans are halved until w varies by at most a factor of 4 on each
 * cell, so that d > h/3 or so, and few nodes do.
 *
 * On long spans of hyperbolic bases ([XuWang2006] section 4) the functions are straight but for
 * e^-s, s the distance to an end of the span: few nodes see nothing of it, whatever they agree on.
 * There cells double in width from the ends to the middle.
 */
#ifndef TAUT_GEOMETRY_NURBS_CELLS_H
#define TAUT_GEOMETRY_NURBS_CELLS_H

#include "taut/basis.h"

#include <stddef.h>

typedef struct taut_cells {
    int count;
    double *lo, *hi; /* [count], increasing */
    int *span;       /* [count]: the span each is part of */
} taut_cells;

/* For `lines` sets of weights: of function i on line l, weights[i * step + l * next]; what varies
 * by a factor on every line varies by no more on any positive sum of them. weights NULL: none.
 * TAUT_NO_MEMORY. */
taut_status taut_cells_new(const taut_basis *basis, int lines, const double *weights, size_t step,
                           size_t next, taut_cells **cells);
taut_status taut_cells_copy(const taut_cells *cells, taut_cells **copy); /* TAUT_NO_MEMORY */
void taut_cells_free(taut_cells *cells);                                 /* NULL is fine */

/* The length over which the functions of a span change: what a rounding of t is to be held against.
 */
double taut_cells_finest(const taut_basis *basis, int span);

/* Node g of `count` Gauss nodes on cell k (node on [-1, 1]): t in the closed cell. */
static inline double taut_cells_at(const taut_cells *cells, int k, double node)
{
    const double lo = cells->lo[k], hi = cells->hi[k];
    const double t = lo + (hi - lo) * (0.5 + 0.5 * node);
    return t < hi ? t : hi;
}

#endif /* TAUT_GEOMETRY_NURBS_CELLS_H */
