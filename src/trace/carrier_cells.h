/* carrier_cells.h -- a surface of low degree cell by cell, as polynomials about the cells' middles.
 *
 * Curves ask for the same cell again and again: at s, t in [-1, 1] across it
 *
 *     (wx, wy, wz, w)(s, t) = sum_ij c_ij s^i t^j
 *
 * by Horner's rule is several times less work than the bases' recurrences. Up to degree 5 the powers
 * lose at most two digits to the bases ([Higham2002] 5.1), beyond that there are no cells.
 */
#ifndef TAUT_TRACE_CARRIER_CELLS_H
#define TAUT_TRACE_CARRIER_CELLS_H

#include "core/arena.h"
#include "taut/basis.h"

typedef struct taut_carrier_cells taut_carrier_cells;

/* Of a net [nu][nv][4] over two bases. *cells stays NULL where their degree is too high, they are no
 * polynomials, or there are too many cells to be worth it. TAUT_NO_MEMORY. */
taut_status taut_carrier_cells_new(taut_arena *arena, const taut_basis *const basis[2],
                                   const double *net, const taut_carrier_cells **cells);

/* The derivatives up to `order` (0..3) at `at` of the polynomial of the cell, inside it or not, in the
 * order of taut_jet_power: of wx, wy, wz, and of w. */
void taut_carrier_cells_at(const taut_carrier_cells *cells, const int span[2], const double at[2],
                           int order, double (*x)[3], double *weights);

#endif /* TAUT_TRACE_CARRIER_CELLS_H */
