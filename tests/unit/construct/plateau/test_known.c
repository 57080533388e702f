/* test_known.c -- minimal surfaces in closed form: kept, left or approached. */
#include "check.h"
#include "films.h"
#include "problems.h"

#include "taut/measure.h"
#include "taut/plateau.h"

#include <math.h>

/* Enneper's surface (u - u^3/3 + u v^2, -v - u^2 v + v^3/3, u^2 - v^2) over [-a, a]^2, its boundary
 * on n x n cubic points: harmonic, so the Dirichlet surface is it. */
static test_problem enneper(int n, double a)
{
    test_problem net = problem_new(basis_uniform(3, n), basis_uniform(3, n));
    for (int at = 0; at < n * n; at++) {
        const int m[2] = {at / n, at % n};
        double one[2], two[2], three[2];
        for (int c = 0; c < 2; c++) { /* blossoms of t, t^2, t^3 at three knots in a row */
            double s[3];
            for (int k = 0; k < 3; k++) {
                s[k] = a * (2 * fmin(1, fmax(0, (double)(m[c] + k - 2) / (n - 3))) - 1);
            }
            one[c] = (s[0] + s[1] + s[2]) / 3;
            two[c] = (s[0] * s[1] + s[1] * s[2] + s[2] * s[0]) / 3;
            three[c] = s[0] * s[1] * s[2];
        }
        if (m[0] % (n - 1) == 0 || m[1] % (n - 1) == 0) {
            problem_know(&net, m[0], m[1], one[0] - three[0] / 3 + one[0] * two[1],
                         -one[1] - two[0] * one[1] + three[1] / 3, two[0] - two[1]);
        }
    }
    return net;
}

/* iint (1 + u^2 + v^2)^2 over [-a, a]^2 */
static double enneper_area(double a)
{
    const double b = a * a;
    return 4 * b * (1 + 4 * b / 3 + 2 * b * b / 5 + 2 * b * b / 9);
}

/* iint sqrt(1 + tan^2 x + tan^2 y) over [-a, a]^2: Scherk's area, by the midpoint rule. */
static double scherk_area(double a)
{
    enum { PARTS = 300 };
    double sum = 0;
    for (int k = 0; k < PARTS * PARTS; k++) {
        const double s = tan(a * (k / PARTS + 0.5) / PARTS);
        const double t = tan(a * (k % PARTS + 0.5) / PARTS);
        sum += sqrt(1 + s * s + t * t);
    }
    return sum * 4 * a * a / (PARTS * PARTS);
}

/* Scherk's patch where it is steep, |x|, |y| <= 1.4, between curves that are off by the square of a
 * 97th of its edges. */
static void test_scherk(void)
{
    enum { COUNT = 100 };
    const double a = 1.4, known = scherk_area(a);
    test_problem net = problem_new(basis_uniform(5, 14), basis_uniform(5, 14));
    taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_NORMAL);
    taut_basis *t = basis_uniform(3, COUNT);
    taut_curve *curves[4] = {NULL, NULL, NULL, NULL};

    for (int side = 0; side < 4; side++) {
        double points[3 * COUNT];
        for (int k = 0; k < COUNT; k++) {
            const double along = a * (2 * greville_uniform(COUNT, k) - 1);
            const double z = log(cos(along) / cos(a));
            const double across = side % 2 == 0 ? -a : a;
            points[3 * k] = side < 2 ? across : along;
            points[3 * k + 1] = side < 2 ? along : across;
            points[3 * k + 2] = side < 2 ? z : -z;
        }
        CHECK(taut_curve_new("edge", t, points, NULL, &curves[side], NULL) == TAUT_OK, "an edge");
        problem.curves[side] = curves[side];
    }
    CHECK_NEAR(film_area(&problem, "Scherk"), known, 4e-4 * known, "between its edges");
    for (int side = 0; side < 4; side++) {
        taut_curve_free(curves[side]);
    }
    taut_basis_free(t);
    problem_free(&net);
}

/* There is nothing left to gain on a small patch. */
static void test_enneper(void)
{
    test_problem net = enneper(4, 0.5);
    const taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    CHECK_NEAR(film_area(&problem, "Enneper"), enneper_area(0.5), 1e-14, "Enneper");
    problem_free(&net);
}

/* A minimal surface whose normals fill more than half of the sphere, here |(u, v)| < 1, is
 * stationary and no minimum: a start there is left for less area. Within that disc it stays where
 * it is. */
static void test_saddle(void)
{
    static const double sizes[2] = {0.7, 1};
    for (int k = 0; k < 4; k++) {
        test_problem net = enneper(7, sizes[k / 2]);
        const taut_plateau_problem problem = film_problem(&net, (taut_plateau_method)(k % 2));
        const double known = enneper_area(sizes[k / 2]);
        taut_model *model = NULL;
        taut_error error = {0};
        CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_OK, "%d: %s", k,
              error.message);
        const double area = model != NULL ? film_proved_area(model, &problem, "saddle") : nan("");
        if (k / 2 == 0) {
            CHECK_NEAR(area, known, 1e-13 * known, "stable, method %d", k % 2);
        } else {
            CHECK(area < known * (1 - 1e-3), "unstable, method %d: %.12g of %.12g", k % 2, area,
                  known);
        }
        taut_model_free(model);
        problem_free(&net);
    }
}

/* A net over a boundary like sheet metal, which slides within the film for long. Where its slides
 * gain little it may rest, and not before the certificate finds the area level too. */
static void test_rest(void)
{
    enum { N = 18 };
    test_problem net = problem_new(basis_uniform(3, N), basis_uniform(3, N));
    const taut_plateau_problem problem = film_problem(&net, TAUT_PLATEAU_FULL);
    taut_model *model = NULL;
    taut_error error = {0};

    for (int k = 0; k < N * N; k++) {
        const double u = greville_uniform(N, k / N), v = greville_uniform(N, k % N);
        net.known[k] = k / N == 0 || k / N == N - 1 || k % N == 0 || k % N == N - 1;
        net.points[3 * k] = net.known[k] ? u + 0.1 * sin(4 * v) : 0;
        net.points[3 * k + 1] = net.known[k] ? v + 0.1 * u * u : 0;
        net.points[3 * k + 2] = net.known[k] ? 0.4 * sin(4 * u) * cos(2 * v + 0.6) : 0;
    }
    CHECK(taut_plateau_make(&problem, NULL, &model, &error) == TAUT_OK, "%s", error.message);
    if (model != NULL) {
        CHECK_NEAR(film_proved_area(model, &problem, "rest"), 1.224094003, 1e-9, "rest");
    }
    taut_model_free(model);
    problem_free(&net);
}

int main(void)
{
    test_enneper();
    test_saddle();
    test_rest();
    test_scherk();
    return check_failures != 0;
}
