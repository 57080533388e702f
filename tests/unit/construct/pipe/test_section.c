/* test_section.c -- elliptic pipes: joints against elliptic cylinders, volumes against
 * quadrature, the turn of the sections, false claims, refusals. */
#include "certificates.h"
#include "check.h"
#include "pipes.h"

#include "core/constants.h"
#include "core/vec3.h"

#include <string.h>

static taut_pipe_problem random_problem(void)
{
    taut_pipe_problem problem = pipe_random_ends();
    problem.joint = random_int(0, 1) == 0 ? TAUT_PIPE_G1 : TAUT_PIPE_G2;
    problem.section.kind = TAUT_PIPE_ELLIPTIC;
    for (int side = 0; side < 2; side++) {
        taut_pipe_ellipse *const s = &problem.section.ellipses[side];
        s->a = random_in(0.1, 0.4);
        s->b = random_in(0.1, 0.4);
        for (int k = 0; k < 3; k++) {
            s->direction[k] = random_in(-1, 1);
        }
    }
    return problem;
}

/* Points x E_1 + y E_2 of the end ring are on x^2/a^2 + y^2/b^2 = 1, in the plane across the axis,
 * and the normal of the blend is along x/a^2 E_1 + y/b^2 E_2: that of the elliptic cylinder. */
static void test_joints(void)
{
    for (int trial = 0; trial < random_trials(20); trial++) {
        const taut_pipe_problem problem = random_problem();
        taut_model *model = pipe_made(&problem, 1e-4);
        for (int k = 0; k < 50 && model != NULL; k++) {
            const int side = k % 2;
            const taut_pipe_ellipse *s = &problem.section.ellipses[side];
            double d[3][3], t[3], e1[3], e2[3], normal[3], wanted[3] = {0, 0, 0}, apart[3];
            taut_surface_eval(taut_model_surface(model, 0), side, k / 50.0, 1, d[0]);
            for (int i = 0; i < 3; i++) {
                t[i] = problem.axis.ends[side].direction[i] /
                       taut_norm(problem.axis.ends[side].direction);
            }
            memcpy(e1, s->direction, sizeof e1);
            taut_add_scaled(-taut_dot(e1, t), t, e1);
            const double length = taut_norm(e1);
            for (int i = 0; i < 3; i++) {
                e1[i] /= length;
            }
            taut_cross(t, e1, e2);
            taut_difference(d[TAUT_X], problem.axis.ends[side].point, apart);
            const double x = taut_dot(apart, e1), y = taut_dot(apart, e2);
            CHECK_NEAR(x * x / (s->a * s->a) + y * y / (s->b * s->b), 1, 1e-11,
                       "trial %d, end %d: ellipse", trial, side);
            CHECK(fabs(taut_dot(apart, t)) < 1e-14, "trial %d, end %d: plane", trial, side);
            taut_add_scaled(x / (s->a * s->a), e1, wanted);
            taut_add_scaled(y / (s->b * s->b), e2, wanted);
            taut_cross(d[TAUT_XU], d[TAUT_XV], normal);
            taut_cross(normal, wanted, apart);
            CHECK(taut_norm(apart) < 1e-11 * taut_norm(normal) * taut_norm(wanted),
                  "trial %d, end %d: normal", trial, side);
            /* tangent plane of the cylinder: no part of the normal along the axis */
            CHECK(fabs(taut_dot(normal, t)) < 1e-13 * taut_norm(normal), "trial %d, end %d: %g",
                  trial, side, taut_dot(normal, t) / taut_norm(normal));
        }
        taut_model_free(model);
    }
}

static void test_volume(void)
{
    for (int trial = 0; trial < random_trials(3); trial++) {
        taut_pipe_problem problem = random_problem();
        if (trial == 0) { /* pi a b L exactly */
            problem.section.ellipses[1].a = problem.section.ellipses[0].a;
            problem.section.ellipses[1].b = problem.section.ellipses[0].b;
        }
        taut_model *model = pipe_made(&problem, 2e-11);
        taut_certificate *certificate = pipe_proved(model, &problem, 1e-10);
        const double volume = figure_of(certificate, "volume");
        const double ellipses[2] = {
            TAUT_PI * problem.section.ellipses[0].a * problem.section.ellipses[0].b,
            TAUT_PI * problem.section.ellipses[1].a * problem.section.ellipses[1].b};
        double area = 0;
        CHECK_NEAR(pipe_volume(model, &problem, ellipses, &area), volume, 1e-10 * volume,
                   "trial %d", trial);
        CHECK_NEAR(area, figure_of(certificate, "area"), 1e-10 * area, "trial %d: area", trial);
        if (trial == 0) {
            CHECK_NEAR(volume,
                       TAUT_PI * problem.section.ellipses[0].a * problem.section.ellipses[0].b *
                           figure_of(certificate, "length"),
                       1e-13 * volume, "closed form");
        }
        CHECK(fabs(figure_of(certificate, "section_turn")) <= TAUT_PI / 2, "turned the near way");
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

static taut_verdict tube_of(const taut_model *model, const taut_pipe_problem *problem)
{
    taut_certificate *certificate = pipe_proved(model, problem, 1e-6);
    taut_verdict holds = TAUT_UNDECIDED;
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *claim = taut_certificate_claim(certificate, i);
        if (strcmp(claim->claim, "tube") == 0) {
            holds = claim->holds;
        } else {
            CHECK(claim->holds == TAUT_TRUE, "%s: %g, limit %g", claim->claim, claim->residual,
                  claim->limit);
        }
    }
    taut_certificate_free(certificate);
    return holds;
}

/* Proved with the problem and without; not with sections that are turned or flattened a little. The
 * same anywhere in any unit. */
static void test_claims(void)
{
    for (int trial = 0; trial < random_trials(8); trial++) {
        const taut_pipe_problem problem = random_problem();
        taut_pipe_problem other = problem, moved = problem;
        taut_model *model = pipe_made(&problem, 1e-6), *far = NULL;
        CHECK(tube_of(model, &problem) == TAUT_TRUE, "trial %d", trial);
        CHECK(tube_of(model, NULL) == TAUT_TRUE, "trial %d, from the details", trial);
        other.section.ellipses[trial % 2].b *= 1 - 1e-4;
        CHECK(tube_of(model, &other) == TAUT_FALSE, "trial %d, flattened", trial);
        other = problem;
        other.section.ellipses[trial % 2].a = 0.3;
        other.section.ellipses[trial % 2].b = 0.2;
        taut_model *turned = pipe_made(&other, 1e-6);
        other.section.ellipses[trial % 2].direction[trial % 3] += 1e-2;
        CHECK(tube_of(turned, &other) == TAUT_FALSE, "trial %d, turned", trial);
        for (int side = 0; side < 2; side++) {
            moved.section.ellipses[side].a *= 1000;
            moved.section.ellipses[side].b *= 1000;
            moved.axis.ends[side].handle *= 1000;
            for (int k = 0; k < 3; k++) {
                moved.axis.ends[side].point[k] = 1000 * problem.axis.ends[side].point[k] + 1e6;
            }
        }
        far = pipe_made(&moved, 1e-6);
        taut_certificate *near_proof = pipe_proved(model, &problem, 1e-6);
        taut_certificate *far_proof = pipe_proved(far, &moved, 1e-6);
        CHECK_NEAR(figure_of(far_proof, "section_turn"), figure_of(near_proof, "section_turn"),
                   1e-9, "trial %d", trial);
        CHECK_NEAR(figure_of(far_proof, "volume") * 1e-9, figure_of(near_proof, "volume"), 1e-9,
                   "trial %d", trial);
        taut_certificate_free(near_proof);
        taut_certificate_free(far_proof);
        taut_model_free(model);
        taut_model_free(turned);
        taut_model_free(far);
    }
}

static void test_refusals(void)
{
    taut_pipe_problem problem = random_problem(), other = problem;
    memcpy(other.section.ellipses[1].direction, problem.axis.ends[1].direction,
           sizeof other.axis.ends[1].direction);
    pipe_refused(&other, TAUT_NO_SOLUTION, "section-along");
    other = problem;
    other.section.ellipses[0].direction[0] = other.section.ellipses[0].direction[1] = 0;
    other.section.ellipses[0].direction[2] = 0;
    pipe_refused(&other, TAUT_BAD_INPUT, "value");
    other = problem;
    other.section.ellipses[1].b = 0;
    pipe_refused(&other, TAUT_BAD_INPUT, "value");
    other = problem;
    other.section.ellipses[1].a = INFINITY;
    pipe_refused(&other, TAUT_BAD_INPUT, "value");
    other = problem;
    other.section.ellipses[0].a = NAN;
    pipe_refused(&other, TAUT_BAD_INPUT, "value");
    other = problem;
    other.frame = TAUT_PIPE_FRENET;
    pipe_refused(&other, TAUT_NO_SOLUTION, "frenet-undefined");
    other = problem;
    other.section.ellipses[0].a = 50;
    pipe_refused(&other, TAUT_NO_SOLUTION, "self-intersect-local");
}

int main(void)
{
    random_seed(20261123);
    test_joints();
    test_volume();
    test_claims();
    test_refusals();
    return check_failures != 0;
}
