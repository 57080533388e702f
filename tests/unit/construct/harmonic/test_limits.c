/* test_limits.c -- harmonic surfaces at the edges of what is legal: far from the origin,
 * one point, collapsed rows, planes, degree 1; and the refusals, each of its own kind.
 *
 * needs: exact
 */
#include "bezier_net.h"
#include "certificates.h"
#include "check.h"
#include "shapes.h"

#include "problem/problem.h"
#include "taut/harmonic.h"

#include <string.h>

static taut_harmonic_problem start(bezier_net *g, int n, int m)
{
    static const double u[2] = {0, 1}, v[2] = {0, 2};
    taut_harmonic_problem problem;
    memset(&problem, 0, sizeof problem);
    bezier_net_start(g, n, m, u, v);
    bezier_net_know(g, BEZIER_NET_ROWS);
    problem.u = g->u;
    problem.v = g->v;
    problem.rows.points = g->points;
    problem.rows.known = g->known;
    return problem;
}

static void check_proof(const taut_model *model, int construct, const void *data, const char *what)
{
    taut_certificate *certificate = certificate_of(model, construct, data);
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *c = taut_certificate_claim(certificate, i);
        CHECK(c->residual >= 0 && c->holds != TAUT_FALSE, "%s: %s %g, limit %g, %s", what, c->claim,
              c->residual, c->limit, c->where);
    }
    taut_certificate_free(certificate);
}

static const char *const kinds[] = {
    "far away", "one point", "collapsed rows", "one row a point", "a plane",
    "a line",   "tiny",      "huge",           "next to overflow"};

static void place(bezier_net *g, int kind)
{
    for (int k = 0; k < 3 * (g->n + 1) * (g->m + 1); k++) {
        const int row = k / 3 / (g->m + 1), c = k % 3;
        double x = random_in(-1, 1);
        x = kind == 0 ? 1e8 + x : x;
        x = kind == 1 ? 1e8 + c : x;
        x = kind == 2 ? (row == 0 ? 1 : 3) + c : x;
        x = kind == 3 && row == 0 ? c : x;
        x = (kind == 4 && c == 2) || (kind == 5 && c > 0) ? 0 : x;
        g->points[k] = kind == 6 ? 1e-280 * x : kind == 7 ? 1e280 * x : kind == 8 ? 3e307 * x : x;
    }
}

/* Every kind, degrees 1 and up, with and without the unconstrained bidegree; then the extension. */
static void test_degenerate(void)
{
    static bezier_net g;
    for (int kind = 0; kind < 9; kind++) {
        for (int m = 1; m <= (kind == 8 ? 3 : 7); m++) {
            taut_harmonic_problem problem = start(&g, m % 2 != 0 ? m : m + 1, m);
            taut_harmonic_extension_problem extension;
            taut_model *model = NULL, *pair = NULL;
            taut_error error = {.status = TAUT_OK};
            place(&g, kind);
            CHECK(taut_harmonic_make(&problem, NULL, &model, &error) == TAUT_OK, "%s m=%d: %s",
                  kinds[kind], m, error.message);
            const double *points = taut_surface_points(taut_model_surface(model, 0));
            for (int k = 0; k < (g.n + 1) * (m + 1); k++) {
                CHECK(!g.known[k] || memcmp(points + 3 * k, g.points + 3 * k, 24) == 0,
                      "%s m=%d: a given point moved", kinds[kind], m);
                CHECK(kind != 4 || points[3 * k + 2] == 0, "%s m=%d: left it", kinds[kind], m);
            }
            check_proof(model, TAUT_CONSTRUCT_INDEX_harmonic, &problem, kinds[kind]);
            memset(&extension, 0, sizeof extension);
            extension.surface = taut_model_surface(model, 0);
            extension.edge = (taut_edge)(m % 4);
            CHECK(kind >= 7 ||
                      taut_harmonic_extension_make(&extension, NULL, &pair, &error) == TAUT_OK,
                  "%s m=%d: %s", kinds[kind], m, error.message);
            if (pair != NULL) {
                check_proof(pair, TAUT_CONSTRUCT_INDEX_harmonic_extension, &extension, kinds[kind]);
            }
            taut_model_free(pair);
            taut_model_free(model);
            bezier_net_end(&g);
        }
    }
}

/* Rows of even degree that agree, far from the origin: not refused for their rounding. */
static void test_even_far(void)
{
    static bezier_net g;
    for (int m = 2; m <= 8; m += 2) {
        taut_harmonic_problem problem = start(&g, m, m);
        taut_model *model = NULL;
        taut_error error = {.status = TAUT_OK};
        place(&g, 0);
        g.known[(m + 1) * (m + 1) - 1] = 0;
        CHECK(taut_harmonic_make(&problem, NULL, &model, NULL) == TAUT_OK, "m=%d", m);
        memcpy(g.points, taut_surface_points(taut_model_surface(model, 0)),
               3 * (size_t)((m + 1) * (m + 1)) * sizeof(double));
        g.known[(m + 1) * (m + 1) - 1] = 1;
        taut_model_free(model);
        model = NULL;
        CHECK(taut_harmonic_make(&problem, NULL, &model, &error) == TAUT_OK, "m=%d: %s", m,
              error.message);
        taut_model_free(model);
        bezier_net_end(&g);
    }
}

static void refused(taut_status found, taut_status wanted, const taut_error *error,
                    const char *reason)
{
    CHECK(found == wanted && strcmp(error->reason, reason) == 0, "status %d, %s, '%s', expected %s",
          (int)found, error->reason, error->message, reason);
}

/* The kinds of [NiWang2015] section 3: bad shape, number, degree, inconsistent boundary,
 * inconsistent derivative, not harmonic, bad parameter. (Not the same surface is a verdict of
 * join.) */
static void test_refusals(void)
{
    static bezier_net g;
    taut_model *model = NULL;
    taut_surface *random = NULL;
    taut_error error;
    taut_harmonic_problem problem = start(&g, 4, 4);
    taut_harmonic_extension_problem extension;

    place(&g, 2);
    g.points[4] = 9;
    refused(taut_harmonic_make(&problem, NULL, &model, &error), TAUT_NO_SOLUTION, &error,
            "inconsistent");
    taut_harmonic_problem derivative = {.u = problem.u,
                                        .v = problem.v,
                                        .given = TAUT_HARMONIC_DERIVATIVE,
                                        .derivative = {.edge = g.points, .cross = g.points}};
    refused(taut_harmonic_make(&derivative, NULL, &model, &error), TAUT_NO_SOLUTION, &error,
            "inconsistent");
    CHECK(strcmp(error.where, "/cross_derivative") == 0, "%s", error.where);
    g.known[7] = 1;
    refused(taut_harmonic_make(&problem, NULL, &model, &error), TAUT_BAD_INPUT, &error, "mask");
    bezier_net_end(&g);
    problem = start(&g, 1, 3);
    refused(taut_harmonic_make(&problem, NULL, &model, &error), TAUT_NO_SOLUTION, &error, "degree");
    bezier_net_end(&g);
    problem = start(&g, 3, 3);
    g.points[1] = NAN;
    refused(taut_harmonic_make(&problem, NULL, &model, &error), TAUT_NO_SOLUTION, &error,
            "overflow");
    random = shape_saddle(1);
    memset(&extension, 0, sizeof extension);
    extension.surface = random;
    extension.c1.width = -1;
    refused(taut_harmonic_extension_make(&extension, NULL, &model, &error), TAUT_BAD_INPUT, &error,
            "value");
    for (int k = 0; k < 2; k++) { /* lost in the edge's parameter, or beyond all parameters */
        extension.c1.width = k == 0 ? 1e-300 : 1e300;
        refused(taut_harmonic_extension_make(&extension, NULL, &model, &error), TAUT_BAD_INPUT,
                &error, "value");
        CHECK(strcmp(error.where, "/width") == 0, "%s", error.where);
    }
    taut_surface_free(random);
    for (int k = 0; k < 48; k++) {
        g.points[k] = random_in(-1, 1);
    }
    random = shape_surface(g.u, g.v, g.points, NULL); /* takes the bases */
    extension.surface = random;
    extension.c1.width = 0;
    refused(taut_harmonic_extension_make(&extension, NULL, &model, &error), TAUT_NO_SOLUTION,
            &error, "not-harmonic");
    CHECK(model == NULL, "nothing was made");
    taut_surface_free(random);
}

/* Nothing given, bases of another type, a last point that no rule finds, and points that only
 * rational arithmetic can hold. */
static void test_bad_problems(void)
{
    static bezier_net g;
    const taut_make_options exact = {.exact = 1};
    taut_model *model = NULL;
    taut_error error;
    taut_harmonic_problem problem = start(&g, 5, 4), none = problem;
    taut_basis *other = shape_bspline(3, 6);

    refused(taut_harmonic_make(NULL, NULL, &model, &error), TAUT_BAD_ARGUMENT, &error, "argument");
    none.rows.points = NULL;
    refused(taut_harmonic_make(&none, NULL, &model, &error), TAUT_BAD_ARGUMENT, &error, "argument");
    none.given = TAUT_HARMONIC_DERIVATIVE;
    refused(taut_harmonic_make(&none, NULL, &model, &error), TAUT_BAD_ARGUMENT, &error, "argument");
    for (int k = 0; k < 2; k++) {
        none = problem;
        *(k == 0 ? &none.u : &none.v) = other;
        refused(taut_harmonic_make(&none, NULL, &model, &error), TAUT_BAD_INPUT, &error,
                "not-bezier");
        CHECK(strcmp(error.where, k == 0 ? "/u" : "/v") == 0, "%s", error.where);
    }
    place(&g, 2);
    g.known[29] = 0; /* of 6 x 5: the last of the second row, where degree 5 leaves it free */
    refused(taut_harmonic_make(&problem, NULL, &model, &error), TAUT_BAD_INPUT, &error, "mask");
    CHECK(strcmp(error.where, "/points") == 0, "%s", error.where);
    taut_basis_free(other);
    bezier_net_end(&g);
    problem = start(&g, 9, 9);
    place(&g, 8);
    refused(taut_harmonic_make(&problem, &exact, &model, &error), TAUT_NO_SOLUTION, &error,
            "overflow");
    CHECK(error.found > 1 && model == NULL, "amplification %g", error.found);
    bezier_net_end(&g);
}

/* (u, v, u v) or (u, v, u^2 - v^2) over the unit square, both harmonic. */
static taut_surface *polynomial(int n, int m, int is_square, const double *weights)
{
    double points[3 * 16];
    for (int k = 0; k < (n + 1) * (m + 1); k++) {
        const double i = k / (m + 1), j = k % (m + 1);
        points[3 * k] = i / n;
        points[3 * k + 1] = j / m;
        points[3 * k + 2] =
            is_square ? i * (i - 1) / n / (n - 1.0) - j * (j - 1) / m / (m - 1.0) : i / n * (j / m);
    }
    return shape_surface(shape_bezier(n, 0, 1), shape_bezier(m, 0, 1), points, weights);
}

/* Neighbours: bad numbers; too low a degree for equal tangent planes; beta where degrees are even:
 * beta v P_v has the top coefficient -2 beta, and nothing else has that degree; surfaces that have
 * weights. */
static void test_bad_neighbours(void)
{
    static const double weights[4] = {1, 2, 1, 1};
    taut_surface *low = polynomial(1, 3, 0, NULL), *even = polynomial(2, 2, 1, NULL);
    taut_surface *rational = polynomial(1, 1, 0, weights), *plain = shape_saddle(1);
    taut_harmonic_extension_problem problem = {.given = TAUT_EXTENSION_G1, .edge = TAUT_EDGE_U1};
    taut_model *model = NULL;
    taut_error error;

    refused(taut_harmonic_extension_make(&problem, NULL, &model, &error), TAUT_BAD_ARGUMENT, &error,
            "argument");
    problem.surface = low;
    for (int k = 0; k < 4; k++) {
        problem.g1.c = k == 0 ? 0 : k == 1 ? INFINITY : 1;
        problem.g1.alpha = k == 2 ? NAN : 0;
        problem.g1.beta = k == 3 ? INFINITY : 0;
        refused(taut_harmonic_extension_make(&problem, NULL, &model, &error), TAUT_BAD_INPUT,
                &error, "value");
        CHECK(strcmp(error.where, "/c") == 0, "%s", error.where);
    }
    problem.g1.beta = 0;
    refused(taut_harmonic_extension_make(&problem, NULL, &model, &error), TAUT_NO_SOLUTION, &error,
            "degree");
    CHECK(error.found == 1 && error.limit == 3, "%g of %g", error.found, error.limit);
    problem.surface = even;
    problem.g1.beta = 0.25;
    refused(taut_harmonic_extension_make(&problem, NULL, &model, &error), TAUT_NO_SOLUTION, &error,
            "inconsistent");
    CHECK_NEAR(error.found, 0.5, 1e-12, "2 beta");
    problem.g1.beta = 0;
    CHECK(taut_harmonic_extension_make(&problem, NULL, &model, &error) == TAUT_OK, "beta 0: %s",
          error.message);
    taut_model_free(model);
    model = NULL;
    problem.surface = rational;
    refused(taut_harmonic_extension_make(&problem, NULL, &model, &error), TAUT_BAD_INPUT, &error,
            "not-bezier");
    CHECK(strcmp(error.where, "/surface") == 0, "%s", error.where);
    problem = (taut_harmonic_extension_problem){
        .surface = plain, .given = TAUT_EXTENSION_MERGE, .merge = {rational}};
    refused(taut_harmonic_extension_make(&problem, NULL, &model, &error), TAUT_BAD_INPUT, &error,
            "not-bezier");
    CHECK(strcmp(error.where, "/neighbour") == 0 && model == NULL, "%s", error.where);
    taut_surface_free(low);
    taut_surface_free(even);
    taut_surface_free(rational);
    taut_surface_free(plain);
}

int main(void)
{
    random_seed(20261126);
    test_degenerate();
    test_even_far();
    test_refusals();
    test_bad_problems();
    test_bad_neighbours();
    return check_failures != 0;
}
