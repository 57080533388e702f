/* test_curves.c -- films between 3 to 12 curves: flat polygons, two quads of Schwarz's D as a hexagon, and what is refused. */
#include "check.h"

#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* The area, of a film that holds and has so many surfaces; NAN where it is refused as `reason` at `where`. */
static double area_of(const char *text, int surfaces, const char *reason, const char *where)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_error error = {.status = TAUT_OK};
    taut_status status = taut_problem_read_text(text, strlen(text), "text", &problem, &error);
    double area = NAN;

    status = status == TAUT_OK ? taut_make(problem, NULL, &model, &error) : status;
    if (surfaces == 0) {
        CHECK(status == TAUT_BAD_INPUT && strcmp(error.reason, reason) == 0 &&
                  strcmp(error.where, where) == 0,
              "%s at %s: %s at %s: %s", reason, where, error.reason, error.where, error.message);
    } else {
        CHECK(status == TAUT_OK, "%s: %s", error.where, error.message);
        CHECK(taut_model_surface_count(model) == surfaces, "%d patches", surfaces);
        CHECK(taut_certify(model, problem, NULL, &certificate, &error) == TAUT_OK, "%s",
              error.message);
        CHECK(taut_certificate_holds(certificate) == TAUT_TRUE, "it holds");
        area = taut_record_number(taut_record_get(taut_certificate_figures(certificate), "area"));
    }
    taut_certificate_free(certificate);
    taut_model_free(model);
    taut_problem_free(problem);
    return area;
}

/* A regular polygon, every other side run backwards. */
static void test_polygons(void)
{
    for (int n = 3; n <= 12; n++) {
        char text[3000];
        int at = snprintf(text, sizeof text,
                          "{\"taut\":1,\"construct\":\"film\",\"count\":6,\"curves\":[");
        for (int k = 0; k < n; k++) {
            const double a = 2 * pi * (k + k % 2) / n, b = 2 * pi * (k + 1 - k % 2) / n;
            at += snprintf(text + at, sizeof text - (size_t)at,
                           "%s{\"line\":[[%.17g,%.17g,0],[%.17g,%.17g,0]]}", k == 0 ? "" : ",",
                           cos(a), sin(a), cos(b), sin(b));
        }
        snprintf(text + at, sizeof text - (size_t)at, "]}");
        CHECK_NEAR(area_of(text, n == 4 ? 1 : n, "", ""), 0.5 * n * sin(2 * pi / n), 1e-13,
                   "polygon of %d", n);
    }
}

#define HEXAGON(extra, last)                                                                       \
    "{\"taut\":1,\"construct\":\"film\"," extra "\"curves\":[{\"line\":[[1,1,0],[0,1,1]]},{"       \
    "\"line\":[[1,0,1],[0,1,1]]},{\"line\":[[1,0,1],[0,0,0]]},{\"line\":[[0,0,0],[0,1,-1]]},{"     \
    "\"line\":[[0,1,-1],[1,0,-1]]},{\"line\":[[1,0,-1]," last "]}]}"

/* Twice K(sqrt 3 / 2) / K(1 / 2), cut into other patches than the two quads. */
static void test_schwarz(void)
{
    CHECK_NEAR(area_of(HEXAGON("\"degree\":5,\"count\":9,", "[1,1,0]"), 6, "", ""),
               2 * 1.279261571171006466, 5e-11, "two quads");
    CHECK_NEAR(area_of(HEXAGON("\"degree\":5,\"count\":13,", "[1,1,0]"), 6, "", ""),
               2 * 1.279261571171006466, 1e-11, "two quads");
    CHECK_NEAR(
        area_of(HEXAGON("\"method\":\"normal\",\"degree\":5,\"count\":13,", "[1,1,0]"), 6, "", ""),
        2 * 1.279261571171006466, 3e-8, "two quads, the net as it came");
}

/* Five corners, one of 139 degrees, on which the net folds in all coordinates. */
#define UNEVEN(extra)                                                                              \
    "{\"taut\":1,\"construct\":\"film\"," extra                                                    \
    "\"curves\":[{\"line\":[[1.14,0.17,-0.07],[0.14,0.98,0.22]]},{\"line\":[[0.14,0.98,0.22],["    \
    "-1.11,0.82,0.22]]},{\"line\":[[-1.11,0.82,0.22],[-0.66,-0.26,0.47]]},{\"line\":[[-0.66,-"     \
    "0.26,0.47],[0.09,-0.61,-0.25]]},{\"line\":[[0.09,-0.61,-0.25],[1.14,0.17,-0.07]]}]}"

/* Against the same on 9 x 9 points of degree 4 in all coordinates. */
static void test_uneven(void)
{
    const double fine = area_of(UNEVEN("\"count\":9,"), 5, "", "");
    const double coarse =
        area_of(UNEVEN("\"method\":\"normal\",\"degree\":2,\"count\":6,"), 5, "", "");
    CHECK_NEAR(coarse, fine, 1e-5, "an uneven pentagon");
    CHECK(coarse > fine, "the coarse one has more");
}

static void test_refused(void)
{
    (void)area_of(HEXAGON("", "[1,1,1e-7]"), 0, "curve-ends", "/curves");
    (void)area_of(HEXAGON("\"degree\":1,", "[1,1,0]"), 0, "value", "/degree");
    (void)area_of(HEXAGON("\"count\":4,", "[1,1,0]"), 0, "value", "/count");
    (void)area_of(HEXAGON("\"seams\":[],", "[1,1,0]"), 0, "conflict", "/seams");
    (void)area_of("{\"taut\":1,\"construct\":\"film\",\"degree\":4}", 0, "conflict", "/degree");
    (void)area_of("{\"taut\":1,\"construct\":\"film\",\"curves\":[{\"line\":[[0,0,0],[1,0,0]]},{"
                  "\"line\":[[1,0,0],[0,0,0]]}]}",
                  0, "size", "/curves");
}

int main(void)
{
    test_polygons();
    test_schwarz();
    test_uneven();
    test_refused();
    return check_failures != 0;
}
