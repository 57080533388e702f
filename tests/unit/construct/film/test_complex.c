/* test_complex.c -- films of many patches against closed forms, and what is refused. */
#include "check.h"
#include "documents.h"
#include "refused.h"

#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define B(p, n) "{\"type\":\"bspline\",\"degree\":" #p ",\"count\":" #n "}"
#define FACE(name, n, from, to)                                                                    \
    "{\"name\":\"" name "\",\"u\":" n ",\"v\":" n                                                  \
    ",\"corners\":{\"u0v0\":{\"near\":[0.05,0.03,-0.02]},\"u1v0\":" from ",\"u1v1\":" to           \
    "},\"edges\":{\"u0\":{\"pole\":null}}}"
/* Corners of the tetrahedron of edge 2 sqrt 2. */
#define TETRAHEDRON(n)                                                                             \
    "{\"taut\":1,\"construct\":\"film\",\"patches\":[" FACE("ab", n, A, C) "," FACE(               \
        "ac", n, A,                                                                                \
        D) "," FACE("ad", n, A,                                                                    \
                    E) "," FACE("bc", n, C,                                                        \
                                D) "," FACE("bd", n, C,                                            \
                                            E) "," FACE("cd", n, D,                                \
                                                        E) "],\"seams\":[[\"ab.v0\",\"ac.v0\","    \
                                                           "\"ad.v0\"],[\"ab.v1\","                \
                                                           "\"bc.v0\",\"bd.v0\"],[\"ac.v1\",\"bc." \
                                                           "v1\",\"cd.v0\"],"                      \
                                                           "[\"ad.v1\",\"bd.v1\",\"cd.v1\"]]}"
#define A "[1,1,1]"
#define C "[1,-1,-1]"
#define D "[-1,1,-1]"
#define E "[-1,-1,1]"
#define SLIDES                                                                                     \
    "\"edges\":{\"v0\":{\"slide\":{\"point\":[0,0,0],\"normal\":[0,0,1]}},\"v1\":{\"slide\":{"     \
    "\"point\":[0,0,1],\"normal\":[0,0,2]}}}"
#define WALL(name, n, near0, near1, low, high)                                                     \
    "{\"name\":\"" name "\",\"u\":" n ",\"v\":" n ",\"corners\":{\"u0v0\":" near0                  \
    ",\"u0v1\":" near1 ",\"u1v0\":" low ",\"u1v1\":" high "}," SLIDES "}"
#define FERMAT(n, seam)                                                                            \
    "{\"taut\":1,\"construct\":\"film\",\"patches\":[" WALL(                                       \
        "a", n, "{\"near\":[0.9,0.4,0]}", "{\"near\":[0.7,0.7,1]}", "[0,0,0]",                     \
        "[0,0,1]") "," WALL("b", n, "null", "null", "[2,0,0]",                                     \
                            "[2,0,1]") "," WALL("c", n, "null", "null", "[0.5,1.5,0]",             \
                                                "[0.5,1.5,1]") "],\"seams\":[" seam "]}"

/* Half of a catenoid's ring: v from the lower to the upper circle. */
#define HALF(name, p, q, r)                                                                        \
    "{\"name\":\"" name                                                                            \
    "\",\"u\":" B(5, 13) ",\"v\":" B(5, 11) ",\"edges\":{\"v0\":{\"fixed\":{"                      \
                                            "\"arc\":[[" p ",0],[" q ",0],[" r                     \
                                            ",0]]}},\"v1\":{\"fixed\":{\"arc\":[[" p ",1],[" q     \
                                            ",1],[" r ",1]]}}}}"
static const char catenoid[] =
    "{\"taut\":1,\"construct\":\"film\",\"patches\":[" HALF("front", "1,0", "0,1", "-1,0") "," HALF(
        "back", "1,0", "0,-1", "-1,0") "],\"seams\":[[\"front.u0\",\"back.u0\"],[\"front.u1\","
                                       "\"back.u1\"]]}";

/* A square of two patches, one of them turned, with a cable along their seam, which the sheet of more tension draws into an arc. */
static const char square[] =
    "{\"taut\":1,\"construct\":\"film\",\"patches\":[{\"name\":\"l\",\"u\":" B(3, 5) ",\"v\":" B(
        3,
        6) ",\"corners\":{\"u0v0\":[0,0,0],\"u1v0\":[1,0,0],\"u0v1\":[0,2,0],\"u1v1\":[1,2,0]}},{"
           "\"name\":\"r\",\"tension\":2,\"u\":" B(3, 6) ",\"v\":" B(
               3, 4) ",\"corners\":{\"u0v0\":[1,2,0],\"u1v0\":[1,0,0],\"u0v1\":[2,2,0],\"u1v1\":["
                     "2,0,0]}}],\"seams\":[{\"edges\":[\"l.u1\",\"-r.v0\"],\"cable\":{"
                     "\"force\":3}}]}";

static double figure(const taut_certificate *certificate, const char *name)
{
    return taut_record_number(taut_record_get(taut_certificate_figures(certificate), name));
}

/* Makes, proves, and compares the energy. */
static void check_energy(const char *text, double energy, double error, const char *what)
{
    taut_problem *problem = problem_read(text);
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_error said = {.status = TAUT_OK};

    CHECK(taut_make(problem, NULL, &model, &said) == TAUT_OK, "%s: %s", what, said.message);
    CHECK(taut_certify(model, problem, NULL, &certificate, &said) == TAUT_OK, "%s: %s", what,
          said.message);
    CHECK(taut_certificate_holds(certificate) == TAUT_TRUE, "%s", what);
    CHECK_NEAR(figure(certificate, "energy"), energy, error, "%s", what);
    taut_certificate_free(certificate);
    taut_model_free(model);
    taut_problem_free(problem);
}

/* sides a, b, c: [(a^2 + b^2 + c^2) / 2 + 2 sqrt 3 area]^(1/2), from 2, sqrt 2.5, sqrt 4.5 and area 3/2. */
static void test_closed_forms(void)
{
    const double fermat = sqrt(5.5 + 3 * sqrt(3.0));
    check_energy(FERMAT(B(2, 3), "[\"a.u0\",\"b.u0\",\"c.u0\"]"), fermat, 1e-14 * fermat, "Fermat");
    check_energy(FERMAT(B(4, 6), "[\"a.u0\",\"b.u0\",\"c.u0\"]"), fermat, 1e-13 * fermat,
                 "Fermat, degree 4");
    /* of more points than planes need, nets fold where no Gauss node is, until they are even */
    check_energy(FERMAT(B(3, 6), "[\"a.u0\",\"b.u0\",\"c.u0\"]"), fermat, 1e-13 * fermat,
                 "Fermat, degree 3");
    check_energy(FERMAT(B(5, 8), "[\"a.u0\",\"b.u0\",\"c.u0\"]"), fermat, 1e-13 * fermat,
                 "Fermat, degree 5");
    /* the first point is the centre, so that the size is a third of an edge: what a bound rounds counts with the edge */
    check_energy(TETRAHEDRON(B(2, 3)), 6 * sqrt(2.0), 1e-12, "tetrahedron, one span");
    check_energy(TETRAHEDRON(B(2, 4)), 6 * sqrt(2.0), 1e-12,
                 "tetrahedron"); /* 8 * 3 / (2 sqrt 2) */
    /* The cable is an arc of radius T / (s_r - s_l) = 3 over a chord of 2, drawn into the sheet of more tension; cubics of 3 spans. */
    const double half = asin(1.0 / 3), lens = 9 * (half - sin(half) * cos(half));
    check_energy(square, 2 + lens + 2 * (2 - lens) + 3 * 6 * half, 1e-6,
                 "two tensions and a cable");
}

/* c cosh(1 / (2c)) = 1: the area is pi c^2 (sinh(1/c) + 1/c). The arcs that are fitted err by 1e-9. */
static void test_catenoid(void)
{
    double c = 0.85;
    for (int k = 0; k < 60; k++) {
        c -= (c * cosh(0.5 / c) - 1) / (cosh(0.5 / c) - 0.5 / c * sinh(0.5 / c));
    }
    check_energy(catenoid, acos(-1) * c * c * (sinh(1 / c) + 1 / c), 2e-8, "catenoid");
}

#define TWO(n, corner, edge, seams)                                                                \
    "{\"taut\":1,\"construct\":\"film\",\"patches\":[{\"name\":\"a\",\"u\":" B(2, 4) ",\"v\":" B(  \
        2, 4) ",\"corners\":{\"u0v0\":[0,0,0],\"u1v0\":[1,0,0],\"u0v1\":[0,1,0],"                  \
              "\"u1v1\":[1,1,0]}" edge "},{\"name\":\"b\",\"u\":" B(                               \
                  2, 4) ",\"v\":" n ",\"corners\":{\"u0v0\":" corner                               \
                        ",\"u1v0\":[2,0,0],\"u0v1\":[1,1,0],\"u1v1\":[2,1,0]}}],\"seams\":[" seams \
                        "]}"

static void test_refused(void)
{
    check_document_refused(TWO(B(2, 5), "[1,0,0]", "", "[\"a.u1\",\"b.u0\"]"), TAUT_BAD_INPUT,
                           "seam-mismatch", "/seams/0");
    check_document_refused(TWO("{\"type\":\"bspline\",\"degree\":2,\"knots\":[0,0,0,0.4,1,1,1]}",
                               "[1,0,0]", "", "[\"a.u1\",\"b.u0\"]"),
                           TAUT_BAD_INPUT, "seam-mismatch", "/seams/0");
    check_document_refused(TWO(B(2, 4), "[1,0,1e-6]", "", "[\"a.u1\",\"b.u0\"]"), TAUT_BAD_INPUT,
                           "corner-conflict", "/patches/1/corners/u0v0");
    check_document_refused(TWO(B(2, 4), "[1,0,1e-12]", "", "[\"a.u1\",\"b.u0\"]"), TAUT_BAD_INPUT,
                           "corner-conflict", "/patches/1/corners/u0v0");
    check_document_refused(TWO(B(2, 4), "[1,0,0]", ",\"edges\":{\"u1\":{\"cable\":{\"force\":1}}}",
                               "[\"a.u1\",\"b.u0\"]"),
                           TAUT_BAD_INPUT, "edge-conflict", "/seams/0/0");
    check_document_refused(TWO(B(2, 4), "[1,0,0]", "", "[\"a.u1\",\"b.u0\"],[\"b.u0\",\"a.u0\"]"),
                           TAUT_BAD_INPUT, "edge-conflict", "/seams/0/1");
    check_document_refused(TWO(B(2, 4), "[1,0,0]", "", "[\"a.u1\",\"b.w0\"]"), TAUT_BAD_INPUT,
                           "name", "/seams/0/1");
    check_document_refused(TWO(B(2, 4), "null", "", ""), TAUT_BAD_INPUT, "corner-missing",
                           "/patches/1/edges/u0");
    check_document_refused("{\"taut\":1,\"construct\":\"film\",\"patches\":[{" SLIDES
                           ",\"corners\":{\"u0v0\":{\"near\":[0,0,0]},\"u1v0\":{\"near\":[1,0,0]},"
                           "\"u0v1\":{\"near\":[0,0,1]},\"u1v1\":{\"near\":[1,0,1]}}}],"
                           "\"seams\":[[\"film-0.u0\",\"film-0.u1\"]]}",
                           TAUT_NO_SOLUTION, "floating", "/patches");
}

/* Every claim sees its own harm: ten times its limit. */
static void test_moved(void)
{
    taut_problem *problem = problem_read(FERMAT(B(2, 4), "[\"a.u0\",\"b.u0\",\"c.u0\"]"));
    taut_model *model = NULL;
    const struct {
        int point;
        double by[3];
        const char *claim;
    } rows[] = {{1, {1e-9, 0, 0}, "seams"},      /* of the line, in one sheet alone */
                {4, {0, 0, 1e-13}, "held"},      /* out of the plane it slides in */
                {12, {1e-12, 0, 0}, "held"},     /* a corner */
                {14, {0, 0, 1e-10}, "boundary"}, /* of the straight edge */
                {5, {-1e-8, 1e-8, 0}, "stationary"} /* across the sheet */};

    CHECK(taut_make(problem, NULL, &model, NULL) == TAUT_OK, "Fermat");
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const taut_surface *whole = taut_model_surface(model, 0);
        taut_certificate *certificate = NULL;
        taut_surface *moved = NULL;
        taut_model *other = NULL;
        double points[16][3];
        memcpy(points, taut_surface_points(whole), sizeof points);
        for (int c = 0; c < 3; c++) {
            points[rows[k].point][c] += rows[k].by[c];
        }
        CHECK(taut_surface_new("a", taut_surface_u(whole), taut_surface_v(whole), points[0], NULL,
                               &moved, NULL) == TAUT_OK &&
                  taut_model_new(&other) == TAUT_OK &&
                  taut_model_add_surface(other, moved) == TAUT_OK,
              "moved");
        for (int p = 1; p < 3; p++) {
            taut_surface *copy = NULL;
            CHECK(taut_surface_copy(taut_model_surface(model, p), &copy) == TAUT_OK &&
                      taut_model_add_surface(other, copy) == TAUT_OK,
                  "copied");
        }
        CHECK(taut_certify(other, problem, NULL, &certificate, NULL) == TAUT_OK, "%s",
              rows[k].claim);
        int failed = 0;
        for (int c = 0; c < taut_certificate_claim_count(certificate); c++) {
            const taut_claim *claim = taut_certificate_claim(certificate, c);
            failed |= strcmp(claim->claim, rows[k].claim) == 0 && claim->holds == TAUT_FALSE;
        }
        CHECK(failed, "%s does not see point %d moved", rows[k].claim, rows[k].point);
        taut_certificate_free(certificate);
        taut_model_free(other);
    }
    taut_model_free(model);
    taut_problem_free(problem);
}

int main(void)
{
    test_closed_forms();
    test_catenoid();
    test_refused();
    test_moved();
    return check_failures != 0;
}
