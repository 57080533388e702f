/* kernel.c -- the grid kernels follow the choice of instruction set that the solvers made. */
#include "geometry/grid/kernel.h"

#include "numeric/kernel/name.h"

const taut_grid_ops *taut_grid_ops_chosen(void)
{
    return TAUT_KERNEL_OF(taut_grid);
}
