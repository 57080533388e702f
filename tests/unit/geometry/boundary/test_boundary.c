/* test_boundary.c -- four curves in any order and direction, on any bases: the net that they bound
 * has them as its edges. */
#include "check.h"

#include "geometry/boundary/boundary.h"
#include "taut/operations.h"
#include "taut/surface.h"

#include <stdlib.h>
#include <string.h>

static taut_curve *curve_on(const taut_basis_spec *spec, const double *points,
                            const double *weights)
{
    taut_basis *basis = NULL;
    taut_curve *curve = NULL;
    CHECK(taut_basis_new(spec, 0, &basis, NULL) == TAUT_OK, "%s", spec->type);
    CHECK(taut_curve_new("", basis, points, weights, &curve, NULL) == TAUT_OK, "curve");
    taut_basis_free(basis);
    return curve;
}

/* A Bezier curve from a to b with random inner points. */
static taut_curve *any_between(const double *a, const double *b, int degree, int rational)
{
    const taut_basis_spec spec = {.type = "bezier", .degree = degree};
    double points[32][3], weights[32];
    for (int i = 0; i <= degree; i++) {
        for (int c = 0; c < 3; c++) {
            points[i][c] = i == 0 ? a[c] : i == degree ? b[c] : random_in(-2, 2);
        }
        weights[i] = random_in(0.3, 3);
    }
    return curve_on(&spec, &points[0][0], rational ? weights : NULL);
}

static void become(taut_curve **curve, taut_curve *next, taut_status status)
{
    CHECK(status == TAUT_OK, "operation");
    taut_curve_free(*curve);
    *curve = next;
}

/* Other degree, knots, range and direction, the same points. */
static void disguise(taut_curve **curve, int keep_spans)
{
    taut_curve *next = NULL;
    for (int steps = random_int(0, 4); steps > 0; steps--) {
        const taut_basis *t = taut_curve_t(*curve);
        const double lo = taut_basis_lo(t), hi = taut_basis_hi(t);
        const int way = random_int(0, keep_spans ? 2 : 3);
        taut_status status = TAUT_OK;
        if (way == 0) {
            status = taut_curve_reverse(*curve, &next, NULL);
        } else if (way == 1) {
            status = taut_curve_elevate(*curve, random_int(0, 2), &next, NULL);
        } else if (way == 2) {
            status = taut_curve_rerange(*curve, random_in(-3, 0), random_in(0.1, 4), &next, NULL);
        } else {
            status =
                taut_curve_insert(*curve, lo + (hi - lo) * random_in(0.1, 0.9), 1, &next, NULL);
        }
        become(curve, next, status);
    }
}

static void eval_share(const taut_curve *curve, double share, double *x)
{
    const taut_basis *t = taut_curve_t(curve);
    const double lo = taut_basis_lo(t), hi = taut_basis_hi(t);
    CHECK(taut_curve_eval(curve, fmin(hi, lo + share * (hi - lo)), 0, x) == TAUT_OK, "share %g",
          share);
}

enum { CHORDS = 2000 };

/* A curve as many chords. */
typedef struct chords {
    double points[CHORDS + 1][3];
} chords;

static chords *chords_of(const taut_curve *curve)
{
    chords *made = malloc(sizeof *made);
    for (int k = 0; k <= CHORDS; k++) {
        eval_share(curve, (double)k / CHORDS, made->points[k]);
    }
    return made;
}

static double distance_to(const chords *curve, const double *p)
{
    double best = INFINITY;
    for (int k = 1; k <= CHORDS; k++) {
        const double *a = curve->points[k - 1], *b = curve->points[k];
        double length = 0, along = 0, sum = 0;
        for (int c = 0; c < 3; c++) {
            length += (b[c] - a[c]) * (b[c] - a[c]);
            along += (b[c] - a[c]) * (p[c] - a[c]);
        }
        along = length > 0 ? fmin(1, fmax(0, along / length)) : 0;
        for (int c = 0; c < 3; c++) {
            const double d = p[c] - a[c] - along * (b[c] - a[c]);
            sum += d * d;
        }
        best = fmin(best, sum);
    }
    return sqrt(best);
}

/* Point k / 10 of edge e: u0, u1, v0, v1. */
static void edge_point(const taut_surface *surface, int e, int k, double *x)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double s = k / 10.0, at = e % 2;
    const double uu = e < 2 ? at : s, vv = e < 2 ? s : at;
    const double pu = taut_basis_lo(u) + uu * (taut_basis_hi(u) - taut_basis_lo(u));
    const double pv = taut_basis_lo(v) + vv * (taut_basis_hi(v) - taut_basis_lo(v));
    CHECK(taut_surface_eval(surface, fmin(pu, taut_basis_hi(u)), fmin(pv, taut_basis_hi(v)), 0,
                            x) == TAUT_OK,
          "eval");
}

/* Every edge of a surface on the net lies on one of the curves: `close` away at most. */
static void check_edges(const taut_surface *surface, taut_curve *const curves[4], double close)
{
    int used[4] = {0, 0, 0, 0};
    chords *all[4];
    for (int c = 0; c < 4; c++) {
        all[c] = chords_of(curves[c]);
    }
    for (int e = 0; e < 4; e++) {
        double worst[4] = {0, 0, 0, 0};
        int best = 0;
        for (int k = 0; k <= 10; k++) {
            double x[3];
            edge_point(surface, e, k, x);
            for (int c = 0; c < 4; c++) {
                worst[c] = fmax(worst[c], distance_to(all[c], x));
            }
        }
        for (int c = 1; c < 4; c++) {
            best = worst[c] < worst[best] ? c : best;
        }
        CHECK(worst[best] <= close, "edge %d is %g from every curve", e, worst[best]);
        used[best]++;
    }
    for (int c = 0; c < 4; c++) {
        CHECK(used[c] == 1, "curve %d is %d edges", c, used[c]);
        free(all[c]);
    }
}

static void check_net(taut_curve *const fitted[4], taut_curve *const curves[4], double close)
{
    const taut_basis *u = taut_curve_t(fitted[TAUT_SIDE_V0]),
                     *v = taut_curve_t(fitted[TAUT_SIDE_U0]);
    const int nu = taut_basis_count(u), nv = taut_basis_count(v);
    const int is_rational = taut_boundary_is_rational(fitted);
    double *points = malloc(sizeof(double) * 3 * (size_t)(nu * nv));
    double *weights = malloc(sizeof(double) * (size_t)(nu * nv));
    unsigned char *known = malloc((size_t)(nu * nv));
    taut_surface *surface = NULL;
    CHECK(taut_basis_equal(u, taut_curve_t(fitted[TAUT_SIDE_V1])) &&
              taut_basis_equal(v, taut_curve_t(fitted[TAUT_SIDE_U1])),
          "bases");
    taut_boundary_net(fitted, points, known, is_rational ? weights : NULL);
    for (int i = 0; i < nu * nv; i++) {
        const int outside = i / nv == 0 || i / nv == nu - 1 || i % nv == 0 || i % nv == nv - 1;
        CHECK(known[i] == outside, "point %d", i);
        CHECK(!is_rational || weights[i] > 0, "weight %d", i);
    }
    CHECK(taut_surface_new("", u, v, points, is_rational ? weights : NULL, &surface, NULL) ==
              TAUT_OK,
          "surface");
    if (surface != NULL) {
        check_edges(surface, curves, close);
    }
    taut_surface_free(surface);
    free(points);
    free(weights);
    free(known);
}

static void shuffle(taut_curve *curves[4])
{
    for (int i = 3; i > 0; i--) {
        const int j = random_int(0, i);
        taut_curve *kept = curves[i];
        curves[i] = curves[j];
        curves[j] = kept;
    }
}

static const double square[4][3] = {{0, 0, 0}, {1, 0, 0.2}, {1.1, 1, 0}, {0, 0.9, 0.3}};

static void free_all(taut_curve *curves[4])
{
    for (int i = 0; i < 4; i++) {
        taut_curve_free(curves[i]);
    }
}

static void test_any_four(void)
{
    for (int trial = 0; trial < random_trials(60); trial++) {
        const int rational = trial % 3 == 0;
        const int degree[2] = {random_int(0, 6), random_int(0, 6)};
        const int halvings[2] = {random_int(0, 2), random_int(0, 1)};
        taut_curve *curves[4], *sides[4], *fitted[4];
        taut_error error = {.status = TAUT_OK};
        for (int i = 0; i < 4; i++) {
            curves[i] = any_between(square[i], square[(i + 1) % 4], random_int(1, 5), rational);
            disguise(&curves[i], rational);
        }
        shuffle(curves);
        CHECK(taut_boundary_order((const taut_curve *const *)curves, 1e-9, sides, &error) ==
                  TAUT_OK,
              "%s", error.message);
        CHECK(taut_boundary_fit(sides, degree, halvings, fitted, &error) == TAUT_OK, "%s",
              error.message);
        if (error.status == TAUT_OK) {
            CHECK(taut_basis_degree(taut_curve_t(fitted[TAUT_SIDE_V0])) >= degree[0] &&
                      taut_basis_degree(taut_curve_t(fitted[TAUT_SIDE_U0])) >= degree[1],
                  "degrees");
            check_net(fitted, curves, 2e-5); /* what 2000 chords leave */
            taut_boundary_free(fitted);
        }
        taut_boundary_free(sides);
        free_all(curves);
    }
}

/* A gap is told: how wide, between which, and half a gap within the tolerance is shared. */
static void test_gap(void)
{
    const double gaps[] = {1e-3, 1e-8};
    for (int g = 0; g < 2; g++) {
        taut_curve *curves[4], *sides[4] = {NULL, NULL, NULL, NULL};
        taut_error error = {.status = TAUT_OK};
        for (int i = 0; i < 4; i++) {
            double begin[3], end[3];
            memcpy(begin, square[i], sizeof begin);
            memcpy(end, square[(i + 1) % 4], sizeof end);
            begin[2] += i == 2 ? gaps[g] : 0;
            curves[i] = any_between(begin, end, 3, 0);
        }
        const taut_status status =
            taut_boundary_order((const taut_curve *const *)curves, 1e-6, sides, &error);
        if (g == 0) {
            CHECK(status == TAUT_NO_SOLUTION && strcmp(error.reason, "gap") == 0, "status %d, %s",
                  (int)status, error.reason);
            CHECK_NEAR(error.found, 1e-3, 1e-12, "the gap");
            CHECK(strstr(error.message, "curve 2") != NULL &&
                      strstr(error.message, "curve 3") != NULL,
                  "%s", error.message);
            CHECK(sides[0] == NULL, "sides are touched");
        } else {
            double a[3], b[3];
            CHECK(status == TAUT_OK, "%s", error.message);
            eval_share(sides[TAUT_SIDE_U1], 1, a);
            eval_share(sides[TAUT_SIDE_V1], 1, b);
            CHECK(memcmp(a, b, sizeof a) == 0, "corner");
            CHECK_NEAR(a[2], 0.5e-8, 1e-15, "the middle");
        }
        taut_boundary_free(sides);
        free_all(curves);
    }
}

/* c- and h- curves: alike they stay what they are, unlike or unclamped they are refused. */
static void test_quasi(void)
{
    static const int none[2] = {0, 0};
    for (int trial = 0; trial < 3; trial++) {
        taut_curve *curves[4], *sides[4], *fitted[4] = {NULL, NULL, NULL, NULL};
        taut_error error = {.status = TAUT_OK};
        taut_status status = TAUT_OK;
        for (int i = 0; i < 4; i++) {
            taut_basis_spec spec = {.type = "c-bezier", .alpha = trial == 1 && i == 2 ? 1.1 : 1.2};
            double points[4][3];
            if (trial == 2) {
                spec = (taut_basis_spec){.type = "h-bspline", .beta = 1, .segments = 1};
            }
            for (int k = 0; k < 4; k++) {
                for (int c = 0; c < 3; c++) {
                    points[k][c] = k == 0   ? square[i][c]
                                   : k == 3 ? square[(i + 1) % 4][c]
                                            : random_in(-1, 1);
                }
            }
            curves[i] = curve_on(&spec, &points[0][0], NULL);
        }
        status = taut_boundary_order((const taut_curve *const *)curves, 1e-9, sides, &error);
        CHECK(status == (trial == 2 ? TAUT_NO_SOLUTION : TAUT_OK), "%s", error.message);
        if (status == TAUT_OK) {
            status = taut_boundary_fit(sides, none, none, fitted, &error);
            CHECK(status == (trial == 0 ? TAUT_OK : TAUT_NO_SOLUTION), "%s", error.message);
            taut_boundary_free(sides);
        }
        if (status == TAUT_OK) {
            CHECK(strcmp(taut_basis_type(taut_curve_t(fitted[0])), "c-bezier") == 0, "type");
            check_net(fitted, curves, 2e-5);
        }
        taut_boundary_free(fitted);
        free_all(curves);
    }
}

/* Bezier sides over [0, 1] are the same curves, their end weights equal where they meet; two spans
 * are refused. */
static void test_bezier(void)
{
    for (int trial = 0; trial < 20; trial++) {
        taut_curve *curves[4], *sides[4], *made[4] = {NULL, NULL, NULL, NULL};
        taut_error error = {.status = TAUT_OK};
        const int torn = trial % 5 == 4;
        taut_status status = TAUT_OK;
        for (int i = 0; i < 4; i++) {
            curves[i] = any_between(square[i], square[(i + 1) % 4], random_int(1, 5), trial % 2);
            disguise(&curves[i], 1);
        }
        if (torn) {
            taut_curve *next = NULL;
            status = taut_curve_refine(curves[2], &next, &error);
            become(&curves[2], next, status);
        }
        shuffle(curves);
        CHECK(taut_boundary_order((const taut_curve *const *)curves, 1e-9, sides, &error) ==
                  TAUT_OK,
              "%s", error.message);
        status = taut_boundary_bezier(sides, made, &error);
        if (status == TAUT_OK) {
            status = taut_boundary_agree(made, &error);
        }
        CHECK(status == (torn ? TAUT_NO_SOLUTION : TAUT_OK), "%s", error.message);
        for (int s = 0; status == TAUT_OK && s < 4; s++) {
            const taut_basis *t = taut_curve_t(made[s]);
            chords *side = chords_of(sides[s]);
            double x[3];
            CHECK(strcmp(taut_basis_type(t), "bezier") == 0 && taut_basis_lo(t) == 0 &&
                      taut_basis_hi(t) == 1,
                  "%s over [%g, %g]", taut_basis_type(t), taut_basis_lo(t), taut_basis_hi(t));
            for (int k = 0; k <= 10; k++) {
                eval_share(made[s], k / 10.0, x);
                CHECK(distance_to(side, x) <= 2e-5, "side %d at %g", s, k / 10.0);
            }
            free(side);
        }
        for (int c = 0; status == TAUT_OK && trial % 2 == 1 && c < 4; c++) {
            static const int meet[4][4] = {{TAUT_SIDE_V0, 0, TAUT_SIDE_U0, 0},
                                           {TAUT_SIDE_V0, 1, TAUT_SIDE_U1, 0},
                                           {TAUT_SIDE_V1, 0, TAUT_SIDE_U0, 1},
                                           {TAUT_SIDE_V1, 1, TAUT_SIDE_U1, 1}};
            double w[2];
            for (int k = 0; k < 2; k++) {
                const taut_curve *side = made[meet[c][2 * k]];
                const int last = taut_basis_count(taut_curve_t(side)) - 1;
                w[k] = taut_curve_weights(side)[meet[c][2 * k + 1] ? last : 0];
            }
            CHECK_NEAR(w[0], w[1], 1e-9 * w[1], "corner %d", c);
        }
        taut_boundary_free(made);
        taut_boundary_free(sides);
        free_all(curves);
    }
}

/* Four quadratic splines of two spans each around the square, an inner knot at knots[i]; all with
 * weights that grow along the side by ratio[i], or without any. */
static void two_spans(const double knots[4], const double ratio[4], taut_curve *curves[4])
{
    for (int i = 0; i < 4; i++) {
        const double t[7] = {0, 0, 0, knots[i], 1, 1, 1};
        const taut_basis_spec spec = {.type = "bspline", .degree = 2, .knots = t, .knot_count = 7};
        double points[4][3], weights[4];
        for (int k = 0; k < 4; k++) {
            for (int c = 0; c < 3; c++) {
                points[k][c] = square[i][c] + k / 3.0 * (square[(i + 1) % 4][c] - square[i][c]);
            }
            weights[k] = ratio != NULL ? pow(ratio[i], k / 3.0) : 1;
        }
        memcpy(points[3], square[(i + 1) % 4], sizeof points[3]);
        curves[i] = curve_on(&spec, &points[0][0], ratio != NULL ? weights : NULL);
    }
}

/* Where every side has two spans no change of parameter helps weights that do not close: a rounding
 * passes, more is refused. Sides 0 and 1 lead to the corner that 3 and 2 lead to. */
static void test_weights_around(void)
{
    static const double knots[4] = {0.5, 0.5, 0.5, 0.5};
    static const double last[3] = {0.5, 0.5 * (1 + 1e-12), 0.75};
    for (int trial = 0; trial < 3; trial++) {
        const double ratio[4] = {2, last[trial], 0.25, 4};
        taut_curve *curves[4], *sides[4];
        taut_error error = {.status = TAUT_OK};
        two_spans(knots, ratio, curves);
        CHECK(taut_boundary_order((const taut_curve *const *)curves, 1e-9, sides, &error) ==
                  TAUT_OK,
              "%s", error.message);
        const taut_status status = taut_boundary_agree(sides, &error);
        CHECK(status == (trial < 2 ? TAUT_OK : TAUT_NO_SOLUTION), "trial %d: %s", trial,
              error.message);
        if (trial == 2) {
            CHECK_NEAR(fmax(error.found, 1 / error.found), 1.5, 1e-12, "%s", error.message);
            CHECK(error.limit == 1 && strcmp(error.reason, "corner-weights") == 0, "%s",
                  error.reason);
        }
        taut_boundary_free(sides);
        free_all(curves);
    }
}

/* Two knots of one side within a rounding of one knot of the other cannot be matched. */
static void test_knots_apart(void)
{
    static const int none[2] = {0, 0};
    const double near = 0.5 + 1e-13, t[8] = {0, 0, 0, 0.5, near, 1, 1, 1};
    const double knots[4] = {0.5, 0.5, 0.5, 0.5};
    const taut_basis_spec spec = {.type = "bspline", .degree = 2, .knots = t, .knot_count = 8};
    taut_curve *curves[4], *sides[4], *fitted[4] = {NULL, NULL, NULL, NULL};
    taut_error error = {.status = TAUT_OK};
    double points[5][3];
    two_spans(knots, NULL, curves);
    for (int k = 0; k < 5; k++) {
        for (int c = 0; c < 3; c++) {
            points[k][c] = square[0][c] + k / 4.0 * (square[1][c] - square[0][c]);
        }
    }
    taut_curve_free(curves[0]);
    curves[0] = curve_on(&spec, &points[0][0], NULL);
    CHECK(taut_boundary_order((const taut_curve *const *)curves, 1e-9, sides, &error) == TAUT_OK,
          "%s", error.message);
    CHECK(taut_boundary_fit(sides, none, none, fitted, &error) == TAUT_NO_SOLUTION, "fitted");
    CHECK(strcmp(error.reason, "close-knots") == 0 && fitted[0] == NULL, "%s", error.reason);
    taut_boundary_free(sides);
    free_all(curves);
}

int main(void)
{
    random_seed(20260307);
    test_any_four();
    test_gap();
    test_quasi();
    test_bezier();
    test_weights_around();
    test_knots_apart();
    return check_failures != 0;
}
