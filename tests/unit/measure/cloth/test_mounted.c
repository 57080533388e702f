/* test_mounted.c -- flat pieces put back on the surface: both pieces of a seam meet all along it, places are on the saddle, the largest
 * strains are those that the construction tells, and normals are the surface's. */
#include "check.h"
#include "cloths.h"
#include "domes.h"
#include "measure/cloth/mounted.h"

#include <math.h>
#include <stdio.h>

enum { PARTS = 64 };

/* `low_room`: between places that both look at */
static void test_sail(const char *more, double low_room)
{
    char members[300];
    snprintf(members, sizeof members,
             "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }], \"compensation\": { "
             "\"warp\": 0.02, \"weft\": 0.045 }%s",
             more);
    made_cloth made = cloth_make(SADDLE, members);
    taut_arena *arena = taut_arena_new();
    taut_mounted pieces[3];

    CHECK(made.status == TAUT_OK && arena != NULL, "%s", made.error.message);
    for (int k = 0; k < 3; k++) {
        double low = INFINITY, high = -INFINITY;
        char name[8];
        CHECK(taut_mounted_new(made.model, taut_model_surface(made.model, k + 1), arena,
                               &pieces[k]) == TAUT_OK &&
                  pieces[k].flat != NULL,
              "P%d", k + 1);
        for (int i = 0; i <= PARTS * PARTS; i++) {
            const double s = (double)(i / PARTS) / PARTS, t = (double)(i % PARTS) / (PARTS - 1);
            double point[3], normal[3], strain;
            taut_mounted_at(&pieces[k], s, t, point, normal, &strain);
            CHECK_NEAR(point[2], 0.3 * (point[0] * point[0] - point[1] * point[1]), 1e-14, "z");
            const double up = 1 / sqrt(1 + 0.36 * (point[0] * point[0] + point[1] * point[1]));
            CHECK_NEAR(normal[2], up, 1e-12, "normal");
            low = fmin(low, strain);
            high = fmax(high, strain);
        }
        snprintf(name, sizeof name, "P%d", k + 1);
        CHECK_NEAR(low, cloth_number(&made, "pieces", name, "strain/min"), low_room, "%s low",
                   name);
        CHECK_NEAR(high, cloth_number(&made, "pieces", name, "strain/max"), 2e-4, "%s high", name);
    }
    for (int i = 0; i <= PARTS; i++) { /* strips count from low u, and t runs towards it */
        double right[3], left[3], normal[3], strain;
        taut_mounted_at(&pieces[0], (double)i / PARTS, 0, right, normal, &strain);
        taut_mounted_at(&pieces[1], (double)i / PARTS, 1, left, normal, &strain);
        CHECK_NEAR(hypot(right[0] - left[0], right[1] - left[1]), 0, 1e-15, "seam");
    }
    taut_mounted none;
    CHECK(taut_mounted_new(made.model, taut_model_surface(made.model, 0), arena, &none) ==
                  TAUT_OK &&
              none.flat == NULL,
          "the surface itself is no piece");
    taut_arena_free(arena);
    cloth_free(&made);
}

/* A tube of arcs has no strain anywhere, where arcs meet inside a piece too. */
static void test_arcs(void)
{
    made_cloth made =
        cloth_make(RING("2", "-2"), "\"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 3 }]");
    taut_arena *arena = taut_arena_new();
    CHECK(made.status == TAUT_OK && arena != NULL, "%s", made.error.message);
    for (int k = 0; k < 3; k++) {
        taut_mounted piece;
        CHECK(taut_mounted_new(made.model, taut_model_surface(made.model, k + 1), arena, &piece) ==
                      TAUT_OK &&
                  piece.flat != NULL,
              "P%d", k + 1);
        for (int i = 0; i <= PARTS * PARTS; i++) {
            const double s = (double)(i / PARTS) / PARTS, t = (double)(i % PARTS) / (PARTS - 1);
            double point[3], normal[3], strain;
            taut_mounted_at(&piece, s, t, point, normal, &strain);
            CHECK_NEAR(hypot(point[0], point[1]), 2, 1e-12, "radius");
            CHECK_NEAR(strain, 0, 1e-10, "strain of P%d", k + 1);
        }
    }
    taut_arena_free(arena);
    cloth_free(&made);
}

/* A cap and gores, mounted: they meet on the circle, and strains are those that the construction tells, at the tip too. */
static void test_cap(void)
{
    char *surface = dome_text(DOME_RAYS, 0);
    made_cloth made =
        cloth_make(surface, "\"seams\": [{ \"radial\": \"v0\", \"count\": 1, \"trim\": "
                            "0.7 }], \"seam_length\": \"true\"");
    taut_arena *arena = taut_arena_new();
    taut_mounted cap, rest;
    CHECK(made.status == TAUT_OK && arena != NULL, "%s", made.error.message);
    if (made.status != TAUT_OK || arena == NULL) {
        return;
    }
    CHECK(taut_mounted_new(made.model, taut_model_surface(made.model, 1), arena, &cap) == TAUT_OK &&
              taut_mounted_new(made.model, taut_model_surface(made.model, 2), arena, &rest) ==
                  TAUT_OK,
          "two");
    for (int i = 0; i <= PARTS; i++) {
        double end[3], start[3], normal[3], strain, middle[3];
        const double t = (double)i / PARTS;
        taut_mounted_at(&cap, 1, t, end, normal, &strain);
        taut_mounted_at(&rest, 0, t, start, normal, &strain);
        CHECK_NEAR(hypot(end[0] - start[0], end[1] - start[1]), 0, 1e-13, "circle");
        CHECK_NEAR(hypot(end[0], end[1]), 0.7, 1e-9, "distance");
        taut_mounted_at(&cap, 0.25, t, middle, normal, &strain);
        CHECK_NEAR(strain, 0, 1e-5, "a plane is flat");
        for (int d = 0; d < 3; d++) { /* lines of equal t run into the tip */
            CHECK_NEAR(middle[d], end[d] / 4, 1e-12, "ray");
        }
    }
    taut_arena_free(arena);
    cloth_free(&made);
    free_dome(surface);
}

int main(void)
{
    test_arcs();
    test_cap();
    test_sail("", 2e-5);
    test_sail(", \"decompensate\": [{ \"edge\": \"v0\", \"length\": 0.5 }, { \"edge\": \"u1\", "
              "\"length\": 0.4, \"component\": \"both\" }]",
              5e-5);
    return check_failures != 0;
}
