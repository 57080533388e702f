/* test_fit.c -- the harmonic surface nearest to four boundary rows: it is the surface
 * where there is one, no harmonic surface is nearer, and its certificate notices others. */
#include "bezier_net.h"
#include "certificates.h"
#include "check.h"
#include "shapes.h"

#include "problem/problem.h"
#include "taut/harmonic.h"

#include <string.h>

static void start(bezier_net *g, int n, int m, double across, double along)
{
    const double u[2] = {0, across}, v[2] = {0, along};
    bezier_net_start(g, n, m, u, v);
}

static taut_harmonic_problem problem_of(const bezier_net *g, int fit)
{
    taut_harmonic_problem problem;
    memset(&problem, 0, sizeof problem);
    problem.u = g->u;
    problem.v = g->v;
    if (fit) {
        problem.given = TAUT_HARMONIC_BOUNDARY;
        problem.boundary = (taut_harmonic_boundary){g->points, g->known};
    } else {
        problem.rows = (taut_harmonic_rows){.points = g->points, .known = g->known};
    }
    return problem;
}

/* The four rows of a harmonic surface give it back. */
static void test_reproduces(void)
{
    static bezier_net g;
    for (int m = 1; m <= 9; m++) {
        const int n = m % 2 != 0 ? m : m + 1;
        taut_model *model = NULL, *again = NULL;
        start(&g, n, m, 1, random_log(0.3, 3));
        bezier_net_fill(&g, 0, 1);
        bezier_net_know(&g, BEZIER_NET_ROWS);
        taut_harmonic_problem problem = problem_of(&g, 0);
        CHECK(taut_harmonic_make(&problem, NULL, &model, NULL) == TAUT_OK, "m=%d", m);
        const double *wanted = taut_surface_points(taut_model_surface(model, 0));
        memcpy(g.points, wanted, sizeof(double) * 3 * (size_t)((n + 1) * (m + 1)));
        bezier_net_know(&g, BEZIER_NET_FRAME);
        problem = problem_of(&g, 1);
        CHECK(taut_harmonic_make(&problem, NULL, &again, NULL) == TAUT_OK, "m=%d", m);
        const double grows = detail_of(again, "amplification");
        double largest = 0;
        const double apart =
            shape_apart(taut_model_surface(model, 0), taut_model_surface(again, 0), &largest);
        CHECK(apart <= (2 + grows) * 0x1p-52 * largest, "m=%d: %.3g of the largest, growth %.3g", m,
              apart / largest, grows);
        taut_model_free(model);
        taut_model_free(again);
        bezier_net_end(&g);
    }
}

/* Any rows, offsets and bidegrees: the certificate, which knows no Arnoldi, agrees; and it notices
 * a surface that is harmonic but not the nearest (the same moved a little). */
static void test_nearest(void)
{
    static bezier_net g;
    double worst = 0;
    for (int trial = 0; trial < random_trials(80); trial++) {
        const int n = random_int(1, 14), m = random_int(1, 14), far = trial % 5 == 0;
        const double size = random_log(1e-3, 1e3);
        taut_model *model = NULL, *moved = NULL;
        taut_surface *other = NULL;
        start(&g, n, m, random_log(0.2, 5), random_log(0.2, 5));
        bezier_net_fill(&g, far ? 1e8 : 0, size);
        bezier_net_know(&g, BEZIER_NET_FRAME);
        const taut_harmonic_problem problem = problem_of(&g, 1);
        CHECK(taut_harmonic_make(&problem, NULL, &model, NULL) == TAUT_OK, "n=%d m=%d", n, m);
        taut_certificate *certificate =
            certificate_of(model, TAUT_CONSTRUCT_INDEX_harmonic, &problem);
        const taut_claim *harmonic = claim_of(certificate, "harmonic");
        const taut_claim *nearest = claim_of(certificate, "nearest");
        CHECK(has_claim(certificate, "harmonic") && harmonic->holds != TAUT_FALSE,
              "n=%d m=%d: rho %.3g", n, m, harmonic->residual);
        CHECK(has_claim(certificate, "nearest") && nearest->holds != TAUT_FALSE,
              "n=%d m=%d: product %.3g", n, m, nearest->residual); /* undecided only far away */
        worst = far ? worst : fmax(worst, nearest->residual / (0x1p-53 * (n + m)));
        taut_certificate_free(certificate);
        const taut_surface *surface = taut_model_surface(model, 0);
        for (int k = 0; k < 3 * (n + 1) * (m + 1); k++) {
            g.points[k] = taut_surface_points(surface)[k] + (k % 3 == 0 ? 1e-5 * size : 0);
        }
        CHECK(taut_surface_new("", g.u, g.v, g.points, NULL, &other, NULL) == TAUT_OK, "moved");
        moved = shape_model(other);
        bezier_net_fill(&g, far ? 1e8 : 0, size); /* other rows: not nearest to these */
        certificate = certificate_of(moved, TAUT_CONSTRUCT_INDEX_harmonic, &problem);
        CHECK(claim_of(certificate, "nearest")->holds == TAUT_FALSE,
              "n=%d m=%d: the certificate is blind", n, m);
        taut_certificate_free(certificate);
        taut_model_free(model);
        taut_model_free(moved);
        bezier_net_end(&g);
    }
    CHECK(worst < 8, "products up to %.3g of (n + m) 2^-53", worst);
}

/* Rectangles a billion times longer than wide: powers of z have a part that is small beside the other. */
static void test_thin(void)
{
    static bezier_net g;
    for (int trial = 0; trial < 24; trial++) {
        const int n = random_int(1, 6), m = random_int(1, 6);
        const double narrow = random_log(1e-9, 1e-3);
        taut_model *model = NULL;
        start(&g, n, m, trial % 2 == 0 ? 1 : narrow, trial % 2 == 0 ? narrow : 1);
        bezier_net_fill(&g, 0, 1);
        bezier_net_know(&g, BEZIER_NET_FRAME);
        const taut_harmonic_problem problem = problem_of(&g, 1);
        CHECK(taut_harmonic_make(&problem, NULL, &model, NULL) == TAUT_OK, "n=%d m=%d", n, m);
        taut_certificate *certificate =
            certificate_of(model, TAUT_CONSTRUCT_INDEX_harmonic, &problem);
        CHECK(taut_certificate_holds(certificate) == TAUT_TRUE, "n=%d m=%d, %g: %.3g", n, m, narrow,
              claim_of(certificate, "nearest")->residual);
        taut_certificate_free(certificate);
        taut_model_free(model);
        bezier_net_end(&g);
    }
}

/* One point four times, and rows of a plane: no NaN. The gap of a square bent at one corner is
 * told. */
static void test_degenerate(void)
{
    static bezier_net g;
    for (int kind = 0; kind < 3; kind++) {
        taut_model *model = NULL;
        start(&g, 2 + kind, 3, 1, 1);
        bezier_net_fill(&g, kind == 0 ? 1e8 : 0, kind == 0 ? 0 : 1);
        for (int k = 0; kind == 2 && k < (g.n + 1) * (g.m + 1); k++) {
            g.points[3 * k + 2] = 0;
        }
        bezier_net_know(&g, BEZIER_NET_FRAME);
        const taut_harmonic_problem problem = problem_of(&g, 1);
        CHECK(taut_harmonic_make(&problem, NULL, &model, NULL) == TAUT_OK, "kind %d", kind);
        const double *points = taut_surface_points(taut_model_surface(model, 0));
        for (int k = 0; k < (g.n + 1) * (g.m + 1); k++) {
            CHECK(kind != 0 || (points[3 * k] == 1e8 && points[3 * k + 2] == 1e8), "a point moved");
            CHECK(kind != 2 || points[3 * k + 2] == 0, "left the plane");
        }
        taut_certificate *certificate =
            certificate_of(model, TAUT_CONSTRUCT_INDEX_harmonic, &problem);
        const double gap = figure_of(certificate, "boundary_gap");
        CHECK(kind == 0 ? gap == 0 : gap > 0.01 && gap < 3, "kind %d: gap %g", kind, gap);
        taut_certificate_free(certificate);
        taut_model_free(model);
        bezier_net_end(&g);
    }
}

static void test_refusals(void)
{
    static bezier_net g;
    taut_model *model = NULL;
    taut_error error;
    start(&g, 3, 3, 1, 1);
    bezier_net_fill(&g, 0, 1);
    bezier_net_know(&g, BEZIER_NET_ROWS);
    taut_harmonic_problem problem = problem_of(&g, 1);
    CHECK(taut_harmonic_make(&problem, NULL, &model, &error) == TAUT_BAD_INPUT && model == NULL,
          "two rows are too few");
    bezier_net_end(&g);
    start(&g, 2, 3, 1, 1);
    g.u = (taut_basis_free(g.u), shape_bezier(2, 0, 1));
    bezier_net_know(&g, BEZIER_NET_FRAME);
    g.known[5] = 1;
    problem = problem_of(&g, 1);
    CHECK(taut_harmonic_make(&problem, NULL, &model, &error) == TAUT_BAD_INPUT && model == NULL,
          "a point inside");
    bezier_net_end(&g);
}

/* Degrees beyond 64, told of the higher one. */
static void test_degree(void)
{
    static double points[3 * 2 * 66];
    static unsigned char known[2 * 66];
    for (int k = 0; k < 2; k++) {
        taut_basis *u = shape_bezier(k == 0 ? 65 : 1, 0, 1),
                   *v = shape_bezier(k == 0 ? 1 : 65, 0, 1);
        taut_model *model = NULL;
        taut_error error;
        memset(known, 1, sizeof known);
        const taut_harmonic_problem problem = {
            .u = u, .v = v, .given = TAUT_HARMONIC_BOUNDARY, .boundary = {points, known}};
        CHECK(taut_harmonic_make(&problem, NULL, &model, &error) == TAUT_NO_SOLUTION &&
                  model == NULL && error.found == 65 && error.limit == 64,
              "%g of %g", error.found, error.limit);
        CHECK(strcmp(error.where, k == 0 ? "/u/degree" : "/v/degree") == 0, "%s", error.where);
        taut_basis_free(u);
        taut_basis_free(v);
    }
}

int main(void)
{
    random_seed(20261122);
    test_reproduces();
    test_nearest();
    test_thin();
    test_degenerate();
    test_refusals();
    test_degree();
    return check_failures != 0;
}
