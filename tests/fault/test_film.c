/* test_film.c -- the construction `film` when memory runs out: all of it without the bound of its energy, and the last part of it
 * with. */
#include "calls.h"
#include "check.h"
#include "fault.h"
#include "sails.h"

static taut_status make(const void *context, void **result, taut_error *error)
{
    taut_model *model = *result;
    const taut_status status = taut_film_make(context, NULL, &model, error);
    *result = model;
    return status;
}

/* The proof of a model. */
typedef struct proof {
    const taut_model *model;
    const taut_film_problem *problem;
} proof;

static taut_status prove(const void *context, void **result, taut_error *error)
{
    const proof *p = context;
    taut_certificate *certificate = *result;
    const taut_status status = taut_film_certify(p->model, p->problem, NULL, &certificate, error);
    *result = certificate;
    return status;
}

/* Fails so many allocations of making and proving a sail, or all. */
static void run_out(int without_least, int most)
{
    sail s = sail_new(2, 5, sail_saddle, 2);
    taut_model *model = NULL;

    s.problem.without_least = without_least;
    const fault_call making = {"film", make, release_model, &s.problem};
    CHECK(fault_loop_some(&making, most) > 100, "a film takes memory");
    CHECK(taut_film_make(&s.problem, NULL, &model, NULL) == TAUT_OK, "a sail");
    const proof context = {model, &s.problem};
    const fault_call proving = {"film's certificate", prove, release_certificate, &context};
    CHECK(model == NULL || fault_loop_some(&proving, most) > 100, "a proof takes memory");
    taut_model_free(model);
    sail_free(&s);
}

int main(void)
{
    random_seed(7);
    run_out(1, 2000);
    run_out(0, 60);
    return check_failures != 0;
}
