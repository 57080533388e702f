/* model.h -- the finished pipe as surfaces, a curve and details. */
#ifndef TAUT_PIPE_MODEL_H
#define TAUT_PIPE_MODEL_H

#include "construct/pipe/blend.h"
#include "construct/pipe/task.h"

/* *model is the caller's on success, untouched on failure. */
taut_status taut_pipe_to_model(const taut_pipe_task *task, const taut_pipe_blend *blend,
                               taut_model **model, taut_error *error);
/* The parts of it: a surface, given its control points and weights; a curve; a disc (ellipse) over
 * the ring where a pipe begins (side 0) or ends (side 1), its u along the flow, from the centre to
 * the ring or from the ring to the centre, so that it looks to the side the pipe looks to; the axis
 * of a task. */
taut_status taut_pipe_add_surface(taut_model *model, const char *name, const taut_basis *u,
                                  const taut_basis *v, const double *points, const double *weights,
                                  taut_error *error);
taut_status taut_pipe_add_curve(taut_model *model, const char *name, const taut_basis *t,
                                const double *points, taut_error *error);
void taut_pipe_cap_points(const double *ring, int side, double points[2][TAUT_PIPE_RING][3]);
taut_status taut_pipe_add_axis(const taut_pipe_task *task, const char *name, taut_model *model,
                               taut_error *error);
/* Polygon, shape and handles of an axis. */
void taut_pipe_add_axis_details(const taut_pipe_task *task, taut_record *details);

#endif /* TAUT_PIPE_MODEL_H */
