/* test_film.c -- sails against closed forms: flat ones are polygons between arcs of circles, the
 * strip of a helicoid hangs on a helix; and what has to be true of every film. */
#include "certificates.h"
#include "check.h"
#include "sails.h"

#include <string.h>

/* Flat: each cable over a chord c is an arc of radius T, and takes T^2 (a - sin a cos a) from the
 * polygon, a = asin(c / (2 T)). */
static double flat_energy(double polygon, const double chords[4], const double forces[4])
{
    double energy = polygon;
    for (int k = 0; k < 4; k++) {
        const double r = forces[k], a = asin(chords[k] / (2 * r));
        energy += r * 2 * r * a - r * r * (a - sin(a) * cos(a));
    }
    return energy;
}

/* Degree 4 on 8 spans errs by the eighth power of a span's angle; the tolerances are three times
 * what the next finer space moves them by. */
static void test_square(void)
{
    const struct {
        double force, tolerance;
    } rows[] = {{1.42, 1e-9}, {1.5, 5e-10}, {2, 5e-12}, {10, 2e-13}, {1000, 1e-14}};
    const double chords[4] = {2, 2, 2, 2};

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const double f = rows[k].force, forces[4] = {f, f, f, f};
        const double expected = flat_energy(4, chords, forces);
        sail s = sail_new(4, 12, sail_square, f);
        taut_certificate *proof = NULL;
        taut_model *model = sail_make(&s, &proof);
        CHECK_NEAR(figure_of(proof, "energy"), expected, rows[k].tolerance * expected, "force %g",
                   f);
        for (size_t e = 0; e < 4; e++) {
            CHECK_NEAR(sail_figure(proof, "lengths", e), 2 * f * asin(1 / f),
                       1e2 * rows[k].tolerance, "force %g edge %zu", f, e);
            CHECK(sail_figure(proof, "tensions", e) == f, "edge %zu", e);
        }
        taut_certificate_free(proof);
        taut_model_free(model);
        sail_free(&s);
    }
}

/* The polygon sail of four different forces. */
static void test_polygon(void)
{
    const double corners[4][3] = {{0, 0, 0}, {3, 0, 0}, {0.2, 1.6, 0}, {2.5, 2, 0}};
    const double forces[4] = {2, 2.5, 3, 4},
                 lengths[4] = {1.65966324918375324, 2.12494391481201748, 3.14159265358979324,
                               2.36899473002442970};
    sail s = sail_new(4, 12, corners, 1);
    taut_certificate *proof = NULL;

    for (int e = 0; e < 4; e++) {
        s.problem.edges[e].force = forces[e];
    }
    taut_model *model = sail_make(&s, &proof);
    CHECK_NEAR(figure_of(proof, "energy"), 30.7525014446121551, 2e-12, "energy");
    CHECK_NEAR(figure_of(proof, "area"), 3.22005827834750641, 2e-11, "area");
    for (size_t e = 0; e < 4; e++) {
        CHECK_NEAR(sail_figure(proof, "lengths", e), lengths[e], 2e-11, "edge %zu", e);
    }
    taut_certificate_free(proof);
    taut_model_free(model);
    sail_free(&s);
}

/* A cable in space: the helix r = a is an asymptotic curve of the helicoid. */
static void test_helicoid(void)
{
    sail s = sail_helicoid(5, 13, 1, 1.2);
    taut_certificate *proof = NULL;
    taut_model *model = sail_make(&s, &proof);

    CHECK_NEAR(figure_of(proof, "energy"), 5.56622311816688, 2e-10, "energy");
    CHECK_NEAR(figure_of(proof, "area"), 2.17211056847145, 2e-10, "area");
    CHECK_NEAR(sail_figure(proof, "lengths", 0), 1.69705627484771, 2e-10, "length");
    CHECK(detail_of(model, "deviation") < 1e-6, "%g", detail_of(model, "deviation"));
    taut_certificate_free(proof);
    taut_model_free(model);
    sail_free(&s);
}

/* Four edges of a regular tetrahedron: Schwarz' surface, K(sqrt 3 / 2) / (2 K(1/2)) for edges of
 * length 1. */
static void test_tetrahedron(void)
{
    const double corners[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}};
    sail s = sail_new(4, 14, corners, 0);
    taut_certificate *proof = NULL;
    taut_model *model = sail_make(&s, &proof);

    CHECK_NEAR(figure_of(proof, "area"), 8 * 1.279261571171006466 / 2, 2e-9, "area");
    taut_certificate_free(proof);
    taut_model_free(model);
    sail_free(&s);
}

static double energy_with(double force, double scale, int mirrored, taut_certificate **proof)
{
    double corners[4][3];
    for (int c = 0; c < 4; c++) {
        for (int k = 0; k < 3; k++) {
            corners[c][k] = scale * sail_saddle[c][k] * (mirrored && k == 2 ? -1 : 1);
        }
    }
    sail s = sail_new(4, 12, (const double(*)[3])corners, force);
    taut_model *model = sail_make(&s, proof);
    const double energy = figure_of(*proof, "energy");
    taut_model_free(model);
    sail_free(&s);
    return energy;
}

/* dE/dT = L by central differences; the second derivative of L is below 10 there. */
static void test_derivative(void)
{
    const double h = 1e-3;
    taut_certificate *here = NULL, *other = NULL;
    double sum = 0;

    energy_with(2, 1, 0, &here);
    for (size_t e = 0; e < 4; e++) {
        sum += sail_figure(here, "lengths", e);
    }
    const double more = energy_with(2 + h, 1, 0, &other);
    taut_certificate_free(other);
    const double less = energy_with(2 - h, 1, 0, &other);
    taut_certificate_free(other);
    CHECK_NEAR((more - less) / (2 * h), sum, 10 * h * h, "dE/dT");
    taut_certificate_free(here);
}

/* The tension, what cables have for a law, or an edge that slides, as one of four sails. */
static taut_certificate *proof_at(int kind, double tension)
{
    sail s = sail_new(4, 12, sail_saddle, 2);
    taut_certificate *proof = NULL;

    s.problem.without_least = 1;
    s.problem.tension = tension;
    for (int e = 0; e < 4; e++) {
        s.problem.edges[e].force = 2 + 0.3 * e;
    }
    if (kind == 1) {
        s.problem.edges[0].law = TAUT_FILM_SAG;
        s.problem.edges[0].sag = 0.11;
    } else if (kind == 2) {
        s.problem.edges[1].law = TAUT_FILM_ELASTIC;
        s.problem.edges[1].unstressed = 2.27;
        s.problem.edges[1].stiffness = 40;
    } else if (kind == 3) {
        s.problem.edges[2] = (taut_film_edge){.kind = TAUT_FILM_FIXED};
    }
    taut_model_free(sail_make(&s, &proof));
    sail_free(&s);
    return proof;
}

/* dE/ds = A by central differences, whatever the law of the cables; the third derivative of E is below 6 there. */
static void test_tension_derivative(void)
{
    const double h = 1e-3;

    for (int kind = 0; kind < 4; kind++) {
        taut_certificate *here = proof_at(kind, 1.1), *less = proof_at(kind, 1.1 - h),
                         *more = proof_at(kind, 1.1 + h);
        const double slope = (figure_of(more, "energy") - figure_of(less, "energy")) / (2 * h);
        CHECK_NEAR(slope, figure_of(here, "area"), h * h, "dE/ds, sail %d", kind);
        taut_certificate_free(here);
        taut_certificate_free(less);
        taut_certificate_free(more);
    }
}

/* A net of so many points that the search goes without factors comes to rest as others do. */
static void test_fine(void)
{
    const double chords[4] = {2, 2, 2, 2}, forces[4] = {10, 10, 10, 10};
    const double expected = flat_energy(4, chords, forces);
    sail s = sail_new(4, 46, sail_square, 10);
    taut_certificate *proof = NULL;

    s.problem.without_least = 1;
    taut_model *model = sail_make(&s, &proof);
    CHECK_NEAR(figure_of(proof, "energy"), expected, 1e-14 * expected, "energy");
    CHECK(claim_of(proof, "stationary")->residual < 1e-11, "%g",
          claim_of(proof, "stationary")->residual);
    const double left = detail_of(model, "residual");
    CHECK(left > 0 && left < 1e-12, "%g", left);
    taut_certificate_free(proof);
    taut_model_free(model);
    sail_free(&s);
}

/* A film scales with its forces, and is mirrored with its corners; its symmetry is its data's. */
static void test_maps(void)
{
    taut_certificate *here = NULL, *other = NULL;
    const double energy = energy_with(2, 1, 0, &here);

    CHECK_NEAR(energy, 21.26014312286, 3e-9, "saddle");
    CHECK(energy_with(6, 3, 0, &other) != 0, "scaled");
    CHECK_NEAR(figure_of(other, "energy"), 9 * energy, 1e-12 * 9 * energy, "scaled");
    CHECK_NEAR(figure_of(other, "lowest_eigenvalue"), figure_of(here, "lowest_eigenvalue") / 9,
               1e-8, "scaled");
    taut_certificate_free(other);
    CHECK_NEAR(energy_with(2, 1, 1, &other), energy, 1e-12 * energy, "mirrored");
    taut_certificate_free(other);
    for (size_t e = 1; e < 4; e++) {
        CHECK_NEAR(sail_figure(here, "lengths", e), sail_figure(here, "lengths", 0), 1e-12 * 2.4,
                   "edge %zu", e);
    }
    taut_certificate_free(here);
}

/* Cables of very large force are straight: the film is that of four held edges. */
static void test_strong(void)
{
    sail held = sail_new(4, 12, sail_saddle, 0), drawn = sail_new(4, 12, sail_saddle, 1e5);
    taut_certificate *one = NULL, *two = NULL;
    taut_model *a = sail_make(&held, &one), *b = sail_make(&drawn, &two);

    /* cables give way by s^2 c^3 / (24 T^2) each in length, and by s c^3 / (12 T) in area */
    CHECK_NEAR(figure_of(two, "area"), figure_of(one, "area"), 4 * 12 / (12 * 1e5), "area");
    CHECK(figure_of(two, "area") < figure_of(one, "area"), "cables draw inwards");
    taut_certificate_free(one);
    taut_certificate_free(two);
    taut_model_free(a);
    taut_model_free(b);
    sail_free(&held);
    sail_free(&drawn);
}

/* The film inside comes to rest beside cables of any force. */
static void test_forces(void)
{
    static const double forces[] = {100, 300, 1000, 3000, 3e4, 1e6};

    for (size_t k = 0; k < sizeof forces / sizeof *forces; k++) {
        sail s = sail_new(4, 12, sail_saddle, forces[k]);
        taut_certificate *proof = NULL;
        s.problem.without_least = 1;
        taut_model *model = sail_make(&s, &proof);
        const double rest = claim_of(proof, "stationary")->residual;
        CHECK(rest < 1e-11, "force %g: %g", forces[k], rest);
        taut_certificate_free(proof);
        taut_model_free(model);
        sail_free(&s);
    }
}

/* A loose tolerance asks for no less than the search needs: the same film, as near to its energy as ever. */
static void test_loose(void)
{
    static const double tolerances[] = {1e-6, 1e-5, 1e-4, 1e-3};
    const double energy = 21.260143123; /* on finer spaces, too */

    for (size_t k = 0; k < sizeof tolerances / sizeof *tolerances; k++) {
        sail s = sail_new(4, 12, sail_saddle, 2);
        taut_certificate *proof = NULL;
        s.problem.without_least = 1;
        s.problem.tolerance = tolerances[k];
        taut_model *model = sail_make(&s, &proof);
        CHECK_NEAR(figure_of(proof, "energy"), energy, 1e-8, "tolerance %g", tolerances[k]);
        taut_certificate_free(proof);
        taut_model_free(model);
        sail_free(&s);
    }
}

/* With rigid cables the flat square is a membrane on a frame: its lowest eigenvalue is that of the
 * Laplacian, 2 pi^2 / c^2, raised by no more than the space's fourth power, lowered by c / T. */
static void test_eigenvalue(void)
{
    const double pi = 3.14159265358979323846;
    sail s = sail_new(4, 12, sail_square, 1e5);
    taut_certificate *proof = NULL;
    taut_model *model = sail_make(&s, &proof);

    CHECK_NEAR(figure_of(proof, "lowest_eigenvalue"), pi * pi / 2, 1e-5 * pi * pi, "square");
    taut_certificate_free(proof);
    taut_model_free(model);
    sail_free(&s);
}

/* The tension only sets the unit of forces. */
static void test_tension(void)
{
    sail one = sail_new(3, 9, sail_saddle, 2), two = sail_new(3, 9, sail_saddle, 7);
    taut_certificate *here = NULL, *there = NULL;

    two.problem.tension = 3.5;
    taut_model *a = sail_make(&one, &here), *b = sail_make(&two, &there);
    CHECK_NEAR(figure_of(there, "energy"), 3.5 * figure_of(here, "energy"), 1e-11, "energy");
    CHECK(memcmp(taut_surface_points(taut_model_surface(a, 0)),
                 taut_surface_points(taut_model_surface(b, 0)), 81 * 3 * sizeof(double)) == 0,
          "points");
    taut_certificate_free(here);
    taut_certificate_free(there);
    taut_model_free(a);
    taut_model_free(b);
    sail_free(&one);
    sail_free(&two);
}

int main(void)
{
    test_square();
    test_polygon();
    test_helicoid();
    test_tetrahedron();
    test_derivative();
    test_tension_derivative();
    test_fine();
    test_maps();
    test_strong();
    test_forces();
    test_loose();
    test_tension();
    test_eigenvalue();
    return check_failures != 0;
}
