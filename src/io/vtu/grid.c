#include "io/vtu/grid.h"

#include <math.h>
#include <string.h>

taut_vtu_grid taut_vtu_grid_of(taut_arena *arena, size_t points, size_t cells, size_t corners)
{
    return (taut_vtu_grid){
        .positions = taut_arena_take_raw(arena, points, 3 * sizeof(double)),
        .weights = taut_arena_take_raw(arena, points, sizeof(double)),
        .fields = taut_arena_take_raw(arena, points, TAUT_FIELDS * sizeof(double)),
        .connectivity = taut_arena_take_raw(arena, corners, sizeof(int64_t)),
        .offsets = taut_arena_take_raw(arena, cells, sizeof(int64_t)),
        .types = taut_arena_take_raw(arena, cells, 1),
        .degrees = taut_arena_take_raw(arena, cells, 3 * sizeof(int32_t)),
        .surfaces = taut_arena_take_raw(arena, cells, sizeof(int32_t)),
    };
}

int64_t *taut_vtu_grid_add_cell(taut_vtu_grid *grid, int type, size_t corners, int degree_u,
                                int degree_v, int surface)
{
    int64_t *place = grid->connectivity + grid->corners;
    grid->corners += corners;
    grid->offsets[grid->cells] = (int64_t)grid->corners;
    grid->types[grid->cells] = (uint8_t)type;
    grid->degrees[3 * grid->cells] = degree_u;
    grid->degrees[3 * grid->cells + 1] = degree_v;
    grid->degrees[3 * grid->cells + 2] = 1;
    grid->surfaces[grid->cells] = surface;
    grid->cells++;
    return place;
}

size_t taut_vtu_grid_add_point(taut_vtu_grid *grid, const double *position, double weight)
{
    const size_t index = grid->points++;
    memcpy(grid->positions + 3 * index, position, 3 * sizeof(double));
    grid->weights[index] = weight;
    for (size_t f = 0; f < TAUT_FIELDS; f++) {
        grid->fields[TAUT_FIELDS * index + f] = nan("");
    }
    return index;
}
