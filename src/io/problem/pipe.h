/* pipe.h -- the parts of a `pipe` document that have a file of their own. */
#ifndef TAUT_IO_PROBLEM_PIPE_H
#define TAUT_IO_PROBLEM_PIPE_H

#include "core/arena.h"
#include "io/json/in.h"
#include "taut/pipe.h"

/* `run` and `closed`: axis, legs, leg_count, closed; what else is read already stays. */
taut_status taut_document_pipe_run(const taut_json *document, taut_arena *arena,
                                   taut_pipe_problem *data, taut_error *error);
/* A member that is true or false; `value` stays as it is where it is missing. */
taut_status taut_document_pipe_flag(const taut_json *object, const char *key, int *value,
                                    taut_error *error);

#endif /* TAUT_IO_PROBLEM_PIPE_H */
