/* test_g2.c -- joints of equal curvature: the quintic against its points, the second forms of
 * the surfaces at the joints against those of cylinders, refusals. */
#include "certificates.h"
#include "check.h"
#include "edit.h"
#include "pipes.h"

#include "construct/pipe/arc.h"
#include "core/vec3.h"
#include "taut/taut.h"

#include <stdlib.h>
#include <string.h>

static taut_pipe_problem random_problem(void)
{
    taut_pipe_problem problem = pipe_random_ends();
    problem.section.radius = 0.5;
    problem.shape.alpha = random_in(-2, 1);
    problem.shape.gamma = random_in(-2, 1);
    problem.joint = TAUT_PIPE_G2;
    return problem;
}

/* P' x P'' of the quintic, in products of the edges, against the one from the points; exactly 0 at
 * the ends, and so is T'. */
static void test_arc(void)
{
    for (int trial = 0; trial < random_trials(300); trial++) {
        const double shape[3] = {random_in(-2.9, 1), 0, random_in(-2.9, 1)};
        double edges[3][3];
        taut_pipe_arc arc, plain;
        taut_pipe_jet jet, near[2];
        for (int i = 0; i < 9; i++) {
            edges[i / 3][i % 3] = random_in(-1, 1);
        }
        taut_pipe_arc_quintic((const double(*)[3])edges, shape, &arc);
        plain = arc;
        taut_pipe_arc_finish(&plain);
        for (int i = 0; i <= 6; i++) {
            CHECK(taut_distance(arc.cross[i], plain.cross[i]) < 1e-12, "trial %d: %d", trial, i);
        }
        for (int i = 0; i <= 4; i++) {
            CHECK(taut_distance(arc.velocity[i], plain.velocity[i]) < 2e-14, "trial %d: %d", trial,
                  i);
        }
        for (int end = 0; end < 2; end++) {
            taut_pipe_arc_jet(&arc, end, &jet);
            CHECK(jet.curvature == 0, "trial %d: %g at end %d", trial, jet.curvature, end);
        }
        /* T'' against differences of T' */
        const double t = random_in(0.1, 0.9), h = 1e-5;
        taut_pipe_arc_jet(&arc, t, &jet);
        taut_pipe_arc_jet(&arc, t - h, &near[0]);
        taut_pipe_arc_jet(&arc, t + h, &near[1]);
        for (int k = 0; k < 3 && jet.speed > 1; k++) {
            CHECK_NEAR(jet.bent[k], (near[1].turn[k] - near[0].turn[k]) / (2 * h), 2e-5,
                       "trial %d, coordinate %d", trial, k);
        }
    }
}

/* On the ring of a joint the normal is radial, and with it
 *     n . x_uu = 0,   n . x_uv = 0,   n . x_vv = -|x_v|^2 / a
 * as on a cylinder: over |x_u|^2, |x_u||x_v|, |x_v|^2 and 1 / a to 1e-13. */
static void test_second_forms(void)
{
    double worst = 0;
    for (int trial = 0; trial < random_trials(30); trial++) {
        const taut_pipe_problem problem = random_problem();
        const taut_make_options coarse = {
            .tolerance = 1e-2}; /* long legs: rounding counts by their squares */
        taut_model *model = NULL;
        taut_error error = {.message = ""};
        CHECK(taut_pipe_make(&problem, &coarse, &model, &error) == TAUT_OK, "trial %d: %s", trial,
              error.message);
        if (model == NULL) {
            continue;
        }
        for (int k = 0; k < 34; k++) {
            const int side = k % 2;
            double d[6][3], n[3];
            taut_surface_eval(taut_model_surface(model, 0), side, k / 34.0, 2, d[0]);
            taut_difference(d[TAUT_X], problem.axis.ends[side].point, n);
            const double u = taut_norm(d[TAUT_XU]), v = taut_norm(d[TAUT_XV]);
            const double a = problem.section.radius; /* n is a times the normal */
            CHECK_NEAR(taut_norm(n), a, 1e-14, "trial %d: ring", trial);
            worst = fmax(worst, fabs(taut_dot(n, d[TAUT_XUU])) / (u * u));
            worst = fmax(worst, fabs(taut_dot(n, d[TAUT_XUV])) / (u * v));
            worst = fmax(worst, fabs(taut_dot(n, d[TAUT_XVV]) / (v * v) + 1));
        }
        taut_model_free(model);
    }
    CHECK(worst < 1e-13, "second forms differ by %g", worst);
}

/* The certificate says so, and says it of no quartic; it sees a ring that is out of place by less
 * than tangent planes tell. */
static void test_claims(void)
{
    static const char *const names[2] = {"curvature1", "curvature2"};
    for (int trial = 0; trial < random_trials(12); trial++) {
        taut_pipe_problem problem = random_problem();
        taut_model *model = NULL;
        taut_certificate *certificate = NULL;
        int seen = 0;
        problem.shape.kind = trial == 0 ? TAUT_PIPE_LEAST_BENDING : TAUT_PIPE_SHAPE_GIVEN;
        problem.shape.alpha = trial == 0 ? 0 : problem.shape.alpha;
        CHECK(taut_pipe_make(&problem, NULL, &model, NULL) == TAUT_OK, "made");
        CHECK(taut_pipe_certify(model, &problem, NULL, &certificate, NULL) == TAUT_OK, "proved");
        for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
            const taut_claim *claim = taut_certificate_claim(certificate, i);
            CHECK(claim->holds == TAUT_TRUE, "trial %d: %s %g, limit %g", trial, claim->claim,
                  claim->residual, claim->limit);
            seen += strcmp(claim->claim, names[0]) == 0 || strcmp(claim->claim, names[1]) == 0;
        }
        CHECK(seen == 2, "trial %d: %d claims of curvature", trial, seen);
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

/* A point of the third ring moved outwards, a quarter farther each time as long as the claim holds: what
 * is proved, of all of the ring, is more than what is seen of it, and gives up first. */
static void test_bound(void)
{
    static edit_model edit;
    const taut_pipe_problem problem = {
        .axis = {.kind = TAUT_PIPE_ENDS,
                 .ends = {{{0, 0, 0}, {1, 0, 0}, 2}, {{5, 4, 0}, {0, 1, 0}, 2}}},
        .section = {.kind = TAUT_PIPE_ROUND, .radius = 0.5},
        .joint = TAUT_PIPE_G2};
    taut_model *model = pipe_made(&problem, 1e-6);
    forge_pool pool = {malloc((size_t)1 << 20), (size_t)1 << 20, 0};
    int holds = 1, seen_only = 0;
    for (double move = 1e-18; move < 1e-3 && holds; move *= 1.25) {
        taut_certificate *certificate = NULL;
        pool.used = 0;
        edit_open(model, "pipe", &pool, &edit);
        for (int i = 0; i < edit.surfaces; i++) {
            edit_surface *const s = &edit.surface[i];
            if (strcmp(s->name, "blend") == 0) {
                s->points[3 * (2 * s->nv + 1) + 1] += move;
                s->points[3 * (2 * s->nv + 1) + 2] += move;
            }
        }
        taut_model *moved = edit_close(&edit);
        CHECK(taut_pipe_certify(moved, &problem, NULL, &certificate, NULL) == TAUT_OK, "%g", move);
        const taut_claim *claim = claim_of(certificate, "curvature1");
        holds = claim->holds == TAUT_TRUE;
        if (move == 1e-18) {
            CHECK(holds && claim->kind == TAUT_BOUND, "proved");
        }
        seen_only += holds && claim->kind == TAUT_CHECK;
        taut_certificate_free(certificate);
        taut_model_free(moved);
    }
    CHECK(!holds && seen_only > 0, "it is proved up to the limit");
    free(pool.bytes);
    taut_model_free(model);
}

/* A quintic made where a quartic was asked for is not what was asked for; a blend with its third
 * ring moved is not of equal curvature. */
static void test_false_claims(void)
{
    taut_pipe_problem problem = random_problem();
    taut_model *model = NULL, *moved = NULL;
    taut_certificate *certificate = NULL;
    double points[9 * 400];
    CHECK(taut_pipe_make(&problem, NULL, &model, NULL) == TAUT_OK &&
              taut_model_new(&moved) == TAUT_OK,
          "made");
    for (int i = 0; i < 3; i++) {
        const taut_surface *s = taut_model_surface(model, i);
        const int count = taut_basis_count(taut_surface_u(s)) * taut_basis_count(taut_surface_v(s));
        taut_surface *copy = NULL;
        memcpy(points, taut_surface_points(s), 3 * (size_t)count * sizeof *points);
        for (int k = 0; k < 3; k++) {
            points[2 * 27 + 6 + k] += i == 0 ? 1e-8 : 0;
        }
        CHECK(3 * count <= 9 * 400 &&
                  taut_surface_new(taut_surface_name(s), taut_surface_u(s), taut_surface_v(s),
                                   points, taut_surface_weights(s), &copy, NULL) == TAUT_OK &&
                  taut_model_add_surface(moved, copy) == TAUT_OK,
              "copied");
    }
    taut_curve *axis = NULL;
    CHECK(taut_curve_copy(taut_model_curve(model, 0), &axis) == TAUT_OK &&
              taut_model_add_curve(moved, axis) == TAUT_OK,
          "copied");
    problem.joint = TAUT_PIPE_G1;
    CHECK(taut_pipe_certify(moved, &problem, NULL, &certificate, NULL) == TAUT_OK, "proved");
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *claim = taut_certificate_claim(certificate, i);
        const int wrong = strcmp(claim->claim, "curvature1") == 0 ||
                          strcmp(claim->claim, "ends") == 0 ||
                          strcmp(claim->claim, "identity") == 0; /* a quintic axis */
        CHECK(claim->holds == (wrong ? TAUT_FALSE : TAUT_TRUE), "%s: %g", claim->claim,
              claim->residual);
    }
    taut_certificate_free(certificate);
    taut_model_free(model);
    taut_model_free(moved);
}

static void test_refusals(void)
{
    taut_pipe_problem problem = random_problem();
    taut_model *model = NULL;
    taut_error error = {.message = ""};
    problem.shape.beta = 1;
    CHECK(taut_pipe_make(&problem, NULL, &model, &error) == TAUT_NO_SOLUTION &&
              strcmp(error.reason, "parameter-domain") == 0,
          "%s", error.message);
    problem.shape.beta = 0;
    problem.frame = TAUT_PIPE_FRENET;
    CHECK(taut_pipe_make(&problem, NULL, &model, &error) == TAUT_NO_SOLUTION &&
              strcmp(error.reason, "frenet-undefined") == 0,
          "%s", error.message);
    problem.frame = TAUT_PIPE_ROTATION_MINIMIZING;
    problem.shape.alpha = -3;
    CHECK(taut_pipe_make(&problem, NULL, &model, &error) == TAUT_NO_SOLUTION &&
              strcmp(error.reason, "tangent-lost") == 0,
          "%s", error.message);
    CHECK(model == NULL, "untouched");
}

int main(void)
{
    test_arc();
    test_second_forms();
    test_claims();
    test_false_claims();
    test_refusals();
    test_bound();
    return check_failures != 0;
}
