/* test_pipe.c -- the construction `pipe` and its proof when memory runs out. */
#include "calls.h"
#include "check.h"
#include "fault.h"

#include "taut/pipe.h"

static const taut_make_options coarse = {.tolerance = 1e-2};

static taut_status make(const void *context, void **result, taut_error *error)
{
    taut_model *model = *result;
    const taut_status status = taut_pipe_make(context, &coarse, &model, error);
    *result = model;
    return status;
}

static taut_status make_run(const void *context, void **result, taut_error *error)
{
    taut_model *model = *result;
    const taut_status status = taut_pipe_run_make(context, &coarse, &model, error);
    *result = model;
    return status;
}

typedef struct proof {
    const taut_model *model;
    const taut_pipe_problem *problem;
} proof;

static taut_status prove(const void *context, void **result, taut_error *error)
{
    const proof *p = context;
    taut_certificate *certificate = *result;
    const taut_certify_options options = {.tolerance = 1e-2};
    const taut_status status =
        taut_pipe_certify(p->model, p->problem, &options, &certificate, error);
    *result = certificate;
    return status;
}

typedef struct run_proof {
    const taut_model *model;
    const taut_pipe_run_problem *problem;
} run_proof;

static taut_status prove_run(const void *context, void **result, taut_error *error)
{
    const run_proof *p = context;
    taut_certificate *certificate = *result;
    const taut_certify_options options = {.tolerance = 1e-2};
    const taut_status status =
        taut_pipe_run_certify(p->model, p->problem, &options, &certificate, error);
    *result = certificate;
    return status;
}

/* The neighbours of a chosen shape are many and alike: the first allocations will do. */
static void prove_choice(const taut_model *model, const taut_pipe_problem *problem)
{
    taut_pipe_problem chosen = *problem;
    chosen.shape.kind = TAUT_PIPE_LEAST_CURVATURE;
    const proof context = {model, &chosen};
    const fault_call call = {"chosen", prove, release_certificate, &context};
    fault_loop_first(&call, 90);
}

int main(void)
{
    taut_pipe_problem problem = {
        .axis = {.polygon = {{5, 0, 0}, {5, 2, 0}, {0, 6, 0}, {0, 6, 3}}},
        .section = {.radius = 1},
        .shape = {.alpha = 3, .beta = 2, .gamma = 1, .extended = 1},
    };
    taut_model *model = NULL;
    const fault_call call = {"pipe", make, release_model, &problem};
    CHECK(fault_loop(&call) > 40, "a pipe takes memory");
    CHECK(taut_pipe_make(&problem, &coarse, &model, NULL) == TAUT_OK, "made");
    const proof context = {model, &problem};
    const fault_call certify = {"certificate", prove, release_certificate, &context};
    CHECK(model == NULL || fault_loop(&certify) > 20, "the proof takes memory");
    prove_choice(model, &problem);
    problem.frame = TAUT_PIPE_FRENET;
    problem.lengths[0] = 5;
    problem.axis.polygon[3][2] = 9;
    const fault_call frenet = {"frenet", make, release_model, &problem};
    CHECK(fault_loop(&frenet) > 40, "a pipe takes memory");
    problem.frame = TAUT_PIPE_ROTATION_MINIMIZING;
    problem.joint = TAUT_PIPE_G2;
    problem.shape.alpha = problem.shape.beta = 0;
    const fault_call quintic = {"quintic", make, release_model, &problem};
    CHECK(fault_loop(&quintic) > 40, "a pipe takes memory");
    taut_model_free(model);
    model = NULL;
    problem.section = (taut_pipe_section){
        .kind = TAUT_PIPE_ELLIPTIC, .ellipses = {{0.5, 0.3, {1, 0, 1}}, {0.4, 0.4, {1, 0, 0}}}};
    const fault_call elliptic = {"sections", make, release_model, &problem};
    CHECK(fault_loop(&elliptic) > 40, "a pipe takes memory");
    CHECK(taut_pipe_make(&problem, &coarse, &model, NULL) == TAUT_OK, "made");
    const proof with_sections = {model, &problem};
    const fault_call ellipses = {"ellipses", prove, release_certificate, &with_sections};
    CHECK(model == NULL || fault_loop(&ellipses) > 20, "the proof takes memory");
    taut_model_free(model);
    model = NULL;
    problem.joint = TAUT_PIPE_G1;
    problem.section = (taut_pipe_section){.kind = TAUT_PIPE_CANAL, .radii = {0.5, 0.3}};
    const fault_call canal = {"canal", make, release_model, &problem};
    CHECK(fault_loop(&canal) > 40, "a pipe takes memory");
    CHECK(taut_pipe_make(&problem, &coarse, &model, NULL) == TAUT_OK, "made");
    const proof with_radii = {model, &problem};
    const fault_call spheres = {"spheres", prove, release_certificate, &with_radii};
    CHECK(model == NULL || fault_loop(&spheres) > 20, "the proof takes memory");
    taut_model_free(model);
    model = NULL;
    const double corners[] = {0, 0, 0, 5, 0, 0, 5, 5, 1};
    const taut_pipe_run_problem run = {
        .route = {.kind = TAUT_PIPE_CORNERS, .count = 3, .corners = corners},
        .radius = 0.3,
        .caps = 1};
    const fault_call open_run = {"run", make_run, release_model, &run};
    CHECK(fault_loop(&open_run) > 40, "a run takes memory");
    CHECK(taut_pipe_run_make(&run, &coarse, &model, NULL) == TAUT_OK, "made");
    const run_proof of_run = {model, &run};
    const fault_call certify_run = {"run's certificate", prove_run, release_certificate, &of_run};
    CHECK(model == NULL || fault_loop(&certify_run) > 20, "the proof takes memory");
    taut_model_free(model);
    return check_failures != 0;
}
