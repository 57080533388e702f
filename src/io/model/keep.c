#include "io/model/keep.h"

static void release_basis(void *basis)
{
    taut_basis_free(basis);
}

static void release_curve(void *curve)
{
    taut_curve_free(curve);
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

int taut_keep_model(taut_arena *arena, taut_model *model)
{
    return taut_arena_keep(arena, model, release_model);
}
