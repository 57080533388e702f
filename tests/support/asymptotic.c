#include "asymptotic.h"

#include "check.h"
#include "core/vec3.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

static const int text_order[4] = {TAUT_ASYMPTOTIC_V0, TAUT_ASYMPTOTIC_V1, TAUT_ASYMPTOTIC_U0,
                                  TAUT_ASYMPTOTIC_U1};

static const double square[4][3] = {{1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {0, 1, 0}};
/* legs of edges 1 to 4 of the source, start and end */
static const double legs_1[4][2][3] = {{{0, .2, .1}, {0, .2, -.1}},
                                       {{-.2, 0, .1}, {-.2, 0, -.1}},
                                       {{0, .2, .1}, {0, .2, -.1}},
                                       {{-.2, 0, .1}, {-.2, 0, -.1}}};
static const double legs_6[4][3] = {{0, .2, -.5}, {-.2, 0, -.5}, {0, .2, .5}, {-.2, 0, .5}};
static const double corners_6[4][3] = {{1, 0, -.5}, {1, 1, 0}, {0, 0, 0}, {0, 1, -.5}};
static const double legs_3[4][3] = {{.2, .3, 0}, {-.3, -.2, 0}, {-.2, .3, 0}, {-.3, .2, 0}};
static const double corners_3[4][3] = {{1, 0, 0}, {1, 1, 1}, {0, 0, 1}, {0, 1, 2}};

static taut_asymptotic_problem example_1(int degree)
{
    taut_asymptotic_problem problem;
    memset(&problem, 0, sizeof problem);
    problem.corners.degree = degree;
    memcpy(problem.corners.points, square, sizeof square);
    for (int e = 0; e < 4; e++) {
        memcpy(problem.corners.edges[e].legs, legs_1[e], sizeof legs_1[e]);
        for (int k = 0; k < 2; k++) {
            problem.corners.edges[e].curvature[k] = problem.corners.edges[e].weights[k] = 1.0;
        }
    }
    return problem;
}

static taut_asymptotic_problem example_3(void)
{
    const double weights[4] = {1, 2, 2, 1};
    taut_asymptotic_problem problem;
    memset(&problem, 0, sizeof problem);
    problem.corners.degree = 3;
    memcpy(problem.corners.points, corners_3, sizeof corners_3);
    for (int e = 0; e < 4; e++) {
        memcpy(problem.corners.edges[e].legs[0], legs_3[e], sizeof legs_3[e]);
        memcpy(problem.corners.edges[e].weights, weights, sizeof weights);
    }
    return problem;
}

taut_asymptotic_problem asymptotic_example(int number, const char *branch)
{
    taut_asymptotic_problem problem = number == 3 ? example_3() : example_1(number == 4 ? 5 : 4);
    for (int e = 1; e < 4 && number == 2; e += 2) { /* edges 2 and 4 the other way */
        for (int k = 0; k < 2; k++) {
            problem.corners.edges[e].legs[k][2] = -problem.corners.edges[e].legs[k][2];
        }
    }
    for (int k = 0; k < 2 && number == 5; k++) {
        problem.corners.edges[0].legs[k][2] = 0.0;
        problem.corners.edges[0].curvature[k] = 0.0;
    }
    if (number == 6) {
        memcpy(problem.corners.points, corners_6, sizeof corners_6);
        for (int e = 0; e < 4; e++) {
            memcpy(problem.corners.edges[e].legs[0], legs_6[e], sizeof legs_6[e]);
            memcpy(problem.corners.edges[e].legs[1], legs_6[e], sizeof legs_6[e]);
        }
    }
    for (int k = 0; k < 4 && branch != NULL; k++) {
        problem.corners.has_branch = 1;
        problem.corners.branch[text_order[k]] = branch[k] == '+' ? 1 : branch[k] == '-' ? -1 : 0;
    }
    return problem;
}

taut_asymptotic_problem asymptotic_random(int degree, double amount)
{
    static const int corner_of_edge[4][2] = {{0, 1}, {0, 2}, {2, 3}, {1, 3}};
    taut_asymptotic_problem problem = example_1(degree);
    double weights[4];
    for (int c = 0; c < 4; c++) {
        weights[c] = 1.0 + random_in(-amount, amount);
        for (int k = 0; k < 3; k++) {
            problem.corners.points[c][k] += random_in(-amount, amount);
        }
    }
    for (int e = 0; e < 4; e++) {
        for (int end = 0; end < 2; end++) {
            problem.corners.edges[e].curvature[end] *= 1.0 + random_in(-amount, amount);
            problem.corners.edges[e].weights[end] = weights[corner_of_edge[e][end]];
            for (int k = 0; k < 3; k++) {
                problem.corners.edges[e].legs[end][k] += 0.2 * random_in(-amount, amount);
            }
        }
    }
    return problem;
}

taut_model *asymptotic_make(const taut_asymptotic_problem *problem, const char *what)
{
    taut_model *model = NULL;
    taut_error error = {.message = ""};
    CHECK(taut_asymptotic_make(problem, NULL, &model, &error) == TAUT_OK, "%s: %s", what,
          error.message);
    return model;
}

taut_certificate *asymptotic_certify(const taut_model *model,
                                     const taut_asymptotic_problem *problem, const char *what)
{
    taut_certificate *certificate = NULL;
    taut_error error = {.message = ""};
    CHECK(taut_asymptotic_certify(model, problem, NULL, &certificate, &error) == TAUT_OK, "%s: %s",
          what, error.message);
    return certificate;
}

/* `regular` found false names a place: there the patch indeed has no normal, by differences of
 * points; a singular point is met to the root of the step. */
static void check_singular(const taut_model *model, const taut_claim *claim, const char *what)
{
    const taut_surface *patch = taut_model_surface(model, 0);
    const double h = 1e-4;
    double u = 0, v = 0, x[4][3], side[2][3], normal[3];
    CHECK(sscanf(claim->where, "u = %lf, v = %lf", &u, &v) == 2, "%s: %s", what, claim->where);
    u = fmin(fmax(u, h), 1 - h);
    v = fmin(fmax(v, h), 1 - h);
    for (int k = 0; k < 4; k++) {
        const double du = k == 0 ? -h : k == 1 ? h : 0, dv = k == 2 ? -h : k == 3 ? h : 0;
        CHECK(taut_surface_eval(patch, u + du, v + dv, 0, x[k]) == TAUT_OK, "%s", what);
    }
    taut_difference(x[1], x[0], side[0]);
    taut_difference(x[3], x[2], side[1]);
    taut_cross(side[0], side[1], normal);
    CHECK_NEAR(taut_norm(normal) / (taut_norm(side[0]) * taut_norm(side[1])), 0.0, 1e-2, "%s at %s",
               what, claim->where);
}

static void check_claims(const taut_model *model, const taut_asymptotic_problem *problem, int folds,
                         const char *what)
{
    taut_certificate *certificate = asymptotic_certify(model, problem, what);
    CHECK(taut_certificate_claim_count(certificate) == 6, "%s: six claims", what);
    for (int k = 0; k < taut_certificate_claim_count(certificate); k++) {
        const taut_claim *claim = taut_certificate_claim(certificate, k);
        if (folds && claim->holds == TAUT_FALSE && strcmp(claim->claim, "regular") == 0) {
            check_singular(model, claim, what);
            continue;
        }
        if (folds && claim->holds == TAUT_UNDECIDED && strcmp(claim->claim, "regular") == 0) {
            CHECK(strstr(claim->where, "to rounding") != NULL, "%s: %s", what, claim->where);
            continue;
        }
        if (folds && claim->holds == TAUT_UNDECIDED && strcmp(claim->claim, "osculating") == 0) {
            CHECK(strcmp(claim->where, "the rounding of the points hides it") == 0, "%s: %s", what,
                  claim->where);
            continue;
        }
        CHECK(claim->holds == TAUT_TRUE, "%s: %s %g, limit %g, at %s", what, claim->claim,
              claim->residual, claim->limit, claim->where);
    }
    taut_certificate_free(certificate);
}

void asymptotic_check_claims(const taut_model *model, const taut_asymptotic_problem *problem,
                             const char *what)
{
    check_claims(model, problem, 0, what);
}

void asymptotic_check_claims_or_fold(const taut_model *model,
                                     const taut_asymptotic_problem *problem, const char *what)
{
    check_claims(model, problem, 1, what);
}

taut_curve *asymptotic_curve(const char *name, int n, const double *points, const double *weights)
{
    const taut_basis_spec spec = {.type = "bezier", .degree = n};
    taut_basis *basis = NULL;
    taut_curve *curve = NULL;
    CHECK(taut_basis_new(&spec, 0, &basis, NULL) == TAUT_OK, "%s", name);
    CHECK(taut_curve_new(name, basis, points, weights, &curve, NULL) == TAUT_OK, "%s", name);
    taut_basis_free(basis);
    return curve;
}

void asymptotic_free_curves(taut_asymptotic_problem *problem)
{
    for (int e = 0; e < 4; e++) {
        taut_curve_free((taut_curve *)(size_t)problem->curves[e]);
        problem->curves[e] = NULL;
    }
}

static double choose(int n, int k)
{
    double value = 1.0;
    for (int i = 1; i <= k; i++) {
        value = value * (n + 1 - i) / i;
    }
    return value;
}

static void cross(const double *a, const double *b, double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static void value_of(int p, const double (*a)[3], double t, double out[3])
{
    memset(out, 0, 3 * sizeof *out);
    for (int j = 0; j <= p; j++) {
        const double b = choose(p, j) * pow(t, j) * pow(1 - t, p - j);
        for (int k = 0; k < 3; k++) {
            out[k] += b * a[j][k];
        }
    }
}

void lelieuvre_normal(const lelieuvre *net, double u, double v, double normal[3])
{
    double b[3];
    value_of(net->p, net->a, u, normal);
    value_of(net->p, net->b, v, b);
    for (int k = 0; k < 3; k++) {
        normal[k] += b[k];
    }
}

static lelieuvre draw(int p)
{
    lelieuvre net = {.p = p};
    for (int j = 0; j <= p; j++) {
        for (int k = 0; k < 3; k++) {
            net.a[j][k] = random_in(-0.5, 0.5) + (k == 2 ? 0.8 : 0.0);
            net.b[j][k] = random_in(-0.5, 0.5) + (k == 2 ? 0.8 : 0.0);
        }
        net.a[j][0] += 1.5 * j / p - 0.75; /* a runs along x, b along y: the lines cross well */
        net.b[j][1] += 1.5 * j / p - 0.75;
    }
    return net;
}

/* The derivative of a polynomial, degree p - 1. */
static void slope_of(int p, const double (*a)[3], double t, double out[3])
{
    double slope[LELIEUVRE_DEGREE][3];
    for (int j = 0; j < p; j++) {
        for (int k = 0; k < 3; k++) {
            slope[j][k] = p * (a[j + 1][k] - a[j][k]);
        }
    }
    value_of(p - 1, (const double(*)[3])slope, t, out);
}

/* R_u x R_v = (a + b) det(a + b, a', b'): is the determinant of one sign, well away from 0? */
int lelieuvre_is_regular(const lelieuvre *net)
{
    double least = INFINITY, most = -INFINITY;
    for (int k = 0; k < 21 * 21; k++) {
        const double u = k / 21 / 20.0, v = k % 21 / 20.0;
        double n[3], a[3], b[3], c[3], det = 0.0;
        lelieuvre_normal(net, u, v, n);
        slope_of(net->p, net->a, u, a);
        slope_of(net->p, net->b, v, b);
        cross(a, b, c);
        for (int d = 0; d < 3; d++) {
            det += n[d] * c[d];
        }
        least = fmin(least, det);
        most = fmax(most, det);
    }
    return least > 0.1 * most || most < 0.1 * least;
}

lelieuvre lelieuvre_random(int p)
{
    lelieuvre net = draw(p);
    while (!lelieuvre_is_regular(&net)) {
        net = draw(p);
    }
    return net;
}

enum { CURVE = 2 * LELIEUVRE_DEGREE };

/* Control points of int a x a' dt + other x a, degree 2p - 1, from the origin: the curve v = const
 * for `other` = b(v); with a and b exchanged and the sign turned, the curves u = const. */
static void line_of(int p, const double (*a)[3], const double other[3], double sign,
                    const double origin[3], double (*points)[3])
{
    const int degree = 2 * p - 2;
    double integrand[CURVE][3] = {{0}};
    for (int i = 0; i < p; i++) { /* a x a' = p (a_0 .. a_(p-1)) x (a_1 .. a_p) */
        for (int j = 0; j < p; j++) {
            double term[3];
            cross(a[i], a[j + 1], term);
            for (int k = 0; k < 3; k++) {
                integrand[i + j][k] +=
                    p * choose(p - 1, i) * choose(p - 1, j) / choose(degree, i + j) * term[k];
            }
        }
    }
    for (int i = 0; i <= degree + 1; i++) {
        double moved[3] = {0}, term[3], raised[3] = {0};
        for (int j = 0; j <= p; j++) { /* a raised to degree 2p - 1 */
            if (i - j >= 0 && i - j <= p - 1) {
                const double share = choose(p, j) * choose(p - 1, i - j) / choose(2 * p - 1, i);
                for (int k = 0; k < 3; k++) {
                    raised[k] += share * a[j][k];
                }
            }
        }
        for (int j = 0; j < i; j++) {
            for (int k = 0; k < 3; k++) {
                moved[k] += integrand[j][k] / (degree + 1);
            }
        }
        cross(other, raised, term);
        for (int k = 0; k < 3; k++) {
            points[i][k] = origin[k] + sign * (moved[k] + term[k]);
        }
    }
}

taut_asymptotic_problem lelieuvre_problem(const lelieuvre *net)
{
    const int p = net->p, n = 2 * p - 1;
    const double origin[3] = {0, 0, 0};
    taut_asymptotic_problem problem;
    double points[4][CURVE][3], shift[3];
    memset(&problem, 0, sizeof problem);
    /* v = 0: int a x a' + b_0 x a; u = 0: the same corner, so shifted by b_0 x a_0 */
    line_of(p, net->a, net->b[0], 1.0, origin, points[0]);
    /* -int b x b' + b x a = -(int b x b' + a x b) */
    line_of(p, net->b, net->a[0], -1.0, origin, points[1]);
    for (int k = 0; k < 3; k++) {
        shift[k] = points[0][0][k] - points[1][0][k];
    }
    for (int j = 0; j <= n; j++) {
        for (int k = 0; k < 3; k++) {
            points[1][j][k] += shift[k];
        }
    }
    line_of(p, net->a, net->b[p], 1.0, origin, points[2]);
    line_of(p, net->b, net->a[p], -1.0, origin, points[3]);
    for (int e = 2; e < 4; e++) { /* begin where the earlier edge ends */
        const double *const corner = points[3 - e][n];
        for (int k = 0; k < 3; k++) {
            shift[k] = corner[k] - points[e][0][k];
        }
        for (int j = 0; j <= n; j++) {
            for (int k = 0; k < 3; k++) {
                points[e][j][k] += shift[k];
            }
        }
    }
    problem.given = TAUT_ASYMPTOTIC_CURVES;
    for (int e = 0; e < 4; e++) {
        problem.curves[e] =
            asymptotic_curve(taut_asymptotic_edge_name(e), n, &points[e][0][0], NULL);
    }
    return problem;
}

taut_asymptotic_problem projective_image(const taut_asymptotic_problem *problem,
                                         const projective *map)
{
    taut_asymptotic_problem image = *problem;
    for (int e = 0; e < 4; e++) {
        const int n = taut_basis_count(taut_curve_t(problem->curves[e])) - 1;
        const double *const from = taut_curve_points(problem->curves[e]);
        const double *const weights = taut_curve_weights(problem->curves[e]);
        double points[TAUT_ASYMPTOTIC_DEGREE_MAX + 1][3], w[TAUT_ASYMPTOTIC_DEGREE_MAX + 1];
        for (int j = 0; j <= n; j++) {
            double bottom = 1.0;
            for (int k = 0; k < 3; k++) {
                bottom += map->c[k] * from[3 * j + k];
            }
            for (int k = 0; k < 3; k++) {
                points[j][k] = map->t[k];
                for (int l = 0; l < 3; l++) {
                    points[j][k] += map->a[k][l] * from[3 * j + l];
                }
                points[j][k] /= bottom;
            }
            w[j] = bottom * (weights != NULL ? weights[j] : 1.0);
        }
        image.curves[e] = asymptotic_curve(taut_asymptotic_edge_name(e), n, &points[0][0], w);
    }
    return image;
}
