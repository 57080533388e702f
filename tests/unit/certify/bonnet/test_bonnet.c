/* test_bonnet.c -- the certificate of bonnet attacked: points moved by ten times each limit and by a
 * tenth, nets that are minimal where one might look and nowhere else, creases, other bases, sizes. */
#include "attack.h"
#include "certificates.h"
#include "check.h"
#include "shapes.h"

#include <string.h>

static void test_attacked(void)
{
    static const attack rows[] = {
        {"bonnet-figure-2a", "isothermal", TAUT_BOUND, 0, 0, 15, 1e-9},
        {"bonnet-figure-2a", "harmonic", TAUT_BOUND, 0, 0, 15, 1e-9},
        {"bonnet-figure-2a", "minimal", TAUT_BOUND, 0, 0, 15, 1e-9},
        {"bonnet-figure-2a", "formula", TAUT_BOUND, 0, 0, 15, 1e-12},
        {"bonnet-figure-2a", "algebraic", TAUT_EXACT, 0, 0, 15, 1e-9},
        {"bonnet-figure-3b", "isothermal", TAUT_BOUND, 0, 0, 15, 1e-9},
        {"bonnet-figure-3b", "harmonic", TAUT_BOUND, 0, 0, 15, 1e-9},
        {"bonnet-figure-3b", "minimal", TAUT_BOUND, 0, 0, 15, 1e-9},
        {"bonnet-thomsen", "isothermal", TAUT_BOUND, 0, 0, 15, 1e-9},
        {"bonnet-thomsen", "minimal", TAUT_BOUND, 0, 0, 15, 1e-9},
        {"bonnet-roof", "isothermal", TAUT_BOUND, 0, 0, 15, 1e-9},
        {"bonnet-roof", "harmonic", TAUT_BOUND, 0, 0, 15, 1e-9},
        {"bonnet-roof", "formula", TAUT_BOUND, 0, 0, 15, 1e-12},
        {"bonnet-enneper", "isothermal", TAUT_BOUND, 5, 0, 15, 1e-9},
        {"bonnet-enneper", "harmonic", TAUT_BOUND, 5, 0, 15, 1e-9},
        {"bonnet-enneper", "formula", TAUT_BOUND, 2, 0, 15, 1e-12},
    };
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        attack_claim(&rows[k], 3);
    }
}

/* The claim of a surface alone; takes it over. */
static taut_verdict verdict_of(taut_surface *surface, const char *name)
{
    taut_model *model = shape_model(surface);
    taut_certificate *certificate = prove(model, NULL, "bonnet");
    const taut_verdict holds =
        name != NULL ? claim_of(certificate, name)->holds : taut_certificate_holds(certificate);
    taut_certificate_free(certificate);
    taut_model_free(model);
    return holds;
}

/* Enneper's surface as two bicubic spans with a C^0 knot at 0, and what is beyond it turned about the
 * line where they meet: both are minimal, the whole is none. */
static void test_crease(void)
{
    static const double knots[] = {-0.5, -0.5, -0.5, -0.5, 0, 0, 0, 0.5, 0.5, 0.5, 0.5};
    for (int turned = 0; turned < 2; turned++) {
        taut_surface *low = shape_enneper(-0.5, 0, -0.5, 0.5);
        taut_surface *high = shape_enneper(0, 0.5, -0.5, 0.5);
        const taut_basis_spec spec = {
            .type = "bspline", .degree = 3, .knot_count = 11, .knots = knots};
        double points[7][4][3];
        for (int i = 0; i < 7; i++) {
            const taut_surface *s = i < 4 ? low : high;
            memcpy(points[i], taut_surface_points(s) + 12 * (i < 4 ? i : i - 3), sizeof points[i]);
            for (int j = 0; turned && i > 3 && j < 4; j++) { /* mirrored in the plane of the line */
                points[i][j][0] = -points[i][j][0];
            }
        }
        taut_surface *whole =
            shape_surface(shape_basis(&spec), shape_bezier(3, -0.5, 0.5), &points[0][0][0], NULL);
        CHECK(verdict_of(whole, NULL) == (turned ? TAUT_FALSE : TAUT_TRUE), "turned %d", turned);
        taut_surface_free(low);
        taut_surface_free(high);
    }
}

/* Flat in the middle of every span, not between: z a sum of bumps. */
static void test_stairs(void)
{
    for (int spans = 2; spans <= 64; spans *= 2) {
        double knots[300], points[200][2][3];
        int count = 0;
        knots[count++] = 0;
        for (int i = 0; i <= spans; i++) {
            for (int k = 0; k < 3; k++) {
                knots[count++] = i;
            }
        }
        knots[count++] = spans;
        const taut_basis_spec spec = {
            .type = "bspline", .degree = 3, .knot_count = count, .knots = knots};
        for (int i = 0; i <= 3 * spans; i++) {
            for (int j = 0; j < 2; j++) {
                const double z = i % 3 == 1 ? 0.25 : i % 3 == 2 ? -0.25 : 0;
                const double x[3] = {i / 3.0, j, i / 3 == spans / 2 ? z : 0};
                memcpy(points[i][j], x, sizeof x);
            }
        }
        taut_surface *s =
            shape_surface(shape_basis(&spec), shape_bezier(1, 0, 1), &points[0][0][0], NULL);
        CHECK(verdict_of(s, "isothermal") == TAUT_FALSE, "%d spans", spans);
    }
}

static void test_bases(void)
{
    const taut_basis_spec circular = {.type = "c-bezier", .alpha = 1};
    double points[5][4][3];
    for (int k = 0; k < 20; k++) { /* a square: isothermal, harmonic, and no curvature */
        const double x[3] = {k / 4, k % 4, 0};
        memcpy(points[k / 4][k % 4], x, sizeof x);
    }
    CHECK(verdict_of(
              shape_surface(shape_bezier(4, 0, 4), shape_bezier(3, 0, 3), &points[0][0][0], NULL),
              "harmonic") == TAUT_UNDECIDED,
          "degree 4");
    CHECK(verdict_of(
              shape_surface(shape_bezier(3, 0, 3), shape_bezier(3, 0, 3), &points[0][0][0], NULL),
              "minimal") == TAUT_UNDECIDED,
          "a plane");
    for (int k = 0; k < 20; k++) {
        points[k / 4][k % 4][1] *= 1.001;
    }
    CHECK(verdict_of(
              shape_surface(shape_bezier(3, 0, 3), shape_bezier(3, 0, 3), &points[0][0][0], NULL),
              "isothermal") == TAUT_FALSE,
          "a plane that is stretched");
    for (int k = 0; k < 16; k++) { /* the plane (u, v) on two circular directions */
        const double t = (1 - sin(1)) / (1 - cos(1)), line[4] = {0, t, 1 - t, 1};
        const double x[3] = {line[k / 4], line[k % 4], 0};
        memcpy(points[k / 4][k % 4], x, sizeof x);
    }
    CHECK(verdict_of(
              shape_surface(shape_basis(&circular), shape_basis(&circular), &points[0][0][0], NULL),
              "isothermal") == TAUT_UNDECIDED,
          "a plane on two circular directions");
    points[2][2][2] = 0.01;
    CHECK(verdict_of(
              shape_surface(shape_basis(&circular), shape_basis(&circular), &points[0][0][0], NULL),
              "isothermal") == TAUT_FALSE,
          "two circular directions");
}

/* At every size the same verdicts, and a point moved by 1e-6 of it is told. */
static void test_sizes(void)
{
    static const int exponents[] = {-1000, -600, -300, 0, 300, 600, 1000};
    subject s = subject_example("bonnet-figure-2a");
    for (size_t k = 0; k < sizeof exponents / sizeof exponents[0]; k++) {
        const double by[3] = {0, 0, ldexp(1e-6, exponents[k])};
        taut_model *scaled = model_scaled(s.model, exponents[k]);
        taut_model *moved = model_moved(scaled, 0, 5, by);
        taut_certificate *good = prove(scaled, NULL, "bonnet");
        taut_certificate *bad = prove(moved, NULL, "bonnet");
        static const char *const names[] = {"isothermal", "harmonic", "minimal", "algebraic"};
        for (int i = 0; i < 4; i++) {
            CHECK(claim_of(good, names[i])->holds == TAUT_TRUE, "%s at 2^%d", names[i],
                  exponents[k]);
            CHECK(claim_of(bad, names[i])->holds == TAUT_FALSE, "%s moved at 2^%d", names[i],
                  exponents[k]);
        }
        taut_certificate_free(good);
        taut_certificate_free(bad);
        taut_model_free(scaled);
        taut_model_free(moved);
    }
    subject_free(&s);
}

/* A corner of the net is on the surface: moved, it is as far away as the claim says, or less. */
static void test_distance(void)
{
    static const int corners[] = {0, 3, 12, 15};
    subject s = subject_example("bonnet-figure-2a");
    for (size_t k = 0; k < 4; k++) {
        const double by[3] = {1e-6, 0, 0};
        taut_model *moved = model_moved(s.model, 0, corners[k], by);
        taut_certificate *certificate = prove(moved, s.problem, NULL);
        double size = 0;
        for (int c = 0; c < 48; c++) {
            size = fmax(size, fabs(taut_surface_points(taut_model_surface(s.model, 0))[c]));
        }
        CHECK(claim_of(certificate, "formula")->residual >= 0.99e-6 / size, "corner %zu: %g", k,
              claim_of(certificate, "formula")->residual);
        taut_certificate_free(certificate);
        taut_model_free(moved);
    }
    subject_free(&s);
}

/* Another window, sign, lambda or theta, each by 1e-9, is another surface. */
static void test_formula(void)
{
    static const char *const others[] = {
        "\"lambda\": 0.500000001, \"alpha\": 2, \"beta\": 1",
        "\"lambda\": 0.5, \"alpha\": 2.000000001, \"beta\": 1",
        "\"lambda\": 0.5, \"alpha\": 2, \"beta\": 1, \"theta\": 1e-9",
        "\"lambda\": 0.5, \"alpha\": 2, \"beta\": 1, \"start\": [1e-9, 0]",
        "\"lambda\": 0.5, \"alpha\": 1, \"beta\": 1, \"mesh\": \"bspline\", \"segments\": [3, 1]",
    };
    const char *format = "{\"taut\": 1, \"construct\": \"bonnet\", \"sign\": \"+\", %s}";
    char text[512];
    snprintf(text, sizeof text, format, "\"lambda\": 0.5, \"alpha\": 2, \"beta\": 1");
    subject one = subject_of(text);
    for (size_t k = 0; k < sizeof others / sizeof others[0]; k++) {
        snprintf(text, sizeof text, format, others[k]);
        subject other = subject_of(text);
        taut_certificate *certificate = prove(other.model, one.problem, NULL);
        CHECK(claim_of(certificate, "formula")->holds == TAUT_FALSE, "%s", others[k]);
        CHECK(claim_of(certificate, "minimal")->holds == TAUT_TRUE, "%s", others[k]);
        taut_certificate_free(certificate);
        subject_free(&other);
    }
    subject_free(&one);
}

int main(void)
{
    random_seed(20261211);
    test_attacked();
    test_crease();
    test_stairs();
    test_bases();
    test_sizes();
    test_distance();
    test_formula();
    return check_failures != 0;
}
