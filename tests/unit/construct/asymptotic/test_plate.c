/* test_plate.c -- what the steps of Algorithm 2 refuse of quadrilaterals and patches
 * that the checks before them would not have let through. */
#include "asymptotic.h"
#include "check.h"

#include "construct/asymptotic/low.h"
#include "construct/asymptotic/plate.h"
#include "construct/asymptotic/quad.h"
#include "construct/asymptotic/ribbon.h"
#include "core/arena.h"
#include "core/vec3.h"

#include <string.h>

/* A net's boundary with a weight of v0 changed: curvature and torsion of one edge change and no
 * plane does. */
static taut_quad unequal(void)
{
    const lelieuvre net = lelieuvre_random(2);
    taut_asymptotic_problem problem = lelieuvre_problem(&net);
    taut_quad quad;
    CHECK(taut_quad_of_curves(problem.curves, &quad, NULL) == TAUT_OK, "quad");
    quad.edges[0].weights[1] *= 1.1;
    asymptotic_free_curves(&problem);
    return quad;
}

/* Without opposite torsions there is no common twist: it is missed by |tau_e + tau_f| |r_e' x r_f'|
 * ([WangZhuLi2017], fact 2 of docs/papers/asymptotic.md section 2). */
static void test_unequal_torsions(void)
{
    for (int trial = 0; trial < 20; trial++) {
        const taut_quad quad = unequal();
        taut_ribbon ribbons[4];
        taut_low low;
        taut_error error = {.message = ""};
        double twist[4][3], r[2][3], normal[3], expected = 0;
        for (int e = 0; e < 4; e++) {
            taut_ribbon_fill(&quad, e, &ribbons[e]);
        }
        for (int e = 0; e < 4; e++) {
            taut_ribbon_ends(&quad, e, ribbons);
        }
        for (int k = 0; k < 2; k++) {
            const taut_quad_meeting *const m = &taut_quad_corner[0][k];
            taut_quad_leg(&quad, m->edge, m->end, r[k]);
            for (int i = 0; i < 3; i++) {
                r[k][i] *= 3 * taut_quad_weight(&quad, m->edge, m->end, 1);
            }
            expected += taut_quad_torsion(&quad, m->edge, m->end);
        }
        taut_cross(r[0], r[1], normal);
        expected = fabs(expected) * taut_norm(normal);
        CHECK(taut_ribbon_twists(&quad, ribbons, twist, &error) == TAUT_NO_SOLUTION, "made");
        CHECK(strcmp(error.reason, "twist") == 0 && strstr(error.message, "u0v0") != NULL, "%s",
              error.message);
        CHECK_NEAR(error.found, expected, 1e-9 * expected, "trial %d", trial);
        CHECK(taut_low_corners(&quad, &low, &error) == TAUT_NO_SOLUTION, "made");
        CHECK(strcmp(error.reason, "twist") == 0 && fabs(error.found) > 1e-6, "%g: %s", error.found,
              error.message);
    }
}

/* A patch of bidegree 6 over the unit square, one of its points out of the range that squares of
 * numbers have; and a freedom that moves nothing, for which every factor is as good. */
static void test_singular(void)
{
    const taut_plate_options options = {0, NULL};
    taut_arena *const arena = taut_arena_new();
    taut_patch patch;
    taut_plate_freedom nothing;
    taut_error error = {.message = ""};
    double energy = 7, factor = 0, r = 0;
    CHECK(arena != NULL && taut_patch_new(arena, 6, &patch) == TAUT_OK, "patch");
    for (int k = 0; k < 49; k++) {
        const double entry[4] = {k / 7 / 6.0, k % 7 / 6.0, 0, 1};
        memcpy(patch.net[k], entry, sizeof entry);
    }
    memset(&nothing, 0, sizeof nothing);
    nothing.parts = 1;
    CHECK(taut_plate_step(&patch, 1, &nothing, &factor, &r, &options, &error) == TAUT_NOT_CONVERGED,
          "a step along nothing");
    CHECK(taut_plate_solve(&patch, 1, &nothing, &factor, &options, &energy, &error) ==
              TAUT_NOT_CONVERGED,
          "along nothing");
    CHECK(strcmp(error.reason, "ill-conditioned") == 0 && energy == 7, "%s", error.message);
    CHECK(taut_plate_solve(&patch, 0, NULL, NULL, &options, &energy, &error) == TAUT_OK &&
              energy < 1e-20,
          "a plane: %g", energy);
    patch.net[3][2] = 1e200;
    energy = 7;
    CHECK(taut_plate_solve(&patch, 0, NULL, NULL, &options, &energy, &error) ==
                  TAUT_NOT_CONVERGED &&
              energy == 7,
          "%g", energy);
    taut_arena_free(arena);
}

int main(void)
{
    random_seed(20261129);
    test_unequal_torsions();
    test_singular();
    return check_failures != 0;
}
