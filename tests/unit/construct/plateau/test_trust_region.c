/* test_trust_region.c -- a descent keeps to the work it may do, and reports between its steps. */
#include "certificates.h"
#include "check.h"
#include "problems.h"

#include "construct/plateau/trust_region.h"
#include "taut/plateau.h"

#include <stdio.h>
#include <string.h>

/* Descends from the Dirichlet surface of an example by the full method; fills descent. */
static taut_status minimise(int example, taut_trust_region *region, double *step_cost,
                            taut_error *error)
{
    static const taut_monitor silent;
    test_problem problem = problem_example(example);
    const double *start = NULL;
    taut_model *model = problem_make(&problem, &start);
    taut_arena *arena = taut_arena_new();
    const int nu = taut_basis_count(problem.u), nv = taut_basis_count(problem.v);
    taut_mask mask;
    taut_dirichlet_form form;
    taut_area_functional *functional = NULL;
    taut_newton_step *newton = NULL;
    double net[3 * 64];
    taut_status status = TAUT_NO_MEMORY;

    memcpy(net, start, 3 * (size_t)nu * (size_t)nv * sizeof(double));
    CHECK(taut_mask_new(nu, nv, problem.known, arena, &mask) == TAUT_OK &&
              taut_dirichlet_form_new(problem.u, problem.v, NULL, &form, NULL) == TAUT_OK &&
              taut_area_functional_new(problem.u, problem.v, NULL, 4, &functional) == TAUT_OK &&
              taut_newton_step_new(functional, &form, &mask, NULL, 1, &silent, &newton) == TAUT_OK,
          "the parts of a descent");
    *step_cost = taut_newton_step_cost(newton);
    status = taut_trust_region_minimise(functional, newton, region, net, error);
    taut_newton_step_free(newton);
    taut_area_functional_free(functional);
    taut_dirichlet_form_clear(&form);
    taut_arena_free(arena);
    taut_model_free(model);
    problem_free(&problem);
    return status;
}

/* Without a limit a descent ends at rest and tells what it cost; with half of that it stops short,
 * after no more than a few steps' worth beyond it, and says why. */
static void test_work(void)
{
    taut_trust_region all = {.tolerance = 1e-10, .max_iterations = 100, .work_max = INFINITY};
    taut_trust_region half = all;
    taut_error error = {0};
    double step = 0;

    CHECK(minimise(4, &all, &step, &error) == TAUT_OK, "at rest: %s", error.message);
    CHECK(all.work > all.iterations * 0.5 * step && all.work < all.iterations * 10 * step,
          "%d steps of %.3g flops each cost %.3g", all.iterations, step, all.work);
    half.work_max = 0.5 * all.work;
    CHECK(minimise(4, &half, &step, &error) == TAUT_NOT_CONVERGED, "stopped");
    CHECK(strcmp(error.reason, "work") == 0, "%s", error.message);
    CHECK(half.work > half.work_max && half.work < half.work_max + 10 * step,
          "%.3g flops, %.3g allowed", half.work, half.work_max);
    CHECK(half.iterations < all.iterations && half.area >= all.area, "on the way");
}

/* Boundaries at random make surfaces that have no tangent plane somewhere. They end: with a model,
 * or with a name for what is wrong. */
static void test_rough(void)
{
    random_seed(20260115);
    for (int k = random_trials(3); k > 0; k--) {
        test_problem net = problem_new(basis_uniform(3, 6), basis_uniform(3, 5));
        taut_plateau_problem problem;
        taut_model *model = NULL;
        taut_error error = {0};
        memset(&problem, 0, sizeof problem);
        problem_random_boundary(&net);
        problem.net = net.data;
        const taut_status status = taut_plateau_make(&problem, NULL, &model, &error);
        CHECK((status == TAUT_OK && model != NULL) ||
                  (status == TAUT_NOT_CONVERGED && model == NULL && error.message[0] != '\0'),
              "status %d: %s", (int)status, error.message);
        taut_model_free(model);
        problem_free(&net);
    }
}

/* Stops at once where it begins, its tolerance being no less than any residual: nets with their
 * inside pressed onto an edge, but for a hair, where the area has a direction of negative curvature
 * and a crease across it. They are saddles with no step down, and said to be; where there is such a
 * step it is taken. */
static void test_saddles(void)
{
    int seen = 0;

    random_seed(20260713);
    for (int trial = 0; trial < 60 && seen < 3; trial++) {
        test_problem net = problem_new(basis_uniform(1, 4), basis_uniform(1, 4));
        taut_plateau_problem problem;
        taut_model *model = NULL;
        taut_error error = {0};
        double start[48];
        for (int k = 0; k < 16; k++) {
            const double height = random_int(0, 1) ? random_log(1e-6, 1) : 0;
            const double point[3] = {k / 4, k % 4, height};
            net.known[k] = k / 4 % 3 == 0 || k % 4 % 3 == 0;
            memcpy(net.points + 3 * k, point, sizeof point);
            for (int c = 0; c < 3; c++) {
                start[3 * k + c] =
                    net.known[k] ? point[c] : start[3 * (k % 4) + c] + 1e-5 * random_in(-1, 1);
            }
        }
        memset(&problem, 0, sizeof problem);
        problem.net = net.data;
        problem.start = start;
        problem.tolerance = 0.999;
        problem.max_iterations = 1;
        const taut_status status = taut_plateau_make(&problem, NULL, &model, &error);
        CHECK(status == TAUT_OK || (status == TAUT_NOT_CONVERGED && model == NULL), "trial %d: %s",
              trial, error.message);
        if (strcmp(error.reason, "saddle") == 0) {
            CHECK(status == TAUT_NOT_CONVERGED && error.found < error.limit &&
                      error.limit == -1e-6 && error.found > -1,
                  "trial %d: %g", trial, error.found);
            seen++;
        }
        taut_model_free(model);
        problem_free(&net);
    }
    CHECK(seen == 3, "%d saddles", seen);
}

typedef struct count {
    int reports, most;
} count;

static int note(void *context, double done, const char *what)
{
    count *c = context;
    (void)done;
    return strcmp(what, "least area") == 0 && ++c->reports > c->most;
}

/* A descent reports before each step and at the end, and can be stopped there; between products of
 * a long one too (test_plateau_approach.c). */
static void test_reports(void)
{
    test_problem net = problem_new(basis_uniform(3, 14), basis_uniform(3, 14));
    taut_plateau_problem problem;
    taut_model *model = NULL;
    count counts = {0, 1000000};
    const taut_make_options options = {.monitor = {note, &counts}};
    taut_error error = {0};

    for (int i = 0; i < 14 * 14; i++) {
        const double x = (i / 14) / 13.0, y = (i % 14) / 13.0;
        const double point[3] = {x, y, 0.3 * cos(9 * x) * sin(7 * y)};
        net.known[i] = i / 14 % 13 == 0 || i % 14 % 13 == 0;
        memcpy(net.points + 3 * i, point, sizeof point);
    }
    memset(&problem, 0, sizeof problem);
    problem.net = net.data;
    problem.method = TAUT_PLATEAU_NORMAL;
    CHECK(taut_plateau_make(&problem, &options, &model, &error) == TAUT_OK, "%s", error.message);
    const double iterations = detail_of(model, "iterations");
    CHECK(counts.reports > iterations + 1, "%d reports in %g steps", counts.reports, iterations);
    taut_model_free(model);
    model = NULL;
    for (counts.most = counts.reports - 1; counts.most > 0; counts.most--) {
        counts.reports = 0;
        CHECK(taut_plateau_make(&problem, &options, &model, &error) == TAUT_INTERRUPTED &&
                  model == NULL && strcmp(error.message, "stopped on request") == 0,
              "stopped after %d", counts.most);
    }
    problem_free(&net);
}

int main(void)
{
    test_work();
    test_rough();
    test_saddles();
    test_reports();
    return check_failures != 0;
}
