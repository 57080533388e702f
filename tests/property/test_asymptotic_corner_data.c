/* test_asymptotic_corner_data.c -- patches from corner data, and what must not change when the data
 * is moved, scaled, raised or mapped.
 */
#include "asymptotic.h"
#include "certificates.h"
#include "check.h"

#include <stdio.h>
#include <string.h>

/* Corner data in general position: conditions hold, the certificate too, for both patches. */
static void test_random_corner_data(void)
{
    const int trials = random_trials(12);
    int made = 0;
    for (int trial = 0; trial < trials; trial++) {
        taut_asymptotic_problem problem = asymptotic_random(trial % 12 == 7 ? 5 : 4, 0.1);
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

/* A curvature far from the others: what closes the ring bends next to nothing at that end, with a
 * weight to match, or in so short an interval that it looks like an inflection. The claims hold all
 * the same, to what the points hold. */
static void test_uneven_curvature(void)
{
    static const int exponents[4] = {-5, -3, 3, 7};
    for (int j = 0; j < 4; j++) {
        const int k = exponents[j];
        taut_asymptotic_problem problem = asymptotic_example(1, NULL);
        taut_model *model = NULL;
        char what[48];
        problem.corners.points[3][2] += 0.1;
        problem.corners.points[1][0] += 0.05;
        problem.corners.edges[TAUT_ASYMPTOTIC_U0].legs[1][1] += 0.03;
        problem.corners.edges[TAUT_ASYMPTOTIC_V0].legs[0][0] += 0.02;
        problem.corners.edges[TAUT_ASYMPTOTIC_V1].legs[0][0] -= 0.01;
        problem.corners.edges[TAUT_ASYMPTOTIC_U0].curvature[0] = pow(10, k);
        (void)snprintf(what, sizeof what, "curvature 1e%d", k);
        model = asymptotic_make(&problem, what);
        if (model != NULL) {
            taut_certificate *certificate = asymptotic_certify(model, &problem, what);
            const taut_claim *const edges = claim_of(certificate, "asymptotic");
            const taut_claim *const claim = claim_of(certificate, "boundary");
            CHECK(claim->holds == TAUT_TRUE, "%s: %g, limit %g, at %s", what, claim->residual,
                  claim->limit, claim->where);
            CHECK(edges->holds != TAUT_FALSE, "%s: %g, limit %g, at %s", what, edges->residual,
                  edges->limit, edges->where);
            taut_certificate_free(certificate);
        }
        taut_model_free(model);
    }
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
            const double *const p = problem.corners.points[j];
            const double turned[3] = {c * p[0] - d * p[1], d * p[0] + c * p[1], p[2]};
            image.corners.points[j][k] = s * turned[k] + shift[k];
        }
        for (int end = 0; end < 2; end++) {
            const double *const p = problem.corners.edges[j].legs[end];
            const double turned[3] = {c * p[0] - d * p[1], d * p[0] + c * p[1], p[2]};
            for (int k = 0; k < 3; k++) {
                image.corners.edges[j].legs[end][k] = s * turned[k];
            }
            image.corners.edges[j].curvature[end] /= s;
        }
    }
    first = asymptotic_make(&problem, "similar");
    second = asymptotic_make(&image, "similar image");
    CHECK_NEAR(detail_of(second, "curve_energy") / (s * s), detail_of(first, "curve_energy"), 1e-12,
               "A1");
    CHECK_NEAR(detail_of(second, "plate_energy") / (s * s), detail_of(first, "plate_energy"), 1e-10,
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
            problem.corners.points[j / 3][j % 3] =
                s * problem.corners.points[j / 3][j % 3] + units[k][1];
            problem.corners.edges[j / 3].legs[0][j % 3] *= s;
            problem.corners.edges[j / 3].legs[1][j % 3] *= s;
        }
        for (int j = 0; j < 8; j++) {
            problem.corners.edges[j / 2].curvature[j % 2] /= s;
        }
        (void)snprintf(what, sizeof what, "unit %g, origin %g", s, units[k][1]);
        model = asymptotic_make(&problem, what);
        CHECK_NEAR(detail_of(model, "curve_energy") / (s * s), 4.563279376292, 1e-7, "%s", what);
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
    for (int k = 0; k < 6; k++) {
        static const double scales[6] = {1e-22, 1e22, 1e-200, 1e200, 1, 1};
        static const double origin[6] = {0, 0, 0, 0, 1e12, -1e17};
        static const char *const said[3] = {"too-large", "far-away", "same-corner"};
        taut_asymptotic_problem problem = asymptotic_example(1, "-+-+");
        taut_error error = {.message = ""};
        taut_model *model = NULL;
        for (int j = 0; j < 12; j++) {
            problem.corners.points[j / 3][j % 3] =
                scales[k] * problem.corners.points[j / 3][j % 3] + origin[k];
        }
        CHECK(taut_asymptotic_make(&problem, NULL, &model, &error) ==
                      (k < 5 ? TAUT_BAD_INPUT : TAUT_NO_SOLUTION) &&
                  strcmp(error.reason, said[k < 4 ? 0 : k - 3]) == 0,
              "unit %g, origin %g: %s", scales[k], origin[k], error.message);
    }
}

/* Degrees above 5: everything that was asked for is met, on both kinds of patch, and the curves are
 * quintics raised: their sixth differences in homogeneous coordinates vanish. At degree 6 an
 * edge is straight, at 8 two are. */
static void test_degrees(void)
{
    static const char *const branches[3] = {"0+-+", "-+-+", "00-+"};
    static const int straight_count[3] = {1, 0, 2};
    static const int straight[2] = {TAUT_ASYMPTOTIC_V0, TAUT_ASYMPTOTIC_V1};
    for (int n = 6; n <= TAUT_ASYMPTOTIC_DEGREE_MAX; n++) {
        taut_asymptotic_problem problem = asymptotic_example(1, branches[n - 6]);
        taut_model *model = NULL;
        problem.corners.degree = n;
        problem.surface = n == 6 ? TAUT_BIDEGREE_5N_MINUS_7 : TAUT_BIDEGREE_N_PLUS_3;
        for (int e = 0; e < 4; e++) {
            for (int k = 0; k < 6; k++) {
                problem.corners.edges[e].legs[k / 3][k % 3] *= 4.0 / n;
            }
        }
        problem.corners.edges[TAUT_ASYMPTOTIC_U0].curvature[0] = 0.8;
        for (int k = 0; k < straight_count[n - 6]; k++) {
            taut_asymptotic_edge *const edge = &problem.corners.edges[straight[k]];
            edge->legs[0][2] = edge->legs[1][2] = 0.0;
            edge->curvature[0] = edge->curvature[1] = 0.0;
        }
        model = asymptotic_make(&problem, "degrees");
        if (model == NULL) {
            continue;
        }
        asymptotic_check_claims(model, &problem, "degrees");
        for (int c = straight_count[n - 6]; c < 4;
             c++) { /* the curved ones: v0 and v1 come first */
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
    given.given = TAUT_ASYMPTOTIC_CURVES;
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
    CHECK(detail_of(model, "plate_energy") < 104.9140, "A2 = %g", detail_of(model, "plate_energy"));
    CHECK(detail_of(model, "plate_energy") > 50, "A2 = %g", detail_of(model, "plate_energy"));
    taut_model_free(model);
}

int main(void)
{
    random_seed(2017);
    test_random_corner_data();
    test_uneven_curvature();
    test_similarity();
    test_units();
    test_degrees();
    test_given_curves();
    test_free_all();
    return check_failures != 0;
}
