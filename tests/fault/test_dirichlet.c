/* test_dirichlet.c -- making and certifying Dirichlet surfaces when memory runs out. */
#include "calls.h"
#include "check.h"
#include "fault.h"
#include "problems.h"

#include <math.h>

typedef struct fixture {
    test_problem problem;
    taut_model *model;
} fixture;

static taut_status make(const void *context, void **result, taut_error *error)
{
    const fixture *f = context;
    taut_model *model = *result;
    const taut_status status = taut_dirichlet_make(&f->problem.data, NULL, &model, error);
    *result = model;
    return status;
}

static taut_status certify(const void *context, void **result, taut_error *error)
{
    const fixture *f = context;
    taut_certificate *certificate = *result;
    const taut_status status =
        taut_dirichlet_certify(f->model, &f->problem.data, NULL, &certificate, error);
    *result = certificate;
    return status;
}

static void run(const char *what, fixture *f)
{
    const fault_call making = {what, make, release_model, f};
    const fault_call certifying = {what, certify, release_certificate, f};
    CHECK(fault_loop(&making) > 10, "%s: making takes memory", what);
    f->model = problem_make(&f->problem, NULL);
    CHECK(fault_loop(&certifying) > 10, "%s: certifying takes memory", what);
    taut_model_free(f->model);
    problem_free(&f->problem);
}

int main(void)
{
    fixture box = {problem_example(4), NULL};
    fixture pattern = {problem_example(3), NULL};
    fixture rational = {problem_example(1), NULL};
    fixture searched = {problem_example(1), NULL};
    fixture held = {problem_example(4), NULL};
    static const taut_through through[2] = {{0.5, 0.5, {0, 0, 1}}, {NAN, NAN, {0.25, 0.25, 0.5}}};

    random_seed(20260305);
    run("box", &box);
    pattern.problem.known[5] = 1;
    pattern.problem.known[10] = 1;
    run("pattern", &pattern);
    problem_random_weights(&rational.problem, 1.5);
    run("rational", &rational);
    searched.problem.data.aspect_auto = 1;
    run("aspect", &searched);
    held.problem.data.through = through;
    held.problem.data.through_count = 2;
    run("through", &held);
    return check_failures != 0;
}
