#include "construct/pipe/run.h"

#include "core/fail.h"

taut_status taut_pipe_run_make(const taut_pipe_problem *problem, double tolerance,
                               taut_model **model, taut_error *error)
{
    taut_pipe_run run = {.problem = problem, .arena = taut_arena_new()};
    taut_model *made = NULL;
    taut_status status =
        run.arena != NULL ? taut_pipe_run_lay(&run, error) : taut_fail_memory(error);

    if (status == TAUT_OK) {
        status = taut_pipe_run_judge(&run, error);
    }
    if (status == TAUT_OK) {
        status = taut_pipe_run_sweep(&run, tolerance, error);
    }
    if (status == TAUT_OK) {
        status = taut_pipe_run_model(&run, &made, error);
    }
    taut_arena_free(run.arena);
    if (status == TAUT_OK) {
        *model = made;
    }
    return status;
}
