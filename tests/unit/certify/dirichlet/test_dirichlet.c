/* test_dirichlet.c -- what the certificate of a Dirichlet surface accepts, and what it must not. */
#include "certificates.h"
#include "check.h"
#include "core/constants.h"
#include "problems.h"

#include "certify/common/verdict.h"
#include "certify/dirichlet/gradient.h"
#include "taut/measure.h"

#include <stdlib.h>
#include <string.h>

static taut_certificate *certify(const taut_model *model, const test_problem *problem)
{
    taut_certificate *certificate = NULL;
    taut_error error = {0};
    CHECK(taut_dirichlet_certify(model, problem != NULL ? &problem->data : NULL, NULL, &certificate,
                                 &error) == TAUT_OK,
          "%s: %s", error.where, error.message);
    return certificate;
}

/* A model of the same surface with other points, and the details of the first. */
static taut_model *with_points(const taut_model *model, const double *points)
{
    const taut_surface *from = taut_model_surface(model, 0);
    taut_surface *surface = NULL;
    taut_model *made = NULL;
    CHECK(taut_surface_new("", taut_surface_u(from), taut_surface_v(from), points,
                           taut_surface_weights(from), &surface, NULL) == TAUT_OK,
          "surface");
    CHECK(taut_model_new(&made) == TAUT_OK && taut_model_add_surface(made, surface) == TAUT_OK,
          "model");
    taut_model_set_details(made, taut_record_copy(taut_model_details(model)));
    return made;
}

/* The model with `by` added to coordinate c of point i. */
static taut_model *perturbed(const taut_model *model, size_t i, size_t c, double by)
{
    const taut_surface *from = taut_model_surface(model, 0);
    const size_t count = (size_t)taut_basis_count(taut_surface_u(from)) *
                         (size_t)taut_basis_count(taut_surface_v(from));
    double *points = malloc(3 * count * sizeof(double));
    taut_model *made = NULL;
    memcpy(points, taut_surface_points(from), 3 * count * sizeof(double));
    points[3 * i + c] += by;
    made = with_points(model, points);
    free(points);
    return made;
}

/* The worked examples hold, with limits at most 100 times what was seen and never above 1e-6. */
static void test_examples(void)
{
    for (int number = 1; number <= 4; number++) {
        test_problem problem = problem_example(number);
        taut_model *model = problem_make(&problem, NULL);
        taut_certificate *certificate = certify(model, &problem);
        const taut_claim *stationary = claim_of(certificate, "stationary");
        CHECK(taut_certificate_holds(certificate) == TAUT_TRUE, "example %d", number);
        CHECK(stationary->residual <= stationary->limit, "example %d", number);
        CHECK(stationary->limit <= 100 * stationary->residual && stationary->limit <= 1e-6,
              "example %d: residual %g, limit %g", number, stationary->residual, stationary->limit);
        taut_certificate_free(certificate);
        taut_model_free(model);
        problem_free(&problem);
    }
}

/* An unknown point moved until the residual is ten times the limit: D is quadratic, so the residual
 * is linear in the move. It must fail, and name that point or one its functions reach. */
static void check_perturbed(const test_problem *problem)
{
    taut_model *model = problem_make(problem, NULL), *moved = NULL;
    taut_certificate *certificate = NULL;
    const int count = taut_basis_count(problem->u) * taut_basis_count(problem->v);
    const double probe = 1e-3;
    double slope = 0, limit = 0;
    int at = random_int(0, count - 1);
    const size_t c = (size_t)random_int(0, 2);

    while (problem->known[at]) {
        at = (at + 1) % count;
    }
    moved = perturbed(model, (size_t)at, c, probe);
    certificate = certify(moved, problem);
    slope = claim_of(certificate, "stationary")->residual / probe;
    limit = claim_of(certificate, "stationary")->limit;
    CHECK(taut_certificate_holds(certificate) == TAUT_FALSE, "moved by %g", probe);
    taut_certificate_free(certificate);
    taut_model_free(moved);
    moved = perturbed(model, (size_t)at, c, 10 * limit / slope);
    certificate = certify(moved, problem);
    CHECK(claim_of(certificate, "stationary")->holds == TAUT_FALSE, "residual %g, limit %g",
          claim_of(certificate, "stationary")->residual,
          claim_of(certificate, "stationary")->limit);
    CHECK(claim_of(certificate, "known")->holds == TAUT_TRUE, "the known points are still there");
    taut_certificate_free(certificate);
    taut_model_free(moved);
    taut_model_free(model);
}

static void test_perturbed(void)
{
    for (int trial = 0; trial < 16; trial++) {
        test_problem problem = trial < 4 ? problem_example(trial + 1)
                                         : problem_new(basis_uniform(random_int(2, 5), 7),
                                                       basis_uniform(random_int(2, 5), 8));
        if (trial >= 4) {
            problem_random_boundary(&problem);
        }
        if (trial >= 12) {
            problem_random_weights(&problem, 2);
        }
        if (trial >= 8) {
            problem.data.aspect = random_log(0.3, 3);
        }
        check_perturbed(&problem);
        problem_free(&problem);
    }
}

/* A known point moved by one unit in the last place, a weight, a knot: each is found. */
static void test_known(void)
{
    test_problem problem = problem_example(4), other;
    taut_model *model = problem_make(&problem, NULL), *moved = NULL;
    taut_certificate *certificate = NULL;
    double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    taut_basis_spec spec = {.type = "bspline", .degree = 3, .knot_count = 8, .knots = knots};
    taut_basis *u = NULL;

    moved = perturbed(model, 2, 2, 0x1p-52); /* z = 1 */
    certificate = certify(moved, &problem);
    CHECK(claim_of(certificate, "known")->holds == TAUT_FALSE, "a known point");
    CHECK(strcmp(claim_of(certificate, "known")->where, "/surfaces/0/points/0/2") == 0, "where %s",
          claim_of(certificate, "known")->where);
    taut_certificate_free(certificate);
    taut_model_free(moved);

    knots[4] = knots[5] = knots[6] = knots[7] = 1 + 0x1p-52;
    CHECK(taut_basis_new(&spec, 4, &u, NULL) == TAUT_OK, "knots");
    other = problem;
    other.data.u = u;
    certificate = certify(model, &other);
    CHECK(claim_of(certificate, "known")->holds == TAUT_FALSE, "a knot");
    taut_certificate_free(certificate);
    taut_basis_free(u);

    other = problem;
    problem_random_weights(&other, 1.5);
    certificate = certify(model, &other);
    CHECK(claim_of(certificate, "known")->holds == TAUT_FALSE, "weights");
    taut_certificate_free(certificate);
    free(other.weights);
    taut_model_free(model);
    problem_free(&problem);
}

/* Without its problem a model is judged where its details say what was known. */
static void test_model_alone(void)
{
    test_problem problem = problem_example(3);
    taut_model *model = problem_make(&problem, NULL);
    taut_certificate *certificate = certify(model, NULL);
    taut_error error = {0};
    CHECK(taut_certificate_holds(certificate) == TAUT_TRUE, "boundary");
    CHECK(!has_claim(certificate, "known"), "nothing to compare with");
    taut_certificate_free(certificate);
    taut_model_free(model);

    problem.known[5] = 1;
    model = problem_make(&problem, NULL);
    certificate = NULL;
    CHECK(taut_dirichlet_certify(model, NULL, NULL, &certificate, &error) == TAUT_BAD_INPUT,
          "a pattern needs its problem");
    CHECK(strcmp(error.reason, "needs-problem") == 0 && certificate == NULL, "%s: %s", error.reason,
          error.message);
    certificate = certify(model, &problem);
    CHECK(taut_certificate_holds(certificate) == TAUT_TRUE, "pattern");
    taut_certificate_free(certificate);
    taut_model_set_details(model, NULL);
    CHECK(taut_dirichlet_certify(model, NULL, NULL, &certificate, NULL) == TAUT_BAD_INPUT,
          "no details");
    taut_model_free(model);
    problem_free(&problem);
}

/* The best aspect is proved too: another one in its place is found out. */
static void test_aspect(void)
{
    test_problem problem = problem_example(4);
    taut_model *model = NULL;
    taut_record *details = NULL;
    taut_certificate *certificate = NULL;

    problem.data.aspect_auto = 1;
    model = problem_make(&problem, NULL);
    certificate = certify(model, &problem);
    CHECK(claim_of(certificate, "aspect")->holds == TAUT_TRUE, "best");
    /* not 0: at least what adding up the terms rounds */
    CHECK(claim_of(certificate, "aspect")->kind == TAUT_BOUND &&
              claim_of(certificate, "aspect")->residual > 16 * TAUT_UNIT_ROUNDOFF,
          "proved: %g", claim_of(certificate, "aspect")->residual);
    taut_certificate_free(certificate);
    certificate = certify(model, NULL);
    CHECK(taut_certificate_holds(certificate) == TAUT_TRUE, "from the details");
    taut_certificate_free(certificate);

    problem.data.aspect_auto = 0;
    problem.data.aspect = 1.0384;
    taut_model_free(model);
    model = problem_make(&problem, NULL);
    details = taut_record_copy(taut_model_details(model));
    problem.data.aspect_auto = 1;
    problem.data.aspect = 0;
    certificate = certify(model, &problem);
    CHECK(claim_of(certificate, "stationary")->holds == TAUT_TRUE, "it is stationary");
    CHECK(claim_of(certificate, "aspect")->kind == TAUT_BOUND, "proved to be another");
    CHECK(claim_of(certificate, "aspect")->holds == TAUT_FALSE, "for an aspect that is not best");
    taut_certificate_free(certificate);
    taut_record_free(details);
    taut_model_free(model);
    problem_free(&problem);
}

/* Far from the origin storing the points leaves more than 1e-6: undecided, never false. */
static void test_far_away(void)
{
    for (double far = 1e4; far < 1e16; far *= 100) {
        test_problem problem = problem_new(basis_uniform(3, 12), basis_uniform(3, 12));
        taut_model *model = NULL;
        taut_certificate *certificate = NULL;
        problem_random_boundary(&problem);
        for (int i = 0; i < 3 * 144; i++) {
            problem.points[i] += far;
        }
        model = problem_make(&problem, NULL);
        certificate = certify(model, &problem);
        CHECK(taut_certificate_holds(certificate) != TAUT_FALSE, "offset %g: residual %g", far,
              claim_of(certificate, "stationary")->residual);
        CHECK(claim_of(certificate, "stationary")->limit <= 1e-6, "offset %g", far);
        taut_certificate_free(certificate);
        taut_model_free(model);
        problem_free(&problem);
    }
}

/* Any size, and no size at all. */
static void test_sizes(void)
{
    static const double sizes[5] = {1e-320, 1e-200, 1, 1e200, 0};
    for (int k = 0; k < 5; k++) {
        test_problem problem = problem_example(3);
        taut_model *model = NULL;
        taut_certificate *certificate = NULL;
        for (int i = 0; i < 48; i++) {
            problem.points[i] *= sizes[k];
        }
        model = problem_make(&problem, NULL);
        certificate = certify(model, &problem);
        CHECK(taut_certificate_holds(certificate) == (k == 0 ? TAUT_UNDECIDED : TAUT_TRUE),
              "size %g", sizes[k]);
        taut_certificate_free(certificate);
        taut_model_free(model);
        problem_free(&problem);
    }
}

static double stretched_energy(const taut_model *model, double aspect)
{
    taut_dirichlet_gradient gradient;
    double energy = 0, a = 0, b = 0;
    CHECK(taut_surface_dirichlet_energy(taut_model_surface(model, 0), &energy) == TAUT_OK,
          "energy");
    CHECK(taut_dirichlet_gradient_new(taut_model_surface(model, 0), aspect,
                                      &(taut_gradient_rule){.nodes = 24}, &gradient) == TAUT_OK,
          "gradient");
    a = gradient.halves[0];
    b = gradient.halves[1];
    taut_dirichlet_gradient_clear(&gradient);
    return energy * (aspect * a + b / aspect) / (a + b);
}

/* The gradient against differences of the energy: D is quadratic in the points, so the central
 * difference is exact but for rounding. The gradient comes in a unit of its own: one factor for all
 * points. Weighted and not, at aspects that are not 1. */
static void test_gradient(void)
{
    for (int trial = 0; trial < 6; trial++) {
        test_problem problem = problem_new(basis_uniform(2, 4), basis_uniform(3, 5));
        const double aspect = random_log(0.3, 3), step = 0.125;
        taut_dirichlet_gradient gradient;
        taut_model *model = NULL;
        double factor = 0;
        problem_random_boundary(&problem);
        if (trial % 2 == 1) {
            problem_random_weights(&problem, 2);
        }
        model = problem_make(&problem, NULL);
        CHECK(taut_dirichlet_gradient_new(taut_model_surface(model, 0), aspect,
                                          &(taut_gradient_rule){.nodes = 24}, &gradient) == TAUT_OK,
              "gradient");
        for (size_t i = 0; i < 60; i++) {
            taut_model *up = perturbed(model, i / 3, i % 3, step);
            taut_model *down = perturbed(model, i / 3, i % 3, -step);
            const double slope =
                (stretched_energy(up, aspect) - stretched_energy(down, aspect)) / (2 * step);
            if (i == 0) {
                factor = slope / gradient.values[0];
            }
            CHECK_NEAR(gradient.values[i] * factor, slope, 1e-8, "trial %d number %zu", trial, i);
            taut_model_free(up);
            taut_model_free(down);
        }
        taut_dirichlet_gradient_clear(&gradient);
        taut_model_free(model);
        problem_free(&problem);
    }
}

/* Long segments of a hyperbolic spline: slopes live in layers of width 1 at the knots. What is
 * found is the least surface (the certificate has rules of its own), and as N_0 = O(1 / beta),
 * beta times the energy tends to a constant: by D(2 beta) / D(beta) = 1/2 + O(1 / beta). */
static void test_layers(void)
{
    double before = 0;
    for (double beta = 175; beta <= 700; beta *= 2) {
        const taut_basis_spec spec = {.type = "h-bspline", .beta = beta, .segments = 2};
        taut_basis *u = NULL, *v = NULL;
        double energy = 0;
        CHECK(taut_basis_new(&spec, 5, &u, NULL) == TAUT_OK, "beta=%g", beta);
        CHECK(taut_basis_new(&spec, 5, &v, NULL) == TAUT_OK, "beta=%g", beta);
        test_problem problem = problem_new(u, v);
        random_seed(20260305);
        problem_random_boundary(&problem);
        taut_model *model = problem_make(&problem, NULL);
        taut_dirichlet_gradient gradient;
        taut_certificate *certificate = certify(model, &problem);
        CHECK(taut_certificate_holds(certificate) == TAUT_TRUE, "beta=%g: residual %g, limit %g",
              beta, claim_of(certificate, "stationary")->residual,
              claim_of(certificate, "stationary")->limit);
        CHECK(taut_surface_dirichlet_energy(taut_model_surface(model, 0), &energy) == TAUT_OK,
              "beta=%g", beta);
        CHECK(taut_dirichlet_gradient_new(taut_model_surface(model, 0), 1,
                                          &(taut_gradient_rule){.nodes = 40}, &gradient) == TAUT_OK,
              "beta=%g", beta);
        CHECK_NEAR(ldexp(gradient.halves[0] + gradient.halves[1], 2 * gradient.unit) / 2, energy,
                   1e-10 * energy, "beta=%g", beta);
        if (before > 0) {
            CHECK_NEAR(energy / before, 0.5, 2 / beta, "beta=%g", beta);
        }
        before = energy;
        taut_dirichlet_gradient_clear(&gradient);
        taut_certificate_free(certificate);
        taut_model_free(model);
        problem_free(&problem);
    }
}

static void test_refusals(void)
{
    test_problem problem = problem_example(1), other = problem_example(2);
    taut_model *model = problem_make(&problem, NULL), *empty = NULL;
    taut_certificate *certificate = NULL;
    taut_error error = {0};
    CHECK(taut_model_new(&empty) == TAUT_OK, "model");
    CHECK(taut_dirichlet_certify(model, &other.data, NULL, &certificate, &error) == TAUT_BAD_INPUT,
          "another net");
    CHECK(taut_dirichlet_certify(empty, &problem.data, NULL, &certificate, &error) ==
              TAUT_BAD_INPUT,
          "no surface");
    CHECK(taut_dirichlet_certify(NULL, NULL, NULL, &certificate, &error) == TAUT_BAD_ARGUMENT,
          "no model");
    CHECK(certificate == NULL, "untouched");
    taut_model_free(empty);
    taut_model_free(model);
    problem_free(&problem);
    problem_free(&other);
}

/* One weight so large that no rule sees its layer: undecided, and no figures, whatever the surface. */
static void test_weights_apart(void)
{
    static const double weights[9] = {1, 1, 1, 1, 1e20, 1, 1, 1, 1};
    test_problem problem = problem_new(basis_uniform(2, 3), basis_uniform(2, 3));
    taut_surface *surface = NULL;
    taut_model *heavy = NULL;

    problem_random_boundary(&problem);
    problem.data.aspect_auto = 1;
    taut_model *model = problem_make(&problem, NULL);
    const taut_surface *light = taut_model_surface(model, 0);
    CHECK(taut_surface_new("", taut_surface_u(light), taut_surface_v(light),
                           taut_surface_points(light), weights, &surface, NULL) == TAUT_OK,
          "surface");
    CHECK(taut_model_new(&heavy) == TAUT_OK && taut_model_add_surface(heavy, surface) == TAUT_OK,
          "model");
    taut_model_set_details(heavy, taut_record_copy(taut_model_details(model)));
    problem.data.weights = weights;
    taut_certificate *certificate = certify(heavy, &problem);
    const taut_claim *stationary = claim_of(certificate, "stationary");
    CHECK(stationary->holds == TAUT_UNDECIDED &&
              strcmp(stationary->where, TAUT_CERTIFY_WEIGHTS_APART) == 0,
          "%s", stationary->where);
    CHECK(claim_of(certificate, "aspect")->holds == TAUT_UNDECIDED, "aspect");
    const taut_record *figures = taut_certificate_figures(certificate);
    CHECK(isnan(taut_record_number(taut_record_get(figures, "area"))), "area");
    CHECK(isnan(taut_record_number(taut_record_get(figures, "isothermality"))), "isothermality");
    taut_certificate_free(certificate);
    taut_model_free(heavy);
    taut_model_free(model);
    problem_free(&problem);
}

/* Nodes are raised by half, and no further than the Gauss points that may be spent: on one span
 * 2^24, on many as many as there are without cells. */
static void test_raised(void)
{
    taut_gradient_rule rule = {.nodes = 10};
    taut_dirichlet_gradient before = {.points = 100, .spans = 1};
    CHECK(taut_gradient_raise(&rule, &before) && rule.nodes == 15, "%d", rule.nodes);
    before.points = 0x1p24;
    CHECK(!taut_gradient_raise(&rule, &before) && rule.nodes == 15, "%d", rule.nodes);
    before.points = 0x1p24 / 2.2;
    CHECK(taut_gradient_raise(&rule, &before) && rule.nodes == 22, "%d", rule.nodes);
    before = (taut_dirichlet_gradient){.points = 1e6 * 22 * 22, .spans = 1e6};
    CHECK(taut_gradient_raise(&rule, &before) && rule.nodes == 33, "%d", rule.nodes);
    rule.nodes = 200;
    before.points = 1e6 * 200 * 200;
    CHECK(taut_gradient_raise(&rule, &before) && rule.nodes == 256, "%d", rule.nodes);
    CHECK(!taut_gradient_raise(&rule, &before), "no more");
}

int main(void)
{
    random_seed(20260304);
    test_examples();
    test_perturbed();
    test_known();
    test_model_alone();
    test_aspect();
    test_far_away();
    test_sizes();
    test_gradient();
    test_layers();
    test_weights_apart();
    test_raised();
    test_refusals();
    return check_failures != 0;
}
