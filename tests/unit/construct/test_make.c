/* test_make.c -- taut_make, whatever is made: arguments out of range, and nothing made then. */
#include "check.h"
#include "shapes.h"

#include "problem/problem.h"
#include "taut/harmonic.h"

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
                                              {.threads = TAUT_THREADS_MAX + 1}};
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

int main(void)
{
    test_arguments();
    return check_failures != 0;
}
