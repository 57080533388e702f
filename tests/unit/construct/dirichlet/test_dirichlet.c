/* test_dirichlet.c -- the worked examples against exact rationals, and other closed forms. */
#include "certificates.h"
#include "check.h"
#include "problems.h"

#include <string.h>

static const char *text_of(const taut_model *model, const char *key)
{
    return taut_record_text(taut_record_get(taut_model_details(model), key));
}

/* An entry of the solution of an example: exact rational control points ([WuWang2011] section 4).
 */
typedef struct expected {
    int example, index;
    double point[3];
} expected;

static const expected solutions[] = {
    {1, 4, {0, 0, -0.5}},
    {2, 5, {-0.5, -0.5, 0.375}},
    {2, 6, {-0.5, 0.5, 0.375}},
    {2, 9, {0.5, -0.5, 0.375}},
    {2, 10, {0.5, 0.5, 0.375}},
    {3, 5, {-43.0 / 156, -43.0 / 156, 1.0 / 6}},
    {3, 6, {-43.0 / 156, 43.0 / 156, 1.0 / 6}},
    {3, 9, {43.0 / 156, -43.0 / 156, 1.0 / 6}},
    {3, 10, {43.0 / 156, 43.0 / 156, 1.0 / 6}},
    {4, 6, {-12907.0 / 38283, -409.0 / 546, 1576.0 / 6733}},
    {4, 7, {-13327.0 / 38283, 0, 9057.0 / 47131}},
    {4, 8, {-12907.0 / 38283, 409.0 / 546, 1576.0 / 6733}},
    {4, 11, {12907.0 / 38283, -409.0 / 546, 1576.0 / 6733}},
    {4, 12, {13327.0 / 38283, 0, 9057.0 / 47131}},
    {4, 13, {12907.0 / 38283, 409.0 / 546, 1576.0 / 6733}},
};

static void test_examples(void)
{
    for (size_t k = 0; k < sizeof solutions / sizeof *solutions; k++) {
        const expected *e = &solutions[k];
        test_problem problem = problem_example(e->example);
        const double *points = NULL;
        taut_model *model = problem_make(&problem, &points);
        for (int c = 0; model != NULL && c < 3; c++) {
            CHECK_NEAR(points[3 * e->index + c], e->point[c], 4e-15, "example %d point %d",
                       e->example, e->index);
        }
        taut_model_free(model);
        problem_free(&problem);
    }
}

/* Everything known: what came in goes out, and nothing is solved. */
static void test_nothing_unknown(void)
{
    test_problem problem = problem_example(1);
    const double *points = NULL;
    taut_model *model = NULL;
    memset(problem.known, 1, 9);
    problem.points[3 * 4 + 2] = 0.125;
    model = problem_make(&problem, &points);
    CHECK(memcmp(points, problem.points, 27 * sizeof(double)) == 0, "points");
    CHECK(strcmp(text_of(model, "method"), "none") == 0, "method %s", text_of(model, "method"));
    CHECK(strcmp(text_of(model, "known"), "all") == 0, "known %s", text_of(model, "known"));
    CHECK(detail_of(model, "unknowns") == 0, "unknowns");
    taut_model_free(model);
    problem_free(&problem);
}

/* Two points in a direction leave no interior: nothing to solve either ([WuWang2011] 2.1). */
static void test_thin(void)
{
    test_problem problem = problem_new(basis_uniform(1, 2), basis_uniform(3, 7));
    taut_model *model = NULL;
    problem_random_boundary(&problem);
    model = problem_make(&problem, NULL);
    CHECK(detail_of(model, "unknowns") == 0, "unknowns");
    taut_model_free(model);
    problem_free(&problem);
}

/* One known point, wherever: the surface is that point, bit for bit, at any size. */
static void test_one_point(void)
{
    static const double points[4][3] = {
        {1, 2, 3}, {1e300, -1e300, 5e299}, {-4e-310, 0, 2e-308}, {1e8 + 1, 0, 1e-8}};
    for (int trial = 0; trial < 40; trial++) {
        test_problem problem = problem_new(basis_uniform(2, 5), basis_uniform(3, 6));
        const int at = random_int(0, 29);
        const double *found = NULL;
        taut_model *model = NULL;
        problem.known[at] = 1;
        memcpy(problem.points + 3 * at, points[trial % 4], sizeof points[0]);
        model = problem_make(&problem, &found);
        for (int i = 0; found != NULL && i < 30; i++) {
            CHECK(memcmp(found + 3 * i, points[trial % 4], sizeof points[0]) == 0,
                  "trial %d point %d: %g %g %g", trial, i, found[3 * i], found[3 * i + 1],
                  found[3 * i + 2]);
        }
        taut_model_free(model);
        problem_free(&problem);
    }
}

/* Free edges: with only the edge u = 0 known the surface repeats it, x_u = 0; with u = 0 and u = 1
 * known and both linear precise, it is ruled straight between them. */
static void test_free_edges(void)
{
    test_problem problem = problem_new(basis_uniform(3, 6), basis_uniform(2, 5));
    const double *found = NULL;
    taut_model *model = NULL;
    for (int i = 0; i < 3 * 5; i++) {
        problem.points[i] = random_in(-1, 1);
        problem.points[3 * 25 + i] = problem.points[i];
    }
    memset(problem.known, 1, 5);
    model = problem_make(&problem, &found);
    CHECK(strcmp(text_of(model, "known"), "pattern") == 0, "known");
    CHECK(strcmp(text_of(model, "method"), "fast-diagonalisation") == 0, "method");
    /* D = 1/2 int |x_v|^2 + 1/2 int |x_u|^2 is not least at x_u = 0 only if the edge's own energy
     * could fall by leaving it: the free edge straightens. It can only fall. */
    for (int c = 0; c < 3; c++) {
        double near = 0, far = 0;
        for (int j = 1; j < 5; j++) {
            const double *first = found + 3 * j, *last = found + 3 * (25 + j);
            near += (first[c] - first[c - 3]) * (first[c] - first[c - 3]);
            far += (last[c] - last[c - 3]) * (last[c] - last[c - 3]);
        }
        CHECK(far <= near, "coordinate %d: %g > %g", c, far, near);
    }
    taut_model_free(model);
    problem_free(&problem);
}

/* The aspect of example 4 ([WuWang2011] 7.3): 1.03838616 with energy 4.425522. */
static void test_aspect(void)
{
    test_problem problem = problem_example(4);
    taut_model *model = NULL;
    problem.data.aspect_auto = 1;
    model = problem_make(&problem, NULL);
    CHECK_NEAR(detail_of(model, "aspect"), 1.03838616, 5e-9, "example 4");
    CHECK_NEAR(detail_of(model, "aspect_energy"), 4.425522, 5e-7, "example 4");
    taut_model_free(model);
    problem_free(&problem);
}

/* Enneper's surface on [-1/2, 1/2] x [0, 3/2] moved to the unit square: the best aspect is the
 * ratio 3/2 of the lengths, and the surface then is Enneper's, area 5.725 = D ([WuWang2011] 7.2).
 */
static void test_aspect_enneper(void)
{
    static const double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    const taut_basis_spec spec = {.type = "bspline", .degree = 3, .knot_count = 8, .knots = knots};
    taut_basis *u = NULL, *v = NULL;
    test_problem problem;
    taut_model *model = NULL;
    CHECK(taut_basis_new(&spec, 4, &u, NULL) == TAUT_OK, "u");
    CHECK(taut_basis_new(&spec, 4, &v, NULL) == TAUT_OK, "v");
    problem = problem_new(u, v);
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            /* blossoms of t, t^2, t^3 at three of the end knots */
            const double a[3] = {i < 3 ? -0.5 : 0.5, i < 2 ? -0.5 : 0.5, i < 1 ? -0.5 : 0.5};
            const double b[3] = {j < 3 ? 0 : 1.5, j < 2 ? 0 : 1.5, j < 1 ? 0 : 1.5};
            const double u1 = (a[0] + a[1] + a[2]) / 3, v1 = (b[0] + b[1] + b[2]) / 3;
            const double u2 = (a[0] * a[1] + a[1] * a[2] + a[2] * a[0]) / 3;
            const double v2 = (b[0] * b[1] + b[1] * b[2] + b[2] * b[0]) / 3;
            double *p = problem.points + 3 * (4 * i + j);
            p[0] = u1 - a[0] * a[1] * a[2] / 3 + u1 * v2;
            p[1] = -v1 - u2 * v1 + b[0] * b[1] * b[2] / 3;
            p[2] = u2 - v2;
            problem.known[4 * i + j] = i == 0 || i == 3 || j == 0 || j == 3;
        }
    }
    problem.data.aspect_auto = 1;
    model = problem_make(&problem, NULL);
    CHECK_NEAR(detail_of(model, "aspect"), 1.5, 1e-13, "lengths 1 and 1.5");
    CHECK_NEAR(detail_of(model, "aspect_energy"), 5.725, 1e-13, "area of the patch");
    taut_model_free(model);
    problem_free(&problem);
}

/* Where the surface is a curve no aspect is best; where it is a point every one is. */
static void test_aspect_degenerate(void)
{
    test_problem problem = problem_new(basis_uniform(2, 4), basis_uniform(2, 5));
    taut_model *model = NULL;
    taut_error error = {0};
    problem.data.aspect_auto = 1;
    problem_random_boundary(&problem);
    memset(problem.points, 0, 60 * sizeof(double));
    model = problem_make(&problem, NULL);
    CHECK(detail_of(model, "aspect") == 1, "aspect %g", detail_of(model, "aspect"));
    taut_model_free(model);
    model = NULL;
    for (int i = 0; i < 20; i++) {
        problem.points[3 * i] = (double)(i / 5) / 7;
    }
    CHECK(taut_dirichlet_make(&problem.data, NULL, &model, &error) == TAUT_NO_SOLUTION, "curve");
    CHECK(strcmp(error.reason, "no-best-aspect") == 0, "%s: %s", error.reason, error.message);
    CHECK(model == NULL, "the output is untouched on failure");
    problem_free(&problem);
}

/* The c- and h- bases, all pairs: quadrature there is not exact, and the certificate's own is
 * another. */
static void test_other_bases(void)
{
    static const char *const types[4] = {"c-bezier", "h-bezier", "c-bspline", "h-bspline"};
    for (int k = 0; k < 16; k++) {
        taut_basis *bases[2] = {NULL, NULL};
        test_problem problem;
        const double *found = NULL;
        taut_model *model = NULL;
        for (int d = 0; d < 2; d++) {
            const char *type = types[d == 0 ? k % 4 : k / 4];
            taut_basis_spec spec = {.type = type};
            *(type[0] == 'c' ? &spec.alpha : &spec.beta) = random_in(0.3, 3);
            spec.segments = strstr(type, "bspline") != NULL ? 4 : 0;
            CHECK(taut_basis_new(&spec, 0, &bases[d], NULL) == TAUT_OK, "%s", type);
        }
        problem = problem_new(bases[0], bases[1]);
        problem_random_boundary(&problem);
        model = problem_make(&problem, &found);
        taut_certificate *certificate = NULL;
        CHECK(taut_dirichlet_certify(model, &problem.data, NULL, &certificate, NULL) == TAUT_OK,
              "certify");
        CHECK(taut_certificate_holds(certificate) == TAUT_TRUE, "%s, %s: residual %g",
              taut_basis_type(bases[0]), taut_basis_type(bases[1]),
              taut_certificate_claim(certificate, 0)->residual);
        taut_certificate_free(certificate);
        taut_model_free(model);
        problem_free(&problem);
    }
}

/* Coefficient i of t^k in the Bernstein basis of degree d on [0, 1]: C(i, k) / C(d, k). */
static double power(int d, int i, int k)
{
    double value = 1;
    for (int m = 0; m < k; m++) {
        value *= (double)(i - m) / (d - m);
    }
    return value;
}

/* One patch of high degree: its matrices are too ill-conditioned to be diagonalised from degree 16
 * on, its points hardly matter one by one, its surface does. Re (u + i v)^3 = u^3 - 3 u v^2 is
 * harmonic, so it is the solution for its boundary; errors seen in the surface are 1e-14 to 2e-10,
 * the worst at degree 18 to 20.
 */
static void test_high_degree(void)
{
    for (int d = 10; d <= 20; d += 2) {
        const taut_basis_spec spec = {.type = "bezier", .degree = d};
        taut_basis *u = NULL, *v = NULL;
        test_problem problem;
        taut_model *model = NULL;
        CHECK(taut_basis_new(&spec, 0, &u, NULL) == TAUT_OK, "degree %d", d);
        CHECK(taut_basis_new(&spec, 0, &v, NULL) == TAUT_OK, "degree %d", d);
        problem = problem_new(u, v);
        problem_random_boundary(&problem);
        for (int i = 0; i <= d; i++) {
            for (int j = 0; j <= d; j++) {
                double *p = problem.points + 3 * (i * (d + 1) + j);
                p[0] = power(d, i, 1);
                p[1] = power(d, j, 1);
                p[2] = power(d, i, 3) - 3 * power(d, i, 1) * power(d, j, 2);
            }
        }
        model = problem_make(&problem, NULL);
        for (int k = 0; model != NULL && k < 50; k++) {
            const double s = random_in(0, 1), t = random_in(0, 1);
            double x[3];
            CHECK(taut_surface_eval(taut_model_surface(model, 0), s, t, 0, x) == TAUT_OK, "eval");
            CHECK_NEAR(x[2], s * s * s - 3 * s * t * t, 2e-9, "degree %d at %g %g, %s", d, s, t,
                       text_of(model, "method"));
        }
        taut_model_free(model);
        problem_free(&problem);
    }
}

/* Weights that differ by decades from point to point make rows of the matrix differ by their
 * squares: the preconditioner knows of it. Where they ask for too many nodes it is said, at once.
 */
static void test_wild_weights(void)
{
    static const int sizes[2] = {8, 64};
    static const double limits[2] = {1e2, 1e6};
    for (int k = 0; k < 2; k++) {
        test_problem problem = problem_new(basis_uniform(3, sizes[k]), basis_uniform(3, sizes[k]));
        taut_model *model = NULL;
        taut_error error = {0};
        problem_random_boundary(&problem);
        problem_random_weights(&problem, limits[k]);
        const taut_status status = taut_dirichlet_make(&problem.data, NULL, &model, &error);
        if (k == 0) {
            CHECK(status == TAUT_OK, "%s", error.message);
            CHECK(detail_of(model, "iterations") < 300, "%g iterations",
                  detail_of(model, "iterations"));
        } else {
            CHECK(status == TAUT_NOT_CONVERGED && strcmp(error.where, "/weights") == 0, "%s %s",
                  error.where, error.message);
        }
        taut_model_free(model);
        problem_free(&problem);
    }
}

/* Example 4 with u and v exchanged has the other aspect, and the same energy. */
static void test_aspect_turned(void)
{
    test_problem given = problem_example(4);
    test_problem turned = problem_new(basis_uniform(3, 5), basis_uniform(3, 4));
    taut_model *model = NULL;
    for (int k = 0; k < 20; k++) {
        const int at = k % 5 * 4 + k / 5;
        turned.known[at] = given.known[k];
        memcpy(turned.points + 3 * at, given.points + 3 * k, 3 * sizeof(double));
    }
    turned.data.aspect_auto = 1;
    model = problem_make(&turned, NULL);
    CHECK_NEAR(detail_of(model, "aspect"), 1 / 1.03838616, 5e-9, "example 4, turned");
    CHECK_NEAR(detail_of(model, "aspect_energy"), 4.425522, 5e-7, "example 4, turned");
    taut_model_free(model);
    problem_free(&given);
    problem_free(&turned);
}

int main(void)
{
    random_seed(20260303);
    test_aspect_turned();
    test_high_degree();
    test_wild_weights();
    test_examples();
    test_nothing_unknown();
    test_thin();
    test_one_point();
    test_free_edges();
    test_aspect();
    test_aspect_enneper();
    test_aspect_degenerate();
    test_other_bases();
    return check_failures != 0;
}
