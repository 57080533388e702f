/* test_border_distance.c -- distances from edges of a surface against closed forms: a straight edge and its ends, a quarter of a circle. */
#include "check.h"
#include "geometry/border_distance.h"

#include <math.h>

/* A quarter of a ring in z = 0: radius 1 at u0, 2 at u1, from the x axis (v0) to the y axis (v1). */
static taut_surface *quarter(void)
{
    static const double points[] = {1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0};
    const double h = sqrt(0.5), weights[] = {1, h, 1, 1, h, 1};
    const taut_basis_spec specs[2] = {{.type = "bezier", .degree = 1},
                                      {.type = "bezier", .degree = 2}};
    taut_basis *bases[2] = {NULL, NULL};
    taut_surface *surface = NULL;
    for (int d = 0; d < 2; d++) {
        taut_basis_new(&specs[d], d + 2, &bases[d], NULL);
    }
    taut_surface_new("ring", bases[0], bases[1], points, weights, &surface, NULL);
    taut_basis_free(bases[0]);
    taut_basis_free(bases[1]);
    return surface;
}

int main(void)
{
    taut_surface *surface = quarter();
    taut_arena *arena = taut_arena_new();
    taut_border borders[4];

    CHECK(surface != NULL && arena != NULL, "a quarter of a ring");
    for (int e = 0; e < 4; e++) {
        CHECK(taut_border_new(arena, surface, e, &borders[e]) == TAUT_OK, "%d", e);
    }
    for (int k = 0; k < 400; k++) {
        const double radius = 1 + k % 20 / 19.0, angle = 1.57 * (k / 20) / 19.0;
        const double x[3] = {radius * cos(angle), radius * sin(angle), 0.25 * (k % 3)};
        const double off = hypot(0, x[2]);
        CHECK_NEAR(taut_border_distance(&borders[0], x), hypot(radius - 1, off), 1e-15, "u0, %d",
                   k);
        CHECK_NEAR(taut_border_distance(&borders[1], x), hypot(2 - radius, off), 1e-15, "u1, %d",
                   k);
        /* from x = 1 to 2 on the axis, whose end may be nearer */
        const double beyond = fmax(0, fmax(1 - x[0], x[0] - 2));
        CHECK_NEAR(taut_border_distance(&borders[2], x), hypot(hypot(beyond, x[1]), off), 1e-15,
                   "v0, %d", k);
    }
    taut_arena_free(arena);
    taut_surface_free(surface);
    return check_failures != 0;
}
