/* test_canal.c -- pipes of unlike radii: the canal surface against its spheres, areas and
 * volumes against quadrature, the naive sweep, false claims, refusals. */
#include "certificates.h"
#include "check.h"
#include "pipes.h"

#include "core/constants.h"
#include "core/vec3.h"

#include <string.h>

static taut_pipe_problem random_problem(void)
{
    taut_pipe_problem problem = pipe_random_ends();
    problem.section.kind = TAUT_PIPE_CANAL;
    problem.section.radii[0] = random_in(0.1, 0.5);
    problem.section.radii[1] = random_in(0.1, 0.5);
    return problem;
}

/* At u = t the point is at r(t) from P(t), and the normal of the surface is the sphere's: what
 * tells a canal surface from a sweep. At the joints both are the cylinder's to 1e-13. */
static void test_spheres(void)
{
    for (int trial = 0; trial < random_trials(10); trial++) {
        const taut_pipe_problem problem = random_problem();
        const double *const radii = problem.section.radii;
        const int ends =
            trial % 2; /* of few segments: rounding counts over the first ring's distance */
        taut_model *model = pipe_made(&problem, ends ? 1e-3 : 1e-8);
        for (int k = 0; k <= 60 && model != NULL; k += ends ? 60 : 1) {
            const double t = k / 60.0, end = ends ? 1e-13 : 1e-6;
            const double r = radii[0] + (radii[1] - radii[0]) * t * t * (3 - 2 * t);
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

static void test_measures(void)
{
    for (int trial = 0; trial < random_trials(3); trial++) {
        taut_pipe_problem problem = random_problem();
        problem.section.kind = trial == 2 ? TAUT_PIPE_NAIVE_SWEEP : TAUT_PIPE_CANAL;
        taut_model *model = pipe_made(&problem, 2e-11);
        taut_certificate *certificate = pipe_proved(model, &problem, 1e-10);
        const double discs[2] = {TAUT_PI * problem.section.radii[0] * problem.section.radii[0],
                                 TAUT_PI * problem.section.radii[1] * problem.section.radii[1]};
        double area = 0;
        const double volume = pipe_volume(model, &problem, discs, &area);
        CHECK_NEAR(volume, figure_of(certificate, "volume"), 1e-10 * volume, "trial %d", trial);
        CHECK_NEAR(area, figure_of(certificate, "area"), 1e-10 * area, "trial %d", trial);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

/* A canal surface is no naive sweep, nor the other way round; another radius is another surface. */
static void test_claims(void)
{
    static const char *const names[] = {"joint1", "joint2",  "embedded", "tube",
                                        "ends",   "regular", "graph"};
    for (int trial = 0; trial < random_trials(6); trial++) {
        taut_pipe_problem problem = random_problem(), naive, other;
        problem.section.radii[0] = 0.5;
        problem.section.radii[1] = random_in(0.1, 0.3);
        naive = other = problem;
        naive.section.kind = TAUT_PIPE_NAIVE_SWEEP;
        other.section.radii[trial % 2] *= 1 - 1e-5;
        taut_model *canal = pipe_made(&problem, 1e-6), *sweep = pipe_made(&naive, 1e-6);
        for (size_t k = 0; k < sizeof names / sizeof names[0]; k++) {
            CHECK(pipe_verdict(canal, &problem, names[k]) == TAUT_TRUE, "trial %d: %s", trial,
                  names[k]);
        }
        CHECK(pipe_verdict(canal, NULL, "tube") == TAUT_TRUE, "trial %d, from the details", trial);
        CHECK(pipe_verdict(sweep, &naive, "tube") == TAUT_TRUE, "trial %d, naive", trial);
        CHECK(pipe_verdict(sweep, NULL, "tube") == TAUT_TRUE, "trial %d, naive details", trial);
        CHECK(pipe_verdict(sweep, &problem, "tube") == TAUT_FALSE, "trial %d: no canal", trial);
        CHECK(pipe_verdict(canal, &naive, "tube") == TAUT_FALSE, "trial %d: no sweep", trial);
        CHECK(pipe_verdict(canal, &other, "tube") == TAUT_FALSE, "trial %d: other radius", trial);
        taut_model_free(canal);
        taut_model_free(sweep);
    }
}

/* In other units and far from the origin: the same claims, and figures in those units. */
static void test_scale_and_shift(void)
{
    static const double moves[][2] = {{1e-3, 0}, {1e3, 0}, {1, 1e5}, {1e-60, 0}, {1e60, 0}};
    static const char *const claims[] = {"embedded", "tube", "regular", "graph"};
    for (int trial = 0; trial < random_trials(4); trial++) {
        const taut_pipe_problem problem = random_problem();
        taut_model *model = pipe_made(&problem, 1e-6);
        taut_certificate *here = pipe_proved(model, &problem, 1e-6);
        const double area = figure_of(here, "area"), volume = figure_of(here, "volume");
        for (size_t i = 0; i < sizeof moves / sizeof moves[0]; i++) {
            const double scale = moves[i][0];
            taut_pipe_problem other = problem;
            for (int side = 0; side < 2; side++) {
                other.section.radii[side] *= scale;
                other.axis.ends[side].handle *= scale;
                for (int k = 0; k < 3; k++) {
                    other.axis.ends[side].point[k] =
                        scale * problem.axis.ends[side].point[k] + moves[i][1];
                }
            }
            taut_model *moved = pipe_made(&other, 1e-6);
            taut_certificate *there = pipe_proved(moved, &other, 1e-6);
            for (size_t k = 0; k < sizeof claims / sizeof claims[0]; k++) {
                const taut_claim *a = claim_of(here, claims[k]), *b = claim_of(there, claims[k]);
                CHECK(a->holds == TAUT_TRUE && b->holds == TAUT_TRUE, "trial %d, move %zu: %s",
                      trial, i, claims[k]);
                /* the least of the same places, moved by 1e5 roundings of the axis: 1e-11 */
                CHECK_NEAR(b->residual, a->residual, 1e-8, "trial %d, move %zu: %s", trial, i,
                           claims[k]);
            }
            CHECK_NEAR(figure_of(there, "area") / scale / scale, area, 1e-10 * area,
                       "trial %d, move %zu", trial, i);
            CHECK_NEAR(figure_of(there, "volume") / scale / scale / scale, volume, 1e-10 * volume,
                       "trial %d, move %zu", trial, i);
            taut_certificate_free(there);
            taut_model_free(moved);
        }
        taut_certificate_free(here);
        taut_model_free(model);
    }
}

static void test_refusals(void)
{
    taut_pipe_problem line = {
        .axis = {.kind = TAUT_PIPE_ENDS,
                 .ends = {{{0, 0, 0}, {1, 0, 0}, 1}, {{3, 0, 0}, {1, 0, 0}, 1}}},
        .section = {.kind = TAUT_PIPE_CANAL, .radii = {2.5, 0.1}}};
    taut_pipe_problem other = random_problem();
    pipe_refused(&line, TAUT_NO_SOLUTION, "canal-not-real"); /* r_s = 1.5 * 2.4 / 3 in the middle */
    line.section.radii[0] = 3;
    line.section.radii[1] = 1.3;
    pipe_refused(&line, TAUT_NO_SOLUTION, "canal-not-regular");
    other.joint = TAUT_PIPE_G2;
    pipe_refused(&other, TAUT_NO_SOLUTION, "canal-joint");
    other = random_problem();
    other.frame = TAUT_PIPE_FRENET;
    pipe_refused(&other, TAUT_NO_SOLUTION, "frenet-undefined");
    other = random_problem();
    other.section.radii[1] = -1;
    pipe_refused(&other, TAUT_BAD_INPUT, "value");
    other.section.radii[1] = NAN;
    pipe_refused(&other, TAUT_BAD_INPUT, "value");
}

int main(void)
{
    random_seed(20261124);
    test_spheres();
    test_measures();
    test_claims();
    test_scale_and_shift();
    test_refusals();
    return check_failures != 0;
}
