/* test_box.c -- bounding boxes: of the surface, not of its net. */
#include "check.h"
#include "shapes.h"

#include "taut/measure.h"

static void check_box(const taut_surface *s, const double lo[3], const double hi[3],
                      double tolerance, const char *what)
{
    const taut_measure_options coarse = {.grid = 2};
    taut_surface_measure m;
    CHECK(taut_measure_surface(s, &coarse, &m, NULL) == TAUT_OK, "%s", what);
    for (int c = 0; c < 3; c++) {
        CHECK_NEAR(m.box[0][c], lo[c], tolerance, "%s, least of %d", what, c);
        CHECK_NEAR(m.box[1][c], hi[c], tolerance, "%s, largest of %d", what, c);
    }
}

int main(void)
{
    taut_surface *s = shape_torus(3, 1);
    check_box(s, (double[]){-4, -4, -1}, (double[]){4, 4, 1}, 4e-15, "torus");
    taut_surface_free(s);

    /* z = u^2 - v^2 over [-1, 2] x [-1/2, 1]; x, y have their extremes inside edges */
    s = shape_enneper(-1, 2, -0.5, 1);
    /* x = u - u^3/3 + u v^2: largest at v = 1: 2u - u^3/3, u = sqrt 2; least at u = -1, v = 1 or
     * u = 2: min(-1 + 1/3 - 1, 2 - 8/3 + 0) */
    check_box(s, (double[]){-5. / 3, -1 - 4 + 1. / 3, -1},
              (double[]){2 * sqrt(2) - pow(2, 1.5) / 3, 0.5 + 2 - 1. / 24, 4}, 1e-14, "enneper");
    taut_surface_free(s);

    /* a bump with its top inside: z = 16 u (1-u) v (1-v), moved so that it is not at a sample */
    double points[3][3][3];
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            points[i][j][0] = i / 2.0;
            points[i][j][1] = j / 2.0;
            points[i][j][2] = i == 1 && j == 1 ? 4 : i == 2 && j == 1 ? 0.5 : 0;
        }
    }
    s = shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), points[0][0], NULL);
    /* v = 1/2: z = (8 u (1-u) + u^2/2) / 2, top at u = 8/15 */
    check_box(s, (double[]){0, 0, 0}, (double[]){1, 1, 16.0 / 15}, 1e-14, "bump");
    taut_surface_free(s);

    /* ridges in a fine net: the largest of sin is between knots almost everywhere */
    enum { N = 40 };
    static double net[N * N][3];
    for (int k = 0; k < N * N; k++) {
        net[k][0] = (double)(k / N) / (N - 1);
        net[k][1] = (double)(k % N) / (N - 1);
        net[k][2] = 0.05 * sin(0.8 * (k / N) + 0.5 * (k % N));
    }
    s = shape_surface(shape_bspline(3, N), shape_bspline(3, N), net[0], NULL);
    taut_surface_measure m;
    CHECK(taut_measure_surface(s, NULL, &m, NULL) == TAUT_OK, "ridges");
    double seen[2] = {0, 0};
    enum { M = 1001 };
    static double t[M], values[M * 3];
    for (int j = 0; j < M; j++) {
        t[j] = (double)j / (M - 1);
    }
    for (int i = 0; i < M; i++) {
        CHECK(taut_surface_eval_grid(s, 1, &t[i], M, t, 0, 1, values) == TAUT_OK, "grid");
        for (int j = 0; j < M; j++) {
            seen[0] = fmin(seen[0], values[3 * j + 2]);
            seen[1] = fmax(seen[1], values[3 * j + 2]);
        }
    }
    /* nothing sticks out, and a sample half a cell of 1e-3 away is lower by at most |z''| h^2/2 */
    CHECK(m.box[0][2] <= seen[0] && m.box[1][2] >= seen[1], "outside");
    CHECK_NEAR(m.box[0][2], seen[0], 1e-4, "least");
    CHECK_NEAR(m.box[1][2], seen[1], 1e-4, "largest");
    CHECK(m.box[0][0] == 0 && m.box[1][0] == 1 && m.box[0][1] == 0 && m.box[1][1] == 1, "square");
    taut_surface_free(s);
    return check_failures != 0;
}
