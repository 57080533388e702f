/* test_corner.c -- Algorithm 1: gradients, what is refused and with which nearest data.
 */
#include "asymptotic.h"
#include "check.h"
#include "monitors.h"

#include "construct/asymptotic/conditions.h"
#include "construct/asymptotic/quartic_search.h"
#include "construct/asymptotic/quintic_search.h"
#include "core/vec3.h"

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

/* Second derivatives of a curve's energy against central differences of the first, which are those of
 * taut_curve_energy. Seen: below 3e-9 of the energy. */
static void test_energy_second(void)
{
    static const int point[TAUT_CURVE_MOVES] = {1, 2, 2, 3, 3, 0};
    const double h = 1e-5;
    for (int n = 3; n <= 6; n++) {
        taut_quad_edge edge = random_edge(n);
        taut_curve_rule rule;
        taut_curve_moves moves = {.count = TAUT_CURVE_MOVES};
        double way[TAUT_CURVE_MOVES][3], first[TAUT_CURVE_WAYS], up[TAUT_CURVE_WAYS];
        double down[TAUT_CURVE_WAYS], by_point[TAUT_QUAD_POINTS][3], by_log[TAUT_QUAD_POINTS];
        double second[TAUT_CURVE_WAYS][TAUT_CURVE_WAYS], unused[TAUT_CURVE_WAYS][TAUT_CURVE_WAYS];
        const int ways = TAUT_CURVE_MOVES + n - 1;
        double energy = 0.0;
        memcpy(moves.point, point, sizeof point);
        for (int a = 0; a < TAUT_CURVE_MOVES; a++) {
            moves.direction[a] = way[a];
            for (int k = 0; k < 3; k++) {
                way[a][k] = random_in(-1, 1);
            }
        }
        taut_curve_rule_fill(n, TAUT_CURVE_FINE, &rule);
        energy = taut_curve_energy(&rule, &edge, by_point, by_log);
        taut_curve_second(&rule, &edge, &moves, first, second);
        for (int a = 0; a < ways; a++) {
            const int j = a < moves.count ? point[a] : a - moves.count + 1;
            taut_quad_edge high = edge, low = edge;
            CHECK_NEAR(first[a], a < moves.count ? taut_dot(by_point[j], way[a]) : by_log[j],
                       1e-12 * energy, "n=%d way %d", n, a);
            if (a < moves.count) {
                taut_add_scaled(h, way[a], high.points[j]);
                taut_add_scaled(-h, way[a], low.points[j]);
            } else {
                high.weights[j] *= exp(h);
                low.weights[j] *= exp(-h);
            }
            taut_curve_second(&rule, &high, &moves, up, unused);
            taut_curve_second(&rule, &low, &moves, down, unused);
            for (int b = 0; b <= a; b++) {
                CHECK_NEAR(second[a][b], (up[b] - down[b]) / (2 * h), 1e-8 * energy,
                           "n=%d ways %d %d", n, a, b);
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
        CHECK(taut_corner_data_fill(&problem.corners, 0.0, &data, &error) == TAUT_OK, "%s",
              error.message);
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

/* The degree-5 gradient and Hessian against central differences, where the degree is raised later and
 * where it is not. Differences miss by h^2 times higher derivatives; seen: 4e-7 of the value. */
static void test_quintic_hessian(void)
{
    static taut_corner_data data;
    for (int trial = 0; trial < 12; trial++) {
        const taut_asymptotic_problem problem = asymptotic_random(5 + trial % 3, 0.08);
        const int signs[4] = {trial & 1 ? 1 : -1, trial & 2 ? 1 : -1, trial & 4 ? 1 : -1, 1};
        taut_quintic_search s;
        taut_error error = {.message = ""};
        double x[24], g[2][24], gradient[24], hessian[24 * 24], value = 0.0;
        uint64_t noise = (uint64_t)trial + 1;
        CHECK(taut_corner_data_fill(&problem.corners, 0.0, &data, &error) == TAUT_OK, "%s",
              error.message);
        taut_quintic_plan(&data, signs, &s);
        s.rule = &data.fine;
        CHECK(s.count == 20, "trial %d: %d unknowns", trial, s.count);
        if (!taut_quintic_start(&s, trial, &noise, x) ||
            !taut_quintic_objective(&s, x, &value, gradient)) {
            continue;
        }
        taut_quintic_hessian(&s, x, hessian);
        for (int j = 0; j < s.count; j++) {
            const double h = 1e-5, keep = x[j];
            double ends[2];
            for (int k = 0; k < 2; k++) {
                x[j] = keep + (k == 0 ? h : -h);
                CHECK(taut_quintic_objective(&s, x, &ends[k], g[k]), "trial %d", trial);
            }
            x[j] = keep;
            CHECK_NEAR(gradient[j], (ends[0] - ends[1]) / (2 * h), 1e-6 * value,
                       "trial %d unknown %d", trial, j);
            for (int i = 0; i < s.count; i++) {
                CHECK_NEAR(hessian[i * s.count + j], (g[0][i] - g[1][i]) / (2 * h), 1e-6 * value,
                           "trial %d unknowns %d %d", trial, i, j);
            }
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

/* The numbers of edge e in a message that lists "v0 [a,b,...] v1 [...] ..." after `from`. */
static int read_list(const char *message, const char *from, int e, int count, double *x)
{
    char name[8];
    const char *at = strstr(message, from);
    int read = 0;
    (void)snprintf(name, sizeof name, " %s [", taut_asymptotic_edge_name(e));
    at = at != NULL ? strstr(at, name) : NULL;
    for (at = at != NULL ? at + 5 : NULL; at != NULL && read < count; read++) {
        char *end = NULL;
        x[read] = strtod(at, &end);
        at = end != at && (*end == ',' || *end == ']') ? end + 1 : NULL;
    }
    return read == count;
}

/* One curvature of example 1 changed: refused with the factor it misses by; the curvatures that the
 * message names, read from it, close the ring to the last digit, all eight changed alike. */
static void test_nearest_curvatures(void)
{
    taut_asymptotic_problem problem = asymptotic_example(1, NULL);
    taut_error error;
    taut_model *model = NULL;
    problem.corners.edges[0].curvature[1] = 1.3;
    CHECK(refusal(&problem, &error) == TAUT_NO_SOLUTION, "%s", error.message);
    CHECK_NEAR(fabs(error.found), log(1.3), 1e-12, "by how much");
    for (int e = 0; e < 4; e++) {
        double x[2] = {0};
        CHECK(read_list(error.message, "nearest curvatures", e, 2, x), "%s", error.message);
        for (int k = 0; k < 2; k++) {
            CHECK_NEAR(fabs(log(x[k] / problem.corners.edges[e].curvature[k])),
                       fabs(error.found) / 8, 1e-14, "edge %d end %d", e, k);
            problem.corners.edges[e].curvature[k] = x[k];
        }
    }
    model = asymptotic_make(&problem, "the nearest curvatures");
    asymptotic_check_claims(model, &problem, "the nearest curvatures");
    taut_model_free(model);
}

/* End weights of corner data that differ at several corners: those of the message are the geometric
 * means, and taken. */
static void test_nearest_end_weights(int number)
{
    taut_asymptotic_problem problem = asymptotic_example(number, NULL);
    const int count = number == 3 ? 4 : 2;
    taut_error error;
    taut_model *model = NULL;
    double *const a = &problem.corners.edges[0].weights[count - 1], *const b =
                                                                        &problem.corners.edges[3]
                                                                             .weights[0];
    const double mean = sqrt(1.7 * 0.6);
    problem.report_singular = number == 3;
    *a = 1.7;
    *b = 0.6;
    problem.corners.edges[2].weights[0] = 3;
    CHECK(refusal(&problem, &error) == TAUT_NO_SOLUTION, "%s", error.message);
    for (int e = 0; e < 4; e++) {
        CHECK(
            read_list(error.message, "nearest weights", e, count, problem.corners.edges[e].weights),
            "%s", error.message);
    }
    CHECK(*a == *b && fabs(*a - mean) < 1e-15, "%.17g and %.17g", *a, *b);
    CHECK_NEAR(problem.corners.edges[1].weights[count - 1], sqrt(3), 1e-15, "u0v1");
    CHECK(problem.corners.edges[1].weights[0] == 1, "a corner without strife keeps its weight");
    model = asymptotic_make(&problem, "the nearest end weights");
    asymptotic_check_claims_or_fold(model, &problem, "the nearest end weights");
    taut_model_free(model);
}

/* Of given curves, one of them a line of degree 1: the c and q of the message leave each curve as
 * it is, and the patch is made. */
static void test_nearest_curve_weights(void)
{
    /* of z = xy - x^3/3 */
    static const double v0[4][3] = {{0, 0, 0}, {0.4, 0, 0}, {0.8, 0.24, 0}, {1.2, 0.72, 0.288}};
    static const double v1[4][3] = {{0, 1, 0}, {0.4, 1, 0.4}, {0.8, 1.24, 0.8}, {1.2, 1.72, 1.488}};
    static const double u0[4][3] = {{0, 0, 0}, {0, 1. / 3, 0}, {0, 2. / 3, 0}, {0, 1, 0}};
    static const double u1[2][3] = {{1.2, 0.72, 0.288}, {1.2, 1.72, 1.488}};
    double weights[4][4] = {{1, 1.2, 1.44, 1.728}, {3, 3, 3, 3}, {1, 1, 1, 1}, {1.5, 0.5}};
    const double *const points[4] = {v0[0], u0[0], v1[0], u1[0]};
    taut_asymptotic_problem problem;
    taut_error error = {.message = ""};
    taut_model *model = NULL;
    for (int trial = 0; trial < 2; trial++) {
        memset(&problem, 0, sizeof problem);
        problem.given = TAUT_ASYMPTOTIC_CURVES;
        for (int e = 0; e < 4; e++) {
            const int n = e == 3 ? 1 : 3;
            double c = 1, q = 1;
            char name[8];
            const char *at = NULL;
            (void)snprintf(name, sizeof name, " %s c", taut_asymptotic_edge_name(e));
            at = strstr(error.message, name);
            CHECK(trial == 0 || (at != NULL && sscanf(at + 4, " c = %lf, q = %lf", &c, &q) == 2),
                  "%s", error.message);
            for (int j = 0; j <= n; j++) {
                weights[e][j] *= c * pow(q, j);
            }
            problem.curves[e] =
                asymptotic_curve(taut_asymptotic_edge_name(e), n, points[e], weights[e]);
        }
        if (trial == 0) {
            CHECK(refusal(&problem, &error) == TAUT_NO_SOLUTION, "%s", error.message);
        } else {
            model = asymptotic_make(&problem, "the nearest weights of curves");
            asymptotic_check_claims(model, &problem, "the nearest weights of curves");
            CHECK_NEAR(weights[0][0], sqrt(3), 1e-14, "geometric mean");
        }
        asymptotic_free_curves(&problem);
    }
    taut_model_free(model);
}

/* Point 3 of an edge on either side of the tangent plane at its start: on one the signs of the
 * torsions suit each other, on the other the message names that point and its sine. */
static void test_odd_ring(void)
{
    taut_asymptotic_problem problem = asymptotic_random(4, 0.02);
    taut_error error = {.message = ""};
    const double *const a = problem.corners.edges[0].legs[0], *const b =
                                                                  problem.corners.edges[1].legs[0];
    double *const leg = problem.corners.edges[0].legs[1];
    double normal[3], height = 0.0;
    taut_status status[2];
    for (int k = 0; k < 3; k++) {
        normal[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
        height +=
            normal[k] * (problem.corners.points[1][k] - leg[k] - problem.corners.points[0][k]);
    }
    leg[2] += height / normal[2]; /* now in the plane */
    for (int side = 0; side < 2; side++) {
        taut_model *model = NULL;
        leg[2] += side == 0 ? 0.01 : -0.02;
        status[side] = taut_asymptotic_make(&problem, NULL, &model, &error);
        taut_model_free(model);
    }
    CHECK((strcmp(error.reason, "torsion-signs") == 0) &&
              (status[0] == TAUT_NO_SOLUTION) != (status[1] == TAUT_NO_SOLUTION),
          "%d, %d: %s", (int)status[0], (int)status[1], error.message);
    CHECK(strstr(error.message, "point 3 of v0, off that of corner u0v0") != NULL &&
              error.found > 0 && error.found < 0.02,
          "%g: %s", error.found, error.message);
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
    problem.corners.edges[0].legs[0][2] = 0.03;
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
            moved = fmax(moved, fabs(legs[k][d] - problem.corners.edges[order[k]].legs[0][d]));
            problem.corners.edges[order[k]].legs[0][d] = legs[k][d];
        }
        CHECK(moved < 0.05, "leg %d moved by %g", k, moved);
    }
    model = asymptotic_make(&problem, "the nearest legs");
    asymptotic_check_claims_or_fold(model, &problem, "the nearest legs"); /* singular */
    taut_model_free(model);
}

/* Given curves with a weight changed: opposite torsions fail, and the factors on inner weights that
 * the message gives mend it; a straight edge, v0 of example 5, stays as it is. */
static void test_nearest_weights(int number)
{
    const taut_asymptotic_problem corner = asymptotic_example(number, number == 1 ? "-+-+" : NULL);
    taut_model *source = asymptotic_make(&corner, "source"), *model = NULL;
    taut_asymptotic_problem problem;
    taut_error error;
    const char *at = NULL;
    memset(&problem, 0, sizeof problem);
    problem.given = TAUT_ASYMPTOTIC_CURVES;
    for (int c = 0; c < 4; c++) {
        const taut_curve *const from = taut_model_curve(source, c);
        double w[5];
        memcpy(w, taut_curve_weights(from), sizeof w);
        w[2] *= strcmp(taut_curve_name(from), "v1") == 0 ? 1.01 : 1.0;
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
            CHECK(number != 5 || e != 0 || factor[j] == 1, "of a straight edge: %g", factor[j]);
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
    const char *where, *reason;
} wrong;

static void expect(const taut_asymptotic_problem *problem, wrong w)
{
    taut_error error = {.message = ""};
    const taut_status status = refusal(problem, &error);
    CHECK(status == w.status, "%s: %d %s", w.what, (int)status, error.message);
    CHECK(strcmp(error.where, w.where) == 0, "%s: where \"%s\"", w.what, error.where);
    CHECK(strcmp(error.reason, w.reason) == 0, "%s: %s, %s", w.what, error.reason, error.message);
}

static void test_refusals(void)
{
    taut_asymptotic_problem p = asymptotic_example(1, "++++");
    expect(&p, (wrong){"branch", TAUT_NO_SOLUTION, "/branch", "no-branch"});
    p = asymptotic_example(1, NULL);
    p.corners.degree = 9;
    expect(&p, (wrong){"degree", TAUT_BAD_INPUT, "/degree", "value"});
    p = asymptotic_example(1, NULL);
    p.corners.edges[2].weights[1] = 0;
    expect(&p, (wrong){"weight", TAUT_BAD_INPUT, "/edges/v1/weights", "value"});
    p.corners.edges[2].weights[1] = 2;
    expect(&p, (wrong){"unequal", TAUT_NO_SOLUTION, "/edges", "end-weights"});
    p = asymptotic_example(1, NULL);
    p.corners.edges[1].curvature[0] = nan("");
    expect(&p, (wrong){"curvature", TAUT_BAD_INPUT, "/edges/u0/curvature", "value"});
    p.corners.edges[1].curvature[0] = 0;
    expect(&p, (wrong){"half straight", TAUT_BAD_INPUT, "/edges/u0/curvature", "value"});
    p = asymptotic_example(1, NULL);
    p.corners.edges[0].curvature[0] = p.corners.edges[0].curvature[1] = 0;
    expect(&p, (wrong){"bent straight", TAUT_NO_SOLUTION, "/edges", "straight-edge"});
    p = asymptotic_example(1, NULL);
    p.corners.points[1][0] = INFINITY;
    expect(&p, (wrong){"corner", TAUT_BAD_INPUT, "/corners", "value"});
    p = asymptotic_example(1, NULL);
    memcpy(p.corners.points[1], p.corners.points[0], sizeof p.corners.points[0]);
    expect(&p, (wrong){"same corner", TAUT_NO_SOLUTION, "/corners", "same-corner"});
    p = asymptotic_example(1, NULL);
    memcpy(p.corners.edges[0].legs[0], p.corners.edges[1].legs[0],
           sizeof p.corners.edges[0].legs[0]);
    expect(&p, (wrong){"parallel", TAUT_NO_SOLUTION, "/edges", "parallel-legs"});
    p = asymptotic_example(1, NULL);
    memset(p.corners.edges[3].legs[1], 0, sizeof p.corners.edges[3].legs[1]);
    expect(&p, (wrong){"no leg", TAUT_BAD_INPUT, "/edges/u1/legs", "value"});
    p = asymptotic_example(1, NULL);
    p.surface = TAUT_BIDEGREE_N_PLUS_3;
    p.free_all = 1;
    expect(&p, (wrong){"free", TAUT_BAD_INPUT, "/free", "conflict"});
    p = asymptotic_example(3, NULL);
    expect(&p, (wrong){"singular", TAUT_NO_SOLUTION, "", "singular"});
}

static void test_interrupted(void)
{
    const taut_asymptotic_problem problem = asymptotic_example(1, NULL);
    watch once = {.stop_at = 1};
    const taut_make_options options = {.monitor = monitor_of(&once)};
    taut_model *model = NULL;
    taut_error error;
    CHECK(taut_asymptotic_make(&problem, &options, &model, &error) == TAUT_INTERRUPTED, "stopped");
    CHECK(once.reports == 1 && model == NULL, "%d reports", once.reports);
}

int main(void)
{
    random_seed(4);
    test_energy_gradient();
    test_energy_second();
    test_energy_values();
    test_quartic_gradient();
    test_quintic_hessian();
    test_nearest_curvatures();
    test_nearest_end_weights(1);
    test_nearest_end_weights(3);
    test_nearest_curve_weights();
    test_odd_ring();
    test_nearest_legs();
    test_nearest_weights(1);
    test_nearest_weights(5);
    test_refusals();
    test_interrupted();
    return check_failures != 0;
}
