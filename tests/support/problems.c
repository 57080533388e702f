#include "problems.h"

#include "check.h"
#include "papers.h"

#include <stdlib.h>
#include <string.h>

taut_basis *basis_uniform(int degree, int count)
{
    const taut_basis_spec spec = {.type = "bspline", .degree = degree, .count = count};
    taut_basis *basis = NULL;
    CHECK(taut_basis_new(&spec, count, &basis, NULL) == TAUT_OK, "degree=%d count=%d", degree,
          count);
    return basis;
}

/* Inner knots in [0, 1]: 0 uniform, 1 random, 2 graded over six decades, 3 repeated. */
static void fill_inner(int kind, int degree, int inner, double *knots)
{
    for (int i = 0; i < inner; i++) {
        const double even = (double)(i + 1) / (inner + 1);
        knots[i] = kind == 0   ? even
                   : kind == 1 ? (i == 0 ? 0 : knots[i - 1]) + random_in(0.05, 1)
                   : kind == 2 ? pow(10, -6.0 * (inner - i) / (inner + 1))
                               : (double)(1 + i / degree) / (1 + (inner - 1) / degree + 1);
    }
    for (int i = 0; kind == 1 && i < inner; i++) {
        knots[i] /= knots[inner - 1] + 0.5;
    }
}

taut_basis *basis_random(int degree_max, int count_max)
{
    const int degree = random_int(1, degree_max);
    const int count = random_int(degree + 1, count_max > degree ? count_max : degree + 1);
    const int inner = count - degree - 1;
    const double lo = random_in(-3, 3), length = random_log(0.01, 100);
    double knots[1024];
    taut_basis_spec spec = {.type = "bspline", .degree = degree, .knot_count = count + degree + 1};
    taut_basis *basis = NULL;

    for (int i = 0; i <= degree; i++) {
        knots[i] = 0;
        knots[count + i] = 1;
    }
    if (inner > 0) {
        fill_inner(random_int(0, 3), degree, inner, knots + degree + 1);
    }
    for (int i = 0; i < count + degree + 1; i++) {
        knots[i] = lo + length * knots[i];
    }
    spec.knots = knots;
    CHECK(taut_basis_new(&spec, count, &basis, NULL) == TAUT_OK, "degree=%d count=%d", degree,
          count);
    return basis;
}

double greville_uniform(int count, int i)
{
    double sum = 0;
    for (int k = i - 2; k <= i; k++) {
        sum += fmin(1, fmax(0, (double)k / (count - 3)));
    }
    return sum / 3;
}

test_problem problem_new(taut_basis *u, taut_basis *v)
{
    const size_t count = (size_t)taut_basis_count(u) * (size_t)taut_basis_count(v);
    test_problem problem = {.u = u, .v = v};
    problem.points = calloc(3 * count, sizeof(double));
    problem.known = calloc(count, 1);
    problem.data.u = u;
    problem.data.v = v;
    problem.data.points = problem.points;
    problem.data.known = problem.known;
    return problem;
}

void problem_free(test_problem *problem)
{
    taut_basis_free(problem->u);
    taut_basis_free(problem->v);
    free(problem->points);
    free(problem->known);
    free(problem->weights);
    memset(problem, 0, sizeof *problem);
}

void problem_know(test_problem *problem, int i, int j, double x, double y, double z)
{
    const size_t at = (size_t)i * (size_t)taut_basis_count(problem->v) + (size_t)j;
    const double point[3] = {x, y, z};
    memcpy(problem->points + 3 * at, point, sizeof point);
    problem->known[at] = 1;
}

test_problem problem_tetrahedron(int n)
{
    test_problem net = problem_new(basis_uniform(3, n), basis_uniform(3, n));
    for (int i = 0; i < n; i++) {
        const double t = greville_uniform(n, i);
        problem_know(&net, i, 0, t, 0, t);
        problem_know(&net, i, n - 1, t, 1, 1 - t);
        problem_know(&net, 0, i, 0, t, t);
        problem_know(&net, n - 1, i, 1, t, 1 - t);
    }
    return net;
}

void problem_random_boundary(test_problem *problem)
{
    const int nu = taut_basis_count(problem->u), nv = taut_basis_count(problem->v);
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const int at = i * nv + j;
            if (i == 0 || j == 0 || i == nu - 1 || j == nv - 1) {
                problem->known[at] = 1;
                for (int c = 0; c < 3; c++) {
                    problem->points[3 * at + c] = random_in(-1, 1);
                }
            }
        }
    }
}

void problem_random_weights(test_problem *problem, double limit)
{
    const int count = taut_basis_count(problem->u) * taut_basis_count(problem->v);
    problem->weights = calloc((size_t)count, sizeof(double));
    problem->data.weights = problem->weights;
    for (int i = 0; i < count; i++) {
        problem->weights[i] = random_log(1 / limit, limit);
    }
}

test_problem problem_example(int number)
{
    const paper_net *from = &wuwang2011[number - 1];
    test_problem problem =
        problem_new(basis_uniform(from->degree, from->nu), basis_uniform(from->degree, from->nv));
    for (int k = 0; k < from->nu * from->nv; k++) {
        const int i = k / from->nv, j = k % from->nv;
        const double *x = from->points[k];
        if (i == 0 || j == 0 || i == from->nu - 1 || j == from->nv - 1) {
            problem_know(&problem, i, j, x[0], x[1], x[2]);
        }
    }
    return problem;
}

taut_model *problem_make(const test_problem *problem, const double **points)
{
    taut_model *model = NULL;
    taut_error error = {0};
    const taut_status status = taut_dirichlet_make(&problem->data, NULL, &model, &error);
    CHECK(status == TAUT_OK, "%s: %s: %s", taut_status_text(status), error.where, error.message);
    if (model != NULL && points != NULL) {
        *points = taut_surface_points(taut_model_surface(model, 0));
    }
    return model;
}
