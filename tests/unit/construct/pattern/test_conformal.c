/* test_conformal.c -- pieces laid flat by angles: their scale against a series of Fourier, whose harmonic function shares no code with
 * splines; what has no curvature stays as it is; what angles do not go with is refused. */
#include "certificates.h"
#include "check.h"
#include "cloths.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* r = cosh v, u from 0 to pi/2 and v from -1 to 1.2. */
#define CATENOID                                                                                   \
    "{ \"taut\": 1, \"surfaces\": [{ \"name\": \"catenoid\", \"u\": { \"type\": \"c-bezier\", "    \
    "\"alpha\": 1.5707963267948966 }, \"v\": { \"type\": \"h-bezier\", \"beta\": 2.2 }, "          \
    "\"points\": [[[1.5430806348152437, 0, -1], [0.7996330890615981, 0, -0.3673870059231905], "    \
    "[0.8557506998338412, 0, 0.5673870059231906], [1.8106555673243747, 0, 1.2]], "                 \
    "[[1.5430806348152437, 0.8807847583008784, -1], [0.7996330890615981, 0.4564276300200167, "     \
    "-0.3673870059231905], [0.8557506998338412, 0.4884593561173187, 0.5673870059231906], "         \
    "[1.8106555673243747, 1.0335155469194828, 1.2]], [[0.8807847583008784, 1.5430806348152437, "   \
    "-1], [0.4564276300200167, 0.7996330890615981, -0.3673870059231905], [0.4884593561173187, "    \
    "0.8557506998338412, 0.5673870059231906], [1.0335155469194828, 1.8106555673243747, 1.2]], "    \
    "[[0, 1.5430806348152437, -1], [0, 0.7996330890615981, -0.3673870059231905], [0, "             \
    "0.8557506998338412, 0.5673870059231906], [0, 1.8106555673243747, 1.2]]] }] }"
/* The unit sphere, a quarter of the turn between latitudes of 60 degrees. */
#define SPHERE                                                                                     \
    "{ \"taut\": 1, \"surfaces\": [{ \"name\": \"sphere\", \"u\": { \"type\": \"c-bezier\", "      \
    "\"alpha\": 1.5707963267948966 }, \"v\": { \"type\": \"c-bezier\", \"alpha\": "                \
    "2.0943951023931957 }, \"points\": [[[0.5, 0, -0.8660254037844386], [1.2091995761561452, 0, "  \
    "-0.45656883758151967], [1.2091995761561452, 0, 0.45656883758151967], [0.5, 0, "               \
    "0.8660254037844386]], [[0.5, 0.28539816339744833, -0.8660254037844386], "                     \
    "[1.2091995761561452, 0.6902066764318736, -0.45656883758151967], [1.2091995761561452, "        \
    "0.6902066764318736, 0.45656883758151967], [0.5, 0.28539816339744833, 0.8660254037844386]], "  \
    "[[0.28539816339744833, 0.5, -0.8660254037844386], [0.6902066764318736, 1.2091995761561452, "  \
    "-0.45656883758151967], [0.6902066764318736, 1.2091995761561452, 0.45656883758151967], "       \
    "[0.28539816339744833, 0.5, 0.8660254037844386]], [[0, 0.5, -0.8660254037844386], [0, "        \
    "1.2091995761561452, -0.45656883758151967], [0, 1.2091995761561452, 0.45656883758151967], "    \
    "[0, 0.5, 0.8660254037844386]]] }] }"
/* Slant 1 to 3 of sine 0.6, a quarter of the turn. */
#define CONE                                                                                       \
    "{ \"taut\": 1, \"surfaces\": [{ \"name\": \"cone\", \"u\": { \"type\": \"bezier\", "          \
    "\"degree\": 2 }, \"v\": { \"type\": \"bezier\", \"degree\": 1 }, \"points\": [[[0.6, 0, "     \
    "-0.8], [1.8, 0, -2.4]], [[0.6, 0.6, -0.8], [1.8, 1.8, -2.4]], [[0, 0.6, -0.8], [0, 1.8, "     \
    "-2.4]]], \"weights\": [[1, 1], [0.7071067811865476, 0.7071067811865476], [1, 1]] }] }"

/* Both are e^(2 f) (du^2 + dq^2) with f = sign log cosh q, flat by phi = h - f, h harmonic in (u, q) and f on the border of a strip of
 * width a: what e^phi is in the middle of the strip. */
static double scale_of(double sign, double a, double from, double to, double q)
{
    enum { TERMS = 200, PARTS = 8000 };
    const double length = to - from, ends[2] = {log(cosh(from)), log(cosh(to))};
    double h = ends[0] + (ends[1] - ends[0]) * (q - from) / length;
    for (int n = 1; n <= TERMS; n++) {
        double sum = 0; /* Simpson's rule; both ends are 0 */
        for (int k = 1; k < PARTS; k++) {
            const double x = (double)k / PARTS;
            const double off = log(cosh(from + x * length)) - ends[0] - (ends[1] - ends[0]) * x;
            sum += (k % 2 == 0 ? 2 : 4) * off * sin(n * pi * x);
        }
        h += 2 * sum / (3 * PARTS) * sin(n * pi * (q - from) / length) /
             cosh(n * pi * a / (2 * length));
    }
    return exp(sign * (h - log(cosh(q))));
}

/* Of the first strip, in its middle: y_t over x_t. */
static double scale_found(const made_cloth *made, double a, double radius)
{
    double y[3][3];
    taut_pattern_flat_piece piece;
    if (taut_pattern_piece_at(made->model, 0, &piece, NULL) != TAUT_OK) {
        return NAN;
    }
    taut_surface_eval(piece.flat, 0.5, 0.5, 1, y[0]);
    return hypot(y[2][0], y[2][1]) / (a * radius);
}

static void check_claims(const made_cloth *made)
{
    CHECK(made->status == TAUT_OK, "%s", made->error.message);
    CHECK(taut_certificate_holds(made->proof) == TAUT_TRUE, "holds");
    CHECK(!has_claim(made->proof, "stationary") && !has_claim(made->proof, "stable"),
          "no energy was made least");
    CHECK(claim_of(made->proof, "lengths")->holds == TAUT_TRUE, "lengths are kept");
}

static void test_against_series(void)
{
    made_cloth neck = cloth_make(CATENOID, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": "
                                           "4 }], \"flatten\": \"conformal\"");
    made_cloth ball = cloth_make(SPHERE, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 "
                                         "}], \"flatten\": \"conformal\"");
    const double middle = asinh((sinh(-1) + sinh(1.2)) / 2), edge = asinh(sqrt(3));
    check_claims(&neck);
    check_claims(&ball);
    const double own[2] = {scale_of(1, pi / 8, -1, 1.2, middle),
                           scale_of(-1, pi / 6, -edge, edge, 0)};
    CHECK(own[0] > 1.01 && own[1] < 0.99, "%g, %g", own[0], own[1]);
    CHECK_NEAR(scale_found(&neck, pi / 8, cosh(middle)), own[0], 1e-7, "neck");
    CHECK_NEAR(scale_found(&ball, pi / 6, 1), own[1], 1e-7, "ball");
    /* of the surface, by hand */
    CHECK_NEAR(cloth_number(&neck, "pieces", "P1", "area"), 1.32468097591267802, 1e-10, "area");
    CHECK_NEAR(cloth_number(&ball, "pieces", "P2", "area"), pi / 6 * sqrt(3), 1e-10, "area");
    /* the sphere is largest stretched in the middle */
    CHECK_NEAR(figure_of(ball.proof, "max_strain"), 1 / own[1] - 1, 1e-7, "most");
    CHECK(figure_of(neck.proof, "conformal_energy") > 0 &&
              figure_of(neck.proof, "conformal_energy") < 1e-11 * figure_of(neck.proof, "area"),
          "%g", figure_of(neck.proof, "conformal_energy"));
    cloth_free(&neck);
    cloth_free(&ball);
}

/* Angles and lengths both. */
static void test_cone(void)
{
    made_cloth made = cloth_make(CONE, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 2 "
                                       "}], \"flatten\": \"conformal\"");
    check_claims(&made);
    CHECK(claim_of(made.proof, "isometric")->holds == TAUT_TRUE, "isometric");
    CHECK_NEAR(cloth_number(&made, "pieces", "P1", "flat_area"), 4 * 0.6 * pi / 4, 1e-10, "area");
    cloth_free(&made);
}

/* A model that is told to be conformal and is not. */
static void test_told(void)
{
    made_cloth made = cloth_make(SADDLE, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 2 "
                                         "}], \"flatten\": \"elastic\", \"seam_length\": \"true\"");
    CHECK(made.status == TAUT_OK && !has_claim(made.proof, "conformal"), "%s", made.error.message);
    taut_record *details = taut_record_new();
    const taut_record *own = taut_model_details(made.model);
    for (size_t k = 0; k < taut_record_count(own); k++) {
        const taut_record *item = taut_record_at(own, k);
        if (taut_record_kind_of(item) == TAUT_RECORD_TEXT) {
            taut_record_add_text(details, taut_record_key(own, k), taut_record_text(item));
        } else {
            taut_record_add_record(details, taut_record_key(own, k), item);
        }
    }
    taut_record_add_text(details, "flatten", "conformal");
    taut_model_set_details(made.model, details);
    taut_certificate *proof = NULL;
    CHECK(taut_pattern_certify(made.model, NULL, NULL, &proof, NULL) == TAUT_OK, "certified");
    CHECK(claim_of(proof, "conformal")->holds == TAUT_FALSE, "angles are not kept");
    taut_certificate_free(proof);
    cloth_free(&made);
}

static void test_refused(void)
{
    static const struct {
        const char *members, *where;
    } all[] = {{"\"cloth\": { \"material\": \"etfe\" }", "/cloth/material"},
               {"\"compensation\": { \"weft\": 0.01 }", "/compensation"},
               {"\"compensation\": { \"seam\": 0 }", "/compensation"},
               {"\"decompensate\": [{ \"edge\": \"v0\", \"length\": 1 }]", "/decompensate"},
               {"\"held\": [\"left\"]", "/held"},
               {"\"ends\": \"straight\"", "/ends"}};
    for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) {
        char members[300];
        snprintf(members, sizeof members,
                 "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 2 }], \"flatten\": "
                 "\"conformal\", %s",
                 all[k].members);
        made_cloth made = cloth_make(SADDLE, members);
        CHECK(made.status == TAUT_BAD_INPUT && strcmp(made.error.reason, "conflict") == 0 &&
                  strcmp(made.error.where, all[k].where) == 0,
              "%s: %s at %s", all[k].members, made.error.reason, made.error.where);
        cloth_free(&made);
    }
    made_cloth made = cloth_make(SADDLE, "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 2 "
                                         "}], \"flatten\": \"flat\"");
    CHECK(made.status == TAUT_BAD_INPUT, "no such way");
    cloth_free(&made);
}

int main(void)
{
    test_against_series();
    test_cone();
    test_told();
    test_refused();
    return check_failures != 0;
}
