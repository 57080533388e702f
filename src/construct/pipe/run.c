/* run.c -- construct a run: its pieces laid, one axis out of all of them and its verdict, the frame
 * carried through, the model. */
#include "construct/pipe/run.h"
#include "construct/pipe/reach.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The pieces in the order of flow, with their names for messages. */
typedef struct chain {
    int count;
    taut_pipe_arc *arcs;
    char (*names)[24];
    double *from; /* arc length, in the run's unit, where each begins */
} chain;

static void set_local(taut_pipe_run *run)
{
    double size = run->problem->radius;
    memcpy(run->origin, run->straights[0].to, sizeof run->origin);
    for (int i = 0; i < run->straight_count; i++) {
        for (int k = 0; k < 3; k++) {
            size = fmax(size, fabs(run->straights[i].from[k] - run->origin[k]));
            size = fmax(size, fabs(run->straights[i].to[k] - run->origin[k]));
        }
    }
    run->scale = taut_pipe_power_below(size);
}

static void add_straight(const taut_pipe_run *run, int i, chain *c)
{
    const taut_pipe_straight *s = &run->straights[i];
    taut_pipe_arc *const arc = &c->arcs[c->count];
    if (!(s->length > 0)) {
        return;
    }
    *arc = (taut_pipe_arc){.degree = 2};
    for (int k = 0; k < 3; k++) {
        arc->points[0][k] = (s->from[k] - run->origin[k]) / run->scale;
        arc->points[2][k] = (s->to[k] - run->origin[k]) / run->scale;
        arc->points[1][k] = 0.5 * (arc->points[0][k] + arc->points[2][k]);
    }
    taut_pipe_arc_finish(arc);
    memset(arc->cross, 0, sizeof arc->cross); /* exactly straight */
    snprintf(c->names[c->count], sizeof c->names[0], "pipe%d", i + 1);
    c->from[c->count + 1] = c->from[c->count] + s->length;
    c->count++;
}

static void add_round(const taut_pipe_run *run, const taut_pipe_elbow *e, chain *c)
{
    const int parts = taut_pipe_round_parts(&e->round, run->origin, run->scale, &c->arcs[c->count]);
    for (int i = 0; i < parts; i++) {
        memcpy(c->names[c->count], e->name, sizeof e->name);
        c->from[c->count + 1] = c->from[c->count] + e->round.radius * e->round.angle / parts;
        c->count++;
    }
}

static void add_elbow(const taut_pipe_run *run, int i, chain *c)
{
    const taut_pipe_elbow *e = &run->elbows[i];
    const double *start = e->task.polygon[0];
    if (e->round.angle > 0) {
        add_round(run, e, c);
        return;
    }
    taut_pipe_arc *const arc = &c->arcs[c->count];
    taut_pipe_bend bend;
    double edges[3][3];
    for (int j = 0; j < 9; j++) {
        edges[j / 3][j % 3] = e->task.edges[j / 3][j % 3] * (e->task.scale / run->scale);
    }
    taut_pipe_arc_of(&e->task, (const double(*)[3])edges, e->task.shape, arc);
    for (int j = 0; j <= arc->degree; j++) {
        for (int k = 0; k < 3; k++) {
            arc->points[j][k] += (start[k] - run->origin[k]) / run->scale;
        }
    }
    taut_pipe_bend_integrals(arc, 16, &bend);
    memcpy(c->names[c->count], e->name, sizeof e->name);
    c->from[c->count + 1] = c->from[c->count] + bend.length * run->scale;
    c->count++;
}

static taut_status chain_pieces(taut_pipe_run *run, chain *c, taut_error *error)
{
    const size_t most =
        (size_t)run->straight_count +
        (size_t)run->elbow_count *
            (run->problem->elbow == TAUT_PIPE_ELBOW_ARC ? TAUT_PIPE_ROUND_PARTS : 1);
    c->arcs = taut_arena_take(run->arena, most, sizeof *c->arcs);
    c->names = taut_arena_take(run->arena, most, sizeof *c->names);
    c->from = taut_arena_take(run->arena, most + 1, sizeof *c->from);
    if (c->arcs == NULL || c->names == NULL || c->from == NULL) {
        return taut_fail_memory(error);
    }
    c->from[0] = 0;
    for (int i = 0; i < run->straight_count; i++) {
        add_straight(run, i, c);
        if (i < run->elbow_count) {
            add_elbow(run, i, c);
        }
    }
    return TAUT_OK;
}

/* The piece at an arc length of the whole. */
static const char *name_at(const chain *c, double at, double *along)
{
    int i = 0;
    while (i + 1 < c->count && at > c->from[i + 1]) {
        i++;
    }
    *along = fmax(0, at - c->from[i]);
    return c->names[i];
}

static taut_status judge_run(taut_pipe_run *run, taut_error *error)
{
    const double a = run->problem->radius;
    chain c = {.count = 0};
    double *scratch = NULL, rho = 0, along[2];
    char rest[128];
    taut_status status = TAUT_OK;

    set_local(run);
    status = chain_pieces(run, &c, error);
    if (status != TAUT_OK) {
        return status;
    }
    scratch = taut_arena_take(run->arena, TAUT_PIPE_REACH_ROOM(c.count), sizeof *scratch);
    if (scratch == NULL) {
        return taut_fail_memory(error);
    }
    taut_pulse pulse = {.monitor = run->monitor, .what = "choosing", .done = taut_none};
    const taut_pipe_composite composite = {
        .count = c.count, .arcs = c.arcs, .closed = run->closed, .pulse = &pulse};
    taut_pipe_reach_of(&composite, scratch, &run->reach);
    if (taut_pulse_report(&pulse)) {
        return taut_fail_status(error, TAUT_INTERRUPTED);
    }
    rho = run->reach.radius * run->scale;
    taut_pipe_describe_radius(rho, rest, sizeof rest);
    if (!(a * run->reach.curvature < run->scale)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "self-intersect-local", "/radius", a, rho,
                         "SELF_INTERSECT_LOCAL: radius %.12g is not below the least radius of "
                         "curvature %.12g, of %s at t = %.6g; %s",
                         a, run->scale / run->reach.curvature, c.names[run->reach.curvature_arc],
                         run->reach.curvature_at, rest);
    }
    if (!(a < rho)) {
        const char *one = name_at(&c, run->reach.binding[0] * run->scale, &along[0]);
        const char *two = name_at(&c, run->reach.binding[1] * run->scale, &along[1]);
        return taut_fail(error, TAUT_NO_SOLUTION, "self-intersect-global", "/radius", a, rho,
                         "SELF_INTERSECT_GLOBAL: %s, %.6g along it, touches %s, %.6g along it; %s",
                         one, along[0], two, along[1], rest);
    }
    return TAUT_OK;
}

static taut_status make_run(taut_pipe_run *run, double tolerance, taut_model **model,
                            taut_error *error)
{
    taut_status status = taut_pipe_run_lay(run, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = judge_run(run, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_pipe_run_sweep(run, tolerance, error);
    if (status == TAUT_OK && run->problem->wall > 0) {
        status = taut_pipe_run_sweep_inner(run, tolerance, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    return taut_pipe_run_model(run, model, error);
}

taut_status taut_pipe_run_make(const taut_pipe_run_problem *problem,
                               const taut_make_options *options, taut_model **model,
                               taut_error *error)
{
    taut_pipe_run run = {.problem = problem, .monitor = options != NULL ? &options->monitor : NULL};
    double tolerance = 0;
    taut_status status = TAUT_OK;

    if (problem == NULL || model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_pipe_run_make needs a problem and a place for the model");
    }
    status = taut_pipe_tolerance(options, &tolerance, error);
    if (status != TAUT_OK) {
        return status;
    }
    run.arena = taut_arena_new();
    status = make_run(&run, tolerance, model, error);
    taut_arena_free(run.arena);
    return status;
}
