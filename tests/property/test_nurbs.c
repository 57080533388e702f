/* test_nurbs.c -- the proved distance between c- and h- nets and their NURBS: never passed, never
 * far from what is seen, below what was asked. */
#include "bases.h"
#include "check.h"
#include "shapes.h"

#include "core/constants.h"
#include "taut/operations.h"

#include <stdlib.h>
#include <string.h>

enum { C_BEZIER, C_BSPLINE, H_BEZIER, H_BSPLINE, BEZIER, TYPES };
static const char *const type_names[TYPES] = {"c-bezier", "c-bspline", "h-bezier", "h-bspline",
                                              "bezier"};

static taut_basis *random_basis(int type)
{
    const double longest[TYPES] = {TAUT_PI, 3, 300, 300, 1};
    const double length = type == H_BEZIER || type == H_BSPLINE ? random_log(0.3, longest[type])
                                                                : random_in(0.1, 1) * longest[type];
    if (type == BEZIER) {
        return shape_bezier(random_int(1, 5), 0, 1);
    }
    const int segments = type == C_BSPLINE || type == H_BSPLINE ? random_int(1, 4) : 0;
    const taut_basis_spec spec = spec_of_spans(type_names[type], length, segments, 0);
    return shape_basis(&spec);
}

static void random_points(size_t count, double *points)
{
    for (size_t i = 0; i < 3 * count; i++) {
        points[i] = random_in(-1, 1);
    }
}

static double distance(const double *a, const double *b)
{
    return sqrt(pow(a[0] - b[0], 2) + pow(a[1] - b[1], 2) + pow(a[2] - b[2], 2));
}

static double most_pessimistic = 0;

/* seen <= bound <= tolerance; and bound <= 50 seen, where neither is rounding. */
static void judge(double seen, double bound, double tolerance, double size, const char *what)
{
    CHECK(seen <= bound, "%s: %g off, proved %g", what, seen, bound);
    CHECK(bound <= tolerance, "%s: proved %g, asked for %g", what, bound, tolerance);
    if (bound > 1e-11 * size) { /* 100 times what is allowed for rounding */
        most_pessimistic = fmax(most_pessimistic, bound / seen);
        CHECK(bound <= 50 * seen, "%s: proved %g, seen %g", what, bound, seen);
    }
}

/* Some parameters within each span of a spline, and its ends. */
typedef struct samples {
    int count;
    double *t;
} samples;

static samples sample(const taut_basis *spline, int per_span)
{
    const int spans = taut_basis_span_count(spline);
    const double *breaks = taut_basis_breaks(spline);
    samples s = {spans * per_span + 1, NULL};
    s.t = malloc((size_t)s.count * sizeof *s.t);
    for (int i = 0; i < s.count - 1; i++) {
        const double *ends = breaks + i / per_span;
        s.t[i] = ends[0] + (ends[1] - ends[0]) * (i % per_span) / per_span;
    }
    s.t[s.count - 1] = taut_basis_hi(spline);
    return s;
}

static double curve_distance(const taut_curve *a, const taut_curve *spline)
{
    const samples s = sample(taut_curve_t(spline), 12);
    double seen = 0;
    for (int i = 0; i < s.count; i++) {
        double p[3], q[3];
        CHECK(taut_curve_eval(a, s.t[i], 0, p) == TAUT_OK, "t=%g", s.t[i]);
        CHECK(taut_curve_eval(spline, s.t[i], 0, q) == TAUT_OK, "t=%g", s.t[i]);
        seen = fmax(seen, distance(p, q));
    }
    free(s.t);
    return seen;
}

static void test_curve(int type)
{
    taut_basis *basis = random_basis(type);
    const double tolerance = random_log(1e-10, 1e-2);
    double points[3 * 16], bound = -1, seen = 0;
    taut_curve *curve = NULL, *nurbs = NULL;
    taut_error error = {.message = ""};
    random_points((size_t)taut_basis_count(basis), points);
    CHECK(taut_curve_new("", basis, points, NULL, &curve, NULL) == TAUT_OK, "curve");
    CHECK(taut_curve_to_nurbs(curve, tolerance, &nurbs, &bound, &error) == TAUT_OK, "%s",
          error.message);
    CHECK(strcmp(taut_basis_type(taut_curve_t(nurbs)), "bspline") == 0, "type");
    seen = curve_distance(curve, nurbs);
    if (type == BEZIER) {
        CHECK(bound == 0 && seen < 1e-15 * 64, "exact, seen %g", seen);
    } else {
        judge(seen, bound, tolerance, 1, type_names[type]);
    }
    taut_basis_free(basis);
    taut_curve_free(curve);
    taut_curve_free(nurbs);
}

static double surface_distance(const taut_surface *a, const taut_surface *spline, int per_span)
{
    const samples u = sample(taut_surface_u(spline), per_span);
    const samples v = sample(taut_surface_v(spline), per_span);
    const size_t count = (size_t)u.count * (size_t)v.count;
    double *p = malloc(3 * count * sizeof *p), *q = malloc(3 * count * sizeof *q), seen = 0;
    CHECK(taut_surface_eval_grid(a, u.count, u.t, v.count, v.t, 0, 1, p) == TAUT_OK, "surface");
    CHECK(taut_surface_eval_grid(spline, u.count, u.t, v.count, v.t, 0, 1, q) == TAUT_OK, "nurbs");
    for (size_t i = 0; i < count; i++) {
        seen = fmax(seen, distance(p + 3 * i, q + 3 * i));
    }
    free(p);
    free(q);
    free(u.t);
    free(v.t);
    return seen;
}

static void test_surface(int type_u, int type_v)
{
    taut_basis *u = random_basis(type_u), *v = random_basis(type_v);
    const double tolerance = random_log(1e-8, 1e-2);
    double points[3 * 64], bound = -1;
    taut_surface *surface = NULL, *nurbs = NULL;
    taut_error error = {.message = ""};
    random_points((size_t)taut_basis_count(u) * (size_t)taut_basis_count(v), points);
    CHECK(taut_surface_new("", u, v, points, NULL, &surface, NULL) == TAUT_OK, "surface");
    CHECK(taut_surface_to_nurbs(surface, tolerance, &nurbs, &bound, &error) == TAUT_OK, "%s",
          error.message);
    if (type_u != BEZIER || type_v != BEZIER) {
        judge(surface_distance(surface, nurbs, 4), bound, tolerance, 1, type_names[type_u]);
    }
    taut_basis_free(u);
    taut_basis_free(v);
    taut_surface_free(surface);
    taut_surface_free(nurbs);
}

/* The surface of [XuWang2006] figure 2a (alpha = pi, beta = 1, lambda = 1/2, +), its net from the
 * coefficients of sections 3 and 5. */
static taut_surface *figure_2a(void)
{
    const double k = TAUT_PI / 2, w = sqrt(0.75), kh = (1 - sinh(1)) / (1 - cosh(1));
    const double u[4] = {0, k, TAUT_PI - k, TAUT_PI}, s[4] = {0, k, TAUT_PI - k, 0},
                 c[4] = {1, 1, -1, -1};
    const double v[4] = {0, kh, 1 - kh, 1}, sh[4] = {0, kh, 1 - kh, sinh(1)};
    const double ch[4] = {1, 1, 1 / tanh(0.5) - 1, cosh(1)};
    const taut_basis_spec su = {.type = "c-bezier", .alpha = TAUT_PI};
    const taut_basis_spec sv = {.type = "h-bezier", .beta = 1};
    taut_basis *bu = NULL, *bv = NULL;
    taut_surface *surface = NULL;
    double points[16][3];
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            points[4 * i + j][0] = (0.5 * u[i] + s[i] * ch[j]) / w;
            points[4 * i + j][1] = (v[j] + 0.5 * c[i] * sh[j]) / w;
            points[4 * i + j][2] = c[i] * ch[j];
        }
    }
    CHECK(taut_basis_new(&su, 4, &bu, NULL) == TAUT_OK, "u");
    CHECK(taut_basis_new(&sv, 4, &bv, NULL) == TAUT_OK, "v");
    CHECK(taut_surface_new("2a", bu, bv, &points[0][0], NULL, &surface, NULL) == TAUT_OK, "2a");
    taut_basis_free(bu);
    taut_basis_free(bv);
    return surface;
}

/* The panels this needs beside those of the bound made for that surface alone (minimal-mesh page,
 * section 11.6): 2 x 1, 9 x 2, 22 x 7 for 1e-3, 1e-6, 1e-9. A net's bound knows less, so up to
 * twice as many; and the spline is C^2: its second derivatives agree across each knot. */
static void test_figure_2a(void)
{
    const double tolerances[3] = {1e-3, 1e-6, 1e-9};
    const int panels[3][2] = {{2, 1}, {9, 2}, {22, 7}};
    taut_surface *surface = figure_2a();
    for (int n = 0; n < 3; n++) {
        taut_surface *nurbs = NULL;
        double bound = 0;
        CHECK(taut_surface_to_nurbs(surface, tolerances[n], &nurbs, &bound, NULL) == TAUT_OK, "%g",
              tolerances[n]);
        judge(surface_distance(surface, nurbs, 12), bound, tolerances[n], 1, "figure 2a");
        const int found[2] = {taut_basis_span_count(taut_surface_u(nurbs)),
                              taut_basis_span_count(taut_surface_v(nurbs))};
        CHECK(found[0] <= 2 * panels[n][0] && found[1] <= 2 * panels[n][1], "%g: %d x %d",
              tolerances[n], found[0], found[1]);
        const taut_basis *u = taut_surface_u(nurbs);
        for (int i = 1; i < found[0]; i++) {
            const double x = taut_basis_breaks(u)[i];
            double left[18], right[18];
            taut_basis_eval(u, i - 1, x, 2, left);
            taut_basis_eval(u, i, x, 2, right);
            for (int d = 0; d < 3; d++) {
                for (int a = 3; a < 6; a++) {
                    CHECK_NEAR(left[6 * d + a], right[6 * d + a - 3], 1e-11 * pow(found[0], d),
                               "knot %d d=%d a=%d", i, d, a);
                }
            }
        }
        taut_surface_free(nurbs);
    }
    taut_surface_free(surface);
}

static void test_refusals(void)
{
    taut_surface *surface = figure_2a(), *nurbs = NULL;
    taut_error error = {.message = ""};
    double bound = 7;
    CHECK(taut_surface_to_nurbs(surface, 0, &nurbs, &bound, &error) == TAUT_BAD_ARGUMENT, "zero");
    CHECK(taut_surface_to_nurbs(surface, nan(""), &nurbs, &bound, &error) == TAUT_BAD_ARGUMENT,
          "nan");
    CHECK(taut_surface_to_nurbs(surface, 1e-15, &nurbs, &bound, &error) == TAUT_BAD_ARGUMENT,
          "below rounding");
    CHECK(error.limit > 1e-15 && error.limit < 1e-11, "says %g", error.limit);
    CHECK(taut_surface_to_nurbs(surface, error.limit * 1.1, &nurbs, NULL, &error) == TAUT_OK,
          "what it says is enough: %s", error.message);
    taut_surface_free(nurbs);
    nurbs = NULL;
    CHECK(taut_surface_to_nurbs(surface, 1e-300, &nurbs, NULL, &error) == TAUT_BAD_ARGUMENT,
          "far below rounding");
    CHECK(taut_surface_to_nurbs(NULL, 1, &nurbs, &bound, &error) == TAUT_BAD_ARGUMENT, "NULL");
    CHECK(nurbs == NULL && bound == 7, "outputs are untouched on failure");
    taut_surface_free(surface);
}

/* Long hyperbolic segments and near pi: it ends, and the bound holds. */
static void test_hard_lengths(void)
{
    const struct {
        const char *type;
        double length;
    } cases[] = {{"c-bspline", 3.14}, {"h-bezier", 300}, {"h-bspline", 100}, {"c-bezier", 1e-8}};
    for (int n = 0; n < 4; n++) {
        taut_basis_spec spec = {.type = cases[n].type, .segments = n % 2 == 0 && n < 3 ? 2 : 0};
        double points[3 * 8], bound = -1, seen = 0;
        taut_basis *basis = NULL;
        taut_curve *curve = NULL, *nurbs = NULL;
        taut_error error = {.message = ""};
        spec.segments = strstr(spec.type, "bspline") != NULL ? 2 : 0;
        *(spec.type[0] == 'c' ? &spec.alpha : &spec.beta) = cases[n].length;
        random_points(8, points);
        CHECK(taut_basis_new(&spec, 0, &basis, &error) == TAUT_OK, "%s", error.message);
        CHECK(taut_curve_new("", basis, points, NULL, &curve, NULL) == TAUT_OK, "curve");
        CHECK(taut_curve_to_nurbs(curve, 1e-6, &nurbs, &bound, &error) == TAUT_OK, "%s",
              error.message);
        seen = curve_distance(curve, nurbs);
        CHECK(seen <= bound && bound <= 1e-6, "%s: seen %g, proved %g", spec.type, seen, bound);
        taut_basis_free(basis);
        taut_curve_free(curve);
        taut_curve_free(nurbs);
    }
}

/* Spans of the NURBS of one h-bezier curve of this length; *narrowest as a part of the widest. */
static int spans_of(double beta, double tolerance, const double *points, double *narrowest)
{
    const taut_basis_spec spec = {.type = "h-bezier", .beta = beta};
    taut_basis *basis = NULL;
    taut_curve *curve = NULL, *nurbs = NULL;
    double bound = 0, least = HUGE_VAL, most = 0;
    CHECK(taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK, "basis");
    CHECK(taut_curve_new("", basis, points, NULL, &curve, NULL) == TAUT_OK, "curve");
    CHECK(taut_curve_to_nurbs(curve, tolerance, &nurbs, &bound, NULL) == TAUT_OK, "%g", beta);
    judge(curve_distance(curve, nurbs), bound, tolerance, 1, "h-bezier");
    const int spans = taut_basis_span_count(taut_curve_t(nurbs));
    const double *breaks = taut_basis_breaks(taut_curve_t(nurbs));
    for (int i = 0; i < spans; i++) {
        least = fmin(least, breaks[i + 1] - breaks[i]);
        most = fmax(most, breaks[i + 1] - breaks[i]);
    }
    *narrowest = least / most;
    taut_basis_free(basis);
    taut_curve_free(curve);
    taut_curve_free(nurbs);
    return spans;
}

/* A piece of length b has a layer at each end where |y| = c e^-s, s the distance to the end, and
 * the widest panel there has h^6 c e^-s = 46080 tolerance; c is |P_1 - P_0| or so, near 1 here. So
 * the layers take
 *     2 int ds / h(s) = 12 / h(0) panels at least,     h(0) = (46080 tolerance)^(1/6),
 * whatever b; that each panel is as narrow as its worse end wants, that the one in the middle
 * counts too, and what c is, may cost as much again and more. */
static void test_long_pieces_stay_small(void)
{
    const double points[12] = {0, 0, 0, 0.3, 1, 0, 0.6, -1, 0.5, 1, 0, 0};
    for (double tolerance = 1e-3; tolerance > 1e-10; tolerance /= 1000) {
        const double wanted = 12 / pow(46080 * tolerance, 1.0 / 6);
        for (double beta = 30; beta < 700; beta *= 2.1) {
            double narrowest = 0;
            const int spans = spans_of(beta, tolerance, points, &narrowest);
            CHECK(spans <= 2.5 * wanted + 3, "beta %g, %g: %d panels, %g wanted", beta, tolerance,
                  spans, wanted);
            CHECK(narrowest > tolerance / 100, "a sliver: %g of the widest", narrowest);
        }
    }
}

/* Pieces whose last panel stays a sliver, or comes to be one too many, at every width tried: what
 * was found with enough panels stands. */
static void test_no_width_fits(void)
{
    const struct {
        double beta, tolerance, points[12];
    } cases[] = {{452, 1e-8, {1, 1, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1}},
                 {481, 1e-8, {0, 0, 1, 2, 2, 2, 0, 2, 1, 1, 2, 1}},
                 {241.5, 1e-10, {2, 0, 2, 0, 2, 2, 2, 1, 1, 1, 2, 0}},
                 {292.5, 1e-5, {0, 1, 2, 1, 1, 2, 1, 1, 1, 2, 1, 0}},
                 {386.5, 1e-7, {1, 0, 2, 1, 2, 1, 1, 0, 2, 1, 0, 2}}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        double narrowest = 0;
        const int spans = spans_of(cases[k].beta, cases[k].tolerance, cases[k].points, &narrowest);
        CHECK(spans < 400, "%d spans of beta %g", spans, cases[k].beta);
    }
}

int main(void)
{
    random_seed(20260105);
    for (int trial = 0; trial < 300; trial++) {
        test_curve(trial % TYPES);
    }
    for (int trial = 0; trial < 3 * TYPES * TYPES; trial++) {
        test_surface(trial % TYPES, trial / TYPES % TYPES);
    }
    test_figure_2a();
    test_refusals();
    test_hard_lengths();
    test_long_pieces_stay_small();
    test_no_width_fits();
    if (getenv("TAUT_TEST_SAY") != NULL) {
        printf("most pessimistic bound: %g times what was seen\n", most_pessimistic);
    }
    return check_failures != 0;
}
