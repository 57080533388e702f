/* test_refused.c -- what a Dirichlet problem refuses, and where numbers of double
 * precision end. */
#include "check.h"
#include "monitors.h"
#include "problems.h"

#include <string.h>

static void expect(const test_problem *problem, taut_status status, const char *where)
{
    taut_model *model = NULL;
    taut_error error = {0};
    CHECK(taut_dirichlet_make(&problem->data, NULL, &model, &error) == status,
          "expected %s, found %s", taut_status_text(status), error.message);
    CHECK(strcmp(error.where, where) == 0, "expected %s, found %s", where, error.where);
    CHECK(error.message[0] != '\0' && model == NULL, "message and output");
    taut_model_free(model);
}

static void test_refusals(void)
{
    test_problem problem = problem_example(2);
    taut_make_options options = {0};
    taut_error error = {0};
    taut_model *model = NULL;
    watch once = {.stop_at = 1};

    memset(problem.known, 0, 16);
    expect(&problem, TAUT_NO_SOLUTION, "/points");
    problem.known[7] = 1;
    problem.points[3 * 7 + 1] = nan("");
    expect(&problem, TAUT_BAD_INPUT, "/points/1/3");
    problem.points[3 * 7 + 1] = INFINITY;
    expect(&problem, TAUT_BAD_INPUT, "/points/1/3");
    problem.points[3 * 7 + 1] = 0;
    problem.points[3 * 8] = nan(""); /* unknown: not read */
    problem_random_weights(&problem, 2);
    problem.weights[14] = 0;
    expect(&problem, TAUT_BAD_INPUT, "/weights/3/2");
    problem.weights[14] = INFINITY;
    expect(&problem, TAUT_BAD_INPUT, "/weights/3/2");
    problem.data.weights = NULL;
    problem.data.aspect = -1;
    expect(&problem, TAUT_BAD_INPUT, "/aspect");
    problem.data.aspect = nan("");
    expect(&problem, TAUT_BAD_INPUT, "/aspect");
    problem.data.aspect = 0;
    problem.data.u = NULL;
    expect(&problem, TAUT_BAD_ARGUMENT, "");
    problem.data.u = problem.u;
    options.monitor = monitor_of(&once);
    CHECK(taut_dirichlet_make(&problem.data, &options, &model, &error) == TAUT_INTERRUPTED, "%s",
          error.message);
    CHECK(once.reports == 1 && model == NULL, "%d reports", once.reports);
    CHECK(taut_dirichlet_make(&problem.data, NULL, NULL, NULL) == TAUT_BAD_ARGUMENT, "no place");
    problem_free(&problem);
}

/* Bases that do not serve, and more points than there may be. */
static void test_bases(void)
{
    static const taut_basis_spec curved = {
        .type = "ce-bezier", .alpha = 1, .beta = 1, .gamma = 0.5};
    static const taut_basis_spec round = {.type = "c-bezier", .alpha = 1};
    test_problem problem = problem_example(3);
    taut_basis *ce = NULL, *c = NULL, *wide = basis_uniform(1, 7072);

    CHECK(taut_basis_new(&curved, 0, &ce, NULL) == TAUT_OK &&
              taut_basis_new(&round, 0, &c, NULL) == TAUT_OK,
          "bases");
    problem.data.u = ce;
    expect(&problem, TAUT_BAD_INPUT, "/u");
    problem.data.u = problem.u;
    problem.data.v = ce;
    expect(&problem, TAUT_BAD_INPUT, "/v");
    problem_random_weights(&problem, 2);
    for (int k = 0; k < 2; k++) {
        problem.data.u = k == 0 ? c : problem.u;
        problem.data.v = k == 0 ? problem.v : c;
        expect(&problem, TAUT_BAD_INPUT, "/weights");
    }
    problem.data.weights = NULL;
    problem.data.u = problem.data.v = wide; /* 7072^2 = 50013184, 13184 too many */
    expect(&problem, TAUT_BAD_INPUT, "/points");
    taut_basis_free(ce);
    taut_basis_free(c);
    taut_basis_free(wide);
    problem_free(&problem);
}

/* The middle is 3/8 of the corners' sum less 1/8 of the edges' (example 1), here twice as far out
 * as the boundary: it cannot be had where that is near the largest number. */
static void test_range(void)
{
    static const taut_basis_spec spec = {.type = "bezier", .degree = 2};
    for (int k = 0; k < 2; k++) {
        const double size = k == 0 ? 1 : 1.7e308;
        taut_basis *u = NULL, *v = NULL;
        test_problem problem;
        CHECK(taut_basis_new(&spec, 0, &u, NULL) == TAUT_OK, "u");
        CHECK(taut_basis_new(&spec, 0, &v, NULL) == TAUT_OK, "v");
        problem = problem_new(u, v);
        for (int i = 0; i < 9; i++) {
            problem.known[i] = i != 4;
            for (int c = 0; c < 3; c++) {
                problem.points[3 * i + c] = i % 2 == 0 ? -size : size;
            }
        }
        if (k == 0) {
            const double *found = NULL;
            taut_model *model = problem_make(&problem, &found);
            for (int c = 0; found != NULL && c < 3; c++) {
                CHECK_NEAR(found[3 * 4 + c], -2, 1e-14, "the middle");
            }
            taut_model_free(model);
        } else {
            expect(&problem, TAUT_NO_SOLUTION, "/points");
        }
        problem_free(&problem);
    }
}

static void expect_reason(const test_problem *problem, const char *reason, taut_error *error)
{
    taut_model *model = NULL;
    CHECK(taut_dirichlet_make(&problem->data, NULL, &model, error) == TAUT_NOT_CONVERGED &&
              model == NULL && strcmp(error->reason, reason) == 0,
          "expected %s, found %s: %s", reason, error->reason, error->message);
}

/* Beyond what numbers of double precision can tell apart: a random boundary of degree 20, whose
 * residual stays above its limit, and weights whose squares are no numbers any more. */
static void test_too_extreme(void)
{
    static const taut_basis_spec spec = {.type = "bezier", .degree = 20};
    taut_basis *u = NULL, *v = NULL;
    taut_error error = {0};
    test_problem problem;

    CHECK(taut_basis_new(&spec, 0, &u, NULL) == TAUT_OK, "u");
    CHECK(taut_basis_new(&spec, 0, &v, NULL) == TAUT_OK, "v");
    problem = problem_new(u, v);
    problem_random_boundary(&problem);
    expect_reason(&problem, "undetermined", &error);
    CHECK(error.found > error.limit && error.limit > 0 && error.found < 1e-6, "%g of %g",
          error.found, error.limit);
    problem_free(&problem);
    problem = problem_new(basis_uniform(3, 6), basis_uniform(3, 7));
    problem_random_boundary(&problem);
    problem_random_weights(&problem, 1);
    for (int j = 0; j < 7; j++) {
        problem.weights[2 * 7 + j] = 1e-154;
    }
    expect_reason(&problem, "ill-conditioned", &error);
    problem_free(&problem);
}

int main(void)
{
    random_seed(20260303);
    test_refusals();
    test_bases();
    test_range();
    test_too_extreme();
    return check_failures != 0;
}
