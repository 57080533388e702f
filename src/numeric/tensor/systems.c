#include "numeric/tensor/internal.h"

#include "core/memory.h"

#include <string.h>

taut_status taut_systems_init(const taut_tensor_solver *solver, int d, int nrhs, taut_systems *out)
{
    const taut_direction *banded = &solver->direction[1 - d];
    const size_t n = (size_t)banded->k.n, w = (size_t)banded->k.width;
    const size_t lane_bytes = (size_t)solver->direction[d].modes->kernel->lanes * sizeof(double);
    *out = (taut_systems){solver, d, taut_alloc_aligned((n + w) * (w + 1), lane_bytes),
                          taut_alloc_aligned(n * (size_t)nrhs, lane_bytes)};
    if (out->factor == NULL || out->x == NULL) {
        return TAUT_NO_MEMORY;
    }
    memset(out->factor, 0, w * (w + 1) * lane_bytes);
    return TAUT_OK;
}

void taut_systems_clear(taut_systems *systems)
{
    taut_free(systems->factor);
    taut_free(systems->x);
    systems->factor = systems->x = NULL;
}

void taut_systems_solve(const taut_systems *systems, int first, int used, int from, int upto,
                        int nrhs)
{
    const taut_direction *diagonal = &systems->solver->direction[systems->d];
    const taut_direction *banded = &systems->solver->direction[1 - systems->d];
    const taut_kernel *kernel = diagonal->modes->kernel;
    double shift[TAUT_LANES_MAX], negative[TAUT_LANES_MAX] = {0};

    for (int l = 0; l < kernel->lanes; l++) {
        shift[l] = diagonal->weight * diagonal->modes->values[first + (l < used ? l : used - 1)];
    }
    kernel->band_factor(from, upto, banded->k.width, banded->k.a, banded->m.a, banded->weight,
                        shift, 0x1p-1000, systems->factor, negative);
    kernel->band_substitute(upto - from, banded->k.width, nrhs, systems->factor, systems->x);
}
