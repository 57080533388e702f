/* spread.h -- a model of a cutting pattern to look at: its flat pieces where they are on the roll, beside the surface. */
#ifndef TAUT_IO_FLAT_SPREAD_H
#define TAUT_IO_FLAT_SPREAD_H

#include "taut/model.h"

/* A copy of the model with its details and certificate, the caller's: flat pieces and their outlines (P1, P1.cut) moved, the other lines
 * of pieces left out. NULL in *spread where the model is no such pattern.
 *   plane   to the right and upwards, unit vectors across each other: the pieces lie in that plane, below what the surface takes of it,
 *           the roll in as many rows as make the picture largest; or NULL: on the ground, x and y, the roll in one row
 * TAUT_NO_MEMORY. */
taut_status taut_flat_spread(const taut_model *model, const double plane[2][3],
                             taut_model **spread);

#endif /* TAUT_IO_FLAT_SPREAD_H */
