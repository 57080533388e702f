/* test_asymptotic.c -- the certificate of `asymptotic`: it agrees with values where it can be
 * checked, bounds what it says it bounds, and each claim fails on a model that is wrong by ten
 * times its limit. */
#include "asymptotic.h"
#include "certificates.h"
#include "check.h"
#include "edit.h"

#include "certify/asymptotic/apart.h"
#include "certify/asymptotic/identity.h"
#include "core/memory.h"
#include "core/vec3.h"

#include <stdlib.h>
#include <string.h>

/* A random rational surface of degrees m and n, weights within a factor 4. */
static taut_surface *random_surface(int m, int n)
{
    const taut_basis_spec spec_u = {.type = "bezier", .degree = m};
    const taut_basis_spec spec_v = {.type = "bezier", .degree = n};
    double points[100][3], weights[100];
    taut_basis *u = NULL, *v = NULL;
    taut_surface *surface = NULL;
    for (int k = 0; k < (m + 1) * (n + 1); k++) {
        points[k][0] = k / (n + 1) + random_in(-0.3, 0.3);
        points[k][1] = k % (n + 1) + random_in(-0.3, 0.3);
        points[k][2] = random_in(-1, 1);
        weights[k] = random_log(0.5, 2);
    }
    CHECK(taut_basis_new(&spec_u, 0, &u, NULL) == TAUT_OK, "u");
    CHECK(taut_basis_new(&spec_v, 0, &v, NULL) == TAUT_OK, "v");
    CHECK(taut_surface_new("", u, v, &points[0][0], weights, &surface, NULL) == TAUT_OK, "surface");
    taut_basis_free(u);
    taut_basis_free(v);
    return surface;
}

/* k_n = R_tt.N / |R_t|^2 from derivatives. */
static double normal_curvature(const taut_surface *surface, int edge, double t)
{
    const double u = edge % 2 == 0 ? t : edge / 2, v = edge % 2 == 0 ? edge / 2 : t;
    double x[6][3], normal[3];
    const double *first = edge % 2 == 0 ? x[TAUT_XU] : x[TAUT_XV];
    const double *second = edge % 2 == 0 ? x[TAUT_XUU] : x[TAUT_XVV];
    CHECK(taut_surface_eval(surface, u, v, 2, &x[0][0]) == TAUT_OK, "eval");
    taut_cross(x[TAUT_XU], x[TAUT_XV], normal);
    return taut_dot(second, normal) / taut_norm(normal) / taut_dot(first, first);
}

/* k = |R_t x R_tt| / |R_t|^3. */
static double edge_curvature(const taut_surface *surface, int edge, double t)
{
    const double u = edge % 2 == 0 ? t : edge / 2, v = edge % 2 == 0 ? edge / 2 : t;
    double x[6][3], binormal[3];
    const double *first = edge % 2 == 0 ? x[TAUT_XU] : x[TAUT_XV];
    CHECK(taut_surface_eval(surface, u, v, 2, &x[0][0]) == TAUT_OK, "eval");
    taut_cross(first, edge % 2 == 0 ? x[TAUT_XUU] : x[TAUT_XVV], binormal);
    return taut_norm(binormal) / pow(taut_norm(first), 3);
}

/* On surfaces that are nowhere asymptotic: the polynomials give k_n, and the bound is one, within a
 * quarter of the largest value. */
static void test_identity(void)
{
    for (int trial = 0; trial < 40; trial++) {
        const int m = random_int(2, 8), n = random_int(2, 8), edge = trial % 4;
        taut_surface *surface = random_surface(m, n);
        taut_arena *arena = taut_arena_new();
        taut_identity identity;
        const taut_bounding bounding = {6, 10, 0.0, 0.05, INFINITY, INFINITY};
        double most = 0.0, covered = 0.0, bound = 0.0, sine = 0.0, steepest = 0.0;
        double *scratch = NULL;
        CHECK(taut_identity_fill(surface, edge, arena, &identity) == TAUT_OK, "fill");
        for (int k = 0; k <= 400; k++) {
            const double t = k / 400.0, exact = normal_curvature(surface, edge, t);
            CHECK_NEAR(fabs(taut_identity_at(&identity, t)), fabs(exact), 1e-10 * (1 + fabs(exact)),
                       "trial %d t=%g", trial, t);
            most = fmax(most, fabs(exact));
            steepest = fmax(steepest, fabs(exact) / edge_curvature(surface, edge, t));
        }
        scratch =
            taut_arena_take(arena, (size_t)taut_identity_size(&identity) * 17, sizeof(double));
        {
            taut_bounding how = bounding;
            how.target = 1.25 * most;
            how.sine = 1.25 * steepest;
            how.bent = 0.0;
            bound = taut_identity_bound(&identity, &how, scratch, &covered, &sine);
        }
        CHECK(covered == 1.0, "trial %d covers %g", trial, covered);
        CHECK(bound >= most * (1 - 1e-12), "trial %d: bound %g below %g", trial, bound, most);
        CHECK(bound <= 1.3 * most, "trial %d: bound %g far above %g", trial, bound, most);
        CHECK(sine >= steepest * (1 - 1e-12), "trial %d: sine %g below %g", trial, sine, steepest);
        CHECK(sine <= 1.3 * steepest, "trial %d: sine %g far above %g", trial, sine, steepest);
        taut_arena_free(arena);
        taut_surface_free(surface);
    }
}

/* Two rational curves: the bound of their distance is one, and near it; and of a curve and itself
 * it is 0. */
static void test_apart(void)
{
    for (int trial = 0; trial < 200; trial++) {
        const int m = random_int(1, 12), n = random_int(1, 8);
        const double amount = random_log(1e-14, 1);
        double points[2][13][3], weights[2][13], most = 0, bound = 0;
        taut_curve *curves[2];
        taut_bezier_row rows[2];
        for (int c = 0; c < 2; c++) {
            const int degree = c == 0 ? m : n;
            for (int j = 0; j <= degree; j++) { /* a line, moved */
                for (int k = 0; k < 3; k++) {
                    points[c][j][k] = (double)j / degree + amount * random_in(-1, 1);
                }
                weights[c][j] = 1 + amount * random_in(-0.3, 0.3);
            }
            curves[c] = asymptotic_curve("", degree, &points[c][0][0], weights[c]);
            rows[c] = (taut_bezier_row){degree, 1, &points[c][0][0], weights[c]};
        }
        for (int k = 0; k <= 1000; k++) {
            double x[2][3];
            CHECK(taut_curve_eval(curves[0], k / 1000.0, 0, x[0]) == TAUT_OK, "eval");
            CHECK(taut_curve_eval(curves[1], k / 1000.0, 0, x[1]) == TAUT_OK, "eval");
            most = fmax(most, taut_distance(x[0], x[1]));
        }
        bound = taut_curves_apart(&rows[0], &rows[1], most);
        CHECK(bound >= most * (1 - 1e-4) - 1e-15 && bound <= 1.3 * most + 1e-15,
              "trial %d, degrees %d %d: %g, seen %g", trial, m, n, bound, most);
        bound = taut_curves_apart(&rows[0], &rows[0], 0);
        CHECK(bound <= 1e-30, "the same: %g", bound);
        taut_curve_free(curves[0]);
        taut_curve_free(curves[1]);
    }
}

/* The model with one point or weight of its patch, and optionally of a curve, changed. */
typedef struct change {
    int i, j, coordinate; /* coordinate 3 is the weight */
    double by;            /* added to a coordinate; the weight itself */
} change;

static taut_model *changed(const taut_model *model, const change *c)
{
    const taut_surface *const patch = taut_model_surface(model, 0);
    const int nu = taut_basis_count(taut_surface_u(patch)),
              nv = taut_basis_count(taut_surface_v(patch));
    double *points = taut_alloc((size_t)nu * (size_t)nv * 3, sizeof *points);
    double *weights = taut_alloc((size_t)nu * (size_t)nv, sizeof *weights);
    const int at = c->i * nv + c->j;
    taut_surface *surface = NULL;
    taut_model *made = NULL;
    memcpy(points, taut_surface_points(patch), (size_t)nu * (size_t)nv * 3 * sizeof *points);
    memcpy(weights, taut_surface_weights(patch), (size_t)nu * (size_t)nv * sizeof *weights);
    if (c->coordinate < 3) {
        points[3 * at + c->coordinate] += c->by;
    } else {
        weights[at] = c->by;
    }
    CHECK(taut_model_new(&made) == TAUT_OK, "model");
    CHECK(taut_surface_new("patch", taut_surface_u(patch), taut_surface_v(patch), points, weights,
                           &surface, NULL) == TAUT_OK,
          "surface");
    CHECK(taut_model_add_surface(made, surface) == TAUT_OK, "add");
    for (int k = 0; k < taut_model_curve_count(model); k++) {
        taut_curve *curve = NULL;
        CHECK(taut_curve_copy(taut_model_curve(model, k), &curve) == TAUT_OK, "curve");
        CHECK(taut_model_add_curve(made, curve) == TAUT_OK, "add");
    }
    taut_free(weights);
    taut_free(points);
    return made;
}

static int holds(const taut_model *model, const taut_asymptotic_problem *problem, const char *name)
{
    taut_certificate *certificate = asymptotic_certify(model, problem, name);
    const int verdict = claim_of(certificate, name)->holds == TAUT_TRUE;
    CHECK(has_claim(certificate, name), "%s", name);
    taut_certificate_free(certificate);
    return verdict;
}

/* `regular` fails on example 3 below. Ten times the limit: in k_n a point beside the edge moved
 * along the normal moves R_v by m times as much; 1e-10 is far above what all of these need and far
 * below what shows otherwise. */
static void test_claims_fail(void)
{
    static const struct {
        const char *claim;
        change what;
    } cases[] = {
        {"boundary", {6, 0, 2, 1e-11}},        {"boundary", {0, 0, 0, 1e-11}},
        {"asymptotic", {6, 1, 2, 1e-10}},      {"asymptotic", {12, 5, 2, 1e-10}},
        {"asymptotic", {7, 12, 2, -1e-10}},    {"asymptotic", {1, 7, 2, 1e-10}},
        {"osculating", {6, 1, 2, 1e-10}},      {"osculating", {1, 7, 2, 1e-10}},
        {"positive-weights", {6, 6, 3, 1e-7}},
    };
    const taut_asymptotic_problem problem = asymptotic_example(1, "-+-+");
    taut_model *model = asymptotic_make(&problem, "example 1");
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        taut_model *wrong = changed(model, &cases[k].what);
        CHECK(holds(model, &problem, cases[k].claim), "%s holds to begin with", cases[k].claim);
        CHECK(!holds(wrong, &problem, cases[k].claim), "%s still holds, case %zu", cases[k].claim,
              k);
        taut_model_free(wrong);
    }
    taut_model_free(model);
}

/* A piece of z = xy - x^3/3 between two cubics and two of its rulings: a straight edge has neither
 * osculating plane nor torsion, and what rounding makes of them explains no error beside it. */
static void test_straight_explains_nothing(void)
{
    static const double v0[4][3] = {{0, 0, 0}, {0.4, 0, 0}, {0.8, 0.24, 0}, {1.2, 0.72, 0.288}};
    static const double v1[4][3] = {{0, 1, 0}, {0.4, 1, 0.4}, {0.8, 1.24, 0.8}, {1.2, 1.72, 1.488}};
    static const double u0[2][3] = {{0, 0, 0}, {0, 1, 0}};
    static const double u1[2][3] = {{1.2, 0.72, 0.288}, {1.2, 1.72, 1.488}};
    taut_asymptotic_problem problem;
    taut_model *model = NULL;
    memset(&problem, 0, sizeof problem);
    problem.surface = TAUT_BIDEGREE_N_PLUS_3;
    problem.given = TAUT_ASYMPTOTIC_CURVES;
    problem.curves[TAUT_ASYMPTOTIC_V0] = asymptotic_curve("v0", 3, v0[0], NULL);
    problem.curves[TAUT_ASYMPTOTIC_V1] = asymptotic_curve("v1", 3, v1[0], NULL);
    problem.curves[TAUT_ASYMPTOTIC_U0] = asymptotic_curve("u0", 1, u0[0], NULL);
    problem.curves[TAUT_ASYMPTOTIC_U1] = asymptotic_curve("u1", 1, u1[0], NULL);
    model = asymptotic_make(&problem, "ruled");
    asymptotic_check_claims(model, &problem, "ruled");
    for (int i = 1; i <= 5; i++) {
        const change what = {i, 1, 2, 1e-12};
        taut_model *wrong = changed(model, &what);
        taut_certificate *certificate = asymptotic_certify(wrong, &problem, "ruled and wrong");
        CHECK(claim_of(certificate, "asymptotic")->holds == TAUT_FALSE &&
                  claim_of(certificate, "osculating")->holds == TAUT_FALSE,
              "not false, point %d", i);
        taut_certificate_free(certificate);
        taut_model_free(wrong);
    }
    taut_model_free(model);
    asymptotic_free_curves(&problem);
}

/* Example 1 at 1e6 from the origin in every direction, where points are rounded by 1e-10: what is
 * wrong by ten thousand times that is told all the same. */
static void test_far_claims_fail(void)
{
    static const struct {
        const char *claim;
        change what;
    } cases[] = {{"boundary", {6, 0, 2, 1e-6}},
                 {"asymptotic", {6, 1, 2, 1e-6}},
                 {"asymptotic", {1, 7, 2, 1e-6}},
                 {"osculating", {12, 5, 2, 1e-6}}};
    taut_asymptotic_problem problem = asymptotic_example(1, "-+-+");
    taut_model *model = NULL;
    for (int k = 0; k < 12; k++) {
        problem.corners.points[k / 3][k % 3] += 1e6;
    }
    model = asymptotic_make(&problem, "example 1, far");
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        taut_model *wrong = changed(model, &cases[k].what);
        taut_certificate *certificate = asymptotic_certify(wrong, &problem, "far and wrong");
        CHECK(holds(model, &problem, cases[k].claim), "%s holds to begin with", cases[k].claim);
        CHECK(claim_of(certificate, cases[k].claim)->holds == TAUT_FALSE,
              "%s is not false, case %zu", cases[k].claim, k);
        taut_certificate_free(certificate);
        taut_model_free(wrong);
    }
    taut_model_free(model);
}

/* At 2e9 from the origin rounding explains more than the largest limit: that is undecided. */
static void test_very_far(void)
{
    taut_asymptotic_problem problem = asymptotic_example(1, "-+-+");
    taut_certificate *certificate = NULL;
    taut_model *model = NULL;
    const taut_claim *claim = NULL;
    for (int k = 0; k < 12; k++) {
        problem.corners.points[k / 3][k % 3] += 2e9;
    }
    model = asymptotic_make(&problem, "example 1, very far");
    certificate = asymptotic_certify(model, &problem, "very far");
    claim = claim_of(certificate, "asymptotic");
    CHECK(claim->holds == TAUT_UNDECIDED && claim->limit <= 1e-6 && claim->residual > claim->limit,
          "%d: %g, limit %g, %s", claim->holds, claim->residual, claim->limit, claim->where);
    taut_certificate_free(certificate);
    taut_model_free(model);
}

/* The curves of example 1 with points and weights given to twelve to fourteen digits only: planes
 * and torsions agree to as many, and no patch between them is better. That is undecided, and what
 * is wrong beyond it is false. */
static void test_inexact_data(void)
{
    const taut_asymptotic_problem corner = asymptotic_example(1, "-+-+");
    taut_model *source = asymptotic_make(&corner, "source");
    for (int digits = 12; digits <= 14; digits++) {
        const change far_off = {6, 1, 2, 1e3 * pow(10, -digits)};
        taut_asymptotic_problem problem;
        taut_model *model = NULL, *wrong = NULL;
        memset(&problem, 0, sizeof problem);
        problem.given = TAUT_ASYMPTOTIC_CURVES;
        for (int c = 0; c < 4; c++) {
            const taut_curve *const from = taut_model_curve(source, c);
            double points[5][3], weights[5];
            memcpy(points, taut_curve_points(from), sizeof points);
            memcpy(weights, taut_curve_weights(from), sizeof weights);
            for (int j = 1; j < 4; j++) {
                for (int d = 0; d < 3; d++) {
                    points[j][d] += pow(10, -digits) * random_in(-1, 1);
                }
                weights[j] *= 1 + pow(10, -digits) * random_in(-1, 1);
            }
            for (int e = 0; e < 4; e++) {
                if (strcmp(taut_curve_name(from), taut_asymptotic_edge_name(e)) == 0) {
                    problem.curves[e] =
                        asymptotic_curve(taut_curve_name(from), 4, &points[0][0], weights);
                }
            }
        }
        model = asymptotic_make(&problem, "inexact");
        wrong = changed(model, &far_off);
        for (int k = 0; k < 2; k++) {
            taut_certificate *certificate =
                asymptotic_certify(k == 0 ? model : wrong, &problem, "");
            for (int c = 1; c < 3; c++) { /* asymptotic, osculating */
                const taut_claim *const claim = taut_certificate_claim(certificate, c);
                CHECK(k == 0 ? claim->holds != TAUT_FALSE : claim->holds == TAUT_FALSE,
                      "%d digits, wrong %d: %s %g, limit %g, at %s", digits, k, claim->claim,
                      claim->residual, claim->limit, claim->where);
            }
            taut_certificate_free(certificate);
        }
        taut_model_free(wrong);
        taut_model_free(model);
        asymptotic_free_curves(&problem);
    }
    taut_model_free(source);
}

/* The model times 2^exponent, patch weights times 2^light, and one of its inner points moved by `by`
 * of its size of 1. */
static taut_model *at_size(const taut_model *model, int exponent, int light, double by)
{
    const change what = {1, 7, 2, by};
    taut_model *moved = changed(model, &what), *made = NULL;
    const taut_surface *const patch = taut_model_surface(moved, 0);
    const int count =
        taut_basis_count(taut_surface_u(patch)) * taut_basis_count(taut_surface_v(patch));
    double *points = taut_alloc((size_t)count, 3 * sizeof *points);
    double *weights = taut_alloc((size_t)count, sizeof *weights);
    taut_surface *surface = NULL;
    CHECK(taut_model_new(&made) == TAUT_OK, "model");
    for (int k = 0; k < 3 * count; k++) {
        points[k] = ldexp(taut_surface_points(patch)[k], exponent);
        weights[k / 3] = ldexp(taut_surface_weights(patch)[k / 3], light);
    }
    CHECK(taut_surface_new("patch", taut_surface_u(patch), taut_surface_v(patch), points, weights,
                           &surface, NULL) == TAUT_OK,
          "surface");
    CHECK(taut_model_add_surface(made, surface) == TAUT_OK, "add");
    for (int k = 0; k < taut_model_curve_count(moved); k++) {
        const taut_curve *const from = taut_model_curve(moved, k);
        const int n = taut_basis_count(taut_curve_t(from)) - 1;
        for (int j = 0; j < 3 * (n + 1); j++) {
            points[j] = ldexp(taut_curve_points(from)[j], exponent);
        }
        CHECK(taut_model_add_curve(made, asymptotic_curve(taut_curve_name(from), n, points,
                                                          taut_curve_weights(from))) == TAUT_OK,
              "add");
    }
    taut_free(points);
    taut_free(weights);
    taut_model_free(moved);
    return made;
}

/* From 1e-300 to 1e300 a model is judged as at size 1: what holds there holds, what a point beside
 * an edge moved by a thousandth makes false is false, and curvatures go with the size. */
static void test_sizes(void)
{
    static const int exponents[] = {-997, -500, -300, -150, 0, 150, 256, 299, 332, 465, 510, 997};
    const taut_asymptotic_problem problem = asymptotic_example(1, "-+-+");
    taut_model *model = asymptotic_make(&problem, "example 1");
    taut_certificate *plain[2];
    for (int wrong = 0; wrong < 2; wrong++) {
        taut_model *at_one = at_size(model, 0, 0, wrong * 1e-3);
        plain[wrong] = asymptotic_certify(at_one, NULL, "at size 1");
        taut_model_free(at_one);
    }
    for (size_t k = 0; k < 2 * sizeof exponents / sizeof *exponents; k++) {
        const int exponent = exponents[k / 2], wrong = k % 2;
        taut_model *sized = at_size(model, exponent, k % 3 == 0 ? -7 : 0, wrong * 1e-3);
        taut_certificate *certificate = asymptotic_certify(sized, NULL, "sized");
        for (int c = 0; c < taut_certificate_claim_count(certificate) - 1; c++) { /* no weights */
            const taut_claim *const claim = taut_certificate_claim(certificate, c);
            const taut_claim *const at_one = claim_of(plain[wrong], claim->claim);
            const int unit = strcmp(claim->claim, "asymptotic") == 0 ? -exponent : 0;
            if (strcmp(claim->claim, "positive-weights") == 0) {
                continue;
            }
            CHECK(claim->holds == at_one->holds, "2^%d, wrong %d: %s %d: %s", exponent, wrong,
                  claim->claim, claim->holds, claim->where);
            CHECK_NEAR(ldexp(claim->residual, -unit), at_one->residual,
                       (exponent > 990 ? 1e-3 : 1e-9) * at_one->residual, "2^%d %s", exponent,
                       claim->claim);
        }
        CHECK(claim_of(certificate, "asymptotic")->holds == (wrong ? TAUT_FALSE : TAUT_TRUE),
              "2^%d, wrong %d", exponent, wrong);
        taut_certificate_free(certificate);
        taut_model_free(sized);
    }
    taut_certificate_free(plain[0]);
    taut_certificate_free(plain[1]);
    taut_model_free(model);
}

/* The problem's data wrong, each by ten times the limit: `boundary` tells. */
static void test_boundary_reads_the_problem(void)
{
    const taut_asymptotic_problem problem = asymptotic_example(1, "-+-+");
    taut_model *model = asymptotic_make(&problem, "example 1");
    for (int k = 0; k < 5; k++) {
        taut_asymptotic_problem other = problem;
        other.corners.points[2][1] += k == 0 ? 1e-12 : 0;
        other.corners.edges[1].legs[1][2] += k == 1 ? 1e-12 : 0;
        other.corners.edges[3].curvature[0] *= k == 2 ? 1 + 1e-12 : 1;
        other.corners.edges[2].weights[1] *= k == 3 ? 1 + 1e-12 : 1;
        other.corners.edges[0].legs[0][0] += k == 4 ? 1e-12 : 0;
        CHECK(!holds(model, &other, "boundary"), "datum %d", k);
    }
    CHECK(holds(model, NULL, "boundary"), "from the model alone");
    taut_model_free(model);
}

/* Example 3: singular, and the certificate says so and where; k_n vanishes where there is a normal.
 */
static void test_singular(void)
{
    taut_asymptotic_problem problem = asymptotic_example(3, NULL);
    taut_certificate *certificate = NULL;
    const taut_claim *regular = NULL;
    taut_model *model = NULL;
    problem.report_singular = 1;
    model = asymptotic_make(&problem, "example 3");
    certificate = asymptotic_certify(model, &problem, "example 3");
    regular = claim_of(certificate, "regular");
    CHECK(regular->holds == TAUT_FALSE && regular->residual < 1e-9, "%g", regular->residual);
    CHECK(claim_of(certificate, "asymptotic")->holds == TAUT_TRUE, "regular points");
    CHECK(strstr(regular->where, "0.811599") != NULL || strstr(regular->where, "0.911183") != NULL,
          "%s", regular->where);
    for (int e = 0; e < 4; e++) {
        const double covers = taut_record_number(taut_record_get(
            taut_record_get(taut_record_get(taut_certificate_figures(certificate), "edges"),
                            taut_asymptotic_edge_name(e)),
            "bound_covers"));
        CHECK(covers > 0.5 && covers < 1.0, "edge %d covered %g", e, covers);
    }
    taut_certificate_free(certificate);
    taut_model_free(model);
}

/* Weights c^i: the same surface, but a normal M that is nothing but rounding on most of two edges.
 * What is proved of the rest is not said of all. */
static void test_covers_little(void)
{
    static edit_model edit;
    forge_pool pool = {malloc((size_t)1 << 20), (size_t)1 << 20, 0};
    taut_asymptotic_problem problem = asymptotic_example(1, NULL);
    taut_model *model = asymptotic_make(&problem, "example 1");
    for (int k = 0; k < 2 && model != NULL; k++) {
        taut_certificate *certificate = NULL;
        edit_surface *s = &edit.surface[0];
        const double c = k == 0 ? 1.5 : 1000;
        pool.used = 0;
        edit_open(model, "asymptotic", &pool, &edit);
        for (int i = 0; i < s->nu * s->nv; i++) {
            s->weights[i] *= pow(c, i / s->nv);
        }
        for (int i = 0; i < edit.curves; i++) { /* those along u */
            edit_curve *curve = &edit.curve[i];
            for (int j = 0; j < curve->n && curve->name[0] == 'v'; j++) {
                curve->weights[j] *= pow(c, j);
            }
        }
        taut_model *other = edit_close(&edit);
        certificate = asymptotic_certify(other, NULL, "weights c^i");
        const taut_verdict expected = k == 0 ? TAUT_TRUE : TAUT_UNDECIDED;
        CHECK(claim_of(certificate, "asymptotic")->holds == expected, "weights %d", k);
        CHECK(claim_of(certificate, "osculating")->holds == expected, "weights %d", k);
        taut_certificate_free(certificate);
        taut_model_free(other);
    }
    taut_model_free(model);
    free(pool.bytes);
}

/* A patch twice as large as its curves: N is still at right angles to their b, which is not that of
 * its edges. */
static void test_edges_elsewhere(void)
{
    static edit_model edit;
    forge_pool pool = {malloc((size_t)1 << 20), (size_t)1 << 20, 0};
    taut_asymptotic_problem problem = asymptotic_example(1, NULL);
    taut_model *model = asymptotic_make(&problem, "example 1"), *other = NULL;
    taut_certificate *certificate = NULL;
    edit_open(model, "asymptotic", &pool, &edit);
    for (int i = 0; i < 3 * edit.surface[0].nu * edit.surface[0].nv; i++) {
        edit.surface[0].points[i] *= 2;
    }
    other = edit_close(&edit);
    certificate = asymptotic_certify(other, NULL, "twice as large");
    CHECK(claim_of(certificate, "boundary")->holds == TAUT_FALSE, "boundary");
    CHECK(claim_of(certificate, "asymptotic")->holds == TAUT_TRUE, "of the patch alone");
    CHECK(claim_of(certificate, "osculating")->holds == TAUT_UNDECIDED, "of patch and curves");
    taut_certificate_free(certificate);
    taut_model_free(other);
    taut_model_free(model);
    free(pool.bytes);
}

/* Limits on the worked examples: none above 1e-6, none more than 100 times what is seen. */
static void test_limits(void)
{
    for (int number = 1; number <= 6; number++) {
        taut_asymptotic_problem problem = asymptotic_example(number, NULL);
        taut_certificate *certificate = NULL;
        taut_model *model = NULL;
        problem.report_singular = 1;
        model = asymptotic_make(&problem, "limits");
        certificate = asymptotic_certify(model, &problem, "limits");
        for (int k = 0; k < 3; k++) {
            const taut_claim *claim = taut_certificate_claim(certificate, k);
            CHECK(claim->limit <= 1e-6, "example %d %s", number, claim->claim);
            CHECK(claim->limit <= 100 * claim->residual, "example %d %s: %g of %g", number,
                  claim->claim, claim->residual, claim->limit);
            CHECK(claim->limit >= 2 * claim->residual, "example %d %s: %g of %g", number,
                  claim->claim, claim->residual, claim->limit);
        }
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

/* Models that are not of this construction. */
static void test_refuses(void)
{
    const taut_asymptotic_problem problem = asymptotic_example(1, "-+-+");
    taut_model *empty = NULL;
    taut_certificate *certificate = NULL;
    taut_error error;
    CHECK(taut_model_new(&empty) == TAUT_OK, "model");
    CHECK(taut_asymptotic_certify(empty, &problem, NULL, &certificate, &error) == TAUT_BAD_INPUT,
          "no patch");
    CHECK(taut_model_add_surface(empty, random_surface(5, 4)) == TAUT_OK, "add");
    CHECK(taut_asymptotic_certify(empty, &problem, NULL, &certificate, &error) == TAUT_BAD_INPUT,
          "no curves");
    CHECK(taut_asymptotic_certify(NULL, &problem, NULL, &certificate, &error) == TAUT_BAD_ARGUMENT,
          "no model");
    CHECK(certificate == NULL, "untouched");
    taut_model_free(empty);
}

int main(void)
{
    random_seed(7);
    test_identity();
    test_apart();
    test_claims_fail();
    test_straight_explains_nothing();
    test_far_claims_fail();
    test_very_far();
    test_inexact_data();
    test_boundary_reads_the_problem();
    test_sizes();
    test_singular();
    test_covers_little();
    test_edges_elsewhere();
    test_limits();
    test_refuses();
    return check_failures != 0;
}
