/* test_images.c -- films repeated by mirrors, turns and translations: Schwarz's D and P, and what is refused. */
#include "check.h"
#include "cli/embedded_files.h"

#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define BASES                                                                                      \
    "\"u\":{\"type\":\"bspline\",\"degree\":5,\"count\":12},\"v\":{\"type\":\"bspline\","          \
    "\"degree\":5,\"count\":12},"
#define D_QUAD                                                                                     \
    "{\"taut\":1,\"construct\":\"film\",\"name\":\"d\",\"least\":false," BASES                     \
    "\"corners\":{\"u0v0\":[0,0,0],\"u1v0\":[1,1,0],\"u1v1\":[0,1,1],\"u0v1\":[1,0,1]},"           \
    "\"images\":[%s]}"
#define HALF_TURN "{\"half_turn\":{\"point\":[0,0,0],\"direction\":[1,1,0]}}"
#define THIRD "\"turn\":{\"point\":[0,0,0],\"direction\":[1,-1,-1]},\"angle\":2.0943951023931953"
#define P_QUAD                                                                                     \
    "{\"taut\":1,\"construct\":\"film\",\"name\":\"p\"," BASES                                     \
    "\"corners\":{\"u0v0\":[0.25,0.25,0.25],\"u1v0\":[0.5,0,0.25],\"u1v1\":{\"line\":{\"point\":[" \
    "0.5,0,0],\"direction\":[0,1,0]},\"near\":[0.5,0.25,0]},\"u0v1\":[0.25,0.5,0]},\"edges\":{"    \
    "\"u1\":{\"mirror\":{\"point\":[0.5,0,0],\"normal\":[1,0,0]}},\"v1\":{\"mirror\":{\"point\":[" \
    "0,0,0],\"normal\":[0,0,1]}}},\"images\":[{\"turn\":{\"point\":[0.25,0.25,0.25],"              \
    "\"direction\":[1,1,1]},\"angle\":2.0943951023931953,\"count\":2},{\"mirror\":{\"point\":[0,"  \
    "0,0],\"normal\":[1,0,0]}},{\"mirror\":{\"point\":[0,0,0],\"normal\":[0,3,0]}},{\"mirror\":{"  \
    "\"point\":[0,0,0],\"normal\":[0,0,1]}}]}"

static taut_model *make(const char *text, taut_problem **problem, taut_certificate **certificate)
{
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};

    CHECK(taut_problem_read_text(text, strlen(text), "text", problem, &error) == TAUT_OK, "%s: %s",
          error.where, error.message);
    CHECK(taut_make(*problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_certify(model, *problem, NULL, certificate, &error) == TAUT_OK, "%s", error.message);
    return model;
}

static double area_of(const taut_certificate *certificate)
{
    return taut_record_number(taut_record_get(taut_certificate_figures(certificate), "area"));
}

static const taut_claim *claim_of(const taut_certificate *certificate, const char *name)
{
    for (int c = 0; c < taut_certificate_claim_count(certificate); c++) {
        if (strcmp(taut_certificate_claim(certificate, c)->claim, name) == 0) {
            return taut_certificate_claim(certificate, c);
        }
    }
    return NULL;
}

/* How many edges of all surfaces coincide with another one, by their middles. */
static int count_shared(const taut_model *model)
{
    static double middles[400][3];
    int count = 0, shared = 0;

    for (int s = 0; s < taut_model_surface_count(model); s++) {
        const double at[4][2] = {{0, 0.5}, {1, 0.5}, {0.5, 0}, {0.5, 1}};
        for (int e = 0; e < 4; e++) {
            CHECK(taut_surface_eval(taut_model_surface(model, s), at[e][0], at[e][1], 0,
                                    middles[count++]) == TAUT_OK,
                  "middle");
        }
    }
    for (int a = 0; a < count; a++) {
        int others = 0;
        for (int b = 0; b < count; b++) {
            double away = 0;
            for (int c = 0; c < 3; c++) {
                away = fmax(away, fabs(middles[a][c] - middles[b][c]));
            }
            others += a != b && away < 1e-12;
        }
        CHECK(others <= 1, "edge %d is one of %d", a, others + 1);
        shared += others;
    }
    return shared;
}

/* 2 K(sqrt 3 / 2) / K(1 / 2) over an edge of 1 squared: six quads about a corner, in a cube of side 2. */
static void test_schwarz_d(void)
{
    char text[2000];
    taut_problem *problem = NULL;
    taut_certificate *certificate = NULL;
    snprintf(text, sizeof text, D_QUAD, HALF_TURN ",{" THIRD ",\"count\":2}");
    taut_model *model = make(text, &problem, &certificate);

    CHECK(taut_model_surface_count(model) == 6, "six quads");
    CHECK(strcmp(taut_surface_name(taut_model_surface(model, 5)), "d'''''") == 0, "five primes");
    CHECK(count_shared(model) == 12, "each meets two");
    CHECK_NEAR(area_of(certificate), 1.279261571171006466, 1e-11, "Schwarz D");
    CHECK(claim_of(certificate, "images")->holds == TAUT_TRUE &&
              claim_of(certificate, "identity")->holds == TAUT_TRUE,
          "images");
    taut_certificate_free(certificate);
    taut_model_free(model);
    taut_problem_free(problem);
}

/* The example's model; its area. */
static double area_of_example(const char *name, taut_model **model)
{
    taut_problem *problem = NULL;
    taut_certificate *certificate = NULL;
    const taut_embedded *found = taut_examples;
    while (strcmp(found->name, name) != 0) {
        found++;
    }
    *model = make(found->text, &problem, &certificate);
    const double area = area_of(certificate);
    CHECK(taut_certificate_holds(certificate) != TAUT_FALSE, "%s holds", name);
    taut_certificate_free(certificate);
    taut_problem_free(problem);
    return area;
}

/* Neovius' surface between Schwarz's lines: Surface Evolver's area of a quad (tests/cli/test_film_peer.sh). The gyroid bends from D:
 * (1 + k^2) / (16 k) of a quad in a cell of side 1, k the area of the quad of D. */
static void test_neovius_and_gyroid(void)
{
    const double k = 1.279261571171006466;
    taut_model *model = NULL;

    CHECK_NEAR(area_of_example("film-neovius.json", &model), 0.0731349610814478, 1e-12, "Neovius");
    CHECK(taut_model_surface_count(model) == 48 && count_shared(model) == 144,
          "72 edges inside: %d", count_shared(model));
    taut_model_free(model);
    CHECK_NEAR(area_of_example("film-gyroid.json", &model), (1 + k * k) / (16 * k), 2e-12,
               "gyroid");
    CHECK(taut_model_surface_count(model) == 24 && count_shared(model) == 62, "31 edges inside: %d",
          count_shared(model));
    taut_model_free(model);
}

/* 3 K(1/2) / K(sqrt 3 / 2) a^2 in a cube of side a: 24 quads. */
static void test_schwarz_p(void)
{
    taut_problem *problem = NULL;
    taut_certificate *certificate = NULL;
    taut_model *model = make(P_QUAD, &problem, &certificate);

    CHECK(taut_model_surface_count(model) == 24, "24 quads");
    CHECK(count_shared(model) == 72, "60 edges, 24 of them on the cube");
    CHECK_NEAR(24 * area_of(certificate), 2.34510288404416726, 2e-11, "Schwarz P");
    CHECK(taut_certificate_holds(certificate) == TAUT_TRUE, "P holds");

    /* A copy that is moved by ten times the limit, and one that is not there. */
    taut_model *other = NULL;
    CHECK(taut_model_new(&other) == TAUT_OK, "other");
    for (int k = 0; k < 23; k++) {
        const taut_surface *s = taut_model_surface(model, k);
        double points[144][3];
        taut_surface *copy = NULL;
        memcpy(points, taut_surface_points(s), sizeof points);
        points[50][1] += k == 17 ? 3e-13 : 0;
        CHECK(taut_surface_new(taut_surface_name(s), taut_surface_u(s), taut_surface_v(s),
                               points[0], NULL, &copy, NULL) == TAUT_OK &&
                  taut_model_add_surface(other, copy) == TAUT_OK,
              "copy");
    }
    taut_certificate *fails = NULL;
    CHECK(taut_certify(other, problem, NULL, &fails, NULL) == TAUT_OK, "certificate");
    CHECK(claim_of(fails, "identity")->holds == TAUT_FALSE &&
              claim_of(fails, "images")->holds != TAUT_TRUE &&
              strcmp(claim_of(fails, "images")->where, "p'23") == 0,
          "a copy is missing: %s", claim_of(fails, "images")->where);
    taut_certificate_free(fails);
    taut_surface *last = NULL;
    CHECK(taut_surface_copy(taut_model_surface(model, 23), &last) == TAUT_OK &&
              taut_model_add_surface(other, last) == TAUT_OK,
          "last");
    CHECK(taut_certify(other, problem, NULL, &fails, NULL) == TAUT_OK, "certificate");
    CHECK(claim_of(fails, "identity")->holds == TAUT_TRUE, "all are there");
    CHECK(claim_of(fails, "images")->holds == TAUT_FALSE &&
              strcmp(claim_of(fails, "images")->where, "p'17") == 0,
          "a copy is moved");
    taut_certificate_free(fails);
    taut_model_free(other);
    taut_certificate_free(certificate);
    taut_model_free(model);
    taut_problem_free(problem);
}

static void test_refused(void)
{
    static const struct {
        const char *images, *reason, *where;
    } rows[] = {
        {HALF_TURN "," HALF_TURN, "image-twice", "/images"},
        {"{" THIRD ",\"count\":3}", "image-twice", "/images"},
        {"{\"translate\":[2,0,0],\"count\":4096}", "size", "/images"},
        {"{\"translate\":[2,0,0],\"count\":4097}", "value", "/images/0/count"},
        {"{\"translate\":[0,0,0]}", "value", "/images/0"},
        {"{\"translate\":[2,0,0],\"angle\":1}", "conflict", "/images/0/angle"},
        {"{" THIRD ",\"translate\":[1,0,0]}", "conflict", "/images/0"},
        {"{\"count\":2}", "missing", "/images/0"},
        {"{\"turn\":{\"point\":[0,0,0],\"direction\":[0,0,1]}}", "missing", "/images/0/angle"},
        {"{\"mirror\":{\"point\":[0,0,0],\"direction\":[0,0,1]}}", "unknown-member",
         "/images/0/mirror/direction"},
    };

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        char text[2000];
        taut_problem *problem = NULL;
        taut_model *model = NULL;
        taut_error error = {.status = TAUT_OK};
        snprintf(text, sizeof text, D_QUAD, rows[k].images);
        taut_status said = taut_problem_read_text(text, strlen(text), "text", &problem, &error);
        if (said == TAUT_OK) {
            said = taut_make(problem, NULL, &model, &error);
        }
        CHECK(said == TAUT_BAD_INPUT && strcmp(error.reason, rows[k].reason) == 0 &&
                  strcmp(error.where, rows[k].where) == 0,
              "%s: status %d, %s at %s: %s", rows[k].images, (int)said, error.reason, error.where,
              error.message);
        taut_model_free(model);
        taut_problem_free(problem);
    }
}

/* A patch may not be called as the image of another one is, whichever comes first; with a name that only looks alike it may. */
static void test_names(void)
{
    static const struct {
        const char *names[2];
        int refused;
    } rows[] = {{{"a", "a'"}, 1}, {{"a'9", "a"}, 1}, {{"a", "a'b"}, 0}, {{"a", "ab'"}, 0}};
    static const char document[] =
        "{\"taut\":1,\"construct\":\"film\",\"patches\":[{\"name\":\"%s\"," BASES
        "\"corners\":{\"u0v0\":[0,0,0],\"u1v0\":[1,0,0],\"u0v1\":[0,1,0],\"u1v1\":[1,1,0]}},"
        "{\"name\":\"%s\"," BASES "\"corners\":{\"u1v0\":[2,0,0],\"u1v1\":[2,1,0]}}],"
        "\"seams\":[[\"%s.u1\",\"%s.u0\"]],\"images\":[{\"translate\":[0,0,3],\"count\":9}]}";

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        char text[2000];
        taut_problem *problem = NULL;
        taut_model *model = NULL;
        taut_error error = {.status = TAUT_OK};
        const char *const *names = rows[k].names;
        snprintf(text, sizeof text, document, names[0], names[1], names[0], names[1]);
        CHECK(taut_problem_read_text(text, strlen(text), "text", &problem, &error) == TAUT_OK,
              "%s: %s", error.where, error.message);
        const taut_status status = taut_make(problem, NULL, &model, &error);
        CHECK(rows[k].refused ? status == TAUT_BAD_INPUT && strcmp(error.reason, "name") == 0 &&
                                    strcmp(error.where, "/patches/1/name") == 0
                              : status == TAUT_OK,
              "%s and %s: status %d, %s", names[0], names[1], (int)status, error.message);
        taut_model_free(model);
        taut_problem_free(problem);
    }
}

int main(void)
{
    test_names();
    test_schwarz_d();
    test_schwarz_p();
    test_neovius_and_gyroid();
    test_refused();
    return check_failures != 0;
}
