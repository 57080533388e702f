/* kernel.c -- the grid kernels follow the choice of instruction set that the solvers made. */
#include "geometry/grid/kernel.h"

#include "numeric/kernel/kernel.h"

#include <string.h>

const taut_grid_ops *taut_grid_ops_chosen(void)
{
    static const taut_grid_ops *const table[] = {
#if defined(__x86_64__)
        &taut_grid_avx512,
        &taut_grid_avx2,
#endif
        &taut_grid_baseline
    };
    const char *name = taut_kernel_name();
    size_t i = 0;
    while (i + 1 < sizeof table / sizeof table[0] && strcmp(table[i]->name, name) != 0) {
        i++;
    }
    return table[i];
}
