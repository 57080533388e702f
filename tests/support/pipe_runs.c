#include "pipe_runs.h"

#include "check.h"

#include <math.h>
#include <string.h>

const taut_pipe_leg pipe_stair[4] = {
    {.from = {0, 0, 0}}, {.from = {4, 0, 0}}, {.from = {4, 3, 0}}, {.from = {4, 3, 5}}};
const taut_pipe_leg pipe_placed[3] = {{.from = {0, 0, 0}, .to = {2, 0, 0}},
                                      {.from = {4, 2, 1}, .to = {4, 2, 1}, .direction = {0, 2, 0}},
                                      {.from = {2, 5, 1}, .to = {0, 5, 1}}};

taut_pipe_problem pipe_run_of(taut_pipe_axis axis, const taut_pipe_leg *legs, int count)
{
    const taut_pipe_problem problem = {
        .axis = axis, .legs = legs, .leg_count = count, .radius = 0.2, .alpha = -2, .gamma = -2};
    return problem;
}

static const double pi = 3.14159265358979323846;

void pipe_random_run(int kind, pipe_request *r)
{
    taut_pipe_problem *const p = &r->problem;
    double at[3] = {0, 0, 0};
    const double rise = random_in(0.1, 0.4), twist = random_in(-0.3, 0.3);
    memset(r, 0, sizeof *r);
    *p = (taut_pipe_problem){.radius = 1e-3,
                             .axis = kind == 3 ? TAUT_PIPE_LEGS : TAUT_PIPE_CORNERS,
                             .leg_count = kind == 3   ? 3
                                          : kind == 2 ? 5
                                                      : 7,
                             .closed = kind == 2,
                             .alpha = random_in(-2, 1),
                             .gamma = random_in(-2, 1),
                             .bend_radius = kind == 3 ? 0 : random_in(0.05, 0.3),
                             .joint = random_int(0, 1) == 0 ? TAUT_PIPE_TANGENT
                                                            : TAUT_PIPE_CURVATURE_JOINT};
    for (int i = 0; i < p->leg_count; i++) {
        for (int k = 0; k < 3; k++) {
            const double turn = i * (0.5 * pi + twist * rise);
            const double ring = 2 * pi * i / p->leg_count;
            r->legs[i].from[k] = kind == 1   ? (k == 0   ? cos(turn)
                                                : k == 1 ? sin(turn)
                                                         : rise * i / 4)
                                 : kind == 2 ? (k == 0   ? cos(ring)
                                                : k == 1 ? 0.4 * sin(ring)
                                                         : random_in(-0.3, 0.3))
                                             : at[k];
            at[k] += random_in(-1, 1);
            r->legs[i].to[k] = at[k];
            at[k] += random_in(-1, 1);
        }
    }
}

void pipe_attach(pipe_request *r)
{
    r->problem.legs = r->legs;
}

taut_model *pipe_run_made(pipe_request *r, double tolerance)
{
    const taut_make_options coarse = {.tolerance = tolerance};
    taut_error error = {.message = ""};
    taut_model *model = NULL;
    pipe_attach(r);
    taut_status status = taut_pipe_make(&r->problem, &coarse, &model, &error);
    if (status == TAUT_NO_SOLUTION && strstr(error.message, "LEG_TOO_SHORT") != NULL) {
        r->problem.bend_radius = 0.999 * error.limit;
        r->problem.radius = fmin(r->problem.radius, 0.1 * error.limit);
        status = taut_pipe_make(&r->problem, &coarse, &model, &error);
    }
    CHECK(status == TAUT_OK, "%s %s", error.where, error.message);
    return model;
}
