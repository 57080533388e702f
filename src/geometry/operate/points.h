/* points.h -- affine maps of points, and making models with a reason on failure. */
#ifndef TAUT_GEOMETRY_OPERATE_POINTS_H
#define TAUT_GEOMETRY_OPERATE_POINTS_H

#include "basis/change.h"
#include "core/pulse.h"
#include "taut/model.h"

#include <stddef.h>

/* *moved, double[count][3], to be freed: A x + b of each point, matrix double[3][4] = (A | b). */
taut_status taut_operate_points(const double *matrix, size_t count, const double *points,
                                double **moved, taut_error *error);

/* The model owns the object afterwards, or it is freed. */
taut_status taut_operate_add_surface(taut_model *model, taut_surface *surface, taut_error *error);
taut_status taut_operate_add_curve(taut_model *model, taut_curve *curve, taut_error *error);

/* Adds a copy. */
taut_status taut_operate_copy_surface(const taut_surface *surface, taut_model *to,
                                      taut_error *error);
taut_status taut_operate_copy_curve(const taut_curve *curve, taut_model *to, taut_error *error);

/* Adds the object after each change of a list, named with so many dashes (change.h). */
taut_status taut_operate_add_curve_parts(const taut_curve *curve, const taut_change_list *list,
                                         int dashes, taut_model *to, taut_error *error);
taut_status taut_operate_add_surface_parts(const taut_surface *surface, int direction,
                                           const taut_change_list *list, int dashes, taut_model *to,
                                           taut_error *error);
/* Adds every patch of the surface, span by span. pulse, which may be NULL, is told of them. TAUT_NO_SOLUTION: more than a model
 * holds; TAUT_INTERRUPTED. */
taut_status taut_operate_add_patches(const taut_surface *surface, int dashes, taut_pulse *pulse,
                                     taut_model *to, taut_error *error);
/* As taut_surface_pieces, of which pulse is told. */
taut_status taut_operate_pieces(const taut_surface *surface, taut_pulse *pulse, taut_model **pieces,
                                taut_error *error);

/* A new model with the unit of another. */
taut_status taut_operate_begin(const taut_model *model, taut_model **made, taut_error *error);
/* Hands the model over, or frees it. */
taut_status taut_operate_end(taut_status status, taut_model *made, taut_model **result);
/* Puts "/surfaces/i" or "/curves/i" before the place of a failure. */
taut_status taut_operate_placed(taut_status status, const char *array, int i, taut_error *error);

#endif /* TAUT_GEOMETRY_OPERATE_POINTS_H */
