/* test_refused.c -- films that are none: what is said, and the least forces against closed forms. */
#include "check.h"
#include "sails.h"

#include <string.h>

static taut_error refusal(const sail *s, taut_status status, const char *reason, const char *where,
                          const char *what)
{
    taut_error error = {.status = TAUT_OK};
    taut_model *model = NULL;
    const taut_status found = taut_film_make(&s->problem, NULL, &model, &error);

    CHECK(found == status && strcmp(error.reason, reason) == 0 && strcmp(error.where, where) == 0,
          "%s: status %d, %s at %s: %s", what, (int)found, error.reason, error.where,
          error.message);
    CHECK(model == NULL, "%s", what);
    taut_model_free(model);
    return error;
}

/* Flat sails: the corner of a square allows T > c / sqrt 2, where the arcs are quarter circles; in
 * a rectangle of 10 by 1 the long arcs meet first, R = (25 + 1/4) / 1; a rhombus is bound by its
 * sharp corner, R = c / (2 sin(angle / 2)). */
static void test_flat(void)
{
    const double long_one[4][3] = {{0, 0, 0}, {10, 0, 0}, {0, 1, 0}, {10, 1, 0}};
    const double rhombus[4][3] = {{0, 0, 0}, {2, 0.5, 0}, {2, -0.5, 0}, {4, 0, 0}};
    const double chord = sqrt(4.25), angle = 2 * atan(0.25);
    const struct {
        const double (*corners)[3];
        double force, least;
        const char *what;
    } rows[] = {{sail_square, 1.4, sqrt(2.0), "square"},
                {sail_square, 0.9, sqrt(2.0), "square, below its chords"},
                {long_one, 12, 25.25, "rectangle"},
                {rhombus, 2, chord / (2 * sin(angle / 2)), "rhombus"}};

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        sail s = sail_new(4, 12, rows[k].corners, rows[k].force);
        const taut_error error =
            refusal(&s, TAUT_NO_SOLUTION, "cable-too-weak", "/edges/u0/cable", rows[k].what);
        CHECK_NEAR(error.limit, rows[k].least, 1e-11 * rows[k].least, "%s", rows[k].what);
        CHECK(error.found == rows[k].force, "%s", rows[k].what);
        sail_free(&s);
    }
    for (size_t k = 0; k < 3; k++) { /* and a little above there is one */
        taut_model *model = NULL;
        sail s = sail_new(4, 12, rows[k].corners, 1.02 * rows[k].least);
        CHECK(taut_film_make(&s.problem, NULL, &model, NULL) == TAUT_OK, "%s", rows[k].what);
        taut_model_free(model);
        sail_free(&s);
    }
}

/* One cable between straight edges: it may not reach the edge across. */
static void test_half_flat(void)
{
    const double corners[4][3] = {{0, 0, 0}, {4, 0, 0}, {0, 1, 0}, {4, 1, 0}};
    sail s = sail_new(4, 12, corners, 0);

    s.problem.edges[3] = (taut_film_edge){.kind = TAUT_FILM_CABLE, .force = 2.4};
    const taut_error error =
        refusal(&s, TAUT_NO_SOLUTION, "cable-too-weak", "/edges/v1/cable", "one cable");
    CHECK_NEAR(error.limit, 2.5, 1e-11, "rise 1 over a chord of 4: R = (4 + 1) / 2");
    sail_free(&s);
}

/* In space no closed form is known: the force told is one with a film, and 2 % less has none. */
static void test_space(void)
{
    sail s = sail_new(3, 8, sail_saddle, 1.5);
    const taut_error error =
        refusal(&s, TAUT_NO_SOLUTION, "cable-too-weak", "/edges/u0/cable", "saddle");
    CHECK(error.limit > 1.6 && error.limit < 1.75, "%g", error.limit);
    sail_free(&s);
    s = sail_new(3, 8, sail_saddle, 0.98 * error.limit);
    refusal(&s, TAUT_NO_SOLUTION, "cable-too-weak", "/edges/u0/cable", "saddle, below");
    sail_free(&s);
    taut_model *model = NULL;
    s = sail_new(3, 8, sail_saddle, 1.03 * error.limit);
    CHECK(taut_film_make(&s.problem, NULL, &model, NULL) == TAUT_OK, "saddle, above");
    taut_model_free(model);
    sail_free(&s);
}

/* Forces that no rule settles a film of say so too, and name the same force within a per cent. */
static void test_thin(void)
{
    static const double corners[4][3] = {{0, 0, 2}, {6, 0, 2}, {0, 4, 2}, {6, 4, 3}};
    static const double forces[] = {1, 2.5, 3.3};

    for (int k = 0; k < 3; k++) {
        sail s = sail_new(4, 12, corners, forces[k]);
        const taut_error error =
            refusal(&s, TAUT_NO_SOLUTION, "cable-too-weak", "/edges/u0/cable", "thin");
        CHECK(error.limit > 3.72 && error.limit < 3.757, "%g of %g", error.limit, forces[k]);
        sail_free(&s);
    }
}

static void test_data(void)
{
    const double crossed[4][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    const double line[4][3] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    const double same[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 1, 0}};
    const double far[4][3] = {{-1e308, 0, 0}, {1e308, 0, 0}, {0, 1e308, 0}, {1, 1, 0}};
    sail s = sail_new(4, 12, crossed, 2);
    refusal(&s, TAUT_NO_SOLUTION, "crossed", "/corners", "crossed");
    sail_free(&s);
    s = sail_new(4, 12, line, 2);
    refusal(&s, TAUT_NO_SOLUTION, "no-area", "/corners", "line");
    sail_free(&s);
    s = sail_new(4, 12, same, 2);
    refusal(&s, TAUT_NO_SOLUTION, "no-area", "/corners", "same");
    sail_free(&s);
    s = sail_new(4, 12, far, 2);
    refusal(&s, TAUT_NO_SOLUTION, "overflow", "/corners", "far");
    sail_free(&s);
    s = sail_new(1, 12, sail_square, 2);
    refusal(&s, TAUT_BAD_INPUT, "basis", "/u", "degree");
    sail_free(&s);
    s = sail_new(4, 51, sail_square, 2);
    refusal(&s, TAUT_BAD_INPUT, "size", "/u", "size");
    sail_free(&s);
    s = sail_new(4, 12, sail_square, 2);
    s.problem.edges[2].force = -1;
    refusal(&s, TAUT_BAD_INPUT, "value", "/edges/v0/cable/force", "force");
    s.problem.edges[2].force = 1e9;
    refusal(&s, TAUT_BAD_INPUT, "value", "/edges/v0/cable/force", "very strong");
    s.problem.edges[2].force = 2;
    s.problem.corners[3][1] = NAN;
    refusal(&s, TAUT_BAD_INPUT, "value", "/corners/u1v1/1", "NaN");
    s.problem.has_corner[3] = 0;
    refusal(&s, TAUT_BAD_INPUT, "corner-missing", "/corners/u1v1", "missing");
    s.problem.has_corner[3] = 1;
    s.problem.corners[3][1] = 2;
    s.problem.tension = -1;
    refusal(&s, TAUT_BAD_INPUT, "value", "/tension", "tension");
    s.problem.tension = 0;
    s.problem.tolerance = 1;
    refusal(&s, TAUT_BAD_INPUT, "value", "/tolerance", "tolerance");
    s.problem.tolerance = 0;
    s.problem.max_iterations = 1;
    refusal(&s, TAUT_NOT_CONVERGED, "not-converged", "", "one step");
    sail_free(&s);
    s = sail_helicoid(4, 12, 1, 1.2);
    s.problem.has_corner[1] = 1;
    s.problem.corners[1][0] = 2.1;
    refusal(&s, TAUT_BAD_INPUT, "curve-ends", "/edges/u1/fixed", "ends");
    sail_free(&s);
}

int main(void)
{
    test_flat();
    test_half_flat();
    test_space();
    test_thin();
    test_data();
    return check_failures != 0;
}
