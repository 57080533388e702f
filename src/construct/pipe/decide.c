/* decide.c -- from the numbers of a problem to its axis, with what is not given decided; refused
 * where it bends too sharply. */
#include "construct/pipe/task.h"
#include "core/fail.h"

#include <stdio.h>

void taut_pipe_describe_radius(double rho, char *text, size_t size)
{
    if (rho > 0) {
        snprintf(text, size, "the largest radius that would work is below %.12g", rho);
    } else {
        snprintf(text, size,
                 "the axis meets itself, so that no radius would work: other points, "
                 "shape numbers or shorter straight pipes may");
    }
}

/* The axis of the polygon and shape that were settled, with its bends; reach apart from it. */
static void analyse_axis(taut_pipe_task *task)
{
    taut_pipe_arc_of(task, (const double(*)[3])task->edges, task->shape, &task->arc);
    taut_pipe_bend_extremes(&task->arc, 2 * TAUT_PIPE_REACH_SAMPLES, &task->bend);
}

/* NOT_REGULAR and BEND_RADIUS. */
static taut_status judge_bends(const taut_pipe_task *task, const char *name, taut_error *error)
{
    const double least = task->scale / task->bend.curvature, asked = task->problem->bend_radius;
    if (taut_pipe_bend_is_cusp(&task->bend)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "not-regular", "/shape", task->bend.least_speed,
                         0,
                         "NOT_REGULAR: %s has a cusp at t = %.6g; other shape numbers or shorter "
                         "handles avoid it",
                         name, task->bend.least_speed_at);
    }
    if (asked * task->bend.curvature > task->scale) {
        return taut_fail(error, TAUT_NO_SOLUTION, "bend-radius", "/bend_radius", asked,
                         TAUT_PIPE_ROOM * least,
                         "BEND_RADIUS: %s bends with a radius of %.12g at t = %.6g; a bend radius "
                         "below %.12g would work, or more room between its ends",
                         name, least, task->bend.curvature_at, TAUT_PIPE_ROOM * least);
    }
    return TAUT_OK;
}

taut_status taut_pipe_decide(taut_pipe_task *task, const char *name, taut_error *error)
{
    taut_status status = TAUT_OK;

    task->reach_scratch = taut_arena_take(task->arena, TAUT_PIPE_REACH_ROOM(1), sizeof(double));
    task->nodes[0] = taut_arena_take(task->arena, TAUT_PIPE_INTERVALS, sizeof *task->nodes[0]);
    task->nodes[1] = taut_arena_take(task->arena, TAUT_PIPE_INTERVALS_FINE, sizeof *task->nodes[1]);
    if (taut_arena_status(task->arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = taut_pipe_begin(task, error);
    if (status != TAUT_OK) {
        return status;
    }
    taut_pipe_choose_handles(task);
    status = task->is_stopped ? TAUT_OK : taut_pipe_settle(task, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = task->is_stopped ? TAUT_OK : taut_pipe_choose_shape(task, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (taut_pipe_is_stopped(task, "axis")) {
        return taut_fail_status(error, TAUT_INTERRUPTED);
    }
    analyse_axis(task);
    return judge_bends(task, name, error);
}
