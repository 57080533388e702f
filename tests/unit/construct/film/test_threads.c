/* test_threads.c -- films drawn along their threads: a tube in closed form, the surface of least Dirichlet energy by the
 * construction of that name, references that lead to a catenoid; a bound that no film of the space is below. */
#include "certificates.h"
#include "check.h"
#include "rings.h"
#include "sails.h"
#include "taut/dirichlet.h"

#include <string.h>

static const double pi = 3.14159265358979324;

static void check_claims(const taut_certificate *proof, const char *what)
{
    static const char *const claims[] = {"held", "stationary", "stable", "least"};
    film_holds(proof, sizeof claims / sizeof *claims, claims, what);
    CHECK(claim_of(proof, "least")->kind == TAUT_CHECK, "%s: rounding is not enclosed", what);
}

/* Forces 2 and 1 per width around and along, by the parameters of the turn: r = r0 cosh(sqrt 2 (v - 1/2)). */
static void test_tube(void)
{
    ring r = ring_new(4, 20, 4, 10);
    taut_certificate *proof = NULL;
    ring_circle(&r, 0, 0, 1);
    ring_circle(&r, 1, 1, 1);
    r.problem.force_density[0] = 1 / pi;
    r.problem.force_density[1] = 2 * pi;
    taut_model *model = film_made(&r.problem, &proof, "tube");
    check_claims(proof, "tube");
    CHECK_NEAR(figure_of(proof, "energy"), 8.55177442270630239, 4e-9, "tube");
    CHECK_NEAR(figure_of(proof, "area"), 6.01902441570783425, 3e-10, "tube");
    CHECK(detail_of(model, "iterations") == 1, "quadratic: one step");
    taut_certificate_free(proof);
    taut_model_free(model);
    ring_free(&r);
}

/* Between held edges a = b = 1 is twice the Dirichlet energy of parameters over [0, 1]; other forces are other ranges. */
static void test_dirichlet(void)
{
    const double corners[4][3] = {{0, 0, 0.3}, {2, 0, -0.2}, {0.3, 1, 0.1}, {2.5, 1.5, 1}};
    for (int k = 0; k < 2; k++) {
        sail s = sail_new(3, 8, corners, 0);
        taut_certificate *proof = NULL;
        taut_basis *wide = NULL;
        taut_model *other = NULL;
        double net[64][3];
        unsigned char known[64];
        double knots[12];
        for (int i = 0; i < 12; i++) {
            knots[i] = (k + 1) * fmin(5, fmax(0, i - 3)) / 5;
        }
        const taut_basis_spec spec = {
            .type = "bspline", .degree = 3, .knot_count = 12, .knots = knots};
        CHECK(taut_basis_new(&spec, 8, &wide, NULL) == TAUT_OK, "range");
        s.problem.force_density[0] =
            k == 0 ? 1 : 0.25; /* |x_u|^2 over [0, 2] is a quarter, du twice */
        s.problem.force_density[1] = 1;
        taut_model *model = film_made(&s.problem, &proof, "dirichlet");
        check_claims(proof, "dirichlet");
        const double *points = taut_surface_points(taut_model_surface(model, 0));
        for (int i = 0; i < 64; i++) {
            known[i] = i / 8 == 0 || i / 8 == 7 || i % 8 == 0 || i % 8 == 7;
            memcpy(net[i], points + 3 * i, sizeof net[i]);
        }
        const taut_dirichlet_problem problem = {
            .u = wide, .v = s.v, .points = net[0], .known = known};
        CHECK(taut_dirichlet_make(&problem, NULL, &other, NULL) == TAUT_OK, "dirichlet");
        const double *expected = taut_surface_points(taut_model_surface(other, 0));
        for (int i = 0; i < 3 * 64; i++) {
            CHECK_NEAR(points[i], expected[i], 1e-14, "case %d, number %d", k, i);
        }
        taut_basis_free(wide);
        taut_model_free(other);
        taut_certificate_free(proof);
        taut_model_free(model);
        sail_free(&s);
    }
}

/* dE/dT = L, by differences; and no other net of the space, here that of other forces, is below the bound. */
static void test_sail(void)
{
    double energies[3], length = 0, bound = 0;
    for (int k = 0; k < 3; k++) {
        sail s = sail_new(3, 9, sail_saddle, 3);
        taut_certificate *proof = NULL;
        s.problem.force_density[0] = 2;
        s.problem.force_density[1] = 1;
        s.problem.edges[0].force = 3 + 1e-4 * (k - 1);
        taut_model *model = film_made(&s.problem, &proof, "sail");
        check_claims(proof, "sail");
        energies[k] = figure_of(proof, "energy");
        length = k == 1 ? sail_figure(proof, "lengths", 0) : length;
        bound = k == 1 ? figure_of(proof, "lower_bound") : bound;
        taut_certificate_free(proof);
        taut_model_free(model);
        sail_free(&s);
    }
    CHECK_NEAR((energies[2] - energies[0]) / 2e-4, length, 1e-7, "dE/dT");
    CHECK(bound <= energies[1] && energies[1] - bound < 1e-6 * energies[1], "%g", bound);
}

/* A film on a reference that is fed back comes to stresses that are alike everywhere: the catenoid. */
static void test_updates(void)
{
    ring r = ring_new(4, 20, 4, 10);
    taut_certificate *proof = NULL;
    taut_model *tube = NULL;
    ring_circle(&r, 0, 0, 1);
    ring_circle(&r, 1, 1, 1);
    r.problem.force_density[0] = 1 / pi;
    r.problem.force_density[1] = 2 * pi;
    CHECK(taut_film_make(&r.problem, NULL, &tube, NULL) == TAUT_OK, "tube");
    r.problem.force_density[0] = r.problem.force_density[1] = 0;
    r.problem.prestress[0] = r.problem.prestress[1] = 5;
    r.problem.reference = taut_model_surface(tube, 0);
    r.problem.updates = 40;
    taut_model *model = film_made(&r.problem, &proof, "updates");
    if (model == NULL) {
        return;
    }
    CHECK_NEAR(figure_of(proof, "area"), ring_area(1), 4e-10, "updates");
    CHECK(claim_of(proof, "stationary")->holds == TAUT_UNDECIDED, "of which reference?");
    r.problem.updates = 0;
    r.problem.reference = taut_model_surface(model, 0); /* its own: at rest once more */
    taut_certificate_free(proof);
    taut_model *again = film_made(&r.problem, &proof, "own");
    CHECK(claim_of(proof, "stationary")->holds == TAUT_TRUE, "own");
    CHECK_NEAR(figure_of(proof, "energy"), 5 * ring_area(1), 3e-9, "half of both forces on itself");
    taut_certificate_free(proof);
    taut_model_free(again);
    taut_model_free(model);
    taut_model_free(tube);
    ring_free(&r);
}

static void refuse(const taut_film_problem *problem, const char *reason, const char *where)
{
    taut_error error = {.status = TAUT_OK};
    taut_model *model = NULL;

    CHECK(taut_film_make(problem, NULL, &model, &error) == TAUT_BAD_INPUT &&
              strcmp(error.reason, reason) == 0 && strcmp(error.where, where) == 0,
          "expected %s at %s: %s at %s: %s", reason, where, error.reason, error.where,
          error.message);
    taut_model_free(model);
}

static void test_refused(void)
{
    sail s = sail_new(3, 8, sail_saddle, 3);
    taut_model *flat = NULL;

    s.problem.force_density[0] = 1;
    refuse(&s.problem, "value", "/force_density");
    s.problem.force_density[1] = INFINITY;
    refuse(&s.problem, "value", "/force_density");
    s.problem.force_density[1] = 1;
    s.problem.tension = 2;
    refuse(&s.problem, "conflict", "/force_density");
    s.problem.tension = 0;
    s.problem.updates = 1;
    refuse(&s.problem, "conflict", "/updates");
    s.problem.updates = 0;
    CHECK(taut_film_make(&s.problem, NULL, &flat, NULL) == TAUT_OK, "sail");
    s.problem.reference = taut_model_surface(flat, 0);
    refuse(&s.problem, "missing", "/prestress");
    s.problem.force_density[0] = s.problem.force_density[1] = 0;
    s.problem.prestress[0] = s.problem.prestress[1] = 1;
    s.problem.reference = NULL;
    refuse(&s.problem, "missing", "/reference");
    s.problem.reference = taut_model_surface(flat, 0);
    s.problem.updates = 101;
    refuse(&s.problem, "value", "/updates");
    s.problem.updates = 0;
    sail other = sail_new(3, 9, sail_saddle, 3);
    other.problem.prestress[0] = other.problem.prestress[1] = 1;
    other.problem.reference = s.problem.reference;
    refuse(&other.problem, "basis", "/reference");
    sail_free(&other);
    taut_model_free(flat);
    sail_free(&s);
}

int main(void)
{
    test_tube();
    test_dirichlet();
    test_sail();
    test_updates();
    test_refused();
    return check_failures != 0;
}
