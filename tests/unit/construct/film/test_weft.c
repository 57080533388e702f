/* test_weft.c -- warp and weft on many patches, against closed forms. */
#include "check.h"

#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define B(p, n) "{\"type\":\"bspline\",\"degree\":" #p ",\"count\":" #n "}"
enum { ROOM = 5000 };

/* Half of a tube between unit circles at distance 1: over half a turn, so that along the turn the density is twice that of the whole,
 * and across it half. */
#define HALF(name, q)                                                                              \
    "{\"name\":\"" name "\",\"u\":" B(4, 12) ",\"v\":" B(                                          \
        4, 10) ",\"force_density\":["                                                              \
               "0.636619772367581344,3.14159265358979324],\"edges\":{\"v0\":{\"fixed\":{\"arc\":[" \
               "[1,0,0],[0," q ",0],[-1,0,0]]}},\"v1\":{\"fixed\":{\"arc\":[[1,0,1],[0," q         \
               ",1],[-1,0,1]]}}}}"
static const char tube[] = "{\"taut\":1,\"construct\":\"film\",\"patches\":[" HALF(
    "f", "1") "," HALF("b", "-1") "],\"seams\":[[\"f.u0\",\"b.u0\"],[\"f.u1\",\"b.u1\"]]}";

/* A strip of width 1 from x = 0 to x = 2 between planes: one part of tension 1, the other of threads, a = 2 and b = 3. Its seam at c:
 * c + a (2 - c)^2 / 2 + b / 2 is least where a (2 - c) = 1. */
#define SLIDES                                                                                     \
    "\"edges\":{\"v0\":{\"slide\":{\"point\":[0,0,0],\"normal\":[0,1,0]}},\"v1\":{\"slide\":{"     \
    "\"point\":[0,1,0],\"normal\":[0,1,0]}}}"
static const char strip[] =
    "{\"taut\":1,\"construct\":\"film\",\"patches\":[{\"name\":\"s\",\"u\":" B(3, 5) ",\"v\":" B(
        3, 4) ",\"corners\":{\"u0v0\":[0,0,0],\"u0v1\":[0,1,0],\"u1v0\":{\"near\":[0.8,0,0]},"
              "\"u1v1\":{\"near\":[0.8,1,0]}}," SLIDES
              "},{\"name\":\"t\",\"u\":" B(2, 3) ",\"v\":" B(
                  3, 4) ",\"corners\":{\"u1v0\":[2,0,0],\"u1v1\":[2,1,0]},%s," SLIDES
                        "}],\"seams\":[[\"s.u1\",\"t.u0\"]]}";

/* 1/2 by 1: s_u |x_u|^2 / |X_u|^2 |X_u x X_v| = 2 s_u |x_u|^2, and s_v / 2. */
#define REFERENCE                                                                                  \
    "\"reference\":{\"u\":" B(2, 3) ",\"v\":" B(                                                   \
        3, 4) ",\"points\":[[[0,0,0],[0,0.3333333333333333,0],[0,"                                 \
              "0.6666666666666666,0],[0,1,0]],[[0.25,0,0],[0.25,0.3333333333333333,0],[0.25,"      \
              "0.6666666666666666,0],[0.25,1,0]],[[0.5,0,0],[0.5,0.3333333333333333,0],[0.5,"      \
              "0.6666666666666666,0],[0.5,1,0]]]}"

/* Makes, proves: the certificate, which holds. */
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

static const taut_record *find_figure(const taut_certificate *certificate, const char *name)
{
    return taut_record_get(taut_certificate_figures(certificate), name);
}

static double number(const taut_certificate *certificate, const char *name)
{
    const taut_record *found = find_figure(certificate, name);
    return found != NULL ? taut_record_number(found) : NAN;
}

static double at(const taut_record *list, size_t i, size_t j)
{
    return taut_record_number(taut_record_at(taut_record_at(list, i), j));
}

/* r = r0 cosh(sqrt 2 (v - 1/2)), as of one patch; the circles' fit errs by 2e-9. */
static void test_tube(void)
{
    taut_certificate *found = prove(tube, "tube");
    CHECK_NEAR(number(found, "energy"), 8.55177442270630239, 4e-9, "energy");
    CHECK_NEAR(number(found, "area"), 6.01902441570783425, 4e-10, "area");
    CHECK(find_figure(found, "mean_curvature") == NULL, "threads have no mean curvature to be 0");
    CHECK(number(found, "seam_angle") < 1e-4, "seams: %g", number(found, "seam_angle"));
    taut_certificate_free(found);
}

static void check_strip(const char *threads)
{
    char text[ROOM];

    snprintf(text, sizeof text, strip, threads);
    taut_certificate *found = prove(text, threads);
    const taut_record *stress = find_figure(found, "stress");
    CHECK_NEAR(number(found, "energy"), 3.25, 1e-12, "%s", threads);
    CHECK_NEAR(taut_record_number(taut_record_at(find_figure(found, "areas"), 0)), 1.5, 1e-10, "%s",
               threads);
    for (size_t k = 0; stress != NULL && k < 2; k++) { /* a |x_u| / |x_v| = 1, b |x_v| / |x_u| */
        CHECK_NEAR(at(stress, 0, k), 1, 1e-10, "%s", threads);
        CHECK_NEAR(at(stress, 1, k), 6, 1e-9, "%s", threads);
    }
    CHECK(stress != NULL && number(found, "seam_angle") < 1e-10, "%s", threads);
    taut_certificate_free(found);
}

/* Makes: the model, whose claims hold or, of updates, are undecided. */
static taut_model *make_updated(const char *text, taut_certificate **certificate, const char *what)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_error said = {.status = TAUT_OK};

    CHECK(taut_problem_read_text(text, strlen(text), "text", &problem, &said) == TAUT_OK, "%s: %s",
          what, said.message);
    CHECK(taut_make(problem, NULL, &model, &said) == TAUT_OK, "%s: %s", what, said.message);
    CHECK(taut_certify(model, problem, NULL, certificate, &said) == TAUT_OK, "%s: %s", what,
          said.message);
    CHECK(taut_certificate_holds(*certificate) != TAUT_FALSE, "%s", what);
    for (int k = 0; k < taut_certificate_claim_count(*certificate); k++) {
        const taut_claim *claim = taut_certificate_claim(*certificate, k);
        CHECK(strcmp(claim->claim, "stationary") != 0 || claim->holds == TAUT_UNDECIDED, "%s",
              what);
    }
    taut_problem_free(problem);
    return model;
}

/* Threads twice as strong as the film beside them, on a reference of width L: they rest at L / 2, and at half of that after each
 * update. */
static void test_updates(void)
{
    char text[ROOM];
    taut_certificate *found = NULL;

    snprintf(text, sizeof text, strip, "\"updates\":2,\"prestress\":[2,6]," REFERENCE);
    taut_model *model = make_updated(text, &found, "a strip");
    CHECK_NEAR(taut_record_number(taut_record_at(find_figure(found, "areas"), 0)), 2 - 0.0625,
               1e-10, "its film");
    const taut_record *updates = taut_record_get(taut_model_details(model), "updates");
    CHECK(taut_record_count(updates) == 2, "two of them");
    CHECK_NEAR(taut_record_number(taut_record_at(updates, 0)), 0.125 / sqrt(5), 1e-10, "first");
    CHECK_NEAR(taut_record_number(taut_record_at(updates, 1)), 0.0625 / sqrt(5), 1e-10, "second");
    taut_certificate_free(found);
    taut_model_free(model);
}

static size_t write_half(const taut_model *model, int k, const char *arcs, int updates, char *text,
                         size_t room)
{
    const taut_surface *half = taut_model_surface(model, k);
    const double *points = taut_surface_points(half);
    size_t at = (size_t)snprintf(
        text, room,
        "%s{\"name\":\"%s\",\"u\":" B(4, 12) ",\"v\":" B(
            4, 10) ",\"prestress\":[1,1],\"updates\":%d,\"edges\":{%s},\"reference\":"
                   "{\"u\":" B(4, 12) ",\"v\":" B(4, 10) ",\"points\":[",
        k == 0 ? "" : ",", k == 0 ? "f" : "b", updates, arcs);
    for (int i = 0; i < 120; i++) {
        at += (size_t)snprintf(text + at, room - at, "%s[%.17g,%.17g,%.17g]%s",
                               i == 0        ? "["
                               : i % 10 == 0 ? ",["
                                             : ",",
                               points[3 * i], points[3 * i + 1], points[3 * i + 2],
                               i % 10 == 9 ? "]" : "");
    }
    return at + (size_t)snprintf(text + at, room - at, "]}}");
}

#define ARCS(q)                                                                                    \
    "\"v0\":{\"fixed\":{\"arc\":[[1,0,0],[0," q ",0],[-1,0,0]]}},"                                 \
    "\"v1\":{\"fixed\":{\"arc\":[[1,0,1],[0," q ",1],[-1,0,1]]}}"

/* Threads as strong along as across, and updates, from the orthotropic tube in two halves to the catenoid; of one half the reference is
 * updated less often, and it is a film of its last one. */
static void test_catenoid(void)
{
    enum { LONG = 40000 };
    static char text[LONG];
    taut_certificate *found = NULL;
    taut_problem *problem = NULL;
    taut_model *first = NULL;

    CHECK(taut_problem_read_text(tube, strlen(tube), "text", &problem, NULL) == TAUT_OK, "tube");
    CHECK(taut_make(problem, NULL, &first, NULL) == TAUT_OK, "tube");
    size_t at = (size_t)snprintf(text, LONG, "{\"taut\":1,\"construct\":\"film\",\"patches\":[");
    at += write_half(first, 0, ARCS("1"), 30, text + at, LONG - at);
    at += write_half(first, 1, ARCS("-1"), 26, text + at, LONG - at);
    snprintf(text + at, LONG - at, "],\"seams\":[[\"f.u0\",\"b.u0\"],[\"f.u1\",\"b.u1\"]]}");
    taut_model *model = make_updated(text, &found, "a catenoid");
    CHECK_NEAR(number(found, "area"), 5.99179697580228191, 3e-10, "catenoid");
    CHECK(taut_record_count(taut_record_get(taut_model_details(model), "updates")) == 30, "rounds");
    taut_certificate_free(found);
    taut_model_free(model);
    taut_model_free(first);
    taut_problem_free(problem);
}

static void refuse(const char *threads, const char *reason, const char *where)
{
    char text[ROOM];
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};

    snprintf(text, sizeof text, strip, threads);
    taut_status found = taut_problem_read_text(text, strlen(text), "text", &problem, &error);
    if (found == TAUT_OK) {
        found = taut_make(problem, NULL, &model, &error);
    }
    CHECK(found == TAUT_BAD_INPUT && strcmp(error.reason, reason) == 0 &&
              strcmp(error.where, where) == 0,
          "%s at %s: %s at %s", reason, where, error.reason, error.where);
    taut_model_free(model);
    taut_problem_free(problem);
}

int main(void)
{
    test_tube();
    check_strip("\"force_density\":[2,3]");
    check_strip("\"prestress\":[1,6]," REFERENCE);
    refuse("\"tension\":1,\"force_density\":[2,3]", "conflict", "/patches/1/force_density");
    refuse("\"prestress\":[1,6]", "missing", "/patches/1/reference");
    refuse("\"force_density\":[0,3]", "value", "/patches/1/force_density/0");
    refuse("\"updates\":2,\"force_density\":[2,3]", "conflict", "/patches/1/updates");
    refuse("\"updates\":101,\"prestress\":[1,6]," REFERENCE, "value", "/patches/1/updates");
    test_updates();
    test_catenoid();
    return check_failures != 0;
}
