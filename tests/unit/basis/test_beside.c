/* test_beside.c -- functions beside a parameter: the same as at it, and with all digits of the
 * distance from either end of the range. */
#include "check.h"
#include "shapes.h"

#include "basis/basis_ops.h"

#include <math.h>

enum { LOCAL = 9, ORDERS = 4 };

static void test_same(void)
{
    for (int trial = 0; trial < 200; trial++) {
        const int degree = random_int(1, LOCAL - 1);
        const double lo = random_in(-2, 2), hi = lo + random_log(0.1, 10);
        taut_basis *basis = shape_bezier(degree, lo, hi);
        double at[ORDERS * LOCAL], beside[ORDERS * LOCAL], scale = 1;
        const double t = random_in(lo, hi);
        CHECK(taut_basis_eval(basis, 0, t, ORDERS - 1, at) == TAUT_OK, "degree %d", degree);
        taut_basis_eval_beside(basis, 0, t, 0, ORDERS - 1, beside);
        for (int k = 0; k < ORDERS; k++) {
            for (int i = 0; i <= degree; i++) {
                CHECK_NEAR(beside[k * (degree + 1) + i], at[k * (degree + 1) + i], 2e-13 * scale,
                           "degree %d, order %d, function %d at %g", degree, k, i, t);
            }
            scale *= 2 * degree / (hi - lo);
        }
        taut_basis_free(basis);
    }
}

/* At 1 - d, d far below a rounding of 1: the first function is d^n, the second n d^(n-1) (1 - d). */
static void test_ends(void)
{
    for (double d = 1e-4; d > 1e-30; d *= 1e-3) {
        const double t = 1 - d, rest = (1 - t) - d;
        double values[2 * LOCAL];
        taut_basis *basis = shape_bezier(3, 0, 1);
        taut_basis_eval_beside(basis, 0, t, rest, 1, values);
        CHECK_NEAR(values[0] / (d * d * d), 1, 1e-14, "d=%g", d);
        CHECK_NEAR(values[1] / (3 * d * d * (1 - d)), 1, 1e-14, "d=%g", d);
        CHECK_NEAR(values[4] / (-3 * d * d), 1, 1e-14, "slope, d=%g", d);
        taut_basis_eval_beside(basis, 0, 0, d, 1, values);
        CHECK_NEAR(values[3] / (d * d * d), 1, 1e-14, "d=%g", d);
        CHECK_NEAR(values[7] / (3 * d * d), 1, 1e-14, "slope, d=%g", d);
        taut_basis_free(basis);
    }
}

int main(void)
{
    random_seed(20261124);
    test_same();
    test_ends();
    return check_failures != 0;
}
