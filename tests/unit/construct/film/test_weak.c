/* test_weak.c -- films of many patches whose cables are too weak, or whose forces cannot balance: what is said, against closed forms
 * and films of one patch. */
#include "check.h"
#include "refused.h"

#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT = 4000 };

#define BASIS(p, n) "{\"type\":\"bspline\",\"degree\":" #p ",\"count\":" #n "}"
#define PATCH(name, n, corners, edges)                                                             \
    "{\"name\":\"" name "\",\"u\":" n ",\"v\":" n ",\"corners\":{" corners "},\"edges\":{" edges   \
    "}}"

/* A sail over (0, 0) to (%1, %2) in two patches, the corners %3 high and low in turn, with cables of the force %4. */
#define CABLE "{\"cable\":{\"force\":%.17g}}"
static void write_two(char *text, const double size[2], double height, double force)
{
    snprintf(
        text, TEXT,
        "{\"taut\":1,\"construct\":\"film\",\"patches\":[" PATCH(
            "a", BASIS(3, 8), "\"u0v0\":[0,0,%.17g],\"u0v1\":[0,%.17g,%.17g]",
            "\"u0\":" CABLE) "," PATCH("b", BASIS(3, 8),
                                       "\"u1v0\":[%.17g,0,%.17g],\"u1v1\":[%.17g,%.17g,%.17g]",
                                       "\"u1\":" CABLE) "],\"seams\":[[\"a.u1\",\"b.u0\"]],"
                                                        "\"cables\":[{\"name\":\"s\",\"along\":["
                                                        "\"a.v0\",\"b.v0\"],\"force\":%.17g},"
                                                        "{\"name\":\"n\",\"along\":[\"a.v1\",\"b."
                                                        "v1\"],\"force\":%.17g}]}",
        height, size[1], -height, force, size[0], -height, size[0], size[1], height, force, force,
        force);
}

/* The same of one patch. */
static void write_one(char *text, const double size[2], double height, double force)
{
    snprintf(
        text, TEXT,
        "{\"taut\":1,\"construct\":\"film\",\"least\":false,\"u\":" BASIS(3, 11) ",\"v\":" BASIS(
            3, 8) ",\"corners\":{\"u0v0\":[0,0,%.17g],\"u1v0\":[%.17g,0,%.17g],"
                  "\"u0v1\":[0,%.17g,%.17g],\"u1v1\":[%.17g,%.17g,%.17g]},"
                  "\"edges\":{\"u0\":" CABLE ",\"u1\":" CABLE ",\"v0\":" CABLE ",\"v1\":" CABLE
                  "}}",
        height, size[0], -height, size[1], -height, size[0], size[1], height, force, force, force,
        force);
}

#define LAW "{\"cable\":{\"%s\":%.17g}}"
#define NEARLY_FLAT                                                                                \
    "{\"taut\":1,\"construct\":\"film\",\"least\":false,\"corners\":{\"u0v0\":[0,0,0],\"u1v0\":["  \
    "2,0,0],"                                                                                      \
    "\"u0v1\":[0,2,0],\"u1v1\":[2,2,1e-9]},\"edges\":{\"u0\":" LAW ",\"u1\":" LAW ",\"v0\":" LAW   \
    ",\"v1\":" LAW "}}"
#define ARC                                                                                        \
    "{\"taut\":1,\"construct\":\"film\",\"least\":false,\"corners\":{\"u0v0\":[0,0,0],\"u1v0\":["  \
    "2,0,0],"                                                                                      \
    "\"u0v1\":[0,2,0],\"u1v1\":[2,2,0]},\"edges\":{\"u0\":{\"fixed\":{\"arc\":[[0,0,0],[0.2,1,0]," \
    "[0,2,0]"                                                                                      \
    "]}},\"u1\":{\"cable\":{\"force\":6}},\"v0\":" CABLE ",\"v1\":" CABLE "}}"

static int holds(const char *text, const char *what)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_error said = {.status = TAUT_OK};
    int does = 0;

    CHECK(taut_problem_read_text(text, strlen(text), "text", &problem, &said) == TAUT_OK, "%s: %s",
          what, said.message);
    CHECK(taut_make(problem, NULL, &model, &said) == TAUT_OK, "%s: %s", what, said.message);
    if (model != NULL && taut_certify(model, problem, NULL, &certificate, &said) == TAUT_OK) {
        does = taut_certificate_holds(certificate) == TAUT_TRUE;
    }
    taut_certificate_free(certificate);
    taut_model_free(model);
    taut_problem_free(problem);
    return does;
}

/* T > c / sqrt 2 of a square, where neighbours touch in the corners; of 10 by 1 the long arcs meet, R = (25 + 1/4) / 1. */
static void test_flat(void)
{
    const struct {
        double size[2], force, least;
        const char *what;
    } rows[] = {{{2, 2}, 1.3, sqrt(2.0), "square"},
                {{2, 2}, 1.4141, sqrt(2.0), "square, nearly"},
                {{2, 2}, 0.2, sqrt(2.0), "square, below its chords"},
                {{10, 1}, 12, 25.25, "rectangle"}};
    char text[TEXT];

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        write_two(text, rows[k].size, 0, rows[k].force);
        const taut_error said = check_document_refused(text, TAUT_NO_SOLUTION, "cable-too-weak",
                                                       "/patches/0/edges/u0/cable/force");
        CHECK_NEAR(said.limit, rows[k].least, 1e-11 * rows[k].least, "%s", rows[k].what);
        CHECK(said.found == rows[k].force, "%s", rows[k].what);
    }
    write_two(text, rows[0].size, 0, 1.5);
    CHECK(holds(text, "square"), "a square sail of two patches above its least force");
}

/* In space: what is told is near to that of one patch, whatever was asked for, and a film has it. */
static void test_space(void)
{
    const double size[2] = {2, 2};
    char text[TEXT];

    write_one(text, size, 0.5, 1);
    const double one =
        check_document_refused(text, TAUT_NO_SOLUTION, "cable-too-weak", "/edges/u0/cable").limit;
    write_two(text, size, 0.5, 1);
    const double two = check_document_refused(text, TAUT_NO_SOLUTION, "cable-too-weak",
                                              "/patches/0/edges/u0/cable/force")
                           .limit;
    write_two(text, size, 0.5, 0.6);
    const double weak = check_document_refused(text, TAUT_NO_SOLUTION, "cable-too-weak",
                                               "/patches/0/edges/u0/cable/force")
                            .limit;
    CHECK_NEAR(two, one, 0.03 * one, "the least force of a saddle in two patches");
    CHECK_NEAR(weak, two, 0.005 * two, "the least force, asked for less");
    write_two(text, size, 0.5, two);
    CHECK(holds(text, "saddle"), "a saddle of the force that is told");
}

/* Neighbours that pass each other in a corner by 0.2 degrees, where no test of flat sails sees it: out of the plane by
 * 1e-9 of the size, by lengths too, and beside an edge that is held on an arc, of radius 2.6 over its chord 2, which leaves
 * a corner of acos(5 / 13): cables of 13 / 12 and more come clear of it. */
static void test_corner(void)
{
    char text[TEXT];

    snprintf(text, sizeof text, NEARLY_FLAT, "force", 1.4115, "force", 1.4115, "force", 1.4115,
             "force", 1.4115);
    const taut_error flat =
        check_document_refused(text, TAUT_NO_SOLUTION, "cable-too-weak", "/edges/u0/cable");
    CHECK(flat.limit > sqrt(2.0) && flat.limit < 1.416, "%s", flat.message);
    snprintf(text, sizeof text, NEARLY_FLAT, "length", 2.2215, "length", 2.2215, "length", 2.2215,
             "length", 2.2215);
    const taut_error given =
        check_document_refused(text, TAUT_NO_SOLUTION, "cable-too-weak", "/edges/u0/cable");
    CHECK(given.limit < 2.221441470 && given.limit > 2.2204, "%s", given.message);
    snprintf(text, sizeof text, ARC, 1.083, 1.083);
    const taut_error arc =
        check_document_refused(text, TAUT_NO_SOLUTION, "cable-too-weak", "/edges/u1/cable");
    const double least = 1.083 * arc.limit / arc.found;
    CHECK(least > 13 / 12.0 && least < 1.0855, "%s", arc.message);
    snprintf(text, sizeof text, ARC, 1.0836, 1.0836);
    CHECK(holds(text, "arc"), "beside an arc");
    for (int k = 0; k < 2; k++) { /* of two patches, by 0.3 and 0.1 degrees */
        const double size[2] = {2, 2};
        write_two(text, size, 1e-9, k == 0 ? 1.411 : 1.413);
        const taut_error two = check_document_refused(text, TAUT_NO_SOLUTION, "cable-too-weak",
                                                      "/patches/0/edges/u0/cable/force");
        CHECK_NEAR(two.limit, sqrt(2.0), 1e-3, "%s", two.message);
    }
}

/* Coarse nets whose own tangents are 0.2 degrees apart where their cables pass each other by 1.2: the least forces of flat sails,
 * c / sqrt 2 of a square and of 2 by 1.6 where sines of half angles over the force, 1 and 0.8, add up to a right angle. */
static void test_coarse_corner(void)
{
    const double sizes[2][2] = {{2, 2}, {2, 1.6}};
    char text[TEXT];

    for (int k = 0; k < 2; k++) {
        const double exact = 0.5 * sqrt(sizes[k][0] * sizes[k][0] + sizes[k][1] * sizes[k][1]);
        write_one(text, sizes[k], 1e-9, 0.99 * exact);
        const taut_error said =
            check_document_refused(text, TAUT_NO_SOLUTION, "cable-too-weak", "/edges/u0/cable");
        CHECK(said.limit > exact && said.limit < 1.002 * exact, "%s", said.message);
        write_one(text, sizes[k], 1e-9, 1.0002 * exact);
        CHECK(holds(text, "coarse"), "above the least force");
        write_two(text, sizes[k], 1e-9, 0.9998 * exact);
        const taut_error two = check_document_refused(text, TAUT_NO_SOLUTION, "cable-too-weak",
                                                      "/patches/0/edges/u0/cable/force");
        CHECK(two.limit > exact && two.limit < 1.005 * exact, "%s", two.message);
        write_two(text, sizes[k], 1e-9, 1.001 * exact);
        CHECK(holds(text, "coarse"), "two patches above the least force");
    }
}

#define WALL(name, tension, low)                                                                   \
    "{\"name\":\"" name "\",\"u\":" BASIS(2, 4) ",\"v\":" BASIS(                                   \
        2, 3) ",\"tension\":" tension ",\"corners\":{\"u1v0\":[" low ",0],\"u1v1\":[" low          \
              ",1]},\"edges\":{\"v0\":{"                                                           \
              "\"slide\":{\"point\":[0,0,0],\"normal\":[0,0,1]}},\"v1\":{\"slide\":{\"point\":["   \
              "0,0,1],\"normal\":[0,0,2]}}}}"
#define WALLS(tension, a, b, c)                                                                    \
    "{\"taut\":1,\"construct\":\"film\",\"patches\":[" WALL("a", tension, a) "," WALL(             \
        "b", "1", b) "," WALL("c", "1", c) "],\"seams\":[[\"a.u0\",\"b.u0\",\"c.u0\"]]}"

/* Fermat's point is in a corner of 120 degrees or more; with tensions, where the others draw less than that one holds: of two at
 * 90 degrees sqrt 2. */
static void test_walls(void)
{
    (void)check_document_refused(WALLS("1", "0,0", "1,0", "-0.51,0.866"), TAUT_NO_SOLUTION,
                                 "unbalanced", "/seams/0");
    CHECK(holds(WALLS("1", "0,0", "1,0", "-0.40,0.866"), "115 degrees"), "115 degrees");
    (void)check_document_refused(WALLS("1.42", "0,0", "1,0", "0,1"), TAUT_NO_SOLUTION, "unbalanced",
                                 "/seams/0");
    CHECK(holds(WALLS("1.3", "0,0", "1,0", "0,1"), "tensions"), "three tensions");
    const taut_error said = check_document_refused(WALLS("3", "0,0", "1,0", "0,1"),
                                                   TAUT_NO_SOLUTION, "unbalanced", "/seams/0");
    CHECK(said.found == 3 && said.limit == 2, "%s", said.message);
}

/* Two sheets of tensions 1 and 2 in one seam; two cables of forces 2 and 3 that meet where nothing holds them. */
static void test_balance(void)
{
    (void)check_document_refused(
        "{\"taut\":1,\"construct\":\"film\",\"patches\":[" PATCH(
            "a", BASIS(3, 5), "\"u0v0\":[0,0,0],\"u0v1\":[0,1,0],\"u1v0\":[1,0,0],\"u1v1\":[1,1,0]",
            "") ",{\"name\":\"b\",\"tension\":2,\"u\":" BASIS(3,
                                                              5) ",\"v\":" BASIS(3,
                                                                                 5) ","
                                                                                    "\"corners\":{"
                                                                                    "\"u1v0\":[2,0,"
                                                                                    "0],\"u1v1\":["
                                                                                    "2,1,0]}}],"
                                                                                    "\"seams\":[["
                                                                                    "\"a.u1\",\"b."
                                                                                    "u0\"]]}",
        TAUT_NO_SOLUTION, "unbalanced", "/seams/0");
    const taut_error said = check_document_refused(
        "{\"taut\":1,\"construct\":\"film\",\"patches\":[" PATCH(
            "a", BASIS(3, 6), "\"u0v0\":[0,0,0],\"u0v1\":[0,1,0],\"u1v1\":[1,1,0]",
            "\"v0\":{\"cable\":{\"force\":2}}") "," PATCH("b", BASIS(3, 6),
                                                          "\"u1v0\":[2,0,0],\"u1v1\":[2,1,"
                                                          "0]",
                                                          "\"v0\":{\"cable\":{\"force\":3}"
                                                          "}") "],\"seams\":[[\"a.u1\",\"b."
                                                               "u0\"]]}",
        TAUT_NO_SOLUTION, "unbalanced", "/patches/1/edges/v0/cable/force");
    CHECK(said.found == 3 && said.limit == 2, "%s", said.message);
}

/* A cable of given length beside a saddle of two patches. A message has the last length there is a film for, which is one number
 * whatever was asked for, near half a circle over the chord of 2; or, where the way up ends too, that it is more than that. */
static void test_lengths(void)
{
    static const char *const lengths[] = {"3", "3.3", "5", "6"};
    static const char document[] =
        "{\"taut\":1,\"construct\":\"film\",\"patches\":[{\"name\":\"a\",\"u\":{\"type\":"
        "\"bspline\","
        "\"degree\":4,\"count\":8},\"v\":{\"type\":\"bspline\",\"degree\":4,\"count\":8},"
        "\"corners\":{"
        "\"u0v0\":[0,0,0],\"u1v0\":[1,0,0],\"u0v1\":[0,2,0],\"u1v1\":[1,2,0.3]},\"edges\":{\"u0\":{"
        "\"cable\":{\"length\":%s}}}},{\"name\":\"b\",\"u\":{\"type\":\"bspline\",\"degree\":4,"
        "\"count\":"
        "8},\"v\":{\"type\":\"bspline\",\"degree\":4,\"count\":8},\"corners\":{\"u1v0\":[2,0,0],"
        "\"u1v1\":"
        "[2,2,0.3]}}],\"seams\":[[\"a.u1\",\"b.u0\"]]}";

    for (int k = 0; k < 4; k++) {
        char text[2000];
        taut_problem *problem = NULL;
        taut_model *model = NULL;
        taut_error error = {.status = TAUT_OK};
        snprintf(text, sizeof text, document, lengths[k]);
        CHECK(taut_problem_read_text(text, strlen(text), "text", &problem, &error) == TAUT_OK,
              "%s: %s", error.where, error.message);
        const taut_status status = taut_make(problem, NULL, &model, &error);
        if (k == 0) {
            CHECK(status == TAUT_OK, "a length of 3: %s", error.message);
        } else {
            const int folds = strcmp(error.reason, "folds") == 0;
            CHECK(folds || strcmp(error.reason, "cable-too-weak") == 0, "%s: %s", lengths[k],
                  error.message);
            CHECK(strcmp(error.where, "/patches/0/edges/u0/cable/length") == 0, "%s: %s",
                  lengths[k], error.where);
            CHECK_NEAR(error.found, atof(lengths[k]), 1e-12, "what is found");
            CHECK_NEAR(error.limit, 3.141592653589793, folds ? 1e-12 : 0.05, "%s", lengths[k]);
        }
        taut_model_free(model);
        taut_problem_free(problem);
    }
}

/* A ridge that is longer than the film draws it to: a film that pushes at it comes to no rest. */
static void test_slack(void)
{
    static const char roof[] = "{\"taut\":1,\"construct\":\"film\",\"patches\":[" PATCH(
        "a", BASIS(3, 6),
        "\"u0v0\":[-3,-2,0],\"u1v0\":[3,-2,0],\"u0v1\":[-2.2,0,1.5],\"u1v1\":[2.2,0,1.5]",
        "\"u0\":{\"cable\":{\"force\":3}},\"u1\":{\"cable\":{\"force\":3}},\"v0\":{\"cable\":{"
        "\"force\":6}}") "," PATCH("b", BASIS(3, 6),
                                   "\"u0v0\":[-3,2,0],\"u1v0\":[3,2,0],\"u0v1\":[-2.2,0,1.5],"
                                   "\"u1v1\":[2.2,0,1.5]",
                                   "\"u0\":{\"cable\":{\"force\":3}},\"u1\":{\"cable\":{\"force\":"
                                   "3}},\"v0\":{\"cable\":{\"force\":6}}") "],\"seams\":[{"
                                                                           "\"edges\":[\"a.v1\","
                                                                           "\"b.v1\"],\"cable\":{"
                                                                           "\"length\":%.17g}}]}";
    char text[TEXT];

    snprintf(text, TEXT, roof, 5.2);
    CHECK(holds(text, "ridge"), "a ridge that the film draws");
    snprintf(text, TEXT, roof, 5.788);
    const taut_error said =
        check_document_refused(text, TAUT_NO_SOLUTION, "cable-too-weak", "/seams/0/cable/length");
    CHECK(strstr(said.message, "slack") != NULL && strstr(said.message, "5.4") != NULL, "%s",
          said.message);
}

int main(void)
{
    test_slack();
    test_lengths();
    test_flat();
    test_space();
    test_corner();
    test_coarse_corner();
    test_walls();
    test_balance();
    return check_failures != 0;
}
