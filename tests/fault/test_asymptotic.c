/* test_asymptotic.c -- the construction `asymptotic` and its certificate when memory runs out. */
#include "asymptotic.h"
#include "calls.h"
#include "check.h"
#include "fault.h"

#include <string.h>

static taut_status make(const void *context, void **result, taut_error *error)
{
    taut_model *model = *result;
    const taut_status status = taut_asymptotic_make(context, NULL, &model, error);
    *result = model;
    return status;
}

typedef struct certified {
    const taut_model *model;
    const taut_asymptotic_problem *problem;
} certified;

static taut_status certify(const void *context, void **result, taut_error *error)
{
    const certified *const c = context;
    taut_certificate *certificate = *result;
    const taut_status status =
        taut_asymptotic_certify(c->model, c->problem, NULL, &certificate, error);
    *result = certificate;
    return status;
}

/* Four lines: the quickest quadrilateral of given curves. */
static taut_asymptotic_problem lines(void)
{
    static const double corners[4][3] = {{0, 0, 0}, {2, 0, 1}, {0, 1.5, 1}, {2, 1.5, -0.5}};
    static const int ends[4][2] = {{0, 1}, {0, 2}, {2, 3}, {1, 3}};
    taut_asymptotic_problem problem;
    memset(&problem, 0, sizeof problem);
    problem.given = TAUT_ASYMPTOTIC_CURVES;
    problem.surface = TAUT_BIDEGREE_N_PLUS_3;
    for (int e = 0; e < 4; e++) {
        double line[2][3];
        memcpy(line[0], corners[ends[e][0]], sizeof line[0]);
        memcpy(line[1], corners[ends[e][1]], sizeof line[1]);
        problem.curves[e] = asymptotic_curve(taut_asymptotic_edge_name(e), 1, &line[0][0], NULL);
    }
    return problem;
}

/* A quartic's search takes its room before it begins: later failures would repeat all of it. */
static void try_quartic(void)
{
    const taut_asymptotic_problem problem = asymptotic_example(1, NULL);
    const fault_call call = {"quartic", make, release_model, &problem};
    fault_loop_first(&call, 6);
}

int main(void)
{
    taut_asymptotic_problem cubic = asymptotic_example(3, NULL), given = lines();
    const fault_call first = {"cubic", make, release_model, &cubic};
    const fault_call second = {"four lines", make, release_model, &given};
    certified context = {NULL, &given};
    const fault_call third = {"certify", certify, release_certificate, &context};
    cubic.report_singular = 1;
    CHECK(fault_loop(&first) > 10, "a cubic takes memory");
    try_quartic();
    CHECK(fault_loop(&second) > 10, "given curves take memory");
    context.model = asymptotic_make(&given, "four lines");
    CHECK(fault_loop(&third) > 10, "certify takes memory");
    taut_model_free((taut_model *)(size_t)context.model);
    asymptotic_free_curves(&given);
    CHECK(fault_live() == 0, "%ld blocks left", fault_live());
    return check_failures != 0;
}
