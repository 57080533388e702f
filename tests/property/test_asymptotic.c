/* test_asymptotic.c -- patches on the curves of surfaces that are known: nets, ruled surfaces,
 * lines.
 */
#include "asymptotic.h"
#include "check.h"

#include "core/vec3.h"

#include <stdio.h>
#include <string.h>

static void patch_normal(const taut_surface *patch, double u, double v, double normal[3])
{
    double x[3][3];
    CHECK(taut_surface_eval(patch, u, v, 1, &x[0][0]) == TAUT_OK, "u=%g v=%g", u, v);
    taut_cross(x[TAUT_XU], x[TAUT_XV], normal);
}

/* The sine between two directions. */
static double sine(const double a[3], const double b[3])
{
    double c[3];
    taut_cross(a, b, c);
    return taut_norm(c) / (taut_norm(a) * taut_norm(b));
}

/* f in r' x r'' = f N along v = 0 or 1: det(a + b, a', a''), whose zeros are the inflections. The
 * number of its sign changes at samples. */
static int inflections_of(const lelieuvre *net, int edge)
{
    int changes = 0;
    double before = 0.0;
    for (int k = 0; k <= 400; k++) {
        const double t = k / 400.0, h = 1e-3;
        double n[3], low[3], high[3], first[3], second[3], value = 0.0;
        const double u = edge % 2 == 0 ? t : edge / 2, v = edge % 2 == 0 ? edge / 2 : t;
        const double du = edge % 2 == 0 ? h : 0.0, dv = edge % 2 == 0 ? 0.0 : h;
        lelieuvre_normal(net, u, v, n);
        lelieuvre_normal(net, u - du, v - dv, low);
        lelieuvre_normal(net, u + du, v + dv, high);
        for (int d = 0; d < 3; d++) {
            first[d] = high[d] - low[d];
            second[d] = high[d] - 2 * n[d] + low[d];
        }
        value = taut_det(n, first, second);
        changes += k > 0 && value * before < 0;
        before = value;
    }
    return changes;
}

/* The patch on a net's boundary has the net's normal along it; beta keeps its sign through
 * inflections. */
static int check_net(const lelieuvre *net, const taut_asymptotic_problem *problem,
                     const projective *map, const char *what)
{
    taut_model *model = NULL;
    taut_error error = {.message = ""};
    int inflections = 0;
    const taut_status status = taut_asymptotic_make(problem, NULL, &model, &error);
    CHECK(status == TAUT_OK, "%s: %s", what, error.message);
    if (status != TAUT_OK) {
        return 0;
    }
    /* only the boundary is the net's: nets bend so much that the patch between may fold */
    asymptotic_check_claims_or_fold(model, problem, what);
    for (int e = 0; e < 4; e++) {
        const taut_record *edge = taut_record_get(
            taut_record_get(taut_model_details(model), "edges"), taut_asymptotic_edge_name(e));
        const taut_record *found = taut_record_get(edge, "inflections");
        const int expected = inflections_of(net, e);
        CHECK((int)taut_record_count(found) == expected, "%s edge %d: %d inflections of %d", what,
              e, (int)taut_record_count(found), expected);
        inflections += expected;
        for (int k = 0; k <= 20 && map == NULL; k++) {
            const double t = k / 20.0;
            const double u = e % 2 == 0 ? t : e / 2, v = e % 2 == 0 ? e / 2 : t;
            double exact[3], normal[3];
            lelieuvre_normal(net, u, v, exact);
            patch_normal(taut_model_surface(model, 0), u, v, normal);
            /* at an inflection no curve tells the plane: it is known as a limit, to the square
             * root of what the deflation leaves */
            CHECK_NEAR(sine(exact, normal), 0.0, expected > 0 ? 1e-8 : 1e-10, "%s edge %d t=%g",
                       what, e, t);
        }
    }
    taut_model_free(model);
    return inflections;
}

static projective random_map(void)
{
    projective map = {.t = {random_in(-1, 1), random_in(-1, 1), random_in(-1, 1)}};
    for (int k = 0; k < 3; k++) {
        for (int l = 0; l < 3; l++) {
            map.a[k][l] = (k == l) + random_in(-0.3, 0.3);
        }
        map.c[k] = random_in(-0.08, 0.08);
    }
    return map;
}

/* Cubic (p = 2) and quintic (p = 3) nets, polynomial and their projective images. */
static void test_nets(void)
{
    int inflections = 0;
    for (int trial = 0; trial < random_trials(12); trial++) {
        const int p = trial % 4 == 0 ? 3 : 2; /* the quintic is slow */
        const lelieuvre net = lelieuvre_random(p);
        const projective map = random_map();
        taut_asymptotic_problem problem = lelieuvre_problem(&net);
        taut_asymptotic_problem image = projective_image(&problem, &map);
        char what[64];
        (void)snprintf(what, sizeof what, "net %d, degree %d", trial, 2 * p - 1);
        inflections += check_net(&net, &problem, NULL, what);
        (void)snprintf(what, sizeof what, "image of net %d, degree %d", trial, 2 * p - 1);
        inflections += check_net(&net, &image, &map, what);
        asymptotic_free_curves(&image);
        asymptotic_free_curves(&problem);
    }
    printf("inflections met: %d\n", inflections);
}

/* Nets whose edge v = 0 hardly bends: with a quadratic, its det(a + b, a', a'') is one number,
 * which is made small. Its torsion is then known to the rounding of its points over the square of
 * its height, far worse than that of the edges it meets: the patch must not pass that on to them.
 */
static lelieuvre flat_net(double bend)
{
    lelieuvre net;
    do {
        double n[3], slope[3], second[3], across[3];
        net = lelieuvre_random(2);
        lelieuvre_normal(&net, 0.0, 0.0, n);
        for (int k = 0; k < 3; k++) {
            slope[k] = net.a[1][k] - net.a[0][k];
            second[k] = net.a[2][k] - 2 * net.a[1][k] + net.a[0][k];
        }
        taut_cross(n, slope, across);
        taut_add_scaled((bend - 1.0) * taut_dot(across, second) / taut_dot(across, across), across,
                        net.a[2]);
    } while (!lelieuvre_is_regular(&net));
    return net;
}

static void test_flat_edges(void)
{
    for (int trial = 0; trial < random_trials(12); trial++) {
        const double bend = pow(10, -3 - trial % 4); /* 1e-3 to 1e-6 */
        const lelieuvre net = flat_net(bend);
        taut_asymptotic_problem problem = lelieuvre_problem(&net);
        char what[48];
        taut_model *model = NULL;
        taut_error error = {.message = ""};
        taut_status status = TAUT_OK;
        (void)snprintf(what, sizeof what, "net %d flat to %g", trial, bend);
        problem.surface = trial % 3 == 2 ? TAUT_BIDEGREE_N_PLUS_3 : TAUT_BIDEGREE_5N_MINUS_7;
        status = taut_asymptotic_make(&problem, NULL, &model, &error);
        CHECK(status == TAUT_OK || strcmp(error.reason, "inflection") == 0 ||
                  strcmp(error.reason, "negative-weight") == 0,
              "%s: %s", what, error.message);
        if (status == TAUT_OK) {
            asymptotic_check_claims_or_fold(model, &problem, what);
        }
        taut_model_free(model);
        asymptotic_free_curves(&problem);
    }
}

/* Nets far from the origin: no claim on the edges is found false, those that rounding hides are
 * undecided; where the coordinates hold less than six digits the problem is refused. */
static void test_far_nets(void)
{
    static const double origins[3] = {1e5, -1e8, 1e12};
    const lelieuvre net = lelieuvre_random(2);
    taut_asymptotic_problem problem = lelieuvre_problem(&net);
    for (int k = 0; k < 3; k++) {
        const projective map = {.a = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                .t = {origins[k], origins[k], 0.5 * origins[k]}};
        taut_asymptotic_problem moved = projective_image(&problem, &map);
        taut_certificate *certificate = NULL;
        taut_model *model = NULL;
        taut_error error = {.message = ""};
        const taut_status status = taut_asymptotic_make(&moved, NULL, &model, &error);
        CHECK(status == (k < 2 ? TAUT_OK : TAUT_BAD_INPUT), "origin %g: %s", origins[k],
              error.message);
        CHECK(k < 2 || strcmp(error.reason, "far-away") == 0, "%s", error.message);
        if (status == TAUT_OK) {
            certificate = asymptotic_certify(model, &moved, "far");
            for (int c = 0; c < 3; c++) {
                const taut_claim *claim = taut_certificate_claim(certificate, c);
                CHECK(claim->holds == TAUT_TRUE || (k == 1 && claim->holds == TAUT_UNDECIDED),
                      "origin %g: %s %g, limit %g, at %s", origins[k], claim->claim,
                      claim->residual, claim->limit, claim->where);
            }
            taut_certificate_free(certificate);
            taut_model_free(model);
        }
        asymptotic_free_curves(&moved);
    }
    asymptotic_free_curves(&problem);
}

/* All weights of a net times one number are the same curves: the claims hold, also of numbers near
 * the ends of double. Weights that far from those at the corners are refused by name. */
static void test_weight_scales(void)
{
    const lelieuvre net = lelieuvre_random(2);
    for (int power = -300; power <= 300; power += 150) {
        taut_asymptotic_problem problem = lelieuvre_problem(&net);
        const double w = pow(10, power);
        taut_error error = {.message = ""};
        taut_model *model = NULL;
        char what[32];
        (void)snprintf(what, sizeof what, "weights 1e%d", power);
        for (int e = 0; e < 4; e++) {
            const taut_curve *const from = problem.curves[e];
            const double weights[4] = {w, w, w, w};
            problem.curves[e] =
                asymptotic_curve(taut_curve_name(from), 3, taut_curve_points(from), weights);
            taut_curve_free((taut_curve *)(size_t)from);
        }
        model = asymptotic_make(&problem, what);
        if (model != NULL) {
            asymptotic_check_claims_or_fold(model, &problem, what);
        }
        taut_model_free(model);
        model = NULL;
        if (power != 0) {
            const taut_curve *const from = problem.curves[0];
            const double weights[4] = {w, 1, 1, w};
            problem.curves[0] = asymptotic_curve("v0", 3, taut_curve_points(from), weights);
            taut_curve_free((taut_curve *)(size_t)from);
            CHECK(taut_asymptotic_make(&problem, NULL, &model, &error) == TAUT_BAD_INPUT &&
                      strcmp(error.reason, "value") == 0,
                  "%s: %s", what, error.message);
        }
        asymptotic_free_curves(&problem);
    }
}

/* z = xy - x^3/3: the curves y = x^2/2 + c are asymptotic cubics, the lines x = const its rulings.
 * Both patches lie with the surface's tangent planes on the boundary. */
static void test_ruled(void)
{
    for (int low = 0; low < 2; low++) {
        taut_asymptotic_problem problem;
        taut_model *model = NULL;
        const double x0 = 0.2, x1 = 1.1;
        memset(&problem, 0, sizeof problem);
        problem.given = TAUT_ASYMPTOTIC_CURVES;
        problem.surface = low ? TAUT_BIDEGREE_N_PLUS_3 : TAUT_BIDEGREE_5N_MINUS_7;
        for (int side = 0; side < 2; side++) {
            const double c = side, x = side == 0 ? x0 : x1, h = (x1 - x0) / 3;
            /* blossoms of (x, x^2/2 + c, x^3/6 + c x) at x0 .. x1 */
            double cubic[4][3], line[2][3];
            for (int j = 0; j < 4; j++) {
                double at[3];
                for (int k = 0; k < 3; k++) {
                    at[k] = k < 3 - j ? x0 : x1;
                }
                cubic[j][0] = x0 + j * h;
                cubic[j][1] = (at[0] * at[1] + at[1] * at[2] + at[2] * at[0]) / 6 + c;
                cubic[j][2] = at[0] * at[1] * at[2] / 6 + c * cubic[j][0];
            }
            for (int j = 0; j < 2; j++) {
                line[j][0] = x;
                line[j][1] = x * x / 2 + j;
                line[j][2] = x * x * x / 6 + j * x;
            }
            problem.curves[2 * side] =
                asymptotic_curve(side == 0 ? "v0" : "v1", 3, &cubic[0][0], NULL);
            problem.curves[2 * side + 1] =
                asymptotic_curve(side == 0 ? "u0" : "u1", 1, &line[0][0], NULL);
        }
        model = asymptotic_make(&problem, "ruled");
        if (model != NULL) {
            asymptotic_check_claims(model, &problem, low ? "ruled, n+3" : "ruled, 5n-7");
            for (int k = 0; k <= 40; k++) {
                const double t = k % 21 / 20.0, v = k / 21, x = x0 + t * (x1 - x0);
                const double y = x * x / 2 + v;
                const double exact[3] = {-(y - x * x), -x, 1};
                double normal[3];
                patch_normal(taut_model_surface(model, 0), t, v, normal);
                CHECK_NEAR(sine(exact, normal), 0.0, 1e-12, "low %d t=%g v=%g", low, t, v);
            }
        }
        taut_model_free(model);
        asymptotic_free_curves(&problem);
    }
}

/* Four straight lines: the bilinear patch is what of least energy they bound, and it comes out. */
static void test_four_lines(void)
{
    static const double corners[4][3] = {{0, 0, 0}, {2, 0, 1}, {0, 1.5, 1}, {2, 1.5, -0.5}};
    static const int ends[4][2] = {{0, 1}, {0, 2}, {2, 3}, {1, 3}};
    taut_asymptotic_problem problem;
    taut_model *model = NULL;
    memset(&problem, 0, sizeof problem);
    problem.given = TAUT_ASYMPTOTIC_CURVES;
    for (int e = 0; e < 4; e++) {
        double line[2][3];
        memcpy(line[0], corners[ends[e][0]], sizeof line[0]);
        memcpy(line[1], corners[ends[e][1]], sizeof line[1]);
        problem.curves[e] = asymptotic_curve(taut_asymptotic_edge_name(e), 1, &line[0][0], NULL);
    }
    model = asymptotic_make(&problem, "four lines");
    if (model != NULL) {
        asymptotic_check_claims(model, &problem, "four lines");
        for (int trial = 0; trial < 50; trial++) {
            const double u = random_in(0, 1), v = random_in(0, 1);
            double x[3];
            CHECK(taut_surface_eval(taut_model_surface(model, 0), u, v, 0, x) == TAUT_OK, "eval");
            for (int k = 0; k < 3; k++) {
                const double exact = (1 - u) * (1 - v) * corners[0][k] +
                                     u * (1 - v) * corners[1][k] + (1 - u) * v * corners[2][k] +
                                     u * v * corners[3][k];
                CHECK_NEAR(x[k], exact, 1e-13, "u=%g v=%g", u, v);
            }
        }
    }
    taut_model_free(model);
    asymptotic_free_curves(&problem);
}

int main(void)
{
    random_seed(2017);
    test_nets();
    test_flat_edges();
    test_far_nets();
    test_weight_scales();
    test_ruled();
    test_four_lines();
    return check_failures != 0;
}
