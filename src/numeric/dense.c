#include "numeric/dense.h"
#include "core/constants.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { SWEEPS_MAX = 60 }; /* Jacobi converges quadratically: ten sweeps are seldom needed */

/* Eight partial sums, which the compiler keeps in vectors. */
static double dot_product(int n, const double *restrict x, const double *restrict y)
{
    double part[8] = {0};
    int i = 0;
    for (; i + 8 <= n; i += 8) {
        for (int k = 0; k < 8; k++) {
            part[k] += x[i + k] * y[i + k];
        }
    }
    for (; i < n; i++) {
        part[0] += x[i] * y[i];
    }
    return ((part[0] + part[4]) + (part[2] + part[6])) +
           ((part[1] + part[5]) + (part[3] + part[7]));
}

static void add_scaled(int n, double s, const double *restrict x, double *restrict y)
{
    for (int i = 0; i < n; i++) {
        y[i] += s * x[i];
    }
}

/* The length of (first, x), safe from overflow. */
static double length_of(double first, int n, const double *x)
{
    double largest = fabs(first), sum = 0.0;
    for (int i = 0; i < n; i++) {
        largest = fmax(largest, fabs(x[i]));
    }
    if (!(largest > 0)) {
        return 0.0;
    }
    sum = (first / largest) * (first / largest);
    for (int i = 0; i < n; i++) {
        sum += (x[i] / largest) * (x[i] / largest);
    }
    return largest * sqrt(sum);
}

/* Column j of the stack [r; block] is (r[0..j-1][j], r[j][j], 0, block[:][j]): the reflection that
 * clears block[:][j] touches row j of r and the block alone. */
void taut_qr_append(int n, double *r, int rows, double *block)
{
    assert(n >= 1 && rows >= 1);
    for (int j = 0; j < n; j++) {
        double *diagonal = r + (int64_t)j * n + j;
        double *x = block + (int64_t)j * rows;
        const double length = length_of(*diagonal, rows, x);
        const double beta = *diagonal > 0 ? -length : length; /* no cancellation in head */
        const double head = *diagonal - beta;
        if (!(length > 0)) {
            continue;
        }
        /* reflector I - tau w w', w = (1, x / head), tau = -head / beta */
        for (int i = 0; i < rows; i++) {
            x[i] /= head;
        }
        *diagonal = beta;
        for (int k = j + 1; k < n; k++) {
            double *top = r + (int64_t)k * n + j;
            double *y = block + (int64_t)k * rows;
            const double s = (head / beta) * (*top + dot_product(rows, x, y));
            *top += s;
            add_scaled(rows, s, x, y);
        }
    }
}

int taut_triangle_solve(int n, int ld, const double *r, double *x)
{
    double largest = 0.0;
    for (int j = 0; j < n; j++) {
        largest = fmax(largest, fabs(r[(int64_t)j * ld + j]));
    }
    for (int j = 0; j < n; j++) {
        if (!(fabs(r[(int64_t)j * ld + j]) > 1e-14 * largest)) {
            return 0;
        }
    }
    for (int j = n - 1; j >= 0; j--) {
        x[j] /= r[(int64_t)j * ld + j];
        add_scaled(j, -x[j], r + (int64_t)j * ld, x);
    }
    return 1;
}

/* The rotation that makes the columns x, y orthogonal, given their products; applied by rotate. */
static void find_rotation(double xx, double yy, double xy, double *c, double *s)
{
    const double zeta = (yy - xx) / (2.0 * xy);
    /* an overflow of zeta^2 gives t = 0, which it is to rounding */
    const double t = (zeta >= 0 ? 1.0 : -1.0) / (fabs(zeta) + sqrt(1.0 + zeta * zeta));
    *c = 1.0 / sqrt(1.0 + t * t);
    *s = *c * t;
}

static void rotate_columns(int n, double *restrict x, double *restrict y, double c, double s)
{
    for (int i = 0; i < n; i++) {
        const double xi = x[i], yi = y[i];
        x[i] = c * xi - s * yi;
        y[i] = s * xi + c * yi;
    }
}

static void swap_columns(int n, double *restrict x, double *restrict y)
{
    for (int i = 0; i < n; i++) {
        const double keep = x[i];
        x[i] = y[i];
        y[i] = keep;
    }
}

static void set_identity(int n, double *v)
{
    memset(v, 0, (size_t)n * (size_t)n * sizeof *v);
    for (int i = 0; i < n; i++) {
        v[i * n + i] = 1.0;
    }
}

/* One sweep of one-sided Jacobi; the number of rotations made. */
static int svd_sweep(int rows, int columns, double *a, double *v)
{
    int rotations = 0;
    for (int p = 0; p < columns - 1; p++) {
        for (int q = p + 1; q < columns; q++) {
            double *x = a + (int64_t)p * rows, *y = a + (int64_t)q * rows;
            const double xx = dot_product(rows, x, x), yy = dot_product(rows, y, y),
                         xy = dot_product(rows, x, y);
            double c = 1.0, s = 0.0;
            if (fabs(xy) <= DBL_EPSILON * sqrt(xx) * sqrt(yy) || fabs(xy) < DBL_MIN) {
                continue;
            }
            find_rotation(xx, yy, xy, &c, &s);
            rotate_columns(rows, x, y, c, s);
            rotate_columns(columns, v + (int64_t)p * columns, v + (int64_t)q * columns, c, s);
            rotations++;
        }
    }
    return rotations;
}

void taut_svd(int rows, int columns, double *a, double *s, double *v)
{
    assert(rows >= columns && columns >= 1);
    set_identity(columns, v);
    for (int sweep = 0; sweep < SWEEPS_MAX && svd_sweep(rows, columns, a, v) > 0; sweep++) {
    }
    for (int j = 0; j < columns; j++) {
        double *x = a + (int64_t)j * rows;
        s[j] = length_of(0.0, rows, x);
        for (int i = 0; i < rows && s[j] > 0; i++) {
            x[i] /= s[j];
        }
    }
    for (int j = 0; j < columns; j++) {
        int largest = j;
        for (int k = j + 1; k < columns; k++) {
            largest = s[k] > s[largest] ? k : largest;
        }
        if (largest != j) {
            const double keep = s[j];
            s[j] = s[largest];
            s[largest] = keep;
            swap_columns(rows, a + (int64_t)j * rows, a + (int64_t)largest * rows);
            swap_columns(columns, v + (int64_t)j * columns, v + (int64_t)largest * columns);
        }
    }
}

/* With a padded by zero rows to at least as many rows as columns, v spans all of the unknowns'
 * space: its first `rank` columns the solution's part, the others the null space. */
int taut_least_norm(int rows, int columns, const double *a, const double *b, double cut, double *x,
                    double *null)
{
    const int padded = rows > columns ? rows : columns;
    double u[TAUT_SVD_MAX * TAUT_SVD_MAX] = {0}, v[TAUT_SVD_MAX * TAUT_SVD_MAX];
    double s[TAUT_SVD_MAX];
    int rank = 0;

    assert(rows >= 1 && columns >= 1 && padded <= TAUT_SVD_MAX);
    for (int j = 0; j < columns; j++) {
        memcpy(u + (int64_t)j * padded, a + (int64_t)j * rows, (size_t)rows * sizeof *u);
    }
    taut_svd(padded, columns, u, s, v);
    memset(x, 0, (size_t)columns * sizeof *x);
    for (; rank < columns && s[rank] > cut * s[0] && s[rank] > 0; rank++) {
        const double part = dot_product(rows, u + (int64_t)rank * padded, b) / s[rank];
        add_scaled(columns, part, v + (int64_t)rank * columns, x);
    }
    if (null != NULL) {
        memcpy(null, v + (int64_t)rank * columns,
               (size_t)(columns - rank) * (size_t)columns * sizeof *null);
    }
    return rank;
}
