#include "numeric/bernstein.h"

#include <assert.h>
#include <stddef.h>
#include <string.h>

/* b[0..degree] = B[degree,i](t), raising the degree one step at a time ([PieglTiller1997] A1.3):
 *     B[m,i] = (1-t) B[m-1,i] + t B[m-1,i-1]
 * 1-t is one correctly rounded subtraction, so nothing cancels on [0, 1]. */
static void bernstein_values(int degree, double t, double *b)
{
    const double s = 1.0 - t;

    b[0] = 1.0;
    for (int m = 1; m <= degree; m++) {
        double carried = 0.0; /* t B[m-1,i-1] */
        for (int i = 0; i < m; i++) {
            const double lower = b[i];
            b[i] = s * lower + carried;
            carried = t * lower;
        }
        b[m] = carried;
    }
}

/* b[0..degree] holds B[degree-1,i](t), i < degree, on entry and B'[degree,i](t) on return:
 *     B'[n,i] = n (B[n-1,i-1] - B[n-1,i])
 * It is linear in b, so repeating it over rising degrees takes higher derivatives. */
static void bernstein_differentiate(int degree, double *b)
{
    b[degree] = degree * b[degree - 1];
    for (int i = degree - 1; i > 0; i--) {
        b[i] = degree * (b[i - 1] - b[i]);
    }
    b[0] = -degree * b[0];
}

void taut_bernstein_eval(int degree, int order, double t, double *values)
{
    const size_t row_length = (size_t)degree + 1;

    assert(degree >= 0 && order >= 0);
    for (int k = 0; k <= order; k++) {
        double *row = values + (size_t)k * row_length;
        if (k > degree) {
            memset(row, 0, row_length * sizeof *row);
            continue;
        }
        bernstein_values(degree - k, t, row);
        for (int m = degree - k + 1; m <= degree; m++) {
            bernstein_differentiate(m, row);
        }
    }
}
