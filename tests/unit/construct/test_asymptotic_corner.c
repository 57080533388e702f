/* test_asymptotic_corner.c -- Algorithm 1: gradients, what is refused and with which nearest data.
 */
#include "asymptotic.h"
#include "check.h"

#include "construct/asymptotic/conditions.h"
#include "construct/asymptotic/quartic_search.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Points and weights of a random curve. */
static taut_quad_edge random_edge(int n)
{
    taut_quad_edge edge;
    memset(&edge, 0, sizeof edge);
    for (int j = 0; j <= n; j++) {
        for (int k = 0; k < 3; k++) {
            edge.points[j][k] = random_in(-1, 1);
        }
        edge.weights[j] = random_log(0.5, 2);
    }
    return edge;
}

/* The gradient of a curve's energy against central differences: error of order h^2 = 1e-10 of the
 * third derivative, and rounding 1e-16 / h. */
static void test_energy_gradient(void)
{
    taut_curve_rule rule;
    const double h = 1e-5;
    for (int n = 3; n <= 6; n++) {
        taut_quad_edge edge = random_edge(n);
        double by_point[TAUT_QUAD_POINTS][3], by_log[TAUT_QUAD_POINTS], energy = 0.0;
        taut_curve_rule_fill(n, TAUT_CURVE_FINE, &rule);
        energy = taut_curve_energy(&rule, &edge, by_point, by_log);
        for (int j = 0; j <= n; j++) {
            for (int k = 0; k < 4; k++) {
                taut_quad_edge up = edge, down = edge;
                double slope = 0.0;
                if (k < 3) {
                    up.points[j][k] += h;
                    down.points[j][k] -= h;
                } else {
                    up.weights[j] *= exp(h);
                    down.weights[j] *= exp(-h);
                }
                slope = (taut_curve_energy(&rule, &up, NULL, NULL) -
                         taut_curve_energy(&rule, &down, NULL, NULL)) /
                        (2 * h);
                CHECK_NEAR(k < 3 ? by_point[j][k] : by_log[j], slope, 1e-6 * energy,
                           "n=%d j=%d k=%d", n, j, k);
            }
        }
    }
}

/* A straight line at constant speed has no energy; a parabola's is |r''|^2. */
static void test_energy_values(void)
{
    const double parabola[4][3] = {{0, 0, 0}, {1. / 3, 0, 0}, {2. / 3, 1. / 3, 0}, {1, 1, 0}};
    taut_quad_edge edge;
    taut_curve_rule rule;
    memset(&edge, 0, sizeof edge);
    memcpy(edge.points, parabola, sizeof parabola);
    for (int j = 0; j < 4; j++) {
        edge.weights[j] = 3.0;
    }
    taut_curve_rule_fill(3, TAUT_CURVE_FINE, &rule);
    CHECK_NEAR(taut_curve_energy(&rule, &edge, NULL, NULL), 4.0, 1e-14, "r = (t, t^2)");
}

/* The degree-4 objective against central differences: edges in general position (the closing
 * condition takes an unknown), congruent ones, one straight edge. */
static void test_quartic_gradient(void)
{
    static taut_corner_data data;
    for (int trial = 0; trial < 9; trial++) {
        const taut_asymptotic_problem problem = trial % 3 == 0   ? asymptotic_random(4, 0.08)
                                                : trial % 3 == 1 ? asymptotic_example(2, NULL)
                                                                 : asymptotic_example(5, NULL);
        const int in[4] = {1, 1, -1, -1}, two[4] = {1, -1, -1, 1}, five[4] = {0, 1, -1, -1};
        const int *const signs = trial % 3 == 0 ? in : trial % 3 == 1 ? two : five;
        taut_quartic quartic;
        taut_quartic_search s;
        taut_error error = {.message = ""};
        double x[8], gradient[8], value = 0.0, unused[8];
        uint64_t noise = (uint64_t)trial + 1;
        CHECK(taut_corner_data_fill(&problem, &data, &error) == TAUT_OK, "%s", error.message);
        CHECK(taut_quartic_fill(&data, &quartic, &error) == TAUT_OK, "%s", error.message);
        taut_quartic_plan(&quartic, signs, &s);
        s.rule = &data.fine;
        CHECK(s.count == (trial % 3 == 1 ? 5 : 4), "trial %d: %d unknowns", trial, s.count);
        if (!taut_quartic_allows(&quartic, signs) || !taut_quartic_start(&s, trial, &noise, x)) {
            continue;
        }
        CHECK(taut_quartic_objective(&s, x, &value, gradient), "trial %d", trial);
        for (int j = 0; j < s.count; j++) {
            const double h = 1e-5, keep = x[j];
            double up = 0.0, down = 0.0;
            x[j] = keep + h;
            CHECK(taut_quartic_objective(&s, x, &up, unused), "up");
            x[j] = keep - h;
            CHECK(taut_quartic_objective(&s, x, &down, unused), "down");
            x[j] = keep;
            CHECK_NEAR(gradient[j], (up - down) / (2 * h), 1e-6 * value, "trial %d unknown %d",
                       trial, j);
        }
    }
}

static taut_status refusal(const taut_asymptotic_problem *problem, taut_error *error)
{
    taut_model *model = NULL;
    const taut_status status = taut_asymptotic_make(problem, NULL, &model, error);
    CHECK(status != TAUT_OK && model == NULL, "not refused");
    taut_model_free(model);
    return status;
}

/* One curvature of example 1 changed: refused with the factor it misses by; the curvatures that the
 * message names, read from it, close the ring to the last digit. */
static void test_nearest_curvatures(void)
{
    static const int up[4][2] = {{0, 1}, {1, 0}, {2, 0}, {3, 1}}; /* as the message lists them */
    taut_asymptotic_problem problem = asymptotic_example(1, NULL);
    taut_error error;
    taut_model *model = NULL;
    const char *at = NULL;
    double factor = 0.0;
    problem.edges[0].curvature[1] = 1.3;
    CHECK(refusal(&problem, &error) == TAUT_NO_SOLUTION, "%s", error.message);
    CHECK_NEAR(fabs(error.found), log(1.3), 1e-12, "by how much");
    at = strstr(error.message, "multiply curvature of v0[1], u0[0], v1[0], u1[1] by ");
    CHECK(at != NULL && sscanf(at + 52, "%lf", &factor) == 1, "%s", error.message);
    CHECK_NEAR(factor, exp(error.found / 8), 1e-14, "%s", error.message);
    for (int k = 0; k < 4; k++) {
        problem.edges[up[k][0]].curvature[up[k][1]] *= factor;
        problem.edges[up[k][0]].curvature[1 - up[k][1]] /= factor;
    }
    model = asymptotic_make(&problem, "the nearest curvatures");
    asymptotic_check_claims(model, &problem, "the nearest curvatures");
    taut_model_free(model);
}

/* Example 3 with a leg turned: the nearest legs of the message close the ring. */
static void test_nearest_legs(void)
{
    taut_asymptotic_problem problem = asymptotic_example(3, NULL);
    taut_error error;
    taut_model *model = NULL;
    const char *at = NULL;
    double legs[4][3]; /* in the message's order v0, v1, u0, u1 */
    static const int order[4] = {TAUT_ASYMPTOTIC_V0, TAUT_ASYMPTOTIC_V1, TAUT_ASYMPTOTIC_U0,
                                 TAUT_ASYMPTOTIC_U1};
    problem.edges[0].legs[0][2] = 0.03;
    problem.report_singular = 1;
    CHECK(refusal(&problem, &error) == TAUT_NO_SOLUTION, "%s", error.message);
    at = strstr(error.message, "nearest legs: v0 [");
    CHECK(at != NULL, "%s", error.message);
    for (int k = 0; k < 4 && at != NULL; k++) {
        at = strchr(at, '[');
        CHECK(at != NULL && sscanf(at, "[%lf,%lf,%lf]", &legs[k][0], &legs[k][1], &legs[k][2]) == 3,
              "%s", error.message);
        at += at != NULL;
    }
    if (at == NULL) {
        return;
    }
    for (int k = 0; k < 4; k++) {
        double moved = 0.0;
        for (int d = 0; d < 3; d++) {
            moved = fmax(moved, fabs(legs[k][d] - problem.edges[order[k]].legs[0][d]));
            problem.edges[order[k]].legs[0][d] = legs[k][d];
        }
        CHECK(moved < 0.05, "leg %d moved by %g", k, moved);
    }
    model = asymptotic_make(&problem, "the nearest legs");
    asymptotic_check_claims_or_fold(model, &problem, "the nearest legs"); /* singular */
    taut_model_free(model);
}

/* Given curves with a weight changed: opposite torsions fail, and the factors on inner weights that
 * the message gives mend it. */
static void test_nearest_weights(void)
{
    const taut_asymptotic_problem corner = asymptotic_example(1, "-+-+");
    taut_model *source = asymptotic_make(&corner, "source"), *model = NULL;
    taut_asymptotic_problem problem;
    taut_error error;
    const char *at = NULL;
    memset(&problem, 0, sizeof problem);
    for (int c = 0; c < 4; c++) {
        const taut_curve *const from = taut_model_curve(source, c);
        double w[5];
        memcpy(w, taut_curve_weights(from), sizeof w);
        w[2] *= c == 0 ? 1.01 : 1.0;
        for (int e = 0; e < 4; e++) {
            if (strcmp(taut_curve_name(from), taut_asymptotic_edge_name(e)) == 0) {
                problem.curves[e] =
                    asymptotic_curve(taut_curve_name(from), 4, taut_curve_points(from), w);
            }
        }
    }
    CHECK(refusal(&problem, &error) == TAUT_NO_SOLUTION, "%s", error.message);
    at = strstr(error.message, "inner weights: v0 ");
    CHECK(at != NULL, "%s", error.message);
    for (int e = 0; e < 4 && at != NULL; e++) {
        double factor[3], w[5];
        const taut_curve *const from = problem.curves[e];
        at = strstr(at, taut_asymptotic_edge_name(e));
        CHECK(at != NULL && sscanf(at + 2, " %lf %lf %lf", &factor[0], &factor[1], &factor[2]) == 3,
              "%s", error.message);
        memcpy(w, taut_curve_weights(from), sizeof w);
        for (int j = 0; j < 3; j++) {
            w[j + 1] *= factor[j];
            CHECK(fabs(factor[j] - 1) < 0.011, "factor %g", factor[j]);
        }
        problem.curves[e] = asymptotic_curve(taut_curve_name(from), 4, taut_curve_points(from), w);
        taut_curve_free((taut_curve *)(size_t)from);
    }
    model = asymptotic_make(&problem, "the nearest weights");
    asymptotic_check_claims(model, &problem, "the nearest weights");
    taut_model_free(model);
    asymptotic_free_curves(&problem);
    taut_model_free(source);
}

typedef struct wrong {
    const char *what;
    taut_status status;
    const char *where, *message;
} wrong;

static void expect(const taut_asymptotic_problem *problem, wrong w)
{
    taut_error error = {.message = ""};
    const taut_status status = refusal(problem, &error);
    CHECK(status == w.status, "%s: %d %s", w.what, (int)status, error.message);
    CHECK(strcmp(error.where, w.where) == 0, "%s: where \"%s\"", w.what, error.where);
    CHECK(strstr(error.message, w.message) != NULL, "%s: %s", w.what, error.message);
}

static void test_refusals(void)
{
    taut_asymptotic_problem p = asymptotic_example(1, "++++");
    expect(&p, (wrong){"branch", TAUT_NO_SOLUTION, "/branch", "those that exist: -+-+ +-+-"});
    p = asymptotic_example(1, NULL);
    p.degree = 9;
    expect(&p, (wrong){"degree", TAUT_BAD_INPUT, "/degree", "3 to 8"});
    p = asymptotic_example(1, NULL);
    p.edges[2].weights[1] = 0;
    expect(&p, (wrong){"weight", TAUT_BAD_INPUT, "/edges/v1/weights", "positive"});
    p.edges[2].weights[1] = 2;
    expect(&p, (wrong){"unequal", TAUT_NO_SOLUTION, "/edges", "differ at corner u1v1"});
    p = asymptotic_example(1, NULL);
    p.edges[1].curvature[0] = nan("");
    expect(&p, (wrong){"curvature", TAUT_BAD_INPUT, "/edges/u0/curvature", "negative"});
    p.edges[1].curvature[0] = 0;
    expect(&p, (wrong){"half straight", TAUT_BAD_INPUT, "/edges/u0/curvature", "both are 0"});
    p = asymptotic_example(1, NULL);
    p.edges[0].curvature[0] = p.edges[0].curvature[1] = 0;
    expect(&p, (wrong){"bent straight", TAUT_NO_SOLUTION, "/edges", "does not lie along"});
    p = asymptotic_example(1, NULL);
    p.corners[1][0] = INFINITY;
    expect(&p, (wrong){"corner", TAUT_BAD_INPUT, "/corners", "finite"});
    p = asymptotic_example(1, NULL);
    memcpy(p.corners[1], p.corners[0], sizeof p.corners[0]);
    expect(&p, (wrong){"same corner", TAUT_NO_SOLUTION, "/corners", "same corner"});
    p = asymptotic_example(1, NULL);
    memcpy(p.edges[0].legs[0], p.edges[1].legs[0], sizeof p.edges[0].legs[0]);
    expect(&p, (wrong){"parallel", TAUT_NO_SOLUTION, "/edges", "parallel at corner u0v0"});
    p = asymptotic_example(1, NULL);
    memset(p.edges[3].legs[1], 0, sizeof p.edges[3].legs[1]);
    expect(&p, (wrong){"no leg", TAUT_BAD_INPUT, "/edges/u1/legs", "length zero"});
    p = asymptotic_example(1, NULL);
    p.surface = TAUT_ASYMPTOTIC_N_3;
    p.free_all = 1;
    expect(&p, (wrong){"free", TAUT_BAD_INPUT, "/free", "5n-7"});
    p = asymptotic_example(3, NULL);
    expect(&p,
           (wrong){"singular", TAUT_NO_SOLUTION, "", "edge v0 is singular at parameter 0.811599"});
}

static int stop_at_once(void *context, double done, const char *what)
{
    (void)done;
    (void)what;
    ++*(int *)context;
    return 1;
}

static void test_interrupted(void)
{
    const taut_asymptotic_problem problem = asymptotic_example(1, NULL);
    int calls = 0;
    const taut_make_options options = {.monitor = {stop_at_once, &calls}};
    taut_model *model = NULL;
    taut_error error;
    CHECK(taut_asymptotic_make(&problem, &options, &model, &error) == TAUT_INTERRUPTED, "stopped");
    CHECK(calls == 1 && model == NULL, "%d calls", calls);
}

int main(void)
{
    random_seed(4);
    test_energy_gradient();
    test_energy_values();
    test_quartic_gradient();
    test_nearest_curvatures();
    test_nearest_legs();
    test_nearest_weights();
    test_refusals();
    test_interrupted();
    return check_failures != 0;
}
