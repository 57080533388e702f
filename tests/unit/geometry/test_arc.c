/* test_arc.c -- arcs against the circle through their three points, whose centre and radius are found from the sides and angles
 * of the triangle; where no arc is. */
#include "check.h"

#include "core/constants.h"
#include "core/vec3.h"
#include "geometry/arc.h"
#include "taut/basis.h"

#include <math.h>

/* Barycentric weights a^2 (b^2 + c^2 - a^2) of the circumcentre. */
static void find_centre(const double p[3][3], double centre[3])
{
    double side[3], weight[3], sum = 0;
    for (int k = 0; k < 3; k++) {
        const double length = taut_distance(p[(k + 1) % 3], p[(k + 2) % 3]);
        side[k] = length * length;
    }
    for (int k = 0; k < 3; k++) {
        weight[k] = side[k] * (side[(k + 1) % 3] + side[(k + 2) % 3] - side[k]);
        sum += weight[k];
    }
    for (int c = 0; c < 3; c++) {
        centre[c] = 0;
        for (int k = 0; k < 3; k++) {
            centre[c] += weight[k] / sum * p[k][c];
        }
    }
}

/* On the circle, as fast everywhere, the ends where they were given, and through the middle point. */
static void check_arc(const double p[3][3], double tolerance, const char *what)
{
    taut_curve *curve = NULL;
    double centre[3], nearest = INFINITY;

    CHECK(taut_arc_new(p, &curve) == TAUT_OK, "%s", what);
    if (curve == NULL) {
        return;
    }
    find_centre(p, centre);
    const taut_basis *t = taut_curve_t(curve);
    const double lo = taut_basis_lo(t), hi = taut_basis_hi(t), radius = taut_distance(p[0], centre);
    const double chord = taut_distance(p[0], p[2]), unit = fmax(chord, radius);
    for (int k = 0; k <= 400; k++) {
        double x[2][3];
        CHECK(taut_curve_eval(curve, k == 400 ? hi : lo + (hi - lo) * k / 400, 1, x[0]) == TAUT_OK,
              "%s", what);
        CHECK_NEAR(taut_distance(x[0], centre), radius, tolerance * unit, "%s at %d", what, k);
        CHECK_NEAR(taut_norm(x[1]), radius, 1e-11 * unit, "%s at %d", what, k);
        nearest = fmin(nearest, taut_distance(x[0], p[1]));
        if (k % 400 == 0) {
            CHECK(taut_distance(x[0], p[k / 200]) <= 1e-12 * unit, "%s: end %d off by %.3g", what,
                  k / 400, taut_distance(x[0], p[k / 200]) / unit);
        }
    }
    CHECK(nearest <= radius * (hi - lo) / 800 * 1.01, "%s: %.3g from the middle point", what,
          nearest / unit);
    taut_curve_free(curve);
}

/* Arcs of any angle, anywhere, of any size: Q at any share of the arc. */
static void test_random(void)
{
    for (int trial = 0; trial < random_trials(200); trial++) {
        const double radius = random_log(1e-3, 1e3), angle = random_in(0.05, 2 * TAUT_PI - 0.05);
        const double at[3] = {0, random_in(0.1, 0.9) * angle, angle};
        double centre[3], e[3], f[3], n[3], p[3][3];
        char what[64];
        for (int c = 0; c < 3; c++) {
            centre[c] = radius * random_in(-1, 1);
            e[c] = random_in(-1, 1);
            n[c] = random_in(-1, 1);
        }
        taut_cross(n, e, f);
        taut_cross(e, f, n);
        for (int k = 0; k < 3; k++) {
            for (int c = 0; c < 3; c++) {
                p[k][c] = centre[c] + radius * (cos(at[k]) * e[c] / taut_norm(e) +
                                                sin(at[k]) * f[c] / taut_norm(f));
            }
        }
        snprintf(what, sizeof what, "trial %d, angle %.3g", trial, angle);
        check_arc((const double(*)[3])p, 1e-11, what);
    }
}

static void test_extremes(void)
{
    static const double sizes[4] = {1e-140, 1e-30, 1e30, 1e140};
    for (int k = 0; k < 4; k++) {
        const double s = sizes[k];
        const double p[3][3] = {{-s, 0, 0}, {0, 0, s}, {s, 0, 0}};
        taut_curve *curve = NULL;
        double x[3];
        CHECK(taut_arc_new(p, &curve) == TAUT_OK, "size %g", s);
        CHECK(taut_curve_eval(curve, 0.25 * TAUT_PI, 0, x) == TAUT_OK, "size %g", s);
        CHECK_NEAR(x[0] / s, -sqrt(0.5), 1e-14, "size %g", s);
        CHECK_NEAR(x[2] / s, sqrt(0.5), 1e-14, "size %g", s);
        taut_curve_free(curve);
    }
}

static void test_refused(void)
{
    static const double none[5][3][3] = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
                                         {{0, 0, 0}, {0, 0, 0}, {2, 0, 0}},
                                         {{0, 0, 0}, {1, 1, 0}, {0, 0, 0}},
                                         {{0, 0, 0}, {1, 1e-4, 0}, {2, 0, 0}},
                                         {{-1e308, 0, 0}, {0, 1e308, 0}, {1e308, 0, 0}}};
    for (int k = 0; k < 5; k++) {
        taut_curve *curve = NULL;
        CHECK(taut_arc_new(none[k], &curve) == TAUT_NO_SOLUTION, "%d", k);
        CHECK(curve == NULL, "%d", k);
    }
}

int main(void)
{
    random_seed(20261123);
    test_random();
    test_extremes();
    test_refused();
    return check_failures != 0;
}
