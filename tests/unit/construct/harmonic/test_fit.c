/* test_fit.c -- the harmonic surface nearest to four boundary rows: it is the surface
 * where there is one, no harmonic surface is nearer, and its certificate notices others. */
#include "check.h"

#include "problem/problem.h"
#include "taut/harmonic.h"

#include <string.h>

enum { SIZE = 32 };

/* A problem of random boundary rows, or of one completed from two of them. */
typedef struct net {
    taut_basis *u, *v;
    double points[SIZE * SIZE * 3];
    unsigned char known[SIZE * SIZE];
    int n, m;
} net;

static taut_basis *bezier(int degree, double width)
{
    const taut_basis_spec spec = {
        .type = "bezier", .degree = degree, .has_range = 1, .range = {0, width}};
    taut_basis *basis = NULL;
    CHECK(taut_basis_new(&spec, degree + 1, &basis, NULL) == TAUT_OK, "degree %d", degree);
    return basis;
}

static void net_start(net *g, int n, int m, double across, double along)
{
    memset(g, 0, sizeof *g);
    g->n = n;
    g->m = m;
    g->u = bezier(n, across);
    g->v = bezier(m, along);
}

static void net_end(net *g)
{
    taut_basis_free(g->u);
    taut_basis_free(g->v);
}

static void know(net *g, int four)
{
    for (int i = 0; i <= g->n; i++) {
        for (int j = 0; j <= g->m; j++) {
            const int rows = i == 0 || i == g->n, columns = j == 0 || j == g->m;
            g->known[i * (g->m + 1) + j] = rows || (four && columns);
        }
    }
}

static void fill(net *g, double offset, double size)
{
    for (int k = 0; k < 3 * (g->n + 1) * (g->m + 1); k++) {
        g->points[k] = offset + size * random_in(-1, 1);
    }
}

static taut_harmonic_problem problem_of(const net *g, int fit)
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

static taut_certificate *prove(const taut_model *model, const taut_harmonic_problem *data)
{
    taut_problem *problem = NULL;
    taut_certificate *certificate = NULL;
    CHECK(taut_problem_new(TAUT_CONSTRUCT_INDEX_harmonic, &problem) == TAUT_OK, "problem");
    problem->data = data;
    CHECK(taut_certify(model, problem, NULL, &certificate, NULL) == TAUT_OK, "certify");
    taut_problem_free(problem);
    return certificate;
}

static double claim(const taut_certificate *certificate, const char *name, int *holds)
{
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *c = taut_certificate_claim(certificate, i);
        if (strcmp(c->claim, name) == 0) {
            *holds = c->holds != TAUT_FALSE; /* undecided only far from the origin */
            return c->residual;
        }
    }
    CHECK(0, "no claim %s", name);
    return -1;
}

/* The four rows of a harmonic surface give it back. */
static void test_reproduces(void)
{
    static net g;
    for (int m = 1; m <= 9; m++) {
        const int n = m % 2 != 0 ? m : m + 1;
        taut_model *model = NULL, *again = NULL;
        net_start(&g, n, m, 1, random_log(0.3, 3));
        fill(&g, 0, 1);
        know(&g, 0);
        taut_harmonic_problem problem = problem_of(&g, 0);
        CHECK(taut_harmonic_make(&problem, NULL, &model, NULL) == TAUT_OK, "m=%d", m);
        const double *wanted = taut_surface_points(taut_model_surface(model, 0));
        memcpy(g.points, wanted, sizeof(double) * 3 * (size_t)((n + 1) * (m + 1)));
        know(&g, 1);
        problem = problem_of(&g, 1);
        CHECK(taut_harmonic_make(&problem, NULL, &again, NULL) == TAUT_OK, "m=%d", m);
        const double *found = taut_surface_points(taut_model_surface(again, 0));
        const double grows =
            taut_record_number(taut_record_get(taut_model_details(again), "amplification"));
        double largest = 0, apart = 0;
        for (int k = 0; k < 3 * (n + 1) * (m + 1); k++) {
            largest = fmax(largest, fabs(wanted[k]));
            apart = fmax(apart, fabs(found[k] - wanted[k]));
        }
        CHECK(apart <= (2 + grows) * 0x1p-52 * largest, "m=%d: %.3g of the largest, growth %.3g", m,
              apart / largest, grows);
        taut_model_free(model);
        taut_model_free(again);
        net_end(&g);
    }
}

/* Any rows, offsets and bidegrees: the certificate, which knows no Arnoldi, agrees; and it notices
 * a surface that is harmonic but not the nearest (the same moved a little). */
static void test_nearest(void)
{
    static net g;
    double worst = 0;
    for (int trial = 0; trial < random_trials(80); trial++) {
        const int n = random_int(1, 14), m = random_int(1, 14), far = trial % 5 == 0;
        const double size = random_log(1e-3, 1e3);
        taut_model *model = NULL, *moved = NULL;
        taut_surface *other = NULL;
        int harmonic = 0, nearest = 0;
        net_start(&g, n, m, random_log(0.2, 5), random_log(0.2, 5));
        fill(&g, far ? 1e8 : 0, size);
        know(&g, 1);
        const taut_harmonic_problem problem = problem_of(&g, 1);
        CHECK(taut_harmonic_make(&problem, NULL, &model, NULL) == TAUT_OK, "n=%d m=%d", n, m);
        taut_certificate *certificate = prove(model, &problem);
        const double rho = claim(certificate, "harmonic", &harmonic);
        const double product = claim(certificate, "nearest", &nearest);
        CHECK(harmonic, "n=%d m=%d: rho %.3g", n, m, rho);
        CHECK(nearest, "n=%d m=%d: product %.3g", n, m, product);
        worst = far ? worst : fmax(worst, product / (0x1p-53 * (n + m)));
        taut_certificate_free(certificate);
        const taut_surface *surface = taut_model_surface(model, 0);
        for (int k = 0; k < 3 * (n + 1) * (m + 1); k++) {
            g.points[k] = taut_surface_points(surface)[k] + (k % 3 == 0 ? 1e-5 * size : 0);
        }
        CHECK(taut_surface_new("", g.u, g.v, g.points, NULL, &other, NULL) == TAUT_OK, "moved");
        CHECK(taut_model_new(&moved) == TAUT_OK && taut_model_add_surface(moved, other) == TAUT_OK,
              "model");
        fill(&g, far ? 1e8 : 0, size); /* other rows: not nearest to these */
        certificate = prove(moved, &problem);
        (void)claim(certificate, "nearest", &nearest);
        CHECK(!nearest, "n=%d m=%d: the certificate is blind", n, m);
        taut_certificate_free(certificate);
        taut_model_free(model);
        taut_model_free(moved);
        net_end(&g);
    }
    CHECK(worst < 8, "products up to %.3g of (n + m) 2^-53", worst);
}

/* One point four times, and rows of a plane: no NaN. The gap of a square bent at one corner is
 * told. */
static void test_degenerate(void)
{
    static net g;
    for (int kind = 0; kind < 3; kind++) {
        taut_model *model = NULL;
        net_start(&g, 2 + kind, 3, 1, 1);
        fill(&g, kind == 0 ? 1e8 : 0, kind == 0 ? 0 : 1);
        for (int k = 0; kind == 2 && k < (g.n + 1) * (g.m + 1); k++) {
            g.points[3 * k + 2] = 0;
        }
        know(&g, 1);
        const taut_harmonic_problem problem = problem_of(&g, 1);
        CHECK(taut_harmonic_make(&problem, NULL, &model, NULL) == TAUT_OK, "kind %d", kind);
        const double *points = taut_surface_points(taut_model_surface(model, 0));
        for (int k = 0; k < (g.n + 1) * (g.m + 1); k++) {
            CHECK(kind != 0 || (points[3 * k] == 1e8 && points[3 * k + 2] == 1e8), "a point moved");
            CHECK(kind != 2 || points[3 * k + 2] == 0, "left the plane");
        }
        taut_certificate *certificate = prove(model, &problem);
        const double gap = taut_record_number(
            taut_record_get(taut_certificate_figures(certificate), "boundary_gap"));
        CHECK(kind == 0 ? gap == 0 : gap > 0.01 && gap < 3, "kind %d: gap %g", kind, gap);
        taut_certificate_free(certificate);
        taut_model_free(model);
        net_end(&g);
    }
}

static void test_refusals(void)
{
    static net g;
    taut_model *model = NULL;
    taut_error error;
    net_start(&g, 3, 3, 1, 1);
    fill(&g, 0, 1);
    know(&g, 0);
    taut_harmonic_problem problem = problem_of(&g, 1);
    CHECK(taut_harmonic_make(&problem, NULL, &model, &error) == TAUT_BAD_INPUT && model == NULL,
          "two rows are too few");
    net_end(&g);
    net_start(&g, 2, 3, 1, 1);
    g.u = (taut_basis_free(g.u), bezier(2, 1));
    know(&g, 1);
    g.known[5] = 1;
    problem = problem_of(&g, 1);
    CHECK(taut_harmonic_make(&problem, NULL, &model, &error) == TAUT_BAD_INPUT && model == NULL,
          "a point inside");
    net_end(&g);
}

/* Degrees beyond 64, told of the higher one. */
static void test_degree(void)
{
    static double points[3 * 2 * 66];
    static unsigned char known[2 * 66];
    for (int k = 0; k < 2; k++) {
        taut_basis *u = bezier(k == 0 ? 65 : 1, 1), *v = bezier(k == 0 ? 1 : 65, 1);
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
    test_degenerate();
    test_refusals();
    test_degree();
    return check_failures != 0;
}
