/* test_pipe_canal.c -- pipes of unlike radii: the canal surface against its spheres, areas and
 * volumes against quadrature, the naive sweep, false claims, refusals. */
#include "check.h"

#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "taut/taut.h"

#include <string.h>

static const double pi = 3.14159265358979323846;

static double figure(const taut_certificate *certificate, const char *name)
{
    return taut_record_number(taut_record_get(taut_certificate_figures(certificate), name));
}

static taut_pipe_problem random_problem(void)
{
    taut_pipe_problem problem = {
        .axis = TAUT_PIPE_ENDS,
        .ends = {{{random_in(-1, 1), random_in(-1, 1), random_in(-1, 1)},
                  {random_in(-1, 1), random_in(-1, 1), 2},
                  random_in(2, 3)},
                 {{random_in(4, 5), random_in(-1, 1), random_in(5, 6)},
                  {random_in(1, 2), random_in(-1, 1), random_in(-1, 1)},
                  random_in(2, 3)}},
        .alpha = random_in(-1, 1),
        .gamma = random_in(-1, 1),
        .radii = {random_in(0.1, 0.5), random_in(0.1, 0.5)},
    };
    return problem;
}

static taut_model *made(const taut_pipe_problem *problem, double tolerance)
{
    const taut_make_options options = {.tolerance = tolerance};
    taut_error error = {.message = ""};
    taut_model *model = NULL;
    CHECK(taut_pipe_make(problem, &options, &model, &error) == TAUT_OK, "%s %s", error.where,
          error.message);
    return model;
}

static taut_certificate *proved(const taut_model *model, const taut_pipe_problem *problem,
                                double tolerance)
{
    const taut_certify_options options = {.tolerance = tolerance};
    taut_certificate *certificate = NULL;
    CHECK(taut_pipe_certify(model, problem, &options, &certificate, NULL) == TAUT_OK, "proved");
    return certificate;
}

/* At u = t the point is at r(t) from P(t), and the normal of the surface is the sphere's: what
 * tells a canal surface from a sweep. At the joints both are the cylinder's to 1e-13. */
static void test_spheres(void)
{
    for (int trial = 0; trial < random_trials(10); trial++) {
        const taut_pipe_problem problem = random_problem();
        const int ends =
            trial % 2; /* of few segments: rounding counts over the first ring's distance */
        taut_model *model = made(&problem, ends ? 1e-3 : 1e-8);
        for (int k = 0; k <= 60 && model != NULL; k += ends ? 60 : 1) {
            const double t = k / 60.0, end = ends ? 1e-13 : 1e-6;
            const double r =
                problem.radii[0] + (problem.radii[1] - problem.radii[0]) * t * t * (3 - 2 * t);
            double d[3][3], x[3], normal[3], radial[3], across[3];
            taut_surface_eval(taut_model_surface(model, 0), t, random_in(0, 1), 1, d[0]);
            taut_curve_eval(taut_model_curve(model, 0), t, 0, x);
            taut_difference(d[TAUT_X], x, radial);
            taut_cross(d[TAUT_XU], d[TAUT_XV], normal);
            taut_cross(normal, radial, across);
            CHECK_NEAR(taut_norm(radial), r, fmin(end, 1e-8), "trial %d, t = %g", trial, t);
            CHECK(taut_norm(across) < end * taut_norm(normal) * r, "trial %d, t = %g: %g", trial, t,
                  taut_norm(across) / taut_norm(normal) / r);
        }
        taut_model_free(model);
    }
}

/* The integrals of 1 and X . n / 3 over the blend, and over the discs at its ends. */
static double volume_of(const taut_model *model, const taut_pipe_problem *problem, double *area)
{
    enum { G = 8 };
    const taut_surface *surface = taut_model_surface(model, 0);
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    double nodes[G], weights[G], volume = 0;
    taut_gauss_rule(G, nodes, weights);
    *area = 0;
    for (int i = 0; i < taut_basis_span_count(u) * taut_basis_span_count(v); i++) {
        const double *bu = taut_basis_breaks(u) + i / taut_basis_span_count(v);
        const double *bv = taut_basis_breaks(v) + i % taut_basis_span_count(v);
        for (int k = 0; k < G * G; k++) {
            const double w =
                0.25 * (bu[1] - bu[0]) * (bv[1] - bv[0]) * weights[k / G] * weights[k % G];
            double x[3][3], normal[3];
            taut_surface_eval(surface, bu[0] + (bu[1] - bu[0]) * 0.5 * (1 + nodes[k / G]),
                              bv[0] + (bv[1] - bv[0]) * 0.5 * (1 + nodes[k % G]), 1, x[0]);
            taut_cross(x[TAUT_XU], x[TAUT_XV], normal);
            volume -= w * taut_dot(x[0], normal) / 3;
            *area += w * taut_norm(normal);
        }
    }
    for (int side = 0; side < 2; side++) {
        const taut_pipe_end *end = &problem->ends[side];
        volume += (side == 0 ? -1 : 1) * taut_dot(end->point, end->direction) /
                  taut_norm(end->direction) * pi * problem->radii[side] * problem->radii[side] / 3;
    }
    return volume;
}

static void test_measures(void)
{
    for (int trial = 0; trial < random_trials(3); trial++) {
        taut_pipe_problem problem = random_problem();
        problem.naive = trial == 2;
        taut_model *model = made(&problem, 2e-11);
        taut_certificate *certificate = proved(model, &problem, 1e-10);
        double area = 0;
        const double volume = volume_of(model, &problem, &area);
        CHECK_NEAR(volume, figure(certificate, "volume"), 1e-10 * volume, "trial %d", trial);
        if (trial < 2) {
            CHECK_NEAR(area, figure(certificate, "area"), 1e-10 * area, "trial %d", trial);
        }
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

static taut_verdict verdict(const taut_model *model, const taut_pipe_problem *problem,
                            const char *name)
{
    taut_certificate *certificate = proved(model, problem, 1e-6);
    taut_verdict holds = TAUT_UNDECIDED;
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *claim = taut_certificate_claim(certificate, i);
        if (strcmp(claim->claim, name) == 0) {
            holds = claim->holds;
        }
    }
    taut_certificate_free(certificate);
    return holds;
}

/* A canal surface is no naive sweep, nor the other way round; another radius is another surface. */
static void test_claims(void)
{
    static const char *const names[] = {"joint1", "joint2",  "embedded", "tube",
                                        "ends",   "regular", "graph"};
    for (int trial = 0; trial < random_trials(6); trial++) {
        taut_pipe_problem problem = random_problem(), naive, other;
        problem.radii[0] = 0.5;
        problem.radii[1] = random_in(0.1, 0.3);
        naive = other = problem;
        naive.naive = 1;
        other.radii[trial % 2] *= 1 - 1e-5;
        taut_model *canal = made(&problem, 1e-6), *sweep = made(&naive, 1e-6);
        for (size_t k = 0; k < sizeof names / sizeof names[0]; k++) {
            CHECK(verdict(canal, &problem, names[k]) == TAUT_TRUE, "trial %d: %s", trial, names[k]);
        }
        CHECK(verdict(canal, NULL, "tube") == TAUT_TRUE, "trial %d, from the details", trial);
        CHECK(verdict(sweep, &naive, "tube") == TAUT_TRUE, "trial %d, naive", trial);
        CHECK(verdict(sweep, NULL, "tube") == TAUT_TRUE, "trial %d, naive details", trial);
        CHECK(verdict(sweep, &problem, "tube") == TAUT_FALSE, "trial %d: no canal", trial);
        CHECK(verdict(canal, &naive, "tube") == TAUT_FALSE, "trial %d: no sweep", trial);
        CHECK(verdict(canal, &other, "tube") == TAUT_FALSE, "trial %d: other radius", trial);
        taut_model_free(canal);
        taut_model_free(sweep);
    }
}

static void refused(const taut_pipe_problem *problem, taut_status status, const char *words)
{
    taut_error error = {.message = ""};
    taut_model *model = NULL;
    CHECK(taut_pipe_make(problem, NULL, &model, &error) == status &&
              strstr(error.message, words) != NULL && model == NULL,
          "%s: %s", words, error.message);
}

static void test_refusals(void)
{
    taut_pipe_problem line = {.axis = TAUT_PIPE_ENDS,
                              .ends = {{{0, 0, 0}, {1, 0, 0}, 1}, {{3, 0, 0}, {1, 0, 0}, 1}},
                              .radii = {2.5, 0.1}};
    taut_pipe_problem other = random_problem();
    refused(&line, TAUT_NO_SOLUTION, "CANAL_NOT_REAL"); /* r_s = 1.5 * 2.4 / 3 in the middle */
    line.radii[0] = 3;
    line.radii[1] = 1.3;
    refused(&line, TAUT_NO_SOLUTION, "CANAL_NOT_REGULAR");
    other.joint = TAUT_PIPE_CURVATURE_JOINT;
    refused(&other, TAUT_NO_SOLUTION, "CANAL_JOINT");
    other = random_problem();
    other.frame = TAUT_PIPE_FRENET;
    refused(&other, TAUT_NO_SOLUTION, "FRENET_UNDEFINED");
    other = random_problem();
    other.radii[1] = -1;
    refused(&other, TAUT_BAD_INPUT, "positive length");
    other.radii[1] = NAN;
    refused(&other, TAUT_BAD_INPUT, "positive length");
    other = random_problem();
    other.sections[0].a = 1;
    refused(&other, TAUT_BAD_INPUT, "one of them");
}

int main(void)
{
    random_seed(20261124);
    test_spheres();
    test_measures();
    test_claims();
    test_refusals();
    return check_failures != 0;
}
