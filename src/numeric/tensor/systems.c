/* systems.c -- the banded systems of many modes, side by side. */
#include "numeric/tensor/internal.h"

taut_systems taut_systems_of(const taut_tensor_solver *solver, int d, int nrhs, taut_arena *arena)
{
    const taut_direction *banded = &solver->direction[1 - d];
    const size_t n = (size_t)banded->k.n, w = (size_t)banded->k.width;
    const size_t lane_bytes = TAUT_LANES * sizeof(double);
    return (taut_systems){solver, d, taut_arena_take(arena, (n + w) * (w + 1), lane_bytes),
                          taut_arena_take(arena, n * (size_t)nrhs, lane_bytes)};
}

void taut_systems_solve(const taut_systems *systems, int first, int used, int from, int upto,
                        int nrhs)
{
    const taut_direction *diagonal = &systems->solver->direction[systems->d];
    const taut_direction *banded = &systems->solver->direction[1 - systems->d];
    const taut_kernel *kernel = diagonal->modes->kernel;
    double shift[TAUT_LANES], negative[TAUT_LANES] = {0};

    for (int l = 0; l < TAUT_LANES; l++) {
        shift[l] = diagonal->weight * diagonal->modes->values[first + (l < used ? l : used - 1)];
    }
    kernel->band_factor(from, upto, banded->k.width, banded->k.a, banded->m.a, banded->weight,
                        shift, 0x1p-1000, systems->factor, negative);
    kernel->band_substitute(upto - from, banded->k.width, nrhs, systems->factor, systems->x);
}

double taut_systems_work(const taut_systems *systems, int rows, size_t nrhs)
{
    const double width = systems->solver->direction[1 - systems->d].k.width;
    return TAUT_LANES * (double)rows * (width + 1) * (width + 1 + 4 * (double)nrhs);
}
