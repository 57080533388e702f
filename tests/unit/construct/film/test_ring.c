/* test_ring.c -- films that go around against catenoids: between circles, on a cable, on a plane; where there is
 * none, refusals on the right side of the known distances. */
#include "certificates.h"
#include "check.h"
#include "refused.h"
#include "rings.h"
#include "sails.h"

#include "taut/construct.h"
#include "taut/read.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double pi = 3.14159265358979324;

/* The model with a certificate that holds. */
static taut_model *make(const ring *r, taut_certificate **proof, const char *what)
{
    static const char *const claims[] = {"held", "seams", "stationary", "stable", "identity"};
    taut_model *model = film_made(&r->problem, proof, what);
    film_holds(*proof, sizeof claims / sizeof *claims, claims, what);
    return model;
}

/* Heights of a half and more are stable up to 1.3255; eigenvalues of the second variation against the normal are closed
 * forms too. What limits is the circle, fitted to 16 and 24 spans. */
static void test_catenoid(void)
{
    const struct {
        int p, n, q, m;
        double h, tolerance, eigenvalue, off;
    } rows[] = {{4, 20, 4, 10, 1, 1e-10, 6.88334278619286, 3e-6},
                {5, 29, 5, 13, 1, 5e-12, 6.88334278619286, 1e-7},
                {4, 20, 4, 10, 1.3, 1e-9, 1.32126176671640, 6e-5},
                {3, 23, 3, 11, 0.5, 1e-8, 0, INFINITY},
                {4, 10, 4, 9, 1, 1e-6, 0, INFINITY}};

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        ring r = ring_new(rows[k].p, rows[k].n, rows[k].q, rows[k].m);
        taut_certificate *proof = NULL;
        ring_circle(&r, 0, 0, 1);
        ring_circle(&r, 1, rows[k].h, 1);
        taut_model *model = make(&r, &proof, "catenoid");
        const double area = ring_area(rows[k].h);
        CHECK_NEAR(figure_of(proof, "area"), area, rows[k].tolerance * area, "row %zu", k);
        if (rows[k].eigenvalue > 0) {
            CHECK_NEAR(figure_of(proof, "lowest_eigenvalue"), rows[k].eigenvalue,
                       rows[k].off * rows[k].eigenvalue, "row %zu", k);
        }
        CHECK(claim_of(proof, "boundary")->holds == TAUT_TRUE, "row %zu", k);
        taut_certificate_free(proof);
        taut_model_free(model);
        ring_free(&r);
    }
}

/* The neck in the middle, all around. */
static void test_neck(void)
{
    ring r = ring_new(4, 20, 4, 12);
    taut_certificate *proof = NULL;
    ring_circle(&r, 0, -0.5, 1);
    ring_circle(&r, 1, 0.5, 1);
    taut_model *model = make(&r, &proof, "neck");
    double nearest = INFINITY;
    for (int k = 0; model != NULL && k < 500; k++) {
        double x[3];
        (void)taut_surface_eval(taut_model_surface(model, 0), random_in(0, 1), random_in(0.4, 0.6),
                                0, x);
        nearest = fmin(nearest, hypot(x[0], x[1]));
    }
    CHECK(ring_neck(1) <= nearest + 2e-6 && nearest < ring_neck(1) + 1e-4, "%g", nearest);
    taut_certificate_free(proof);
    taut_model_free(model);
    ring_free(&r);
}

/* Circles of two radii on one catenoid rho = a cosh((z - b) / a). */
static void test_unequal(void)
{
    const double a = 0.7, low = -0.4, high = 0.9;
    ring r = ring_new(5, 30, 5, 14);
    taut_certificate *proof = NULL;
    ring_circle(&r, 0, low, a * cosh(low / a));
    ring_circle(&r, 1, high, a * cosh(high / a));
    taut_model *model = make(&r, &proof, "unequal");
    const double area = pi * a * (high - low + 0.5 * a * (sinh(2 * high / a) - sinh(2 * low / a)));
    CHECK_NEAR(figure_of(proof, "area"), area, 2e-11 * area, "two radii");
    taut_certificate_free(proof);
    taut_model_free(model);
    ring_free(&r);
}

/* A cable in the plane z = 0.3 draws the film in to 0.8127: tanh((h - b) / a) = -T / r. */
static void test_cable(void)
{
    for (int law = 0; law < 3; law++) {
        ring r = ring_new(4, 20, 4, 10);
        taut_certificate *proof = NULL;
        const double length = 5.106618132605986741, force = 0.3, unstressed = 5.1;
        ring_circle(&r, 0, 0, 1);
        ring_cable(&r, 1, 0.3, force);
        r.problem.edges[3].law = law == 0   ? TAUT_FILM_FORCE
                                 : law == 1 ? TAUT_FILM_LENGTH
                                            : TAUT_FILM_ELASTIC;
        r.problem.edges[3].length = length;
        r.problem.edges[3].unstressed = unstressed;
        r.problem.edges[3].stiffness = force * unstressed / (length - unstressed);
        taut_model *model = make(&r, &proof, "cable");
        CHECK_NEAR(figure_of(proof, "area"), 2.004664184976782615, 3e-10, "law %d", law);
        const double energy = figure_of(proof, "energy") + (law == 1 ? force * length : 0);
        if (law < 2) {
            CHECK_NEAR(energy, 3.536649624758578637, 5e-11, "law %d", law);
        }
        CHECK(figure_of(proof, "balance") < 2e-6, "law %d: %g", law, figure_of(proof, "balance"));
        CHECK(figure_of(proof, "cable_geodesic") < 1e-3, "law %d: %g", law,
              figure_of(proof, "cable_geodesic"));
        taut_certificate_free(proof);
        taut_model_free(model);
        ring_free(&r);
    }
}

/* A plane that the film meets at a right angle holds half of what is mirrored in it. */
static void test_slide(void)
{
    ring r = ring_new(4, 20, 4, 10);
    taut_certificate *proof = NULL;
    ring_circle(&r, 0, 0, 1);
    ring_slide(&r, 1, 0.5);
    taut_model *model = make(&r, &proof, "slide");
    CHECK_NEAR(2 * figure_of(proof, "area"), ring_area(1), 3e-10, "half a catenoid");
    CHECK(figure_of(proof, "slide_angle") < 1e-4, "%g", figure_of(proof, "slide_angle"));
    taut_certificate_free(proof);
    taut_model_free(model);
    ring_free(&r);
}

/* A disc round a pole: area pi, lowest eigenvalue the square of the first zero of J0. */
static void test_pole(void)
{
    ring r = ring_new(4, 20, 4, 10);
    taut_certificate *proof = NULL;
    const double zero = 2.40482555769577277;
    ring_circle(&r, 0, 0.25, 1);
    r.problem.edges[3].kind = TAUT_FILM_POLE;
    taut_model *model = make(&r, &proof, "pole");
    CHECK_NEAR(figure_of(proof, "area"), pi, 3e-10, "disc");
    CHECK_NEAR(figure_of(proof, "lowest_eigenvalue"), zero * zero, 1e-8, "disc");
    taut_certificate_free(proof);
    taut_model_free(model);
    ring_free(&r);
}

/* Turned, moved, larger: the same film; the other direction around: the same too. */
static void test_alike(void)
{
    double c = cos(1.1), s = sin(1.1),
           turn[3][3] = {{c, -s, 0}, {s * c, c * c, -s}, {s * s, c * s, c}};
    const double d[3] = {3, -2, 0.5};
    double area[2];

    for (int k = 0; k < 2; k++) {
        ring r = ring_new(4, 17, 3, 8);
        taut_certificate *proof = NULL;
        ring_circle(&r, 0, 0, 1);
        ring_cable(&r, 1, 0.25, 0.4);
        if (k == 1) {
            ring_move(&r, turn, d);
            r.problem.u = r.v;
            r.problem.v = r.u;
            r.problem.ring = TAUT_FILM_RING_V;
            memcpy(r.problem.edges, r.problem.edges + 2, 2 * sizeof *r.problem.edges);
            memset(r.problem.edges + 2, 0, 2 * sizeof *r.problem.edges);
        }
        taut_model *model = make(&r, &proof, "alike");
        area[k] = figure_of(proof, "area");
        taut_certificate_free(proof);
        taut_model_free(model);
        ring_free(&r);
    }
    CHECK_NEAR(area[0], area[1], 1e-12, "turned, and the other way around");
}

static void refuse(const ring *r, taut_status status, const char *reason, const char *where)
{
    taut_error error = {.status = TAUT_OK};
    taut_model *model = NULL;
    const taut_status found = taut_film_make(&r->problem, NULL, &model, &error);

    CHECK(found == status && strcmp(error.reason, reason) == 0 && strcmp(error.where, where) == 0,
          "expected %s at %s: status %d, %s at %s: %s", reason, where, (int)found, error.reason,
          error.where, error.message);
    CHECK(model == NULL, "%s", reason);
    taut_model_free(model);
}

/* Above 2 / sinh t0 = 1.32548683869836 there is none, which is proved; 1.32 has one. A plane has one up to half of it,
 * a cable of force 0.3 up to 0.376. */
static void test_far(void)
{
    const struct {
        double h, plane, cable;
        int is_there;
    } rows[] = {{1.32, 0, 0, 1},  {1.327, 0, 0, 0}, {5, 0, 0, 0},    {0, 0.66, 0, 1},
                {0, 0.664, 0, 0}, {0, 0, 0.37, 1},  {0, 0, 0.38, 0}, {0, 0, 2, 0}};

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        ring r = ring_new(3, 13, 3, 7); /* coarse: each step on the way is a film */
        ring_circle(&r, 0, 0, 1);
        if (rows[k].h > 0) {
            ring_circle(&r, 1, rows[k].h, 1);
        } else if (rows[k].plane > 0) {
            ring_slide(&r, 1, rows[k].plane);
        } else {
            ring_cable(&r, 1, rows[k].cable, 0.3);
        }
        if (rows[k].is_there) {
            taut_certificate *proof = NULL;
            taut_model *model = make(&r, &proof, "far");
            taut_certificate_free(proof);
            taut_model_free(model);
        } else {
            refuse(&r, TAUT_NO_SOLUTION, rows[k].plane > 0 ? "slides-away" : "collapses",
                   rows[k].h > 0 ? "/edges" : "/edges/v1");
        }
        ring_free(&r);
    }
}

/* The cone turns with the edges, and is found where the middles are not on its axis. */
static void test_cone(void)
{
    double turn[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}};
    const double d[3] = {10, 20, 30};
    ring r = ring_new(4, 20, 3, 6);
    taut_error error = {.status = TAUT_OK};
    taut_model *model = NULL;

    ring_circle(&r, 0, 0, 1);
    ring_circle(&r, 1, 1.4, 1);
    ring_move(&r, turn, d);
    CHECK(taut_film_make(&r.problem, NULL, &model, &error) == TAUT_NO_SOLUTION, "turned");
    CHECK_NEAR(error.limit, 1.32548683869836, 1e-13, "turned");
    CHECK_NEAR(error.found, 1.4, 1e-13, "turned");
    ring_free(&r);
}

static void test_refused(void)
{
    ring r = ring_new(4, 20, 4, 10);
    taut_basis *few = NULL;
    const taut_basis_spec spec = {.type = "bspline", .degree = 4, .count = 8};

    refuse(&r, TAUT_BAD_INPUT, "corner-missing", "/edges/v0");
    ring_cable(&r, 0, 0, 1);
    ring_cable(&r, 1, 1, 1);
    refuse(&r, TAUT_NO_SOLUTION, "floating", "/edges");
    ring_circle(&r, 0, 0, 1);
    r.problem.edges[3].has_plane = 0;
    refuse(&r, TAUT_NO_SOLUTION, "collapses", "/edges/v1");
    r.problem.edges[3].has_plane = 1;
    r.problem.edges[3].plane.direction[2] = 0;
    refuse(&r, TAUT_BAD_INPUT, "value", "/edges/v1");
    r.problem.edges[3].plane.direction[2] = 1;
    r.problem.edges[3].law = TAUT_FILM_SAG;
    r.problem.edges[3].sag = 0.1;
    refuse(&r, TAUT_BAD_INPUT, "value", "/edges/v1");
    r.problem.edges[0].kind = TAUT_FILM_SLIDE;
    refuse(&r, TAUT_BAD_INPUT, "edge-conflict", "/edges/u0");
    r.problem.edges[0].kind = TAUT_FILM_FIXED;
    ring_slide(&r, 1, 0.3);
    r.problem.has_corner[2] = 1;
    refuse(&r, TAUT_BAD_INPUT, "corner-conflict", "/corners/u0v1");
    r.problem.has_corner[2] = 0;
    CHECK(taut_basis_new(&spec, 8, &few, NULL) == TAUT_OK, "few");
    r.problem.u = few;
    refuse(&r, TAUT_BAD_INPUT, "basis", "/u");
    taut_basis_free(few);
    ring_free(&r);
}

/* A document: a film between circles of radius 1 about the z axis at 0 and h, the second from an angle on. */
static taut_problem *read_tube(const char *members, int across, double h, double angle)
{
    char text[1000];
    taut_problem *problem = NULL;

    snprintf(
        text, sizeof text,
        "{\"taut\":1,\"construct\":\"film\",%s\"u\":{\"type\":\"bspline\",\"degree\":4,\"count\":"
        "20},"
        "\"v\":{\"type\":\"bspline\",\"degree\":4,\"count\":%d},\"seams\":[[\"u0\",\"u1\"]],"
        "\"edges\":{"
        "\"v0\":{\"fixed\":{\"circle\":{\"center\":[0,0,0],\"normal\":[0,0,1],\"radius\":1}}},"
        "\"v1\":{\"fixed\":{\"circle\":{\"center\":[0,0,%.17g],\"normal\":[0,0,1],\"radius\":1,"
        "\"start\":[%.17g,%.17g,0]}}}}}",
        members, across, h, cos(angle), sin(angle));
    CHECK(taut_problem_read_text(text, strlen(text), "tube", &problem, NULL) == TAUT_OK, "read");
    return problem;
}

/* One film, wherever its circles begin: straight lines between opposite places would all meet in the middle. */
static void test_starts(void)
{
    for (int k = 1; k < 8; k++) {
        taut_problem *problem = read_tube("", 10, 0.7, pi * k / 4);
        taut_certificate *proof = NULL;
        taut_model *model = NULL;
        taut_error said = {.status = TAUT_OK};
        CHECK(taut_make(problem, NULL, &model, &said) == TAUT_OK, "%d/8: %s", k, said.message);
        if (model != NULL && taut_certify(model, problem, NULL, &proof, NULL) == TAUT_OK) {
            CHECK(taut_certificate_holds(proof) != TAUT_FALSE, "%d/8", k);
            CHECK_NEAR(figure_of(proof, "area"), ring_area(0.7), 1e-8, "%d/8", k);
        }
        taut_certificate_free(proof);
        taut_model_free(model);
        taut_problem_free(problem);
    }
}

/* Threads draw a tube thin and never part: r = cosh(k (v - 1/2)) / cosh(k / 2), k = 2 pi sqrt(a / b), and the energy is b (1 / 2 +
 * k tanh(k / 2)). On few points the spline swings beyond the axis, and that is no collapse. */
static void test_thin(void)
{
    const double k = 2 * pi * sqrt(10);
    taut_problem *problem = read_tube("\"force_density\":[10,1],", 40, 1, 0);
    taut_problem *coarse = read_tube("\"force_density\":[10,1],", 10, 1, 0);
    taut_certificate *proof = NULL;
    taut_model *model = NULL;
    taut_error said = {.status = TAUT_OK};

    CHECK(taut_make(problem, NULL, &model, &said) == TAUT_OK &&
              taut_certify(model, problem, NULL, &proof, NULL) == TAUT_OK,
          "%s", said.message);
    CHECK(taut_certificate_holds(proof) == TAUT_TRUE, "thin");
    CHECK_NEAR(figure_of(proof, "energy"), 0.5 + k * tanh(k / 2), 1e-7, "thin");
    taut_certificate_free(proof);
    taut_model_free(model);
    model = NULL;
    CHECK(taut_make(coarse, NULL, &model, &said) == TAUT_NOT_CONVERGED &&
              strcmp(said.reason, "folds") == 0 && strstr(said.message, "cable") == NULL,
          "%s", said.message);
    taut_problem_free(problem);
    taut_problem_free(coarse);
}

/* A closed cable that is longer than the waist of the catenoid, where the film without it would rest in its plane: slack. */
static void test_slack(void)
{
    const double waist = 0.952356777722, pi2 = 2 * pi; /* a cosh(0.3 / a) = 1 */
    const char *const laws[] = {"\"length\":6.2", "\"length\":8",
                                "\"unstressed\":6.5,\"stiffness\":10"};
    char text[1000];

    CHECK_NEAR(waist * cosh(0.3 / waist), 1, 1e-10, "waist");
    for (int k = 0; k < 3; k++) {
        snprintf(
            text, sizeof text,
            "{\"taut\":1,\"construct\":\"film\",\"u\":{\"type\":\"bspline\",\"degree\":4,\"count\":"
            "20},"
            "\"v\":{\"type\":\"bspline\",\"degree\":4,\"count\":10},\"seams\":[[\"u0\",\"u1\"]],"
            "\"edges\":{"
            "\"v0\":{\"fixed\":{\"circle\":{\"center\":[0,0,0],\"normal\":[0,0,1],\"radius\":1}}},"
            "\"v1\":{\"cable\":{%s},\"plane\":{\"point\":[0,0,0.3],\"normal\":[0,0,1]}}}}",
            laws[k]);
        const taut_error said =
            check_document_refused(text, TAUT_NO_SOLUTION, "cable-too-weak", "/edges/v1/cable");
        CHECK(strstr(said.message, "slack") != NULL, "%s", said.message);
        CHECK(fabs(said.limit - pi2 * waist) < 1e-4, "%s", said.message);
    }
}

int main(void)
{
    test_slack();
    random_seed(23);
    test_starts();
    test_thin();
    test_catenoid();
    test_neck();
    test_unequal();
    test_cable();
    test_slide();
    test_pole();
    test_alike();
    test_far();
    test_cone();
    test_refused();
    return check_failures != 0;
}
