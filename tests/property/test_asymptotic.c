/* test_asymptotic.c -- patches on quadrilaterals whose surfaces are known, and what must not change
 * when the data is moved, scaled, raised or mapped.
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
        const int p = trial % 3 == 0 ? 3 : 2; /* the quintic is slow */
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

/* z = xy - x^3/3: the curves y = x^2/2 + c are asymptotic cubics, the lines x = const its rulings.
 * Both patches lie with the surface's tangent planes on the boundary. */
static void test_ruled(void)
{
    for (int low = 0; low < 2; low++) {
        taut_asymptotic_problem problem;
        taut_model *model = NULL;
        const double x0 = 0.2, x1 = 1.1;
        memset(&problem, 0, sizeof problem);
        problem.surface = low ? TAUT_ASYMPTOTIC_N_3 : TAUT_ASYMPTOTIC_5N_7;
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

static double detail(const taut_model *model, const char *name)
{
    return taut_record_number(taut_record_get(taut_model_details(model), name));
}

/* Corner data in general position: conditions hold, the certificate too, for both patches. */
static void test_random_corner_data(void)
{
    const int trials = random_trials(16);
    int made = 0;
    for (int trial = 0; trial < trials; trial++) {
        taut_asymptotic_problem problem = asymptotic_random(trial % 8 == 7 ? 5 : 4, 0.1);
        taut_model *model = NULL;
        taut_error error;
        const taut_status status = taut_asymptotic_make(&problem, NULL, &model, &error);
        char what[64];
        (void)snprintf(what, sizeof what, "trial %d", trial);
        /* data without a solution, and an energy without a minimum, are to be expected */
        CHECK(status == TAUT_OK || status == TAUT_NOT_CONVERGED || status == TAUT_NO_SOLUTION,
              "%s: %s", what, error.message);
        if (status == TAUT_OK) {
            taut_certificate *certificate = asymptotic_certify(model, &problem, what);
            for (int k = 0; k < 5; k++) {
                const taut_claim *claim = taut_certificate_claim(certificate, k);
                /* the inside may fold: that is what the claim is there to tell */
                CHECK(claim->holds == TAUT_TRUE || strcmp(claim->claim, "regular") == 0,
                      "%s: %s %g, limit %g, at %s", what, claim->claim, claim->residual,
                      claim->limit, claim->where);
            }
            taut_certificate_free(certificate);
            taut_model_free(model);
            made++;
        }
    }
    CHECK(8 * made >= 5 * trials, "made %d of %d", made, trials);
}

/* x -> s Q x + t with curvatures over s: the same weights, s^2 times the energies, the image of
 * every point. */
static void test_similarity(void)
{
    const double s = 2.75, c = 0.6, d = 0.8, shift[3] = {3, -1, 2};
    taut_asymptotic_problem problem = asymptotic_example(1, "-+-+"), image = problem;
    taut_model *first = NULL, *second = NULL;
    for (int j = 0; j < 4; j++) {
        for (int k = 0; k < 3; k++) { /* a turn about z */
            const double *const p = problem.corners[j];
            const double turned[3] = {c * p[0] - d * p[1], d * p[0] + c * p[1], p[2]};
            image.corners[j][k] = s * turned[k] + shift[k];
        }
        for (int end = 0; end < 2; end++) {
            const double *const p = problem.edges[j].legs[end];
            const double turned[3] = {c * p[0] - d * p[1], d * p[0] + c * p[1], p[2]};
            for (int k = 0; k < 3; k++) {
                image.edges[j].legs[end][k] = s * turned[k];
            }
            image.edges[j].curvature[end] /= s;
        }
    }
    first = asymptotic_make(&problem, "similar");
    second = asymptotic_make(&image, "similar image");
    CHECK_NEAR(detail(second, "curve_energy") / (s * s), detail(first, "curve_energy"), 1e-12,
               "A1");
    CHECK_NEAR(detail(second, "plate_energy") / (s * s), detail(first, "plate_energy"), 1e-10,
               "A2");
    for (int trial = 0; trial < random_trials(30); trial++) {
        const double u = random_in(0, 1), v = random_in(0, 1);
        double p[3], q[3];
        CHECK(taut_surface_eval(taut_model_surface(first, 0), u, v, 0, p) == TAUT_OK, "eval");
        CHECK(taut_surface_eval(taut_model_surface(second, 0), u, v, 0, q) == TAUT_OK, "eval");
        CHECK_NEAR(q[0], s * (c * p[0] - d * p[1]) + shift[0], 1e-10, "u=%g v=%g", u, v);
        CHECK_NEAR(q[1], s * (d * p[0] + c * p[1]) + shift[1], 1e-10, "u=%g v=%g", u, v);
        CHECK_NEAR(q[2], s * p[2] + shift[2], 1e-10, "u=%g v=%g", u, v);
    }
    taut_model_free(second);
    taut_model_free(first);
}

/* Other units of length, and an origin 1e8 away: the same energies, and a patch whose claims hold
 * or, where the rounding of its points hides them, are undecided. Units no double can work with are
 * refused by name. */
static void test_units(void)
{
    static const double units[6][2] = {{1e-9, 0}, {1e9, 0}, {1e-19, 0},
                                       {1e19, 0}, {1, 1e8}, {1, -1e4}};
    for (int k = 0; k < 6; k++) {
        const double s = units[k][0];
        taut_asymptotic_problem problem = asymptotic_example(1, "-+-+");
        taut_certificate *certificate = NULL;
        taut_model *model = NULL;
        char what[48];
        for (int j = 0; j < 12; j++) {
            problem.corners[j / 3][j % 3] = s * problem.corners[j / 3][j % 3] + units[k][1];
            problem.edges[j / 3].legs[0][j % 3] *= s;
            problem.edges[j / 3].legs[1][j % 3] *= s;
        }
        for (int j = 0; j < 8; j++) {
            problem.edges[j / 2].curvature[j % 2] /= s;
        }
        (void)snprintf(what, sizeof what, "unit %g, origin %g", s, units[k][1]);
        model = asymptotic_make(&problem, what);
        CHECK_NEAR(detail(model, "curve_energy") / (s * s), 4.563279376292, 1e-7, "%s", what);
        CHECK(taut_asymptotic_certify(model, &problem, NULL, &certificate, NULL) == TAUT_OK, "%s",
              what);
        for (int c = 0; c < taut_certificate_claim_count(certificate); c++) {
            const taut_claim *const claim = taut_certificate_claim(certificate, c);
            CHECK(claim->holds == TAUT_TRUE ||
                      (units[k][1] == 1e8 && claim->holds == TAUT_UNDECIDED),
                  "%s: %s %g, limit %g, at %s", what, claim->claim, claim->residual, claim->limit,
                  claim->where);
        }
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
    for (int k = 0; k < 4; k++) {
        const double s = k == 0 ? 1e-22 : k == 1 ? 1e22 : k == 2 ? 1e-200 : 1e200;
        taut_asymptotic_problem problem = asymptotic_example(1, "-+-+");
        taut_error error = {.message = ""};
        taut_model *model = NULL;
        for (int j = 0; j < 12; j++) {
            problem.corners[j / 3][j % 3] *= s;
        }
        CHECK(taut_asymptotic_make(&problem, NULL, &model, &error) == TAUT_BAD_INPUT &&
                  strstr(error.message, "another unit of length") != NULL,
              "unit %g: %s", s, error.message);
    }
}

/* Degrees above 5: everything that was asked for is met, on both kinds of patch, and the curves are
 * quintics raised: their sixth differences in homogeneous coordinates vanish. */
static void test_degrees(void)
{
    for (int n = 6; n <= TAUT_ASYMPTOTIC_DEGREE_MAX; n++) {
        taut_asymptotic_problem problem = asymptotic_example(1, "-+-+");
        taut_model *model = NULL;
        problem.degree = n;
        problem.surface = n == 6 ? TAUT_ASYMPTOTIC_5N_7 : TAUT_ASYMPTOTIC_N_3;
        for (int e = 0; e < 4; e++) {
            for (int k = 0; k < 6; k++) {
                problem.edges[e].legs[k / 3][k % 3] *= 4.0 / n;
            }
        }
        problem.edges[1].curvature[0] = 0.8;
        model = asymptotic_make(&problem, "degrees");
        if (model == NULL) {
            continue;
        }
        asymptotic_check_claims(model, &problem, "degrees");
        for (int c = 0; c < 4; c++) {
            const double *const w = taut_curve_weights(taut_model_curve(model, c));
            double difference = 0.0, size = 0.0, sign = 1.0, binomial = 1.0;
            for (int j = 0; j <= 6; j++) {
                difference += sign * binomial * w[j];
                size += binomial * w[j];
                sign = -sign;
                binomial = binomial * (6 - j) / (j + 1);
            }
            CHECK_NEAR(difference, 0.0, 1e-14 * size, "degree %d curve %d", n, c);
        }
        taut_model_free(model);
    }
}

/* The curves of a model, given, make the same patch; raised by a degree they keep beta. */
static void test_given_curves(void)
{
    taut_asymptotic_problem corner = asymptotic_example(1, "-+-+"), given;
    taut_model *first = asymptotic_make(&corner, "corner data"), *second = NULL;
    memset(&given, 0, sizeof given);
    for (int k = 0; k < 4; k++) {
        const taut_curve *curve = taut_model_curve(first, k);
        for (int e = 0; e < 4; e++) {
            if (strcmp(taut_curve_name(curve), taut_asymptotic_edge_name(e)) == 0) {
                given.curves[e] = curve;
            }
        }
    }
    second = asymptotic_make(&given, "given curves");
    for (int i = 0; second != NULL && i < 3 * 14 * 14; i++) {
        CHECK_NEAR(taut_surface_points(taut_model_surface(second, 0))[i],
                   taut_surface_points(taut_model_surface(first, 0))[i], 1e-9, "entry %d", i);
    }
    asymptotic_check_claims(second, &given, "given curves");
    taut_model_free(second);
    taut_model_free(first);
}

/* With the alpha free as well, A_2 falls and all claims still hold; for example 1 in, a cubic's
 * alpha gives 104.9140 (docs page, errata), so the least is no higher. */
static void test_free_all(void)
{
    taut_asymptotic_problem problem = asymptotic_example(1, "+-+-");
    taut_model *model = NULL;
    problem.free_all = 1;
    model = asymptotic_make(&problem, "free");
    asymptotic_check_claims(model, &problem, "free");
    CHECK(detail(model, "plate_energy") < 104.9140, "A2 = %g", detail(model, "plate_energy"));
    CHECK(detail(model, "plate_energy") > 50, "A2 = %g", detail(model, "plate_energy"));
    taut_model_free(model);
}

int main(void)
{
    random_seed(2017);
    test_nets();
    test_ruled();
    test_four_lines();
    test_random_corner_data();
    test_similarity();
    test_units();
    test_degrees();
    test_given_curves();
    test_free_all();
    return check_failures != 0;
}
