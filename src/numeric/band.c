#include "numeric/band.h"

#include "core/constants.h"
#include "core/memory.h"
#include "numeric/kernel/kernel.h"

#include <assert.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

/* Largest n * (width + 1): keeps every index computation far from overflow. */
static const uint64_t entries_max =
    SIZE_MAX / 16 < (uint64_t)1 << 40 ? SIZE_MAX / 16 : (uint64_t)1 << 40;

enum { WIDE = 32 }; /* half-width from which the vector kernels pay */

taut_status taut_band_init(int n, int width, taut_band *out)
{
    if (n < 1 || width < 0 || width == INT32_MAX || out == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    const size_t row_length = (size_t)width + 1;
    if (row_length > entries_max / (size_t)n) {
        return TAUT_BAD_ARGUMENT;
    }
    double *a = taut_alloc_zero((size_t)n * row_length, sizeof *a);
    if (a == NULL) {
        return TAUT_NO_MEMORY;
    }
    *out = (taut_band){n, width, a};
    return TAUT_OK;
}

void taut_band_clear(taut_band *band)
{
    if (band != NULL) {
        taut_free(band->a);
        *band = (taut_band){0, 0, NULL};
    }
}

taut_status taut_band_widen(const taut_band *from, int width, taut_band *out)
{
    if (from == NULL || from->a == NULL || width < from->width) {
        return TAUT_BAD_ARGUMENT;
    }
    taut_band wide;
    const taut_status status = taut_band_init(from->n, width, &wide);
    if (status != TAUT_OK) {
        return status;
    }
    for (int i = 0; i < from->n; i++) {
        memcpy(taut_band_row(&wide, i), taut_band_row(from, i),
               ((size_t)from->width + 1) * sizeof(double));
    }
    *out = wide;
    return TAUT_OK;
}

int taut_band_is_legal(const taut_band *band)
{
    if (band == NULL || band->a == NULL || band->n < 1 || band->width < 0) {
        return 0;
    }
    for (int i = 0; i < band->n; i++) {
        const double *row = taut_band_row(band, i);
        for (int d = 0; d <= band->width; d++) {
            if (!isfinite(row[d]) || (d > i && row[d] != 0.0)) {
                return 0;
            }
        }
    }
    return 1;
}

int taut_band_equal(const taut_band *a, const taut_band *b)
{
    return a->n == b->n && a->width == b->width &&
           memcmp(a->a, b->a, (size_t)a->n * ((size_t)a->width + 1) * sizeof *a->a) == 0;
}

double taut_band_at(const taut_band *band, int i, int j)
{
    assert(i >= 0 && i < band->n && j >= 0 && j < band->n);
    const int d = i > j ? i - j : j - i;
    return d > band->width ? 0.0 : taut_band_row(band, i > j ? i : j)[d];
}

void taut_band_multiply_add(const taut_band *band, double factor, const double *x, double *y)
{
    const int w = band->width;
    for (int i = 0; i < band->n; i++) {
        const double *row = taut_band_row(band, i);
        const double xi = factor * x[i];
        double sum = 0.0;
        for (int d = 1; d <= w && d <= i; d++) {
            sum += row[d] * x[i - d];
            y[i - d] += row[d] * xi;
        }
        y[i] += factor * sum + row[0] * xi;
    }
}

/* Row by row: with u(i,j) = L(i,j) D(j),
 *     u(i,j) = A(i,j) - sum_k u(i,k) L(j,k),    L(i,j) = u(i,j) / D(j),
 *     D(i)   = A(i,i) - sum_j u(i,j) L(i,j)
 * sums over the band, k < j < i. */
/* Row i becomes that of the factors; its pivot is returned. */
static double factor_row(const taut_band *band, int i, const taut_kernel *kernel)
{
    const int w = band->width, reach = i < w ? i : w;
    double *row = taut_band_row(band, i);

    for (int d = reach - 1; d >= 1; d--) {
        const double *upper = taut_band_row(band, i - d);
        if (kernel != NULL) {
            row[d] -= kernel->dot((size_t)(reach - d), row + d + 1, upper + 1);
            continue;
        }
        for (int e = reach; e > d; e--) {
            row[d] -= row[e] * upper[e - d];
        }
    }
    for (int d = reach; d >= 1; d--) {
        const double u = row[d];
        row[d] = u / taut_band_row(band, i - d)[0];
        row[0] -= u * row[d];
    }
    return row[0];
}

/* Operations of a row of the factors, as pulses count them. */
static double row_work(const taut_band *band)
{
    return (double)band->width * band->width;
}

taut_status taut_band_factor(taut_band *band)
{
    return taut_band_factor_watched(band, NULL);
}

taut_status taut_band_factor_watched(taut_band *band, taut_pulse *pulse)
{
    const int n = band->n;
    const taut_kernel *kernel = band->width >= WIDE ? taut_kernel_best() : NULL;

    for (int i = 0; i < n; i++) {
        const double diagonal = taut_band_row(band, i)[0];
        if (!(factor_row(band, i, kernel) > 8.0 * n * TAUT_UNIT_ROUNDOFF * diagonal)) {
            return TAUT_NO_SOLUTION;
        }
        if (taut_pulse_beat(pulse, row_work(band))) {
            return TAUT_INTERRUPTED;
        }
    }
    return TAUT_OK;
}

taut_status taut_band_factor_signed(taut_band *band, int *negative, taut_pulse *pulse)
{
    const int n = band->n;
    const taut_kernel *kernel = band->width >= WIDE ? taut_kernel_best() : NULL;

    *negative = 0;
    for (int i = 0; i < n; i++) {
        const double diagonal = taut_band_row(band, i)[0];
        const double pivot = factor_row(band, i, kernel);
        if (!(fabs(pivot) > 8.0 * n * TAUT_UNIT_ROUNDOFF * fabs(diagonal))) {
            return TAUT_NO_SOLUTION;
        }
        *negative += pivot < 0;
        if (taut_pulse_beat(pulse, row_work(band))) {
            return TAUT_INTERRUPTED;
        }
    }
    return TAUT_OK;
}

static void reverse_order(int n, double *x)
{
    for (int i = 0, j = n - 1; i < j; i++, j--) {
        const double xi = x[i];
        x[i] = x[j];
        x[j] = xi;
    }
}

/* The same for one right-hand side: with x the other way round, rows of the factor and stretches of
 * x run alike, y[n - 1 - i] = x[i]. */
static void solve_wide(const taut_band *factor, double *x)
{
    const taut_kernel *kernel = taut_kernel_best();
    const int n = factor->n, w = factor->width;

    reverse_order(n, x);
    for (int i = 1; i < n; i++) {
        const size_t reach = (size_t)(i < w ? i : w);
        x[n - 1 - i] -= kernel->dot(reach, taut_band_row(factor, i) + 1, x + (n - i));
    }
    for (int i = 0; i < n; i++) {
        x[n - 1 - i] /= taut_band_row(factor, i)[0];
    }
    for (int i = n - 1; i > 0; i--) {
        const size_t reach = (size_t)(i < w ? i : w);
        kernel->add_scaled(reach, -x[n - 1 - i], taut_band_row(factor, i) + 1, x + (n - i));
    }
    reverse_order(n, x);
}

void taut_band_solve(const taut_band *factor, int count, double *x)
{
    if (count == 1 && factor->width >= WIDE) {
        solve_wide(factor, x);
        return;
    }
    const int n = factor->n, w = factor->width;
    const size_t c = (size_t)count;
    for (int i = 0; i < n; i++) {
        const double *row = taut_band_row(factor, i);
        double *xi = x + (size_t)i * c;
        for (int d = 1; d <= w && d <= i; d++) {
            const double *above = xi - (size_t)d * c;
            for (size_t r = 0; r < c; r++) {
                xi[r] -= row[d] * above[r];
            }
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        double *xi = x + (size_t)i * c;
        const double pivot = taut_band_row(factor, i)[0];
        for (size_t r = 0; r < c; r++) {
            xi[r] /= pivot;
        }
        for (int d = 1; d <= w && i + d < n; d++) {
            const double l = taut_band_row(factor, i + d)[d];
            const double *below = xi + (size_t)d * c;
            for (size_t r = 0; r < c; r++) {
                xi[r] -= l * below[r];
            }
        }
    }
}
