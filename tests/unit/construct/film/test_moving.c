/* test_moving.c -- corners on lines and in planes, cables in planes, slides and mirrors: films that are known
 * come out again where what held them lets go in a way that they do not use. */
#include "certificates.h"
#include "check.h"
#include "geometry/arc.h"
#include "rings.h"
#include "sails.h"

#include <string.h>

static taut_model *make(const taut_film_problem *problem, taut_certificate **proof,
                        const char *what)
{
    static const char *const claims[] = {"held", "stationary", "stable"};
    taut_model *model = film_made(problem, proof, what);
    film_holds(*proof, sizeof claims / sizeof *claims, claims, what);
    return model;
}

/* The square sail, plane and least: a corner that starts above it on a mast, or in an upright plane, comes down. */
static void test_corner(void)
{
    const double energy = 19.3057836398482911;
    for (int k = 0; k < 2; k++) {
        sail s = sail_new(4, 12, sail_square, 2);
        taut_certificate *proof = NULL;
        s.problem.corners[3][2] = 0.5;
        s.problem.corner_kinds[3] = k == 0 ? TAUT_FILM_ON_LINE : TAUT_FILM_ON_PLANE;
        s.problem.guides[3] = k == 0 ? (taut_film_guide){{2, 2, 7}, {0, 0, 3}}
                                     : (taut_film_guide){{2, 2, 0}, {1, 1, 0}};
        taut_model *model = make(&s.problem, &proof, "corner");
        CHECK_NEAR(figure_of(proof, "energy"), energy, 1e-11 * energy, "kind %d", k);
        CHECK(claim_of(proof, "least")->holds == TAUT_UNDECIDED, "a corner that moves has rivals");
        if (model != NULL) {
            const taut_surface *surface = taut_model_surface(model, 0);
            const double *corner = taut_surface_points(surface) + 3 * 143;
            const double expected[3] = {2, 2, 0};
            for (int c = 0; c < 3; c++) {
                CHECK_NEAR(corner[c], expected[c], 1e-9, "kind %d", k);
            }
        }
        taut_certificate_free(proof);
        taut_model_free(model);
        sail_free(&s);
    }
}

/* A corner that comes down from afar: the chord at its start says nothing of a given length, here that of a force of 2. Sags
 * have no chord there. */
static void test_from_afar(void)
{
    const double pi = 3.14159265358979324;
    sail s = sail_new(4, 12, sail_square, 2);
    taut_certificate *proof = NULL;
    taut_error error = {.status = TAUT_OK};
    taut_model *none = NULL;

    s.problem.corners[3][2] = 3;
    s.problem.corner_kinds[3] = TAUT_FILM_ON_LINE;
    s.problem.guides[3] = (taut_film_guide){{2, 2, 7}, {0, 0, 3}};
    s.problem.edges[1].law = TAUT_FILM_LENGTH;
    s.problem.edges[1].length = 2 * pi / 3;
    taut_model *model = make(&s.problem, &proof, "from afar");
    CHECK_NEAR(sail_figure(proof, "tensions", 1), 2, 1e-7, "the force of its length");
    s.problem.edges[1].law = TAUT_FILM_SAG;
    s.problem.edges[1].sag = 0.1;
    CHECK(taut_film_make(&s.problem, NULL, &none, &error) == TAUT_BAD_INPUT &&
              strcmp(error.where, "/edges/u1") == 0,
          "%s", error.message);
    taut_certificate_free(proof);
    taut_model_free(model);
    sail_free(&s);
}

/* Cables a hundred times as strong as the film: steps in all coordinates are all but singular, and led the corner off its mast by
 * 3e-8 of the size. It was brought back when nothing came to rest any more. */
static void test_strong_cables(void)
{
    static const double corners[4][3] = {
        {10.638656293584846, -23.572419692754842, -24.094023768245496},
        {83.20546208863513, 28.082757757352358, 11.727081121455008},
        {4.0424280289031866, 79.023745589540326, -10.389842546190103},
        {99.177344965152415, 70.456347071470731, -26.749711219965082}};
    static const double forces[4] = {19660.926285267076, 3168.2627850343242, 8125.8921814148398,
                                     34540.372602012067};
    static const double mast[3] = {0.25170759540132742, -0.17815895529288195, 1};
    sail s = sail_new(4, 8, corners, 1);
    taut_certificate *proof = NULL;

    s.problem.tension = 41.705603456819162;
    s.problem.without_least = 1;
    s.problem.corner_kinds[3] = TAUT_FILM_ON_LINE;
    memcpy(s.problem.guides[3].point, corners[3], sizeof mast);
    memcpy(s.problem.guides[3].direction, mast, sizeof mast);
    for (int e = 0; e < 4; e++) {
        s.problem.edges[e].force = forces[e];
    }
    taut_model *model = make(&s.problem, &proof, "strong cables");
    CHECK(!has_claim(proof, "details"), "%s", claim_of(proof, "details")->where);
    taut_certificate_free(proof);
    taut_model_free(model);
    sail_free(&s);
}

/* Cables of a flat sail lie in its plane anyway. In upright planes a saddle's hang differently: less may move, so that
 * there is more energy. */
static void test_cables(void)
{
    double energies[3];
    for (int k = 0; k < 3; k++) {
        sail s = sail_new(4, 10, k == 0 ? sail_square : sail_saddle, 2);
        taut_certificate *proof = NULL;
        for (int e = 0; e < 4 && k != 1; e++) {
            s.problem.edges[e].has_plane = 1;
            s.problem.edges[e].plane =
                k == 0 ? (taut_film_guide){{1, 1, 0}, {0, 0, 1}}
                       : (taut_film_guide){{e == 1, e == 3, 0}, {e < 2, e >= 2, 0}};
            for (int c = 0; c < 2 && k == 2; c++) {
                s.problem.edges[e].plane.point[c] = 2 * s.problem.edges[e].plane.point[c] - 1;
            }
        }
        taut_model *model = make(&s.problem, &proof, "cables");
        energies[k] = figure_of(proof, "energy");
        CHECK(figure_of(proof, "cable_geodesic") < 0.05, "%g", figure_of(proof, "cable_geodesic"));
        taut_certificate_free(proof);
        taut_model_free(model);
        sail_free(&s);
    }
    CHECK_NEAR(energies[0], 19.3057836398482911, 1e-9, "flat");
    CHECK(energies[2] > energies[1] + 0.1, "%g, %g", energies[1], energies[2]);
}

/* An eighth of a catenoid between mirrors and a slide; corners that are not given slide along both planes. */
static void test_mirrors(void)
{
    const double quarter[3][3] = {{1, 0, 0}, {sqrt(0.5), sqrt(0.5), 0}, {0, 1, 0}};
    taut_basis *u = NULL, *v = NULL;
    taut_curve *arc = NULL;
    taut_certificate *proof = NULL;
    const taut_basis_spec around = {.type = "bspline", .degree = 4, .count = 10},
                          along = {.type = "bspline", .degree = 4, .count = 8};
    CHECK(taut_basis_new(&around, 10, &u, NULL) == TAUT_OK &&
              taut_basis_new(&along, 8, &v, NULL) == TAUT_OK &&
              taut_arc_new(quarter, &arc) == TAUT_OK,
          "quarter");
    taut_film_problem problem = {
        .u = u,
        .v = v,
        .edges = {{.kind = TAUT_FILM_SLIDE, .plane = {{0, 0, 0}, {0, 1, 0}}, .is_mirror = 1},
                  {.kind = TAUT_FILM_SLIDE, .plane = {{0, 0, 0}, {1, 0, 0}}, .is_mirror = 1},
                  {.kind = TAUT_FILM_FIXED, .curve = arc},
                  {.kind = TAUT_FILM_SLIDE, .plane = {{0, 0, 0.5}, {0, 0, 1}}}},
        .corner_kinds = {TAUT_FILM_HELD, TAUT_FILM_HELD, TAUT_FILM_FREE, TAUT_FILM_FREE}};
    taut_model *model = make(&problem, &proof, "mirrors");
    CHECK_NEAR(8 * figure_of(proof, "area"), ring_area(1), 4e-8, "an eighth");
    CHECK(claim_of(proof, "mirror")->holds == TAUT_TRUE, "mirror");
    CHECK(figure_of(proof, "slide_angle") < 1e-3, "%g", figure_of(proof, "slide_angle"));
    taut_certificate_free(proof);
    taut_model_free(model);
    taut_curve_free(arc);
    taut_basis_free(u);
    taut_basis_free(v);
}

static void refuse(const taut_film_problem *problem, taut_status status, const char *reason,
                   const char *where)
{
    taut_error error = {.status = TAUT_OK};
    taut_model *model = NULL;
    const taut_status found = taut_film_make(problem, NULL, &model, &error);

    CHECK(found == status && strcmp(error.reason, reason) == 0 && strcmp(error.where, where) == 0,
          "expected %s at %s: status %d, %s at %s: %s", reason, where, (int)found, error.reason,
          error.where, error.message);
    taut_model_free(model);
}

static void test_refused(void)
{
    sail s = sail_new(4, 8, sail_square, 2);

    s.problem.corner_kinds[3] = TAUT_FILM_FREE;
    refuse(&s.problem, TAUT_NO_SOLUTION, "no-corner", "/corners/u1v1");
    s.problem.corner_kinds[3] = TAUT_FILM_ON_LINE;
    refuse(&s.problem, TAUT_BAD_INPUT, "value", "/corners/u1v1");
    s.problem.guides[3].direction[2] = NAN;
    refuse(&s.problem, TAUT_BAD_INPUT, "value", "/corners/u1v1");
    s.problem.guides[3].direction[2] = 1;
    s.problem.edges[3].kind = TAUT_FILM_FIXED;
    refuse(&s.problem, TAUT_BAD_INPUT, "corner-conflict", "/corners/u1v1");
    s.problem.edges[3].kind = TAUT_FILM_CABLE;
    s.problem.corner_kinds[3] = TAUT_FILM_HELD;
    s.problem.edges[0].has_plane = 1;
    s.problem.edges[0].plane = (taut_film_guide){{0.1, 0, 0}, {1, 0, 0}};
    refuse(&s.problem, TAUT_BAD_INPUT, "corner-conflict", "/corners/u0v0");
    s.problem.edges[0].kind = TAUT_FILM_POLE;
    s.problem.edges[0].has_plane = 0;
    refuse(&s.problem, TAUT_BAD_INPUT, "corner-conflict",
           "/corners/u0v1");      /* its ends are two corners */
    for (int e = 0; e < 4; e++) { /* planes that hold nothing upwards */
        s.problem.edges[e] =
            (taut_film_edge){.kind = TAUT_FILM_SLIDE,
                             .plane = {{e == 1 ? 2 : 0, e == 3 ? 2 : 0, 0}, {e < 2, e >= 2, 0}}};
        s.problem.corner_kinds[e] = TAUT_FILM_FREE;
    }
    refuse(&s.problem, TAUT_NO_SOLUTION, "floating", "/edges");
    s.problem.corner_kinds[3] = TAUT_FILM_HELD;
    s.problem.edges[2].plane = (taut_film_guide){{1, 0, 0}, {1, 0, 0}}; /* beside that of u0 */
    refuse(&s.problem, TAUT_BAD_INPUT, "corner-conflict", "/corners/u0v0");
    sail_free(&s);
}

int main(void)
{
    test_corner();
    test_from_afar();
    test_strong_cables();
    test_cables();
    test_mirrors();
    test_refused();
    return check_failures != 0;
}
