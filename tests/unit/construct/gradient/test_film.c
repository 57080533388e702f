/* test_film.c -- derivatives of sails: against circles, against films of moved problems, against sums that must be 0.
 *
 * A flat sail on a square is bounded by arcs of radius R = T / s over chords c, sin a = c / (2 R):
 *
 *     area c^2 - 4 R^2 (a - sin a cos a),   length 2 R a of each cable
 */
#include "check.h"
#include "rings.h"
#include "sails.h"
#include "taut/gradient.h"
#include "taut/measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static taut_film_slopes slopes_of(const taut_film_problem *problem, taut_film_gradient_of of,
                                  int edge)
{
    const taut_film_gradient_request request = {.of = of, .edge = edge, .corner = 1, .axis = 2};
    taut_film_slopes slopes = {.points = NULL};
    taut_error error = {.message = ""};
    taut_model *model = NULL;

    CHECK(taut_film_make(problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_film_gradient(problem, model, &request, &slopes, &error) == TAUT_OK, "%s",
          error.message);
    taut_model_free(model);
    return slopes;
}

/* ---- circles ---- */

static void test_circles(void)
{
    const double radius = 2, chord = 2, a = asin(chord / (2 * radius));
    const double by_radius = -chord / (2 * radius * radius * cos(a));
    const double length = 2 * a + 2 * radius * by_radius;
    const double area =
        -8 * radius * (a - sin(a) * cos(a)) - 8 * radius * radius * sin(a) * sin(a) * by_radius;
    sail s = sail_new(4, 12, sail_square, 2);
    s.problem.tolerance = 1e-13;
    const taut_film_slopes of_energy = slopes_of(&s.problem, TAUT_FILM_GRADIENT_ENERGY, 0),
                           of_area = slopes_of(&s.problem, TAUT_FILM_GRADIENT_AREA, 0),
                           of_length = slopes_of(&s.problem, TAUT_FILM_GRADIENT_LENGTH, 0);
    double sum = 0, sums = 0;

    for (int e = 0; e < 4; e++) {
        CHECK_NEAR(of_energy.laws[e], 2 * radius * a, 1e-9, "dE/dT = L of edge %d", e);
        sum += of_area.laws[e];
        sums += of_length.laws[e];
    }
    CHECK_NEAR(sum, area, 1e-7, "area by all forces");
    CHECK_NEAR(sums, length, 1e-7, "length by all forces");
    sail_free(&s);
}

/* ---- films of moved problems ---- */

enum { INPUTS = 17 }; /* corners, laws, one stiffness */

/* Input i of a problem with an elastic cable v0. */
static double *input_of(taut_film_problem *problem, int i)
{
    taut_film_edge *edge = &problem->edges[(i - 12) & 3];

    if (i < 12) {
        return &problem->corners[i / 3][i % 3];
    }
    if (i == 16) {
        return &problem->edges[2].stiffness;
    }
    return edge->law == TAUT_FILM_FORCE    ? &edge->force
           : edge->law == TAUT_FILM_LENGTH ? &edge->length
           : edge->law == TAUT_FILM_SAG    ? &edge->sag
                                           : &edge->unstressed;
}

static double slope_by(const taut_film_slopes *slopes, int i)
{
    return i < 12   ? slopes->corners[i / 3][i % 3]
           : i < 16 ? slopes->laws[i - 12]
                    : slopes->stiffness[2];
}

static double value_of(const taut_film_problem *problem, taut_film_gradient_of of, int edge)
{
    static const char *const names[] = {"energy", "area", "lengths", "tensions", ""};
    taut_certificate *certificate = NULL;
    taut_model *model = NULL;
    double value = 0;

    if (of == TAUT_FILM_GRADIENT_REACTION) { /* by its corner alone, at corner 1 along z */
        static double points[3 * 400];
        taut_film_slopes slopes = {.points = points};
        CHECK(taut_film_make(problem, NULL, &model, NULL) == TAUT_OK, "made");
        CHECK(taut_film_gradient(problem, model, NULL, &slopes, NULL) == TAUT_OK, "derived");
        const int nu = taut_basis_count(problem->u), nv = taut_basis_count(problem->v);
        value = -points[3 * (nu - 1) * nv + 2];
    } else {
        model = film_made(problem, &certificate, "moved");
        value = of == TAUT_FILM_GRADIENT_ENERGY || of == TAUT_FILM_GRADIENT_AREA
                    ? taut_record_number(
                          taut_record_get(taut_certificate_figures(certificate), names[of]))
                    : sail_figure(certificate, names[of], (size_t)edge);
    }
    taut_certificate_free(certificate);
    taut_model_free(model);
    return value;
}

/* By differences of fourth order along a random direction of all inputs: *found, and the library's. */
static void test_moved(const taut_film_problem *problem, double tolerance, const char *what)
{
    static const taut_film_gradient_of numbers[] = {
        TAUT_FILM_GRADIENT_ENERGY, TAUT_FILM_GRADIENT_AREA, TAUT_FILM_GRADIENT_LENGTH,
        TAUT_FILM_GRADIENT_TENSION, TAUT_FILM_GRADIENT_REACTION};
    static const double share[4] = {8, -8, -1, 1}, at[4] = {1, -1, 2, -2};
    const double h = 5e-4;
    double direction[INPUTS];

    for (int i = 0; i < INPUTS; i++) {
        taut_film_problem moved = *problem;
        const double value = *input_of(&moved, i);
        direction[i] = i < 12 ? random_in(-1, 1) : value * random_in(-0.3, 0.3);
    }
    for (size_t n = 0; n < sizeof numbers / sizeof *numbers; n++) {
        const int edge = random_int(0, 3);
        const taut_film_slopes slopes = slopes_of(problem, numbers[n], edge);
        double found = 0, expected = 0, size = 0;
        for (int i = 0; i < INPUTS; i++) {
            found += slope_by(&slopes, i) * direction[i];
            size += fabs(slope_by(&slopes, i) * direction[i]);
        }
        for (int k = 0; k < 4; k++) {
            taut_film_problem moved = *problem;
            for (int i = 0; i < INPUTS; i++) {
                *input_of(&moved, i) += at[k] * h * direction[i];
            }
            expected += share[k] * value_of(&moved, numbers[n], edge) / (12 * h);
        }
        CHECK_NEAR(found, expected, tolerance * size, "%s: number %d, edge %d", what,
                   (int)numbers[n], edge);
    }
}

static void test_laws(void)
{
    sail s = sail_new(3, 7, sail_saddle, 2);

    s.problem.tolerance = 1e-13;
    s.problem.without_least = 1;
    s.problem.edges[1] =
        (taut_film_edge){.kind = TAUT_FILM_CABLE, .law = TAUT_FILM_LENGTH, .length = 2.4};
    s.problem.edges[2] = (taut_film_edge){
        .kind = TAUT_FILM_CABLE, .law = TAUT_FILM_ELASTIC, .unstressed = 2.2, .stiffness = 30};
    s.problem.edges[3] =
        (taut_film_edge){.kind = TAUT_FILM_CABLE, .law = TAUT_FILM_SAG, .sag = 0.12};
    for (int trial = 0; trial < random_trials(1); trial++) {
        test_moved(&s.problem, 1e-6, "laws");
    }
    s.problem.force_density[0] = 1; /* points have one place only: differences find more digits */
    s.problem.force_density[1] = 2;
    test_moved(&s.problem, 1e-8, "threads");
    sail_free(&s);
}

/* ---- a straight edge, a film that is turned or shifted ---- */

static void test_sums(void)
{
    sail s = sail_new(4, 8, sail_saddle, 2);
    static double points[3 * 64];
    taut_film_slopes slopes = {.points = points};
    const taut_film_gradient_request area = {.of = TAUT_FILM_GRADIENT_AREA};
    taut_model *model = NULL;
    double by_growth = 0, by_points = 0;

    s.problem.edges[1] = (taut_film_edge){.kind = TAUT_FILM_FIXED};
    CHECK(taut_film_make(&s.problem, NULL, &model, NULL) == TAUT_OK, "made");
    CHECK(taut_film_gradient(&s.problem, model, &area, &slopes, NULL) == TAUT_OK, "derived");
    for (int k = 0; k < 3; k++) {
        double sum = 0;
        for (int c = 0; c < 4; c++) {
            sum += slopes.corners[c][k];
            by_growth += slopes.corners[c][k] * s.problem.corners[c][k];
        }
        CHECK_NEAR(sum, 0, 1e-9, "a film that is shifted along axis %d keeps its area", k);
    }
    for (int e = 0; e < 4; e++) { /* forces grow with lengths, the area with their square */
        by_growth += slopes.laws[e] * (e == 1 ? 0 : 2);
        by_points += slopes.laws[e] * (e == 1 ? 0 : 2);
    }
    for (int i = 0; i < 192; i++) {
        by_points += points[i] * taut_surface_points(taut_model_surface(model, 0))[i];
    }
    double value = 0, unsure = 0;
    CHECK(taut_surface_area(taut_model_surface(model, 0), &value, &unsure) == TAUT_OK, "measured");
    CHECK_NEAR(by_growth, 2 * value, 1e-7, "a film that grows");
    CHECK_NEAR(by_points, 2 * value, 1e-7, "the same by all points that are held");
    taut_model_free(model);
    sail_free(&s);
}

/* ---- films that go around ---- */

enum { AROUND = 9, ALONG = 5 };

/* A ring whose lower edge is held on a circle of this radius and height, drawn together by a cable or held above. */
static ring ring_of(double radius, double z, int law, double given)
{
    ring r = ring_new(3, AROUND, 3, ALONG);
    ring_circle(&r, 0, z, radius);
    if (law < 0) {
        ring_circle(&r, 1, 0.6, 0.8);
        return r;
    }
    ring_cable(&r, 1, 0.2, given);
    taut_film_edge *edge = &r.problem.edges[3];
    edge->law = (taut_film_law)law;
    if (law == TAUT_FILM_LENGTH) {
        edge->length = given;
    } else if (law == TAUT_FILM_ELASTIC) {
        edge->unstressed = given;
        edge->stiffness = 7;
    }
    return r;
}

/* The number of the ring, and the points of its net; its slopes where they are asked for. */
static double ring_value(ring *r, taut_film_gradient_of of, double *points,
                         taut_film_slopes *slopes)
{
    static const char *const names[] = {"energy", "area", "lengths", "tensions"};
    const taut_film_gradient_request request = {.of = of, .edge = 3};
    taut_certificate *certificate = NULL;
    taut_error error = {.message = ""};
    r->problem.tolerance = 1e-12;
    r->problem.without_least = 1;
    taut_model *model = film_made(&r->problem, &certificate, "ring");
    const double value =
        of <= TAUT_FILM_GRADIENT_AREA
            ? taut_record_number(taut_record_get(taut_certificate_figures(certificate), names[of]))
            : sail_figure(certificate, names[of], 0);

    memcpy(points, taut_surface_points(taut_model_surface(model, 0)),
           3 * AROUND * ALONG * sizeof(double));
    if (slopes != NULL) {
        CHECK(taut_film_gradient(&r->problem, model, &request, slopes, &error) == TAUT_OK,
              "number %d: %s", (int)of, error.message);
    }
    taut_certificate_free(certificate);
    taut_model_free(model);
    return value;
}

/* Radius, height and what the cable is given, along a random way of all three, by differences of fourth order. */
static void test_rings(void)
{
    static const double share[4] = {8, -8, -1, 1}, at[4] = {1, -1, 2, -2};
    static const struct {
        int law;
        double given, h; /* between films that differ within themselves, wider steps */
    } rows[] = {{-1, 0, 4e-3},
                {TAUT_FILM_FORCE, 0.3, 1e-3},
                {TAUT_FILM_LENGTH, 5.4, 1e-3},
                {TAUT_FILM_ELASTIC, 5.2, 1e-3}};

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const double h = rows[k].h;
        for (int of = 0; of <= (rows[k].law < 0 ? 1 : 3); of++) {
            static double points[4][3 * AROUND * ALONG], held[3 * AROUND * ALONG];
            static double by_points[3 * AROUND * ALONG];
            taut_film_slopes slopes = {.points = by_points};
            ring r = ring_of(1, 0, rows[k].law, rows[k].given);
            ring_value(&r, (taut_film_gradient_of)of, held, &slopes);
            ring_free(&r);
            const double way[3] = {random_in(-1, 1), random_in(-1, 1), random_in(-1, 1)};
            double expected = 0, found = slopes.laws[3] * way[2];
            for (int m = 0; m < 4; m++) {
                const double step = at[m] * h;
                r = ring_of(1 + step * way[0], step * way[1], rows[k].law,
                            rows[k].given + step * way[2]);
                expected += share[m] / (12 * h) *
                            ring_value(&r, (taut_film_gradient_of)of, points[m], NULL);
                ring_free(&r);
            }
            for (int i = 0; i < 3 * AROUND * ALONG; i++) {
                for (int m = 0; m < 4; m++) {
                    found += by_points[i] * share[m] / (12 * h) * points[m][i];
                }
            }
            CHECK_NEAR(found, expected, 1e-7, "law %d, number %d", rows[k].law, of);
        }
    }
}

/* ---- refused ---- */

static void refused(const taut_film_problem *problem, const taut_model *model,
                    taut_film_gradient_request request, const char *reason)
{
    taut_film_slopes slopes = {.laws = {7}};
    taut_error error = {.message = ""};
    const taut_status status = taut_film_gradient(problem, model, &request, &slopes, &error);

    CHECK(status != TAUT_OK && strcmp(error.reason, reason) == 0, "%s: %s", reason, error.message);
    CHECK(slopes.laws[0] == 7, "the output is untouched");
}

static void test_refused(void)
{
    sail s = sail_new(3, 6, sail_saddle, 2);
    taut_model *model = NULL;
    taut_film_problem other = s.problem;
    const taut_film_gradient_request none = {.of = TAUT_FILM_GRADIENT_ENERGY};

    CHECK(taut_film_make(&s.problem, NULL, &model, NULL) == TAUT_OK, "made");
    refused(NULL, model, none, "argument");
    refused(&s.problem, model, (taut_film_gradient_request){.of = (taut_film_gradient_of)9},
            "argument");
    refused(&s.problem, model, (taut_film_gradient_request){.edge = 4}, "argument");
    other.corners[0][0] -= 1e-3;
    refused(&other, model, none, "other-model");
    other = s.problem;
    other.edges[0].force = 2.1;
    refused(&other, model, none, "not-at-rest");
    other = s.problem;
    other.method = TAUT_FILM_NORMAL;
    refused(&other, model, none, "no-gradient");
    other = s.problem;
    other.edges[0] = (taut_film_edge){.kind = TAUT_FILM_FIXED};
    refused(&other, model, (taut_film_gradient_request){.of = TAUT_FILM_GRADIENT_TENSION},
            "argument");
    taut_model_free(model);
    sail_free(&s);
}

int main(void)
{
    test_circles();
    test_laws();
    test_sums();
    test_rings();
    test_refused();
    return check_failures != 0;
}
