#include "geometry/keep.h"

static void release_basis(void *basis)
{
    taut_basis_free(basis);
}

static void release_curve(void *curve)
{
    taut_curve_free(curve);
}

static void release_surface(void *surface)
{
    taut_surface_free(surface);
}

static void release_table(void *table)
{
    taut_table_free(table);
}

static void release_model(void *model)
{
    taut_model_free(model);
}

int taut_keep_basis(taut_arena *arena, taut_basis *basis)
{
    return taut_arena_keep(arena, basis, release_basis);
}

int taut_keep_curve(taut_arena *arena, taut_curve *curve)
{
    return taut_arena_keep(arena, curve, release_curve);
}

int taut_keep_surface(taut_arena *arena, taut_surface *surface)
{
    return taut_arena_keep(arena, surface, release_surface);
}

int taut_keep_table(taut_arena *arena, taut_table *table)
{
    return taut_arena_keep(arena, table, release_table);
}

int taut_keep_model(taut_arena *arena, taut_model *model)
{
    return taut_arena_keep(arena, model, release_model);
}
