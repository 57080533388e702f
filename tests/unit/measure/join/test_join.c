/* test_join.c -- orders of contact, angles and gaps of surfaces made to meet in a known way. */
#include "check.h"
#include "papers.h"
#include "shapes.h"

#include "core/constants.h"
#include "taut/join.h"
#include "taut/operations.h"

#include <string.h>

static taut_join joined(const taut_surface *a, taut_edge edge_a, const taut_surface *b,
                        taut_edge edge_b)
{
    taut_join join;
    taut_error error = {.message = ""};
    memset(&join, 0, sizeof join);
    CHECK(taut_join_measure(a, edge_a, b, edge_b, &join, &error) == TAUT_OK, "%s", error.message);
    return join;
}

/* Over [0, 1]^2: (x0 + speed u + bend u^2, y(v), f u^k), y = (1 - s) v + s v^2. */
static taut_surface *strip(double x0, double speed, double bend, double s, double f, int k)
{
    double x[7], z[7], y[3], points[7][3][3];
    double cx[3] = {x0, speed, bend}, cy[3] = {0, 1 - s, s}, cz[7] = {0};
    cz[k] = f;
    shape_bernstein(6, 3, cx, 0, 1, x);
    shape_bernstein(6, 7, cz, 0, 1, z);
    shape_bernstein(2, 3, cy, 0, 1, y);
    for (int i = 0; i < 7; i++) {
        for (int j = 0; j < 3; j++) {
            points[i][j][0] = x[i];
            points[i][j][1] = y[j];
            points[i][j][2] = z[i];
        }
    }
    return shape_surface(shape_bezier(6, 0, 1), shape_bezier(2, 0, 1), points[0][0], NULL);
}

/* A plane, then z = u^k: contact of order k - 1, up to 3. With x = 1 + 2u + u^2 beyond the edge, or
 * y = (v + v^2)/2 along it, no parameter agrees and the surfaces are the same. */
static void test_orders(void)
{
    taut_surface *plane = strip(0, 1, 0, 0, 0, 1);
    for (int k = 1; k <= 6; k++) {
        const int order = k - 1 < 3 ? k - 1 : 3;
        taut_surface *same = strip(1, 1, 0, 0, 0.5, k);
        taut_surface *faster = strip(1, 2, 1, 0, 0.5, k);
        taut_surface *bent = strip(1, 1, 1, 0, 0.5, k);
        taut_surface *uneven = strip(1, 1, 0, 0.5, 0.5, k);
        const taut_join j[4] = {
            joined(plane, TAUT_EDGE_U1, same, TAUT_EDGE_U0),
            joined(plane, TAUT_EDGE_U1, faster, TAUT_EDGE_U0),
            joined(plane, TAUT_EDGE_U1, bent, TAUT_EDGE_U0),
            joined(plane, TAUT_EDGE_U1, uneven, TAUT_EDGE_U0),
        };
        const int c[4] = {order, 0, order < 1 ? order : 1, 0};
        for (int i = 0; i < 4; i++) {
            CHECK(j[i].g_order == order, "k=%d i=%d: g %d", k, i, j[i].g_order);
            CHECK(j[i].c_order == c[i], "k=%d i=%d: c %d", k, i, j[i].c_order);
            CHECK_NEAR(j[i].max_gap, 0, 1e-10, "k=%d i=%d", k, i);
            const double slope = k > 1 ? 0 : i == 1 ? atan(0.25) : atan(0.5);
            CHECK_NEAR(j[i].max_normal_angle, slope, 1e-10, "k=%d i=%d", k, i);
            CHECK_NEAR(j[i].max_tangent_angle, slope, 1e-10, "k=%d i=%d", k, i);
            CHECK(!j[i].reversed, "k=%d i=%d", k, i);
            /* one map of the parameters: proved; point by point: compared */
            CHECK(j[i].kind == (i < 3 ? TAUT_JOIN_BOUND : TAUT_JOIN_CHECK), "k=%d i=%d", k, i);
            CHECK(i == 3 ? isnan(j[i].gap_bound)
                         : j[i].gap_bound >= j[i].max_gap && j[i].gap_bound < 1e-11,
                  "k=%d i=%d: %g", k, i, j[i].gap_bound);
            CHECK(j[i].one_surface == 0, "k=%d i=%d: %d", k, i, j[i].one_surface);
        }
        taut_surface_free(same);
        taut_surface_free(faster);
        taut_surface_free(bent);
        taut_surface_free(uneven);
    }
    taut_surface_free(plane);
}

/* A plane, then z = 1e-4 u^3 on nets of high degree, whose second derivatives could be large but
 * vanish: contact of order 2 by parameters as well as without them. */
static void test_tight(void)
{
    taut_surface *plane = strip(0, 1, 0, 0, 0, 1), *cubic = strip(1, 1, 0, 0, 1e-4, 3);
    taut_surface *raised = NULL, *high = NULL;
    CHECK(taut_surface_elevate(cubic, TAUT_ALONG_U, 6, &raised, NULL) == TAUT_OK, "u");
    CHECK(taut_surface_elevate(raised, TAUT_ALONG_V, 10, &high, NULL) == TAUT_OK, "v");
    const taut_join j = joined(plane, TAUT_EDGE_U1, high, TAUT_EDGE_U0);
    CHECK(j.c_order == 2 && j.g_order == 2, "c %d g %d", j.c_order, j.g_order);
    taut_surface_free(plane);
    taut_surface_free(cubic);
    taut_surface_free(raised);
    taut_surface_free(high);
}

/* Each way to turn the second surface: its edge that was u0 is named, and the same comes out. */
static void check_turned(const taut_surface *a, taut_edge edge, const taut_surface *b, int c, int g,
                         int one, const char *what)
{
    taut_surface *t = shape_transposed(b), *r = shape_reversed(b), *tr = shape_reversed(t);
    taut_surface *rt = shape_transposed(r), *trt = shape_transposed(tr);
    const taut_surface *turned[6] = {b, t, r, tr, rt, trt};
    const taut_edge edges[6] = {TAUT_EDGE_U0, TAUT_EDGE_V0, TAUT_EDGE_U1,
                                TAUT_EDGE_V0, TAUT_EDGE_V1, TAUT_EDGE_U0};
    const int reversed[6] = {0, 0, 0, 1, 0, 1};
    for (int i = 0; i < 6; i++) {
        const taut_join there = joined(a, edge, turned[i], edges[i]);
        const taut_join back = joined(turned[i], edges[i], a, edge);
        CHECK(there.c_order == c && there.g_order == g, "%s %d: c %d g %d", what, i, there.c_order,
              there.g_order);
        CHECK(back.c_order == c && back.g_order == g, "%s %d: back c %d g %d", what, i,
              back.c_order, back.g_order);
        CHECK(there.one_surface == one && back.one_surface == one, "%s %d: %d", what, i,
              there.one_surface);
        CHECK(there.reversed == reversed[i], "%s %d", what, i);
        CHECK_NEAR(back.max_gap, there.max_gap, 1e-13, "%s %d", what, i);
        CHECK_NEAR(back.max_normal_angle, there.max_normal_angle, 1e-12, "%s %d", what, i);
        CHECK_NEAR(back.max_tangent_angle, there.max_tangent_angle, 1e-12, "%s %d", what, i);
    }
    taut_surface_free(t);
    taut_surface_free(r);
    taut_surface_free(tr);
    taut_surface_free(rt);
    taut_surface_free(trt);
}

/* Windows of one polynomial surface, each over its own part of the parameters: C^3 and one surface,
 * also where the widths are forgotten; two windows that share only the edge are not. */
static void test_one_surface(void)
{
    taut_surface *left = shape_enneper(-0.5, 1, -1, 0.5), *right = shape_enneper(1, 1.5, -1, 0.5);
    taut_surface *other = strip(0, 1, 0, 0, 0.5, 2);
    taut_surface *unit = shape_surface(shape_bezier(3, 0, 1), shape_bezier(3, 0, 1),
                                       taut_surface_points(right), NULL);
    check_turned(left, TAUT_EDGE_U1, right, 3, 3, 1, "windows");
    check_turned(left, TAUT_EDGE_U1, unit, 0, 3, 1, "widths forgotten");
    const taut_join self = joined(left, TAUT_EDGE_U1, left, TAUT_EDGE_U1);
    CHECK(self.c_order == 0 && self.g_order == 0 && self.one_surface == 0, "folded on itself");
    CHECK_NEAR(self.max_normal_angle, TAUT_PI, 1e-14, "folded on itself");
    CHECK_NEAR(self.max_tangent_angle, TAUT_PI, 1e-14, "folded on itself");
    CHECK(joined(left, TAUT_EDGE_U1, other, TAUT_EDGE_U0).one_surface == -1, "bidegrees differ");
    taut_surface_free(left);
    taut_surface_free(right);
    taut_surface_free(other);
    taut_surface_free(unit);
}

/* [NiWang2015] section 4: P and Q continue each other to all orders. */
static void test_harmonic(void)
{
    taut_surface *a =
        shape_surface(shape_bezier(3, 0, 1), shape_bezier(3, 0, 1), niwang2015_p[0], NULL);
    taut_surface *b =
        shape_surface(shape_bezier(3, 0, 1), shape_bezier(3, 0, 1), niwang2015_q[0], NULL);
    check_turned(a, TAUT_EDGE_U1, b, 3, 3, 1, "harmonic");
    taut_surface_free(a);
    taut_surface_free(b);
}

/* Quadrics with rational weights: a sphere across its seam is one surface (G^3), though its
 * parameters are C^1 only; the half sphere below and the cylinder above share tangent planes, not
 * curvatures. */
static void test_quadrics(void)
{
    const double w = sqrt(0.5), weights[9] = {1, w, 1, w, 0.5, w, 1, w, 1};
    const double bowl[9][3] = {{1, 0, 0},  {1, 0, -1}, {0, 0, -1}, {1, 1, 0}, {1, 1, -1},
                               {0, 0, -1}, {0, 1, 0},  {0, 1, -1}, {0, 0, -1}};
    const double tube[6][3] = {{1, 0, 0}, {1, 0, 2}, {1, 1, 0}, {1, 1, 2}, {0, 1, 0}, {0, 1, 2}};
    const double tube_weights[6] = {1, 1, w, w, 1, 1};
    taut_surface *sphere = shape_sphere(1), *torus = shape_torus(3, 1);
    taut_surface *a = shape_surface(shape_bezier(2, 0, 1), shape_bezier(2, 0, 1), bowl[0], weights);
    taut_surface *b =
        shape_surface(shape_bezier(2, 0, 1), shape_bezier(1, 0, 1), tube[0], tube_weights);
    taut_join j = joined(sphere, TAUT_EDGE_U1, sphere, TAUT_EDGE_U0);
    CHECK(j.c_order == 1 && j.g_order == 3, "seam of a sphere: c %d g %d", j.c_order, j.g_order);
    j = joined(torus, TAUT_EDGE_V1, torus, TAUT_EDGE_V0);
    CHECK(j.c_order == 1 && j.g_order == 3, "seam of a torus: c %d g %d", j.c_order, j.g_order);
    CHECK(j.kind == TAUT_JOIN_BOUND && j.gap_bound < 1e-10, "a torus, weights cleared: %g",
          j.gap_bound);
    j = joined(a, TAUT_EDGE_V0, b, TAUT_EDGE_V0);
    CHECK(j.c_order == 0 && j.g_order == 1, "bowl and tube: c %d g %d", j.c_order, j.g_order);
    CHECK_NEAR(j.max_normal_angle, 0, 1e-14, "bowl and tube");
    CHECK(j.one_surface == -1, "rational");
    j = joined(sphere, TAUT_EDGE_V1, sphere, TAUT_EDGE_V1);
    CHECK(j.g_order == 0 && isnan(j.max_normal_angle), "at a pole there is no normal");
    taut_surface_free(sphere);
    taut_surface_free(torus);
    taut_surface_free(a);
    taut_surface_free(b);
}

/* Two planes at an angle: that angle, and no more than position. */
static void test_dihedral(void)
{
    for (double angle = 0.1; angle < 3; angle += 0.3) {
        const double flat[4][3] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}};
        const double c = cos(angle), s = sin(angle);
        const double up[4][3] = {{1, 0, 0}, {1, 1, 0}, {1 + c, 0.3, s}, {1 + c, 1.3, s}};
        taut_surface *a =
            shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), flat[0], NULL);
        taut_surface *b = shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), up[0], NULL);
        const taut_join j = joined(a, TAUT_EDGE_U1, b, TAUT_EDGE_U0);
        CHECK_NEAR(j.max_normal_angle, angle, 4e-15, "angle=%g", angle);
        CHECK_NEAR(j.max_tangent_angle, acos(c / sqrt(1.09)), 4e-15, "angle=%g", angle);
        CHECK(j.c_order == 0 && j.g_order == 0, "angle=%g", angle);
        taut_surface_free(a);
        taut_surface_free(b);
    }
}

/* A gap is measured, and forgiven below 1e-9 of the size; orders do not depend on where the
 * surfaces lie, nor on their size. */
static void test_gaps_and_sizes(void)
{
    taut_surface *a = shape_enneper(-0.5, 1, -1, 0.5), *b = shape_enneper(1, 1.5, -1, 0.5);
    for (int k = -150; k <= 150; k += 25) {
        for (int lift = 0; lift < 2; lift++) {
            const double size = pow(10, k), gap = (lift ? 1e-6 : 1e-11) * size;
            double rotation[3][3], shift[3], moved[3];
            shape_rotation(rotation);
            for (int c = 0; c < 3; c++) {
                shift[c] = 100 * size * (c - 1);
                moved[c] = shift[c] + gap * rotation[c][2];
            }
            taut_surface *ma = shape_moved(a, size, (const double(*)[3])rotation, shift);
            taut_surface *mb = shape_moved(b, size, (const double(*)[3])rotation, moved);
            const taut_join j = joined(ma, TAUT_EDGE_U1, mb, TAUT_EDGE_U0);
            CHECK(j.c_order == (lift ? -1 : 3) && j.g_order == (lift ? -1 : 3),
                  "size=%g lift=%d: c %d g %d", size, lift, j.c_order, j.g_order);
            /* the net is rounded at 100 sizes; where the surface leans, its nearest point is nearer
             */
            CHECK(j.max_gap <= gap + 1e-13 * size && j.max_gap > 0.3 * gap - 1e-13 * size,
                  "size=%g: %g", size, j.max_gap);
            taut_surface_free(ma);
            taut_surface_free(mb);
        }
    }
    taut_surface_free(a);
    taut_surface_free(b);
}

/* Splines: knots on one side only, at other places than the other side's, and a kink between. */
static void test_splines(void)
{
    taut_surface *a = shape_random(3, 3, 0);
    taut_surface *b = shape_transposed(a);
    const taut_join j = joined(a, TAUT_EDGE_U1, b, TAUT_EDGE_V1);
    CHECK(j.c_order == 0 && j.g_order == 0, "the same edge of the same surface");
    CHECK_NEAR(j.max_normal_angle, TAUT_PI, 1e-7, "folded");
    CHECK(!j.reversed && j.one_surface == -1, "spline");
    taut_surface_free(a);
    taut_surface_free(b);
}

static void test_names_and_record(void)
{
    taut_edge edge = TAUT_EDGE_U0;
    taut_surface *a = shape_enneper(0, 1, 0, 1), *b = shape_enneper(1, 2, 0, 1);
    taut_join j = joined(a, TAUT_EDGE_U1, b, TAUT_EDGE_U0);
    taut_record *record = taut_record_new();
    CHECK(taut_edge_of_name("v1", &edge) == TAUT_OK && edge == TAUT_EDGE_V1, "v1");
    CHECK(taut_edge_of_name("w1", &edge) == TAUT_BAD_ARGUMENT && edge == TAUT_EDGE_V1, "w1");
    CHECK(taut_edge_of_name(NULL, &edge) == TAUT_BAD_ARGUMENT, "NULL");
    CHECK(strcmp(taut_edge_name(TAUT_EDGE_V0), "v0") == 0, "name");
    CHECK(strcmp(taut_edge_name((taut_edge)4), "") == 0, "no name");
    CHECK(taut_join_measure(a, (taut_edge)7, b, TAUT_EDGE_U0, &j, NULL) == TAUT_BAD_ARGUMENT,
          "edge");
    CHECK(taut_join_measure(NULL, TAUT_EDGE_U0, b, TAUT_EDGE_U0, &j, NULL) == TAUT_BAD_ARGUMENT,
          "NULL");
    CHECK(j.c_order == 3, "untouched on failure");
    taut_join_record(&j, record);
    CHECK(taut_record_status(record) == TAUT_OK, "record");
    CHECK(taut_record_number(taut_record_get(record, "c_order")) == 3, "c_order");
    CHECK(taut_record_number(taut_record_get(record, "g_order")) == 3, "g_order");
    CHECK(taut_record_number(taut_record_get(record, "max_gap")) == j.max_gap, "max_gap");
    CHECK(taut_record_get(record, "max_tangent_angle") != NULL, "max_tangent_angle");
    CHECK(taut_record_get(record, "max_normal_angle") != NULL, "max_normal_angle");
    CHECK(strcmp(taut_record_text(taut_record_get(record, "kind")), "bound") == 0, "kind");
    CHECK(taut_record_number(taut_record_get(record, "gap_bound")) == j.gap_bound, "gap_bound");
    CHECK(taut_record_bool(taut_record_get(record, "one_surface")), "one_surface");
    taut_record_free(record);
    taut_surface_free(a);
    taut_surface_free(b);
}

/* Edges that lie beside each other all along: the bound is that distance, but for rounding. */
static void test_beside(void)
{
    const double apart = 0x1p-34;
    taut_surface *plane = strip(0, 1, 0, 0, 0, 1), *beside = strip(1 + apart, 1, 0, 0, 0, 1);
    const taut_join j = joined(plane, TAUT_EDGE_U1, beside, TAUT_EDGE_U0);
    CHECK(j.kind == TAUT_JOIN_BOUND, "kind %d", (int)j.kind);
    CHECK_NEAR(j.gap_bound, apart, 1e-11, "of a gap all along");
    CHECK(j.gap_bound >= apart, "%g below the gap", j.gap_bound);
    taut_surface_free(plane);
    taut_surface_free(beside);
}

/* Weights that fall by a factor a row: the surface cut in two, seen from either side, and folded back
 * over itself. What the weights of rows far from the edge are is nothing to the edge. */
static void test_steep_weights(void)
{
    static const double factors[] = {1e-4, 1e-3, 1e3, 1e4, 1e5};
    for (int f = 0; f < 5; f++) {
        double points[16][3], weights[16];
        for (int k = 0; k < 16; k++) {
            points[k][0] = k / 4 / 3.0;
            points[k][1] = k % 4 / 3.0;
            points[k][2] = 0.1 * (k / 4) * (k % 4);
            weights[k] = pow(factors[f], k / 4);
        }
        taut_surface *whole =
            shape_surface(shape_bezier(3, 0, 1), shape_bezier(3, 0, 1), points[0], weights);
        taut_surface *back = shape_reversed(whole);
        taut_model *pieces = NULL;
        const taut_join fold = joined(whole, TAUT_EDGE_U1, back, TAUT_EDGE_U0);
        CHECK(fold.c_order == 0 && fold.g_order == 0, "%g: c %d, g %d", factors[f], fold.c_order,
              fold.g_order);
        CHECK_NEAR(fold.max_tangent_angle, TAUT_PI, 1e-9, "%g", factors[f]);
        CHECK(taut_surface_split(whole, TAUT_ALONG_U, 0.3, &pieces, NULL) == TAUT_OK, "split");
        const taut_join cut = joined(taut_model_surface(pieces, 0), TAUT_EDGE_U1,
                                     taut_model_surface(pieces, 1), TAUT_EDGE_U0);
        CHECK(cut.c_order == 3 && cut.g_order == 3 && cut.kind == TAUT_JOIN_BOUND, "%g: c %d, g %d",
              factors[f], cut.c_order, cut.g_order);
        CHECK(cut.gap_bound < 1e-11, "%g: %g", factors[f], cut.gap_bound);
        taut_model_free(pieces);
        taut_surface_free(whole);
        taut_surface_free(back);
    }
}

int main(void)
{
    random_seed(20260304);
    test_orders();
    test_tight();
    test_one_surface();
    test_harmonic();
    test_quadrics();
    test_dihedral();
    test_gaps_and_sizes();
    test_beside();
    test_splines();
    test_steep_weights();
    test_names_and_record();
    return check_failures != 0;
}
