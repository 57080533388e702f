/* test_balance.c -- the figure `balance` of films of many patches: closed forms of flat sheets that are not at rest, certified as
 * what they were not made as; and films at rest, on spaces that grow finer. */
#include "certificates.h"
#include "check.h"
#include "documents.h"
#include "problem/problem.h"
#include "taut/construct.h"
#include "taut/read.h"

#include <math.h>

#define PATCH(name, corners, more)                                                                 \
    "{\"name\":\"" name "\",\"u\":{\"type\":\"bspline\",\"degree\":2,\"count\":4},"                \
    "\"v\":{\"type\":\"bspline\",\"degree\":2,\"count\":4},\"corners\":{" corners "}" more "}"
#define CORNERS(a, b, c, d) "\"u0v0\":" a ",\"u1v0\":" b ",\"u0v1\":" c ",\"u1v1\":" d
#define FILM(a, b, seam, more)                                                                     \
    "{\"taut\":1,\"construct\":\"film\",\"accept\":\"stationary\",\"patches\":[" a "," b           \
    "],\"seams\":[" seam "]" more "}"
/* The unit square, and one beside it whose last corner is somewhere. */
#define LEFT PATCH("a", CORNERS("[0,0,0]", "[1,0,0]", "[0,1,0]", "[1,1,0]"), "")
#define BESIDE(last, more) PATCH("b", CORNERS("[1,0,0]", "[2,0,0]", "[1,1,0]", last), more)
#define SEAM "[\"a.u1\",\"b.u0\"]"
#define U1(what) ",\"edges\":{\"u1\":" what "}"
#define AT "\"point\":[2,0,0],\"normal\":"

/* A film as one document makes it, and another has it. */
static double balance_of(const char *made, const char *asked)
{
    taut_problem *first = problem_read(made), *second = problem_read(asked);
    taut_model *model = NULL;
    taut_certificate *proof = NULL;
    taut_error error = {.status = TAUT_OK};

    CHECK(taut_make(first, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_certify(model, second, NULL, &proof, &error) == TAUT_OK, "%s", error.message);
    const double balance = figure_of(proof, "balance");
    taut_certificate_free(proof);
    taut_model_free(model);
    taut_problem_free(first);
    taut_problem_free(second);
    return balance;
}

/* Along all that is held but the seam and b's u1 the sheets of tension 1 draw with (1, 0, 0) outwards, 5 in all. */
static void test_flat(void)
{
    const char *made = FILM(LEFT, BESIDE("[2,1,0]", ""), SEAM, "");
    const struct {
        const char *what, *asked;
        double expected;
    } rows[] = {
        {"at rest", FILM(LEFT, BESIDE("[2,1,0]", ""), SEAM, ""), 0},
        {"of two tensions", FILM(LEFT, BESIDE("[2,1,0]", ",\"tension\":2"), SEAM, ""), 1. / 9},
        {"under pressure",
         FILM(LEFT, BESIDE("[2,1,0]", ""), SEAM,
              ",\"cells\":[{\"sides\":[\"a\",\"b\"],\"pressure\":0.1}]"),
         0.2 / 6.2},
        {"under pressure on both sides",
         FILM(LEFT, BESIDE("[2,1,0]", ""), SEAM,
              ",\"cells\":[{\"sides\":[\"a\",\"b\"],\"pressure\":0.1},"
              "{\"sides\":[\"-a\",\"-b\"],\"pressure\":0.04}]"),
         0.12 / 6.12},
        {"slides, held square",
         FILM(LEFT, BESIDE("[2,1,0]", U1("{\"slide\":{" AT "[1,0,0]}}")), SEAM, ""), 0},
        {"slides, held aslant",
         FILM(LEFT, BESIDE("[2,1,0]", U1("{\"slide\":{" AT "[1,0,1]}}")), SEAM, ""),
         sqrt(0.5) / (5 + sqrt(0.5))},
        {"a straight cable",
         FILM(LEFT, BESIDE("[2,1,0]", U1("{\"cable\":{\"force\":3}}")), SEAM, ""), 1. / 11},
        {"a straight cable in a plane across",
         FILM(LEFT, BESIDE("[2,1,0]", U1("{\"cable\":{\"force\":3},\"plane\":{" AT "[1,0,0]}}")),
              SEAM, ""),
         0},
        {"a straight cable in the film's plane",
         FILM(LEFT, BESIDE("[2,1,0]", U1("{\"cable\":{\"force\":3},\"plane\":{" AT "[0,0,1]}}")),
              SEAM, ""),
         1. / 11},
        {"threads", FILM(LEFT, BESIDE("[2,1,0]", ",\"force_density\":[2.5,0.7]"), SEAM, ""),
         1.5 / 6.9},
        {"a cable along the seam",
         FILM(LEFT, BESIDE("[2,1,0]", ""), "{\"edges\":" SEAM ",\"cable\":{\"force\":7}}", ""), 0},
    };

    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        CHECK_NEAR(balance_of(made, rows[k].asked), rows[k].expected, 1e-14, "%s", rows[k].what);
    }
}

/* Of a cable that ends on a line, or in a plane, only what these take counts: b's last corner is (3, 1, 0). */
static void test_glides(void)
{
    const double r = 3 / sqrt(2), sum = hypot(1 + r, 1);
#define GLIDES(corner)                                                                             \
    FILM(LEFT,                                                                                     \
         BESIDE(corner, ",\"edges\":{\"u1\":{\"cable\":{\"force\":3}},\"v1\":{\"slide\":"          \
                        "{\"point\":[0,1,0],\"normal\":[0,1,0]}}}"),                               \
         SEAM, "")
    const char *made = FILM(LEFT, BESIDE("[3,1,0]", ""), SEAM, "");

    CHECK_NEAR(balance_of(made, GLIDES("{\"near\":[3,1,0]}")), sum / (6 + 3 + r), 1e-14,
               "in a plane");
    CHECK_NEAR(balance_of(made, GLIDES("{\"line\":{\"point\":[0,1,0],\"direction\":[1,0,0]}}")),
               sum / (6 + 3 + r), 1e-14, "on a line");
    CHECK_NEAR(balance_of(made, GLIDES("[3,1,0]")), sqrt(2) / (6 + 6), 1e-14, "held");
#undef GLIDES
}

/* Films at rest: what remains is how far their tangents are off. Threads pull at a point that an edge is, too. */
static void test_rest(void)
{
#define CAP(u, v)                                                                                  \
    "{\"taut\":1,\"construct\":\"film\",\"u\":{\"type\":\"bspline\",\"degree\":4,\"count\":" u     \
    "},\"v\":{\"type\":\"bspline\",\"degree\":4,\"count\":" v "},\"seams\":[[\"u0\",\"u1\"]],"     \
    "\"edges\":{\"v0\":{\"fixed\":{\"circle\":{\"center\":[0,0,0],\"normal\":[0,0,1],"             \
    "\"radius\":1}}},\"v1\":{\"pole\":null}},\"cells\":[{\"sides\":[\"film\"],\"volume\":1}]}"
#define THREADS(n, edges)                                                                          \
    "{\"taut\":1,\"construct\":\"film\",\"u\":{\"type\":\"bspline\",\"degree\":4,\"count\":" n     \
    "},\"v\":{\"type\":\"bspline\",\"degree\":4,\"count\":" n "},\"force_density\":[1,0.5],"       \
    "\"corners\":{\"u1v0\":[2,0,0],\"u1v1\":[1,1.8,1]},\"edges\":{\"u0\":{\"pole\":[0,0,0]},"      \
    "\"v0\":" edges ",\"v1\":" edges "}}"
#define CABLE "{\"cable\":{\"force\":5}}"
    const char *const held = THREADS("8", "\"fixed\"");
    const double coarse = balance_of(THREADS("8", CABLE), THREADS("8", CABLE)),
                 fine = balance_of(THREADS("16", CABLE), THREADS("16", CABLE));

    CHECK_NEAR(balance_of(held, held), 0, 1e-14, "three edges that are held");
    CHECK(fine < 1e-3 && fine < coarse / 3, "threads and cables: %g, then %g", coarse, fine);
    CHECK_NEAR(balance_of(CAP("20", "10"), CAP("20", "10")), 0, 2e-6, "a cap of given volume");
#undef CAP
#undef THREADS
#undef CABLE
}

int main(void)
{
    test_flat();
    test_glides();
    test_rest();
    return check_failures != 0;
}
