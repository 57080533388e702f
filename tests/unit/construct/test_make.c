/* test_make.c -- taut_make, whatever is made: arguments out of range, and nothing made then. */
#include "check.h"
#include "monitors.h"
#include "shapes.h"

#include "problem/problem.h"
#include "taut/harmonic.h"
#include "taut/read.h"

#include <string.h>

/* A harmonic problem of two rows of degree 1, which anything can make. */
static taut_problem *rows(taut_harmonic_problem *data)
{
    static const double points[12] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1};
    static const unsigned char known[4] = {1, 1, 1, 1};
    taut_problem *problem = NULL;
    *data = (taut_harmonic_problem){.u = shape_bezier(1, 0, 1),
                                    .v = shape_bezier(1, 0, 1),
                                    .rows = {.points = points, .known = known}};
    CHECK(taut_problem_new(TAUT_CONSTRUCT_INDEX_harmonic, &problem) == TAUT_OK, "problem");
    problem->data = data;
    return problem;
}

static void test_arguments(void)
{
    static const taut_make_options wrong[] = {{.tolerance = -1},
                                              {.tolerance = NAN},
                                              {.tolerance = INFINITY},
                                              {.threads = -1},
                                              {.threads = TAUT_THREADS_MAX + 1},
                                              {.time_limit = -1},
                                              {.time_limit = NAN}};
    taut_harmonic_problem data;
    taut_problem *const problem = rows(&data);
    taut_model *model = NULL;
    taut_error error;

    CHECK(taut_make(NULL, NULL, &model, &error) == TAUT_BAD_ARGUMENT, "no problem");
    CHECK(taut_make(problem, NULL, NULL, &error) == TAUT_BAD_ARGUMENT, "no place");
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        CHECK(taut_make(problem, &wrong[i], &model, &error) == TAUT_BAD_ARGUMENT &&
                  strcmp(error.reason, "argument") == 0,
              "case %zu: %s", i, error.message);
    }
    strcpy(problem->unit, "ell"); /* no document brings it here: units are read from a list */
    CHECK(taut_make(problem, NULL, &model, &error) == TAUT_INTERNAL &&
              strcmp(error.reason, "fault") == 0,
          "%s", error.message);
    CHECK(model == NULL, "untouched");
    strcpy(problem->unit, "in");
    CHECK(taut_make(problem, NULL, &model, &error) == TAUT_OK &&
              strcmp(taut_model_unit(model), "in") == 0,
          "%s", error.message);
    taut_model_free(model);
    taut_problem_free(problem);
    taut_basis_free((taut_basis *)(size_t)data.u);
    taut_basis_free((taut_basis *)(size_t)data.v);
}

/* Whatever ends before it has anything to show says so, and not that somebody stopped it. A limit of
 * no time at all is over at the first report. */
static void test_ended(void)
{
    static const char text[] =
        "{\"taut\": 1, \"construct\": \"dirichlet\", \"u\": {\"type\": \"bezier\", \"degree\": 2},"
        " \"v\": {\"type\": \"bezier\", \"degree\": 2}, \"points\": [[[0,0,0], [0,1,0], [0,2,1]],"
        " [[1,0,0], null, [1,2,0]], [[2,0,1], [2,1,0], [2,2,0]]]}";
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_error error;
    watch enough = {.stop_at = 1, .answer = TAUT_ENOUGH}, stop = {.stop_at = 1};
    watch other = {.stop_at = 1, .answer = -7}, none = {.stop_at = 0};

    CHECK(taut_problem_read_text(text, sizeof text - 1, "text", &problem, NULL) == TAUT_OK, "text");
    const taut_make_options short_time = {.time_limit = 1e-9};
    CHECK(taut_make(problem, &short_time, &model, &error) == TAUT_NOT_CONVERGED &&
              strcmp(error.reason, "time") == 0 && error.limit == 1e-9,
          "%s", error.message);
    const taut_make_options ended = {.monitor = monitor_of(&enough)};
    CHECK(taut_make(problem, &ended, &model, &error) == TAUT_NOT_CONVERGED &&
              strcmp(error.reason, "time") == 0 && isnan(error.limit),
          "%s", error.message);
    const taut_make_options stopped = {.monitor = monitor_of(&stop), .time_limit = 1e9};
    CHECK(taut_make(problem, &stopped, &model, &error) == TAUT_INTERRUPTED &&
              strcmp(error.reason, "interrupted") == 0,
          "%s", error.message);
    const taut_make_options strange = {.monitor = monitor_of(&other), .time_limit = 1e-9};
    CHECK(taut_make(problem, &strange, &model, &error) == TAUT_INTERRUPTED, "%s", error.message);
    CHECK(model == NULL, "untouched");
    const taut_make_options whole = {.monitor = monitor_of(&none), .time_limit = 1e9};
    CHECK(taut_make(problem, &whole, &model, &error) == TAUT_OK && none.reports > 0, "%s",
          error.message);
    taut_model_free(model);
    taut_problem_free(problem);
}

int main(void)
{
    test_arguments();
    test_ended();
    return check_failures != 0;
}
