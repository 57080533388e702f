/* spread.h -- a model of a cutting pattern to look at: its flat pieces where they are on the roll, beside the surface. */
#ifndef TAUT_IO_FLAT_SPREAD_H
#define TAUT_IO_FLAT_SPREAD_H

#include "taut/model.h"

/* A copy of the model with its details and certificate, the caller's: flat pieces and their outlines (P1, P1.cut) moved, the other lines
 * of pieces left out. NULL in *spread where the model is no such pattern. TAUT_NO_MEMORY. */
taut_status taut_flat_spread(const taut_model *model, taut_model **spread);

#endif /* TAUT_IO_FLAT_SPREAD_H */
