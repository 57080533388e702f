/* test_pipe_choice.c -- shapes that a pipe chooses against a grid over the whole box. */
#include "check.h"

#include "construct/pipe/bend.h"
#include "taut/taut.h"

static const double pi = 3.14159265358979323846;

static double figure(const taut_certificate *certificate, const char *name)
{
    return taut_record_number(taut_record_get(taut_certificate_figures(certificate), name));
}

/* Ends anywhere with any directions. */
static taut_pipe_problem random_ends(void)
{
    taut_pipe_problem problem = {.radius = 1e-3, .axis = TAUT_PIPE_ENDS};
    for (int side = 0; side < 2; side++) {
        for (int k = 0; k < 3; k++) {
            problem.ends[side].point[k] = random_in(-1, 1);
            problem.ends[side].direction[k] = random_in(-1, 1);
        }
        problem.ends[side].handle = random_in(0.3, 3);
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
        problem.shape = sharpest ? TAUT_PIPE_LEAST_CURVATURE : TAUT_PIPE_LEAST_BENDING;
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
        const double found = figure(certificate, sharpest ? "max_curvature" : "bending");
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
            if (bend.turning < 0.99 * pi && bend.curvature * problem.radius < 0.999) {
                least = fmin(least, sharpest ? bend.curvature : bend.bending);
            }
        }
        CHECK(found <= least * (1 + 1e-9), "trial %d: %.12g above %.12g", trial, found, least);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

int main(void)
{
    random_seed(20261123);
    test_choice();
    return check_failures != 0;
}
