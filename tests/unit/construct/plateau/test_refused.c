/* test_refused.c -- what a least area refuses: which member, by which number, and why; and
 * the numbers of double precision that are too large or too small for it. */
#include "check.h"
#include "films.h"
#include "problems.h"

#include "taut/plateau.h"

#include <float.h>
#include <math.h>
#include <string.h>

typedef struct refusal {
    taut_status status;
    const char *where, *reason;
    double found, limit; /* NaN: none */
} refusal;

static int same(double found, double expected)
{
    return found == expected || (isnan(found) && isnan(expected));
}

static void refused(const taut_plateau_problem *problem, const refusal *expected)
{
    taut_model *model = NULL;
    taut_error error = {0};
    const taut_status status = taut_plateau_make(problem, NULL, &model, &error);
    CHECK(status == expected->status && strcmp(error.where, expected->where) == 0 && model == NULL,
          "expected %s, found %s at %s", expected->where, error.message, error.where);
    CHECK(strcmp(error.reason, expected->reason) == 0, "expected %s, found %s: %s",
          expected->reason, error.reason, error.message);
    CHECK(same(error.found, expected->found) && same(error.limit, expected->limit),
          "%s: found %g, limit %g", expected->where, error.found, error.limit);
}

/* Straight from one corner of a square of half the side to the next, the middle raised. */
static taut_curve *edge(int side, double half, double raised)
{
    static const int corners[4][2] = {{0, 2}, {1, 3}, {0, 1}, {2, 3}};
    taut_basis *t = basis_uniform(2, 3);
    taut_curve *curve = NULL;
    double points[9];
    for (int k = 0; k < 3; k++) {
        const int from = corners[side][0], to = corners[side][1];
        const double x = 0.5 * ((2 - k) * (from % 2) + k * (to % 2));
        const double y = 0.5 * ((2 - k) * (from / 2) + k * (to / 2));
        points[3 * k] = half * (2 * x - 1);
        points[3 * k + 1] = half * (2 * y - 1);
        points[3 * k + 2] = k == 1 ? raised : 0;
    }
    CHECK(taut_curve_new("edge", t, points, NULL, &curve, NULL) == TAUT_OK, "an edge");
    taut_basis_free(t);
    return curve;
}

static void test_numbers(void)
{
    static const double areas[] = {1e-12, -1e-3, 1, INFINITY};
    static const int methods[] = {-1, 3}, refines[] = {-1, TAUT_PLATEAU_REFINE_MAX + 1};
    test_problem net = problem_example(1);
    const taut_plateau_problem good = film_problem(&net, TAUT_PLATEAU_FULL);
    taut_plateau_problem problem = good;

    for (int k = 0; k < 4; k++) {
        const refusal e = {TAUT_BAD_INPUT, "/tolerance_area", "value", areas[k],
                           TAUT_PLATEAU_AREA_MIN};
        problem.tolerance_area = areas[k];
        refused(&problem, &e);
    }
    for (int k = 0; k < 2; k++) {
        const refusal method = {TAUT_BAD_INPUT, "/method", "name", NAN, NAN};
        const refusal refine = {TAUT_BAD_INPUT, "/refine", "value", refines[k], 6};
        problem = good;
        problem.method = (taut_plateau_method)methods[k];
        refused(&problem, &method);
        problem = good;
        problem.refine = refines[k];
        refused(&problem, &refine);
    }
    problem_free(&net);
}

/* Members that do not go together, and ones that are missing. */
static void test_members(void)
{
    const refusal needs = {TAUT_BAD_ARGUMENT, "", "argument", NAN, NAN};
    const refusal own = {TAUT_BAD_INPUT, "/tolerance_area", "conflict", NAN, NAN};
    const refusal start = {TAUT_BAD_INPUT, "/start", "conflict", NAN, NAN};
    const refusal weights = {TAUT_BAD_INPUT, "/weights", "conflict", NAN, NAN};
    const refusal frame = {TAUT_BAD_INPUT, "/points", "conflict", NAN, NAN};
    const refusal finite = {TAUT_BAD_INPUT, "/start/points/1/1", "value", INFINITY, NAN};
    taut_curve *curves[4] = {edge(0, 1, 0.1), edge(1, 1, 0.1), edge(2, 1, 0.1), edge(3, 1, 0.1)};
    test_problem net = problem_example(1);
    const taut_plateau_problem good = film_problem(&net, TAUT_PLATEAU_FULL);
    taut_plateau_problem problem = good;

    problem.net.u = NULL;
    refused(&problem, &needs);
    problem = good;
    problem.net.known = NULL;
    refused(&problem, &needs);
    problem = good;
    memcpy(problem.curves, curves, 3 * sizeof *curves); /* three are no boundary */
    refused(&problem, &needs);
    problem = good;
    problem.tolerance_area = 0.1;
    problem.refine = 1;
    refused(&problem, &own);
    problem.refine = 0;
    problem.start = net.points;
    refused(&problem, &own);
    problem.tolerance_area = 0;
    memcpy(problem.curves, curves, sizeof curves);
    refused(&problem, &start);
    problem.start = NULL;
    problem_random_weights(&net, 1.5);
    problem.net.weights = net.weights;
    refused(&problem, &weights);
    problem = good;
    net.known[1] = 0; /* an edge that is not known is none to refine */
    problem.refine = 1;
    refused(&problem, &frame);
    problem = good;
    problem.start = net.points;
    net.points[3 * 4 + 1] = INFINITY;
    refused(&problem, &finite);
    for (int k = 0; k < 4; k++) {
        taut_curve_free(curves[k]);
    }
    problem_free(&net);
}

/* Curves that no row of points can follow: knots nearer to each other than numbers can tell, and
 * curves whose size is beyond the largest number. Half as large they are fitted. */
static void test_fits(void)
{
    const refusal far = {TAUT_NOT_CONVERGED, "/curves", "curve-fit", NAN, NAN};
    const double near = 1e-16;
    const double knots[11] = {0, 0, 0, 0, near, 2 * near, 3 * near, 1, 1, 1, 1};
    const taut_basis_spec spec = {.type = "bspline", .degree = 3, .knot_count = 11, .knots = knots};
    static const double halves[3] = {1, 1.7e308, 0.8e308};

    for (int k = 0; k < 3; k++) {
        taut_plateau_problem problem;
        taut_basis *basis = k == 0 ? NULL : basis_uniform(3, 6);
        taut_model *model = NULL;
        memset(&problem, 0, sizeof problem);
        if (k == 0) {
            CHECK(taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK, "knots 1e-16 apart");
        }
        problem.net.u = problem.net.v = basis;
        for (int side = 0; side < 4; side++) {
            problem.curves[side] = edge(side, halves[k], (side < 2 ? 0.1 : -0.1) * halves[k]);
        }
        if (k < 2) {
            refused(&problem, &far);
        } else {
            CHECK(taut_plateau_make(&problem, NULL, &model, NULL) == TAUT_OK, "a large square");
        }
        for (int side = 0; side < 4; side++) {
            taut_curve_free((taut_curve *)problem.curves[side]);
        }
        taut_model_free(model);
        taut_basis_free(basis);
    }
}

static double farthest(const taut_model *model)
{
    const taut_surface *s = model != NULL ? taut_model_surface(model, 0) : NULL;
    double most = 0;
    for (int i = 0; s != NULL && i < 3 * 16; i++) {
        most = fmax(most, fabs(taut_surface_points(s)[i]));
    }
    return most;
}

/* Films whose points go beyond those of the Dirichlet surface, which they begin with, and so large
 * that only that one is within the range of numbers. */
static void test_range(void)
{
    const refusal far = {TAUT_NO_SOLUTION, "/points", "overflow", NAN, NAN};
    int seen = 0;

    random_seed(20260711);
    for (int trial = 0; trial < 400 && seen < 2; trial++) {
        test_problem net = problem_new(basis_uniform(3, 4), basis_uniform(3, 4));
        taut_model *first = NULL, *film = NULL;
        problem_random_boundary(&net);
        for (int k = 0; k < 16; k++) {
            for (int c = 0; c < 3 && net.known[k]; c++) {
                const int at = c == 0 ? k / 4 : c == 1 ? k % 4 : -1;
                net.points[3 * k + c] *= 0.4;
                net.points[3 * k + c] += at >= 0 ? 2.0 * at / 3 - 1 : 0;
            }
        }
        const taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
        if (taut_plateau_make(&problem, NULL, &film, NULL) == TAUT_OK &&
            taut_dirichlet_make(&net.data, NULL, &first, NULL) == TAUT_OK &&
            farthest(film) > 1.02 * farthest(first)) {
            const double scale = DBL_MAX / (1.01 * farthest(first));
            for (int i = 0; i < 48; i++) {
                net.points[i] *= scale;
            }
            refused(&problem, &far);
            seen++;
        }
        taut_model_free(first);
        taut_model_free(film);
        problem_free(&net);
    }
    CHECK(seen == 2, "%d films were too large", seen);
}

/* A layer that no rule sees is no reason to say that the film has no area. */
static void test_weights_apart(void)
{
    const refusal e = {TAUT_NOT_CONVERGED, "/weights", "weights-vary", 1e20, 0x1p43};
    test_problem net = problem_new(basis_uniform(2, 3), basis_uniform(2, 3));
    taut_plateau_problem problem = {.method = TAUT_PLATEAU_FULL};

    for (int k = 0; k < 9; k++) {
        if (k != 4) {
            problem_know(&net, k / 3, k % 3, k / 3, k % 3, 0);
        }
    }
    problem_random_weights(&net, 1);
    net.weights[4] = 1e20;
    problem = film_problem(&net, TAUT_PLATEAU_FULL);
    problem.net.weights = net.weights;
    refused(&problem, &e);
    problem_free(&net);
}

/* A saddle so steep that the net of its least area would fold: at the barrier no step gains, which is no rest. */
static void test_folding(void)
{
    enum { COUNT = 20 };
    test_problem net = problem_new(basis_uniform(3, COUNT), basis_uniform(3, COUNT));
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};

    for (int i = 0; i < COUNT; i++) {
        for (int j = 0; j < COUNT; j++) {
            const double x = greville_uniform(COUNT, i), y = greville_uniform(COUNT, j);
            const double a = 2 * x - 1, b = 2 * y - 1;
            if (i % (COUNT - 1) == 0 || j % (COUNT - 1) == 0) {
                problem_know(&net, i, j, x, y, 2 * (a * a - b * b));
            }
        }
    }
    const taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    const taut_status status = taut_plateau_make(&problem, NULL, &model, &error);
    CHECK(status == TAUT_NOT_CONVERGED && strcmp(error.reason, "folds") == 0, "%d, %s", (int)status,
          error.message);
    taut_model_free(model);
    problem_free(&net);
}

int main(void)
{
    test_numbers();
    test_members();
    test_fits();
    test_range();
    test_weights_apart();
    test_folding();
    return check_failures != 0;
}
