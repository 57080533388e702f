/* test_spaces.c -- finer spaces for a least area: where knots go in, how far that goes, and
 * nets that are nothing but known points. */
#include "certificates.h"
#include "check.h"
#include "films.h"
#include "problems.h"

#include "construct/plateau/directions.h"
#include "construct/plateau/refine.h"
#include "taut/measure.h"
#include "taut/operations.h"
#include "taut/plateau.h"

#include <math.h>
#include <string.h>

static double number_of(const taut_model *model, const char *key)
{
    const taut_record *refinement = taut_record_get(taut_model_details(model), "refinement");
    return taut_record_number(taut_record_get(refinement, key));
}

/* Fills the net, all of it known: z over the unit square at Greville points. */
static void lay(test_problem *net, double (*z)(double x, double y))
{
    const taut_basis *bases[2] = {net->u, net->v};
    taut_basis_spec spec[2];
    taut_basis_spec_of(bases[0], &spec[0]);
    taut_basis_spec_of(bases[1], &spec[1]);
    const int nv = taut_basis_count(net->v), count = taut_basis_count(net->u) * nv;
    for (int k = 0; k < count; k++) {
        const int at[2] = {k / nv, k % nv};
        double x[2] = {0, 0};
        for (int d = 0; d < 2; d++) {
            for (int i = 1; i <= spec[d].degree; i++) {
                x[d] += spec[d].knots[at[d] + i] / spec[d].degree;
            }
        }
        net->known[k] = 1;
        net->points[3 * k] = x[0];
        net->points[3 * k + 1] = x[1];
        net->points[3 * k + 2] = z(x[0], x[1]);
    }
}

/* Only the boundary known. */
static void open_inside(test_problem *net)
{
    const int nu = taut_basis_count(net->u), nv = taut_basis_count(net->v);
    for (int k = 0; k < nu * nv; k++) {
        net->known[k] = k / nv == 0 || k / nv == nu - 1 || k % nv == 0 || k % nv == nv - 1;
    }
}

static double flat(double x, double y)
{
    return 0.25 * x - 0.5 * y;
}

static double warped(double x, double y)
{
    return x * (1 - y) + y * (1 - x);
}

static double bowl(double x, double y)
{
    return 0.2 * (x * (1 - x) + y * (1 - y));
}

static taut_surface *surface_of(const test_problem *net)
{
    taut_surface *surface = NULL;
    CHECK(taut_surface_new("net", net->u, net->v, net->points, NULL, &surface, NULL) == TAUT_OK,
          "a surface");
    return surface;
}

/* A plane of 20 x 20 spans with one point raised bends in 4 spans of each direction: knots go into
 * the middles of some of those and nowhere else, and the surface stays. */
static void test_few_spans(void)
{
    test_problem net = problem_new(basis_uniform(3, 23), basis_uniform(3, 23));
    taut_surface *surface = NULL, *finer = NULL;
    taut_error error = {0};

    lay(&net, flat);
    net.points[3 * (11 * 23 + 6) + 2] += 0.05;
    surface = surface_of(&net);
    CHECK(taut_plateau_insert_knots(surface, NULL, &finer, &error) == TAUT_OK, "%s", error.message);
    for (int d = 0; finer != NULL && d < 2; d++) {
        const taut_basis *old = d == 0 ? net.u : net.v;
        const taut_basis *made = d == 0 ? taut_surface_u(finer) : taut_surface_v(finer);
        const int more = taut_basis_count(made) - 23, first = d == 0 ? 8 : 3;
        int seen = 0;
        CHECK(more >= 1 && more <= 4, "%d knots along %c", more, d == 0 ? 'u' : 'v');
        for (int s = 0; s < 4; s++) { /* the support of the point */
            const double *b = taut_basis_breaks(old) + first + s;
            for (int k = 0; k <= taut_basis_span_count(made); k++) {
                seen += fabs(taut_basis_breaks(made)[k] - 0.5 * (b[0] + b[1])) < 1e-14;
            }
        }
        CHECK(seen == more, "%d of %d knots are where the surface bends", seen, more);
    }
    for (int k = 0; finer != NULL && k < 100; k++) {
        const double u = random_in(0, 1), v = random_in(0, 1);
        double x[3], y[3];
        CHECK(taut_surface_eval(surface, u, v, 0, x) == TAUT_OK &&
                  taut_surface_eval(finer, u, v, 0, y) == TAUT_OK,
              "evaluated");
        CHECK_NEAR(y[2], x[2], 1e-14, "at %g %g", u, v);
    }
    taut_surface_free(finer);
    taut_surface_free(surface);
    problem_free(&net);
}

/* A net with nothing to find keeps its points, and tells their area. */
static void test_nothing_unknown(void)
{
    test_problem net = problem_new(basis_uniform(2, 4), basis_uniform(3, 5));
    const taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    taut_model *model = NULL;
    taut_error error = {0};

    lay(&net, flat);
    net.points[3 * 7 + 2] = 0.75;
    CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    if (model != NULL) {
        const taut_record *details = taut_model_details(model);
        const double area = film_proved_area(model, &problem, "all known");
        CHECK(memcmp(taut_surface_points(taut_model_surface(model, 0)), net.points,
                     60 * sizeof(double)) == 0,
              "the points are those given");
        CHECK(taut_record_number(taut_record_get(details, "unknowns")) == 0, "unknowns");
        CHECK_NEAR(taut_record_number(taut_record_get(details, "dirichlet_area")), area,
                   1e-9 * area, "area");
    }
    taut_model_free(model);
    problem_free(&net);
}

/* Weights that are all the same say nothing, in finer spaces either. */
static void test_equal_weights(void)
{
    test_problem net = problem_example(3);
    taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    double least[2] = {0, 0};
    double weights[16];

    problem.refine = 1;
    for (int k = 0; k < 2; k++) {
        taut_model *model = NULL;
        taut_error error = {0};
        for (int i = 0; i < 16; i++) {
            weights[i] = 3;
        }
        problem.net.weights = k == 1 ? weights : NULL;
        CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
        least[k] = number_of(model, "estimated_least_area");
        taut_model_free(model);
    }
    CHECK_NEAR(least[1], least[0], 1e-12 * least[0], "with weights 3");
    problem_free(&net);
}

/* A space that finds no rest within the iterations allowed still counts for the estimate, by the
 * area it came to: less near, and from above. */
static void test_unfinished(void)
{
    test_problem net = problem_example(2);
    taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    double least[2] = {0, 0}, area = 0;

    problem.refine = 1;
    for (int k = 0; k < 2; k++) {
        taut_model *model = NULL;
        taut_error error = {0};
        CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
        least[k] = number_of(model, "estimated_least_area");
        problem.max_iterations = (int)detail_of(model, "iterations");
        CHECK(problem.max_iterations > 1 &&
                  taut_surface_area(taut_model_surface(model, 0), &area, NULL) == TAUT_OK,
              "%d iterations", problem.max_iterations);
        taut_model_free(model);
    }
    CHECK(least[1] > least[0] * (1 + 1e-7) && least[1] < area, "%.12g and %.12g of %.12g", least[1],
          least[0], area);
    problem_free(&net);
}

/* More points than the spaces of an estimate have go along normals: hardly above the least, here
 * 1.27926157117 of four edges of a tetrahedron; one space more takes a quarter and less of what is
 * left over. */
static void test_many_points(void)
{
    test_problem net = problem_new(basis_uniform(3, 16), basis_uniform(3, 16));
    taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    taut_model *model = NULL;
    taut_error error = {0};

    lay(&net, warped);
    open_inside(&net);
    problem.refine = 1;
    CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    CHECK_NEAR(number_of(model, "estimated_least_area"), 1.2792615711710065, 1e-9, "29 x 29");
    taut_model_free(model);
    problem_free(&net);
}

/* A net that has more points than there may be takes no knots; one with a few less takes one round
 * of them. Both say how many points it was. */
static void test_too_far(void)
{
    static const int counts[2] = {51, 49};
    for (int k = 0; k < 2; k++) {
        test_problem net = problem_new(basis_uniform(1, counts[k]), basis_uniform(1, 51));
        taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_NORMAL);
        taut_model *model = NULL;
        taut_error error = {0};
        lay(&net, k == 0 ? flat : warped);
        open_inside(&net);
        problem.tolerance_area = 1e-10;
        CHECK(taut_plateau_make(&problem, NULL, &model, &error) ==
                  (k == 0 ? TAUT_BAD_INPUT : TAUT_NOT_CONVERGED),
              "%d", k);
        CHECK(strcmp(error.where, "/tolerance_area") == 0 && model == NULL, "%s: %s", error.where,
              error.message);
        if (k == 0) {
            CHECK(strcmp(error.reason, "size") == 0 && error.found == 51 * 51 &&
                      error.limit == 2500,
                  "%s", error.message);
        } else {
            CHECK(strcmp(error.reason, "area-gap") == 0 && error.found > error.limit &&
                      error.limit == 1e-10 && error.found < 1,
                  "%s: %g of %g", error.message, error.found, error.limit);
        }
        problem_free(&net);
    }
}

/* Unit directions at every point, also where the surface has no normal: on an edge that is a point
 * they are its neighbours' mean, and on a line there are none to follow. */
static void test_directions(void)
{
    for (int k = 0; k < 2; k++) {
        test_problem net = problem_new(basis_uniform(2, 5), basis_uniform(3, 6));
        double directions[90];
        taut_surface *surface = NULL;
        lay(&net, flat);
        for (int i = 0; i < 30; i++) {
            double *x = net.points + 3 * i;
            x[1] *= k == 0 && i < 6 ? 0 : 1;
            x[0] *= k == 1 ? 0 : 1;
            x[1] *= k == 1 ? 0 : 1;
            x[2] = k == 1 ? i / 6 : flat(x[0], x[1]);
        }
        surface = surface_of(&net);
        CHECK(taut_plateau_directions(surface, directions) == TAUT_OK, "directions");
        for (int i = 0; i < 30; i++) {
            const double *d = directions + 3 * i, length = sqrt(1 + 0.0625 + 0.25);
            const double expected[3] = {k == 0 ? -0.25 / length : 0, k == 0 ? 0.5 / length : 0,
                                        k == 0 ? 1 / length : 1};
            for (int c = 0; c < 3; c++) {
                CHECK_NEAR(d[c], expected[c], 1e-14, "%d: point %d", k, i);
            }
        }
        taut_surface_free(surface);
        problem_free(&net);
    }
}

/* Edges whose middles are free, along the normals of the Dirichlet surface: every row and column of
 * the net has an unknown. The film is below the Dirichlet surface, and at rest. */
static void test_free_middles(void)
{
    test_problem net = problem_new(basis_uniform(1, 7), basis_uniform(1, 7));
    taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_NORMAL);
    taut_model *model = NULL;
    taut_error error = {0};

    lay(&net, bowl);
    open_inside(&net);
    for (int k = 0; k < 4; k++) {
        net.known[k == 0 ? 3 : k == 1 ? 45 : k == 2 ? 21 : 27] = 0;
    }
    CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    if (model != NULL) {
        const double first = detail_of(model, "dirichlet_area");
        const double area = film_proved_area(model, &problem, "free middles");
        CHECK(area < first * (1 - 1e-6) && area > 0.5 * first, "%.12g of %.12g", area, first);
    }
    taut_model_free(model);
    model = NULL;
    problem.max_iterations = 1;
    CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_NO_SOLUTION && model == NULL &&
              strcmp(error.where, "/points") == 0 && strcmp(error.reason, "free-edge") == 0 &&
              error.found > error.limit,
          "one step: %s", error.message);
    problem_free(&net);
}

int main(void)
{
    random_seed(20260712);
    test_few_spans();
    test_nothing_unknown();
    test_equal_weights();
    test_unfinished();
    test_many_points();
    test_too_far();
    test_directions();
    test_free_middles();
    return check_failures != 0;
}
