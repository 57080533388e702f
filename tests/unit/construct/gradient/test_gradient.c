/* test_gradient.c -- derivatives against what shares no code with them: makes of moved problems.
 *
 * Points are linear in what is given, and the energy is quadratic: two makes give both without any
 * error but rounding. The area is compared with differences of fourth order.
 */
#include "check.h"
#include "problems.h"
#include "taut/gradient.h"
#include "taut/measure.h"

#include <stdlib.h>
#include <string.h>

enum { POINTS_MAX = 400 };

/* A problem of either construction, moved along a direction of its known points. */
typedef struct moved {
    const test_problem *problem;
    int is_plateau;
    taut_plateau_method method;
    double direction[3 * POINTS_MAX];
    const double *factors; /* of the points, or NULL: the area */
    taut_gradient_of of;
} moved;

static size_t count_of(const taut_dirichlet_problem *net)
{
    return (size_t)taut_basis_count(net->u) * (size_t)taut_basis_count(net->v);
}

static taut_model *make_at(const moved *m, double step, taut_plateau_problem *made, double *points)
{
    taut_model *model = NULL;
    taut_error error;
    taut_status status = TAUT_OK;
    const size_t size = 3 * count_of(&m->problem->data);

    for (size_t i = 0; i < size; i++) {
        points[i] = m->problem->data.points[i] + step * m->direction[i];
    }
    *made =
        (taut_plateau_problem){.net = m->problem->data, .method = m->method, .without_least = 1};
    made->tolerance = 1e-13;
    made->net.points = points;
    status = m->is_plateau ? taut_plateau_make(made, NULL, &model, &error)
                           : taut_dirichlet_make(&made->net, NULL, &model, &error);
    /* what is below rounding is as far as it gets */
    for (int k = 0; k < 2 && status == TAUT_NOT_CONVERGED; k++) {
        made->tolerance *= 10;
        status = taut_plateau_make(made, NULL, &model, &error);
    }
    CHECK(status == TAUT_OK, "%s", error.message);
    return model;
}

/* The number that is derived, by measures and sums. */
static double value_at(const moved *m, double step)
{
    static double points[3 * POINTS_MAX];
    taut_plateau_problem made;
    double value = 0, value_error = 0;
    taut_model *model = make_at(m, step, &made, points);
    const taut_surface *surface = taut_model_surface(model, 0);

    for (size_t i = 0; m->factors != NULL && i < 3 * count_of(&made.net); i++) {
        value += m->factors[i] * taut_surface_points(surface)[i];
    }
    if (m->factors == NULL) {
        CHECK((m->of == TAUT_GRADIENT_AREA
                   ? taut_surface_area(surface, &value, &value_error)
                   : taut_surface_dirichlet_energy(surface, &value)) == TAUT_OK,
              "measured");
    }
    taut_model_free(model);
    return value;
}

/* The derivative along the direction by the library; *size: of its terms. */
static double derivative_of(const moved *m, double *size)
{
    static double points[3 * POINTS_MAX], gradient[3 * POINTS_MAX];
    const taut_gradient_request request = {.of = m->of, .factors = m->factors};
    taut_plateau_problem made;
    taut_error error = {.message = ""};
    taut_model *model = make_at(m, 0, &made, points);
    const taut_status status =
        m->is_plateau ? taut_plateau_gradient(&made, model, &request, gradient, &error)
                      : taut_dirichlet_gradient(&made.net, model, &request, gradient, &error);
    double sum = 0;

    CHECK(status == TAUT_OK, "%s", error.message);
    *size = 0;
    for (size_t i = 0; status == TAUT_OK && i < 3 * count_of(&made.net); i++) {
        CHECK(m->problem->data.known[i / 3] || gradient[i] == 0, "unknown points have none");
        sum += gradient[i] * m->direction[i];
        *size += fabs(gradient[i] * m->direction[i]);
    }
    taut_model_free(model);
    return sum;
}

static void choose_direction(moved *m)
{
    memset(m->direction, 0, sizeof m->direction);
    for (size_t i = 0; i < 3 * count_of(&m->problem->data); i++) {
        m->direction[i] = m->problem->data.known[i / 3] ? random_in(-1, 1) : 0;
    }
}

/* (F(h) - F(-h)) / 2 h, by steps h and h / 2 without their h^2. */
static double difference_of(const moved *m, double h)
{
    const double wide = (value_at(m, h) - value_at(m, -h)) / (2 * h);
    const double narrow = (value_at(m, h / 2) - value_at(m, -h / 2)) / h;
    return narrow + (narrow - wide) / 3;
}

static void fill(double *factors, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        factors[i] = random_in(-1, 1);
    }
}

/* ---- dirichlet ---- */

static test_problem random_problem(void)
{
    const int degrees[2] = {random_int(1, 4), random_int(1, 4)};
    test_problem problem = problem_new(basis_uniform(degrees[0], degrees[0] + random_int(2, 6)),
                                       basis_uniform(degrees[1], degrees[1] + random_int(2, 6)));
    const size_t count = count_of(&problem.data);

    problem_random_boundary(&problem);
    if (random_int(0, 1)) { /* a pattern: some inside too, some of the boundary free */
        for (size_t i = 0; i < count; i++) {
            if (random_int(0, 4) == 0) {
                problem.known[i] = !problem.known[i];
                fill(problem.points + 3 * i, 3);
            }
        }
        problem.known[0] = 1;
    }
    return problem;
}

static void test_linear(void)
{
    static double factors[3 * POINTS_MAX];
    for (int trial = 0; trial < random_trials(40); trial++) {
        test_problem problem = random_problem();
        moved m = {.problem = &problem, .of = TAUT_GRADIENT_POINTS, .factors = factors};
        double size = 0;
        if (random_int(0, 2) == 0) {
            problem.data.aspect = random_log(0.2, 5);
        }
        fill(factors, 3 * count_of(&problem.data));
        choose_direction(&m);
        const double found = derivative_of(&m, &size);
        const double expected = (value_at(&m, 1) - value_at(&m, -1)) / 2;
        /* rounding of the solves, times the terms of both sums */
        CHECK_NEAR(found, expected, 1e-11 * (1 + size), "points, trial %d", trial);
        m.of = TAUT_GRADIENT_DIRICHLET_ENERGY;
        m.factors = NULL;
        const double energy = derivative_of(&m, &size);
        const double up = value_at(&m, 1), down = value_at(&m, -1);
        CHECK_NEAR(energy, (up - down) / 2, 1e-11 * (fabs(up) + fabs(down) + size), "energy %d",
                   trial);
        problem_free(&problem);
    }
}

static void test_area(void)
{
    for (int trial = 0; trial < random_trials(12); trial++) {
        test_problem problem = problem_tetrahedron(random_int(4, 7));
        moved m = {.problem = &problem, .of = TAUT_GRADIENT_AREA};
        double size = 0;
        choose_direction(&m);
        const double found = derivative_of(&m, &size);
        CHECK_NEAR(found, difference_of(&m, 0.002), 1e-7 * size, "area, trial %d", trial);
        problem_free(&problem);
    }
}

/* Weights that vary: by quadrature, and not by factors of one direction. */
static void test_weights(void)
{
    static double factors[3 * POINTS_MAX];
    for (int trial = 0; trial < random_trials(6); trial++) {
        test_problem problem = problem_tetrahedron(5);
        moved m = {.problem = &problem, .of = TAUT_GRADIENT_POINTS, .factors = factors};
        double size = 0;
        problem_random_weights(&problem, 1.5);
        fill(factors, 3 * count_of(&problem.data));
        choose_direction(&m);
        const double found = derivative_of(&m, &size);
        CHECK_NEAR(found, (value_at(&m, 1) - value_at(&m, -1)) / 2, 1e-10 * (1 + size),
                   "weights, trial %d", trial);
        m.of = TAUT_GRADIENT_AREA;
        m.factors = NULL;
        const double area = derivative_of(&m, &size);
        CHECK_NEAR(area, difference_of(&m, 0.002), 1e-7 * size, "area with weights, %d", trial);
        problem_free(&problem);
    }
}

/* ---- plateau ---- */

static void test_plateau(void)
{
    static double factors[3 * POINTS_MAX];
    for (int trial = 0; trial < random_trials(8); trial++) {
        test_problem problem = problem_tetrahedron(random_int(4, 6));
        moved m = {.problem = &problem, .is_plateau = 1, .of = TAUT_GRADIENT_AREA};
        double size = 0, found = 0;
        choose_direction(&m);
        for (size_t i = 0; i < 3 * count_of(&problem.data); i++) {
            m.direction[i] *= 0.3; /* films that do not fold */
        }
        for (int method = 0; method < 2; method++) {
            m.method = method == 0 ? TAUT_PLATEAU_FULL : TAUT_PLATEAU_NORMAL;
            if (method == 1 && trial % 2 == 1) { /* "full" slides within the surface, and folds */
                problem_random_weights(&problem, 1.2);
            }
            found = derivative_of(&m, &size);
            CHECK_NEAR(found, difference_of(&m, 0.005), 1e-7 * size, "trial %d method %d", trial,
                       method);
        }
        m.of = TAUT_GRADIENT_POINTS;
        m.factors = factors;
        fill(factors, 3 * count_of(&problem.data));
        found = derivative_of(&m, &size);
        CHECK_NEAR(found, difference_of(&m, 0.005), 1e-7 * (1 + size), "points, trial %d", trial);
        problem_free(&problem);
    }
}

/* A saddle so steep that its second derivatives need many Gauss nodes, more than those of the area. */
static void test_steep(void)
{
    static double factors[3 * POINTS_MAX];
    test_problem problem = problem_new(basis_uniform(2, 3), basis_uniform(2, 3));
    moved m = {.problem = &problem,
               .is_plateau = 1,
               .method = TAUT_PLATEAU_NORMAL,
               .of = TAUT_GRADIENT_POINTS,
               .factors = factors};
    double size = 0;

    for (int i = 0; i < 9; i++) {
        const double heights[9] = {0, 4, 0, -3, 0, -5, 0.5, 4, 0};
        problem.points[3 * i] = i / 3;
        problem.points[3 * i + 1] = i % 3;
        problem.points[3 * i + 2] = heights[i];
        problem.known[i] = i != 4;
    }
    fill(factors, 27);
    choose_direction(&m);
    const double found = derivative_of(&m, &size);
    CHECK_NEAR(found, difference_of(&m, 0.005), 1e-7 * (1 + size), "steep");
    problem_free(&problem);
}

/* ---- refused ---- */

static void refused(taut_status expected, const char *reason, taut_status status,
                    const taut_error *error, const double *gradient)
{
    CHECK(status == expected && strcmp(error->reason, reason) == 0, "%s: %s", reason,
          error->message);
    CHECK(gradient[0] == 7, "the output is untouched");
}

static void test_refused(void)
{
    test_problem problem = problem_tetrahedron(5);
    moved m = {.problem = &problem, .is_plateau = 1};
    double points[75], gradient[75] = {7}, factors[75] = {0};
    taut_plateau_problem made;
    taut_error error;
    taut_model *model = make_at(&m, 0, &made, points);
    taut_gradient_request request = {.of = TAUT_GRADIENT_DIRICHLET_ENERGY};

    refused(TAUT_BAD_ARGUMENT, "no-gradient",
            taut_plateau_gradient(&made, model, &request, gradient, &error), &error, gradient);
    made.net.aspect_auto = 1;
    refused(TAUT_BAD_ARGUMENT, "no-gradient",
            taut_dirichlet_gradient(&made.net, model, NULL, gradient, &error), &error, gradient);
    made.net.aspect_auto = 0;
    made.net.through = &(taut_through){0.5, 0.5, {0}};
    made.net.through_count = 1;
    refused(TAUT_BAD_ARGUMENT, "no-gradient",
            taut_plateau_gradient(&made, model, NULL, gradient, &error), &error, gradient);
    refused(TAUT_BAD_ARGUMENT, "no-gradient",
            taut_dirichlet_gradient(&made.net, model, NULL, gradient, &error), &error, gradient);
    made.net.through_count = 0;
    request.factors = factors;
    refused(TAUT_BAD_ARGUMENT, "argument",
            taut_dirichlet_gradient(&made.net, model, &request, gradient, &error), &error,
            gradient);
    request.of = TAUT_GRADIENT_POINTS;
    factors[74] = INFINITY;
    refused(TAUT_BAD_ARGUMENT, "argument",
            taut_dirichlet_gradient(&made.net, model, &request, gradient, &error), &error,
            gradient);
    points[0] += 1;
    refused(TAUT_BAD_ARGUMENT, "other-model",
            taut_dirichlet_gradient(&made.net, model, NULL, gradient, &error), &error, gradient);
    points[0] -= 1;
    taut_model_free(model);
    model = NULL; /* the Dirichlet surface has not the least area */
    CHECK(taut_dirichlet_make(&made.net, NULL, &model, NULL) == TAUT_OK, "dirichlet");
    refused(TAUT_NO_SOLUTION, "not-at-rest",
            taut_plateau_gradient(&made, model, NULL, gradient, &error), &error, gradient);
    refused(TAUT_BAD_ARGUMENT, "argument", taut_gradient(NULL, model, NULL, gradient, &error),
            &error, gradient);
    taut_model_free(model);
    problem_free(&problem);
}

int main(void)
{
    random_seed(24);
    test_linear();
    test_area();
    test_weights();
    test_plateau();
    test_steep();
    test_refused();
    return check_failures != 0;
}
