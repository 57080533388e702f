/* model.h -- the finished pipe as surfaces, a curve and details. */
#ifndef TAUT_PIPE_MODEL_H
#define TAUT_PIPE_MODEL_H

#include "construct/pipe/blend.h"
#include "construct/pipe/task.h"

/* *model is the caller's on success, untouched on failure. */
taut_status taut_pipe_to_model(const taut_pipe_task *task, const taut_pipe_blend *blend,
                               taut_model **model, taut_error *error);
taut_record *taut_pipe_details(const taut_pipe_task *task, const taut_pipe_blend *blend);

#endif /* TAUT_PIPE_MODEL_H */
