/* test_patches.c -- `least` of films of many patches: against a closed form, under witnesses that lie, and on boundaries that are
 * no single closed convex curve. */
#include "certificates.h"
#include "check.h"
#include "documents.h"
#include "witnesses.h"

#include "certify/film/complex/least.h"
#include "problem/film_rim.h"
#include "problem/problem.h"
#include "taut/construct.h"
#include "taut/read.h"

#include <math.h>
#include <string.h>

#define PATCH(name, p, n, corners, more)                                                           \
    "{\"name\":\"" name "\",\"u\":{\"type\":\"bspline\",\"degree\":" p ",\"count\":" n             \
    "},\"v\":{\"type\":\"bspline\",\"degree\":" p ",\"count\":" n "},\"corners\":{" corners        \
    "}" more "}"
#define CORNERS(a, b, c, d) "\"u0v0\":" a ",\"u1v0\":" b ",\"u0v1\":" c ",\"u1v1\":" d
#define FILM(patches, seams, more)                                                                 \
    "{\"taut\":1,\"construct\":\"film\",\"patches\":[" patches "],\"seams\":[" seams "]" more "}"

/* Four edges of a tetrahedron in the unit cube, whose film is Schwarz's D, in two by two patches: one of them is turned over, and
 * its seams run backwards. */
#define QUAD(n, more)                                                                              \
    FILM(PATCH(                                                                                    \
             "a", "4", n, CORNERS("[0,0,0]", "[0.5,0.5,0]", "[0.5,0,0.5]", "null"),                \
             "") "," PATCH("b", "4", n, CORNERS("[0.5,0.5,0]", "[1,1,0]", "null", "[0.5,1,0.5]"),  \
                           "") "," PATCH("c", "4", n,                                              \
                                         CORNERS("null", "[0.5,1,0.5]", "[0.5,0.5,1]", "[0,1,1]"), \
                                         "") "," PATCH("d", "4", n,                                \
                                                       CORNERS("[1,0,1]", "[0.5,0.5,1]",           \
                                                               "[0.5,0,0.5]", "null"),             \
                                                       ""),                                        \
         "[\"a.u1\",\"b.u0\"],[\"b.v1\",\"c.v0\"],[\"a.v1\",\"d.v1\"],[\"c.u0\",\"-d.u1\"]", more)
static const double quad_area = 1.279261571171006466; /* K(sqrt 3 / 2) / K(1 / 2) */

/* What a certificate says. */
typedef struct proof {
    taut_verdict holds;
    double residual, lower, energy;
    char where[128];
} proof;

static proof prove(const taut_model *model, const taut_problem *problem)
{
    taut_certificate *certificate = NULL;
    proof p = {.lower = NAN};

    CHECK(taut_certify(model, problem, NULL, &certificate, NULL) == TAUT_OK, "certificate");
    const taut_claim *claim = claim_of(certificate, "least");
    p.holds = claim->holds;
    p.residual = claim->residual;
    p.lower = figure_of(certificate, "lower_bound");
    p.energy = figure_of(certificate, "energy");
    snprintf(p.where, sizeof p.where, "%s", claim->where);
    taut_certificate_free(certificate);
    return p;
}

static taut_model *make(const taut_problem *problem)
{
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_make(problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    return model;
}

static int begins(const char *text, const char *word)
{
    return strncmp(text, word, strlen(word)) == 0;
}

/* ---- a closed form ---- */

/* On 8 and, where knots of a seam that is run backwards are off by rounding, 9 spans. */
static void test_quad(void)
{
    static const struct {
        const char *text;
        double tension;
    } rows[] = {{QUAD("12", ""), 1}, {QUAD("13", ""), 1}};

    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        taut_problem *problem = problem_read(rows[k].text);
        taut_model *model = make(problem);
        const proof p = prove(model, problem);
        CHECK(p.holds == TAUT_TRUE && p.residual < 2e-13, "%g, %s", p.residual, p.where);
        CHECK(p.lower <= quad_area * (1 + 1e-15), "%.17g is no lower bound", p.lower);
        CHECK_NEAR(p.lower, quad_area, 4e-13, "bound");
        CHECK_NEAR(p.energy, quad_area, 4e-13, "energy");
        taut_model_free(model);
        taut_problem_free(problem);
    }
}

/* ---- witnesses that lie ---- */

/* Where the coefficients of the first patch begin among the numbers of the witness, on 8 points of degree 4. */
enum { SIDE = 16, FIRST = 3 + 2 * (1 + SIDE + 7) };

static double coefficient_of(const taut_model *model, int i, int j)
{
    const taut_record *patches =
        taut_record_get(taut_record_get(taut_model_details(model), "least"), "patches");
    const taut_record *rows = taut_record_get(taut_record_at(patches, 0), "coefficients");
    CHECK(taut_record_count(rows) == SIDE, "%d rows", (int)taut_record_count(rows));
    return taut_record_number(taut_record_at(taut_record_at(rows, (size_t)i), (size_t)j));
}

/* One coefficient is another: inside a patch the bound is weaker, or none; along a seam it is none. */
static void test_coefficients(const taut_model *model, const taut_problem *problem)
{
    static const struct {
        double by;
        const char *why;
    } rows[] = {{1e-4, ""}, {-1e-4, ""}, {3, "steep: "}, {-3, "steep: "}};

    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        taut_model *other = witness_changed(
            model, (witness_change){.at = FIRST + SIDE * 5 + 6,
                                    .instead = coefficient_of(model, 5, 6) + rows[k].by});
        const proof p = prove(other, problem);
        CHECK(rows[k].why[0] != '\0'
                  ? begins(p.where, rows[k].why)
                  : p.lower < quad_area * (1 - 1e-9) && p.lower > 0.9 * quad_area,
              "by %g: %.17g, %s", rows[k].by, p.lower, p.where);
        taut_model_free(other);
    }
    for (int trial = 0; trial < random_trials(40); trial++) {
        const int i = random_int(0, SIDE - 1), j = random_int(0, SIDE - 1);
        const double by = random_log(1e-9, 3) * (random_int(0, 1) == 0 ? -1 : 1);
        taut_model *other =
            witness_changed(model, (witness_change){.at = FIRST + SIDE * i + j,
                                                    .instead = coefficient_of(model, i, j) + by});
        const proof p = prove(other, problem);
        const int is_shared = i == SIDE - 1 || j == SIDE - 1;
        CHECK(!(p.lower > quad_area * (1 + 1e-15)), "%d %d by %g: %.17g", i, j, by, p.lower);
        CHECK(p.holds != TAUT_FALSE, "nothing was asked for");
        CHECK(!is_shared || begins(p.where, "seams: "), "%d %d: %s", i, j, p.where);
        taut_model_free(other);
    }
}

static void test_numbers(const taut_model *model, const taut_problem *problem)
{
    static const char *const members[] = {NULL, "direction", "knots", "degree", "coefficients"};

    for (int trial = 0; trial < random_trials(40); trial++) {
        const double size = random_log(1e-14, 3);
        taut_model *other = witness_changed(
            model, (witness_change){.at = -1, .by = size, .only = members[trial % 5]});
        const proof p = prove(other, problem);
        CHECK(!(p.lower > quad_area * (1 + 1e-15)), "size %g: %.17g", size, p.lower);
        CHECK(p.holds != TAUT_FALSE, "nothing was asked for");
        taut_model_free(other);
    }
}

static void test_changed(void)
{
    static const struct {
        witness_change c;
        const char *why;
    } rows[] = {
        {{.at = -1, .without = "direction"}, "witness: invalid direction"},
        {{.at = -1, .without = "patches"}, "witness: it is not one of as many patches"},
        {{.at = -1, .without = "knots"}, "witness: its bases"},
        {{.at = -1, .without = "coefficients"}, "witness: its coefficients"},
        {{.at = FIRST + 20, .instead = NAN}, "witness: its coefficients"},
        {{.at = 0, .instead = -20}, "folds"},
    };
    taut_problem *problem = problem_read(QUAD("8", ""));
    taut_model *model = make(problem);

    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        taut_model *other = witness_changed(model, rows[k].c);
        const proof p = prove(other, problem);
        const int folds = begins(rows[k].why, "folds");
        CHECK(folds ||
                  (p.holds == TAUT_UNDECIDED && isnan(p.lower) && begins(p.where, rows[k].why)),
              "%s: %s", rows[k].why, p.where);
        taut_model_free(other);
    }
    test_coefficients(model, problem);
    test_numbers(model, problem);
    taut_model_free(model);
    taut_problem_free(problem);
}

/* ---- films that it is no bound of ---- */

#define FLAT(more_a, more_b, seam, more)                                                           \
    FILM(PATCH("a", "2", "4", CORNERS("[0,0,0]", "[1,0,0]", "[0,1,0]", "[1,1,0]"),                 \
               more_a) "," PATCH("b", "2", "4",                                                    \
                                 CORNERS("[1,0,0]", "[2,0,0]", "[1,1,0]", "[2,1,0]"), more_b),     \
         seam, more)
#define HALF(name, p, q, r)                                                                        \
    PATCH(name, "4", "10", "",                                                                     \
          ",\"edges\":{\"v0\":{\"fixed\":{\"arc\":[[" p ",0],[" q ",0],[" r                        \
          ",0]]}},\"v1\":{\"fixed\":{\"arc\":[[" p ",1],[" q ",1],[" r ",1]]}}}")

static void test_obstacles(void)
{
    static const struct {
        const char *text, *why;
    } rows[] = {
        {FLAT("", "", "[\"a.u1\",\"b.u0\"]", ""), ""},
        {FLAT("", "", "[\"a.u1\",\"b.u0\"]", ",\"least\":false"), "declined"},
        {FILM(HALF("f", "1,0", "0,1", "-1,0") "," HALF("g", "1,0", "0,-1", "-1,0"),
              "[\"f.u0\",\"g.u0\"],[\"f.u1\",\"g.u1\"]", ""),
         "curves"},
        {FILM(PATCH("a", "2", "4", CORNERS("[0,0,0]", "[1,0,0]", "[0,0,1]", "[1,0,1]"),
                    "") "," PATCH("b", "2", "4",
                                  CORNERS("[0,0,0]", "[-1,1,0]", "[0,0,1]", "[-1,1,1]"),
                                  "") "," PATCH("c", "2", "4",
                                                CORNERS("[0,0,0]", "[-1,-1,0]", "[0,0,1]",
                                                        "[-1,-1,1]"),
                                                ""),
              "[\"a.u0\",\"b.u0\",\"c.u0\"]", ""),
         "lines"},
    };

    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        taut_problem *problem = problem_read(rows[k].text);
        taut_model *model = make(problem);
        const proof p = prove(model, problem);
        const int is_there = rows[k].why[0] == 0;
        CHECK(p.holds == (is_there ? TAUT_TRUE : TAUT_UNDECIDED), "%s: %s", rows[k].why, p.where);
        CHECK(begins(p.where, rows[k].why), "expected %s, found %s", rows[k].why, p.where);
        CHECK(is_there || taut_record_get(taut_model_details(model), "least") == NULL,
              "%s: there is no witness", rows[k].why);
        taut_model_free(model);
        taut_problem_free(problem);
    }
}

/* ---- lines of three sheets ---- */

/* Walls of height 1 from a line to the corners of a triangle, between planes; the line starts, or is held, at a place. */
static void write_walls(const double at[2], int is_held, char text[4096])
{
    static const double corner[3][2] = {{0, 0}, {2, 0}, {0.5, 1.5}};
    size_t used = (size_t)snprintf(text, 4096, "{\"taut\":1,\"construct\":\"film\",\"patches\":[");
    for (int k = 0; k < 3; k++) {
        used += (size_t)snprintf(
            text + used, 4096 - used,
            "%s{\"name\":\"%c\",\"u\":{\"type\":\"bspline\",\"degree\":2,\"count\":3},"
            "\"v\":{\"type\":\"bspline\",\"degree\":2,\"count\":3},\"corners\":{",
            k > 0 ? "," : "", 'a' + k);
        for (int z = 0; z < 2; z++) {
            used += (size_t)snprintf(text + used, 4096 - used,
                                     is_held ? "\"u0v%d\":[%.17g,%.17g,%d],"
                                             : "\"u0v%d\":{\"near\":[%.17g,%.17g,%d]},",
                                     z, at[0], at[1], z);
        }
        used += (size_t)snprintf(text + used, 4096 - used,
                                 "\"u1v0\":[%g,%g,0],\"u1v1\":[%g,%g,1]},\"edges\":{"
                                 "\"v0\":{\"slide\":{\"point\":[0,0,0],\"normal\":[0,0,1]}},"
                                 "\"v1\":{\"slide\":{\"point\":[0,0,1],\"normal\":[0,0,1]}}}}",
                                 corner[k][0], corner[k][1], corner[k][0], corner[k][1]);
    }
    (void)snprintf(text + used, 4096 - used, "],\"seams\":[[\"a.u0\",\"b.u0\",\"c.u0\"]]}");
}

/* Fermat's point is proved least; no place of the line leads to a bound above it. */
static void test_walls(void)
{
    const double least = sqrt(5.5 + 3 * sqrt(3)), fermat[2] = {0.65108474, 0.52337289};
    char text[4096];

    write_walls((double[2]){0.9, 0.4}, 0, text);
    taut_problem *asked = problem_read(text);
    taut_model *model = make(asked);
    const proof p = prove(model, asked);
    CHECK(p.holds == TAUT_TRUE && p.residual < 1e-12, "%g, %s", p.residual, p.where);
    CHECK(p.lower <= least, "%.17g is no lower bound of %.17g", p.lower, least);
    CHECK_NEAR(p.lower, least, 1e-12, "bound");
    taut_model_free(model);
    for (int trial = 0; trial < random_trials(40); trial++) {
        const double by = random_log(1e-9, 0.1), angle = random_in(0, 6.28);
        const double at[2] = {fermat[0] + by * cos(angle), fermat[1] + by * sin(angle)};
        write_walls(at, 1, text);
        taut_problem *held = problem_read(text);
        model = make(held);
        const proof other = prove(model, asked);
        CHECK(!(other.lower > least), "%g away: %.17g is above the least", by, other.lower);
        CHECK(other.holds != TAUT_FALSE && (by < 1e-2 || other.holds == TAUT_UNDECIDED), "%g away",
              by);
        taut_model_free(model);
        taut_problem_free(held);
    }
    taut_problem_free(asked);
}

/* ---- sides, in turn ---- */

static void find_rim(const taut_problem *problem, taut_arena *arena, taut_film_complex *complex,
                     taut_film_rim *rim)
{
    const taut_film_problem *film = problem->data;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_film_complex_new(film, arena, complex, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_film_rim_find(complex, arena, rim) == TAUT_OK, "rim");
}

static void test_rims(void)
{
    static const struct {
        const char *text, *why;
    } rows[] = {
        /* A strip of three, closed with half a turn. */
        {FILM(PATCH("a", "2", "3", CORNERS("[2,0,1]", "[-1,2,1]", "[2,0,-1]", "[-1,2,-1]"),
                    "") "," PATCH("b", "2", "3", CORNERS("null", "[-1,-2,1]", "null", "[-1,-2,-1]"),
                                  "") "," PATCH("c", "2", "3",
                                                CORNERS("null", "null", "null", "null"), ""),
              "[\"a.u1\",\"b.u0\"],[\"b.u1\",\"c.u0\"],[\"c.u1\",\"-a.u0\"]", ""),
         "sides"},
        {FLAT("", ",\"tension\":2", "[\"a.u1\",\"b.u0\"]", ""), "tension"},
        {FLAT(",\"edges\":{\"u0\":{\"slide\":{\"point\":[0,0,0],\"normal\":[1,0,0]}}}",
              ",\"tension\":2", "[\"a.u1\",\"b.u0\"]", ""),
         "tension"},
        /* Holding what slides would lead to no bound. */
        {FILM(PATCH("a", "2", "3", CORNERS("[0,0,0]", "[1,0,0]", "[0,0,1]", "[1,0,1]"),
                    ",\"edges\":{\"v0\":{\"slide\":{\"point\":[0,0,0],\"normal\":[0,0,1]}}"
                    "}") "," PATCH("b", "2", "3", CORNERS("null", "[-1,1,0]", "null", "[-1,1,1]"),
                                   "") "," PATCH("c", "2", "3",
                                                 CORNERS("null", "[-1,-1,0]", "null", "[-1,-1,1]"),
                                                 ""),
              "[\"a.u0\",\"b.u0\",\"c.u0\"]", ""),
         "lines"},
        {FLAT(",\"force_density\":[1,1]", "", "[\"a.u1\",\"b.u0\"]", ""), "threads"},
        {FLAT("", "", "{\"edges\":[\"a.u1\",\"b.u0\"],\"cable\":{\"force\":1}}", ""), "cables"},
        {FLAT("", ",\"edges\":{\"u1\":{\"cable\":{\"force\":3}}}", "[\"a.u1\",\"b.u0\"]", ""),
         "cables"},
        {FLAT("", ",\"edges\":{\"u1\":{\"slide\":{\"point\":[2,0,0],\"normal\":[1,0,0]}}}",
              "[\"a.u1\",\"b.u0\"]", ""),
         "moving"},
        {FLAT("", "", "[\"a.u1\",\"b.u0\"]",
              ",\"cells\":[{\"sides\":[\"a\",\"b\"],\"pressure\":0.1}]"),
         "cells"},
        {FLAT("", "", "", ""), "apart"},
    };

    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        taut_problem *problem = problem_read(rows[k].text);
        taut_arena *arena = taut_arena_new();
        taut_film_complex complex;
        taut_film_rim rim;
        find_rim(problem, arena, &complex, &rim);
        CHECK(rim.why != NULL && begins(rim.why, rows[k].why), "%s: %s", rows[k].why,
              rim.why != NULL ? rim.why : "one");
        taut_arena_free(arena);
        taut_problem_free(problem);
    }
}

/* ---- a boundary that goes round twice ---- */

enum { ANGLES = 3 /* twice as many have one centre */, NET = 3 };

/* A polygon of ANGLES corners, run through `times` times, as `curves` are laid out: sheets in its plane, about one centre. */
static void polygon(int times, double corner[2 * ANGLES][3], char text[4096])
{
    const int count = times * ANGLES;
    size_t used = (size_t)snprintf(text, 4096,
                                   "{\"taut\":1,\"construct\":\"film\",\"degree\":2,"
                                   "\"count\":3,\"curves\":[");

    for (int k = 0; k < count; k++) {
        const double angle = 2 * M_PI * k / ANGLES;
        corner[k][0] = cos(angle);
        corner[k][1] = sin(angle);
        corner[k][2] = 0;
    }
    for (int k = 0; k < count; k++) {
        const double *a = corner[k], *b = corner[(k + 1) % count];
        used += (size_t)snprintf(text + used, 4096 - used,
                                 "%s{\"line\":[[%.17g,%.17g,0],[%.17g,%.17g,0]]}", k > 0 ? "," : "",
                                 a[0], a[1], b[0], b[1]);
    }
    (void)snprintf(text + used, 4096 - used, "]}");
}

/* The sheet at corner k: a quad between the corner, the middles of its edges and the centre. */
static taut_surface *quad_at(const taut_film_problem *patch, int count, double corner[][3], int k)
{
    double points[NET][NET][3];
    const double *at = corner[k], *next = corner[(k + 1) % count],
                 *last = corner[(k + count - 1) % count];
    taut_surface *surface = NULL;

    for (int i = 0; i < NET; i++) {
        for (int j = 0; j < NET; j++) {
            const double u = 0.5 * i, v = 0.5 * j;
            for (int c = 0; c < 3; c++) {
                points[i][j][c] = (1 - u) * (1 - v) * at[c] +
                                  u * (1 - v) * 0.5 * (at[c] + next[c]) +
                                  (1 - u) * v * 0.5 * (at[c] + last[c]);
            }
        }
    }
    CHECK(taut_surface_new("", patch->u, patch->v, points[0][0], NULL, &surface, NULL) == TAUT_OK,
          "surface");
    return surface;
}

/* psi = 0 on all, seen along +-z. */
static taut_record *plain_witness(int count, double z)
{
    static const double none[NET] = {0, 0, 0}, knots[2 * NET] = {0, 0, 0, 1, 1, 1};
    const double e[3] = {0, 0, z};
    taut_record *witness = taut_record_new();
    taut_record_add_numbers(witness, "direction", 3, e);
    taut_record *patches = taut_record_add_list(witness, "patches");

    for (int k = 0; k < count; k++) {
        taut_record *patch = taut_record_add_object(patches, NULL);
        for (int d = 0; d < 2; d++) {
            taut_record *basis = taut_record_add_object(patch, d == 0 ? "u" : "v");
            taut_record_add_text(basis, "type", "bspline");
            taut_record_add_number(basis, "degree", NET - 1);
            taut_record_add_numbers(basis, "knots", 2 * NET, knots);
        }
        taut_record *rows = taut_record_add_list(patch, "coefficients");
        for (int i = 0; i < NET; i++) {
            taut_record_add_numbers(rows, NULL, NET, none);
        }
    }
    return witness;
}

/* Once round, the flat polygon is the least of all; twice round all angles are left ones too, and all sheets lie alike. */
static void test_round(int times, double z, const char *why)
{
    char text[4096];
    double corner[2 * ANGLES][3];
    const taut_surface *surfaces[2 * ANGLES];
    const int count = times * ANGLES;
    polygon(times, corner, text);
    taut_problem *problem = problem_read(text);
    const taut_film_problem *film = problem->data;
    taut_arena *arena = taut_arena_new();
    taut_record *witness = plain_witness(count, z);
    taut_film_complex complex;
    taut_film_rim rim;
    taut_least_finding found;

    find_rim(problem, arena, &complex, &rim);
    CHECK(rim.why == NULL && rim.count == 2 * count, "one curve of %d sides", rim.count);
    for (int k = 0; k < count; k++) {
        surfaces[k] = quad_at(&film->patches[k], count, corner, k);
    }
    CHECK(taut_complex_least_of(&complex, surfaces, witness, NULL, &found) == TAUT_OK, "least");
    if (why == NULL) {
        CHECK(found.why == NULL && found.gap <= 1e-14, "%s, gap %g",
              found.why != NULL ? found.why : "found", found.gap);
    } else {
        CHECK(found.why != NULL && begins(found.why, why), "%d times: %s", times,
              found.why != NULL ? found.why : "a bound");
    }
    for (int k = 0; k < count; k++) {
        taut_surface_free((taut_surface *)(uintptr_t)surfaces[k]);
    }
    taut_record_free(witness);
    taut_arena_free(arena);
    taut_problem_free(problem);
}

int main(void)
{
    random_seed(26);
    test_quad();
    test_changed();
    test_obstacles();
    test_walls();
    test_rims();
    test_round(1, 1, NULL);
    test_round(1, -1, NULL);
    test_round(2, 1, "outline");
    return check_failures != 0;
}
