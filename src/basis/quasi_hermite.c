/* quasi_hermite.c -- a quintic C^2 B-spline that meets a c- or h- basis with two derivatives at the
 * ends of panels.
 *
 * All inner knots are triple. The coefficient with knots x, x, x, x+y, x+z is the blossom of the
 * osculating parabola at x:
 *     f(x) + f'(x) (y + z)/5 + f''(x) y z/20
 */
#include "basis/quasi_change.h"

#include "core/fail.h"
#include "core/memory.h"

#include <assert.h>
#include <math.h>

/* knots[0 .. 3 N + 8]: six at each end, three at each of the N - 1 inner panel ends. */
static void fill_knots(int panels, const double *ends, double *knots)
{
    int n = 0;
    for (int k = 0; k <= panels; k++) {
        const int times = k == 0 || k == panels ? 6 : 3;
        for (int i = 0; i < times; i++) {
            knots[n++] = ends[k];
        }
    }
}

/* The three coefficients at panel end k. */
static void fill_rows(const taut_basis *basis, int panels, const double *ends, int k,
                      taut_change *change)
{
    const double x = ends[k];
    const int span = taut_basis_span(basis, x);
    const double before = k > 0 ? ends[k - 1] - x : 0;
    const double after = k < panels ? ends[k + 1] - x : 0;
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

taut_status taut_quasi_to_bspline(const taut_basis *basis, int panels, const double *ends,
                                  taut_change **change, taut_error *error)
{
    taut_basis_spec spec = {.type = "bspline", .degree = 5};
    taut_status status = TAUT_OK;
    double *knots = NULL;

    assert(panels >= 1 && panels <= (TAUT_COUNT_MAX - 3) / 3); /* see geometry/nurbs/spans.c */
    spec.knot_count = 3 * panels + 9;
    knots = taut_alloc((size_t)spec.knot_count, sizeof(double));
    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    fill_knots(panels, ends, knots);
    spec.knots = knots;
    status = taut_change_new(&spec, 0, 4, change, error);
    for (int k = 0; status == TAUT_OK && k <= panels; k++) {
        fill_rows(basis, panels, ends, k, *change);
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
