/* test_along.c -- cables of all laws on films of many patches, and cables along several edges, against closed forms. */
#include "check.h"
#include "refused.h"

#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define B(p, n) "{\"type\":\"bspline\",\"degree\":" #p ",\"count\":" #n "}"
enum { ROOM = 6000 };

/* A square sail of side 2 in two patches, whose cables south and north each run along both of them. */
static const char square[] =
    "{\"taut\":1,\"construct\":\"film\",\"patches\":[{\"name\":\"l\",\"u\":" B(4, 8) ",\"v\":" B(
        4,
        12) ",\"corners\":{\"u0v0\":[0,0,0],\"u0v1\":[0,2,0]},\"edges\":{\"u0\":{\"cable\":{%s}}}}"
            ",{\"name\":\"r\",\"u\":" B(4, 8) ",\"v\":" B(
                4, 12) ",\"corners\":{\"u1v0\":[2,0,0],\"u1v1\":[2,2,0]},\"edges\":{\"u1\":{"
                       "\"cable\":{%s}}}}],\"seams\":[[\"l.u1\",\"r.u0\"]],\"cables\":[{"
                       "\"name\":\"south\",\"along\":[\"l.v0\",\"r.v0\"],%s},{\"along\":[\"-r."
                       "v1\",\"-l.v1\"],%s}]}";

/* Half of a ring: its lower edge an arc, the upper a cable in a plane. */
#define HALF(name, q)                                                                              \
    "{\"name\":\"" name "\",\"u\":" B(4, 12) ",\"v\":" B(                                          \
        4,                                                                                         \
        10) ",\"corners\":{\"u0v1\":" PLANE "0.8,0,0.3]},\"u1v1\":" PLANE                          \
            "-0.8,0,0.3]}},\"edges\":{\"v0\":{\"fixed\":{\"arc\":[[1,0,0],"                        \
            "[0," q                                                                                \
            ",0],[-1,0,0]]}},\"v1\":{\"cable\":{%s},\"plane\":{\"point\":[0,0,0.3],\"normal\":["   \
            "0,0,1]}}}}"
#define PLANE "{\"plane\":{\"point\":[0,0,0.3],\"normal\":[0,0,1]},\"near\":["
static const char ring[] = "{\"taut\":1,\"construct\":\"film\",\"patches\":[" HALF(
    "f", "1") "," HALF("b", "-1") "],\"seams\":[[\"f.u0\",\"b.u0\"],[\"f.u1\",\"b.u1\"]]}";

/* A square sail of one patch by one or two cables. */
static const char lone[] =
    "{\"taut\":1,\"construct\":\"film\",\"corners\":{\"u0v0\":[0,0,0],\"u1v0\":[2,0,0],\"u0v1\":["
    "0,2,0],\"u1v1\":[2,2,0]},%s\"cables\":[%s]}";

/* The example film-tent, whose cables run along two edges each. */
#define QUARTER(name, a, b, corner)                                                                \
    "{\"name\":\"" name                                                                            \
    "\",\"u\":" B(4, 9) ",\"v\":" B(4, 9) ",\"corners\":{\"u0v0\":[0,0,1],"                        \
                                          "\"u1v0\":{\"near\":[" a ",0.15]},\"u1v1\":[" corner     \
                                          ",0],\"u0v1\":{\"near\":[" b ",0.15]}}}"
static const char tent[] = "{\"taut\":1,\"construct\":\"film\",\"patches\":[" QUARTER(
    "a", "0.7,0", "0,0.7",
    "1,1") "," QUARTER("b", "0,0.7", "-0.7,0",
                       "-1,1") "," QUARTER("c", "-0.7,0", "0,-0.7",
                                           "-1,-1") "," QUARTER("d", "0,-0.7", "0.7,0",
                                                                "1,-1") "],"
                                                                        "\"seams\":[[\"a."
                                                                        "u0\",\"b.v0\"],["
                                                                        "\"b.u0\",\"c.v0\"],"
                                                                        "[\"c.u0\",\"d.v0\"],"
                                                                        "[\"d.u0\",\"a.v0\"]"
                                                                        "],\"cables\":[{"
                                                                        "\"along\":[\"-c.v0"
                                                                        "\",\"a.v0\"],%s},{"
                                                                        "\"along\":[\"-c.u0"
                                                                        "\",\"a.u0\"],%s},{"
                                                                        "\"along\":[\"-d.v1"
                                                                        "\",\"a.u1\"],%s},{"
                                                                        "\"along\":[\"-a.v1"
                                                                        "\",\"b.u1\"],%s},{"
                                                                        "\"along\":[\"-b.v1"
                                                                        "\",\"c.u1\"],%s},{"
                                                                        "\"along\":[\"-c.v1"
                                                                        "\",\"d.u1\"],%s}]}";

static const taut_record *find_figure(const taut_certificate *certificate, const char *name)
{
    return taut_record_get(taut_certificate_figures(certificate), name);
}

static double at(const taut_record *list, size_t k)
{
    return taut_record_number(taut_record_at(list, k));
}

/* Makes and proves; the certificate, which holds. */
static taut_certificate *prove(const char *text, const char *what)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_error said = {.status = TAUT_OK};

    CHECK(taut_problem_read_text(text, strlen(text), "text", &problem, &said) == TAUT_OK, "%s: %s",
          what, said.message);
    CHECK(taut_make(problem, NULL, &model, &said) == TAUT_OK, "%s: %s", what, said.message);
    CHECK(taut_certify(model, problem, NULL, &certificate, &said) == TAUT_OK, "%s: %s", what,
          said.message);
    CHECK(taut_certificate_holds(certificate) == TAUT_TRUE, "%s", what);
    taut_model_free(model);
    taut_problem_free(problem);
    return certificate;
}

static void check_all(const taut_certificate *certificate, const char *figure, size_t count,
                      const double *expected, double error, const char *what)
{
    const taut_record *list = find_figure(certificate, figure);
    CHECK(list != NULL && taut_record_count(list) == count, "%s: %s", what, figure);
    for (size_t k = 0; list != NULL && k < count; k++) {
        CHECK_NEAR(at(list, k), expected[k], error, "%s: %s %d", what, figure, (int)k);
    }
}

/* Four cables of the same law: forces, lengths and energy. */
static void check_square(const char *law, double force, double length, double energy, double error)
{
    const double forces[4] = {force, force, force, force},
                 lengths[4] = {length, length, length, length};
    char text[ROOM];

    snprintf(text, sizeof text, square, law, law, law, law);
    taut_certificate *found = prove(text, law);
    check_all(found, "tensions", 4, forces, error, law);
    check_all(found, "lengths", 4, lengths, error, law);
    CHECK_NEAR(taut_record_number(find_figure(found, "energy")), energy, error, "%s", law);
    taut_certificate_free(found);
}

/* Arcs of radius 2 and 60 degrees; of the elastic law R = EA (L(R) - L0) / L0, solved to 15 digits. */
static void test_square(void)
{
    const double pi = acos(-1), area = 4 - 8 * (pi / 3 - sqrt(3.0) / 2);
    check_square("\"force\":2", 2, 2 * pi / 3, area + 16 * pi / 3, 1e-9);
    check_square("\"length\":2.0943951023931953", 2, 2 * pi / 3, area, 1e-9);
    check_square("\"sag\":0.13397459621556135", 2, 2 * pi / 3, area, 1e-9);
    check_square("\"unstressed\":2.05,\"stiffness\":40", 1.7042443219206245, 2.13734252149843201,
                 2.53266887213592824, 5e-9);
}

/* One cable along two edges has one length: by symmetry twice that of each; one that closes likewise. */
static void test_lone(void)
{
    const double pi = acos(-1), area = 4 - 8 * (pi / 3 - sqrt(3.0) / 2);
    const double two[2] = {2, 2}, twice[2] = {4 * pi / 3, 4 * pi / 3}, whole = 8 * pi / 3;
    char text[ROOM];

    snprintf(text, sizeof text, lone, "",
             "{\"along\":[\"v0\",\"u1\"],\"force\":2},{\"name\":\"x\",\"along\":[\"-v1\",\"-u0\"],"
             "\"length\":4.1887902047863906}");
    taut_certificate *found = prove(text, "two cables");
    check_all(found, "tensions", 2, two, 1e-9, "two cables");
    check_all(found, "lengths", 2, twice, 1e-9, "two cables");
    CHECK_NEAR(taut_record_number(find_figure(found, "energy")), area + 8 * pi / 3, 1e-9, "two");
    taut_certificate_free(found);
    snprintf(text, sizeof text, lone, "",
             "{\"along\":[\"v0\",\"u1\",\"-v1\",\"-u0\"],\"length\":8.3775804095727811}");
    found = prove(text, "one cable");
    check_all(found, "tensions", 1, two, 1e-9, "one cable");
    check_all(found, "lengths", 1, &whole, 1e-12, "one cable");
    taut_certificate_free(found);
}

/* The ring cable of the catenoid of example 6: radius 0.812743518286946649, area 2.004664184976782615. */
static void test_ring(void)
{
    const double length = 0.5 * 5.106618132605986741, force = 0.3;
    const double forces[2] = {force, force}, lengths[2] = {length, length};
    static const char *const laws[2] = {"\"force\":0.3", "\"length\":2.5533090663029934"};
    char text[ROOM];

    for (int k = 0; k < 2; k++) {
        snprintf(text, sizeof text, ring, laws[k], laws[k]);
        taut_certificate *found = prove(text, laws[k]);
        check_all(found, "tensions", 2, forces, 1e-8, laws[k]);
        check_all(found, "lengths", 2, lengths, 1e-8, laws[k]);
        CHECK_NEAR(taut_record_number(find_figure(found, "area")), 2.004664184976782615, 1e-8, "%s",
                   laws[k]);
        taut_certificate_free(found);
    }
}

/* Cables by forces; then by the lengths that these made, and by springs that are drawn to them: the same film each time. */
static void test_tent(void)
{
    const double forces[6] = {1, 1, 3, 3, 3, 3};
    char text[ROOM], laws[6][128];
    double lengths[6], lowest[3];

    for (int k = 0; k < 6; k++) {
        snprintf(laws[k], sizeof laws[k], "\"force\":%.0f", forces[k]);
    }
    snprintf(text, sizeof text, tent, laws[0], laws[1], laws[2], laws[3], laws[4], laws[5]);
    taut_certificate *found = prove(text, "tent");
    CHECK_NEAR(taut_record_number(find_figure(found, "energy")), 33.037128872, 1e-8, "tent");
    const taut_record *made = find_figure(found, "lengths");
    for (size_t k = 0; k < 6; k++) {
        lengths[k] = at(made, k);
    }
    lowest[2] = taut_record_number(find_figure(found, "lowest_eigenvalue"));
    taut_certificate_free(found);
    for (int law = 0; law < 2; law++) {
        for (int k = 0; k < 6; k++) {
            if (law == 0) {
                snprintf(laws[k], sizeof laws[k], "\"length\":%.17g", lengths[k]);
            } else {
                snprintf(laws[k], sizeof laws[k], "\"unstressed\":%.17g,\"stiffness\":%.17g",
                         0.9 * lengths[k], 9 * forces[k]);
            }
        }
        snprintf(text, sizeof text, tent, laws[0], laws[1], laws[2], laws[3], laws[4], laws[5]);
        found = prove(text, law == 0 ? "tent by lengths" : "tent by springs");
        check_all(found, "tensions", 6, forces, 5e-8, laws[0]);
        check_all(found, "lengths", 6, lengths, 5e-9, laws[0]);
        lowest[law] = taut_record_number(find_figure(found, "lowest_eigenvalue"));
        taut_certificate_free(found);
    }
    /* What is kept leaves fewer ways, and a spring resists: forces are the least stable, then springs, then lengths. */
    CHECK(lowest[2] < 0.99 * lowest[1] && lowest[1] < lowest[0], "%.9g, %.9g, %.9g", lowest[2],
          lowest[1], lowest[0]);
}

/* A film by one length is none by another, though it is at rest by that which it has. */
static void test_other(void)
{
    static const char *const lengths[2] = {"8.4", "8.400001"};
    taut_problem *problems[2] = {NULL, NULL};
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    char text[ROOM], cable[128];

    for (int k = 0; k < 2; k++) {
        snprintf(cable, sizeof cable, "{\"along\":[\"v0\",\"u1\",\"-v1\",\"-u0\"],\"length\":%s}",
                 lengths[k]);
        snprintf(text, sizeof text, lone, "", cable);
        CHECK(taut_problem_read_text(text, strlen(text), "text", &problems[k], NULL) == TAUT_OK,
              "%s", text);
    }
    CHECK(taut_make(problems[0], NULL, &model, NULL) == TAUT_OK, "made");
    CHECK(taut_certify(model, problems[1], NULL, &certificate, NULL) == TAUT_OK, "certified");
    for (int k = 0; k < taut_certificate_claim_count(certificate); k++) {
        const taut_claim *claim = taut_certificate_claim(certificate, k);
        if (strcmp(claim->claim, "length") == 0) {
            CHECK(claim->holds == TAUT_FALSE && strcmp(claim->where, "cable-0") == 0, "%s",
                  claim->where);
            CHECK_NEAR(claim->residual, 1e-6 / 8.400001, 1e-12, "length");
        } else if (strcmp(claim->claim, "stationary") == 0) {
            CHECK(claim->holds == TAUT_TRUE, "at rest");
        }
    }
    taut_certificate_free(certificate);
    taut_model_free(model);
    taut_problem_free(problems[0]);
    taut_problem_free(problems[1]);
}

static void test_refused(void)
{
    static const struct {
        const char *edges, *cables;
        taut_status status;
        const char *reason, *where;
    } rows[] = {
        {"", "{\"along\":[\"v0\"]}", TAUT_BAD_INPUT, "missing", "/cables/0"},
        {"", "{\"along\":[\"v0\"],\"force\":1,\"length\":3}", TAUT_BAD_INPUT, "conflict",
         "/cables/0"},
        {"", "{\"along\":[],\"force\":1}", TAUT_BAD_INPUT, "size", "/cables/0/along"},
        {"", "{\"along\":[\"v2\"],\"force\":1}", TAUT_BAD_INPUT, "name", "/cables/0/along/0"},
        {"", "{\"along\":[\"v0\",\"v0\"],\"force\":1}", TAUT_BAD_INPUT, "edge-conflict",
         "/cables/0/along/1"},
        {"", "{\"along\":[\"v0\"],\"force\":1},{\"along\":[\"-v0\"],\"force\":1}", TAUT_BAD_INPUT,
         "edge-conflict", "/cables/1/along/0"},
        {"\"edges\":{\"v0\":{\"cable\":{\"force\":2}}},", "{\"along\":[\"v0\"],\"force\":1}",
         TAUT_BAD_INPUT, "edge-conflict", "/cables/0/along/0"},
        {"\"edges\":{\"v0\":\"fixed\"},", "{\"along\":[\"v0\"],\"force\":1}", TAUT_BAD_INPUT,
         "edge-conflict", "/cables/0/along/0"},
        {"", "{\"along\":[\"v0\",\"v1\"],\"force\":1}", TAUT_BAD_INPUT, "curve-ends",
         "/cables/0/along/1"},
        {"", "{\"along\":[\"v0\"],\"length\":2}", TAUT_NO_SOLUTION, "cable-too-short",
         "/cables/0/length"},
        {"", "{\"along\":[\"v0\",\"u1\",\"-v1\",\"-u0\"],\"sag\":0.1}", TAUT_BAD_INPUT, "value",
         "/cables/0/sag"},
        {"", "{\"along\":[\"v0\"],\"force\":1e9}", TAUT_BAD_INPUT, "value", "/cables/0/force"},
        {"",
         "{\"name\":\"a\",\"along\":[\"v0\"],\"force\":1},{\"name\":\"a\",\"along\":[\"u0\"],"
         "\"force\":1}",
         TAUT_BAD_INPUT, "name", "/cables/1/name"},
    };
    char text[ROOM];

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        snprintf(text, sizeof text, lone, rows[k].edges, rows[k].cables);
        check_document_refused(text, rows[k].status, rows[k].reason, rows[k].where);
    }
    snprintf(text, sizeof text, square, "\"force\":2", "\"length\":1.5", "\"force\":2",
             "\"force\":2");
    check_document_refused(text, TAUT_NO_SOLUTION, "cable-too-short",
                           "/patches/1/edges/u1/cable/length");
    snprintf(text, sizeof text, ring, "\"sag\":0.1", "\"force\":0.3");
    check_document_refused(text, TAUT_BAD_INPUT, "value", "/patches/0/edges/v1/cable/sag");
}

int main(void)
{
    test_square();
    test_lone();
    test_ring();
    test_tent();
    test_other();
    test_refused();
    return check_failures != 0;
}
