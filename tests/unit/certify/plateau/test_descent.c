/* test_descent.c -- what going along moves gains at most, against differences of areas.
 *
 * The area of the moved surface is integrated by this test; its first and second differences at
 * five steps give the gain, to 1e-5 or so. What is proved must never be less, and not be much more.
 */
#include "certify/plateau/descent.h"

#include "check.h"
#include "shapes.h"

#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 64, NODES = 24 };
static const double step = 4e-3;

typedef enum kind { POLYNOMIAL, RATIONAL, TRIGONOMETRIC, HYPERBOLIC, KINDS } kind;

static taut_basis *random_basis(kind which)
{
    const int is_spline = random_int(0, 1), segments = random_int(1, 3), degree = random_int(2, 4);
    if (which == TRIGONOMETRIC) {
        const taut_basis_spec spec = {.type = is_spline ? "c-bspline" : "c-bezier",
                                      .alpha = random_in(0.5, 2),
                                      .segments = is_spline ? segments : 0};
        return shape_basis(&spec);
    }
    if (which == HYPERBOLIC) {
        const taut_basis_spec spec = {.type = is_spline ? "h-bspline" : "h-bezier",
                                      .beta = random_log(0.5, 3),
                                      .segments = is_spline ? segments : 0};
        return shape_basis(&spec);
    }
    return is_spline ? shape_bspline(degree, degree + segments) : shape_bezier(degree, -1, 2);
}

static taut_surface *random_net(kind which, double size, double offset)
{
    taut_basis *u = random_basis(which), *v = random_basis(which);
    const int nu = taut_basis_count(u), nv = taut_basis_count(v);
    double points[MOST][3], weights[MOST];

    for (int k = 0; k < nu * nv; k++) {
        points[k][0] = offset + size * (k / nv + random_in(-0.1, 0.1)) / nu;
        points[k][1] = offset + size * (k % nv + random_in(-0.1, 0.1)) / nv;
        points[k][2] = size * random_in(-0.2, 0.2);
        weights[k] = random_log(1, 4);
    }
    return shape_surface(u, v, points[0], which == RATIONAL ? weights : NULL);
}

/* The area of the surface with its points moved by t d, in cells of a quarter of a span. */
static double area_of(const taut_surface *s, double t, const double *d)
{
    const taut_basis *u = taut_surface_u(s), *v = taut_surface_v(s);
    const int count = taut_basis_count(u) * taut_basis_count(v);
    double points[MOST][3], node[NODES], weight[NODES], sum = 0;
    taut_surface *moved = NULL;

    for (int k = 0; k < 3 * count; k++) {
        points[k / 3][k % 3] = taut_surface_points(s)[k] + t * d[k];
    }
    CHECK(taut_surface_new("", u, v, points[0], taut_surface_weights(s), &moved, NULL) == TAUT_OK,
          "moved");
    taut_gauss_rule(NODES, node, weight);
    for (int cell = 0; cell < 4 * taut_basis_span_count(u) * taut_basis_span_count(v) * 4; cell++) {
        const int a = cell / (4 * taut_basis_span_count(v)),
                  b = cell % (4 * taut_basis_span_count(v));
        const double *bu = taut_basis_breaks(u) + a / 4, *bv = taut_basis_breaks(v) + b / 4;
        const double wu = (bu[1] - bu[0]) / 4, wv = (bv[1] - bv[0]) / 4;
        for (int k = 0; k < NODES * NODES; k++) {
            double x[3][3], n[3];
            taut_surface_eval(moved, bu[0] + wu * (a % 4 + 0.5 + 0.5 * node[k / NODES]),
                              bv[0] + wv * (b % 4 + 0.5 + 0.5 * node[k % NODES]), 1, x[0]);
            taut_cross(x[1], x[2], n);
            sum += 0.25 * weight[k / NODES] * weight[k % NODES] * wu * wv * taut_norm(n);
        }
    }
    taut_surface_free(moved);
    return sum;
}

/* The gain by differences of the fourth order; INFINITY where the area is not convex along d. */
static double gain_of(const taut_surface *s, const double *d, double size)
{
    const double h = step * size;
    double a[5];

    for (int k = 0; k < 5; k++) {
        a[k] = area_of(s, (k - 2) * h, d);
    }
    const double first = (8 * (a[3] - a[1]) - (a[4] - a[0])) / (12 * h);
    const double second = (16 * (a[3] + a[1]) - (a[4] + a[0]) - 30 * a[2]) / (12 * h * h);
    return second > 0 ? first * first / (2 * second) / a[2] : (double)INFINITY;
}

/* What is proved, with the errors of the gradient left out: they are the caller's. NaN where the
 * surface turns too much for any rule of the gradient. */
static double bound_of(const taut_surface *s, const double *d, double error)
{
    taut_gradient_rule rule = {.nodes = 0};
    taut_dirichlet_gradient gradient = {.unit = 0};
    double gain = NAN;

    CHECK(taut_gradient_plan(s, 1, 1, NULL, &rule) == TAUT_OK, "plan");
    if (rule.nodes > 0) {
        CHECK(taut_area_gradient_new(s, &rule, &gradient) == TAUT_OK, "gradient");
        CHECK(taut_certify_descent(s, &rule, &gradient, error, d, &gain) == TAUT_OK, "descent");
    }
    taut_gradient_rule_clear(&rule);
    taut_dirichlet_gradient_clear(&gradient);
    return gain;
}

static void test_against_differences(kind which)
{
    int proved_any = 0;

    for (int trial = 0; trial < 8; trial++) {
        const double size = trial % 2 == 0 ? 1 : random_log(1e-3, 1e3);
        taut_surface *s = random_net(which, size, trial % 3 == 0 ? 0 : 5 * size);
        const int count =
            3 * taut_basis_count(taut_surface_u(s)) * taut_basis_count(taut_surface_v(s));
        double d[3 * MOST];
        for (int k = 0; k < count; k++) {
            d[k] = random_in(-1, 1) + (k % 3 == 2);
        }
        const double told = gain_of(s, d, size), proved = bound_of(s, d, 0);
        if (!isnan(proved) && isfinite(told)) {
            CHECK(proved >= told * (1 - 1e-4), "%d: gain %.8g, proved %.8g", which, told, proved);
            CHECK(proved <= told * (1 + 1e-3), "%d: gain %.8g, proved %.8g", which, told, proved);
            CHECK(bound_of(s, d, 1e-3) > proved, "an error of the gradient counts");
            proved_any++;
        }
        CHECK(isnan(proved) || isfinite(told) || isinf(proved), "%d: no gain", which);
        taut_surface_free(s);
    }
    CHECK(proved_any >= 3, "%d: only %d were proved", which, proved_any);
}

/* Nothing is proved along no moves, nor where the area is a saddle along them: a plane moved within
 * itself has det(d_u, d_v) for a second derivative, whose integral vanishes with d on the edges. */
static void test_nothing_proved(void)
{
    const double flat[9][3] = {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 0, 0}, {1, 1, 0},
                               {1, 2, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}};
    taut_surface *s = shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), flat[0], NULL);
    double d[27] = {0};

    CHECK(isinf(bound_of(s, d, 0)), "no moves");
    d[12] = 1;
    d[13] = 0.5;
    CHECK(isinf(bound_of(s, d, 0)), "moves within the plane");
    d[14] = NAN;
    CHECK(isinf(bound_of(s, d, 0)), "no number");
    d[14] = 1;
    CHECK(bound_of(s, d, 0) < 1e-20, "across the plane, where the area is at rest");
    CHECK(bound_of(s, d, 1e-3) > 1e-9, "if the gradient is known that well");
    taut_surface_free(s);
}

int main(void)
{
    random_seed(20261122);
    for (int which = 0; which < KINDS; which++) {
        test_against_differences((kind)which);
    }
    test_nothing_proved();
    return check_failures != 0;
}
