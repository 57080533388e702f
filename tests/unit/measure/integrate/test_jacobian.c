/* test_jacobian.c -- the sign of the Jacobian of planar surfaces, against closed forms and samples.
 */
#include "check.h"
#include "shapes.h"

#include "taut/measure.h"
#include "taut/operations.h"

#include <string.h>

static taut_jacobian of(const taut_surface *surface, const char *what)
{
    taut_jacobian found = {TAUT_JACOBIAN_NONE, 9, -9, {-9, -9}, -9};
    CHECK(taut_surface_jacobian(surface, &found) == TAUT_OK, "%s", what);
    return found;
}

/* z^2 over [u0, u0+1] x [0, 1]: x = u^2 - v^2, y = 2 u v, J = 4 (u^2 + v^2). */
static taut_surface *square_map(double u0, double u1)
{
    double one[3], u[3], uu[3], t[3], tt[3], points[27];
    const double powers[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    shape_bernstein(2, 3, powers[0], u0, u1, one);
    shape_bernstein(2, 3, powers[1], u0, u1, u);
    shape_bernstein(2, 3, powers[2], u0, u1, uu);
    shape_bernstein(2, 3, powers[1], 0, 1, t);
    shape_bernstein(2, 3, powers[2], 0, 1, tt);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            points[9 * i + 3 * j] = uu[i] - tt[j];
            points[9 * i + 3 * j + 1] = 2 * u[i] * t[j];
            points[9 * i + 3 * j + 2] = 5;
        }
    }
    return shape_surface(shape_bezier(2, u0, u1), shape_bezier(2, 0, 1), points, NULL);
}

static void test_square_map(void)
{
    taut_surface *away = square_map(1, 2), *corner = square_map(0, 1), *through = square_map(-1, 1);
    taut_jacobian j = of(away, "away from 0");
    CHECK(j.state == TAUT_JACOBIAN_ONE_SIGN && j.sign == 1, "state %d sign %d", (int)j.state,
          j.sign);
    CHECK(j.lowest <= 4 && j.lowest >= 3.95, "lowest %.17g", j.lowest);
    CHECK(j.at[0] == 1 && j.at[1] == 0, "at %g %g", j.at[0], j.at[1]);
    j = of(corner, "zero at a corner");
    CHECK(j.state == TAUT_JACOBIAN_ONE_SIGN && j.lowest == 0, "%d: %g", (int)j.state, j.lowest);
    j = of(through, "zero inside an edge: nothing is proved that is not so");
    CHECK(j.state != TAUT_JACOBIAN_FOLDS && fabs(j.lowest) < 1e-6, "%d: %g", (int)j.state,
          j.lowest);
    taut_surface_free(away);
    taut_surface_free(corner);
    taut_surface_free(through);
}

/* x = u, y = v - c 4u(1-u) (3v^2 - 2v^3): J = 1 - 24 c u(1-u) v(1-v), least 1 - 1.5 c in the
 * middle.
 */
static taut_surface *bump(double c, const int axes[2])
{
    const double hill[3] = {0, 4, -4}, rise[4] = {0, 0, 3, -2};
    double h[3], r[4], points[36] = {0};
    shape_bernstein(2, 3, hill, 0, 1, h);
    shape_bernstein(3, 4, rise, 0, 1, r);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            double *p = points + 3 * (4 * i + j);
            p[axes[0]] = i / 2.0;
            p[axes[1]] = j / 3.0 - c * h[i] * r[j];
        }
    }
    return shape_surface(shape_bezier(2, 0, 1), shape_bezier(3, 0, 1), points, NULL);
}

static void test_bump(void)
{
    static const int planes[3][2] = {{0, 1}, {1, 2}, {2, 0}};
    for (int k = 0; k < 3; k++) {
        for (double c = 0.05; c < 1; c += 0.1) {
            taut_surface *surface = bump(c, planes[k]), *spline = NULL, *turned = NULL;
            const double least = 1 - 1.5 * c;
            taut_jacobian j = of(surface, "bump");
            CHECK(j.state == (least > 0 ? TAUT_JACOBIAN_ONE_SIGN : TAUT_JACOBIAN_FOLDS), "c=%g: %d",
                  c, (int)j.state);
            CHECK(j.sign == 1, "c=%g", c);
            CHECK(least > 0 ? j.lowest <= least && j.lowest >= 0.9 * least
                            : j.lowest >= least - 1e-12 && j.lowest < 0,
                  "c=%g: lowest %g, true %g", c, j.lowest, least);
            CHECK(taut_surface_refine(surface, TAUT_ALONG_U, &spline, NULL) == TAUT_OK, "refine");
            j = of(spline, "spline");
            CHECK(j.state == (least > 0 ? TAUT_JACOBIAN_ONE_SIGN : TAUT_JACOBIAN_FOLDS),
                  "spline c=%g: %d", c, (int)j.state);
            turned = shape_transposed(surface);
            j = of(turned, "transposed");
            CHECK(j.sign == -1, "c=%g: transposing turns the orientation", c);
            taut_surface_free(spline);
            taut_surface_free(turned);
            taut_surface_free(surface);
        }
    }
}

/* J at a point by evaluation, in the coordinates x, y. */
static double value(const taut_surface *surface, double u, double v)
{
    double x[3][3];
    CHECK(taut_surface_eval(surface, u, v, 1, &x[0][0]) == TAUT_OK, "u=%g v=%g", u, v);
    return x[1][0] * x[2][1] - x[1][1] * x[2][0];
}

/* Perturbed grids: every verdict holds at samples, and few are left open. */
static void test_random(void)
{
    int seen[5] = {0, 0, 0, 0, 0};
    for (int trial = 0; trial < 300; trial++) {
        const int n = random_int(1, 5), m = random_int(1, 5);
        const double noise = random_in(0, 1.5), offset = trial % 3 == 0 ? 1e8 : 0;
        const double size = random_log(1e-6, 1e6);
        double points[3 * 36];
        for (int i = 0; i <= n; i++) {
            for (int k = 0; k <= m; k++) {
                double *p = points + 3 * (i * (m + 1) + k);
                p[0] = offset + size * (i + noise * random_in(-1, 1));
                p[1] = offset - size * (k + noise * random_in(-1, 1));
                p[2] = offset;
            }
        }
        taut_surface *s =
            shape_surface(shape_bezier(n, 0, 2), shape_bezier(m, -1, 1), points, NULL);
        const taut_jacobian j = of(s, "random");
        /* evaluating far from the origin rounds by units of 2^-53 of the offset */
        const double unit = n * m * (size * size + 1e9 * 0x1p-48 * offset * size);
        double least = INFINITY;
        for (int a = 0; a <= 20; a++) {
            for (int b = 0; b <= 20; b++) {
                least = fmin(least, j.sign * value(s, a / 10.0, -1 + b / 10.0));
            }
        }
        seen[j.state]++;
        if (j.state == TAUT_JACOBIAN_ONE_SIGN) {
            CHECK(least >= j.lowest - 1e-9 * unit, "n=%d m=%d: %g below %g", n, m, least, j.lowest);
            CHECK(j.lowest >= 0, "n=%d m=%d", n, m);
        } else if (j.state == TAUT_JACOBIAN_FOLDS) {
            const double there = j.sign * value(s, j.at[0], j.at[1]);
            CHECK(j.lowest < 0 && fabs(there - j.lowest) <= 1e-6 * unit + 1e-6 * fabs(there),
                  "n=%d m=%d: %g there, %g said", n, m, there, j.lowest);
        }
        taut_surface_free(s);
    }
    CHECK(seen[TAUT_JACOBIAN_ONE_SIGN] > 40 && seen[TAUT_JACOBIAN_FOLDS] > 40 &&
              seen[TAUT_JACOBIAN_UNDECIDED] < 12 && seen[TAUT_JACOBIAN_NONE] == 0,
          "one sign %d, folds %d, open %d, not planar %d", seen[1], seen[2], seen[3], seen[0]);
}

static void test_others(void)
{
    const double points[4][3] = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const double line[4][3] = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
    const double weights[4] = {1, 1, 2, 1};
    const double same[4][3] = {{0}};
    const taut_basis_spec trigonometric = {.type = "c-bezier", .alpha = 1};
    double net[48] = {0};
    taut_surface *surfaces[6] = {
        shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), points[0], NULL),
        shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), line[0], NULL),
        shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), same[0], NULL),
        shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), points[0], weights),
        shape_saddle(1),
        NULL};
    static const taut_jacobian_state wanted[6] = {
        TAUT_JACOBIAN_ONE_SIGN,    TAUT_JACOBIAN_FOLDS, TAUT_JACOBIAN_FOLDS,
        TAUT_JACOBIAN_UNSUPPORTED, TAUT_JACOBIAN_NONE,  TAUT_JACOBIAN_UNSUPPORTED};

    for (int i = 0; i < 16; i++) {
        net[3 * i] = i / 4;
        net[3 * i + 1] = i % 4;
    }
    surfaces[5] = shape_surface(shape_basis(&trigonometric), shape_bezier(3, 0, 1), net, NULL);
    for (int k = 0; k < 6; k++) {
        const taut_jacobian j = of(surfaces[k], "others");
        CHECK(j.state == wanted[k], "surface %d: %d, expected %d", k, (int)j.state, (int)wanted[k]);
        CHECK(k > 2 || j.lowest == 0, "surface %d: lowest %g", k, j.lowest);
        taut_surface_free(surfaces[k]);
    }
    CHECK(taut_surface_jacobian(NULL, NULL) == TAUT_BAD_ARGUMENT, "NULL");
}

int main(void)
{
    random_seed(20261121);
    test_square_map();
    test_bump();
    test_random();
    test_others();
    return check_failures != 0;
}
