/* cells.h -- the surfaces of a net cell by cell, as Bernstein coefficients that know their rounding.
 *
 * Filled as they are asked for, so that each thread has its own.
 */
#ifndef TAUT_CERTIFY_TRACE_CELLS_H
#define TAUT_CERTIFY_TRACE_CELLS_H

#include "certify/common/field.h"
#include "certify/trace/cells_ops.h"
#include "taut/measure.h"

typedef struct taut_net_cell {
    int state;            /* 0 not looked at, 1 known, -1 none */
    taut_field x[4];      /* X, Y, Z, w; points are moved by -origin */
    const double *points; /* of a polynomial: X, Y, Z and 0 of each coefficient */
    double lo[2], hi[2], width[2];
    double error;   /* of a coefficient of X, Y, Z */
    double largest; /* of X, Y, Z */
} taut_net_cell;

typedef struct taut_net_cells {
    taut_arena *arena;
    const taut_net_cell_ops *ops; /* for this processor */
    const taut_surface *const *surfaces;
    double origin[3];
    taut_net_cell **list;      /* of each surface */
    const taut_net_cell *last; /* that was asked for, or NULL */
    int last_on;               /* which surface it is of */
} taut_net_cells;

/* The cells of surfaces about 1 in size. The arena's. TAUT_NO_MEMORY. */
taut_status taut_net_cells_new(taut_arena *arena, int count, const taut_surface *const *surfaces,
                               taut_net_cells **cells);

/* The cell of a span, or of a place; NULL where it is no polynomial, or quotient, of a degree that is small enough. */
const taut_net_cell *taut_net_cell_of(taut_net_cells *cells, int on, const int span[2]);
const taut_net_cell *taut_net_cell_at(taut_net_cells *cells, int on, const double at[2]);

/* S, S_u, S_v (unless NULL) and the forms at a place; 0 where there are none. By the coefficients where the cell is a
 * polynomial and the normal far from vanishing, else by taut_surface_eval and taut_surface_forms_points. */
int taut_net_cells_look(taut_net_cells *cells, int on, const double at[2], double s[3][3],
                        taut_forms *forms);

#endif /* TAUT_CERTIFY_TRACE_CELLS_H */
