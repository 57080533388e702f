/* test_dirichlet.c -- the construction `dirichlet` when memory runs out, by each of its methods. */
#include "check.h"
#include "fault.h"
#include "problems.h"

static void release_model(void *model)
{
    taut_model_free(model);
}

static taut_status make(const void *context, void **result, taut_error *error)
{
    const test_problem *problem = context;
    taut_model *model = *result;
    const taut_status status = taut_dirichlet_make(&problem->data, NULL, &model, error);
    *result = model;
    return status;
}

typedef struct proof {
    const test_problem *problem;
    const taut_model *model;
} proof;

static void release_certificate(void *certificate)
{
    taut_certificate_free(certificate);
}

static taut_status certify(const void *context, void **result, taut_error *error)
{
    const proof *p = context;
    taut_certificate *certificate = *result;
    const taut_status status =
        taut_dirichlet_certify(p->model, &p->problem->data, NULL, &certificate, error);
    *result = certificate;
    return status;
}

/* Four problems: a full boundary; holes anywhere; weights; the best aspect. */
static test_problem problem_of(int kind)
{
    test_problem problem = problem_new(basis_uniform(2, 4), basis_uniform(1, 4));
    problem_random_boundary(&problem);
    if (kind == 1) {
        for (int i = 0; i < 16; i++) {
            problem.known[i] = (unsigned char)(i % 5 == 0);
        }
    } else if (kind == 2) {
        problem_random_weights(&problem, 2);
    } else if (kind == 3) {
        problem.data.aspect_auto = 1;
    }
    return problem;
}

int main(void)
{
    static const char *const names[] = {"boundary", "holes", "weights", "aspect"};
    random_seed(20260113);
    for (int kind = 0; kind < 4; kind++) {
        test_problem problem = problem_of(kind);
        const fault_call call = {names[kind], make, release_model, &problem};
        taut_model *model = NULL;
        CHECK(fault_loop(&call) > 10, "%s takes memory", names[kind]);
        CHECK(taut_dirichlet_make(&problem.data, NULL, &model, NULL) == TAUT_OK, "%s", names[kind]);
        const proof p = {&problem, model};
        if (kind == 0) { /* the others take the same memory, but longer to integrate */
            CHECK(fault_loop(&(fault_call){"certify", certify, release_certificate, &p}) > 10,
                  "proving %s takes memory", names[kind]);
        }
        taut_model_free(model);
        problem_free(&problem);
    }
    CHECK(fault_live() == 0, "%ld blocks left", fault_live());
    return check_failures != 0;
}
