/* test_told.c -- whoever measures a join is told of the places that are looked at; an end leaves no figures. They do not depend on
 * who is told. */
#include "check.h"
#include "core/pulse.h"
#include "monitors.h"

#include "taut/join.h"

#include <string.h>

enum { DEGREE = 30, COUNT = DEGREE + 1 };

/* x and y are parameters, z = lift. */
static taut_surface *plane(double lift, double apart)
{
    static double points[COUNT][COUNT][3];
    const taut_basis_spec spec = {.type = "bezier", .degree = DEGREE};
    taut_basis *basis = NULL;
    taut_surface *surface = NULL;
    for (int i = 0; i < COUNT; i++) {
        for (int j = 0; j < COUNT; j++) {
            const double x[3] = {apart + (double)i / DEGREE, (double)j / DEGREE, lift * i * j};
            memcpy(points[i][j], x, sizeof x);
        }
    }
    CHECK(taut_basis_new(&spec, COUNT, &basis, NULL) == TAUT_OK &&
              taut_surface_new("p", basis, basis, &points[0][0][0], NULL, &surface, NULL) ==
                  TAUT_OK,
          "surface");
    taut_basis_free(basis);
    return surface;
}

/* Edges with a gap: of each of a hundred places of the one the nearest of a hundred of the other is found, by the whole net. */
static void check_apart(const taut_surface *a, const taut_surface *b)
{
    const double operations = 100.0 * 100 * COUNT * COUNT * 6;
    watch all = {.stop_at = 0};
    const taut_join_options watched = {.monitor = monitor_of(&all)};
    taut_join plain, told;

    CHECK(taut_join_measure(a, TAUT_EDGE_U1, b, TAUT_EDGE_U0, &plain, NULL) == TAUT_OK &&
              taut_join_measure_with(a, TAUT_EDGE_U1, b, TAUT_EDGE_U0, &watched, &told, NULL) ==
                  TAUT_OK,
          "measured");
    CHECK(plain.max_gap == told.max_gap && plain.c_order == -1 && told.c_order == -1, "gaps %g, %g",
          plain.max_gap, told.max_gap);
    CHECK(all.reports > operations / TAUT_PULSE_WORK, "%d reports of %.3g operations", all.reports,
          operations);
    for (int k = 1; k <= all.reports; k += 1 + all.reports / 5) {
        watch stop = {.stop_at = k, .answer = k % 2 != 0 ? TAUT_STOP : TAUT_ENOUGH};
        const taut_join_options options = {.monitor = monitor_of(&stop)};
        taut_join none = {.c_order = 7};
        taut_error error = {.status = TAUT_OK};
        CHECK(taut_join_measure_with(a, TAUT_EDGE_U1, b, TAUT_EDGE_U0, &options, &none, &error) ==
                      TAUT_INTERRUPTED &&
                  none.c_order == 7 && stop.reports == k &&
                  strcmp(error.reason, "interrupted") == 0,
              "stopped at %d of %d: went on to %d", k, all.reports, stop.reports);
    }
}

int main(void)
{
    taut_surface *a = plane(0, 0), *b = plane(0.01, 1.5);
    check_apart(a, b);
    taut_surface_free(a);
    taut_surface_free(b);
    return check_failures != 0;
}
