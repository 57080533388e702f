/* test_refused.c -- corner data without a quadrilateral: which condition fails, where,
 * by how much; that what a message advises is followed by a patch. */
#include "asymptotic.h"
#include "certificates.h"
#include "check.h"

#include "core/vec3.h"

#include <stdio.h>
#include <string.h>

/* A leg's coordinate that is moved. */
typedef struct move {
    int edge, end, axis;
    double by;
} move;

static taut_asymptotic_problem moved(int example, int count, const move *moves)
{
    taut_asymptotic_problem problem = asymptotic_example(example, NULL);
    for (int i = 0; i < count; i++) {
        problem.corners.edges[moves[i].edge].legs[moves[i].end][moves[i].axis] += moves[i].by;
    }
    return problem;
}

/* `names`: the edge, corner or point that the message must name. */
static taut_error refused(const taut_asymptotic_problem *problem, taut_status status,
                          const char *where, const char *reason, const char *names)
{
    taut_model *model = NULL;
    taut_error error = {.message = ""};
    const taut_status found = taut_asymptotic_make(problem, NULL, &model, &error);
    CHECK(found == status && model == NULL, "%s: %d: %s", reason, (int)found, error.message);
    CHECK(strcmp(error.where, where) == 0, "%s: at \"%s\"", reason, error.where);
    CHECK(strcmp(error.reason, reason) == 0 && strstr(error.message, names) != NULL,
          "%s, %s: %s, %s", reason, names, error.reason, error.message);
    taut_model_free(model);
    return error;
}

static void made(const taut_asymptotic_problem *problem, const char *what)
{
    taut_model *const model = asymptotic_make(problem, what);
    if (model != NULL) {
        asymptotic_check_claims_or_fold(model, problem, what);
    }
    taut_model_free(model);
}

/* Examples 1 and 6 with legs moved. In 6 mu and nu are fixed, 3 in size on every edge. */
static void test_quartics(void)
{
    static const struct {
        int example, count;
        move moves[3];
        taut_status status;
        const char *reason, *names;
        double found; /* NaN: none */
    } cases[] = {
        {1, 1, {{0, 1, 2, 0.2}}, TAUT_NO_SOLUTION, "parallel-planes", "edge v0", NAN},
        /* P_3 of v0 into the plane at u0v0, and of u0 into that of v0 and itself */
        {1,
         1,
         {{0, 1, 2, -0.3}},
         TAUT_NO_SOLUTION,
         "torsion",
         "at corner u0v0 the torsion of v0",
         0.012},
        {1,
         1,
         {{1, 1, 2, -0.3}},
         TAUT_NO_SOLUTION,
         "torsion",
         "at corner u0v0 the torsion of u0",
         0.012},
        {6, 2, {{3, 0, 0, 0.4}, {3, 0, 2, -1}}, TAUT_NO_SOLUTION, "turns-over", "edge v0", -1},
        {1,
         2,
         {{3, 1, 0, 0.4}, {3, 1, 1, 0.3}},
         TAUT_NOT_CONVERGED,
         "no-minimum",
         "1 sign branches",
         NAN},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const taut_asymptotic_problem problem =
            moved(cases[i].example, cases[i].count, cases[i].moves);
        const taut_error error =
            refused(&problem, cases[i].status, "/edges", cases[i].reason, cases[i].names);
        CHECK(isnan(cases[i].found) ? isnan(error.found)
                                    : fabs(fabs(error.found) - fabs(cases[i].found)) < 1e-12,
              "case %zu: found %.17g", i, error.found);
    }
}

/* A ring that closes only for nu / mu beyond what its edges have: the curvatures told are the limit
 * where middle points lie at infinity. Beyond, by any factor, it closes; short of them it is missed
 * by that factor. */
static void test_out_of_reach(void)
{
    static const int epsilon[4] = {1, -1, -1, 1};
    static const move moves[] = {{2, 1, 2, -0.3}, {2, 1, 0, -0.1}};
    taut_asymptotic_problem problem = moved(6, 2, moves);
    problem.corners.edges[0].curvature[1] = 1e5;
    taut_error error = refused(&problem, TAUT_NO_SOLUTION, "/edges", "closing", "more than");
    for (int e = 0; e < 4; e++) {
        char name[8];
        double *const k = problem.corners.edges[e].curvature;
        (void)snprintf(name, sizeof name, " %s [", taut_asymptotic_edge_name(e));
        const char *const at = strstr(error.message, name);
        CHECK(at != NULL && sscanf(at + 5, "%lf,%lf", &k[0], &k[1]) == 2, "%s", error.message);
    }
    for (int side = 0; side < 2; side++) {
        const double factor = (side == 0 ? -0.5 : 4) * (error.found > 0 ? 1 : -1);
        taut_asymptotic_problem near = problem;
        for (int e = 0; e < 4; e++) {
            near.corners.edges[e].curvature[0] /= exp(epsilon[e] * factor / 8);
            near.corners.edges[e].curvature[1] *= exp(epsilon[e] * factor / 8);
        }
        if (side == 0) {
            const taut_error again =
                refused(&near, TAUT_NO_SOLUTION, "/edges", "closing", "more than");
            CHECK_NEAR(again.found, -factor, 1e-12, "what was taken back");
        } else {
            made(&near, "beyond the curvatures told");
        }
    }
}

/* Point 1 of the last edge just through the tangent plane at that edge's other end. */
static void test_odd_ring(void)
{
    static const move moves[] = {{3, 0, 2, 0.32}};
    const taut_asymptotic_problem problem = moved(1, 1, moves);
    const taut_error error = refused(&problem, TAUT_NO_SOLUTION, "/edges", "torsion-signs",
                                     "point 1 of u1, off that of corner u1v1");
    /* (.8, 0, .42) over the plane normal to (.02, -.02, -.04) */
    CHECK_NEAR(error.found, 0.0008 / (sqrt(0.0024) * sqrt(0.8 * 0.8 + 0.42 * 0.42)), 1e-14, "sine");
}

/* End weights that differ by a million leave a negative weight beside an edge of the source's
 * patch, and the other patch is made; by 1e5 at one corner, for neither. */
static void test_uneven_weights(void)
{
    static const int corner[4][2] = {{0, 1}, {0, 2}, {2, 3}, {1, 3}};
    static const double weights[2][4] = {{1e3, 1e-3, 1, 1}, {1e5, 1, 1, 1}};
    for (int i = 0; i < 2; i++) {
        taut_asymptotic_problem problem = asymptotic_example(1, NULL);
        for (int k = 0; k < 8; k++) {
            problem.corners.edges[k / 2].weights[k % 2] = weights[i][corner[k / 2][k % 2]];
        }
        const taut_error error =
            refused(&problem, TAUT_NO_SOLUTION, "", "negative-weight", "weight 8 beside edge v0");
        CHECK(error.found < 0 && error.limit == 0, "weight %g", error.found);
        problem.surface = TAUT_BIDEGREE_N_PLUS_3;
        if (i == 0) {
            made(&problem, "uneven weights, n+3");
        } else {
            (void)refused(&problem, TAUT_NO_SOLUTION, "", "negative-weight", "");
        }
    }
}

/* Curvatures next to nothing: the start that suits them lies on the end of the range of P_2. */
static void test_flat_ends(void)
{
    taut_asymptotic_problem problem = asymptotic_random(4, 0.05);
    for (int e = 0; e < 4; e++) {
        problem.corners.edges[e].curvature[0] = problem.corners.edges[e].curvature[1] = 1e-25;
    }
    (void)refused(&problem, TAUT_NOT_CONVERGED, "/edges", "no-minimum", "");
}

/* Four straight edges leave nothing to be found: the bilinear patch, its curves without energy. */
static void test_straight_edges(void)
{
    for (int degree = 4; degree <= 5; degree++) {
        static const int ends[4][2] = {{0, 1}, {0, 2}, {2, 3}, {1, 3}};
        static const double corners[4][3] = {{0, 0, 0}, {2, 0, 1}, {0, 1.5, 1}, {2, 1.5, -0.5}};
        taut_asymptotic_problem problem = {.corners = {.degree = degree},
                                           .surface = TAUT_BIDEGREE_N_PLUS_3};
        memcpy(problem.corners.points, corners, sizeof corners);
        for (int e = 0; e < 4; e++) {
            for (int end = 0; end < 2; end++) {
                problem.corners.edges[e].weights[end] = 1;
                for (int k = 0; k < 3; k++) {
                    problem.corners.edges[e].legs[end][k] =
                        (corners[ends[e][1]][k] - corners[ends[e][0]][k]) / degree;
                }
            }
        }
        taut_model *const model = asymptotic_make(&problem, "four straight edges");
        double middle[3];
        asymptotic_check_claims(model, &problem, "four straight edges");
        CHECK(taut_surface_eval(taut_model_surface(model, 0), 0.5, 0.5, 0, middle) == TAUT_OK,
              "eval");
        for (int k = 0; k < 3; k++) {
            CHECK_NEAR(middle[k],
                       (corners[0][k] + corners[1][k] + corners[2][k] + corners[3][k]) / 4, 1e-12,
                       "degree %d", degree);
        }
        CHECK(detail_of(model, "curve_energy") == 0, "energy");
        taut_model_free(model);
    }
}

/* Degree 3: two cubics between two straight edges, v0 from (0,0,0) along x to (1,0,h), and one unit
 * on along y. P_2 moves along y from P_1, and the energy is least half way of what P_3 - P_1 has of
 * y: with nothing of it P_2 = P_1. */
static taut_asymptotic_problem between_lines(double aside)
{
    taut_asymptotic_problem problem = {.corners = {.degree = 3}};
    for (int c = 0; c < 4; c++) {
        problem.corners.points[c][0] = c % 2;
        problem.corners.points[c][1] = c / 2 + (c % 2 ? aside : 0);
        problem.corners.points[c][2] = c % 2;
    }
    for (int e = 0; e < 4; e++) {
        problem.corners.edges[e].legs[0][e % 2] = e % 2 == 0 ? 1 : 1. / 3;
        for (int j = 0; j < 4; j++) {
            problem.corners.edges[e].weights[j] = 1;
        }
    }
    return problem;
}

static void test_cubics(void)
{
    /* a leg of example 3 along its corner planes' common line, found from small integers */
    static const double start[4][2][3] = {{{2, -1, -2}, {1, 0, 2}},
                                          {{1, -2, -2}, {2, 1, 1}},
                                          {{1, -1, -1}, {1, 1, 2}},
                                          {{0, 1, 2}, {1, -2, -2}}};
    static const double end[4][2][3] = {{{-1, -1, -1}, {0, 0, -1}},
                                        {{0, -2, 1}, {-2, 2, -1}},
                                        {{-1, 0, 0}, {-2, 0, -2}},
                                        {{-1, 1, -1}, {2, 1, 2}}};
    /* legs a millionth of others: no step of Newton's leads to a ring that closes */
    static const double open[4][2][3] = {{{1, 1, -4}, {-1, 4, -1}},
                                         {{-2, 3, 4}, {2e-6, 3e-6, 2e-6}},
                                         {{0, 3, 4}, {1e-6, -4e-6, 2e-6}},
                                         {{-4, -2, 3}, {1, 1, -4}}};
    static const struct {
        const double (*data)[2][3];
        const char *reason, *names;
    } cases[] = {{start, "cannot-bend", "edge u0 cannot bend at corner u0v0"},
                 {end, "cannot-bend", "edge v0 cannot bend at corner u1v0"},
                 {open, "closing", ""}};
    taut_asymptotic_problem problem = {.corners = {.degree = 3}};
    for (int i = 0; i < 3; i++) {
        for (int e = 0; e < 4; e++) {
            memcpy(problem.corners.points[e], cases[i].data[e][0],
                   sizeof problem.corners.points[e]);
            memcpy(problem.corners.edges[e].legs[0], cases[i].data[e][1],
                   sizeof problem.corners.points[e]);
            for (int j = 0; j < 4; j++) {
                problem.corners.edges[e].weights[j] = 1;
            }
        }
        (void)refused(&problem, TAUT_NO_SOLUTION, "/edges", cases[i].reason, cases[i].names);
    }
    for (int e = 0; e < 4; e++) { /* all in a plane */
        problem.corners.points[e][2] = problem.corners.edges[e].legs[0][2] = 0;
    }
    (void)refused(&problem, TAUT_NO_SOLUTION, "/edges", "parallel-planes", "edge v0");
    problem = between_lines(0);
    (void)refused(&problem, TAUT_NO_SOLUTION, "/edges", "no-minimum", "edge v0");
    problem = between_lines(0.5);
    problem.report_singular = 1;
    taut_model *const model = asymptotic_make(&problem, "two cubics between lines");
    for (int c = 0; c < 2 && model != NULL; c++) {
        const double *const p = taut_curve_points(taut_model_curve(model, c)); /* v0, v1 */
        CHECK_NEAR(p[6], p[3], 1e-14, "curve %d: along x", c);
        CHECK_NEAR(p[7], p[4] + 0.25, 1e-14, "curve %d: half way aside", c);
        CHECK_NEAR(p[8], p[5], 1e-14, "curve %d: no height", c);
    }
    taut_model_free(model);
}

/* The problem of the four curves of a model. */
static taut_asymptotic_problem curves_of(const taut_model *model)
{
    taut_asymptotic_problem problem;
    memset(&problem, 0, sizeof problem);
    problem.given = TAUT_ASYMPTOTIC_CURVES;
    for (int c = 0; c < 4; c++) {
        const taut_curve *const from = taut_model_curve(model, c);
        for (int e = 0; e < 4; e++) {
            if (strcmp(taut_curve_name(from), taut_asymptotic_edge_name(e)) == 0) {
                problem.curves[e] =
                    asymptotic_curve(taut_curve_name(from), taut_basis_degree(taut_curve_t(from)),
                                     taut_curve_points(from), taut_curve_weights(from));
            }
        }
    }
    return problem;
}

static void replace_curve(taut_asymptotic_problem *problem, int edge, const double (*points)[3],
                          const double *weights)
{
    taut_curve *const old = (taut_curve *)(size_t)problem->curves[edge];
    const int degree = taut_basis_degree(taut_curve_t(old));
    problem->curves[edge] =
        asymptotic_curve(taut_asymptotic_edge_name(edge), degree, &points[0][0], weights);
    taut_curve_free(old);
}

/* The curves of example 1 with points of v0 moved: its leg along that of u0, its third point on the
 * leg's line, above the plane, its fourth through the plane at the start within that at the end. */
static void test_points(void)
{
    const taut_asymptotic_problem corner = asymptotic_example(1, "-+-+");
    taut_model *const source = asymptotic_make(&corner, "source");
    static const char *const words[4][2] = {{"parallel-legs", "v0 and u0"},
                                            {"no-curvature", "edge v0"},
                                            {"osculating-plane", "of v0 at corner u0v0"},
                                            {"torsion", "none"}};
    for (int i = 0; i < 4; i++) {
        taut_asymptotic_problem problem = curves_of(source);
        double p[5][3], w[5], bend[3], leg[3], other[3];
        memcpy(p, taut_curve_points(problem.curves[0]), sizeof p);
        memcpy(w, taut_curve_weights(problem.curves[0]), sizeof w);
        const double *const u0 = taut_curve_points(problem.curves[1]);
        for (int k = 0; k < 3; k++) {
            p[1][k] = i == 0 ? 2 * u0[3 + k] - p[0][k] : p[1][k];
            p[2][k] = i == 1 ? 2 * p[1][k] - p[0][k] : p[2][k] + (i == 2 && k == 2 ? 0.1 : 0);
            p[3][k] = i == 3 ? 2 * p[2][k] - p[3][k] : p[3][k];
        }
        replace_curve(&problem, 0, (const double(*)[3])p, w);
        const taut_error error = refused(&problem, TAUT_NO_SOLUTION, "", words[i][0], words[i][1]);
        taut_difference(p[1], p[0], leg);
        taut_difference(p[2], p[0], bend);
        taut_difference(u0 + 3, u0, other);
        taut_cross(leg, bend, bend);
        CHECK(i != 2 || fabs(error.found - fabs(taut_dot(bend, other)) /
                                               (taut_norm(bend) * taut_norm(other))) < 1e-14,
              "%g", error.found);
        CHECK(i > 1 || error.found < 1e-14, "%g", error.found);
        asymptotic_free_curves(&problem);
    }
    taut_model_free(source);
}

/* Arguments, and curves that cannot be a boundary. */
static void test_curves(void)
{
    static double points[10][3];
    static const int wrong_way[3] = {0, 1, 2};
    const lelieuvre net = lelieuvre_random(2);
    taut_asymptotic_problem problem = lelieuvre_problem(&net), bad = problem;
    const taut_basis_spec late = {.type = "bezier", .degree = 3, .has_range = 1, .range = {0, 2}};
    taut_basis *basis = NULL;
    taut_curve *curve = NULL;
    taut_model *model = NULL;
    taut_error error;
    CHECK(taut_asymptotic_make(NULL, NULL, &model, &error) == TAUT_BAD_ARGUMENT, "no problem");
    CHECK(taut_asymptotic_make(&problem, NULL, NULL, &error) == TAUT_BAD_ARGUMENT, "no place");
    bad.curves[2] = NULL;
    (void)refused(&bad, TAUT_BAD_INPUT, "/curves/v1", "missing", "v1");
    bad.curves[2] = asymptotic_curve("v1", 9, points[0], NULL);
    error = refused(&bad, TAUT_BAD_INPUT, "/curves/v1", "value", "v1");
    CHECK(error.found == 9 && error.limit == 8, "%g of %g", error.found, error.limit);
    taut_curve_free((taut_curve *)(size_t)bad.curves[2]);
    CHECK(taut_basis_new(&late, 0, &basis, NULL) == TAUT_OK, "basis");
    CHECK(taut_curve_new("v1", basis, points[0], NULL, &curve, NULL) == TAUT_OK, "curve");
    bad.curves[2] = curve;
    (void)refused(&bad, TAUT_BAD_INPUT, "/curves/v1", "not-bezier", "v1");
    taut_curve_free(curve);
    taut_basis_free(basis);
    for (int i = 0; i < 3; i++) {
        const double *const from = taut_curve_points(problem.curves[wrong_way[i]]);
        double turned[4][3];
        for (int j = 0; j < 4; j++) {
            memcpy(turned[j], from + 3 * (3 - j), sizeof turned[j]);
        }
        replace_curve(&problem, wrong_way[i], (const double(*)[3])turned, NULL);
    }
    (void)refused(&problem, TAUT_NO_SOLUTION, "/curves", "not-closed",
                  "with v0, u0 and v1 reversed");
    asymptotic_free_curves(&problem);
    bad = asymptotic_example(1, NULL);
    bad.corners.edges[1].legs[1][2] = NAN;
    (void)refused(&bad, TAUT_BAD_INPUT, "/edges/u0/legs", "value", "");
}

/* det(a + b, a', a'') along an edge of a net, which is 0 at its inflections, by differences. */
static double turning(const lelieuvre *net, int edge, double t)
{
    double x[3][3], first[3], second[3];
    for (int k = 0; k < 3; k++) {
        const double at = t + 1e-4 * (k - 1), side = edge / 2;
        lelieuvre_normal(net, edge % 2 == 0 ? at : side, edge % 2 == 0 ? side : at, x[k]);
    }
    for (int k = 0; k < 3; k++) {
        first[k] = x[2][k] - x[0][k];
        second[k] = x[2][k] - 2 * x[1][k] + x[0][k];
    }
    return taut_det(x[1], first, second);
}

/* n + 3 refuses what 5n - 7 can make or report: an edge that turns over, an inflection. */
static void test_low(void)
{
    taut_asymptotic_problem problem = asymptotic_example(3, NULL);
    problem.surface = TAUT_BIDEGREE_N_PLUS_3;
    taut_error error = refused(&problem, TAUT_NO_SOLUTION, "", "singular", "edge v0");
    CHECK(error.found > 0 && error.found < 1, "%g", error.found);
    for (int trial = 0, met = 0; trial < 40 && !met; trial++) {
        const lelieuvre net = lelieuvre_random(3);
        taut_model *model = NULL;
        problem = lelieuvre_problem(&net);
        problem.surface = TAUT_BIDEGREE_N_PLUS_3;
        (void)taut_asymptotic_make(&problem, NULL, &model, &error);
        met = model == NULL && strcmp(error.reason, "inflection") == 0;
        for (int e = 0; e < 4 && met; e++) {
            if (strstr(error.message, taut_asymptotic_edge_name(e)) != NULL) {
                CHECK(turning(&net, e, error.found - 1e-3) * turning(&net, e, error.found + 1e-3) <
                          0,
                      "%s", error.message);
            }
        }
        CHECK(met || trial < 39, "no inflection in 40 nets");
        taut_model_free(model);
        asymptotic_free_curves(&problem);
    }
}

static int stop_inside(void *context, double done, const char *what)
{
    *(double *)context = done;
    return strcmp(what, "inner points") == 0 && done > 0.7;
}

static void test_interrupted(void)
{
    const taut_asymptotic_problem problem = asymptotic_example(1, NULL);
    double done = 0;
    const taut_make_options options = {.monitor = {stop_inside, &done}};
    taut_model *model = NULL;
    taut_error error;
    CHECK(taut_asymptotic_make(&problem, &options, &model, &error) == TAUT_INTERRUPTED, "stopped");
    CHECK(done > 0.7 && done < 0.75 && model == NULL, "at %g", done);
}

int main(void)
{
    random_seed(20261130);
    test_quartics();
    test_out_of_reach();
    test_odd_ring();
    test_uneven_weights();
    test_flat_ends();
    test_straight_edges();
    test_cubics();
    test_points();
    test_curves();
    test_low();
    test_interrupted();
    return check_failures != 0;
}
