/* test_bases.c -- orders of contact across bases: pieces of one surface of every kind, and
 * surfaces that meet in a known way on unlike bases, turned every way. */
#include "bases.h"
#include "check.h"
#include "shapes.h"

#include "core/constants.h"
#include "taut/join.h"
#include "taut/operations.h"

#include <string.h>

static taut_surface *reversed(const taut_surface *a, int direction)
{
    taut_surface *b = NULL;
    CHECK(taut_surface_reverse(a, direction, &b, NULL) == TAUT_OK, "reverse");
    return b;
}

/* The surface with u and v exchanged, and run backwards, as three bits say; its edge that was
 * `edge`. */
static taut_surface *turned(const taut_surface *a, int how, taut_edge edge, taut_edge *now)
{
    taut_surface *u = how & 1 ? reversed(a, TAUT_ALONG_U) : NULL;
    const taut_surface *first = u != NULL ? u : a;
    taut_surface *v = how & 2 ? reversed(first, TAUT_ALONG_V) : NULL;
    const taut_surface *second = v != NULL ? v : first;
    taut_surface *t = NULL;
    int held = (int)edge / 2, end = (int)edge % 2;
    end = (how & (held == 0 ? 1 : 2)) != 0 ? 1 - end : end;
    if (how & 4) {
        CHECK(taut_surface_transpose(second, &t, NULL) == TAUT_OK, "transpose");
        held = 1 - held;
    } else {
        CHECK(taut_surface_copy(second, &t) == TAUT_OK, "copy");
    }
    *now = (taut_edge)(2 * held + end);
    taut_surface_free(u);
    taut_surface_free(v);
    return t;
}

/* Whichever way either is turned. */
static void check_orders(const taut_surface *a, taut_edge edge_a, const taut_surface *b,
                         taut_edge edge_b, int c, int g, const char *what)
{
    for (int how = 0; how < 8; how++) {
        taut_edge ea = edge_a, eb = edge_b;
        taut_surface *ta = turned(a, 7 - how, edge_a, &ea), *tb = turned(b, how, edge_b, &eb);
        taut_join join = {.c_order = -2};
        CHECK(taut_join_measure(ta, ea, tb, eb, &join, NULL) == TAUT_OK, "%s", what);
        CHECK(join.c_order == c && join.g_order == g,
              "%s, turned %d: c %d g %d, expected %d %d; gap %g, angle %g", what, how, join.c_order,
              join.g_order, c, g, join.max_gap, join.max_normal_angle);
        taut_surface_free(ta);
        taut_surface_free(tb);
    }
}

enum { C_BEZIER, C_BSPLINE, H_BEZIER, H_BSPLINE, BEZIER, BSPLINE, TYPES };

/* Random of a type; a bspline's knots are uniform. */
static taut_basis *random_basis(int type)
{
    static const char *const names[TYPES] = {"c-bezier",  "c-bspline", "h-bezier",
                                             "h-bspline", "bezier",    "bspline"};
    if (type == BEZIER || type == BSPLINE) {
        const int degree = random_int(3, 4);
        return type == BEZIER ? shape_bezier(degree, 0, 1)
                              : shape_bspline(degree, degree + random_int(2, 4));
    }
    const int is_circular = type == C_BEZIER || type == C_BSPLINE;
    const double length = is_circular ? random_in(0.3, 2.8) : random_log(0.3, 30);
    const int segments = type == C_BSPLINE || type == H_BSPLINE ? random_int(2, 4) : 0;
    const taut_basis_spec spec = spec_of_spans(names[type], length, segments, 0);
    return shape_basis(&spec);
}

static void random_net(const taut_basis *u, const taut_basis *v, double points[][3],
                       double *weights)
{
    const int nu = taut_basis_count(u), nv = taut_basis_count(v);
    for (int i = 0; i < nu * nv; i++) {
        points[i][0] = i / nv + random_in(-0.3, 0.3); /* so that it is regular */
        points[i][1] = i % nv + random_in(-0.3, 0.3);
        points[i][2] = random_in(-0.5, 0.5);
        weights[i] = random_in(0.7, 1.4);
    }
}

/* Cut between knots both pieces are one smooth surface; on a knot they are C^2 (c- and h-), or C to
 * the degree less one, and no more by any parameters. */
static void test_pieces(int type_u, int type_v)
{
    taut_basis *u = random_basis(type_u), *v = random_basis(type_v);
    double points[81][3], weights[81];
    taut_surface *whole = NULL;
    taut_model *pieces = NULL;
    taut_error error = {.message = ""};
    const int rational = type_u >= BEZIER && type_v >= BEZIER;
    const int at_knot = taut_basis_span_count(u) > 1 && random_int(0, 1);
    const int degree = taut_basis_degree(u);
    const double *breaks = taut_basis_breaks(u);
    const double t =
        at_knot ? breaks[1] : breaks[0] + (breaks[1] - breaks[0]) * random_in(0.3, 0.7);
    const int smooth = !at_knot ? 3 : degree < 0 ? 2 : degree - 1;
    char what[80];
    random_net(u, v, points, weights);
    snprintf(what, sizeof what, "%s x %s, %s", taut_basis_type(u), taut_basis_type(v),
             at_knot ? "on a knot" : "between knots");
    CHECK(taut_surface_new("", u, v, points[0], rational ? weights : NULL, &whole, NULL) == TAUT_OK,
          "surface");
    CHECK(taut_surface_split(whole, TAUT_ALONG_U, t, &pieces, &error) == TAUT_OK, "%s",
          error.message);
    int low = 0; /* the piece that ends at t: a spline may have opened into more than two */
    while (taut_basis_hi(taut_surface_u(taut_model_surface(pieces, low))) < t) {
        low++;
    }
    check_orders(taut_model_surface(pieces, low), TAUT_EDGE_U1, taut_model_surface(pieces, low + 1),
                 TAUT_EDGE_U0, smooth, smooth, what);
    taut_model_free(pieces);
    taut_surface_free(whole);
    taut_basis_free(u);
    taut_basis_free(v);
}

/* A quarter of the unit circle times a line: on c-bezier, whose coefficients of cos and sin are
 * (1, 1, a cot(a/2) - 1, 0) and reversed ([XuWang2006] section 3), and as a rational parabola. */
static taut_surface *quarter_tube(int rational, double low, double high)
{
    const double c[4] = {1, 1, TAUT_PI / 2 - 1, 0}, w[6] = {1, 1, sqrt(0.5), sqrt(0.5), 1, 1};
    const double x[3] = {1, 1, 0};
    double points[4][2][3];
    taut_basis *u =
        shape_basis(rational ? &(taut_basis_spec){.type = "bezier", .degree = 2}
                             : &(taut_basis_spec){.type = "c-bezier", .alpha = TAUT_PI / 2});
    taut_basis *v = shape_basis(&(taut_basis_spec){.type = "bezier", .degree = 1});
    taut_surface *surface = NULL;
    for (int i = 0; i < (rational ? 3 : 4); i++) {
        for (int j = 0; j < 2; j++) {
            points[i][j][0] = rational ? x[i] : c[i];
            points[i][j][1] = rational ? x[2 - i] : c[3 - i];
            points[i][j][2] = j == 0 ? low : high;
        }
    }
    CHECK(taut_surface_new("", u, v, points[0][0], rational ? w : NULL, &surface, NULL) == TAUT_OK,
          "tube");
    taut_basis_free(u);
    taut_basis_free(v);
    return surface;
}

/* A quarter of the catenoid (cos u cosh v, sin u cosh v, v), 0 <= v <= beta. */
static taut_surface *catenoid(double beta)
{
    const double c[4] = {1, 1, TAUT_PI / 2 - 1, 0};
    const double k = (beta - sinh(beta)) / (1 - cosh(beta));
    const double h[4] = {1, 1, beta / tanh(beta / 2) - 1, cosh(beta)},
                 z[4] = {0, k, beta - k, beta};
    double points[4][4][3];
    taut_basis *u = shape_basis(&(taut_basis_spec){.type = "c-bezier", .alpha = TAUT_PI / 2});
    taut_basis *v = shape_basis(&(taut_basis_spec){.type = "h-bezier", .beta = beta});
    taut_surface *surface = NULL;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            points[i][j][0] = c[i] * h[j];
            points[i][j][1] = c[3 - i] * h[j];
            points[i][j][2] = z[j];
        }
    }
    CHECK(taut_surface_new("", u, v, points[0][0], NULL, &surface, NULL) == TAUT_OK, "catenoid");
    taut_basis_free(u);
    taut_basis_free(v);
    return surface;
}

/* One cylinder in two parameters along the edge is G^3 and C^0; the waist of a catenoid touches it
 * (G^1), and by equal parameters r_v = (0, 0, 1) on both sides: C^1. */
static void test_unlike(void)
{
    taut_surface *low = quarter_tube(0, -1, 0), *high = quarter_tube(1, 0, 1);
    taut_surface *same = quarter_tube(0, 0, 1), *waist = catenoid(1);
    taut_surface *lifted = quarter_tube(1, 1e-3, 1);
    check_orders(low, TAUT_EDGE_V1, same, TAUT_EDGE_V0, 3, 3, "tube and tube, c-bezier");
    check_orders(low, TAUT_EDGE_V1, high, TAUT_EDGE_V0, 0, 3, "tube, c-bezier and rational");
    check_orders(low, TAUT_EDGE_V1, waist, TAUT_EDGE_V0, 1, 1, "tube and catenoid, c-bezier");
    check_orders(high, TAUT_EDGE_V0, waist, TAUT_EDGE_V0, 0, 0, "folded back");
    check_orders(low, TAUT_EDGE_V1, lifted, TAUT_EDGE_V0, -1, -1, "a gap");
    taut_surface_free(low);
    taut_surface_free(high);
    taut_surface_free(same);
    taut_surface_free(waist);
    taut_surface_free(lifted);
}

/* Cut far from the layers at their ends, long hyperbolic pieces still are one surface. */
static void test_long_pieces(void)
{
    for (double beta = 50; beta <= 300; beta += 125) {
        double points[16][3], weights[16];
        taut_basis *u = shape_basis(&(taut_basis_spec){.type = "h-bezier", .beta = beta});
        taut_basis *v = shape_basis(&(taut_basis_spec){.type = "h-bezier", .beta = beta / 7});
        taut_surface *whole = NULL;
        taut_model *pieces = NULL;
        random_net(u, v, points, weights);
        CHECK(taut_surface_new("", u, v, points[0], NULL, &whole, NULL) == TAUT_OK, "surface");
        CHECK(taut_surface_split(whole, TAUT_ALONG_U, 0.3 * beta, &pieces, NULL) == TAUT_OK, "cut");
        check_orders(taut_model_surface(pieces, 0), TAUT_EDGE_U1, taut_model_surface(pieces, 1),
                     TAUT_EDGE_U0, 3, 3, "long");
        taut_model_free(pieces);
        taut_surface_free(whole);
        taut_basis_free(u);
        taut_basis_free(v);
    }
}

int main(void)
{
    random_seed(20260715);
    for (int trial = 0; trial < random_trials(2 * TYPES * TYPES); trial++) {
        test_pieces(trial % TYPES, trial / TYPES % TYPES);
    }
    test_unlike();
    test_long_pieces();
    return check_failures != 0;
}
