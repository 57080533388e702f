/* test_plateau.c -- the construction `plateau` when memory runs out, by each of its methods. */
#include "calls.h"
#include "check.h"
#include "fault.h"
#include "problems.h"

#include "taut/plateau.h"

#include <string.h>

static taut_status make(const void *context, void **result, taut_error *error)
{
    taut_model *model = *result;
    const taut_status status = taut_plateau_make(context, NULL, &model, error);
    *result = model;
    return status;
}

/* The proof of a model. */
typedef struct proof {
    const taut_model *model;
    const taut_plateau_problem *problem;
} proof;

static taut_status prove(const void *context, void **result, taut_error *error)
{
    const proof *p = context;
    taut_certificate *certificate = *result;
    const taut_status status =
        taut_plateau_certify(p->model, p->problem, NULL, &certificate, error);
    *result = certificate;
    return status;
}

/* A plane, whose curvature is measured at once: most of the memory is measure's, tested there. */
static void prove_plane(void)
{
    test_problem net = problem_example(1);
    taut_plateau_problem problem;
    taut_model *model = NULL;

    for (int i = 0; i < 9; i++) {
        net.points[3 * i + 2] = 0;
    }
    memset(&problem, 0, sizeof problem);
    problem.net = net.data;
    problem.method = TAUT_PLATEAU_NORMAL;
    CHECK(taut_plateau_make(&problem, NULL, &model, NULL) == TAUT_OK, "a plane");
    const proof context = {model, &problem};
    const fault_call call = {"certificate", prove, release_certificate, &context};
    CHECK(model == NULL || fault_loop(&call) > 5, "the proof takes memory");
    taut_model_free(model);
    problem_free(&net);
}

/* A straight edge of the unit square, its middle raised. */
static taut_curve *edge(double x0, double y0, double x1, double y1, double middle)
{
    const double points[9] = {x0, y0, 0, 0.5 * (x0 + x1), 0.5 * (y0 + y1), middle, x1, y1, 0};
    taut_basis *t = basis_uniform(2, 3);
    taut_curve *curve = NULL;
    CHECK(taut_curve_new("edge", t, points, NULL, &curve, NULL) == TAUT_OK, "an edge");
    taut_basis_free(t);
    return curve;
}

/* Between curves, on finer spaces, and to a tolerance of the area: some of many allocations. */
static void test_spaces(void)
{
    static const char *const names[] = {"curves", "refine", "tolerance_area", "gap"};
    taut_curve *curves[4] = {edge(0, 0, 0, 1, 0.2), edge(1, 0, 1, 1, 0.1), edge(0, 0, 1, 0, -0.1),
                             edge(0, 1, 1, 1, -0.2)};
    for (int kind = 0; kind < 4; kind++) {
        test_problem net = problem_example(1);
        taut_plateau_problem problem;
        memset(&problem, 0, sizeof problem);
        problem.net = net.data;
        for (int k = 0; k < 4 && kind == 0; k++) {
            problem.curves[k] = curves[k];
        }
        problem.method = TAUT_PLATEAU_NORMAL;
        problem.refine = kind == 1;
        problem.tolerance_area = kind == 2 ? 0.02 : 0;
        problem.gap = kind == 3 ? 1e-3 : 0;
        const fault_call call = {names[kind], make, release_model, &problem};
        CHECK(fault_loop_some(&call, 60) > 60, "%s takes memory", names[kind]);
        problem_free(&net);
    }
    for (int k = 0; k < 4; k++) {
        taut_curve_free(curves[k]);
    }
}

int main(void)
{
    static const char *const names[] = {"full", "normal", "weights"};
    random_seed(20260114);
    for (int kind = 0; kind < 3; kind++) {
        test_problem net = problem_example(1);
        taut_plateau_problem problem;
        memset(&problem, 0, sizeof problem);
        if (kind == 2) {
            problem_random_weights(&net, 1.5);
        }
        problem.net = net.data;
        problem.method = kind == 1 ? TAUT_PLATEAU_NORMAL : TAUT_PLATEAU_FULL;
        const fault_call call = {names[kind], make, release_model, &problem};
        CHECK(fault_loop(&call) > 10, "%s takes memory", names[kind]);
        problem_free(&net);
    }
    test_spaces();
    prove_plane();
    CHECK(fault_live() == 0, "%ld blocks left", fault_live());
    return check_failures != 0;
}
