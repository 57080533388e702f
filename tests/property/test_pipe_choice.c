/* test_pipe_choice.c -- shapes that a pipe chooses against a grid over the whole box. */
#include "certificates.h"
#include "check.h"

#include "construct/pipe/bend.h"
#include "core/constants.h"
#include "core/vec3.h"
#include "taut/taut.h"

/* Ends anywhere with any directions. */
static taut_pipe_problem random_ends(void)
{
    taut_pipe_problem problem = {.axis = {.kind = TAUT_PIPE_ENDS}, .section = {.radius = 1e-3}};
    for (int side = 0; side < 2; side++) {
        for (int k = 0; k < 3; k++) {
            problem.axis.ends[side].point[k] = random_in(-1, 1);
            problem.axis.ends[side].direction[k] = random_in(-1, 1);
        }
        problem.axis.ends[side].handle = random_in(0.3, 3);
    }
    return problem;
}

/* A chosen shape is no worse than any of 9^3 places of the box that certainly have room. */
static void test_choice(void)
{
    for (int trial = 0; trial < random_trials(2); trial++) {
        taut_pipe_problem problem = random_ends();
        const int sharpest = trial % 2;
        taut_model *model = NULL;
        taut_certificate *certificate = NULL;
        problem.shape.kind = sharpest ? TAUT_PIPE_LEAST_CURVATURE : TAUT_PIPE_LEAST_BENDING;
        if (taut_pipe_make(&problem, NULL, &model, NULL) != TAUT_OK) {
            continue;
        }
        CHECK(taut_pipe_certify(model, &problem, NULL, &certificate, NULL) == TAUT_OK, "proof");
        for (int k = 0; k < taut_certificate_claim_count(certificate); k++) {
            const taut_claim *claim = taut_certificate_claim(certificate, k);
            CHECK(claim->holds == TAUT_TRUE, "trial %d: %s %g, limit %g, %s", trial, claim->claim,
                  claim->residual, claim->limit, claim->where);
        }
        const double *v = taut_curve_points(taut_model_curve(model, 0));
        const double found = figure_of(certificate, sharpest ? "max_curvature" : "bending");
        double edges[3][3], least = INFINITY;
        for (int i = 0; i < 9; i++) {
            edges[i / 3][i % 3] = v[i + 3] - v[i];
        }
        for (int i = 0; i < 9 * 9 * 9; i++) {
            const double shape[3] = {-2.99 + 3.99 * (i % 9) / 8, -3 + 6.0 * (i / 9 % 9) / 8,
                                     -2.99 + 3.99 * (i / 81) / 8};
            taut_pipe_arc arc;
            taut_pipe_bend bend;
            taut_pipe_arc_quasi((const double(*)[3])edges, shape, &arc);
            taut_pipe_bend_extremes(&arc, 60, &bend);
            taut_pipe_bend_integrals(&arc, 8, &bend);
            if (bend.turning < 0.99 * TAUT_PI && bend.curvature * problem.section.radius < 0.999) {
                least = fmin(least, sharpest ? bend.curvature : bend.bending);
            }
        }
        CHECK(found <= least * (1 + 1e-9), "trial %d: %.12g above %.12g", trial, found, least);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

/* Length times bending with these handles. */
static double fairness(const taut_pipe_problem *problem, const double handles[2])
{
    const double shape[3] = {problem->shape.alpha, problem->shape.beta, problem->shape.gamma};
    double v[4][3], edges[3][3];
    taut_pipe_arc arc;
    taut_pipe_bend bend;
    for (int side = 0; side < 2; side++) {
        const double *const d = problem->axis.ends[side].direction, *const p =
                                                                        problem->axis.ends[side]
                                                                            .point;
        const double step = (side == 0 ? 1 : -1) * handles[side] / taut_norm(d);
        for (int k = 0; k < 3; k++) {
            v[3 * side][k] = p[k];
            v[1 + side][k] = p[k] + step * d[k];
        }
    }
    for (int i = 0; i < 3; i++) {
        taut_difference(v[i + 1], v[i], edges[i]);
    }
    taut_pipe_arc_quasi((const double(*)[3])edges, shape, &arc);
    taut_pipe_bend_integrals(&arc, 64, &bend);
    return bend.length * bend.bending;
}

/* One handle given, either: the other is no worse than any of 200 lengths of the range it is sought
 * in, and the given one stays. */
static void test_one_handle(void)
{
    for (int trial = 0; trial < random_trials(6); trial++) {
        taut_pipe_problem problem = random_ends();
        const int given = trial % 2;
        const double handle = problem.axis.ends[given].handle;
        taut_model *model = NULL;
        double handles[2], found = 0, size = 0;
        problem.axis.ends[1 - given].handle = 0;
        if (taut_pipe_make(&problem, NULL, &model, NULL) != TAUT_OK) {
            continue;
        }
        const double *const v = taut_curve_points(taut_model_curve(model, 0));
        handles[0] = taut_distance(v + 3, v);
        handles[1] = taut_distance(v + 9, v + 6);
        CHECK_NEAR(handles[given], handle, 1e-14, "trial %d", trial);
        found = fairness(&problem, handles);
        size = taut_distance(problem.axis.ends[0].point, problem.axis.ends[1].point);
        for (int i = 0; i < 200; i++) {
            handles[1 - given] = size / 64 * pow(256, (i + 0.5) / 200);
            CHECK(fairness(&problem, handles) >= found * (1 - 1e-6), "trial %d: %g, found %g",
                  trial, fairness(&problem, handles), found);
        }
        taut_model_free(model);
    }
}

int main(void)
{
    random_seed(20261123);
    test_choice();
    test_one_handle();
    return check_failures != 0;
}
