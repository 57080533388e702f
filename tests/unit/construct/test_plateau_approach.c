/* test_plateau_approach.c -- coming near along normals: what the method "normal" finds, or nothing
 * at all. */
#include "check.h"
#include "problems.h"

#include "construct/plateau_approach.h"
#include "taut/plateau.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static taut_status approach(int example, int max_iterations, taut_descent *descent, double *net,
                            int *products)
{
    static const taut_monitor silent;
    test_problem problem = problem_example(example);
    const double *start = NULL;
    taut_model *model = problem_make(&problem, &start);
    taut_arena *arena = taut_arena_new();
    const int nu = taut_basis_count(problem.u), nv = taut_basis_count(problem.v);
    taut_pattern pattern;
    taut_dirichlet_form form;
    taut_film *film = NULL;
    taut_status status = TAUT_NO_MEMORY;
    int made = 0;

    memcpy(net, start, 3 * (size_t)nu * (size_t)nv * sizeof(double));
    CHECK(taut_pattern_new(nu, nv, problem.known, arena, &pattern) == TAUT_OK &&
              taut_dirichlet_form_new(problem.u, problem.v, NULL, &form, NULL) == TAUT_OK &&
              taut_film_new(problem.u, problem.v, NULL, 9, &film) == TAUT_OK,
          "the parts of a film");
    *descent =
        (taut_descent){.tolerance = 1e-10, .max_iterations = max_iterations, .work_max = INFINITY};
    status = taut_plateau_approach(film, &form, &pattern, taut_model_surface(model, 0), 1, &silent,
                                   descent, net, &made, NULL);
    *products = made;
    taut_film_free(film);
    taut_dirichlet_form_clear(&form);
    taut_arena_free(arena);
    taut_model_free(model);
    problem_free(&problem);
    return status;
}

/* The normal method's points of example 4, to the residual that is asked for on the way: 1e-7 of
 * the gradient is 1e-6 of the points here. */
static void test_near(void)
{
    test_problem net = problem_example(4);
    taut_plateau_problem problem = {.net = net.data, .method = TAUT_PLATEAU_NORMAL};
    taut_model *model = NULL;
    taut_descent descent;
    double found[3 * 64];
    int products = 0;

    CHECK(taut_plateau_make(&problem, NULL, &model, NULL) == TAUT_OK, "normal");
    CHECK(approach(4, 100, &descent, found, &products) == TAUT_OK, "approach");
    CHECK(descent.iterations > 1 && products > 1, "%d steps", descent.iterations);
    for (size_t i = 0; model != NULL && i < 60; i++) {
        CHECK_NEAR(found[i], taut_surface_points(taut_model_surface(model, 0))[i], 1e-6, "%zu", i);
    }
    taut_model_free(model);
    problem_free(&net);
}

/* Stopped short, it leaves the net, and the count of steps, as they were. */
static void test_nothing(void)
{
    test_problem problem = problem_example(4);
    const double *start = NULL;
    taut_model *model = problem_make(&problem, &start);
    taut_descent descent;
    double found[3 * 64];
    int products = 0;

    CHECK(approach(4, 1, &descent, found, &products) == TAUT_OK, "approach");
    CHECK(descent.iterations == 0 && products > 0, "%d steps", descent.iterations);
    CHECK(memcmp(found, start, 60 * sizeof(double)) == 0, "the net has moved");
    taut_model_free(model);
    problem_free(&problem);
}

int main(void)
{
    test_near();
    test_nothing();
    return check_failures != 0;
}
