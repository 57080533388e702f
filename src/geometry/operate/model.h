/* model.h -- what the operations on whole models share. */
#ifndef TAUT_GEOMETRY_OPERATE_MODEL_H
#define TAUT_GEOMETRY_OPERATE_MODEL_H

#include "taut/model.h"

/* Is there anything to work on: an object, and one of this name unless it is NULL? */
taut_status taut_operate_named(const taut_model *model, const char *name, taut_error *error);

/* How many dashes keep the names of `pieces` pieces of object i of a model (surfaces first, then
 * curves) apart from all others, those made so far included. */
int taut_operate_dashes(const taut_model *from, int i, int pieces, const taut_model *so_far);

taut_status taut_operate_copy_surface(const taut_surface *surface, taut_model *to,
                                      taut_error *error);
taut_status taut_operate_copy_curve(const taut_curve *curve, taut_model *to, taut_error *error);

#endif /* TAUT_GEOMETRY_OPERATE_MODEL_H */
