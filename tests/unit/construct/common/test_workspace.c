/* test_workspace.c -- a sequence of Dirichlet problems that shares its factors: the same numbers,
 * bit for bit, as one at a time, whatever came before. */
#include "check.h"
#include "monitors.h"
#include "problems.h"

#include "taut/taut.h"

#include <string.h>

/* Makes it with and without the workspace and compares points and details. */
static void compare(const test_problem *problem, taut_workspace *workspace, const char *what)
{
    const taut_make_options options = {.workspace = workspace};
    const size_t count =
        (size_t)taut_basis_count(problem->u) * (size_t)taut_basis_count(problem->v);
    const double *alone = NULL, *shared = NULL;
    taut_model *one = problem_make(problem, &alone), *two = NULL;
    taut_error error = {.status = TAUT_OK};
    char *texts[2] = {NULL, NULL};
    size_t lengths[2] = {0, 0};

    CHECK(taut_dirichlet_make(&problem->data, &options, &two, &error) == TAUT_OK, "%s: %s", what,
          error.message);
    shared = taut_surface_points(taut_model_surface(two, 0));
    CHECK(memcmp(alone, shared, 3 * count * sizeof(double)) == 0, "%s: points differ", what);
    CHECK(taut_record_write(taut_model_details(one), &texts[0], &lengths[0]) == TAUT_OK, "write");
    CHECK(taut_record_write(taut_model_details(two), &texts[1], &lengths[1]) == TAUT_OK, "write");
    CHECK(strcmp(texts[0], texts[1]) == 0, "%s: %s and %s", what, texts[0], texts[1]);
    taut_text_free(texts[0]);
    taut_text_free(texts[1]);
    taut_model_free(one);
    taut_model_free(two);
}

static void expect_reuses(const taut_workspace *workspace, size_t expected, const char *what)
{
    CHECK(taut_workspace_reuses(workspace) == expected, "%s: %zu reuses, expected %zu", what,
          taut_workspace_reuses(workspace), expected);
}

/* Random bases and patterns; other points, other aspects: the factors serve. */
static void test_sequence(void)
{
    for (int trial = 0; trial < random_trials(40); trial++) {
        test_problem problem = problem_new(basis_random(4, 14), basis_random(4, 14));
        const int count = taut_basis_count(problem.u) * taut_basis_count(problem.v);
        taut_workspace *workspace = NULL;
        CHECK(taut_workspace_new(&workspace) == TAUT_OK, "workspace");
        for (int k = 0; k < 4; k++) {
            problem_random_boundary(&problem);
            if (trial % 3 == 1) { /* conjugate gradients */
                problem.known[count / 2] = 1;
            }
            problem.data.aspect = k == 2 ? random_log(0.1, 10) : 0;
            compare(&problem, workspace, "sequence");
        }
        expect_reuses(workspace, 3, "sequence");
        taut_workspace_free(workspace);
        problem_free(&problem);
    }
}

/* Another pattern, other weights, another basis: never the factors of something else. A flag that
 * is nonzero in another way is the same. */
static void test_changes(void)
{
    test_problem first = problem_new(basis_uniform(3, 7), basis_uniform(3, 9));
    test_problem other = problem_new(basis_uniform(3, 7), basis_uniform(4, 9));
    taut_workspace *workspace = NULL;

    CHECK(taut_workspace_new(&workspace) == TAUT_OK, "workspace");
    problem_random_boundary(&first);
    problem_random_boundary(&other);
    compare(&first, workspace, "first");
    first.known[0] = 7;
    compare(&first, workspace, "another flag");
    expect_reuses(workspace, 1, "another flag");
    first.known[2 * 9 + 3] = 1;
    compare(&first, workspace, "another pattern");
    compare(&other, workspace, "another basis");
    problem_random_weights(&other, 3);
    compare(&other, workspace, "weights that are no product"); /* refined as it goes: not kept */
    compare(&other, workspace, "the same again");
    expect_reuses(workspace, 1, "weights that are no product");
    for (int i = 0; i < 7; i++) {
        for (int j = 0; j < 9; j++) {
            other.weights[9 * i + j] = (1 + i) * (2.0 + j);
        }
    }
    compare(&other, workspace, "weights that are a product");
    compare(&other, workspace, "the same again");
    expect_reuses(workspace, 2, "weights that are a product");
    other.weights[5] *= 1 + 0x1p-52;
    compare(&other, workspace, "one bit of a weight");
    expect_reuses(workspace, 2, "one bit of a weight");
    taut_workspace_free(workspace);
    problem_free(&first);
    problem_free(&other);
}

/* A make that was stopped, or that failed, leaves nothing behind that the next could trip over. */
static void test_after_failure(void)
{
    watch once = {.stop_at = 1};
    test_problem problem = problem_new(basis_uniform(2, 8), basis_uniform(3, 6));
    taut_make_options options = {.monitor = monitor_of(&once)};
    taut_model *model = NULL;

    CHECK(taut_workspace_new(&options.workspace) == TAUT_OK, "workspace");
    problem_random_boundary(&problem);
    CHECK(taut_dirichlet_make(&problem.data, &options, &model, NULL) == TAUT_INTERRUPTED, "stop");
    CHECK(once.reports == 1 && model == NULL, "%d reports", once.reports);
    compare(&problem, options.workspace, "after an interrupt");
    CHECK(once.reports == 1, "a monitor of before was asked");
    problem.points[0] = 1e308; /* and a scale at the end of the range */
    compare(&problem, options.workspace, "a large point");
    problem.points[0] = nan("");
    CHECK(taut_dirichlet_make(&problem.data, &options, &model, NULL) == TAUT_BAD_INPUT, "nan");
    problem.points[0] = -3;
    compare(&problem, options.workspace, "after a refusal");
    taut_workspace_free(options.workspace);
    taut_workspace_free(NULL);
    CHECK(taut_workspace_new(NULL) == TAUT_BAD_ARGUMENT, "no place");
    problem_free(&problem);
}

int main(void)
{
    random_seed(20261121);
    test_sequence();
    test_changes();
    test_after_failure();
    return check_failures != 0;
}
