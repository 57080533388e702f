/* polynomial.c -- are two Bezier patches pieces of one polynomial surface?
 *
 * With rows counted from the common edge inwards, a_0 = b_0, a_1, .. and b_0, b_1, .., and widths
 * across the edge in the ratio r, they are when all differences agree up to the degree:
 *     (-1)^k Delta^k a_0 = r^-k Delta^k b_0,   k = 0..n      ([NiWang2015] section 2.6 (3), with
 * the widths of section 2.6). r is taken from the first differences, as widths are not always kept.
 */
#include "measure/join/side.h"

#include "core/memory.h"

#include <math.h>
#include <string.h>

static int is_polynomial_bezier(const taut_surface *surface)
{
    return strcmp(taut_basis_type(taut_surface_u(surface)), "bezier") == 0 &&
           strcmp(taut_basis_type(taut_surface_v(surface)), "bezier") == 0 &&
           taut_surface_weights(surface) == NULL;
}

/* Point j, in the common direction along the edge, of the i-th row from the edge, scaled. */
static void point_of(const taut_join_side *side, int i, int j, double *x)
{
    const int columns = taut_basis_count(taut_surface_v(side->surface));
    const int across = taut_basis_count(side->across), along = taut_basis_count(side->along);
    const int row = (int)side->edge % 2 == 0 ? i : across - 1 - i;
    const int column = side->sign_along > 0 ? j : along - 1 - j;
    const int at = side->held == 0 ? row * columns + column : column * columns + row;
    for (int c = 0; c < 3; c++) {
        x[c] = ldexp(taut_surface_points(side->surface)[3 * at + c], -side->scale);
    }
}

/* d[k][j][3] = sign^k Delta^k of the rows at the edge, k = 0..n; the largest |coordinate| of the
 * net relative to its first point is *size. */
static void find_differences(const taut_join_side *side, double sign, double *d, double *size)
{
    const int rows = taut_basis_count(side->across), columns = taut_basis_count(side->along);
    const size_t length = 3 * (size_t)columns;
    double origin[3];

    point_of(side, 0, 0, origin);
    for (int i = 0; i < rows; i++) {
        for (int j = 0; j < columns; j++) {
            double *x = d + (size_t)i * length + 3 * (size_t)j;
            point_of(side, i, j, x);
            for (int c = 0; c < 3; c++) {
                *size = fmax(*size, fabs(x[c] - origin[c]));
            }
        }
    }
    for (int k = 1; k < rows; k++) {
        for (int i = rows - 1; i >= k; i--) {
            double *row = d + (size_t)i * length;
            const double *before = d + (size_t)(i - 1) * length;
            for (size_t c = 0; c < length; c++) {
                row[c] = sign * (row[c] - before[c]);
            }
        }
    }
}

/* The r that best makes b = r a, 1 where a vanishes. */
static double ratio_of(const double *a, const double *b, size_t length)
{
    double ab = 0, aa = 0;
    for (size_t c = 0; c < length; c++) {
        ab += a[c] * b[c];
        aa += a[c] * a[c];
    }
    return aa > 0 && ab > 0 ? ab / aa : 1;
}

static int differences_agree(const double *a, const double *b, int rows, size_t length, double size)
{
    const double r = ratio_of(a + length, b + length, length);
    double power = 1, width = 1;
    for (int k = 0; k < rows; k++) {
        const double limit = taut_join_tolerance * width * fmax(1, power) * size;
        for (size_t c = (size_t)k * length; c < (size_t)(k + 1) * length; c++) {
            if (!(fabs(power * a[c] - b[c]) <= limit)) {
                return 0;
            }
        }
        power *= r;
        width *= 2;
    }
    return 1;
}

taut_status taut_join_is_one_surface(const taut_join_side *a, const taut_join_side *b, int *one)
{
    const int rows = taut_basis_count(a->across), columns = taut_basis_count(a->along);
    const size_t length = 3 * (size_t)columns;
    double *da = NULL, *db = NULL, size = 0;

    *one = -1;
    if (!is_polynomial_bezier(a->surface) || !is_polynomial_bezier(b->surface) ||
        rows != taut_basis_count(b->across) || columns != taut_basis_count(b->along)) {
        return TAUT_OK;
    }
    da = taut_alloc((size_t)rows * length, sizeof(double));
    db = taut_alloc((size_t)rows * length, sizeof(double));
    if (da != NULL && db != NULL) {
        find_differences(a, -1, da, &size);
        find_differences(b, 1, db, &size);
        *one = differences_agree(da, db, rows, length, size);
    }
    const taut_status status = da != NULL && db != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    taut_free(da);
    taut_free(db);
    return status;
}
