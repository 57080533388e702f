/* test_axis.c -- axis, bends and frames of `pipe` against closed forms and the torsion. */
#include "check.h"

#include "construct/pipe/bend.h"
#include "construct/pipe/frame.h"
#include "core/vec3.h"
#include "numeric/bernstein.h"
#include "taut/curve.h"

#include <string.h>

static const double paper_edges[3][3] = {{0, 2, 0}, {-5, 4, 0}, {0, 0, 3}};
static const double paper_shape[3] = {3, 2, 1};

static void random_edges(double edges[3][3])
{
    for (int i = 0; i < 9; i++) {
        edges[i / 3][i % 3] = random_in(-1, 1);
    }
}

static double relative(const double a[3], const double b[3], double size)
{
    return taut_distance(a, b) / size;
}

/* The product form of P' x P'' against the two halves of P', and against the points. */
static void test_cross_product(void)
{
    for (int trial = 0; trial < 500; trial++) {
        const double shape[3] = {random_in(-3, 3), random_in(-4, 4), random_in(-3, 3)};
        double edges[3][3];
        taut_pipe_arc arc, plain;
        random_edges(edges);
        taut_pipe_arc_quasi((const double(*)[3])edges, shape, &arc);
        plain = arc;
        taut_pipe_arc_finish(&plain);
        for (int i = 0; i < 5; i++) {
            CHECK(relative(arc.cross[i], plain.cross[i], 1) < 2e-13, "trial %d, coefficient %d",
                  trial, i);
        }
        for (int i = 0; i < 4; i++) {
            CHECK(relative(arc.velocity[i], plain.velocity[i], 1) < 2e-14, "trial %d, leg %d",
                  trial, i);
        }
    }
}

/* P against the ce-bezier basis; reversal (gamma, -beta, alpha); the curvature at the ends in
 * closed form ([WangBai2018] section 2.3). */
static void test_curve(void)
{
    for (int trial = 0; trial < 300; trial++) {
        const double shape[3] = {random_in(-2.9, 1), random_in(-3, 3), random_in(-2.9, 1)};
        const double back[3] = {shape[2], -shape[1], shape[0]};
        const taut_basis_spec spec = {
            .type = "ce-bezier", .alpha = shape[0], .beta = shape[1], .gamma = shape[2]};
        double edges[3][3], reversed[3][3], points[4][3] = {{0, 0, 0}}, t = random_in(0, 1);
        double x[3], y[3], across[3];
        taut_pipe_arc arc, other;
        taut_pipe_jet jet;
        taut_basis *basis = NULL;
        taut_curve *curve = NULL;
        random_edges(edges);
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                points[i + 1][k] = points[i][k] + edges[i][k];
                reversed[2 - i][k] = -edges[i][k];
            }
        }
        taut_pipe_arc_quasi((const double(*)[3])edges, shape, &arc);
        taut_pipe_arc_quasi((const double(*)[3])reversed, back, &other);
        CHECK(taut_basis_new(&spec, 4, &basis, NULL) == TAUT_OK, "basis");
        CHECK(taut_curve_new("", basis, &points[0][0], NULL, &curve, NULL) == TAUT_OK, "curve");
        taut_curve_eval(curve, t, 0, x);
        taut_pipe_arc_point(&arc, t, y);
        CHECK(taut_distance(x, y) < 4e-15, "trial %d: %g", trial, taut_distance(x, y));
        taut_pipe_arc_point(&other, 1 - t, x);
        for (int k = 0; k < 3; k++) {
            x[k] += points[3][k];
        }
        CHECK(taut_distance(x, y) < 4e-15, "trial %d, reversed: %g", trial, taut_distance(x, y));
        taut_pipe_arc_jet(&arc, 0, &jet);
        taut_cross(edges[0], edges[1], across);
        const double closed = 2 * (3 - shape[1]) / pow(3 + shape[0], 2) * taut_norm(across) /
                              pow(taut_norm(edges[0]), 3);
        CHECK_NEAR(jet.curvature, closed, 1e-14 * (1 + closed), "trial %d", trial);
        taut_curve_free(curve);
        taut_basis_free(basis);
    }
}

static double angle(const double a[3], const double b[3])
{
    double across[3];
    taut_cross(a, b, across);
    return atan2(taut_norm(across), taut_dot(a, b));
}

/* In the legal box the axis turns no more than its polygon. */
static void test_turning(void)
{
    for (int trial = 0; trial < 200; trial++) {
        const double shape[3] = {random_in(-2.5, 1), random_in(-3, 3), random_in(-2.5, 1)};
        double edges[3][3];
        taut_pipe_arc arc;
        taut_pipe_bend bend;
        random_edges(edges);
        taut_pipe_arc_quasi((const double(*)[3])edges, shape, &arc);
        taut_pipe_bend_integrals(&arc, 64, &bend);
        const double bound = angle(edges[0], edges[1]) + angle(edges[1], edges[2]);
        CHECK(bend.turning <= bound + 1e-6, "trial %d: %g > %g", trial, bend.turning, bound);
    }
}

/* The integral of torsion along the arc, from determinants, by many midpoints. */
static double torsion_of(const taut_pipe_arc *arc, int count)
{
    double sum = 0;
    for (int i = 0; i < count; i++) {
        const double t = (i + 0.5) / count;
        double d1[3], d2[3], unused[3], third[3][3], d3[3], across[3];
        taut_bernstein_point(3, 3, &arc->velocity[0][0], t, d1, d2);
        for (int k = 0; k < 3; k++) {
            for (int c = 0; c < 3; c++) {
                third[k][c] = 3 * (arc->velocity[k + 1][c] - arc->velocity[k][c]);
            }
        }
        taut_bernstein_point(2, 3, &third[0][0], t, unused, d3);
        taut_cross(d1, d2, across);
        sum += taut_dot(across, d3) / taut_dot(across, across) * taut_norm(d1) / count;
    }
    return sum;
}

/* Double reflection from the normal at the start: with U = cos theta N + sin theta B the exact
 * frame has theta = -integral of torsion ([WangBai2018] section 4.3); the errors of its section 6,
 * order 4. */
static void test_double_reflection(void)
{
    static const double printed[4] = {1.34e-6, 8.46e-8, 5.30e-9, 3.31e-10};
    taut_pipe_arc arc;
    taut_pipe_binormal binormal;
    taut_pipe_normals first, last;
    double exact[3], theta = 0, before = 0;

    taut_pipe_arc_quasi(paper_edges, paper_shape, &arc);
    taut_pipe_binormal_of(&arc, &binormal);
    taut_pipe_frenet(&arc, &binormal, 0, &first);
    taut_pipe_frenet(&arc, &binormal, 1, &last);
    /* midpoints halved and extrapolated twice (errors of order 2 and 4): good to 1e-13 */
    const double m1 = torsion_of(&arc, 2000), m2 = torsion_of(&arc, 4000),
                 m3 = torsion_of(&arc, 8000);
    const double r1 = m2 + (m2 - m1) / 3, r2 = m3 + (m3 - m2) / 3;
    theta = -(r2 + (r2 - r1) / 15);
    CHECK_NEAR(theta, -1.5788432731822, 2e-13, "torsion");
    for (int k = 0; k < 3; k++) {
        exact[k] = cos(theta) * last.u[k] + sin(theta) * last.w[k];
    }
    for (int i = 0; i < 4; i++) {
        double u[3];
        memcpy(u, first.u, sizeof u);
        taut_pipe_carry(&arc, 0, 1, 16 << i, u);
        const double error = taut_distance(u, exact);
        CHECK_NEAR(error, printed[i], 0.005 * printed[i], "n = %d", 16 << i);
        CHECK(i == 0 || fabs(before / error - 16) < 0.4, "order: %g", before / error);
        before = error;
    }
}

/* Ten thousand reflections leave a unit normal; one within its tolerance of Frenet's turned. */
static void test_many_reflections(void)
{
    taut_pipe_arc arc;
    taut_pipe_jet jet;
    double u[3];
    taut_pipe_arc_quasi(paper_edges, paper_shape, &arc);
    taut_pipe_arc_jet(&arc, 0, &jet);
    taut_pipe_first_normal(jet.tangent, u);
    CHECK(u[0] == 1 && u[1] == 0 && u[2] == 0, "ties go to the lowest axis");
    taut_pipe_carry(&arc, 0, 1, 10000, u);
    taut_pipe_arc_jet(&arc, 1, &jet);
    CHECK_NEAR(taut_norm(u), 1, 2e-13, "length"); /* 2e4 roundings, adding as their root */
    CHECK_NEAR(taut_dot(u, jet.tangent), 0, 2e-13, "right angle");
}

/* In a plane the normal of the plane is carried unchanged; one reflection over half a turn with
 * parallel tangents is refused, and halved steps get through. */
static void test_plane_and_refusal(void)
{
    const double edges[3][3] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, shape[3] = {0, 0, 0};
    const double x0[3] = {0, 0, 0}, x1[3] = {0, 1, 0}, t0[3] = {1, 0, 0}, r0[3] = {0, 0, 1};
    const double back[3] = {1, 0, 0};
    double u[3] = {0, 0, 1}, r1[3] = {7, 7, 7};
    taut_pipe_arc arc;
    taut_pipe_arc_quasi(edges, shape, &arc);
    taut_pipe_carry(&arc, 0, 1, 40, u);
    CHECK(fabs(u[0]) < 1e-15 && fabs(u[1]) < 1e-15 && fabs(u[2] - 1) < 1e-14, "the plane's normal");
    CHECK(!taut_pipe_reflect(x0, t0, r0, x1, back, r1) && r1[0] == 7, "no second mirror");
    CHECK(!taut_pipe_reflect(x0, t0, r0, x0, t0, r1) && r1[0] == 7, "no step");
}

/* One step that ends as it began, aside of it, is taken in parts, which come to what many small
 * steps do: to the error of order 4 of some ten. Within rounding of a cusp the
 * axis stands still: the vector stays normal, at once. */
static void test_long_steps(void)
{
    const double bent[3][3] = {{1, 0, 0}, {-2, 1, 0.3}, {1, 0.02, -0.06}}, shape[3] = {0, 0, 0};
    const double cusp[3][3] = {{1, 1, 0}, {-1, 0, 0}, {1, -1, 0}};
    double one[3] = {0, 0, 1}, many[3] = {0, 0, 1}, u[3] = {0.6, 0, 0.8};
    taut_pipe_arc arc;
    taut_pipe_jet jet;
    taut_pipe_arc_quasi(bent, shape, &arc);
    taut_pipe_carry(&arc, 0, 1, 1, one);
    taut_pipe_carry(&arc, 0, 1, 1000, many);
    CHECK_NEAR(taut_norm(one), 1, 1e-14, "length");
    CHECK(taut_distance(one, many) > 1e-6 && taut_distance(one, many) < 0.05, "apart by %g",
          taut_distance(one, many));
    taut_pipe_arc_quasi(cusp, shape, &arc);
    taut_pipe_carry(&arc, 0.5 - 1e-10, 0.5 + 1e-10, 1, u);
    taut_pipe_arc_jet(&arc, 0.5 + 1e-10, &jet);
    CHECK_NEAR(taut_norm(u), 1, 1e-14, "length");
    CHECK_NEAR(taut_dot(u, jet.tangent), 0, 1e-14, "right angle");
    CHECK_NEAR(fabs(u[2]), 0.8, 1e-12, "the part normal to the plane stays");
}

/* Frenet's frame and its derivatives against differences, its limits at beta = +-3 included. */
static void test_frenet(void)
{
    for (int trial = 0; trial < 100; trial++) {
        const double shape[3] = {random_in(-2, 1),
                                 trial % 3 == 0   ? 3
                                 : trial % 3 == 1 ? -3
                                                  : 0.5,
                                 random_in(-2, 1)};
        const double t = trial % 2 == 0 ? 0 : 1, h = 1e-6;
        double edges[3][3], sides[3], across[3];
        taut_pipe_arc arc;
        taut_pipe_binormal binormal;
        taut_pipe_normals at, near;
        random_edges(edges);
        taut_cross(edges[0], edges[1], sides);
        if (fabs(taut_dot(sides, edges[2])) < 0.2) {
            continue;
        }
        taut_pipe_arc_quasi((const double(*)[3])edges, shape, &arc);
        taut_pipe_binormal_of(&arc, &binormal);
        CHECK(binormal.least > 0, "trial %d", trial);
        taut_pipe_frenet(&arc, &binormal, t, &at);
        taut_pipe_frenet(&arc, &binormal, t == 0 ? h : 1 - h, &near);
        CHECK_NEAR(taut_norm(at.u), 1, 4e-15, "trial %d", trial);
        CHECK_NEAR(taut_dot(at.u, at.w), 0, 4e-15, "trial %d", trial);
        for (int k = 0; k < 3; k++) {
            const double slope = (near.u[k] - at.u[k]) / (t == 0 ? h : -h);
            across[k] = slope - at.du[k];
        }
        CHECK(taut_norm(across) < 1e-3 * (1 + taut_dot(at.du, at.du)), "trial %d: %g", trial,
              taut_norm(across));
    }
}

static void test_cusp(void)
{
    const double edges[3][3] = {{1, 1, 0}, {-1, 0, 0}, {1, -1, 0}}, shape[3] = {0, 0, 0};
    taut_pipe_arc arc;
    taut_pipe_bend bend;
    taut_pipe_arc_quasi(edges, shape, &arc);
    taut_pipe_bend_extremes(&arc, 101, &bend);
    CHECK(taut_pipe_bend_is_cusp(&bend), "speed %g", bend.least_speed);
    CHECK_NEAR(bend.least_speed_at, 0.5, 1e-12, "where");
}

int main(void)
{
    random_seed(20261121);
    test_cross_product();
    test_curve();
    test_turning();
    test_double_reflection();
    test_many_reflections();
    test_plane_and_refusal();
    test_long_steps();
    test_frenet();
    test_cusp();
    return check_failures != 0;
}
