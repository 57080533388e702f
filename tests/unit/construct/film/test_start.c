/* test_start.c -- films from starts, films that are no minimum, finer spaces: the thin catenoid by its closed forms, and what
 * the same film is from its own net. */
#include "certificates.h"
#include "check.h"
#include "rings.h"
#include "sails.h"

#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979324;

/* The thin catenoid between unit circles at distance h: a cosh(h / 2a) = 1. */
static double thin_neck(double h)
{
    double low = 0.02, high = h / 2 / 1.19967864025773;
    for (int k = 0; k < 200; k++) {
        const double a = 0.5 * (low + high);
        *(a * cosh(h / 2 / a) > 1 ? &low : &high) = a;
    }
    return low;
}

/* Rings of the circles' fitted points about where the thin catenoid has them. */
static double *thin_start(const ring *r, double h)
{
    taut_model *model = NULL;
    const double a = thin_neck(h);
    const int nu = taut_basis_count(r->problem.u), nv = taut_basis_count(r->problem.v);
    double *start = malloc((size_t)(nu * nv) * 3 * sizeof(double));

    CHECK(taut_film_make(&r->problem, NULL, &model, NULL) == TAUT_OK, "thick");
    const double *points = taut_surface_points(taut_model_surface(model, 0));
    for (int k = 0; k < nu * nv; k++) {
        double sum = 0; /* the Greville abscissa */
        taut_basis_spec spec;
        taut_basis_spec_of(r->problem.v, &spec);
        for (int d = 1; d <= spec.degree; d++) {
            sum += spec.knots[k % nv + d] / spec.degree;
        }
        const double z = a * asinh(sinh(h / 2 / a) * (2 * sum - 1));
        const double *rim = points + 3 * (k - k % nv);
        start[3 * k] = rim[0] * a * cosh(z / a);
        start[3 * k + 1] = rim[1] * a * cosh(z / a);
        start[3 * k + 2] = h / 2 + z;
        if (k % nv == 0 || k % nv == nv - 1) {
            memcpy(start + 3 * k, points + 3 * k, 3 * sizeof(double));
        }
    }
    taut_model_free(model);
    return start;
}

/* Area pi (a h + a^2 sinh(h / a)); the eigenvalues are closed forms as well, of all normal moves. */
static void test_thin(void)
{
    const struct {
        double h, eigenvalue, off;
    } rows[] = {{1.3, -1.44319941203643, 1e-2}};

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const double h = rows[k].h, a = thin_neck(h);
        const double area = pi * (a * h + a * a * sinh(h / a));
        ring r = ring_new(4, 20, 4, 14);
        taut_certificate *proof = NULL;
        taut_error error = {.status = TAUT_OK};
        taut_model *model = NULL;
        ring_circle(&r, 0, 0, 1);
        ring_circle(&r, 1, h, 1);
        double *start = thin_start(&r, h);
        r.problem.start = start;
        CHECK(taut_film_make(&r.problem, NULL, &model, &error) == TAUT_NO_SOLUTION &&
                  strcmp(error.reason, "unstable") == 0 && error.found < 0 &&
                  strstr(error.message, "0 waves") != NULL,
              "h = %g: %s: %s", h, error.reason, error.message);
        r.problem.accepts_stationary = 1;
        model = film_made(&r.problem, &proof, "thin");
        CHECK_NEAR(figure_of(proof, "area"), area, 1e-6 * area, "h = %g", h);
        CHECK(claim_of(proof, "stationary")->holds == TAUT_TRUE, "h = %g: %g", h,
              claim_of(proof, "stationary")->residual);
        CHECK(claim_of(proof, "stable")->holds == TAUT_UNDECIDED, "h = %g", h);
        CHECK(figure_of(proof, "lowest_eigenvalue") < -1, "h = %g", h);
        if (rows[k].eigenvalue < 0) {
            CHECK_NEAR(figure_of(proof, "lowest_eigenvalue"), rows[k].eigenvalue,
                       -rows[k].off * rows[k].eigenvalue, "h = %g", h);
        }
        const taut_record *verdict = taut_record_get(taut_model_details(model), "verdict");
        CHECK(taut_record_kind_of(taut_record_get(verdict, "stable")) == TAUT_RECORD_BOOL, "h = %g",
              h);
        taut_certificate_free(proof);
        taut_model_free(model);
        free(start);
        ring_free(&r);
    }
}

/* A film begun as itself is itself, by few steps; with no word of minima the same. */
static void test_itself(void)
{
    sail s = sail_new(4, 10, sail_saddle, 2);
    taut_certificate *proof = NULL, *other = NULL;
    s.problem.without_least = 1;
    taut_model *model = film_made(&s.problem, &proof, "saddle");
    s.problem.start = taut_surface_points(taut_model_surface(model, 0));
    for (int any = 0; any < 2; any++) {
        s.problem.accepts_stationary = any;
        taut_model *again = film_made(&s.problem, &other, "again");
        CHECK_NEAR(figure_of(other, "energy"), figure_of(proof, "energy"), 1e-12, "any %d", any);
        CHECK(taut_record_number(taut_record_get(taut_model_details(again), "iterations")) < 6,
              "any %d", any);
        taut_certificate_free(other);
        taut_model_free(again);
    }
    taut_certificate_free(proof);
    taut_model_free(model);
    sail_free(&s);
}

/* The same energy from above, and a net that is not followed: the claims hold. */
static void test_normal(void)
{
    static const char *const claims[] = {"held", "stationary", "stable", "identity"};
    sail s = sail_new(4, 12, sail_square, 2);
    taut_certificate *proof = NULL;
    s.problem.method = TAUT_FILM_NORMAL;
    taut_model *model = film_made(&s.problem, &proof, "normal");
    film_holds(proof, sizeof claims / sizeof *claims, claims, "normal");
    const double above = figure_of(proof, "energy") - 19.3057836398482911;
    CHECK(above > -1e-12 && above < 1e-6, "%g", above);
    taut_certificate_free(proof);
    taut_model_free(model);
    sail_free(&s);
}

static const double leaning[4][3] = {{-1, -1, 0.5}, {1, -1, -0.5}, {-1, 1, -0.5}, {1.2, 1.1, 0.6}};

/* Thirteen spans begin with seven, these with three: from chords the same film takes 72 steps. */
static void test_odd_spans(void)
{
    static const char *const claims[] = {"held", "stationary", "stable", "identity"};
    sail s = sail_new(4, 17, leaning, 2);
    taut_certificate *proof = NULL;
    s.problem.without_least = 1;
    taut_model *model = film_made(&s.problem, &proof, "odd");
    film_holds(proof, sizeof claims / sizeof *claims, claims, "odd");
    CHECK(taut_record_number(taut_record_get(taut_model_details(model), "iterations")) < 30,
          "steps");
    CHECK_NEAR(figure_of(proof, "energy"), 22.1969842, 1e-7, "odd");
    taut_certificate_free(proof);
    taut_model_free(model);
    sail_free(&s);
}

/* A sail without symmetry: nearly the energy of the film of all coordinates, after few steps, since the first ones are
 * taken in coarse nets, and no saddle is looked for where the net alone may lie askew. */
static void test_normal_steps(void)
{
    static const char *const claims[] = {"held", "stationary", "stable", "identity"};
    sail s = sail_new(5, 12, leaning, 2);
    taut_certificate *proof = NULL, *whole = NULL;
    s.problem.without_least = 1;
    taut_model *full = film_made(&s.problem, &whole, "full");
    s.problem.method = TAUT_FILM_NORMAL;
    taut_model *model = film_made(&s.problem, &proof, "normal");
    film_holds(proof, sizeof claims / sizeof *claims, claims, "normal");
    const double least = figure_of(whole, "energy");
    CHECK_NEAR(figure_of(proof, "energy"), least, 1e-7 * least, "normal");
    CHECK(taut_record_number(taut_record_get(taut_model_details(model), "iterations")) < 20,
          "first steps");
    taut_certificate_free(proof);
    taut_certificate_free(whole);
    taut_model_free(model);
    taut_model_free(full);
    sail_free(&s);
}

/* Energies fall towards the closed form of the square, and so does the estimate. */
static void test_refine(void)
{
    sail s = sail_new(3, 6, sail_square, 1.6);
    const double a = asin(1 / 1.6);
    taut_certificate *proof = NULL;
    s.problem.refine = 2;
    taut_model *model = film_made(&s.problem, &proof, "refined");
    const taut_record *refinement = taut_record_get(taut_model_details(model), "refinement");
    const taut_record *rounds = taut_record_get(refinement, "rounds");
    const double energy = 4 - 4 * 1.6 * 1.6 * (a - sin(a) * cos(a)) + 4 * 1.6 * 2 * 1.6 * a;
    double before = INFINITY;
    CHECK(taut_record_count(rounds) == 3, "%zu", taut_record_count(rounds));
    for (size_t k = 0; k < taut_record_count(rounds); k++) {
        const taut_record *one = taut_record_at(rounds, k);
        const double now = taut_record_number(taut_record_get(one, "energy"));
        CHECK(now < before && now > energy - 1e-10, "round %zu: %.15g, %.15g", k, now, energy);
        before = now;
    }
    CHECK_NEAR(before, energy, 1e-6, "the last");
    CHECK_NEAR(taut_record_number(taut_record_get(refinement, "estimated_least_energy")), energy,
               1e-6, "estimate");
    CHECK(taut_record_number(taut_record_get(refinement, "estimated_gap")) > 0, "gap");
    taut_certificate_free(proof);
    taut_model_free(model);
    sail_free(&s);
}

int main(void)
{
    test_thin();
    test_itself();
    test_normal();
    test_odd_spans();
    test_normal_steps();
    test_refine();
    return check_failures != 0;
}
