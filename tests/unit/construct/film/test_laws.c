/* test_laws.c -- cables of given length, of given sag and elastic ones against closed forms: over a
 * flat sail each is an arc of a circle, whatever its law; and the laws against each other. */
#include "certificates.h"
#include "check.h"
#include "sails.h"

#include <string.h>

static const double chord = 2, pi = 3.14159265358979323846;

/* A sail on the square, or on a trapezoid that widens from one cable on a chord of 2. */
static sail new_sail(int count, const taut_film_edge *cable, int cables)
{
    static const double trapezoid[4][3] = {{0, 0, 0}, {3, -3, 0}, {0, 2, 0}, {3, 5, 0}};
    sail s = sail_new(4, count, cables == 4 ? sail_square : trapezoid, 0);
    for (int e = 0; e < cables; e++) {
        s.problem.edges[e] = *cable;
    }
    return s;
}

/* The area that an arc of half-angle a takes. */
static double segment(double a)
{
    const double r = chord / (2 * sin(a));
    return r * r * (a - sin(a) * cos(a));
}

static void check_arcs(const sail *s, int cables, double a, double energy, double tolerance,
                       const char *what)
{
    const double length = chord * a / sin(a), force = chord / (2 * sin(a));
    const double area = (cables == 4 ? 4 : 15) - cables * segment(a);
    /* L = c (1 + a^2 / 6 + ..): what rounding does to it moves the force by 3 / a^2 as much */
    const double given = s->problem.edges[0].law == TAUT_FILM_ELASTIC ? 0 : 1e-15 * 3 / (a * a);
    taut_certificate *proof = NULL;
    taut_model *model = sail_make(s, &proof);

    const double bound = tolerance * area + cables * force * 1e-15 * length; /* dA = -T dL */
    CHECK_NEAR(figure_of(proof, "area"), area, bound, "%s", what);
    CHECK_NEAR(figure_of(proof, "energy"), area + energy, bound + tolerance * energy, "%s", what);
    for (int e = 0; e < cables; e++) {
        CHECK_NEAR(sail_figure(proof, "tensions", (size_t)e), force,
                   (1e2 * tolerance + given) * force, "%s, edge %d", what, e);
        CHECK_NEAR(sail_figure(proof, "lengths", (size_t)e), length, 1e2 * tolerance * length,
                   "%s, edge %d", what, e);
        const taut_record *cable =
            taut_record_at(taut_record_get(taut_model_details(model), "cables"), (size_t)e);
        CHECK_NEAR(taut_record_number(taut_record_get(cable, "force")), force,
                   (1e2 * tolerance + given) * force, "%s, edge %d: details", what, e);
    }
    taut_certificate_free(proof);
    taut_model_free(model);
}

/* Degree 4 errs by the eighth power of a span's angle, as in test_film.c. */
static void test_lengths(void)
{
    const struct {
        double angle, tolerance;
    } rows[] = {{1e-3, 1e-13}, {0.1, 1e-12}, {pi / 6, 5e-12}, {0.7, 1e-9}};

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const double a = rows[k].angle;
        taut_film_edge edge = {
            .kind = TAUT_FILM_CABLE, .law = TAUT_FILM_LENGTH, .length = chord * a / sin(a)};
        sail s = new_sail(12, &edge, 4);
        check_arcs(&s, 4, a, 0, rows[k].tolerance, "length");
        sail_free(&s);
        edge = (taut_film_edge){
            .kind = TAUT_FILM_CABLE, .law = TAUT_FILM_SAG, .sag = 0.5 * tan(a / 2)};
        s = new_sail(12, &edge, 4);
        check_arcs(&s, 4, a, 0, rows[k].tolerance, "sag");
        sail_free(&s);
    }
}

/* Nearly half a circle: beyond it a cable of given force would be none. */
static void test_deep(void)
{
    const double a = 1.5;
    const taut_film_edge edge = {
        .kind = TAUT_FILM_CABLE, .law = TAUT_FILM_LENGTH, .length = chord * a / sin(a)};
    sail s = new_sail(20, &edge, 1);
    check_arcs(&s, 1, a, 0, 1e-8, "deep");
    sail_free(&s);
}

/* Four cables of a square, so long that arcs of 2.4 rad touch in its corners: there is no flat sail, before one is sought. */
static void test_too_long(void)
{
    const double a = 1.2;
    const taut_film_edge edge = {
        .kind = TAUT_FILM_CABLE, .law = TAUT_FILM_LENGTH, .length = chord * a / sin(a)};
    sail s = new_sail(8, &edge, 4);
    taut_error error = {.status = TAUT_OK};
    taut_model *model = NULL;
    CHECK(taut_film_make(&s.problem, NULL, &model, &error) == TAUT_NO_SOLUTION &&
              strcmp(error.reason, "cable-too-weak") == 0,
          "%s: %s", error.reason, error.message);
    /* each may be stressed until arcs of a quarter turn from corner to corner touch: sqrt(1/2) of a chord is the radius */
    CHECK_NEAR(error.limit, chord * sqrt(0.5), 1e-12 * chord, "the least force");
    taut_model_free(model);
    sail_free(&s);
}

/* EA is chosen for an unstressed length, and the other way round, so that the arc is known. */
static void test_elastic(void)
{
    const struct {
        double angle, unstressed, tolerance;
    } rows[] = {{0.05, 2.0, 1e-12},
                {0.3, 1.5, 1e-12},
                {pi / 6, 2.05, 5e-12},
                {0.7, 0.2, 1e-9},
                {0.3, 2.03, 1e-12} /* stiff */};

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const double a = rows[k].angle, l0 = rows[k].unstressed;
        const double length = chord * a / sin(a), force = chord / (2 * sin(a));
        const double stiffness = force * l0 / (length - l0);
        const taut_film_edge edge = {.kind = TAUT_FILM_CABLE,
                                     .law = TAUT_FILM_ELASTIC,
                                     .unstressed = l0,
                                     .stiffness = stiffness};
        sail s = new_sail(12, &edge, 4);
        const double energy = 4 * stiffness * (length - l0) * (length - l0) / (2 * l0);
        check_arcs(&s, 4, a, energy, rows[k].tolerance, "elastic");
        sail_free(&s);
    }
    /* the page's: EA and L0 round numbers */
    const taut_film_edge edge = {
        .kind = TAUT_FILM_CABLE, .law = TAUT_FILM_ELASTIC, .unstressed = 2.05, .stiffness = 40};
    sail s = new_sail(20, &edge, 4);
    taut_certificate *proof = NULL;
    taut_model *model = sail_make(&s, &proof);
    CHECK_NEAR(sail_figure(proof, "tensions", 0), 1.7042443219206245, 1e-9, "tension");
    CHECK_NEAR(sail_figure(proof, "lengths", 3), 2.13734252149843201, 1e-9, "length");
    CHECK_NEAR(figure_of(proof, "area"), 2.2349628794840626, 1e-10, "area");
    CHECK_NEAR(figure_of(proof, "energy"), 2.53266887213592824, 1e-9, "energy");
    taut_certificate_free(proof);
    taut_model_free(model);
    sail_free(&s);
}

/* In space: the lengths that forces make, given, make the forces. */
static void test_back(void)
{
    const double forces[4] = {2, 2.5, 3, 4};
    sail s = sail_new(4, 12, sail_saddle, 1);
    taut_certificate *one = NULL, *two = NULL;

    for (int e = 0; e < 4; e++) {
        s.problem.edges[e].force = forces[e];
    }
    taut_model *a = sail_make(&s, &one);
    for (int e = 0; e < 4; e++) {
        const double length = sail_figure(one, "lengths", (size_t)e);
        s.problem.edges[e] = e % 2 == 0 ? (taut_film_edge){.kind = TAUT_FILM_CABLE,
                                                           .law = TAUT_FILM_LENGTH,
                                                           .length = length}
                                        : (taut_film_edge){.kind = TAUT_FILM_CABLE,
                                                           .law = TAUT_FILM_ELASTIC,
                                                           .unstressed = 0.9 * length,
                                                           .stiffness = 9 * forces[e]};
    }
    taut_model *b = sail_make(&s, &two);
    CHECK_NEAR(figure_of(two, "area"), figure_of(one, "area"), 1e-9, "area");
    for (size_t e = 0; e < 4; e++) {
        CHECK_NEAR(sail_figure(two, "tensions", e), forces[e], 1e-8, "edge %zu", e);
    }
    CHECK_NEAR(sail_figure(two, "sags", 1), sail_figure(one, "sags", 1), 1e-6, "sag");
    taut_certificate_free(one);
    taut_certificate_free(two);
    taut_model_free(a);
    taut_model_free(b);
    sail_free(&s);
}

static double energy_of_length(double length, double *force)
{
    sail s = sail_new(4, 12, sail_saddle, 2);
    taut_certificate *proof = NULL;
    s.problem.edges[2] =
        (taut_film_edge){.kind = TAUT_FILM_CABLE, .law = TAUT_FILM_LENGTH, .length = length};
    taut_model *model = sail_make(&s, &proof);
    const double energy = figure_of(proof, "energy");
    *force = sail_figure(proof, "tensions", 2);
    taut_certificate_free(proof);
    taut_model_free(model);
    sail_free(&s);
    return energy;
}

/* dE / dL = -T, by central differences: the third derivative times h^2 is below 1e-4 here. */
static void test_derivative(void)
{
    const double length = 2.4, h = 1e-3;
    double force = 0, none = 0;

    energy_of_length(length, &force);
    const double more = energy_of_length(length + h, &none);
    const double less = energy_of_length(length - h, &none);
    CHECK_NEAR((more - less) / (2 * h), -force, 1e-4, "dE/dL = -T");
}

static void refusal(const taut_film_edge *edge, taut_status status, const char *reason,
                    const char *where)
{
    sail s = new_sail(12, edge, 4);
    taut_error error = {.status = TAUT_OK};
    taut_model *model = NULL;
    const taut_status found = taut_film_make(&s.problem, NULL, &model, &error);

    CHECK(found == status && strcmp(error.reason, reason) == 0 && strcmp(error.where, where) == 0,
          "%s: %s at %s: %s", reason, error.reason, error.where, error.message);
    taut_model_free(model);
    sail_free(&s);
}

static void test_refused(void)
{
    const taut_film_edge rows[] = {
        {.kind = TAUT_FILM_CABLE, .law = TAUT_FILM_LENGTH, .length = 2},
        {.kind = TAUT_FILM_CABLE, .law = TAUT_FILM_LENGTH, .length = 2.3}, /* quarters: 2.2214 */
        {.kind = TAUT_FILM_CABLE, .law = TAUT_FILM_SAG, .sag = 0.3},
        {.kind = TAUT_FILM_CABLE, .law = TAUT_FILM_ELASTIC, .unstressed = 2.2, .stiffness = 40}};
    const taut_film_edge data[] = {
        {.kind = TAUT_FILM_CABLE, .law = TAUT_FILM_LENGTH, .length = -1},
        {.kind = TAUT_FILM_CABLE, .law = TAUT_FILM_SAG, .sag = 0.5},
        {.kind = TAUT_FILM_CABLE, .law = TAUT_FILM_ELASTIC, .unstressed = 0, .stiffness = 40},
        {.kind = TAUT_FILM_CABLE, .law = TAUT_FILM_ELASTIC, .unstressed = 2, .stiffness = 1e9}};
    static const char *const members[] = {"length", "sag", "unstressed", "stiffness"};

    for (size_t k = 0; k < 4; k++) {
        char where[48];
        refusal(&rows[k], TAUT_NO_SOLUTION, k == 0 ? "cable-too-short" : "cable-too-weak",
                k == 0 ? "/edges/u0/cable/length" : "/edges/u0/cable");
        snprintf(where, sizeof where, "/edges/u0/cable/%s", members[k]);
        refusal(&data[k], TAUT_BAD_INPUT, "value", where);
    }
}

int main(void)
{
    test_lengths();
    test_deep();
    test_too_long();
    test_elastic();
    test_back();
    test_derivative();
    test_refused();
    return check_failures != 0;
}
