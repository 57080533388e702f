/* test_biharmonic.c -- biharmonic surfaces from four rows and their neighbours: closed forms,
 * harmonic surfaces given back, certificates over random data, and refusals. */
#include "bezier_net.h"
#include "certificates.h"
#include "check.h"
#include "shapes.h"

#include "problem/problem.h"
#include "taut/biharmonic.h"
#include "taut/harmonic.h"
#include "taut/measure.h"
#include "taut/operations.h"

#include <string.h>

/* All four rows known. */
static void start(bezier_net *g, int n, double across, double along)
{
    const double u[2] = {1, 1 + across}, v[2] = {-2, -2 + along};
    bezier_net_start(g, n, n, u, v);
    bezier_net_know(g, BEZIER_NET_FRAME);
}

static taut_biharmonic_problem rows_of(const bezier_net *g)
{
    taut_biharmonic_problem problem;
    memset(&problem, 0, sizeof problem);
    problem.rows = (taut_biharmonic_rows){NULL, g->u, g->v, g->points, g->known};
    return problem;
}

static taut_model *make(const taut_biharmonic_problem *problem, const char *what)
{
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    const taut_status status = taut_biharmonic_make(problem, NULL, &model, &error);
    CHECK(status == TAUT_OK, "%s: %s", what, error.message);
    return model;
}

/* How the claim stands, -1 if it is not there; *slack its residual over its limit. */
static int prove(const taut_model *model, const taut_biharmonic_problem *data, const char *name,
                 double *slack)
{
    taut_certificate *certificate = certificate_of(model, TAUT_CONSTRUCT_INDEX_biharmonic, data);
    const taut_claim *c = claim_of(certificate, name);
    const int verdict = has_claim(certificate, name) ? (int)c->holds : -1;
    *slack = c->limit > 0 ? c->residual / c->limit : c->residual;
    taut_certificate_free(certificate);
    return verdict;
}

/* The masks of [NiWang2015] section 8.4. */
static void test_masks(void)
{
    static bezier_net g;
    for (int n = 2; n <= 3; n++) {
        start(&g, n, 1, 1);
        bezier_net_fill(&g, 0, 1);
        const taut_biharmonic_problem problem = rows_of(&g);
        taut_model *model = make(&problem, "mask");
        const double *p = taut_surface_points(taut_model_surface(model, 0));
        for (int c = 0; c < 3; c++) {
#define P(i, j) g.points[3 * ((i) * (n + 1) + (j)) + c]
            const double wanted = n == 2 ? (P(0, 1) + P(1, 0) + P(2, 1) + P(1, 2)) / 2 -
                                               (P(0, 0) + P(0, 2) + P(2, 0) + P(2, 2)) / 4
                                         : (-4 * P(0, 0) - 2 * P(0, 3) - 2 * P(3, 0) - P(3, 3) +
                                            6 * P(0, 1) + 6 * P(1, 0) + 3 * P(1, 3) + 3 * P(3, 1)) /
                                               9;
#undef P
            CHECK_NEAR(p[3 * (n + 2) + c], wanted, 4e-16, "n=%d c=%d", n, c);
        }
        taut_model_free(model);
        bezier_net_end(&g);
    }
}

/* The four rows of a harmonic surface, over any rectangle: the same surface. */
static void test_harmonic(void)
{
    static bezier_net g;
    for (int n = 1; n <= 11; n += 2) {
        taut_harmonic_problem harmonic;
        taut_model *wanted = NULL;
        start(&g, n, 1, random_log(0.5, 2));
        bezier_net_fill(&g, 0, 1);
        memset(&harmonic, 0, sizeof harmonic);
        harmonic.u = g.u;
        harmonic.v = g.v;
        harmonic.rows.points = g.points;
        harmonic.rows.known = g.known;
        bezier_net_know(&g, BEZIER_NET_ROWS);
        CHECK(taut_harmonic_make(&harmonic, NULL, &wanted, NULL) == TAUT_OK, "n=%d", n);
        const double *expected = taut_surface_points(taut_model_surface(wanted, 0));
        memcpy(g.points, expected, 3 * (size_t)((n + 1) * (n + 1)) * sizeof(double));
        bezier_net_know(&g, BEZIER_NET_FRAME);
        const taut_biharmonic_problem problem = rows_of(&g);
        taut_model *model = make(&problem, "harmonic");
        const double grows = detail_of(model, "amplification");
        double largest = 0;
        const double apart =
            shape_apart(taut_model_surface(wanted, 0), taut_model_surface(model, 0), &largest);
        CHECK(apart <= (1 + grows) * 0x1p-52 * largest, "n=%d: %.3g of the largest, growth %.3g", n,
              apart / largest, grows);
        taut_model_free(wanted);
        taut_model_free(model);
        bezier_net_end(&g);
    }
}

static void all_hold(const taut_model *model, const taut_biharmonic_problem *problem, int neighbour,
                     const char *what, int n, double *worst)
{
    static const char *const names[] = {"biharmonic", "boundary", "continuity", "least-bending"};
    for (int k = 0; k < (neighbour ? 4 : 2); k++) {
        double slack = 0;
        const int verdict = prove(model, problem, names[k], &slack);
        CHECK(verdict == TAUT_TRUE || verdict == TAUT_UNDECIDED,
              "%s n=%d: %s %d, %.3g of its limit", what, n, names[k], verdict, slack);
        worst[k] = fmax(worst[k], verdict == TAUT_TRUE ? slack : 0);
    }
}

/* The model with one inner point of its last surface moved. */
static taut_model *moved(const taut_model *model, double by)
{
    const int last = taut_model_surface_count(model) - 1;
    taut_model *other = NULL;
    double points[3 * BEZIER_NET_SIZE * BEZIER_NET_SIZE];
    taut_surface *surface = NULL;

    CHECK(taut_model_new(&other) == TAUT_OK, "model");
    for (int i = 0; i <= last; i++) {
        const taut_surface *s = taut_model_surface(model, i);
        const int columns = taut_basis_count(taut_surface_v(s));
        const int count = taut_basis_count(taut_surface_u(s)) * columns;
        memcpy(points, taut_surface_points(s), 3 * (size_t)count * sizeof(double));
        points[3 * (columns + 1)] += i == last ? by : 0;
        CHECK(taut_surface_new(taut_surface_name(s), taut_surface_u(s), taut_surface_v(s), points,
                               NULL, &surface, NULL) == TAUT_OK &&
                  taut_model_add_surface(other, surface) == TAUT_OK,
              "surface %d", i);
    }
    return other;
}

static double energy_of(const taut_surface *surface)
{
    double energy = -1;
    CHECK(taut_surface_bending_energy(surface, &energy) == TAUT_OK, "energy");
    return energy;
}

/* Random rows, rectangles and offsets; neighbours across every edge, of any width. The energy of a
 * neighbour is not above that of the surface carried on, which meets it C^infinity. */
static void test_random(void)
{
    static bezier_net g;
    double worst[4] = {0, 0, 0, 0};
    for (int trial = 0; trial < random_trials(60); trial++) {
        const int n = random_int(2, 9), far = trial % 6 == 0;
        const double size = far ? 1 : random_log(1e-3, 1e3);
        start(&g, n, random_log(0.5, 2), random_log(0.5, 2));
        bezier_net_fill(&g, far ? 1e8 : 0, size);
        const taut_biharmonic_problem problem = rows_of(&g);
        taut_model *model = make(&problem, "rows");
        const taut_surface *p = taut_model_surface(model, 0);
        double slack = 0;
        all_hold(model, &problem, 0, "rows", n, worst);
        for (int k = 0; k < 3 * (n + 1) * (n + 1); k++) {
            CHECK(!g.known[k / 3] || taut_surface_points(p)[k] == g.points[k],
                  "a given point moved");
        }
        taut_model *wrong = moved(model, 1e-4 * size);
        CHECK(prove(wrong, &problem, "biharmonic", &slack) == TAUT_FALSE, "n=%d: blind", n);
        taut_model_free(wrong);

        taut_biharmonic_problem next;
        memset(&next, 0, sizeof next);
        next.given = TAUT_BIHARMONIC_NEIGHBOUR;
        next.neighbour.surface = p;
        next.neighbour.edge = (taut_edge)(trial % 4);
        next.neighbour.width = trial % 3 == 0 ? 0 : random_log(0.3, 3);
        double energies[2] = {0, 0};
        for (next.neighbour.contact = 1; next.neighbour.contact <= 2; next.neighbour.contact++) {
            taut_model *pair = make(&next, "neighbour");
            all_hold(pair, &next, 1, next.neighbour.contact == 1 ? "c1" : "c2", n, worst);
            energies[next.neighbour.contact - 1] = energy_of(taut_model_surface(pair, 1));
            wrong = moved(pair, 1e-3 * size);
            CHECK(far || prove(wrong, &next, "biharmonic", &slack) == TAUT_FALSE, "n=%d: blind", n);
            taut_model_free(wrong);
            taut_model_free(pair);
        }
        CHECK(energies[0] <= energies[1] * (1 + 1e-9), "n=%d: C^1 %g, C^2 %g", n, energies[0],
              energies[1]);
        taut_model_free(model);
        bezier_net_end(&g);
    }
    for (int k = 0; k < 4; k++) {
        CHECK(worst[k] <= 1 && (k == 1 || worst[k] > 1e-3), "claim %d: up to %.3g of the limit", k,
              worst[k]);
    }
}

/* A harmonic extension is biharmonic and meets the surface C^infinity: it passes all but the claim
 * of least bending. */
static void test_not_least(void)
{
    taut_surface *enneper = shape_enneper(0, 1, 0, 1);
    taut_harmonic_extension_problem extension;
    taut_biharmonic_problem next;
    taut_model *carried = NULL, *pair = NULL, *least = NULL;
    taut_surface *copy = NULL;
    double slack = 0;

    memset(&extension, 0, sizeof extension);
    extension.surface = enneper;
    extension.edge = TAUT_EDGE_U1;
    memset(&next, 0, sizeof next);
    next.given = TAUT_BIHARMONIC_NEIGHBOUR;
    next.neighbour.surface = enneper;
    next.neighbour.edge = TAUT_EDGE_U1;
    next.neighbour.contact = 1;
    CHECK(taut_harmonic_extension_make(&extension, NULL, &carried, NULL) == TAUT_OK, "extension");
    CHECK(taut_model_new(&pair) == TAUT_OK, "model");
    for (int i = 0; i < 2; i++) {
        CHECK(taut_surface_copy(taut_model_surface(carried, i), &copy) == TAUT_OK &&
                  taut_model_add_surface(pair, copy) == TAUT_OK,
              "copy");
    }
    CHECK(prove(pair, &next, "biharmonic", &slack) == TAUT_TRUE, "%.3g", slack);
    CHECK(prove(pair, &next, "continuity", &slack) == TAUT_TRUE, "%.3g", slack);
    CHECK(prove(pair, &next, "least-bending", &slack) == TAUT_FALSE, "%.3g", slack);
    least = make(&next, "enneper");
    CHECK(energy_of(taut_model_surface(least, 1)) < 0.9 * energy_of(taut_model_surface(pair, 1)),
          "the energy falls");
    taut_model_free(carried);
    taut_model_free(pair);
    taut_model_free(least);
    taut_surface_free(enneper);
}

/* One point, a segment, a plane; the bilinear case with its neighbours: no NaN, no refusal. */
static void test_degenerate(void)
{
    static bezier_net g;
    double worst[4] = {0, 0, 0, 0};
    for (int kind = 0; kind < 4; kind++) {
        start(&g, kind == 3 ? 1 : 4, 1, 2);
        bezier_net_fill(&g, kind == 0 ? 1e8 : 0, kind == 0 ? 0 : 1);
        for (int k = 0; k < (g.n + 1) * (g.n + 1); k++) {
            for (int c = kind == 1 ? 1 : 2; (kind == 1 || kind == 2) && c < 3; c++) {
                g.points[3 * k + c] = 0;
            }
        }
        const taut_biharmonic_problem problem = rows_of(&g);
        taut_model *model = make(&problem, "degenerate");
        all_hold(model, &problem, 0, "degenerate", kind, worst);
        taut_biharmonic_problem next;
        memset(&next, 0, sizeof next);
        next.given = TAUT_BIHARMONIC_NEIGHBOUR;
        next.neighbour.surface = taut_model_surface(model, 0);
        next.neighbour.edge = TAUT_EDGE_V1;
        for (next.neighbour.contact = 1; next.neighbour.contact <= 2; next.neighbour.contact++) {
            taut_model *pair = make(&next, "degenerate neighbour");
            all_hold(pair, &next, 1, "degenerate neighbour", kind, worst);
            taut_model_free(pair);
        }
        taut_model_free(model);
        bezier_net_end(&g);
    }
}

/* Where nothing is free the net is de Casteljau's: (1 + 2 h)^n times the rows. Else no net is
 * larger than it says, and signs that go against each other make one that is nearly so. */
static void test_amplification(void)
{
    for (int n = 1; n <= 5; n++) {
        const double width = random_in(0.3, 1.5);
        double most = 0, told = 0;
        for (int trial = 0; trial < 40; trial++) {
            taut_biharmonic_problem next = {
                .given = TAUT_BIHARMONIC_NEIGHBOUR,
                .neighbour = {.edge = TAUT_EDGE_U1, .width = width, .contact = 2}};
            taut_model *model = NULL, *pair = NULL;
            bezier_net g;
            double given = 0, beyond = 0;
            start(&g, n, 1, 1);
            bezier_net_fill(&g, 0, 1);
            const taut_biharmonic_problem rows = rows_of(&g);
            model = make(&rows, "rows");
            next.neighbour.surface = taut_model_surface(model, 0);
            pair = make(&next, "neighbour");
            told = detail_of(pair, "amplification");
            for (int k = 0; k < 3 * (n + 1) * (n + 1); k++) {
                const double p = fabs(taut_surface_points(next.neighbour.surface)[k]);
                given = k / 3 / (n + 1) >= n - 2 ? fmax(given, p) : given;
                beyond = fmax(beyond, fabs(taut_surface_points(taut_model_surface(pair, 1))[k]));
            }
            most = fmax(most, beyond / given);
            taut_model_free(pair);
            taut_model_free(model);
            bezier_net_end(&g);
        }
        CHECK(most <= told * (1 + 1e-12), "n=%d: grew %.17g, told %.17g", n, most, told);
        CHECK(most >= 0.02 * told, "n=%d: grew %.17g, told %.17g", n, most, told);
        if (n <= 2) {
            CHECK_NEAR(told, pow(1 + 2 * width, n), 1e-13 * told, "n=%d", n);
        }
    }
}

static void refused(const taut_biharmonic_problem *problem, taut_status wanted, const char *reason)
{
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_biharmonic_make(problem, NULL, &model, &error) == wanted && model == NULL, "%s",
          reason);
    CHECK(strcmp(error.reason, reason) == 0, "said %s, '%s', expected %s", error.reason,
          error.message, reason);
}

static void test_refusals(void)
{
    static bezier_net g;
    taut_biharmonic_problem problem;
    double points[75];
    taut_surface *random = NULL;

    start(&g, 18, 1, 1); /* 4.5e11 there */
    problem = rows_of(&g);
    refused(&problem, TAUT_NO_SOLUTION, "ill-conditioned");
    bezier_net_end(&g);
    start(&g, 25, 1, 1); /* too high to tell */
    problem = rows_of(&g);
    refused(&problem, TAUT_NO_SOLUTION, "ill-conditioned");
    bezier_net_end(&g);
    refused(NULL, TAUT_BAD_ARGUMENT, "argument");
    start(&g, 3, 1, 1);
    for (int k = 0; k < 2; k++) {
        taut_basis *const other = shape_bspline(2, 4);
        problem = rows_of(&g);
        *(k == 0 ? &problem.rows.u : &problem.rows.v) = other;
        refused(&problem, TAUT_BAD_INPUT, "not-bezier");
        taut_basis_free(other);
    }
    bezier_net_end(&g);
    start(&g, 3, 1, 1);
    problem = rows_of(&g);
    g.known[5] = 1;
    refused(&problem, TAUT_BAD_INPUT, "mask");
    g.known[5] = 0;
    taut_basis_free(g.v);
    g.v = shape_bezier(2, 0, 1);
    problem = rows_of(&g);
    for (int k = 0; k < 12; k++) {
        g.known[k] = k / 3 == 0 || k / 3 == 3 || k % 3 != 1;
    }
    refused(&problem, TAUT_NO_SOLUTION, "degree");
    bezier_net_end(&g);
    for (int k = 0; k < 75; k++) {
        points[k] = random_in(-1, 1);
    }
    random = shape_surface(shape_bezier(4, 0, 1), shape_bezier(4, 0, 1), points, NULL);
    memset(&problem, 0, sizeof problem);
    problem.given = TAUT_BIHARMONIC_NEIGHBOUR;
    problem.neighbour.surface = random;
    problem.neighbour.contact = 1;
    refused(&problem, TAUT_NO_SOLUTION, "not-biharmonic");
    problem.neighbour.contact = 3;
    refused(&problem, TAUT_BAD_INPUT, "value");
    problem.neighbour.contact = 2;
    problem.neighbour.width = -1;
    refused(&problem, TAUT_BAD_INPUT, "value");
    taut_surface_free(random);
}

/* (u, v, u^2 - v^2) of degree n both ways, over the unit square. */
static taut_surface *saddle(int n)
{
    static double points[34 * 34][3];
    for (int k = 0; k < (n + 1) * (n + 1); k++) {
        const double i = k / (n + 1), j = k % (n + 1);
        points[k][0] = i / n;
        points[k][1] = j / n;
        points[k][2] = (i * (i - 1) - j * (j - 1)) / (n * (n - 1.0));
    }
    return shape_surface(shape_bezier(n, 0, 1), shape_bezier(n, 0, 1), points[0], NULL);
}

/* Where rounding leaves nothing of what would be claimed neighbours are refused, unless that is
 * allowed; a step before that all claims hold. */
static void test_digits(void)
{
    static const struct {
        int n, contact;
        double width;
        const char *reason;
    } cases[] = {{33, 1, 1, "degree"},
                 {13, 2, 3.5, "ill-conditioned"},
                 {12, 2, 2.5, NULL},
                 {20, 1, 0.02, NULL}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        taut_surface *given = saddle(cases[i].n);
        taut_biharmonic_problem problem = {.given = TAUT_BIHARMONIC_NEIGHBOUR,
                                           .neighbour = {.surface = given,
                                                         .edge = TAUT_EDGE_U1,
                                                         .width = cases[i].width,
                                                         .contact = cases[i].contact}};
        double worst[4] = {0, 0, 0, 0};
        if (cases[i].reason != NULL) {
            refused(&problem, TAUT_NO_SOLUTION, cases[i].reason);
            problem.neighbour.allow_ill_conditioned = 1;
        }
        if (cases[i].n <= 20) {
            taut_model *pair = make(&problem, "at the limit");
            if (cases[i].reason == NULL) {
                all_hold(pair, &problem, 1, "at the limit", cases[i].n, worst);
            }
            taut_model_free(pair);
        }
        taut_surface_free(given);
    }
}

int main(void)
{
    random_seed(20261123);
    test_masks();
    test_harmonic();
    test_random();
    test_not_least();
    test_degenerate();
    test_amplification();
    test_refusals();
    test_digits();
    return check_failures != 0;
}
