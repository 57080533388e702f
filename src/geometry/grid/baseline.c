/* baseline.c -- grid kernels for any processor. */
#define GRID_LANES 2
#define GRID_STREAM(pointer, value) (FOUR_AT(pointer) = (value))
#define GRID_STREAMS 0
#define GRID_FENCE() ((void)0)
#include "geometry/grid/kernel_body.h"

const taut_grid_ops taut_grid_baseline = GRID_OPS("baseline");
