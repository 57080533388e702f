/* test_minimise.c -- minima with known places, and how domains are kept. */
#include "check.h"

#include "numeric/minimise.h"

#include <string.h>

enum { MOST = 12 };

/* Rosenbrock's valley in n variables: minimum 0 at (1, ..., 1). One is added to the value, so that
 * relative measures have something to go by. */
static int rosenbrock(void *context, const double *x, double *value, double *gradient)
{
    const int n = *(const int *)context;
    *value = 1.0;
    for (int i = 0; i < n; i++) {
        gradient[i] = 0.0;
    }
    for (int i = 0; i + 1 < n; i++) {
        const double a = x[i + 1] - x[i] * x[i], b = 1.0 - x[i];
        *value += 100 * a * a + b * b;
        gradient[i] += -400 * a * x[i] - 2 * b;
        gradient[i + 1] += 200 * a;
    }
    return 1;
}

static void test_rosenbrock(void)
{
    for (int n = 2; n <= MOST; n += 5) {
        double x[MOST], work[TAUT_MINIMISE_WORK(MOST)];
        taut_minimum minimum;
        for (int i = 0; i < n; i++) {
            x[i] = i % 2 == 0 ? -1.2 : 1.0;
        }
        CHECK(taut_minimise(n, rosenbrock, NULL, &n, x, work, 0, &minimum), "n=%d", n);
        CHECK(minimum.converged, "n=%d gradient %g curvature %g", n, minimum.gradient,
              minimum.curvature);
        if (minimum.value < 2.0) { /* from 4 variables on there is a second minimum near x_0 = -1 */
            for (int i = 0; i < n; i++) {
                CHECK_NEAR(x[i], 1.0, 1e-9, "n=%d", n);
            }
        }
    }
}

/* Its Hessian. */
static void rosenbrock_bend(void *context, const double *x, double *hessian)
{
    const int n = *(const int *)context;
    memset(hessian, 0, (size_t)n * (size_t)n * sizeof *hessian);
    for (int i = 0; i + 1 < n; i++) {
        hessian[i * n + i] += 1200 * x[i] * x[i] - 400 * x[i + 1] + 2;
        hessian[i * n + i + 1] -= 400 * x[i];
        hessian[(i + 1) * n + i] -= 400 * x[i];
        hessian[(i + 1) * n + i + 1] += 200;
    }
}

/* The same minimum with it, in fewer evaluations than differences take. */
static void test_hessian(void)
{
    for (int n = 2; n <= MOST; n += 5) {
        double x[2][MOST], work[TAUT_MINIMISE_WORK(MOST)];
        taut_minimum minimum[2];
        for (int own = 0; own < 2; own++) {
            for (int i = 0; i < n; i++) {
                x[own][i] = i % 2 == 0 ? -1.2 : 1.0;
            }
            CHECK(taut_minimise(n, rosenbrock, own ? rosenbrock_bend : NULL, &n, x[own], work, 0,
                                &minimum[own]),
                  "n=%d", n);
            CHECK(minimum[own].converged, "n=%d own %d", n, own);
        }
        for (int i = 0; i < n; i++) {
            CHECK_NEAR(x[0][i], x[1][i], 1e-9, "n=%d", n);
        }
        CHECK_NEAR(minimum[1].curvature, minimum[0].curvature, 1e-6, "n=%d", n);
        CHECK(minimum[1].evaluations < minimum[0].evaluations, "n=%d: %d and %d", n,
              minimum[1].evaluations, minimum[0].evaluations);
    }
}

/* x - log x summed, defined for x > 0 only: minimum at 1. The domain is asked for at points
 * outside, which the run must step back from. */
static int barrier(void *context, const double *x, double *value, double *gradient)
{
    int *const refused = context;
    *value = 0.0;
    for (int i = 0; i < 3; i++) {
        if (!(x[i] > 0)) {
            (*refused)++;
            return 0;
        }
        *value += (i + 1) * (x[i] - log(x[i]));
        gradient[i] = (i + 1) * (1.0 - 1.0 / x[i]);
    }
    return 1;
}

static void test_domain(void)
{
    double x[3] = {50, 0.001, 8}, work[TAUT_MINIMISE_WORK(3)];
    taut_minimum minimum;
    int refused = 0;
    CHECK(taut_minimise(3, barrier, NULL, &refused, x, work, 0, &minimum), "start in the domain");
    CHECK(minimum.converged, "gradient %g", minimum.gradient);
    for (int i = 0; i < 3; i++) {
        CHECK_NEAR(x[i], 1.0, 1e-12, "i=%d", i);
    }
    CHECK_NEAR(minimum.value, 6.0, 1e-14, "value");
    CHECK_NEAR(minimum.curvature, 1.0, 1e-8, "the least of 1, 2, 3");
    x[1] = -1;
    CHECK(!taut_minimise(3, barrier, NULL, &refused, x, work, 0, &minimum), "start outside");
}

/* x^4 - 2 x^2 + 2 from the saddle's side: a run must not settle on the maximum at 0. */
static int double_well(void *context, const double *x, double *value, double *gradient)
{
    (void)context;
    *value = x[0] * x[0] * x[0] * x[0] - 2 * x[0] * x[0] + 2;
    gradient[0] = 4 * x[0] * x[0] * x[0] - 4 * x[0];
    return 1;
}

static void test_leaves_maximum(void)
{
    double x[1] = {1e-6}, work[TAUT_MINIMISE_WORK(1)];
    taut_minimum minimum;
    CHECK(taut_minimise(1, double_well, NULL, NULL, x, work, 0, &minimum), "start");
    CHECK(minimum.converged, "gradient %g", minimum.gradient);
    CHECK_NEAR(fabs(x[0]), 1.0, 1e-9, "x");
}

/* exp(-x) falls for ever: no minimum, and it is not taken for one. */
static int valley(void *context, const double *x, double *value, double *gradient)
{
    (void)context;
    *value = 1.0 + exp(-x[0]);
    gradient[0] = -exp(-x[0]);
    return x[0] < 500;
}

static void test_valley(void)
{
    double x[1] = {0}, work[TAUT_MINIMISE_WORK(1)];
    taut_minimum minimum;
    CHECK(taut_minimise(1, valley, NULL, NULL, x, work, 0, &minimum), "start");
    CHECK(!minimum.converged || minimum.curvature < 1e-6 * minimum.value,
          "x=%g converged %d curvature %g", x[0], minimum.converged, minimum.curvature);
}

int main(void)
{
    test_rosenbrock();
    test_hessian();
    test_domain();
    test_leaves_maximum();
    test_valley();
    return check_failures != 0;
}
