/* cells_baseline.c -- the loops of cells.c and compose.c for any processor. */
#include "certify/trace/cells_body.h"

const taut_net_cell_ops taut_net_cell_baseline = {sum_cell, compose_cell};
