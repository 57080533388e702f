/* keep.h -- objects that an arena frees: as taut_arena_keep, 0 when memory ran out. */
#ifndef TAUT_GEOMETRY_KEEP_H
#define TAUT_GEOMETRY_KEEP_H

#include "core/arena.h"
#include "geometry/grid/table.h"
#include "taut/model.h"

int taut_keep_basis(taut_arena *arena, taut_basis *basis);
int taut_keep_curve(taut_arena *arena, taut_curve *curve);
int taut_keep_surface(taut_arena *arena, taut_surface *surface);
int taut_keep_table(taut_arena *arena, taut_table *table);
int taut_keep_model(taut_arena *arena, taut_model *model);

#endif /* TAUT_GEOMETRY_KEEP_H */
