/* operate_points.h -- affine maps of points, and adding to models with a reason on failure. */
#ifndef TAUT_GEOMETRY_OPERATE_POINTS_H
#define TAUT_GEOMETRY_OPERATE_POINTS_H

#include "taut/model.h"

#include <stddef.h>

/* *moved, double[count][3], to be freed: A x + b of each point, matrix double[3][4] = (A | b). */
taut_status taut_operate_points(const double *matrix, size_t count, const double *points,
                                double **moved, taut_error *error);

/* The model owns the object afterwards, or it is freed. */
taut_status taut_operate_add_surface(taut_model *model, taut_surface *surface, taut_error *error);
taut_status taut_operate_add_curve(taut_model *model, taut_curve *curve, taut_error *error);

#endif /* TAUT_GEOMETRY_OPERATE_POINTS_H */
