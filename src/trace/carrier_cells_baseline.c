/* carrier_cells_baseline.c -- the loops of carrier_cells.c for any processor. */
#include "trace/carrier_cells_body.h"

const taut_carrier_cells_ops taut_carrier_cells_baseline = {evaluate_at};
