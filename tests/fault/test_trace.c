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

static int ignore(void *context, const taut_trace_step *step)
{
    (void)context;
    (void)step;
    return 0;
}

static taut_status follow(const void *context, void **result, taut_error *error)
{
    const taut_surface *surface = taut_model_surface(context, 0);
    const double at[2] = {0.3, 0.4}, way[2] = {1, 1};
    (void)result;
    return taut_trace_follow(surface, TAUT_TRACE_PRINCIPAL, 1, at, way, 0, ignore, NULL, NULL,
                             error);
}

static void release_nothing(void *result)
{
    (void)result;
}

/* Structs of details take none. */
static void test_told(const taut_model *net)
{
    taut_trace_lath lath;
    taut_trace_node node;
    taut_trace_piece piece;
    fault_arm(1000, 0);
    CHECK(taut_trace_lath_at(net, 0, &lath, NULL) == TAUT_OK, "lath");
    CHECK(taut_trace_node_at(net, 0, &node, NULL) == TAUT_OK, "node");
    CHECK(taut_trace_pattern(net, 0, 0, NULL, &piece, NULL) == TAUT_OK, "piece");
    CHECK(fault_counted() == 0, "%ld allocations", fault_counted());
    fault_disarm();
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
    test_told(net);
    fault_check("follow", follow, release_nothing, net, 3);
    fault_check("strips", strips, release_model, net, 10);
    taut_model_free(net);
    taut_problem_free(problem);
    return check_failures != 0;
}
