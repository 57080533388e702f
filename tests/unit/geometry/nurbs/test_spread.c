/* test_spread.c -- the spread of weights, on nets whose lines have powers of two for weights. */
#include "check.h"
#include "shapes.h"

#include "geometry/nurbs/spread.h"

#include <math.h>
#include <stdlib.h>

enum { COUNT = 4 };

/* Biquadratic in two spans each way: the first and last functions meet on none. */
static double spread_of(int per_row, int per_column)
{
    static const double knots[COUNT + 3] = {0, 0, 0, 1, 2, 2, 2};
    const taut_basis_spec spec = {
        .type = "bspline", .degree = 2, .knots = knots, .knot_count = COUNT + 3};
    double points[COUNT * COUNT][3], weights[COUNT * COUNT];
    for (int k = 0; k < COUNT * COUNT; k++) {
        const int i = k / COUNT, j = k % COUNT;
        points[k][0] = i;
        points[k][1] = j;
        points[k][2] = 0;
        weights[k] = ldexp(1, per_row * i + per_column * j);
    }
    taut_surface *s = shape_surface(shape_basis(&spec), shape_basis(&spec), points[0], weights);
    const double spread = taut_weight_spread(s);
    taut_surface_free(s);
    return spread;
}

int main(void)
{
    for (int row = -5; row <= 5; row++) {
        for (int column = -5; column <= 5; column++) {
            const int most = abs(row) > abs(column) ? abs(row) : abs(column);
            CHECK(spread_of(row, column) == ldexp(1, 2 * most), "%d, %d: %g", row, column,
                  spread_of(row, column));
        }
    }
    return check_failures != 0;
}
