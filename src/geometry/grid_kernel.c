/* grid_kernel.c -- which instruction set the grid kernels use. */
#include "geometry/grid_kernel.h"

#include <stdlib.h>
#include <string.h>

#if defined(__x86_64__)
static int has_avx2(void)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

static int has_avx512(void)
{
    return __builtin_cpu_supports("avx512f") && has_avx2();
}
#endif

const taut_grid_ops *taut_grid_ops_chosen(void)
{
    const taut_grid_ops *best = &taut_grid_baseline;
#if defined(__x86_64__)
    const char *forced = getenv("TAUT_KERNEL");
    if (forced != NULL && strcmp(forced, "baseline") == 0) {
        return &taut_grid_baseline;
    }
    if (has_avx2()) {
        best = &taut_grid_avx2;
    }
    if (has_avx512() && !(forced != NULL && strcmp(forced, "avx2") == 0)) {
        best = &taut_grid_avx512;
    }
#endif
    return best;
}
