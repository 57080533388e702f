#include "pipe_runs.h"

#include "certificates.h"
#include "check.h"
#include "core/constants.h"

#include <math.h>
#include <string.h>

const double pipe_stair[4][3] = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {4, 3, 5}};
const taut_pipe_leg pipe_placed[3] = {
    {.from = {0, 0, 0}, .to = {2, 0, 0}},
    {.kind = TAUT_PIPE_LEG_POINT, .from = {4, 2, 1}, .direction = {0, 2, 0}},
    {.from = {2, 5, 1}, .to = {0, 5, 1}}};

static taut_pipe_run_problem run_along(taut_pipe_route route)
{
    return (taut_pipe_run_problem){
        .route = route, .radius = 0.2, .shape = {.alpha = -2, .gamma = -2}};
}

taut_pipe_run_problem pipe_run_of_corners(const double (*corners)[3], int count)
{
    return run_along(
        (taut_pipe_route){.kind = TAUT_PIPE_CORNERS, .count = count, .corners = &corners[0][0]});
}

taut_pipe_run_problem pipe_run_of_legs(const taut_pipe_leg *legs, int count)
{
    return run_along((taut_pipe_route){.kind = TAUT_PIPE_LEGS, .count = count, .legs = legs});
}

taut_model *pipe_run_made(const taut_pipe_run_problem *problem, double tolerance)
{
    const taut_make_options options = {.tolerance = tolerance};
    taut_error error = {.message = ""};
    taut_model *model = NULL;
    CHECK(taut_pipe_run_make(problem, &options, &model, &error) == TAUT_OK, "%s %s", error.where,
          error.message);
    return model;
}

taut_certificate *pipe_run_proved(const taut_model *model, const taut_pipe_run_problem *problem,
                                  double tolerance)
{
    const taut_certify_options options = {.tolerance = tolerance};
    taut_certificate *certificate = NULL;
    CHECK(taut_pipe_run_certify(model, problem, &options, &certificate, NULL) == TAUT_OK, "proved");
    return certificate;
}

taut_error pipe_run_refused(const taut_pipe_run_problem *problem, taut_status status,
                            const char *reason)
{
    taut_error error = {.message = ""};
    taut_model *model = NULL;
    CHECK(taut_pipe_run_make(problem, NULL, &model, &error) == status &&
              strcmp(error.reason, reason) == 0 && model == NULL,
          "%s: %s %s %s", reason, error.reason, error.where, error.message);
    taut_model_free(model);
    return error;
}

taut_verdict pipe_run_verdict(const taut_model *model, const taut_pipe_run_problem *problem,
                              const char *name)
{
    taut_certificate *certificate = pipe_run_proved(model, problem, 1e-6);
    const taut_verdict holds = claim_of(certificate, name)->holds;
    taut_certificate_free(certificate);
    return holds;
}

void pipe_random_run(int kind, pipe_random *r)
{
    taut_pipe_run_problem *const p = &r->problem;
    double at[3] = {0, 0, 0};
    const double rise = kind == 1 ? random_in(0.05, 0.1) : random_in(0.1, 0.4),
                 twist = random_in(-0.3, 0.3);
    memset(r, 0, sizeof *r);
    *p = (taut_pipe_run_problem){.route = {.kind = kind == 3 ? TAUT_PIPE_LEGS : TAUT_PIPE_CORNERS,
                                           .count = kind == 3   ? 3
                                                    : kind == 2 ? 5
                                                                : 7,
                                           .closed = kind == 2},
                                 .radius = 1e-3,
                                 .shape = {.alpha = random_in(kind == 1 ? 0 : -2, 1),
                                           .gamma = random_in(kind == 1 ? 0 : -2, 1)},
                                 /* a stair's turns, above each other by half of it at most */
                                 .bend_radius = kind == 3   ? 0
                                                : kind == 1 ? random_in(0.25, 0.3)
                                                            : random_in(0.05, 0.3),
                                 .joint = random_int(0, 1) == 0 ? TAUT_PIPE_G1 : TAUT_PIPE_G2};
    for (int i = 0; i < p->route.count; i++) {
        for (int k = 0; k < 3; k++) {
            const double turn = i * (0.5 * TAUT_PI + twist * rise);
            const double ring = 2 * TAUT_PI * i / p->route.count;
            r->corners[i][k] = kind == 1   ? (k == 0   ? cos(turn)
                                              : k == 1 ? sin(turn)
                                                       : rise * i / 4)
                               : kind == 2 ? (k == 0   ? cos(ring)
                                              : k == 1 ? 0.4 * sin(ring)
                                                       : random_in(-0.3, 0.3))
                                           : at[k];
            r->legs[i].from[k] = r->corners[i][k];
            at[k] += random_in(-1, 1);
            r->legs[i].to[k] = at[k];
            at[k] += random_in(-1, 1);
        }
    }
    pipe_attach(r);
}

void pipe_attach(pipe_random *r)
{
    taut_pipe_route *const route = &r->problem.route;
    if (route->kind == TAUT_PIPE_CORNERS) {
        route->corners = &r->corners[0][0];
    } else {
        route->legs = r->legs;
    }
}

taut_model *pipe_random_made(pipe_random *r, double tolerance)
{
    const taut_make_options coarse = {.tolerance = tolerance};
    taut_error error = {.message = ""};
    taut_model *model = NULL;
    pipe_attach(r);
    taut_status status = taut_pipe_run_make(&r->problem, &coarse, &model, &error);
    if (status == TAUT_NO_SOLUTION && strcmp(error.reason, "leg-too-short") == 0) {
        r->problem.bend_radius = 0.999 * error.limit;
        r->problem.radius = fmin(r->problem.radius, 0.1 * error.limit);
        status = taut_pipe_run_make(&r->problem, &coarse, &model, &error);
    }
    if (status == TAUT_NO_SOLUTION && strncmp(error.reason, "self-intersect-", 15) == 0) {
        r->problem.radius = 0.5 * error.limit;
        status = taut_pipe_run_make(&r->problem, &coarse, &model, &error);
    }
    CHECK(status == TAUT_OK, "%s %s", error.where, error.message);
    return model;
}
