/* test_dirichlet.c -- two routes to one surface over random legal problems.
 * links: lapacke */
#include "certificates.h"
#include "check.h"
#include "problems.h"

#include "core/constants.h"
#include "geometry/nurbs/gram.h"
#include "taut/measure.h"

#include <lapacke.h>
#include <stdlib.h>
#include <string.h>

static size_t count_of(const test_problem *problem)
{
    return (size_t)taut_basis_count(problem->u) * (size_t)taut_basis_count(problem->v);
}

/* max |a - b| over all coordinates. */
static double apart(size_t count, const double *a, const double *b)
{
    double largest = 0;
    for (size_t i = 0; i < 3 * count; i++) {
        largest = fmax(largest, fabs(a[i] - b[i]));
    }
    return largest;
}

static double size_of(size_t count, const double *a)
{
    double largest = 0;
    for (size_t i = 0; i < 3 * count; i++) {
        largest = fmax(largest, fabs(a[i]));
    }
    return largest;
}

/* Makes both and compares: the second's points must be map(first's). */
static void compare(const test_problem *first, const test_problem *second,
                    void (*map)(const double *from, double *to, const void *data), const void *data,
                    double tolerance, const char *what)
{
    const size_t count = count_of(first);
    const double *a = NULL, *b = NULL;
    taut_model *one = problem_make(first, &a), *two = problem_make(second, &b);
    double *mapped = malloc(3 * count * sizeof(double));
    for (size_t i = 0; i < count && a != NULL; i++) {
        map(a + 3 * i, mapped + 3 * i, data);
    }
    if (a != NULL && b != NULL) {
        const double size = size_of(count, mapped);
        CHECK_NEAR(apart(count, mapped, b), 0, tolerance * size, "%s: %d x %d, degrees %d, %d",
                   what, taut_basis_count(first->u), taut_basis_count(first->v),
                   taut_basis_degree(first->u), taut_basis_degree(first->v));
    }
    free(mapped);
    taut_model_free(one);
    taut_model_free(two);
}

static test_problem random_problem(int degree_max, int count_max)
{
    test_problem problem =
        problem_new(basis_random(degree_max, count_max), basis_random(degree_max, count_max));
    problem_random_boundary(&problem);
    return problem;
}

static test_problem copy_of(const test_problem *from)
{
    taut_basis *u = NULL, *v = NULL;
    test_problem copy;
    CHECK(taut_basis_copy(from->u, &u) == TAUT_OK && taut_basis_copy(from->v, &v) == TAUT_OK,
          "copy");
    copy = problem_new(u, v);
    memcpy(copy.points, from->points, 3 * count_of(from) * sizeof(double));
    memcpy(copy.known, from->known, count_of(from));
    return copy;
}

/* x -> A x + b */
typedef struct affine {
    double a[3][3], b[3];
} affine;

static void apply_affine(const double *from, double *to, const void *data)
{
    const affine *map = data;
    for (int c = 0; c < 3; c++) {
        to[c] =
            map->a[c][0] * from[0] + map->a[c][1] * from[1] + map->a[c][2] * from[2] + map->b[c];
    }
}

/* The system is linear, the same for each coordinate, and blind to translation: any affine map of
 * the known points maps the solution ([WuWang2011] 2.4). Errors are those of well conditioned
 * solves: a few hundred roundings of the size of the points. */
static void test_affine(void)
{
    for (int trial = 0; trial < 150; trial++) {
        test_problem problem = random_problem(7, 14), moved = copy_of(&problem);
        affine map;
        for (int c = 0; c < 9; c++) {
            map.a[c / 3][c % 3] = random_in(-2, 2);
        }
        for (int c = 0; c < 3; c++) {
            map.b[c] = random_in(-5, 5);
        }
        for (size_t i = 0; i < count_of(&problem); i++) {
            apply_affine(problem.points + 3 * i, moved.points + 3 * i, &map);
        }
        compare(&problem, &moved, apply_affine, &map, 1e-12, "affine");
        problem_free(&problem);
        problem_free(&moved);
    }
}

static void scale_by(const double *from, double *to, const void *data)
{
    for (int c = 0; c < 3; c++) {
        to[c] = *(const double *)data * from[c];
    }
}

/* Powers of two scale the solution bit for bit, as far as doubles reach. */
static void test_scale(void)
{
    const double factors[4] = {0x1p600, 0x1p-600, 0x1p1000, 0x1p-900};
    for (int trial = 0; trial < 40; trial++) {
        const double factor = factors[trial % 4];
        test_problem problem = random_problem(5, 12), scaled = copy_of(&problem);
        for (size_t i = 0; i < 3 * count_of(&problem); i++) {
            scaled.points[i] *= factor;
        }
        compare(&problem, &scaled, scale_by, &factor, 0, "scale");
        problem_free(&problem);
        problem_free(&scaled);
    }
}

static void keep(const double *from, double *to, const void *data)
{
    (void)data;
    memcpy(to, from, 3 * sizeof(double));
}

/* The basis with its knots k -> shift + factor k, exactly. */
static taut_basis *stretched(const taut_basis *basis, double factor, double shift)
{
    double knots[1024];
    taut_basis_spec spec;
    taut_basis *made = NULL;
    taut_basis_spec_of(basis, &spec);
    for (int i = 0; i < spec.knot_count; i++) {
        knots[i] = shift + factor * spec.knots[i];
    }
    spec.knots = knots;
    CHECK(taut_basis_new(&spec, taut_basis_count(basis), &made, NULL) == TAUT_OK, "stretched");
    return made;
}

/* Both knot vectors times the same number change nothing; different ones, together with the aspect
 * that undoes them, neither ([WuWang2011] 2.4, 7.3). Powers of two, so that the knots are exact. */
static void test_knot_scaling(void)
{
    for (int trial = 0; trial < 80; trial++) {
        test_problem problem = random_problem(6, 12), other;
        const double fu = ldexp(1, random_int(-40, 40)), fv = ldexp(1, random_int(-40, 40));
        other = problem_new(stretched(problem.u, fu, 0), stretched(problem.v, fv, 0));
        memcpy(other.points, problem.points, 3 * count_of(&problem) * sizeof(double));
        memcpy(other.known, problem.known, count_of(&problem));
        problem.data.aspect = 0.7;
        other.data.aspect = 0.7 * fu / fv;
        compare(&problem, &other, keep, NULL, 1e-12, "knot scaling");
        problem_free(&problem);
        problem_free(&other);
    }
}

/* u and v change places. */
static void test_transpose(void)
{
    for (int trial = 0; trial < 80; trial++) {
        test_problem problem = random_problem(6, 12), other;
        const int nu = taut_basis_count(problem.u), nv = taut_basis_count(problem.v);
        const double *a = NULL, *b = NULL;
        taut_model *one = NULL, *two = NULL;
        other = problem_new(stretched(problem.v, 1, 0), stretched(problem.u, 1, 0));
        for (int i = 0; i < nu; i++) {
            for (int j = 0; j < nv; j++) {
                memcpy(other.points + 3 * (j * nu + i), problem.points + 3 * (i * nv + j),
                       3 * sizeof(double));
                other.known[j * nu + i] = problem.known[i * nv + j];
            }
        }
        one = problem_make(&problem, &a);
        two = problem_make(&other, &b);
        for (int i = 0; a != NULL && b != NULL && i < nu; i++) {
            for (int j = 0; j < nv; j++) {
                CHECK_NEAR(apart(1, a + 3 * (i * nv + j), b + 3 * (j * nu + i)), 0,
                           1e-12 * size_of(count_of(&problem), a), "transpose %d %d", i, j);
            }
        }
        taut_model_free(one);
        taut_model_free(two);
        problem_free(&problem);
        problem_free(&other);
    }
}

/* The blossom of t^k at p knots is their elementary symmetric mean: the coefficient of t^k on the
 * function whose inner knots they are ([PieglTiller1997] ch. 5; [Farin2002]). */
static double coefficient(const double *knots, int p, int k)
{
    double e[16] = {1};
    double choose = 1;
    for (int i = 0; i < p; i++) {
        for (int m = i + 1; m > 0; m--) {
            e[m] += knots[i] * e[m - 1];
        }
    }
    for (int i = 1; i <= k; i++) {
        choose *= (double)(p - k + i) / i;
    }
    return e[k] / choose;
}

/* Re and Im of (u + i v)^m have the coefficients sum_k C(m,k) i^k [u^(m-k)] [v^k]. */
static void harmonic(const double *ku, int pu, const double *kv, int pv, int m, double value[2])
{
    double choose = 1;
    value[0] = value[1] = 0;
    for (int k = 0; k <= m; k++) {
        const double term = choose * coefficient(ku, pu, m - k) * coefficient(kv, pv, k);
        value[k % 2] += (k % 4 < 2 ? 1 : -1) * term;
        choose *= (double)(m - k) / (k + 1);
    }
}

/* A harmonic surface in the spline space is the answer to its own boundary ([WuWang2011] 2.4):
 * degrees 2 to 7, uniform, random, graded and repeated knots. The errors seen there are 2e-15 to
 * 4e-12 of the size. */
static void test_harmonic(void)
{
    for (int trial = 0; trial < 300; trial++) {
        test_problem problem;
        taut_basis_spec u, v;
        taut_basis *bu = NULL, *bv = NULL;
        do {
            taut_basis_free(bu);
            bu = basis_random(7, 16);
        } while (taut_basis_degree(bu) < 2);
        do {
            taut_basis_free(bv);
            bv = basis_random(7, 16);
        } while (taut_basis_degree(bv) < 2);
        taut_basis_spec_of(bu, &u);
        taut_basis_spec_of(bv, &v);
        const double length =
            1 / fmax(taut_basis_hi(bu) - taut_basis_lo(bu), taut_basis_hi(bv) - taut_basis_lo(bv));
        problem = problem_new(stretched(bu, length, -length * taut_basis_lo(bu)),
                              stretched(bv, length, -length * taut_basis_lo(bv)));
        taut_basis_spec_of(problem.u, &u);
        taut_basis_spec_of(problem.v, &v);
        problem_random_boundary(&problem);
        const int nv = taut_basis_count(bv), least = u.degree < v.degree ? u.degree : v.degree;
        double *exact = malloc(3 * count_of(&problem) * sizeof(double));
        for (size_t i = 0; i < count_of(&problem); i++) {
            double value[2], other[2];
            harmonic(u.knots + i / (size_t)nv + 1, u.degree, v.knots + i % (size_t)nv + 1, v.degree,
                     least, value);
            harmonic(u.knots + i / (size_t)nv + 1, u.degree, v.knots + i % (size_t)nv + 1, v.degree,
                     1, other);
            exact[3 * i] = value[0];
            exact[3 * i + 1] = value[1];
            exact[3 * i + 2] = 3 * other[0] - other[1] + 0.5 * value[0];
            memcpy(problem.points + 3 * i, exact + 3 * i, 3 * sizeof(double));
        }
        const double *points = NULL;
        taut_model *model = problem_make(&problem, &points);
        if (points != NULL) {
            CHECK_NEAR(apart(count_of(&problem), points, exact), 0,
                       4e-12 * size_of(count_of(&problem), exact),
                       "degrees %d, %d, %d x %d, power %d", u.degree, v.degree,
                       taut_basis_count(bu), nv, least);
        }
        taut_model_free(model);
        free(exact);
        problem_free(&problem);
        taut_basis_free(bu);
        taut_basis_free(bv);
    }
}

/* A(ij,st) entry by entry: double[count][count]. */
static double *dense_matrix(const test_problem *problem)
{
    const int nu = taut_basis_count(problem->u), nv = taut_basis_count(problem->v);
    const int count = nu * nv;
    double *matrix = calloc((size_t)(count * count), sizeof(double));
    taut_gram u, v;
    CHECK(taut_gram_new(problem->u, NULL, &u, NULL) == TAUT_OK, "gram");
    CHECK(taut_gram_new(problem->v, NULL, &v, NULL) == TAUT_OK, "gram");
    for (int a = 0; a < count; a++) {
        for (int b = 0; b < count; b++) {
            const int i = a / nv, j = a % nv, s = b / nv, t = b % nv;
            matrix[a * count + b] = v.length / u.length * taut_band_at(&u.stiffness, i, s) *
                                        taut_band_at(&v.mass, j, t) +
                                    u.length / v.length * taut_band_at(&u.mass, i, s) *
                                        taut_band_at(&v.stiffness, j, t);
        }
    }
    taut_gram_clear(&u);
    taut_gram_clear(&v);
    return matrix;
}

/* The unknown points by dense Cholesky factorisation; returns the reciprocal condition number. */
static double solve_dense(const test_problem *problem, const double *matrix, double *points)
{
    const int count = (int)count_of(problem);
    int *index = malloc((size_t)count * sizeof(int)), n = 0;
    double *a = NULL, *b = NULL, norm = 0, rcond = 0;
    for (int i = 0; i < count; i++) {
        if (!problem->known[i]) {
            index[n++] = i;
        }
    }
    a = calloc((size_t)(n * n) + 1, sizeof(double));
    b = calloc(3 * (size_t)n + 1, sizeof(double));
    for (int i = 0; i < n; i++) {
        double row = 0;
        for (int j = 0; j < n; j++) {
            a[i * n + j] = matrix[index[i] * count + index[j]];
            row += fabs(a[i * n + j]);
        }
        norm = fmax(norm, row);
        for (int k = 0; k < count; k++) {
            for (int c = 0; problem->known[k] && c < 3; c++) {
                b[3 * i + c] -= matrix[index[i] * count + k] * problem->points[3 * k + c];
            }
        }
    }
    CHECK(n == 0 || LAPACKE_dpotrf(LAPACK_ROW_MAJOR, 'L', n, a, n) == 0, "n=%d", n);
    CHECK(n == 0 || LAPACKE_dpotrs(LAPACK_ROW_MAJOR, 'L', n, 3, a, n, b, 3) == 0, "n=%d", n);
    CHECK(n == 0 || LAPACKE_dpocon(LAPACK_ROW_MAJOR, 'L', n, a, n, norm, &rcond) == 0, "n=%d", n);
    memcpy(points, problem->points, 3 * (size_t)count * sizeof(double));
    for (int i = 0; i < n; i++) {
        memcpy(points + 3 * index[i], b + 3 * i, 3 * sizeof(double));
    }
    free(index);
    free(a);
    free(b);
    return rcond;
}

/* Any pattern: scattered points, missing edges, holes, one single point. */
static void random_pattern(test_problem *problem)
{
    const int nu = taut_basis_count(problem->u), nv = taut_basis_count(problem->v);
    const int kind = random_int(0, 3);
    const double share = random_in(0.02, 0.95);
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const int at = i * nv + j;
            problem->known[at] =
                kind == 0   ? random_in(0, 1) < share
                : kind == 1 ? (i == 0 || j == 0) /* two free edges */
                : kind == 2 ? (i == 0 || i == nu - 1 || j == 0 || j == nv - 1 || (i + j) % 5 == 0)
                            : 0;
        }
    }
    problem->known[random_int(0, nu * nv - 1)] = 1;
    for (int i = 0; i < 3 * nu * nv; i++) {
        problem->points[i] = random_in(-1, 1);
    }
}

static void test_patterns(void)
{
    for (int trial = 0; trial < 300; trial++) {
        test_problem problem = problem_new(basis_random(5, 10), basis_random(5, 10));
        const size_t count = count_of(&problem);
        double *matrix = dense_matrix(&problem), *exact = malloc(3 * count * sizeof(double));
        const double *points = NULL;
        taut_model *model = NULL;
        double rcond = 0;
        random_pattern(&problem);
        rcond = solve_dense(&problem, matrix, exact);
        model = problem_make(&problem, &points);
        if (points != NULL) {
            /* what the dense solve itself may be off by ([Higham2002] 10.1) */
            const double tolerance = 8 * (double)count * TAUT_UNIT_ROUNDOFF / fmax(rcond, 1e-300);
            CHECK_NEAR(apart(count, points, exact), 0, tolerance + 1e-14, "trial %d, %zu points",
                       trial, count);
            for (size_t i = 0; i < count; i++) {
                CHECK(!problem.known[i] ||
                          memcmp(points + 3 * i, problem.points + 3 * i, 3 * sizeof(double)) == 0,
                      "known point %zu moved", i);
            }
        }
        taut_model_free(model);
        free(matrix);
        free(exact);
        problem_free(&problem);
    }
}

/* The area is at most the energy, at every aspect ([WuWang2011] 2.3). Nearly flat boundaries: the
 * area integrand has no kinks to slow it down. */
static void test_area_below_energy(void)
{
    for (int trial = 0; trial < 12; trial++) {
        test_problem problem = problem_new(basis_uniform(random_int(2, 4), random_int(5, 7)),
                                           basis_uniform(random_int(2, 4), random_int(5, 7)));
        const int nu = taut_basis_count(problem.u), nv = taut_basis_count(problem.v);
        taut_certificate *certificate = NULL;
        taut_model *model = NULL;
        problem_random_boundary(&problem);
        for (int i = 0; i < nu * nv; i++) {
            problem.points[3 * i] = (double)(i / nv) / nu;
            problem.points[3 * i + 1] = (double)(i % nv) / nv;
            problem.points[3 * i + 2] *= 0.2;
        }
        problem.data.aspect = random_log(0.25, 4);
        model = problem_make(&problem, NULL);
        CHECK(taut_dirichlet_certify(model, &problem.data, NULL, &certificate, NULL) == TAUT_OK,
              "certify");
        const taut_record *figures = taut_certificate_figures(certificate);
        const double area = taut_record_number(taut_record_get(figures, "area"));
        const double energy = taut_record_number(taut_record_get(figures, "dirichlet_energy"));
        const double stretched_energy =
            taut_record_number(taut_record_get(figures, "aspect_energy"));
        CHECK(area > 0 && area <= energy * (1 + 1e-10), "area %g energy %g", area, energy);
        CHECK(area <= stretched_energy * (1 + 1e-10), "area %g energy %g", area, stretched_energy);
        CHECK_NEAR(stretched_energy, detail_of(model, "aspect_energy"), 1e-12 * stretched_energy,
                   "two routes to one energy");
        taut_certificate_free(certificate);
        taut_model_free(model);
        problem_free(&problem);
    }
}

/* Weights that are products, w_ij = a_i b_j, take the tensor route. One weight off by a part in 1e8
 * takes the other, and must move the solution by about as little. */
static void test_weight_routes(void)
{
    for (int trial = 0; trial < 40; trial++) {
        test_problem problem = problem_new(basis_uniform(random_int(1, 4), random_int(5, 8)),
                                           basis_uniform(random_int(1, 4), random_int(5, 8)));
        test_problem other;
        const int nv = taut_basis_count(problem.v);
        double a[8], b[8];
        problem_random_boundary(&problem);
        problem_random_weights(&problem, 2);
        for (int i = 0; i < 8; i++) {
            a[i] = random_log(0.3, 3);
            b[i] = random_log(0.3, 3);
        }
        for (size_t i = 0; i < count_of(&problem); i++) {
            problem.weights[i] = a[i / (size_t)nv] * b[i % (size_t)nv];
        }
        other = copy_of(&problem);
        problem_random_weights(&other, 2);
        memcpy(other.weights, problem.weights, count_of(&problem) * sizeof(double));
        other.weights[random_int(0, (int)count_of(&problem) - 1)] *= 1 + 1e-11;
        compare(&problem, &other, keep, NULL, 1e-10, "weights");
        /* all weights the same: the polynomial solution */
        for (size_t i = 0; i < count_of(&problem); i++) {
            problem.weights[i] = 0.3;
        }
        other.data.weights = NULL;
        compare(&problem, &other, keep, NULL, 0, "equal weights");
        problem_free(&problem);
        problem_free(&other);
    }
}

/* At an offset of 1e8 the solution is the one at the origin, to what storing it there leaves. */
static void shift_far(const double *from, double *to, const void *data)
{
    for (int c = 0; c < 3; c++) {
        to[c] = from[c] + ((const double *)data)[c];
    }
}

static void test_far_away(void)
{
    const double far[3] = {1e8, -3e8, 2e8};
    for (int trial = 0; trial < 40; trial++) {
        test_problem problem = random_problem(5, 12), moved = copy_of(&problem);
        for (size_t i = 0; i < 3 * count_of(&problem); i++) {
            /* what survives the shift exactly */
            problem.points[i] = ldexp(round(ldexp(problem.points[i], 20)), -20);
            moved.points[i] = problem.points[i] + far[i % 3];
        }
        compare(&problem, &moved, shift_far, far, 2 * TAUT_UNIT_ROUNDOFF, "far away");
        problem_free(&problem);
        problem_free(&moved);
    }
}

int main(void)
{
    random_seed(20260302);
    test_affine();
    test_scale();
    test_knot_scaling();
    test_transpose();
    test_harmonic();
    test_patterns();
    test_area_below_energy();
    test_weight_routes();
    test_far_away();
    return check_failures != 0;
}
