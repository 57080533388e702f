/* test_exact.c -- rational arithmetic against doubles, and against itself: residuals that are 0,
 * pieces that are the whole, texts in lowest terms whose doubles are the nearest ones. links: gmp
 */
#include "certificates.h"
#include "check.h"
#include "shapes.h"

#include "problem/problem.h"
#include "taut/harmonic.h"
#include "taut/operations.h"

#include <gmp.h>
#include <stdlib.h>
#include <string.h>

enum { SIZE = 16, TEXT = 40 };

static const taut_make_options exactly = {.exact = 1};

typedef struct net {
    taut_basis *u, *v;
    int n, m;
    double points[3 * SIZE * SIZE];
    const char *texts[3 * SIZE * SIZE];
    char store[3 * SIZE * SIZE][TEXT];
    unsigned char known[SIZE * SIZE];
} net;

/* Random fractions in two rows (or columns) of a net; every third coordinate is a double. */
static void start(net *g, int n, int m, int turned)
{
    memset(g, 0, sizeof *g);
    g->n = n;
    g->m = m;
    const double lo = random_int(0, 9) / 10.0, hi = random_int(11, 29) / 10.0; /* hi - lo rounds */
    g->u = shape_bezier(n, lo, hi);
    g->v = shape_bezier(m, -1, ldexp(random_int(1, 8), -2));
    for (int k = 0; k < 3 * (n + 1) * (m + 1); k++) {
        const int i = k / 3 / (m + 1), j = k / 3 % (m + 1);
        const int top = random_int(-99, 99), bottom = random_int(1, 99);
        g->known[k / 3] = turned ? j == 0 || j == m : i == 0 || i == n;
        g->points[k] = (double)top / bottom;
        if (k % 3 != 2) {
            snprintf(g->store[k], TEXT, "%d/%d", top, bottom);
            g->texts[k] = g->store[k];
        }
    }
}

static void end(net *g)
{
    taut_basis_free(g->u);
    taut_basis_free(g->v);
}

static taut_harmonic_problem problem_of(const net *g)
{
    taut_harmonic_problem problem;
    memset(&problem, 0, sizeof problem);
    problem.u = g->u;
    problem.v = g->v;
    problem.rows.points = g->points;
    problem.rows.known = g->known;
    problem.rows.exact = g->texts;
    return problem;
}

/* The exact residual over all surfaces; -1 where the claim does not hold. */
static double residual(const taut_model *model)
{
    static const taut_certify_options options = {.exact = 1};
    const char *name = "harmonic";
    taut_certificate *mark = NULL, *certificate = NULL;
    taut_model *copy = NULL;
    double found = -1;

    CHECK(taut_model_new(&copy) == TAUT_OK, "model");
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        taut_surface *surface = NULL;
        CHECK(taut_surface_copy(taut_model_surface(model, i), &surface) == TAUT_OK &&
                  taut_model_add_surface(copy, surface) == TAUT_OK,
              "copy");
    }
    CHECK(taut_certificate_new(name, &mark) == TAUT_OK, "certificate");
    taut_model_set_certificate(copy, mark);
    CHECK(taut_certify(copy, NULL, &options, &certificate, NULL) == TAUT_OK, "certify");
    const taut_claim *claim = taut_certificate_claim(certificate, 0);
    CHECK(strcmp(claim->claim, name) == 0, "the first claim is %s", claim->claim);
    found = claim->residual;
    taut_certificate_free(certificate);
    taut_model_free(copy);
    return found;
}

/* Texts against the doubles beside them, by another library. */
static void check_texts(const taut_surface *surface, const char *what)
{
    const char *const *texts = taut_surface_exact(surface);
    const int count =
        3 * taut_basis_count(taut_surface_u(surface)) * taut_basis_count(taut_surface_v(surface));
    mpq_t x, lowest, near, other;
    mpq_inits(x, lowest, near, other, NULL);
    CHECK(texts != NULL, "%s: no exact points", what);
    for (int k = 0; texts != NULL && k < count; k++) {
        const double value = taut_surface_points(surface)[k];
        CHECK(mpq_set_str(x, texts[k], 10) == 0, "%s: %s", what, texts[k]);
        mpq_set(lowest, x);
        mpq_canonicalize(lowest);
        CHECK(mpz_cmp(mpq_denref(x), mpq_denref(lowest)) == 0, "%s: %s is not in lowest terms",
              what, texts[k]);
        mpq_set_d(near, value);
        mpq_sub(near, near, x);
        mpq_abs(near, near);
        for (int side = 0; side < 2; side++) {
            mpq_set_d(other, nextafter(value, side == 0 ? -INFINITY : INFINITY));
            mpq_sub(other, other, x);
            mpq_abs(other, other);
            CHECK(mpq_cmp(near, other) <= 0, "%s: %.17g is not nearest to %s", what, value,
                  texts[k]);
        }
    }
    mpq_clears(x, lowest, near, other, NULL);
}

static int same_texts(const taut_surface *a, const taut_surface *b)
{
    const int count = 3 * taut_basis_count(taut_surface_u(a)) * taut_basis_count(taut_surface_v(a));
    for (int k = 0; k < count; k++) {
        if (strcmp(taut_surface_exact(a)[k], taut_surface_exact(b)[k]) != 0) {
            return 0;
        }
    }
    return 1;
}

/* The extension of a surface across an edge, and the merged surface cut in two: both again. */
static void check_extension(const taut_surface *surface, int n)
{
    taut_harmonic_extension_problem problem;
    taut_model *model = NULL, *pieces = NULL;
    memset(&problem, 0, sizeof problem);
    problem.surface = surface;
    problem.edge = (taut_edge)random_int(0, 3);
    problem.c1.width = ldexp(random_int(1, 5), -2);
    CHECK(taut_harmonic_extension_make(&problem, &exactly, &model, NULL) == TAUT_OK, "n=%d", n);
    CHECK(residual(model) == 0, "n=%d: the extension's residual", n);
    check_texts(taut_model_surface(model, 1), "extension");
    const int along_v = problem.edge == TAUT_EDGE_V0 || problem.edge == TAUT_EDGE_V1;
    const int high = problem.edge == TAUT_EDGE_U1 || problem.edge == TAUT_EDGE_V1;
    const taut_basis *basis = along_v ? taut_surface_v(surface) : taut_surface_u(surface);
    CHECK(taut_model_split_exact(model, "h", along_v ? TAUT_ALONG_V : TAUT_ALONG_U,
                                 high ? taut_basis_hi(basis) : taut_basis_lo(basis), &pieces,
                                 NULL) == TAUT_OK,
          "n=%d: split", n);
    CHECK(taut_model_surface_count(pieces) == 4, "n=%d: pieces", n);
    CHECK(same_texts(taut_model_surface(pieces, high ? 2 : 3), taut_model_surface(model, 0)) &&
              same_texts(taut_model_surface(pieces, high ? 3 : 2), taut_model_surface(model, 1)),
          "n=%d edge %d: the pieces are not what was merged", n, (int)problem.edge);
    taut_model_free(model);
    taut_model_free(pieces);
}

static void test_rows(void)
{
    static net g;
    for (int trial = 0; trial < random_trials(40); trial++) {
        const int m = random_int(1, 8), turned = trial % 2;
        const int n = m % 2 != 0 ? m + random_int(0, 1) : m + 1;
        taut_model *exact = NULL, *rounded = NULL;
        double largest = 0;
        start(&g, turned ? m : n, turned ? n : m, turned);
        const taut_harmonic_problem problem = problem_of(&g);
        CHECK(taut_harmonic_make(&problem, &exactly, &exact, NULL) == TAUT_OK, "m=%d", m);
        CHECK(taut_harmonic_make(&problem, NULL, &rounded, NULL) == TAUT_OK, "m=%d", m);
        const double amplification = detail_of(exact, "amplification");
        const double off =
            shape_apart(taut_model_surface(exact, 0), taut_model_surface(rounded, 0), &largest);
        /* the data is rounded before doubles are completed, and by its offset once more */
        CHECK(off <= 4 * 0x1p-53 * (1 + amplification) * 99 * 2, "m=%d n=%d: %.3g of %.3g", m, n,
              off, largest);
        CHECK(residual(exact) == 0, "m=%d", m);
        CHECK(taut_surface_exact(taut_model_surface(rounded, 0)) == NULL, "doubles have no texts");
        check_texts(taut_model_surface(exact, 0), "rows");
        check_extension(taut_model_surface(exact, 0), n);
        taut_model_free(exact);
        taut_model_free(rounded);
        end(&g);
    }
}

/* Even degree: each repair, and the last point left out. */
static void test_even(void)
{
    static net g;
    for (int m = 2; m <= 6; m += 2) {
        for (int even = TAUT_EVEN_REFUSE; even <= 4; even++) {
            taut_model *model = NULL;
            taut_error error;
            start(&g, m, m, 0);
            taut_harmonic_problem problem = problem_of(&g);
            g.known[(m + 1) * (m + 1) - 1] = even < 4;
            problem.rows.even = (taut_harmonic_even)(even % 4);
            const taut_status status = taut_harmonic_make(&problem, &exactly, &model, &error);
            CHECK(status == (even == TAUT_EVEN_REFUSE ? TAUT_NO_SOLUTION : TAUT_OK), "m=%d even=%d",
                  m, even);
            if (model != NULL) {
                const taut_surface *surface = taut_model_surface(model, 0);
                CHECK(taut_basis_degree(taut_surface_u(surface)) ==
                          (even == TAUT_EVEN_RAISE ? m + 1 : m),
                      "m=%d even=%d", m, even);
                CHECK(residual(model) == 0, "m=%d even=%d", m, even);
            }
            taut_model_free(model);
            end(&g);
        }
    }
}

/* From an edge and the derivative across it: the net of the rows it has. */
static void test_derivative(void)
{
    static net g;
    for (int m = 1; m <= 7; m++) {
        const int n = m % 2 != 0 ? m : m + 1;
        taut_model *model = NULL, *rounded = NULL;
        double largest = 0;
        start(&g, n, m, 0);
        taut_harmonic_problem problem = problem_of(&g);
        problem.given = TAUT_HARMONIC_DERIVATIVE;
        problem.derivative = (taut_harmonic_derivative){.edge = g.points,
                                                        .exact_edge = g.texts,
                                                        .cross = g.points + 3 * n * (m + 1),
                                                        .exact_cross = g.texts + 3 * n * (m + 1)};
        CHECK(taut_harmonic_make(&problem, &exactly, &model, NULL) == TAUT_OK, "m=%d", m);
        CHECK(taut_harmonic_make(&problem, NULL, &rounded, NULL) == TAUT_OK, "m=%d", m);
        const double grows = detail_of(rounded, "amplification");
        CHECK(residual(model) == 0, "m=%d", m);
        CHECK(shape_apart(taut_model_surface(model, 0), taut_model_surface(rounded, 0), &largest) <=
                  8 * 0x1p-53 * (1 + grows) * 99 * 4,
              "m=%d", m);
        check_texts(taut_model_surface(model, 0), "derivative");
        taut_model_free(model);
        taut_model_free(rounded);
        end(&g);
    }
}

int main(void)
{
    random_seed(20261124);
    test_rows();
    test_even();
    test_derivative();
    return check_failures != 0;
}
