/* keep.h -- objects that an arena frees: as taut_arena_keep, 0 when memory ran out. */
#ifndef TAUT_IO_MODEL_KEEP_H
#define TAUT_IO_MODEL_KEEP_H

#include "core/arena.h"
#include "taut/model.h"

int taut_keep_basis(taut_arena *arena, taut_basis *basis);
int taut_keep_curve(taut_arena *arena, taut_curve *curve);
int taut_keep_model(taut_arena *arena, taut_model *model);

#endif /* TAUT_IO_MODEL_KEEP_H */
