/* choose.c -- handles and shape numbers that are not given.
 *
 * Shape: least bending, or least largest curvature, over the legal box; a coarse grid gives the
 * starts, a search without derivatives the minima ([WangBai2018] section 10.3).
 * Handles of directed ends: least length times bending about the plain cubic (or the given shape):
 * with the ends fixed it has a minimum, and no scaling changes it. Handles of feet: equal, and the
 * shortest for which the largest radius is three times the radius, a long-radius elbow.
 */
#include "construct/pipe/reach.h"
#include "construct/pipe/search.h"
#include "construct/pipe/task.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { COARSE = 5, STARTS = 4, SAMPLES = 64, ROUNDS = 20, BISECTIONS = 40 };

typedef enum pipe_goal {
    GOAL_BENDING,
    GOAL_CURVATURE,
    GOAL_FAIRNESS /* length times bending, which no scaling changes */
} pipe_goal;

static const double infeasible = 1e200, cusped = 1e300;

int taut_pipe_is_stopped(taut_pipe_task *task, const char *what)
{
    const taut_monitor *monitor = task->monitor;
    if (!task->is_stopped && monitor != NULL && monitor->progress != NULL) {
        task->is_stopped = monitor->progress(monitor->context, taut_none, what) != 0;
    }
    return task->is_stopped;
}

/* The chords that count need a turn of pi between their ends, or of half that where one of them is
 * a free end. */
static int may_touch(const taut_pipe_task *task, double turning)
{
    const int is_free = isfinite(task->tails[0]) || isfinite(task->tails[1]);
    return turning > 0.99 * (is_free ? 0.5 * TAUT_PI : TAUT_PI);
}

/* What a choice is worth: `goal` where the pipe fits, with room; else 1e200 and more, growing with
 * what is missing. Of one that is not below `bound` so much is known as soon as part of an integral or one place shows it: it is `bound`
 * then. */
static double merit_of(taut_pipe_task *task, const double edges[3][3], const double shape[3],
                       pipe_goal goal, double bound, taut_pipe_bend_stop *stop)
{
    const int is_bounded = bound < infeasible; /* by one that fits */
    taut_pipe_arc arc;
    taut_pipe_bend bend;
    double room = 0, value = 0;

    if (taut_pipe_is_stopped(task, "choosing")) {
        return cusped;
    }
    taut_pipe_arc_of(task, edges, shape, &arc);
    if (task->nodes_degree != arc.degree) {
        taut_pipe_nodes_fill(arc.degree, TAUT_PIPE_INTERVALS, task->nodes[0]);
        taut_pipe_nodes_fill(arc.degree, TAUT_PIPE_INTERVALS_FINE, task->nodes[1]);
        task->nodes_degree = arc.degree;
    }
    if (!taut_pipe_bend_integrals_below(
            &arc, task->intervals, task->nodes[task->intervals == TAUT_PIPE_INTERVALS_FINE],
            goal == GOAL_FAIRNESS, is_bounded && goal != GOAL_CURVATURE ? bound : INFINITY,
            &bend)) {
        return bound;
    }
    stop->curvature = is_bounded && goal == GOAL_CURVATURE ? bound : INFINITY;
    stop->factor = fmax(task->radius, task->bend_radius);
    stop->room = is_bounded ? TAUT_PIPE_ROOM : INFINITY;
    if (!taut_pipe_bend_extremes_below(&arc, SAMPLES, stop, &bend)) {
        return bound;
    }
    if (taut_pipe_bend_is_cusp(&bend)) {
        return cusped;
    }
    room = stop->factor * bend.curvature;
    value = goal == GOAL_CURVATURE ? bend.curvature
            : goal == GOAL_BENDING ? bend.bending
                                   : bend.length * bend.bending;
    if (room < TAUT_PIPE_ROOM && value < bound && may_touch(task, bend.turning)) {
        const taut_pipe_composite composite = {
            .count = 1,
            .arcs = &arc,
            .tails = {task->tails[0], task->tails[1]},
            .samples = SAMPLES,
        };
        taut_pipe_reach reach;
        taut_pipe_reach_of(&composite, task->reach_scratch, &reach);
        room = fmax(room, task->radius / reach.radius);
    }
    return room < TAUT_PIPE_ROOM ? value : infeasible * (1 + fmin(room, 1e90));
}

/* One search: the variables are shape numbers, or logarithms of handles. */
typedef struct search {
    taut_pipe_task *task;
    pipe_goal goal;
    int side;     /* the handle that is sought; 2: both */
    double bound; /* the best value of this search: no more is asked of worse ones */
    taut_pipe_bend_stop stop;
} search;

static double lower_bound(search *s, double value)
{
    s->bound = fmin(s->bound, value);
    return value;
}

static double shape_merit(void *context, const double *x)
{
    search *s = context;
    return lower_bound(
        s, merit_of(s->task, (const double(*)[3])s->task->edges, x, s->goal, s->bound, &s->stop));
}

static double handle_merit(void *context, const double *x)
{
    search *s = context;
    double handles[2] = {s->task->handles[0], s->task->handles[1]}, edges[3][3];
    if (s->side == 2) {
        handles[0] = taut_exp(x[0]);
        handles[1] = taut_exp(x[1]);
    } else {
        handles[s->side] = taut_exp(x[0]);
    }
    taut_pipe_edges(s->task, handles, edges);
    return lower_bound(s, merit_of(s->task, (const double(*)[3])edges, s->task->shape, s->goal,
                                   s->bound, &s->stop));
}

/* A step to the best of the neighbours at a part `step` of the box; 0 if none is better. */
static int step_aside(int count, const double *lo, const double *hi, double step,
                      taut_pipe_objective f, search *s, double *best, double *least)
{
    double from[TAUT_PIPE_SEARCH_MAX];
    int neighbours = 1, better = 0;
    memcpy(from, best, (size_t)count * sizeof *from);
    for (int k = 0; k < count; k++) {
        neighbours *= 3;
    }
    for (int code = 0; code < neighbours; code++) {
        double x[TAUT_PIPE_SEARCH_MAX], value = 0;
        int inside = 1;
        for (int k = 0, rest = code; k < count; k++, rest /= 3) {
            x[k] = from[k] + (rest % 3 - 1) * step * (hi[k] - lo[k]);
            inside = inside && x[k] >= lo[k] && x[k] <= hi[k];
        }
        value = inside ? f(s, x) : INFINITY;
        s->task->evaluations += inside;
        if (value < *least) {
            *least = value;
            memcpy(best, x, (size_t)count * sizeof *best);
            better = 1;
        }
    }
    return better;
}

/* A search that ended in a crease is helped out of it: whatever neighbour near or far is better
 * begins another. */
static double leave_creases(int count, const double *lo, const double *hi, taut_pipe_objective f,
                            search *s, double *best)
{
    double least = 0;
    s->task->intervals = TAUT_PIPE_INTERVALS_FINE;
    s->bound = INFINITY;
    least = f(s, best);
    for (int round = 0; round < ROUNDS; round++) {
        if (!step_aside(count, lo, hi, 1.0 / 64, f, s, best, &least) &&
            !step_aside(count, lo, hi, 1.0 / 4096, f, s, best, &least)) {
            break;
        }
        least = taut_pipe_search(count, lo, hi, s->goal == GOAL_CURVATURE, f, s, best,
                                 &s->task->evaluations);
    }
    return least;
}

/* The best of a grid over the box, as starts for as many searches: points that are better than
 * those beside them come before others only by their values, which is enough for four starts. A
 * variable that makes no difference takes its value in `plain`. */
static double search_from_grid(int count, const double *lo, const double *hi, const double *plain,
                               taut_pipe_objective f, search *s, double *best)
{
    double starts[STARTS][TAUT_PIPE_SEARCH_MAX], values[STARTS], least = INFINITY;
    int cells = 1, kept = 0;
    s->task->intervals = TAUT_PIPE_INTERVALS;
    for (int k = 0; k < count; k++) {
        cells *= COARSE;
    }
    for (int cell = 0; cell < cells; cell++) {
        double x[TAUT_PIPE_SEARCH_MAX] = {0}, value = 0;
        int slot = 0;
        for (int k = 0, rest = cell; k < count; k++, rest /= COARSE) {
            x[k] = lo[k] + (hi[k] - lo[k]) * (rest % COARSE + 0.5) / COARSE;
        }
        s->bound = INFINITY;
        value = f(s, x);
        for (slot = kept; slot > 0 && value < values[slot - 1]; slot--) {
            if (slot < STARTS) {
                values[slot] = values[slot - 1];
                memcpy(starts[slot], starts[slot - 1], sizeof starts[slot]);
            }
        }
        if (slot < STARTS) {
            values[slot] = value;
            memcpy(starts[slot], x, sizeof starts[slot]);
            kept = kept < STARTS ? kept + 1 : kept;
        }
    }
    s->task->evaluations += cells;
    for (int k = 0; k < kept; k++) {
        s->bound = INFINITY;
        const double value = taut_pipe_search(count, lo, hi, s->goal == GOAL_CURVATURE, f, s,
                                              starts[k], &s->task->evaluations);
        if (value < least) {
            least = value;
            memcpy(best, starts[k], (size_t)count * sizeof *best);
        }
    }
    least = leave_creases(count, lo, hi, f, s, best);
    for (int k = 0; k < count; k++) {
        const double kept_value = best[k];
        best[k] = plain[k];
        s->bound = INFINITY;
        if (!(f(s, best) <= least)) {
            best[k] = kept_value;
        }
    }
    return least;
}

taut_status taut_pipe_choose_shape(taut_pipe_task *task, taut_error *error)
{
    const double lo[3] = {-3 + 0x1p-7, -3, -3 + 0x1p-7}, hi[3] = {1, 3, 1};
    const double plain[3] = {0, 0, 0};
    search s = {.task = task};

    if (task->problem->shape.kind == TAUT_PIPE_SHAPE_GIVEN) {
        return TAUT_OK;
    }
    s.goal = task->problem->shape.kind == TAUT_PIPE_LEAST_CURVATURE ? GOAL_CURVATURE : GOAL_BENDING;
    if (search_from_grid(3, lo, hi, plain, shape_merit, &s, task->shape) >= cusped &&
        !task->is_stopped) {
        return taut_fail(error, TAUT_NO_SOLUTION, "not-regular", "/shape", taut_none, taut_none,
                         "NOT_REGULAR: the axis has a cusp with all shape numbers tried; move an "
                         "end aside, turn a direction, or give other handles");
    }
    task->chose_shape = 1;
    return TAUT_OK; /* what does not fit is refused with the best there is, by whoever judges it */
}

/* The largest radius over the radius with these handles, or three times the least radius of
 * curvature over the one asked for. */
static double room_of(taut_pipe_task *task, const double handles[2])
{
    taut_pipe_arc arc;
    taut_pipe_reach reach;
    double edges[3][3];
    const taut_pipe_composite composite = {
        .count = 1, .arcs = &arc, .tails = {task->tails[0], task->tails[1]}, .samples = SAMPLES};
    if (taut_pipe_is_stopped(task, "choosing")) {
        return 0;
    }
    taut_pipe_edges(task, handles, edges);
    taut_pipe_arc_of(task, (const double(*)[3])edges, task->shape, &arc);
    taut_pipe_reach_of(&composite, task->reach_scratch, &reach);
    return fmin(reach.radius / task->radius,
                task->bend_radius > 0
                    ? 3 / (reach.curvature * task->bend_radius * (1 + TAUT_PIPE_SLACK))
                    : INFINITY);
}

static void set_missing(const taut_pipe_task *task, double h, double handles[2])
{
    for (int side = 0; side < 2; side++) {
        handles[side] = task->problem->axis.ends[side].handle > 0 ? task->handles[side] : h;
    }
}

/* Doubled from a quarter of the radius, or of the distance of the feet, until the largest radius is
 * three radii, then bisected. A given handle may be too short for that: then the best seen is taken.
 */
static void choose_feet(taut_pipe_task *task)
{
    const double wanted = 3;
    double h = 0.25 * fmax(task->radius, taut_norm(task->across)), lo = h, best = -1, handles[2];
    int found = 0;
    for (int k = 0; k < 24 && !found; k++) {
        double room = 0;
        set_missing(task, h, handles);
        room = room_of(task, handles);
        task->evaluations++;
        found = room >= wanted;
        if (room > best) {
            best = room;
            memcpy(task->handles, handles, sizeof handles);
        }
        lo = !found || k == 0 ? h : lo;
        h = found ? h : 2 * h;
    }
    for (int k = 0; k < BISECTIONS && found; k++) {
        const double middle = 0.5 * (lo + h);
        set_missing(task, middle, handles);
        *(room_of(task, handles) >= wanted ? &h : &lo) = middle;
        task->evaluations++;
    }
    if (found) {
        set_missing(task, h, handles);
        memcpy(task->handles, handles, sizeof handles);
    }
}

static void choose_ends(taut_pipe_task *task, int side)
{
    const double size = fmax(taut_norm(task->across), task->radius);
    const double lo[2] = {taut_log(size / 64), taut_log(size / 64)},
                 hi[2] = {taut_log(4 * size), taut_log(4 * size)};
    const double plain[2] = {taut_log(size / 3), taut_log(size / 3)};
    search s = {.task = task, .goal = GOAL_FAIRNESS, .side = side};
    double x[2] = {0, 0};
    search_from_grid(side == 2 ? 2 : 1, lo, hi, plain, handle_merit, &s, x);
    if (side == 2) {
        task->handles[0] = taut_exp(x[0]);
        task->handles[1] = taut_exp(x[1]);
    } else {
        task->handles[side] = taut_exp(x[0]);
    }
}

void taut_pipe_choose_handles(taut_pipe_task *task)
{
    const taut_pipe_axis *axis = &task->problem->axis;
    const int first = !(task->handles[0] > 0), second = !(task->handles[1] > 0);

    if (axis->kind == TAUT_PIPE_POLYGON || (!first && !second)) {
        return;
    }
    if (task->problem->shape.kind != TAUT_PIPE_SHAPE_GIVEN) {
        memset(task->shape, 0, sizeof task->shape);
    }
    if (axis->kind == TAUT_PIPE_FEET) {
        choose_feet(task);
    } else {
        choose_ends(task, first && second ? 2 : first ? 0 : 1);
    }
}
