/* test_mean.c -- the figures of a film alone against those of taut_measure_surface: the same points
 * of the grid count, whatever the bounds leave out. */
#include "check.h"
#include "shapes.h"

#include "measure/integrate/integrals.h"
#include "taut/measure.h"

enum { POINTS_MAX = 49 };

static int same(double a, double b)
{
    return a == b || (isnan(a) && isnan(b));
}

static void compare(taut_surface *surface, int grid, const char *what)
{
    const taut_measure_options options = {.grid = grid};
    taut_surface_measure all;
    taut_mean_figures some;
    CHECK(taut_measure_surface(surface, &options, &all, NULL) == TAUT_OK, "%s", what);
    CHECK(taut_mean_figures_of(surface, grid, NULL, &some) == TAUT_OK, "%s", what);
    CHECK(same(some.max_abs, all.max_abs_mean), "%s: %.17g, not %.17g", what, some.max_abs,
          all.max_abs_mean);
    CHECK(isnan(some.mean_abs) == isnan(all.mean_abs_mean), "%s", what);
    if (!isnan(some.mean_abs) && !(all.area_error > 0)) {
        /* the areas to 1e-10 each; mean_abs to 1e-6, of a film alone to four digits: of 3,200 random
         * surfaces the farthest is off by 1.1e-5 */
        CHECK_NEAR(some.area, all.area, 2e-10 * all.area, "%s", what);
        CHECK_NEAR(some.mean_abs, all.mean_abs_mean,
                   1.5e-5 * all.mean_abs_mean + 1e-11 * all.max_abs_mean, "%s", what);
    }
    taut_surface_free(surface);
}

/* kind: 1 collapses an edge, 2 flattens, 3 shrinks beyond what squares of numbers hold. */
static taut_surface *random_surface(int kind, int has_weights)
{
    const int p = random_int(2, 5), q = random_int(2, 5);
    const int n = p + random_int(1, 7 - p), m = q + random_int(1, 7 - q);
    const double size = kind == 3 ? 1e-90 : random_log(1e-3, 1e3);
    double points[POINTS_MAX][3], weights[POINTS_MAX];
    for (int k = 0; k < n * m; k++) {
        const double shake = 0.3 * size / n;
        points[k][0] = size * (k / m) / n + random_in(-shake, shake);
        points[k][1] = size * (k % m) / m + random_in(-shake, shake);
        points[k][2] = kind == 2 ? 0 : random_in(-size, size);
        weights[k] = random_log(0.5, 2);
    }
    for (int k = 1; kind == 1 && k < m; k++) {
        for (int c = 0; c < 3; c++) {
            points[k][c] = points[0][c];
        }
    }
    return shape_surface(shape_bspline(p, n), shape_bspline(q, m), points[0],
                         has_weights ? weights : NULL);
}

int main(void)
{
    random_seed(20261121);
    for (int trial = 0; trial < random_trials(10); trial++) {
        char what[64];
        snprintf(what, sizeof what, "trial %d", trial);
        compare(random_surface(trial % 4, trial % 3 == 0), 5 + 4 * (trial % 5), what);
    }
    compare(shape_torus(3, 1), 101, "torus");
    return check_failures != 0;
}
