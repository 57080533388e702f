/* build.h -- what every construction does around its own work: an arena, a model, and the way out
 * of both. */
#ifndef TAUT_CONSTRUCT_COMMON_BUILD_H
#define TAUT_CONSTRUCT_COMMON_BUILD_H

#include "core/arena.h"
#include "taut/model.h"

/* Fills an empty model; scratch from the arena. */
typedef taut_status taut_construct_builder(void *context, taut_arena *arena, taut_model *model,
                                           taut_error *error);

/* Runs a builder on a new arena and a new model. On success *model is the caller's; on failure all
 * is freed and *model as it was. */
taut_status taut_construct_build(taut_construct_builder *build, void *context, taut_model **model,
                                 taut_error *error);

/* A new surface, as taut_surface_new_exact makes it, on bases of its own, into the model. specs[2],
 * counts[2]: of u and v, as taut_basis_new takes them. */
taut_status taut_construct_add_net(taut_model *model, const char *name,
                                   const taut_basis_spec specs[2], const int counts[2],
                                   const double *points, const double *weights,
                                   const char *const *exact, taut_error *error);
/* A surface or a curve just made into the model, which frees it where memory runs out too. */
taut_status taut_construct_add_surface(taut_model *model, taut_surface *surface, taut_error *error);
taut_status taut_construct_add_curve(taut_model *model, taut_curve *curve, taut_error *error);
/* The same of the details; NULL: memory ran out when they were made. */
taut_status taut_construct_set_details(taut_model *model, taut_record *details, taut_error *error);

#endif /* TAUT_CONSTRUCT_COMMON_BUILD_H */
