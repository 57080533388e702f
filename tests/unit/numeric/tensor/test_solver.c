/* The tensor-product solver: residuals in twice the working precision, sizes and widths of all
 * kinds, refusals. */
#include "check.h"
#include "gram.h"

#include "numeric/tensor/apply.h"
#include "numeric/tensor/solver.h"

#include <stdlib.h>
#include <string.h>

typedef struct axis {
    int n, degree;
    taut_band k, m;
    char label[64];
} axis;

/* Gram matrices of n functions: clamped ends left out, or at a free end (is_free bit 1: start, 2:
 * end) kept. */
static axis axis_make(gram_knots kind, int degree, int n, unsigned seed, int is_free)
{
    const int first = is_free & 1 ? 0 : 1, count = n + first + (is_free & 2 ? 0 : 1);
    axis a = {.n = n, .degree = degree};
    double *knots = malloc((size_t)(count + degree + 1) * sizeof *knots);
    gram_knots_make(kind, degree, count, seed, knots);
    CHECK(gram_make(degree, count, knots, first, first + n - 1, &a.k, &a.m), "memory");
    free(knots);
    snprintf(a.label, sizeof a.label, "%s degree=%d n=%d free=%d", gram_names[kind], degree, n,
             is_free);
    return a;
}

static void axis_clear(axis *a)
{
    taut_band_clear(&a->k);
    taut_band_clear(&a->m);
}

/* |A| for the bound on rounding errors. */
static void take_absolute(axis *a)
{
    for (int i = 0; i < a->n * (a->degree + 1); i++) {
        a->k.a[i] = fabs(a->k.a[i]);
        a->m.a[i] = fabs(a->m.a[i]);
    }
}

static double norm(size_t count, const double *x)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; i++) {
        sum += x[i] * x[i];
    }
    return sqrt(sum);
}

static double *random_net(size_t count)
{
    double *x = malloc(count * sizeof *x);
    for (size_t i = 0; i < count; i++) {
        x[i] = random_in(-1.0, 1.0);
    }
    return x;
}

/* A right-hand side as boundary values make it: zero but for `frame` rows and columns along the
 * edges. */
static void keep_frame(int nu, int nv, int nrhs, int frame, double *x)
{
    for (int i = frame; i < nu - frame; i++) {
        for (int j = frame; j < nv - frame; j++) {
            memset(x + ((size_t)i * (size_t)nv + (size_t)j) * (size_t)nrhs, 0,
                   (size_t)nrhs * sizeof *x);
        }
    }
}

/* || |A| |X| || in units of ||R||: what rounding X alone can leave as a residual, times u. */
static double natural(axis u, axis v, double su, double sv, int nrhs, const double *x, double right)
{
    const size_t count = (size_t)u.n * (size_t)v.n * (size_t)nrhs;
    double *absolute = malloc(count * sizeof *absolute), *product = malloc(count * sizeof *product);
    axis a[2] = {u, v};
    for (int d = 0; d < 2; d++) {
        const axis *from = d == 0 ? &u : &v;
        CHECK(taut_band_widen(&from->k, from->degree, &a[d].k) == TAUT_OK, "memory");
        CHECK(taut_band_widen(&from->m, from->degree, &a[d].m) == TAUT_OK, "memory");
        take_absolute(&a[d]);
    }
    for (size_t i = 0; i < count; i++) {
        absolute[i] = fabs(x[i]);
    }
    const taut_tensor tensor = {&a[0].k, &a[0].m, &a[1].k, &a[1].m, su, sv, NULL};
    CHECK(taut_tensor_apply(&tensor, nrhs, absolute, product) == TAUT_OK, "memory");
    const double size = norm(count, product);
    axis_clear(&a[0]);
    axis_clear(&a[1]);
    free(absolute);
    free(product);
    return size / right;
}

/* Solves for a random right-hand side, or for a frame when frame > 0, and checks the residual: at
 * once to a modest multiple of what rounding leaves, after one refinement to the accuracy promised.
 */
static void check_solve(axis u, axis v, double su, double sv, int nrhs, int frame)
{
    const size_t count = (size_t)u.n * (size_t)v.n * (size_t)nrhs;
    const taut_tensor tensor = {&u.k, &u.m, &v.k, &v.m, su, sv, NULL};
    double *right = random_net(count), *x = malloc(count * sizeof *x),
           *r = malloc(count * sizeof *r);
    if (frame > 0) {
        keep_frame(u.n, v.n, nrhs, frame, right);
    }
    memcpy(x, right, count * sizeof *x);
    taut_tensor_solver *solver = NULL;
    const taut_status status =
        taut_tensor_solver_new(&u.k, &u.m, &v.k, &v.m, su, sv, NULL, &solver);
    CHECK(status == TAUT_OK, "%s x %s: %d", u.label, v.label, (int)status);
    if (status == TAUT_OK) {
        double first = 0.0, before = 0.0, after = 0.0;
        CHECK(taut_tensor_solver_solve(solver, nrhs, x) == TAUT_OK, "solve");
        CHECK(taut_tensor_residual(&tensor, nrhs, right, x, r, &first) == TAUT_OK, "residual");
        const double floor = 0x1p-53 * natural(u, v, su, sv, nrhs, x, norm(count, right));
        CHECK(first <= 64 * floor + 64 * 0x1p-53,
              "%s x %s su=%g sv=%g: residual %.2e, rounding %.2e", u.label, v.label, su, sv, first,
              floor);
        CHECK(taut_tensor_solver_refine(solver, nrhs, right, x, &before) == TAUT_OK, "refine");
        CHECK(taut_tensor_residual(&tensor, nrhs, right, x, r, &after) == TAUT_OK, "residual");
        CHECK(before == first, "%s x %s: refine reports %.17g for %.17g", u.label, v.label, before,
              first);
        /* 5e-15, or where rounding the exact X leaves more, that */
        CHECK(after <= fmax(5e-15, floor), "%s x %s su=%g sv=%g: refined %.2e, rounding %.2e",
              u.label, v.label, su, sv, after, floor);
    }
    taut_tensor_solver_free(solver);
    free(right);
    free(x);
    free(r);
}

static void test_residuals(void)
{
    const int sizes[] = {3, 5, 12, 24, 49, 61};
    for (int kind = 0; kind < GRAM_KINDS; kind++) {
        for (int degree = 1; degree <= 7; degree++) {
            for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
                if (sizes[s] + 2 > degree) {
                    axis a = axis_make((gram_knots)kind, degree, sizes[s],
                                       (unsigned)random_int(1, 1000), 0);
                    check_solve(a, a, 1.0, 1.0, 3, 0);
                    check_solve(a, a, 1.0, 1.0, 3, degree);
                    axis_clear(&a);
                }
            }
        }
    }
}

static void test_large(void)
{
    for (int kind = 0; kind < GRAM_KINDS; kind++) {
        axis a = axis_make((gram_knots)kind, 3, kind == GRAM_UNIFORM ? 400 : 200, 5, 0);
        check_solve(a, a, 1.0, 1.0, 3, 3);
        axis_clear(&a);
    }
}

/* The largest net that is promised, on every kind of knots that is harder than random ones; a
 * degree each. Sanitizers see a quarter of it. */
static void test_largest(void)
{
    static const struct {
        gram_knots kind;
        int degree, n;
    } cases[] = {{GRAM_UNIFORM, 3, 1600}, {GRAM_GRADED, 4, 1600}, {GRAM_REPEATED, 2, 800}};
    for (size_t c = 0; c < sizeof cases / sizeof cases[0]; c++) {
        axis a = axis_make(cases[c].kind, cases[c].degree, random_trials(cases[c].n), 5, 0);
        check_solve(a, a, 1.0, 1.0, 1, cases[c].degree);
        axis_clear(&a);
    }
}

/* From 500 on, right-hand sides that live along the edges go another way: with modes of both
 * directions, alike or not, mirrored or not, whose tails end at once or reach across. */
static void test_frames(void)
{
    axis even = axis_make(GRAM_UNIFORM, 3, 501, 0, 0), odd = axis_make(GRAM_UNIFORM, 2, 512, 0, 0);
    axis graded = axis_make(GRAM_GRADED, 3, 500, 0, 0),
         loose = axis_make(GRAM_RANDOM, 5, 504, 7, 3);
    check_solve(even, even, 1.0, 1.0, 3, 3);
    check_solve(even, odd, 1.0, 20.0, 1, 2);
    check_solve(graded, odd, 0.1, 1.0, 2, 2);
    check_solve(loose, even, 1.0, 1e-6, 1, 3);
    axis_clear(&even);
    axis_clear(&odd);
    axis_clear(&graded);
    axis_clear(&loose);
}

/* Two directions of different size, degree, knots, ends and weight; any number of coordinates. */
static void test_mixed_directions(void)
{
    for (int trial = 0; trial < 300; trial++) {
        const int degree_u = random_int(1, 7), degree_v = random_int(1, 7);
        const int nu = random_int(degree_u, 40), nv = random_int(degree_v + 1, 40);
        axis u =
            axis_make((gram_knots)random_int(0, GRAM_KINDS - 1), degree_u, nu, (unsigned)trial, 0);
        axis v = axis_make((gram_knots)random_int(0, GRAM_KINDS - 1), degree_v, nv,
                           (unsigned)trial + 7, random_int(0, 3));
        const int flip = random_int(0, 1);
        check_solve(flip ? v : u, flip ? u : v, random_log(1e-3, 1e3), random_log(1e-3, 1e3),
                    random_int(1, 5), random_int(0, 2));
        axis_clear(&u);
        axis_clear(&v);
    }
}

/* One row, one column, one point. */
static void test_thin_nets(void)
{
    axis one = axis_make(GRAM_UNIFORM, 2, 1, 0, 0), many = axis_make(GRAM_RANDOM, 3, 17, 3, 0);
    check_solve(one, one, 1.0, 2.0, 3, 0);
    check_solve(one, many, 1.0, 2.0, 3, 0);
    check_solve(many, one, 1.0, 2.0, 3, 0);
    axis_clear(&one);
    axis_clear(&many);
}

/* apply against the definition, entry by entry. */
static void test_apply(void)
{
    axis u = axis_make(GRAM_RANDOM, 3, 6, 1, 2), v = axis_make(GRAM_GRADED, 2, 5, 2, 0);
    const taut_tensor tensor = {&u.k, &u.m, &v.k, &v.m, 0.7, 1.3, NULL};
    double *x = random_net(6 * 5 * 2), y[6 * 5 * 2];
    CHECK(taut_tensor_apply(&tensor, 2, x, y) == TAUT_OK, "apply");
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 5; j++) {
            for (int c = 0; c < 2; c++) {
                double sum = 0.0, size = 0.0;
                for (int s = 0; s < 6; s++) {
                    for (int t = 0; t < 5; t++) {
                        const double a = 0.7 * taut_band_at(&u.k, i, s) * taut_band_at(&v.m, j, t) +
                                         1.3 * taut_band_at(&u.m, i, s) * taut_band_at(&v.k, j, t);
                        sum += a * x[(s * 5 + t) * 2 + c];
                        size += fabs(a);
                    }
                }
                CHECK_NEAR(y[(i * 5 + j) * 2 + c], sum, 40 * 0x1p-53 * size, "i=%d j=%d c=%d", i, j,
                           c);
            }
        }
    }
    free(x);
    axis_clear(&u);
    axis_clear(&v);
}

/* Rescaled, a solver gives what a new one gives, to the last bit. */
static void test_rescale(void)
{
    axis u = axis_make(GRAM_MIRRORED, 3, 30, 4, 0), v = axis_make(GRAM_RANDOM, 4, 22, 5, 0);
    taut_tensor_solver *a = NULL, *b = NULL;
    double *x = random_net(30 * 22 * 3), *y = malloc(30 * 22 * 3 * sizeof *y);
    memcpy(y, x, 30 * 22 * 3 * sizeof *y);
    CHECK(taut_tensor_solver_new(&u.k, &u.m, &v.k, &v.m, 1.0, 1.0, NULL, &a) == TAUT_OK, "new");
    CHECK(taut_tensor_solver_new(&u.k, &u.m, &v.k, &v.m, 3.0, 0.2, NULL, &b) == TAUT_OK, "new");
    CHECK(taut_tensor_solver_rescale(a, 3.0, 0.2) == TAUT_OK, "rescale");
    CHECK(taut_tensor_solver_rescale(a, -1.0, 0.2) == TAUT_BAD_ARGUMENT, "negative weight");
    CHECK(taut_tensor_solver_solve(a, 3, x) == TAUT_OK &&
              taut_tensor_solver_solve(b, 3, y) == TAUT_OK,
          "solve");
    CHECK(memcmp(x, y, 30 * 22 * 3 * sizeof *y) == 0, "rescaled solver differs");
    taut_tensor_solver_free(a);
    taut_tensor_solver_free(b);
    free(x);
    free(y);
    axis_clear(&u);
    axis_clear(&v);
}

/* Solved, applied and looked at by any number of threads: the same bits. frame: as of check_solve. */
static void check_threads(axis u, axis v, int nrhs, int frame)
{
    const size_t count = (size_t)u.n * (size_t)v.n * (size_t)nrhs;
    double *right = random_net(count), *x[3][3], norms[3] = {0};

    if (frame > 0) {
        keep_frame(u.n, v.n, nrhs, frame, right);
    }
    for (int k = 0; k < 3; k++) {
        const taut_crew crew = {k == 2 ? 5 : k + 1, NULL};
        const taut_tensor tensor = {&u.k, &u.m, &v.k, &v.m, 1.5, 0.25, &crew};
        taut_tensor_solver *solver = NULL;
        for (int i = 0; i < 3; i++) {
            x[k][i] = malloc(count * sizeof(double));
        }
        memcpy(x[k][0], right, count * sizeof(double));
        CHECK(taut_tensor_solver_new(&u.k, &u.m, &v.k, &v.m, 1.5, 0.25, &crew, &solver) == TAUT_OK,
              "new");
        CHECK(taut_tensor_solver_solve(solver, nrhs, x[k][0]) == TAUT_OK, "solve");
        CHECK(taut_tensor_apply(&tensor, nrhs, right, x[k][1]) == TAUT_OK, "apply");
        CHECK(taut_tensor_residual(&tensor, nrhs, right, x[k][0], x[k][2], &norms[k]) == TAUT_OK,
              "residual");
        taut_tensor_solver_free(solver);
        for (int i = 0; i < 3; i++) {
            CHECK(memcmp(x[0][i], x[k][i], count * sizeof(double)) == 0,
                  "%s x %s, %d: %d threads differ", u.label, v.label, i, crew.threads);
        }
        CHECK(norms[k] == norms[0], "the norm by %d threads", crew.threads);
    }
    for (int k = 0; k < 9; k++) {
        free(x[k / 3][k % 3]);
    }
    free(right);
}

static void test_threads(void)
{
    axis a = axis_make(GRAM_MIRRORED, 3, 131, 6, 0), b = axis_make(GRAM_RANDOM, 5, 197, 7, 0);
    axis c = axis_make(GRAM_MIRRORED, 3, 520, 8, 0), d = axis_make(GRAM_MIRRORED, 2, 510, 9, 0);

    check_threads(a, b, 3, 0);
    check_threads(b, a, 1, 0);
    check_threads(c, d, 1, 2); /* zero but along the edges */
    axis_clear(&a);
    axis_clear(&b);
    axis_clear(&c);
    axis_clear(&d);
}

/* Free on all four sides: constants are in the kernel. One side held is enough. */
static void test_singular(void)
{
    for (int degree = 1; degree <= 7; degree += 2) {
        for (int n = 8; n <= 100; n *= 4) {
            for (int kind = 0; kind < GRAM_KINDS; kind++) {
                axis loose = axis_make((gram_knots)kind, degree, n, 6, 3);
                axis held = axis_make((gram_knots)kind, degree, n, 6, 1);
                taut_tensor_solver *solver = NULL;
                CHECK(taut_tensor_solver_new(&loose.k, &loose.m, &loose.k, &loose.m, 1.0, 1.0, NULL,
                                             &solver) == TAUT_NO_SOLUTION &&
                          solver == NULL,
                      "%s", loose.label);
                check_solve(loose, held, 1.0, 1.0, 1, 0);
                check_solve(held, loose, 1.0, 1.0, 1, 0);
                axis_clear(&loose);
                axis_clear(&held);
            }
        }
    }
}

static void test_refusals(void)
{
    axis u = axis_make(GRAM_UNIFORM, 3, 8, 0, 0);
    taut_tensor_solver *solver = NULL;
    taut_band negative;
    CHECK(taut_band_widen(&u.k, 3, &negative) == TAUT_OK, "memory");
    for (int i = 0; i < 8 * 4; i++) {
        negative.a[i] = -negative.a[i];
    }
    CHECK(taut_tensor_solver_new(&negative, &u.m, &u.k, &u.m, 9.0, 1.0, NULL, &solver) ==
              TAUT_NO_SOLUTION,
          "indefinite");
    CHECK(taut_tensor_solver_new(&u.k, &negative, &u.k, &u.m, 1.0, 1.0, NULL, &solver) ==
              TAUT_NO_SOLUTION,
          "mass");
    CHECK(taut_tensor_solver_new(&u.k, &u.m, &u.k, &negative, 1.0, 1.0, NULL, &solver) ==
              TAUT_NO_SOLUTION,
          "mass");
    CHECK(taut_tensor_solver_new(&u.k, &u.m, &u.k, &u.m, 0.0, 1.0, NULL, &solver) ==
              TAUT_BAD_ARGUMENT,
          "weight");
    CHECK(taut_tensor_solver_new(&u.k, &u.m, &u.k, &u.m, 1.0, nan(""), NULL, &solver) ==
              TAUT_BAD_ARGUMENT,
          "weight");
    CHECK(taut_tensor_solver_new(&u.k, NULL, &u.k, &u.m, 1.0, 1.0, NULL, &solver) ==
              TAUT_BAD_ARGUMENT,
          "none");
    CHECK(solver == NULL, "outputs are untouched on failure");
    CHECK(taut_tensor_solver_solve(NULL, 1, u.k.a) == TAUT_BAD_ARGUMENT, "no solver");
    taut_band_clear(&negative);
    axis_clear(&u);
}

int main(void)
{
    random_seed(14);
    test_apply();
    test_thin_nets();
    test_residuals();
    test_mixed_directions();
    test_large();
    test_largest();
    test_frames();
    test_rescale();
    test_threads();
    test_singular();
    test_refusals();
    return check_failures != 0;
}
