#include "construct/plateau/density.h"

taut_status taut_area_density_new(const taut_area_functional *functional, taut_arena *arena,
                                  taut_area_density *density)
{
    const size_t nodes = (size_t)functional->u.count * (size_t)functional->v.count;

    density->along_u = taut_arena_take(arena, nodes, sizeof(double));
    density->along_v = taut_arena_take(arena, nodes, sizeof(double));
    density->image =
        taut_arena_take(arena, (size_t)functional->nu * (size_t)functional->nv, 3 * sizeof(double));
    return taut_arena_status(arena);
}
