/* run_sweep.c -- the frame carried through a run, and its blends as NURBS.
 *
 * On straight pipes the frame does not turn. In a closed run the rotation-minimising frame comes
 * round turned by some angle; each blend takes a part of what is left, by its length, with no rate
 * at its ends, so that straight pipes keep straight lines of points.
 */
#include "construct/pipe/frame.h"
#include "construct/pipe/run.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { STEPS = 4096, INTERVALS = 16 };
static const double frame_comes_round = 1e-12; /* an angle that is none */

/* u made a unit vector across the tangent at one end of an elbow. */
static void make_normal(const taut_pipe_elbow *e, int end, double u[3])
{
    taut_pipe_jet jet;
    double size = 0;
    taut_pipe_arc_jet(&e->task.arc, end, &jet);
    for (int round = 0; round < 2; round++) { /* again: what rounding left */
        taut_add_scaled(-taut_dot(u, jet.tangent), jet.tangent, u);
        size = taut_norm(u);
        for (int k = 0; k < 3; k++) {
            u[k] /= size;
        }
    }
}

/* Arcs carry their frame as a body: what comes round turned stays so. */
static taut_status sweep_rounds(taut_pipe_run *run, taut_error *error)
{
    const double *first = run->straights[0].direction;
    double u[3], start[3], w[3];
    taut_pipe_first_normal(first, u);
    memcpy(start, u, sizeof start);
    for (int i = 0; i < run->elbow_count; i++) {
        const taut_status status = taut_pipe_round_sweep(run, &run->elbows[i], u, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    taut_cross(first, u, w);
    run->holonomy = taut_atan2(taut_dot(start, w), taut_dot(start, u));
    if (run->closed && fabs(run->holonomy) > frame_comes_round) {
        return taut_fail(error, TAUT_NO_SOLUTION, "arc-frame", "/elbow", run->holonomy, 0,
                         "ARC_FRAME: the frame comes round turned by %.6g, and arcs do not turn it "
                         "back: leave \"elbow\" out, or keep the corners in one plane",
                         run->holonomy);
    }
    return TAUT_OK;
}

/* The angle from the frame that came round to the first, and its parts. */
static void close_frame(taut_pipe_run *run)
{
    taut_pipe_elbow *const start = &run->elbows[0];
    double u[3], w[3], total = 0;
    taut_pipe_jet jet;

    memcpy(u, start->first, sizeof u);
    for (int i = 0; i < run->elbow_count; i++) {
        make_normal(&run->elbows[i], 0, u);
        taut_pipe_carry(&run->elbows[i].task.arc, 0, 1, STEPS, u);
        taut_pipe_bend_integrals(&run->elbows[i].task.arc, INTERVALS, &run->elbows[i].task.bend);
        total += run->elbows[i].task.bend.length * run->elbows[i].task.scale;
    }
    make_normal(start, 0, u);
    taut_pipe_arc_jet(&start->task.arc, 0, &jet);
    taut_cross(jet.tangent, u, w);
    run->holonomy = taut_atan2(taut_dot(start->first, w), taut_dot(start->first, u));
    for (int i = 0; i < run->elbow_count; i++) {
        taut_pipe_elbow *const e = &run->elbows[i];
        e->turn = run->holonomy * e->task.bend.length * e->task.scale / total;
    }
}

static taut_status sweep_elbow(taut_pipe_run *run, taut_pipe_elbow *e, double tolerance,
                               taut_error *error)
{
    const taut_pipe_task *task = &e->task;
    taut_pipe_profile circle = {
        .a = {1, 1}, .b = {1, 1}, .turn = e->turn, .smooth = e->problem.joint == TAUT_PIPE_G2};
    size_t count = 0;
    taut_status status = TAUT_OK;

    memcpy(circle.first, e->first, sizeof circle.first);
    status = taut_pipe_blend_make(&task->arc, task->radius, tolerance, NULL, &circle, run->arena,
                                  e->name, &e->blend, error);
    if (status != TAUT_OK) {
        return status;
    }
    count = 3 * (size_t)e->blend.rows * TAUT_PIPE_RING;
    e->points = taut_arena_take(run->arena, count, sizeof *e->points);
    if (e->points == NULL) {
        return taut_fail_memory(error);
    }
    for (size_t i = 0; i < count; i++) {
        e->points[i] = task->polygon[0][i % 3] + task->scale * e->blend.points[i];
    }
    return TAUT_OK;
}

/* Where no straight pipe is between two blends, the second starts with the points the first ends
 * with. */
static void weld_elbows(taut_pipe_run *run)
{
    for (int i = 0; i < run->elbow_count; i++) {
        const int next = (i + 1) % run->straight_count;
        if (next < run->elbow_count && !(run->straights[next].length > 0)) {
            const taut_pipe_elbow *const e = &run->elbows[i];
            memcpy(run->elbows[next].points,
                   e->points + (size_t)(e->blend.rows - 1) * TAUT_PIPE_RING * 3,
                   3 * TAUT_PIPE_RING * sizeof *e->points);
        }
    }
}

taut_status taut_pipe_run_sweep(taut_pipe_run *run, double tolerance, taut_error *error)
{
    double u[3];
    taut_status status = TAUT_OK;
    taut_pipe_jet jet;

    if (run->problem->elbow == TAUT_PIPE_ELBOW_ARC) {
        status = sweep_rounds(run, error);
        if (status == TAUT_OK) {
            weld_elbows(run);
        }
        return status;
    }
    taut_pipe_arc_jet(&run->elbows[0].task.arc, 0, &jet);
    taut_pipe_first_normal(jet.tangent, run->elbows[0].first);
    memcpy(u, run->elbows[0].first, sizeof u);
    if (run->closed) {
        close_frame(run);
    }
    for (int i = 0; i < run->elbow_count; i++) {
        taut_pipe_elbow *const e = &run->elbows[i];
        make_normal(e, 0, u);
        memcpy(e->first, u, sizeof u);
        status = sweep_elbow(run, e, tolerance, error);
        if (status != TAUT_OK) {
            return status;
        }
        memcpy(u, e->blend.last, sizeof u);
    }
    weld_elbows(run);
    for (int i = 0; i < run->elbow_count; i++) {
        const taut_pipe_elbow *const e = &run->elbows[i];
        taut_pipe_straighten(&e->task.arc, &e->blend, run->problem->radius, e->points);
    }
    return TAUT_OK;
}

/* Elbows are as they were, but for the radius. */
static void narrow_elbows(const taut_pipe_run *run, taut_pipe_run *inner)
{
    memcpy(inner->elbows, run->elbows, (size_t)run->elbow_count * sizeof *run->elbows);
    for (int i = 0; i < run->elbow_count; i++) {
        taut_pipe_elbow *const e = &inner->elbows[i];
        e->problem.section.radius = inner->problem->radius;
        e->task.problem = &e->problem;
        if (!(e->round.angle > 0)) { /* arcs have no task */
            e->task.radius = inner->problem->radius / e->task.scale;
        }
    }
}

taut_status taut_pipe_run_sweep_inner(taut_pipe_run *run, double tolerance, taut_error *error)
{
    taut_pipe_run *const inner = taut_arena_take(run->arena, 1, sizeof *inner);
    taut_pipe_run_problem *const problem = taut_arena_take(run->arena, 1, sizeof *problem);
    taut_pipe_elbow *const elbows =
        taut_arena_take(run->arena, (size_t)run->elbow_count, sizeof *elbows);
    if (inner == NULL || problem == NULL || elbows == NULL) {
        return taut_fail_memory(error);
    }
    *problem = *run->problem;
    problem->radius -= problem->wall;
    *inner = *run;
    inner->problem = problem;
    inner->elbows = elbows;
    narrow_elbows(run, inner);
    run->inner = inner;
    return taut_pipe_run_sweep(inner, tolerance, error);
}
