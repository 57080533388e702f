/* test_harmonic_double.c -- completion in doubles against the same numbers completed in rational
 * arithmetic: 1e-15 of the largest point for random data, from both kinds of data. links: gmp
 */
#include "check.h"
#include "shapes.h"

#include "taut/harmonic.h"

#include <string.h>

enum { SIZE = 32 };

static const taut_make_options exactly = {.exact = 1};
static double points[3 * SIZE * SIZE];
static unsigned char known[SIZE * SIZE];

/* Rows 0 and n, or columns, of random numbers of this size about `offset`. */
static void fill(int n, int m, int turned, double size, double offset)
{
    for (int k = 0; k < 3 * (n + 1) * (m + 1); k++) {
        const int i = k / 3 / (m + 1), j = k / 3 % (m + 1);
        known[k / 3] = turned ? j == 0 || j == m : i == 0 || i == n;
        points[k] = offset + size * random_in(-1, 1);
    }
}

/* Both ways; the distance over the largest coordinate. NaN where there was no rational arithmetic.
 */
static double apart(const taut_harmonic_problem *problem, const char *what, int m)
{
    taut_model *exact = NULL, *rounded = NULL;
    taut_error error = {.message = ""};
    double largest = 0, most = 0;
    const taut_status status = taut_harmonic_make(problem, &exactly, &exact, &error);

    if (status == TAUT_IO) {
        return NAN;
    }
    CHECK(status == TAUT_OK, "%s m=%d: %s", what, m, error.message);
    CHECK(taut_harmonic_make(problem, NULL, &rounded, &error) == TAUT_OK, "%s m=%d: %s", what, m,
          error.message);
    if (exact != NULL && rounded != NULL) {
        most = shape_apart(taut_model_surface(exact, 0), taut_model_surface(rounded, 0), &largest);
    }
    taut_model_free(exact);
    taut_model_free(rounded);
    return most / largest;
}

static void test_rows(int m, int turned, double size, double offset)
{
    const int n = m % 2 != 0 ? m : m + 1;
    taut_harmonic_problem problem = {
        .rows = {.points = points, .known = known, .allow_ill_conditioned = 1}};
    taut_basis *across = shape_bezier(n, 0, random_in(0.5, 2)),
               *along = shape_bezier(m, -1, random_in(0, 1));

    fill(turned ? m : n, turned ? n : m, turned, size, offset);
    problem.u = turned ? along : across;
    problem.v = turned ? across : along;
    const double found = apart(&problem, "rows", m);
    CHECK(!(found > 1e-15), "m=%d turned=%d size=%g offset=%g: %.3g", m, turned, size, offset,
          found);
    taut_basis_free(across);
    taut_basis_free(along);
}

static void test_derivative(int m, double size)
{
    const int n = m % 2 != 0 ? m : m + 1;
    taut_harmonic_problem problem = {.given = TAUT_HARMONIC_DERIVATIVE,
                                     .derivative = {.allow_ill_conditioned = 1}};
    taut_basis *u = shape_bezier(n, 0, random_in(0.5, 2)),
               *v = shape_bezier(m, -1, random_in(0, 1));

    fill(n, m, 0, size, 0);
    problem.u = u;
    problem.v = v;
    problem.derivative.edge = points;
    problem.derivative.cross = points + 3 * (m + 1);
    const double found = apart(&problem, "derivative", m);
    CHECK(!(found > 1e-15), "derivative m=%d size=%g: %.3g", m, size, found);
    taut_basis_free(u);
    taut_basis_free(v);
}

int main(void)
{
    random_seed(20261126);
    for (int m = 1; m <= 30; m += m < 8 ? 1 : random_int(2, 7)) {
        const double size = random_log(1e-3, 1e3);
        const double offset = m % 2 != 0 ? 0 : random_in(-1, 1) * random_log(1, 1e8);
        test_rows(m, random_int(0, 1), size, offset);
        test_derivative(m, size);
    }
    return check_failures != 0;
}
