/* test_nest.c -- pieces that lie into each other: triangles whose places are known by hand, wedges half a turn apart, nap; no two of
 * random polygons meet, and none leaves the roll. */
#include "check.h"
#include "core/constants.h"
#include "pattern/sheet/nest.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { CORNERS = 16, SHAPES = 12 };

static taut_nest_shape shape_of(size_t count, const double (*points)[2])
{
    taut_nest_shape s = {.count = count,
                         .points = points,
                         .low = {INFINITY, INFINITY},
                         .high = {-INFINITY, -INFINITY}};
    for (size_t k = 0; k < 2 * count; k++) {
        s.low[k % 2] = fmin(s.low[k % 2], points[k / 2][k % 2]);
        s.high[k % 2] = fmax(s.high[k % 2], points[k / 2][k % 2]);
    }
    return s;
}

/* Right triangles 4 long and 1 high: two of them make a rectangle, half a turn apart. */
static void test_wedges(void)
{
    static const double wedge[3][2] = {{1, 0}, {5, 0}, {1, 1}};
    const taut_nest_shape shapes[2] = {shape_of(3, wedge), shape_of(3, wedge)};
    taut_nest_place places[2];
    taut_arena *arena = taut_arena_new();
    double length = 0;

    CHECK(taut_nest(arena, 2, shapes, 1, 0, 0, 1, places, &length) == TAUT_OK, "nest");
    CHECK(!places[0].is_turned && places[1].is_turned, "the second one is turned");
    CHECK(length > 4 && length < 4.1, "two wedges, half a turn apart: %g", length);
    CHECK_NEAR(places[0].at[0], -1, 0, "the first one begins the roll");
    CHECK(taut_nest(arena, 2, shapes, 1, 0, 0, 0, places, &length) == TAUT_OK, "nest");
    CHECK(!places[1].is_turned && length > 7.9 && length <= 8, "with a nap: %g", length);
    CHECK(taut_nest(arena, 2, shapes, 1, 0.25, 0, 1, places, &length) == TAUT_OK, "nest");
    CHECK(length > 5.2 && length < 5.4, "a quarter apart, square and along: %g", length);
    CHECK(taut_nest(arena, 2, shapes, 0.9, 0, 0, 1, places, &length) == TAUT_OK && isinf(length),
          "wider than the roll");
    CHECK(taut_nest(arena, 0, shapes, 1, 0, 0, 1, places, &length) == TAUT_OK && length == 0,
          "none");
    taut_arena_free(arena);
}

static double side_of(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static int do_cross(const double a[CORNERS][2], const double b[CORNERS][2])
{
    for (int i = 0; i < CORNERS; i++) {
        for (int k = 0; k < CORNERS; k++) {
            const double *p = a[i], *q = a[(i + 1) % CORNERS];
            const double *r = b[k], *s = b[(k + 1) % CORNERS];
            if (side_of(p, q, r) * side_of(p, q, s) < 0 &&
                side_of(r, s, p) * side_of(r, s, q) < 0) {
                return 1;
            }
        }
    }
    return 0;
}

static double random_number(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005U + 1442695040888963407U;
    return (double)(*seed >> 11) / 9007199254740992.0;
}

static void test_stars(uint64_t seed)
{
    static double stars[SHAPES][CORNERS][2], placed[SHAPES][CORNERS][2];
    taut_nest_shape shapes[SHAPES];
    taut_nest_place places[SHAPES];
    taut_arena *arena = taut_arena_new();
    double length = 0, boxes = 0;

    for (int k = 0; k < SHAPES; k++) {
        for (int i = 0; i < CORNERS; i++) {
            const double r = 0.2 + 0.3 * random_number(&seed), a = 2 * TAUT_PI * i / CORNERS;
            stars[k][i][0] = 3 * r * cos(a);
            stars[k][i][1] = r * sin(a);
        }
        shapes[k] = shape_of(CORNERS, (const double(*)[2])stars[k]);
        boxes += shapes[k].high[0] - shapes[k].low[0];
    }
    CHECK(taut_nest(arena, SHAPES, shapes, 1.5, 0, 0, 1, places, &length) == TAUT_OK, "nest");
    CHECK(length < 0.8 * boxes, "%g of %g", length, boxes);
    for (int k = 0; k < SHAPES; k++) {
        for (int i = 0; i < CORNERS; i++) {
            for (int d = 0; d < 2; d++) {
                placed[k][i][d] =
                    places[k].at[d] + (places[k].is_turned ? -stars[k][i][d] : stars[k][i][d]);
                CHECK(placed[k][i][d] >= -1e-12 && placed[k][i][d] <= (d ? 1.5 : length) + 1e-12,
                      "shape %d leaves the roll: %g", k, placed[k][i][d]);
            }
        }
        for (int m = 0; m < k; m++) {
            CHECK(!do_cross((const double(*)[2])placed[k], (const double(*)[2])placed[m]),
                  "shapes %d and %d meet", k, m);
        }
    }
    taut_arena_free(arena);
}

int main(void)
{
    test_wedges();
    for (uint64_t seed = 1; seed <= 20; seed++) {
        test_stars(seed);
    }
    return check_failures != 0;
}
