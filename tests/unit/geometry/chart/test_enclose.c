/* test_enclose.c -- places and derivatives of random surfaces lie where they are said to lie over a part, and that is not much more. */
#include "check.h"
#include "geometry/chart/enclose.h"

#include <stdlib.h>

enum { MOST = 9 };

static taut_basis *basis_of(int kind)
{
    static const double knots[] = {0, 0, 0, 0, 0.3, 0.45, 0.45, 1, 1, 1, 1};
    static const taut_basis_spec specs[] = {
        {.type = "bezier", .degree = 5},
        {.type = "bspline", .degree = 3, .knot_count = 11, .knots = knots},
        {.type = "c-bezier", .alpha = 2},
        {.type = "h-bezier", .beta = 1.5},
        {.type = "c-bspline", .alpha = 1.2, .segments = 3},
        {.type = "bezier", .degree = 8}};
    taut_basis *basis = NULL;
    taut_error error;
    CHECK(taut_basis_new(&specs[kind], 0, &basis, &error) == TAUT_OK, "%s", error.message);
    return basis;
}

/* Of a wave, so that derivatives of all orders are of one size. */
static taut_surface *surface_of(int u_kind, int v_kind, int is_rational)
{
    taut_basis *u = basis_of(u_kind), *v = basis_of(v_kind);
    double points[MOST * MOST][3], weights[MOST * MOST];
    taut_surface *surface = NULL;
    taut_error error;
    const int count[2] = {taut_basis_count(u), taut_basis_count(v)};
    for (int i = 0; i < count[0]; i++) {
        for (int k = 0; k < count[1]; k++) {
            double *p = points[i * count[1] + k];
            p[0] = 100 + i;
            p[1] = k;
            p[2] = random_in(-1, 1);
            weights[i * count[1] + k] = random_in(0.7, 1.4);
        }
    }
    CHECK(taut_surface_new("s", u, v, points[0], is_rational ? weights : NULL, &surface, &error) ==
              TAUT_OK,
          "%s", error.message);
    taut_basis_free(u);
    taut_basis_free(v);
    return surface;
}

static void part_of(const taut_basis *basis, double size, double *a, double *b)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    *a = random_in(lo, hi - size * (hi - lo));
    *b = *a + size * (hi - lo);
}

/* How wide the ranges are over what is found in them, of the six vectors; 0 where one holds not all. */
static double look_at(const taut_surface *surface, double size)
{
    enum { PLACES = 6 };
    double a[2], b[2], widest = 0;
    taut_range x[6][3], found[6][3];
    part_of(taut_surface_u(surface), size, &a[0], &b[0]);
    part_of(taut_surface_v(surface), size, &a[1], &b[1]);
    CHECK(taut_enclose_surface(surface, a, b, NULL, x), "not known");
    for (int i = 0; i <= PLACES * PLACES + PLACES; i++) {
        const double u = fmin(a[0] + (b[0] - a[0]) * (i % (PLACES + 1)) / PLACES, b[0]);
        const double v = fmin(a[1] + (b[1] - a[1]) * (i / (PLACES + 1)) / PLACES, b[1]);
        double own[6][3];
        taut_surface_eval(surface, u, v, 2, own[0]);
        for (int k = 0; k < 18; k++) {
            const double y = own[k / 3][k % 3];
            taut_range *all = &found[k / 3][k % 3], *said = &x[k / 3][k % 3];
            *all = i == 0 ? taut_range_of(y) : taut_range_join(*all, taut_range_of(y));
            CHECK(y >= said->lo && y <= said->hi, "vector %d: %.17g not in [%.17g, %.17g]", k / 3,
                  y, said->lo, said->hi);
        }
    }
    for (int k = 0; k < 18; k++) {
        const taut_range *all = &found[k / 3][k % 3], *said = &x[k / 3][k % 3];
        widest = fmax(widest, (said->hi - said->lo) - (all->hi - all->lo));
    }
    return widest;
}

static void test_surfaces(void)
{
    static const int kinds[][3] = {{0, 1, 0}, {2, 3, 0}, {4, 2, 0}, {1, 5, 0}, {0, 1, 1}};
    for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
        for (int trial = 0; trial < random_trials(12); trial++) {
            taut_surface *surface = surface_of(kinds[k][0], kinds[k][1], kinds[k][2]);
            /* too much falls with the square of the size, of quotients with the size: derivatives are up to 1e4, of the third order 1e6 */
            const double small = look_at(surface, 0.01);
            CHECK(small < (kinds[k][2] ? 4e4 : 4e2), "kind %d: %g too wide", (int)k, small);
            look_at(surface, 0.2);
            look_at(surface, 0.9);
            taut_surface_free(surface);
        }
    }
}

/* Weights and degrees of which nothing is known. */
static void test_unknown(void)
{
    static const double knots[24] = {[12] = 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    static const taut_basis_spec spec = {
        .type = "bspline", .degree = 11, .knot_count = 24, .knots = knots};
    double points[12][3] = {{0}};
    taut_basis *basis = NULL;
    taut_curve *curve = NULL;
    taut_range x[3][3];
    CHECK(taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK, "basis");
    CHECK(taut_curve_new("c", basis, points[0], NULL, &curve, NULL) == TAUT_OK, "curve");
    CHECK(!taut_enclose_curve(curve, 0, 1, x), "degree 11");
    taut_curve_free(curve);
    taut_basis_free(basis);
}

int main(void)
{
    random_seed(28);
    test_surfaces();
    test_unknown();
    return check_failures != 0;
}
