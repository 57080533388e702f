/* test_trace.c -- a net with laths, from its document, when memory runs out. */
#include "calls.h"
#include "check.h"
#include "fault.h"

#include "taut/taut.h"

static const char document[] =
    "{\"taut\": 1, \"trace\": \"asymptotic\", \"of\": {\"taut\": 1, \"surfaces\": [{\"u\": "
    "{\"type\": "
    "\"bezier\", \"degree\": 1}, \"v\": {\"type\": \"bezier\", \"degree\": 1}, \"points\": [[[0, "
    "0, "
    "1], [0, 1, -1]], [[1, 0, -1], [1, 1, 1]]]}]}, \"seeds\": [{\"at\": [0.3, 0.4]}], \"laths\": "
    "{\"strip\": \"standing\", \"width\": 0.1, \"thickness\": 0.01, \"material\": \"steel-s235\"}}";

static taut_status make(const void *context, void **result, taut_error *error)
{
    taut_model *model = *result;
    const taut_status status = taut_make(context, NULL, &model, error);
    *result = model;
    return status;
}

static taut_status strips(const void *context, void **result, taut_error *error)
{
    taut_model *model = *result;
    const taut_status status = taut_trace_strips(context, 1, &model, error);
    *result = model;
    return status;
}

int main(void)
{
    taut_problem *problem = NULL;
    taut_model *net = NULL;

    CHECK(taut_problem_read_text(document, sizeof document - 1, "net", &problem, NULL) == TAUT_OK,
          "the document");
    fault_check("read", read_problem_text, release_problem, document, 5);
    fault_check("make", make, release_model, problem, 50);
    CHECK(taut_make(problem, NULL, &net, NULL) == TAUT_OK, "the net");
    fault_check("strips", strips, release_model, net, 10);
    taut_model_free(net);
    taut_problem_free(problem);
    return check_failures != 0;
}
