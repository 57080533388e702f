/* test_plateau.c -- four held edges by three constructions: `plateau`, the film of one patch, and that of `patches` with one patch in
 * them. The three share the area and its derivatives, and neither the search nor the proof; the least area is one, that of Schwarz's
 * quad a closed form. */
#include "certificates.h"
#include "check.h"

#include "taut/construct.h"
#include "taut/read.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ROOM = 2000 };
static const double quad_area = 1.279261571171006466; /* K(sqrt 3 / 2) / K(1 / 2) */

typedef struct found {
    double area, bound;
    taut_verdict least;
} found;

static found make(const char *text)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_certificate *proof = NULL;
    taut_error error = {.status = TAUT_OK};
    found f;

    CHECK(taut_problem_read_text(text, strlen(text), "text", &problem, &error) == TAUT_OK &&
              taut_make(problem, NULL, &model, &error) == TAUT_OK &&
              taut_certify(model, problem, NULL, &proof, &error) == TAUT_OK,
          "%s: %s: %s", error.where, error.message, text);
    CHECK(claim_of(proof, "stationary")->holds == TAUT_TRUE, "%s", text);
    f.area = figure_of(proof, "area");
    f.bound = figure_of(proof, "lower_bound");
    f.least = claim_of(proof, "least")->holds;
    taut_certificate_free(proof);
    taut_model_free(model);
    taut_problem_free(problem);
    return f;
}

/* Corners u0v0, u1v0, u0v1, u1v1. */
static void try_corners(const double x[4][3], const char *what, found all[3])
{
    static const char base[] = "\"u\":{\"type\":\"bspline\",\"degree\":4,\"count\":12},\"v\":{"
                               "\"type\":\"bspline\",\"degree\":4,\"count\":12}";
    char points[4][100], corners[ROOM / 2], text[ROOM];

    for (int k = 0; k < 4; k++) {
        snprintf(points[k], sizeof points[k], "[%.17g,%.17g,%.17g]", x[k][0], x[k][1], x[k][2]);
    }
    snprintf(corners, sizeof corners,
             "%s,\"corners\":{\"u0v0\":%s,\"u1v0\":%s,\"u0v1\":%s,\"u1v1\":%s}", base, points[0],
             points[1], points[2], points[3]);
    snprintf(text, sizeof text,
             "{\"taut\":1,\"construct\":\"plateau\",%s,\"curves\":{\"v0\":{\"t\":{\"type\":"
             "\"bezier\",\"degree\":1},\"points\":[%s,%s]},\"v1\":{\"t\":{\"type\":\"bezier\","
             "\"degree\":1},\"points\":[%s,%s]},\"u0\":{\"t\":{\"type\":\"bezier\",\"degree\":1},"
             "\"points\":[%s,%s]},\"u1\":{\"t\":{\"type\":\"bezier\",\"degree\":1},\"points\":[%s,"
             "%s]}}}",
             base, points[0], points[1], points[2], points[3], points[0], points[2], points[1],
             points[3]);
    all[0] = make(text);
    snprintf(text, sizeof text, "{\"taut\":1,\"construct\":\"film\",%s}", corners);
    all[1] = make(text);
    snprintf(text, sizeof text,
             "{\"taut\":1,\"construct\":\"film\",\"patches\":[{\"name\":\"a\",%s}]}", corners);
    all[2] = make(text);
    for (int k = 0; k < 3; k++) {
        CHECK(all[k].least == TAUT_TRUE, "%s, %d: not proved least", what, k);
        for (int j = 0; j < 3; j++) {
            CHECK_NEAR(all[k].area, all[j].area, 1e-10 * all[j].area, "%s: areas %d, %d", what, k,
                       j);
            /* a bound of one is a bound of all; of a film of one patch as a sail it is some 1e-4 below */
            CHECK(!(all[k].bound > all[j].area * (1 + 1e-14)), "%s: %.17g of %d, %.17g of %d", what,
                  all[k].bound, k, all[j].area, j);
            CHECK(k == 1 || all[k].bound > all[j].area * (1 - 2e-10),
                  "%s: %.17g of %d, %.17g of %d", what, all[k].bound, k, all[j].area, j);
        }
    }
}

int main(void)
{
    static const double quad[4][3] = {{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 0}};
    found all[3];

    try_corners(quad, "quad", all);
    CHECK_NEAR(all[1].area, quad_area, 4e-12, "as a film");
    CHECK_NEAR(all[0].area, quad_area, 2e-11, "as a plateau");
    CHECK(all[0].bound <= quad_area && all[1].bound <= quad_area && all[2].bound <= quad_area,
          "bounds above the closed form");
    for (int trial = 0; trial < 4; trial++) {
        double x[4][3];
        for (int k = 0; k < 4; k++) {
            x[k][0] = 2 * (k % 2) + random_in(-0.3, 0.3);
            x[k][1] = 2 * (k / 2) + random_in(-0.3, 0.3);
            x[k][2] = random_in(-0.6, 0.6);
        }
        try_corners((const double(*)[3])x, "random", all);
    }
    return check_failures != 0;
}
