/* test_tip.c -- films of one patch with an edge that is a point: sails of three corners, sectors, and what is refused. */
#include "check.h"
#include "refused.h"

#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define FILM(members) "{\"taut\":1,\"construct\":\"film\"," members "}"
#define CABLE(force) "{\"cable\":{\"force\":" force "}}"
#define SLIDE(x, y, z) "{\"slide\":{\"point\":[0,0,0],\"normal\":[" #x "," #y "," #z "]}}"
#define BASES(p, n)                                                                                \
    "\"u\":{\"type\":\"bspline\",\"degree\":" #p ",\"count\":" #n                                  \
    "},\"v\":{\"type\":\"bspline\",\"degree\":" #p ",\"count\":" #n "},"

static double figure(const taut_certificate *certificate, const char *name)
{
    return taut_record_number(taut_record_get(taut_certificate_figures(certificate), name));
}

/* The energy of a film whose claims hold. */
static double energy_of(const char *text)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_certificate *proof = NULL;
    taut_error error = {.status = TAUT_OK};
    double energy = NAN;

    if (taut_problem_read_text(text, strlen(text), "text", &problem, &error) == TAUT_OK &&
        taut_make(problem, NULL, &model, &error) == TAUT_OK &&
        taut_certify(model, problem, NULL, &proof, &error) == TAUT_OK) {
        for (int k = 0; k < taut_certificate_claim_count(proof); k++) {
            const taut_claim *claim = taut_certificate_claim(proof, k);
            CHECK(claim->holds == TAUT_TRUE || strcmp(claim->claim, "least") == 0, "%s: %g",
                  claim->claim, claim->residual);
        }
        energy = figure(proof, "energy");
    }
    CHECK(error.status == TAUT_OK, "%s: %s", error.where, error.message);
    taut_certificate_free(proof);
    taut_model_free(model);
    taut_problem_free(problem);
    return energy;
}

/* A flat sail of three corners: its area is the triangle's less three segments of radius T / s. */
static double triangle_energy(const double corners[3][2], double force)
{
    double energy = 0;
    for (int k = 0; k < 3; k++) {
        const double *a = corners[k], *b = corners[(k + 1) % 3];
        const double half = asin(hypot(b[0] - a[0], b[1] - a[1]) / (2 * force));
        energy += 0.5 * (a[0] * b[1] - a[1] * b[0]) + 2 * force * force * half -
                  force * force * (half - sin(half) * cos(half));
    }
    return energy;
}

static void test_triangles(void)
{
    const double corners[3][2] = {{0, 0}, {2, 0}, {1, 1.8}};
    const double sail = triangle_energy(corners, 3);
    const char *const poles[] = {
        FILM("\"corners\":{\"u1v0\":[2,0,0],\"u1v1\":[1,1.8,0]},\"edges\":{\"u0\":{\"pole\":[0,0,0]"
             "},\"u1\":" CABLE("3") ",\"v0\":" CABLE("3") ",\"v1\":" CABLE("3") "}"),
        FILM("\"corners\":{\"u0v0\":[0,0,0],\"u0v1\":[0,0,0],\"u1v0\":[2,0,0],\"u1v1\":[1,1.8,0]},"
             "\"edges\":{\"u0\":{\"pole\":null},\"u1\":" CABLE("3") ",\"v0\":" CABLE(
                 "3") ",\"v1\":" CABLE("3") "}"),
        FILM("\"corners\":{\"u0v1\":[2,0,0],\"u1v1\":[1,1.8,0]},\"edges\":{\"v0\":{\"pole\":[0,0,0]"
             "},\"v1\":" CABLE("3") ",\"u0\":" CABLE("3") ",\"u1\":" CABLE("3") "}"),
        FILM("\"patches\":[{\"name\":\"a\",\"corners\":{\"u1v0\":[2,0,0],\"u1v1\":[1,1.8,0]},"
             "\"edges\":{\"u0\":{\"pole\":[0,0,0]},\"u1\":" CABLE("3") ",\"v0\":" CABLE(
                 "3") ",\"v1\":" CABLE("3") "}}]")};

    for (size_t k = 0; k < sizeof poles / sizeof *poles; k++) {
        CHECK_NEAR(energy_of(poles[k]), sail, 2e-11, "sail %d", (int)k);
    }
    CHECK_NEAR(energy_of(FILM("\"corners\":{\"u1v0\":[2,0,0],\"u1v1\":[1,1.8,0]},"
                              "\"edges\":{\"u0\":{\"pole\":[0,0,0]}}")),
               1.8, 1e-14, "triangle");
    /* a quarter of a disc between mirrors, its tip found; the arc is fitted */
    CHECK_NEAR(energy_of(FILM("\"edges\":{\"u0\":{\"pole\":null},\"u1\":{\"fixed\":{\"arc\":[[2,0,"
                              "0],[1.4142135623730951,1.4142135623730951,0],[0,2,0]]}},"
                              "\"v0\":" SLIDE(0, 1, 0) ",\"v1\":" SLIDE(1, 0, 0) "}")),
               acos(-1), 1e-10, "quarter of a disc");
}

/* A sail of three corners in space is that of the quad layout of three curves' sides. */
static void test_space(void)
{
    static const char tip[] =
        FILM(BASES(4, 16) "\"corners\":{\"u1v0\":[2,0,0],\"u1v1\":[0,2,0]},\"edges\":{\"u0\":{"
                          "\"pole\":[0,0,1]},\"u1\":{\"fixed\":{\"arc\":[[2,0,0],[1.5,1.5,0.3],[0,"
                          "2,0]]}}}");
    static const char curves[] =
        FILM("\"degree\":4,\"count\":16,\"curves\":[{\"arc\":[[2,0,0],[1.5,1.5,0.3],[0,2,0]]},{"
             "\"line\":[[0,2,0],[0,0,1]]},{\"line\":[[0,0,1],[2,0,0]]}]");

    CHECK_NEAR(energy_of(tip), energy_of(curves), 2e-9, "two layouts");
}

#define TIP(pole, corners, beside)                                                                 \
    FILM("\"corners\":{" corners "\"u1v0\":[2,0,0],\"u1v1\":[1,1.8,0]},\"edges\":{\"u0\":{"        \
         "\"pole\":" pole "},\"v0\":" beside ",\"v1\":" beside "}")

static void test_refused(void)
{
    check_document_refused(TIP("[0,0,0]", "\"u0v0\":[0,0,1],", "\"fixed\""), TAUT_BAD_INPUT,
                           "corner-conflict", "/edges/u0/pole");
    check_document_refused(TIP("[0,0,0]", "\"u0v1\":null,", "\"fixed\""), TAUT_BAD_INPUT,
                           "corner-conflict", "/edges/u0/pole");
    check_document_refused(TIP("null", "\"u0v0\":[0,0,0],\"u0v1\":[0,0,1],", "\"fixed\""),
                           TAUT_BAD_INPUT, "corner-conflict", "/corners/u0v1");
    check_document_refused(TIP("[0,0]", "", "\"fixed\""), TAUT_BAD_INPUT, "type", "/edges/u0/pole");
    check_document_refused(TIP("null", "", "\"fixed\""), TAUT_BAD_INPUT, "corner-missing",
                           "/edges/v0");
    check_document_refused(TIP("null", "", CABLE("3")), TAUT_NO_SOLUTION, "no-corner", "/edges/u0");
    check_document_refused(TIP("[0,0,0]", "", SLIDE(0, 0, 1)), TAUT_NO_SOLUTION, "point-support",
                           "/edges/u0");
    check_document_refused(
        FILM("\"seams\":[[\"u0\",\"u1\"]],\"edges\":{\"v0\":{\"pole\":[0,0,1]},\"v1\":{"
             "\"fixed\":{\"circle\":{\"center\":[0,0,0],\"normal\":[0,0,1],\"radius\":1}}"
             "}}"),
        TAUT_NO_SOLUTION, "point-support", "/edges/v0/pole");
}

/* Three sheets from the line that they share to arcs between its ends. */
static double book_energy(int degree, int count, const double angles[3], const double radii[3])
{
    char text[4096];
    int used = snprintf(text, sizeof text, "{\"taut\":1,\"construct\":\"film\",\"patches\":[");
    for (int k = 0; k < 3; k++) {
        const double angle = angles[k] * acos(-1) / 180;
        used += snprintf(
            text + used, sizeof text - (size_t)used,
            "%s{\"name\":\"s%d\",\"u\":{\"type\":\"bspline\",\"degree\":%d,\"count\":%d},\"v\":{"
            "\"type\":\"bspline\",\"degree\":%d,\"count\":%d},\"edges\":{\"u1\":{\"fixed\":{"
            "\"arc\":[[0,"
            "0,-1],[%.17g,%.17g,0],[0,0,1]]}},\"v0\":{\"pole\":[0,0,-1]},\"v1\":{\"pole\":[0,0,1]}}"
            "}",
            k > 0 ? "," : "", k, degree, count, degree, count, radii[k] * cos(angle),
            radii[k] * sin(angle));
    }
    (void)snprintf(text + used, sizeof text - (size_t)used,
                   "],\"seams\":[[\"s0.u0\",\"s1.u0\",\"s2.u0\"]]}");
    return energy_of(text);
}

static void test_books(void)
{
    const double even[3] = {0, 120, 240}, ones[3] = {1, 1, 1};
    const double angles[3] = {0, 100, 230}, radii[3] = {1.2, 0.9, 0.7};
    CHECK_NEAR(book_energy(5, 10, even, ones), 1.5 * acos(-1), 1e-9, "three half discs");
    CHECK_NEAR(book_energy(4, 8, angles, radii), book_energy(5, 12, angles, radii), 2e-5,
               "three sheets on two spaces");
}

int main(void)
{
    test_triangles();
    test_space();
    test_books();
    test_refused();
    return check_failures != 0;
}
