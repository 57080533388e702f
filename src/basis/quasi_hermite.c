/* quasi_hermite.c -- a quintic C^2 B-spline that meets a c- or h- basis with two derivatives at the
 * ends of equal panels.
 *
 * All inner knots are triple. The coefficient with knots x, x, x, x+y, x+z is the blossom of the
 * osculating parabola at x:
 *     f(x) + f'(x) (y + z)/5 + f''(x) y z/20
 */
#include "basis/quasi_change.h"

#include "core/fail.h"
#include "core/memory.h"

#include <math.h>

/* End number k of panels: panel ends split each span evenly, breaks are met exactly. */
static double panel_end(const taut_basis *basis, int panels, int k)
{
    const int span = k / panels;
    const int inner = k % panels;
    const double lo = basis->breaks[span];
    return inner == 0 ? lo : lo + (basis->breaks[span + 1] - lo) * ((double)inner / panels);
}

/* knots[0 .. 3 N + 8]: six at each end, three at each of the N - 1 inner panel ends. */
static void fill_knots(const taut_basis *basis, int panels, int total, double *knots)
{
    int n = 0;
    for (int k = 0; k <= total; k++) {
        const double x = panel_end(basis, panels, k);
        const int times = k == 0 || k == total ? 6 : 3;
        for (int i = 0; i < times; i++) {
            knots[n++] = x;
        }
    }
}

/* The three coefficients at panel end k. */
static void fill_rows(const taut_basis *basis, int panels, int total, int k, taut_change *change)
{
    const int span = k == total ? basis->shape.span_count - 1 : k / panels;
    const double x = panel_end(basis, panels, k);
    const double before = k > 0 ? panel_end(basis, panels, k - 1) - x : 0;
    const double after = k < total ? panel_end(basis, panels, k + 1) - x : 0;
    const double y[3] = {before, before, after};
    const double z[3] = {before, after, after};
    double u[3 * 4];

    basis->ops->eval(basis, span, x, 2, u);
    for (int m = 0; m < 3; m++) {
        double *row = taut_change_row(change, 3 * k + m);
        change->first[3 * k + m] = basis->first[span];
        for (int i = 0; i < 4; i++) {
            row[i] = u[i] + u[4 + i] * (y[m] + z[m]) / 5 + u[8 + i] * y[m] * z[m] / 20;
        }
    }
}

taut_status taut_quasi_to_bspline(const taut_basis *basis, int panels, taut_change **change,
                                  taut_error *error)
{
    const double wanted = (double)panels * basis->shape.span_count;
    taut_basis_spec spec = {.type = "bspline", .degree = 5};
    taut_status status = TAUT_OK;
    double *knots = NULL;

    if (panels < 1 || 3 * wanted + 3 > TAUT_COUNT_MAX) {
        return taut_fail(error, TAUT_NO_SOLUTION, NULL, 3 * wanted + 3, TAUT_COUNT_MAX,
                         "a spline of %.0f functions, expected at most %d", 3 * wanted + 3,
                         TAUT_COUNT_MAX);
    }
    const int total = panels * basis->shape.span_count;
    spec.knot_count = 3 * total + 9;
    knots = taut_alloc((size_t)spec.knot_count, sizeof(double));
    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    fill_knots(basis, panels, total, knots);
    spec.knots = knots;
    status = taut_change_new(&spec, 0, 4, change, error);
    for (int k = 0; status == TAUT_OK && k <= total; k++) {
        fill_rows(basis, panels, total, k, *change);
    }
    taut_free(knots);
    return status;
}

/* y(t) = y(m) cos(t - m) + y'(m) sin(t - m); reach is at most pi/2. */
void taut_quasi_c_growth(double reach, double *at, double *slope)
{
    *at = 1;
    *slope = sin(reach);
}

void taut_quasi_h_growth(double reach, double *at, double *slope)
{
    *at = cosh(reach);
    *slope = sinh(reach);
}
