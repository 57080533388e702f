/* test_plateau.c -- least areas that are known from elsewhere, and what is refused. */
#include "certificates.h"
#include "check.h"
#include "films.h"
#include "monitors.h"
#include "problems.h"

#include "taut/measure.h"
#include "taut/plateau.h"

#include <stdlib.h>
#include <string.h>

/* [WuWang2011] section 4: the least areas of its four examples, found there by quasi-Newton steps,
 * and those of the normal method; twelve decimals. */
static void test_examples(void)
{
    static const double full[4] = {4.199556810173, 4.197156448570, 4.105593602010, 4.273264234283};
    static const double normal[4] = {4.199556810173, 4.199565454558, 4.106435034417,
                                     4.288401001734};
    for (int k = 0; k < 4; k++) {
        test_problem net = problem_example(k + 1);
        taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
        CHECK_NEAR(film_area(&problem, "full"), full[k], 2e-12, "example %d", k + 1);
        problem = film_problem(&net, TAUT_PLATEAU_NORMAL);
        CHECK_NEAR(film_area(&problem, "normal"), normal[k], 2e-12, "example %d", k + 1);
        problem_free(&net);
    }
}

/* Four edges of a tetrahedron: Schwarz's minimal surface, of area 1.279261571171 (its integral in
 * closed form). The spline lies above it, by less than 1e-11 of it at 12 x 12 points. */
static void test_skew(void)
{
    test_problem net = problem_tetrahedron(12);
    const taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    const double area = film_area(&problem, "skew");
    CHECK(area > 1.279261571170 && area < 1.279261571171 + 2e-11, "area %.15g", area);
    problem_free(&net);
}

/* A start of one's own leads to the same minimum, and must carry the known points. */
static void test_start(void)
{
    test_problem net = problem_example(3);
    taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
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
    CHECK_NEAR(film_area(&problem, "start"), 4.105593602010, 2e-12, "from another start");
    start[0] += 1e-3;
    CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_BAD_INPUT && model == NULL,
          "a start that moves a known point");
    CHECK(strcmp(error.where, "/start/points/0/0") == 0, "where: %s", error.where);
    problem_free(&net);
}

static void test_refusals(void)
{
    test_problem net = problem_example(4);
    taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
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
    test_problem net = problem_tetrahedron(6);
    const taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
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
    const taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    for (int i = 0; i < 16; i++) {
        net.points[3 * i + 2] = 0.5 * net.points[3 * i];
    }
    CHECK_NEAR(film_area(&problem, "plane"), 4 * sqrt(1.25), 1e-14, "a tilted square");
    problem_free(&net);
}

static void test_interrupt(void)
{
    test_problem net = problem_tetrahedron(8);
    const taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    watch fourth = {.stop_at = 4};
    const taut_make_options options = {.monitor = monitor_of(&fourth)};
    taut_model *model = NULL;
    CHECK(taut_plateau_make(&problem, &options, &model, NULL) == TAUT_INTERRUPTED && model == NULL,
          "stopped");
    problem_free(&net);
}

/* Limits close above what is left: the worked examples end at rounding ([WuWang2011] section 4). */
static void test_limits(void)
{
    for (int k = 0; k < 4; k++) {
        test_problem net = problem_example(k + 1);
        const taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
        taut_model *model = NULL;
        taut_certificate *certificate = NULL;
        CHECK(taut_plateau_make(&problem, NULL, &model, NULL) == TAUT_OK &&
                  taut_plateau_certify(model, &problem, NULL, &certificate, NULL) == TAUT_OK,
              "example %d", k + 1);
        const taut_claim *claim = taut_certificate_claim(certificate, 0);
        CHECK(claim->limit <= 2e-12 && claim->residual <= claim->limit, "example %d: %.3g, %.3g",
              k + 1, claim->residual, claim->limit);
        taut_certificate_free(certificate);
        taut_model_free(model);
        problem_free(&net);
    }
}

/* z = 1 - x^2 on y = +-1, z = y^2 - 1 on x = +-1, over a net of n x n cubic points. */
static test_problem saddle(int n)
{
    test_problem net = problem_new(basis_uniform(3, n), basis_uniform(3, n));
    for (int i = 0; i < n; i++) {
        double knot[3], product = 0;
        for (int k = 0; k < 3; k++) {
            knot[k] = 2 * fmin(1, fmax(0, (double)(i + k - 2) / (n - 3))) - 1;
        }
        for (int k = 0; k < 3; k++) {
            product += knot[k] * knot[(k + 1) % 3] / 3; /* the blossom of t^2 */
        }
        const double t = 2 * greville_uniform(n, i) - 1;
        problem_know(&net, i, 0, t, -1, 1 - product);
        problem_know(&net, i, n - 1, t, 1, 1 - product);
        problem_know(&net, 0, i, -1, t, product - 1);
        problem_know(&net, n - 1, i, 1, t, product - 1);
    }
    return net;
}

/* From above, and as near as 16 x 16 cubic points come; where sanitizers watch, 14 x 14. */
static void test_fine_nets(void)
{
    const int n = random_trials(16) < 16 ? 14 : 16;
    const double far[2] = {n == 16 ? 1e-11 : 2e-11, n == 16 ? 6e-9 : 2e-8};
    for (int k = 0; k < 2; k++) {
        const double least = k == 0 ? 1.2792615711710065 : 7.3835056025;
        test_problem net = k == 0 ? problem_tetrahedron(n) : saddle(n);
        const taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
        taut_model *model = NULL;
        double area = nan("");
        CHECK(taut_plateau_make(&problem, NULL, &model, NULL) == TAUT_OK &&
                  taut_surface_area(taut_model_surface(model, 0), &area, NULL) == TAUT_OK,
              "net %d", k);
        taut_model_free(model);
        CHECK(area > least * (1 - 1e-14) && area < least * (1 + far[k]), "%d: area %.16g", k, area);
        problem_free(&net);
    }
}

/* The area never rises from one iteration to the next, but by the 1e-11 of it that two rules of
 * quadrature may differ where nodes are added. */
static void test_monotone(void)
{
    for (int k = 0; k < 3; k++) {
        test_problem net = k == 0   ? problem_tetrahedron(12)
                           : k == 1 ? saddle(12)
                                    : problem_example(4);
        for (int m = 0; m < 2; m++) {
            const taut_plateau_problem problem = film_problem(&net, (taut_plateau_method)m);
            taut_model *model = NULL;
            CHECK(taut_plateau_make(&problem, NULL, &model, NULL) == TAUT_OK, "made");
            const taut_record *areas = taut_record_get(taut_model_details(model), "areas");
            double before = detail_of(model, "dirichlet_area");
            CHECK(taut_record_count(areas) > 1, "net %d: areas are told", k);
            for (size_t i = 0; i < taut_record_count(areas); i++) {
                const double area = taut_record_number(taut_record_at(areas, i));
                CHECK(area <= before * (1 + 1e-11), "net %d, iteration %zu: %.16g", k, i, area);
                before = area;
            }
            taut_model_free(model);
        }
        problem_free(&net);
    }
}

static const taut_record *refinement_of(const taut_model *model)
{
    return taut_record_get(taut_model_details(model), "refinement");
}

/* [WuWang2011] section 4: "limit of minimal area" of Ex3 and Ex4, 4.1028759 and 4.2728533,
 * found there on 32 x 32 spans; seen 5e-8 after three rounds, 6.7e-7 after two. */
static void test_refine(void)
{
    static const double limits[2] = {4.1028759, 4.2728533};
    const int rounds = random_trials(10) < 10 ? 2 : 3;
    for (int k = 0; k < 2; k++) {
        test_problem net = problem_example(k + 3);
        taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
        taut_model *model = NULL;
        taut_error error = {0};
        problem.refine = rounds;
        CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
        const double found =
            taut_record_number(taut_record_get(refinement_of(model), "estimated_least_area"));
        CHECK_NEAR(found, limits[k], rounds == 3 ? 6e-8 : 8e-7, "example %d", k + 3);
        CHECK(taut_record_count(taut_record_get(refinement_of(model), "rounds")) ==
                  (size_t)rounds + 1,
              "rounds");
        taut_model_free(model);
        problem_free(&net);
    }
}

/* Knots go in until the estimate is met; the edges stay, and areas fall from round to round. */
static void test_tolerance_area(void)
{
    test_problem net = problem_example(4);
    taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    taut_model *model = NULL;
    double area = nan(""), before = INFINITY;
    problem.tolerance_area = 1e-7;
    CHECK(taut_plateau_make(&problem, NULL, &model, NULL) == TAUT_OK, "made");
    CHECK(film_proved_area(model, &problem, "tolerance_area") < 4.2728533 * (1 + 1e-7),
          "near enough");
    const taut_record *rounds = taut_record_get(refinement_of(model), "rounds");
    for (size_t k = 0; k < taut_record_count(rounds); k++) {
        area = taut_record_number(taut_record_get(taut_record_at(rounds, k), "area"));
        CHECK(area < before, "round %zu", k);
        before = area;
    }
    CHECK(taut_record_number(taut_record_get(refinement_of(model), "estimated_gap")) <= 1e-7,
          "the estimate is met");
    taut_model_free(model);
    problem_free(&net);
}

/* Boundaries whose films are degenerate: an edge that is a point, an edge twice, a fold. They end,
 * with numbers or with a name for what is wrong. */
static void test_degenerate(void)
{
    for (int k = 0; k < 4; k++) {
        test_problem net = problem_tetrahedron(7);
        taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
        for (int i = 0; i < 7; i++) {
            double *first = net.points + 3 * i, *last = net.points + 3 * (42 + i);
            for (int c = 0; c < 3; c++) {
                if (k == 0) {
                    first[c] = net.points[c]; /* u0 is a point */
                } else if (k == 1) {
                    last[c] = first[c] + 1e-9 * i * (6 - i); /* u1 is u0, but for a hair */
                } else if (k == 2) {
                    last[c] *= i == 3 ? -4 : 1; /* a spike */
                }
            }
            net.points[3 * (7 * i) + 1] -= k == 3 && i % 6 != 0 ? 3 * sin(2.0 * i) : 0;
        }
        for (int m = k % 2; m <= k % 2; m++) {
            taut_model *model = NULL;
            taut_error error = {0};
            problem.method = (taut_plateau_method)m;
            problem.max_iterations = 8;
            const taut_status status = taut_plateau_make(&problem, NULL, &model, &error);
            CHECK(status == TAUT_OK ||
                      ((status == TAUT_NO_SOLUTION || status == TAUT_NOT_CONVERGED) &&
                       error.message[0] != '\0'),
                  "%d: status %d", k, (int)status);
            for (int i = 0; model != NULL && i < 147; i++) {
                CHECK(isfinite(taut_surface_points(taut_model_surface(model, 0))[i]), "%d", k);
            }
            taut_model_free(model);
        }
        problem_free(&net);
    }
}

int main(void)
{
    test_degenerate();
    test_examples();
    test_limits();
    test_fine_nets();
    test_monotone();
    test_refine();
    test_tolerance_area();
    test_skew();
    test_start();
    test_refusals();
    test_free_edges();
    test_plane();
    test_interrupt();
    return check_failures != 0;
}
