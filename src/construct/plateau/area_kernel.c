/* area_kernel.c -- a film's kernels follow the choice of instruction set that the solvers made. */
#include "construct/plateau/area_kernel.h"

#include "numeric/kernel/kernel.h"

#include <string.h>

const taut_film_ops *taut_film_ops_chosen(void)
{
    static const taut_film_ops *const table[] = {
#if defined(__x86_64__)
        &taut_film_avx512,
        &taut_film_avx2,
#endif
        &taut_film_baseline
    };
    const char *name = taut_kernel_name();
    size_t i = 0;
    while (i + 1 < sizeof table / sizeof table[0] && strcmp(table[i]->name, name) != 0) {
        i++;
    }
    return table[i];
}
