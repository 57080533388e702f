/* test_curves.c -- films between 3 to 12 curves: flat polygons, convex ones and others, discs of arcs, Schwarz's D as a quad whose
 * edges are given in pieces and two of its quads as a hexagon, and what is refused. */
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
        CHECK(status == TAUT_OK, "%s: %s: %s", text, error.where, error.message);
        if (status != TAUT_OK) {
            taut_problem_free(problem);
            return area;
        }
        CHECK(taut_model_surface_count(model) == surfaces, "%d patches, not %d: %s",
              taut_model_surface_count(model), surfaces, text);
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

/* A regular polygon, every other side run backwards: of 7 sides and more it is cut from corner to corner. */
static void test_polygons(void)
{
    static const int patches[13] = {0, 0, 0, 3, 1, 5, 6, 9, 10, 11, 12, 15, 18};
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
        CHECK_NEAR(area_of(text, patches[n], "", ""), 0.5 * n * sin(2 * pi / n), 1e-13,
                   "polygon of %d", n);
    }
}

/* The document of a polygon. */
static void write_polygon(const char *options, int n, const double (*corners)[3], char *text,
                          size_t room)
{
    int at = snprintf(text, room, "{\"taut\":1,\"construct\":\"film\",%s\"curves\":[", options);
    for (int k = 0; k < n; k++) {
        const double *a = corners[k], *b = corners[(k + 1) % n];
        at += snprintf(text + at, room - (size_t)at,
                       "%s{\"line\":[[%.17g,%.17g,%.17g],[%.17g,%.17g,%.17g]]}", k == 0 ? "" : ",",
                       a[0], a[1], a[2], b[0], b[1], b[2]);
    }
    snprintf(text + at, room - (size_t)at, "]}");
}

/* Flat polygons that are not convex, or have corners that are none, against the sum of x dy. Patches that left them would have more. */
static void test_shapes(void)
{
    static const struct {
        const char *what;
        int n, patches;
        double corners[12][3];
    } shapes[] = {
        {"a triangle with a corner of 180 degrees", 4, 6, {{0, 0}, {1, 0}, {2, 0}, {0.8, 1.5}}},
        {"one with a corner of 170", 4, 6, {{0, 0}, {1, -0.0874886635}, {2, 0}, {0.8, 1.5}}},
        {"a square with two, opposite", 6, 8, {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}}},
        {"a triangle with three", 6, 10, {{0, 0}, {1, 0}, {2, 0}, {1.5, 1}, {1, 2}, {0.5, 1}}},
        {"an L", 6, 8, {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}},
        {"a U", 8, 12, {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}},
        {"one with corners that are hardly any, which lines would cut into thin parts",
         11,
         33,
         {{1, 0},
          {0.319, 0.354},
          {-0.575, 0.818},
          {-0.878, -0.479},
          {-0.707, -0.583},
          {-0.637, -0.646},
          {-0.576, -0.663},
          {-0.4, -0.804},
          {-0.332, -0.857},
          {-0.292, -0.857},
          {-0.024, -1}}},
        {"an arrow", 4, 6, {{0, 0}, {2, 1}, {0, 2}, {0.7, 1}}},
        {"a cross",
         12,
         30,
         {{1, 0},
          {2, 0},
          {2, 1},
          {3, 1},
          {3, 2},
          {2, 2},
          {2, 3},
          {1, 3},
          {1, 2},
          {0, 2},
          {0, 1},
          {1, 1}}},
    };
    for (size_t s = 0; s < sizeof shapes / sizeof *shapes; s++) {
        char text[3000];
        double area = 0;
        for (int k = 0; k < shapes[s].n; k++) {
            const double *a = shapes[s].corners[k], *b = shapes[s].corners[(k + 1) % shapes[s].n];
            area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
        }
        write_polygon("\"degree\":3,\"count\":5,", shapes[s].n, shapes[s].corners, text,
                      sizeof text);
        CHECK_NEAR(area_of(text, shapes[s].patches, "", ""), area, 1e-12, "%s", shapes[s].what);
    }
}

/* A circle as arcs: all corners are straight. */
static void test_discs(void)
{
    static const int patches[] = {9, 12, 0, 0, 0, 24};
    for (int n = 3; n <= 8; n += n < 4 ? 1 : 4) {
        char text[3000];
        int at = snprintf(text, sizeof text,
                          "{\"taut\":1,\"construct\":\"film\",\"count\":8,\"curves\":[");
        for (int k = 0; k < n; k++) {
            at += snprintf(text + at, sizeof text - (size_t)at, "%s{\"arc\":[", k == 0 ? "" : ",");
            for (int i = 0; i < 3; i++) {
                const double a = 2 * pi * ((k + 0.5 * i) / n);
                at += snprintf(text + at, sizeof text - (size_t)at, "%s[%.17g,%.17g,0]",
                               i == 0 ? "" : ",", cos(a), sin(a));
            }
            at += snprintf(text + at, sizeof text - (size_t)at, "]}");
        }
        snprintf(text + at, sizeof text - (size_t)at, "]}");
        CHECK_NEAR(area_of(text, patches[n - 3], "", ""), pi, 2e-9, "a disc of %d arcs", n);
    }
}

/* Three lines and half a circle that is tangent to two of them: in a plane the energy does not say where the net is to be, and the
 * first that is found folds over at the centres of its patches. */
static void test_arches(void)
{
    static const double sizes[][2] = {{10, 10}, {4, 2}, {4, 3}, {2, 1}};
    for (int k = 0; k < 4; k++) {
        const double w = sizes[k][0], h = sizes[k][1];
        char text[1000];
        snprintf(
            text, sizeof text,
            "{\"taut\":1,\"construct\":\"film\",\"least\":false,\"curves\":[{\"line\":[[0,%g,0],"
            "[0,0,0]]},{\"line\":[[0,0,0],[%g,0,0]]},{\"line\":[[%g,0,0],[%g,%g,0]]},{\"arc\":"
            "[[%g,%g,0],[%g,%g,0],[0,%g,0]]}]}",
            h, w, w, w, h, w, h, w / 2, h + w / 2, h);
        CHECK_NEAR(area_of(text, 12, "", ""), w * h + pi * w * w / 8, 1e-8 * w * w,
                   "an arch, %g x %g", w, h);
    }
}

/* The quad of Schwarz's D, its edges in pieces, all of whose corners but four are straight. */
static void test_pieces(void)
{
    static const double quad[4][3] = {{0, 0, 0}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};
    static const int splits[][4] = {{2, 1, 1, 1}, {2, 1, 2, 1}, {2, 2, 2, 2}, {3, 3, 3, 3}};
    static const int patches[] = {15, 8, 14, 36};
    for (size_t s = 0; s < sizeof splits / sizeof *splits; s++) {
        double corners[12][3];
        char text[3000];
        int n = 0;
        for (int e = 0; e < 4; e++) {
            for (int k = 0; k < splits[s][e]; k++, n++) {
                const double at = k == 0 ? 0 : (k + 0.1) / splits[s][e];
                for (int c = 0; c < 3; c++) {
                    corners[n][c] = (1 - at) * quad[e][c] + at * quad[(e + 1) % 4][c];
                }
            }
        }
        write_polygon("\"count\":8,", n, (const double(*)[3])corners, text, sizeof text);
        CHECK_NEAR(area_of(text, patches[s], "", ""), 1.279261571171006466, 2e-11, "%d curves", n);
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
    test_shapes();
    test_discs();
    test_arches();
    test_pieces();
    test_schwarz();
    test_uneven();
    test_refused();
    return check_failures != 0;
}
