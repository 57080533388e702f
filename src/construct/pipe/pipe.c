/* pipe.c -- construct `pipe`: check, choose, judge, sweep ([WangBai2018] section 5).
 *
 *   1  the numbers, in local coordinates                                     task.c
 *   2  handles and shape numbers that are not given                          choose.c
 *   3  the axis: its quartic, its bends, its largest radius                  arc.c bend.c reach.c
 *   4  refusals, in this order: NOT_REGULAR, SELF_INTERSECT_LOCAL, SELF_INTERSECT_GLOBAL
 *   5  frames along it, and the tube as NURBS                                frame.c blend.c
 *   6  the model                                                             model.c
 *
 * A run of many goes through the same steps for each blend, and one verdict over all: run.c.
 */
#include "taut/pipe.h"

#include "construct/construct_ops.h"
#include "construct/pipe/frame.h"
#include "construct/pipe/model.h"
#include "construct/pipe/reach.h"
#include "construct/pipe/task.h"
#include "core/fail.h"
#include "problem/pipe.h"

#include <math.h>
#include <stdio.h>

/* Where on the composite axis, in words. */
static void describe_place(const taut_pipe_task *task, double at, char *text, size_t size)
{
    const double scale = task->scale;
    if (at < 0) {
        snprintf(text, size, "pipe 1, %.6g before its end", -at * scale);
    } else {
        snprintf(text, size, "%.6g along the axis", at * scale);
    }
}

static taut_status judge_reach(taut_pipe_task *task, taut_error *error)
{
    const taut_pipe_composite composite = {
        .count = 1, .arcs = &task->arc, .tails = {task->tails[0], task->tails[1]}};
    const double a = task->outer;
    double rho = 0;
    char from[64], to[64];

    taut_pipe_reach_of(&composite, task->reach_scratch, &task->reach);
    rho = task->reach.radius * task->scale;
    if (!(task->radius * task->reach.curvature < 1)) {
        char rest[128];
        taut_pipe_describe_radius(rho, rest, sizeof rest);
        return taut_fail(error, TAUT_NO_SOLUTION, "self-intersect-local", "/radius", a, rho,
                         "SELF_INTERSECT_LOCAL: radius %.12g is not below the least radius of "
                         "curvature %.12g, at t = %.6g; %s",
                         a, task->scale / task->reach.curvature, task->reach.curvature_at, rest);
    }
    if (!(task->radius < task->reach.radius)) {
        describe_place(task, task->reach.binding[0], from, sizeof from);
        describe_place(task, task->reach.binding[1], to, sizeof to);
        char rest[128];
        taut_pipe_describe_radius(rho, rest, sizeof rest);
        return taut_fail(error, TAUT_NO_SOLUTION, "self-intersect-global", "/radius", a, rho,
                         "SELF_INTERSECT_GLOBAL: the pipe touches itself (%s; %s); %s", from, to,
                         rest);
    }
    return TAUT_OK;
}

/* Can Frenet's frame be carried along? */
static taut_status check_frenet(const taut_pipe_task *task, taut_pipe_binormal *binormal,
                                taut_error *error)
{
    const double limit = 1e-9; /* the binormal would turn through pi within 1e-9 of the axis */
    if (task->problem->joint == TAUT_PIPE_G2) {
        return taut_fail(error, TAUT_NO_SOLUTION, "frenet-undefined", "/frame", 0, 0,
                         "FRENET_UNDEFINED: a \"g2\" joint has no curvature, and so no normal; use "
                         "\"rotation-minimizing\"");
    }
    taut_pipe_binormal_of(&task->arc, binormal);
    if (!(binormal->least > 0) && task->bend.curvature == 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "frenet-undefined", "/frame", 0, 0,
                         "FRENET_UNDEFINED: the axis is straight and has no normal; use "
                         "\"rotation-minimizing\"");
    }
    if (!(binormal->least > limit)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "frenet-undefined", "/frame", binormal->least,
                         limit,
                         "FRENET_UNDEFINED: the curvature vanishes at t = %.6g, where the normal "
                         "turns over; use \"rotation-minimizing\"",
                         binormal->least_at);
    }
    return TAUT_OK;
}

/* The ellipses to carry along. */
static taut_status find_ellipses(const taut_pipe_task *task, taut_pipe_profile *profile,
                                 taut_error *error)
{
    const taut_pipe_ellipse *const ellipses = task->problem->section.ellipses;
    const double *const directions[2] = {ellipses[0].direction, ellipses[1].direction};
    int side = 0;
    if (task->problem->frame == TAUT_PIPE_FRENET) {
        return taut_fail(error, TAUT_NO_SOLUTION, "frenet-undefined", "/frame", 0, 0,
                         "FRENET_UNDEFINED: sections have frames of their own; use "
                         "\"rotation-minimizing\"");
    }
    for (int i = 0; i < 2; i++) {
        profile->a[i] = ellipses[i].a / task->outer;
        profile->b[i] = ellipses[i].b / task->outer;
    }
    profile->smooth = task->problem->joint == TAUT_PIPE_G2;
    profile->canal = 0;
    if (!taut_pipe_profile_turn(&task->arc, directions, profile, &side)) {
        return taut_fail(
            error, TAUT_NO_SOLUTION, "section-along",
            side == 0 ? "/sections/0/direction" : "/sections/1/direction", 0, 0,
            "SECTION_ALONG: the direction is along the axis there; give one across it");
    }
    return TAUT_OK;
}

/* Round sections of unlike radii: circles swept naively, or a canal surface that is real and
 * regular. */
static taut_status find_canal(const taut_pipe_task *task, taut_pipe_profile *profile,
                              taut_error *error)
{
    const double least = 1e-3; /* of 1: what is left is a crease but for rounding */
    const taut_pipe_problem *p = task->problem;
    const int is_naive = p->section.kind == TAUT_PIPE_NAIVE_SWEEP;
    taut_pipe_canal_room room;
    taut_pipe_jet jet;

    if (p->joint == TAUT_PIPE_G2 && !is_naive) {
        return taut_fail(error, TAUT_NO_SOLUTION, "canal-joint", "/joint", taut_none, taut_none,
                         "CANAL_JOINT: a canal surface is joined with \"g1\"; use that, or "
                         "\"surface\": \"naive-sweep\"");
    }
    if (p->frame == TAUT_PIPE_FRENET) {
        return taut_fail(error, TAUT_NO_SOLUTION, "frenet-undefined", "/frame", 0, 0,
                         "FRENET_UNDEFINED: radii have frames of their own; use "
                         "\"rotation-minimizing\"");
    }
    *profile = (taut_pipe_profile){.smooth = p->joint == TAUT_PIPE_G2};
    for (int i = 0; i < 2; i++) {
        profile->a[i] = profile->b[i] = p->section.radii[i] / task->outer;
    }
    taut_pipe_arc_jet(&task->arc, 0, &jet);
    taut_pipe_first_normal(jet.tangent, profile->first);
    if (is_naive) {
        return TAUT_OK;
    }
    profile->canal = task->radius;
    taut_pipe_canal_room_of(profile, &task->arc, &room);
    if (!(room.real > least)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "canal-not-real", "/radii", room.real, least,
                         "CANAL_NOT_REAL: the radius changes as fast as the axis runs at t = %.6g, "
                         "so that no envelope is there; radii nearer to each other, ends farther "
                         "apart or longer handles give one",
                         room.real_at);
    }
    if (!(room.regular > least)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "canal-not-regular", "/radii", room.regular,
                         least,
                         "CANAL_NOT_REGULAR: the envelope has a crease at t = %.6g; smaller radii, "
                         "nearer to each other, or ends farther apart avoid it",
                         room.regular_at);
    }
    return TAUT_OK;
}

static taut_status sweep_tube(taut_pipe_task *task, double tolerance, taut_pipe_blend *blend,
                              taut_error *error)
{
    taut_pipe_binormal binormal;
    taut_pipe_profile profile;
    const taut_pipe_section_kind kind = task->problem->section.kind;
    const int is_round = kind == TAUT_PIPE_ROUND;
    const int is_frenet = task->problem->frame == TAUT_PIPE_FRENET;
    const taut_status status = kind == TAUT_PIPE_ELLIPTIC ? find_ellipses(task, &profile, error)
                               : !is_round                ? find_canal(task, &profile, error)
                               : is_frenet                ? check_frenet(task, &binormal, error)
                                                          : TAUT_OK;

    if (status != TAUT_OK) {
        return status;
    }
    return taut_pipe_blend_make(&task->arc, task->radius, tolerance, is_frenet ? &binormal : NULL,
                                is_round ? NULL : &profile, task->arena, "the tube", blend, error);
}

static taut_status make_blend(taut_pipe_task *task, double tolerance, taut_model **model,
                              taut_error *error)
{
    taut_pipe_blend blend;
    taut_status status = taut_pipe_decide(task, "the axis", error);
    if (status != TAUT_OK) {
        return status;
    }
    status = judge_reach(task, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = sweep_tube(task, tolerance, &blend, error);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_pipe_to_model(task, &blend, model, error);
}

taut_status taut_pipe_make(const taut_pipe_problem *problem, const taut_make_options *options,
                           taut_model **model, taut_error *error)
{
    taut_pipe_task task = {.problem = problem,
                           .monitor = options != NULL ? &options->monitor : NULL};
    double tolerance = 0;
    taut_status status = TAUT_OK;

    if (problem == NULL || model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_pipe_make needs a problem and a place for the model");
    }
    status = taut_pipe_tolerance(options, &tolerance, error);
    if (status != TAUT_OK) {
        return status;
    }
    const taut_pipe_choice choices[] = {
        {"/axis", (int)problem->axis.kind, TAUT_PIPE_FEET},
        {"/section", (int)problem->section.kind, TAUT_PIPE_NAIVE_SWEEP},
        {"/shape", (int)problem->shape.kind, TAUT_PIPE_LEAST_CURVATURE},
        {"/frame", (int)problem->frame, TAUT_PIPE_FRENET},
        {"/joint", (int)problem->joint, TAUT_PIPE_G2}};
    status = taut_pipe_check_choices(choices, sizeof choices / sizeof *choices, error);
    if (status != TAUT_OK) {
        return status;
    }
    for (int side = 0; side < 2; side++) {
        task.lengths[side] = problem->lengths[side] > 0 ? problem->lengths[side] : INFINITY;
    }
    task.arena = taut_arena_new();
    status = make_blend(&task, tolerance, model, error);
    taut_arena_free(task.arena);
    return status;
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    const taut_pipe_request *request = data;
    return request->is_run ? taut_pipe_run_make(&request->run, options, model, error)
                           : taut_pipe_make(&request->blend, options, model, error);
}

const taut_construct_ops taut_construct_pipe = {.make = make};
