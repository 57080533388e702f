/* test_plateau.c -- least areas that are known from elsewhere, and what is refused. */
#include "check.h"
#include "problems.h"

#include "taut/measure.h"
#include "taut/plateau.h"

#include <stdlib.h>
#include <string.h>

static taut_plateau_problem plateau_of(const test_problem *net, taut_plateau_method method)
{
    taut_plateau_problem problem;
    memset(&problem, 0, sizeof problem);
    problem.net = net->data;
    problem.method = method;
    return problem;
}

/* Makes and certifies; the area, NaN if that fails. */
static double area_of(const taut_plateau_problem *problem, const char *what)
{
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_error error = {0};
    double area = nan("");

    CHECK(taut_plateau_make(problem, NULL, &model, &error) == TAUT_OK, "%s: %s", what,
          error.message);
    if (model != NULL) {
        CHECK(taut_surface_area(taut_model_surface(model, 0), &area, NULL) == TAUT_OK, "%s", what);
        CHECK(taut_plateau_certify(model, problem, NULL, &certificate, &error) == TAUT_OK, "%s: %s",
              what, error.message);
    }
    if (certificate != NULL) {
        CHECK(taut_certificate_holds(certificate) == TAUT_TRUE, "%s: residual %.3g", what,
              taut_certificate_claim(certificate, 0)->residual);
    }
    taut_certificate_free(certificate);
    taut_model_free(model);
    return area;
}

/* [WuWang2011] section 4: the least areas of its four examples, found there by quasi-Newton steps,
 * and those of the normal method; twelve decimals. */
static void test_examples(void)
{
    static const double full[4] = {4.199556810173, 4.197156448570, 4.105593602010, 4.273264234283};
    static const double normal[4] = {4.199556810173, 4.199565454558, 4.106435034417,
                                     4.288401001734};
    for (int k = 0; k < 4; k++) {
        test_problem net = problem_example(k + 1);
        taut_plateau_problem problem = plateau_of(&net, TAUT_PLATEAU_FULL);
        CHECK_NEAR(area_of(&problem, "full"), full[k], 2e-12, "example %d", k + 1);
        problem = plateau_of(&net, TAUT_PLATEAU_NORMAL);
        CHECK_NEAR(area_of(&problem, "normal"), normal[k], 2e-12, "example %d", k + 1);
        problem_free(&net);
    }
}

static void set(test_problem *net, int i, int j, double x, double y, double z)
{
    const size_t at = (size_t)i * (size_t)taut_basis_count(net->v) + (size_t)j;
    const double point[3] = {x, y, z};
    memcpy(net->points + 3 * at, point, sizeof point);
    net->known[at] = 1;
}

/* The knots' means over a uniform cubic on [0, 1]: where a straight edge has its points. */
static double greville(int count, int i)
{
    double sum = 0;
    for (int k = i + 1; k <= i + 3; k++) {
        sum += fmin(1, fmax(0, (double)(k - 3) / (count - 3)));
    }
    return sum / 3;
}

static test_problem skew(int n)
{
    test_problem net = problem_new(basis_uniform(3, n), basis_uniform(3, n));
    for (int i = 0; i < n; i++) {
        const double t = greville(n, i);
        set(&net, i, 0, t, 0, t);
        set(&net, i, n - 1, t, 1, 1 - t);
        set(&net, 0, i, 0, t, t);
        set(&net, n - 1, i, 1, t, 1 - t);
    }
    return net;
}

/* Four edges of a tetrahedron: Schwarz's minimal surface, of area 1.279261571171 (its integral in
 * closed form). The spline lies above it, by less than 1e-11 of it at 12 x 12 points. */
static void test_skew(void)
{
    test_problem net = skew(12);
    const taut_plateau_problem problem = plateau_of(&net, TAUT_PLATEAU_FULL);
    const double area = area_of(&problem, "skew");
    CHECK(area > 1.279261571170 && area < 1.279261571171 + 2e-11, "area %.15g", area);
    problem_free(&net);
}

/* A start of one's own leads to the same minimum, and must carry the known points. */
static void test_start(void)
{
    test_problem net = problem_example(3);
    taut_plateau_problem problem = plateau_of(&net, TAUT_PLATEAU_FULL);
    double start[48];
    taut_model *model = NULL;
    taut_error error = {0};

    memcpy(start, net.points, sizeof start);
    for (int i = 0; i < 16; i++) {
        for (int c = 0; c < 3 && !net.known[i]; c++) {
            start[3 * i + c] = 0.3 * (i % 3) - 0.2 * c;
        }
    }
    problem.start = start;
    CHECK_NEAR(area_of(&problem, "start"), 4.105593602010, 2e-12, "from another start");
    start[0] += 1e-3;
    CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_BAD_INPUT && model == NULL,
          "a start that moves a known point");
    CHECK(strcmp(error.where, "/start/points/0/0") == 0, "where: %s", error.where);
    problem_free(&net);
}

static void test_refusals(void)
{
    test_problem net = problem_example(4);
    taut_plateau_problem problem = plateau_of(&net, TAUT_PLATEAU_FULL);
    taut_model *model = NULL;
    taut_error error = {0};

    problem.max_iterations = 1;
    CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_NOT_CONVERGED &&
              error.found > error.limit,
          "one iteration is too few: %s", error.message);
    problem.max_iterations = -1;
    CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_BAD_INPUT, "iterations");
    problem.max_iterations = 0;
    problem.tolerance = nan("");
    CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_BAD_INPUT, "tolerance");
    problem.tolerance = 0;
    for (int i = 0; i < 20; i++) {
        net.points[3 * i + 1] = net.points[3 * i + 2] = 0;
    }
    CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_NO_SOLUTION,
          "a boundary on a line: %s", error.message);
    CHECK(model == NULL && taut_plateau_make(NULL, NULL, &model, NULL) == TAUT_BAD_ARGUMENT,
          "untouched");
    problem_free(&net);
}

/* With two opposite edges and nothing between them the film has no end to its shrinking. */
static void test_free_edges(void)
{
    test_problem net = skew(6);
    const taut_plateau_problem problem = plateau_of(&net, TAUT_PLATEAU_FULL);
    taut_model *model = NULL;
    taut_error error = {0};

    for (int i = 1; i < 5; i++) {
        for (int j = 0; j < 6; j++) {
            net.known[6 * i + j] = 0;
        }
    }
    CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_NO_SOLUTION, "free: %s",
          error.message);
    taut_model_free(model);
    problem_free(&net);
}

/* A plane region has one area, however its inside is divided. */
static void test_plane(void)
{
    test_problem net = problem_example(2);
    const taut_plateau_problem problem = plateau_of(&net, TAUT_PLATEAU_FULL);
    for (int i = 0; i < 16; i++) {
        net.points[3 * i + 2] = 0.5 * net.points[3 * i];
    }
    CHECK_NEAR(area_of(&problem, "plane"), 4 * sqrt(1.25), 1e-14, "a tilted square");
    problem_free(&net);
}

static int stop(void *context, double done, const char *what)
{
    (void)done;
    return what != NULL && ++*(int *)context > 3;
}

static void test_interrupt(void)
{
    test_problem net = skew(8);
    const taut_plateau_problem problem = plateau_of(&net, TAUT_PLATEAU_FULL);
    int calls = 0;
    const taut_make_options options = {.monitor = {stop, &calls}};
    taut_model *model = NULL;
    CHECK(taut_plateau_make(&problem, &options, &model, NULL) == TAUT_INTERRUPTED && model == NULL,
          "stopped");
    problem_free(&net);
}

int main(void)
{
    test_examples();
    test_skew();
    test_start();
    test_refusals();
    test_free_edges();
    test_plane();
    test_interrupt();
    return check_failures != 0;
}
