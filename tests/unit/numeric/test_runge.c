/* test_runge.c -- one step of order 8: against the exponential and the circle, and its order. */
#include "check.h"

#include "numeric/runge.h"

static int circle(void *context, const double *y, double *slope)
{
    (void)context;
    slope[0] = -y[1];
    slope[1] = y[0];
    slope[2] = y[2];
    return 1;
}

static int nowhere(void *context, const double *y, double *slope)
{
    (void)context;
    slope[0] = 1;
    return y[0] < 0.5;
}

static double error_of(double h)
{
    const taut_runge system = {3, circle, NULL};
    const double y[3] = {1, 0, 1};
    double first[3], out[3], errors[2][TAUT_RUNGE_MAX];
    circle(NULL, y, first);
    CHECK(taut_runge_step(&system, y, first, h, out, errors), "h = %g", h);
    return fmax(fabs(out[2] - exp(h)), fmax(fabs(out[0] - cos(h)), fabs(out[1] - sin(h))));
}

int main(void)
{
    const taut_runge system = {1, nowhere, NULL};
    const double y = 0, first = 1;
    double out = 7, errors[2][TAUT_RUNGE_MAX];

    /* The error of a step is of order 9: halving it divides by 512, and by more of long ones. */
    const double ratio = error_of(1) / error_of(0.5);
    CHECK(ratio > 512 && ratio < 720, "ratio %g", ratio);
    CHECK(error_of(0.1) < 1e-15, "%g", error_of(0.1));
    CHECK(!taut_runge_step(&system, &y, &first, 1, &out, errors) && out == 7,
          "a stage without a slope");
    CHECK(taut_runge_error(0, 0) == 0 && taut_runge_error(1, 0) == 1, "norms");
    return check_failures != 0;
}
