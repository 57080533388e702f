/* strip.c -- elimination row by row:
 *
 *     for each row k, and each row i below it within the width: l = A(i, k) / A(k, k); row i -= l row k; A(i, k) = l
 */
#include "numeric/strip.h"

#include <math.h>

static const double vanishing = 1e-13; /* of the row's largest number */

static double *row_of(double *a, int width, int i)
{
    return a + (size_t)i * (2 * (size_t)width + 1) + width - i;
}

static const double *row_in(const double *a, int width, int i)
{
    return a + (size_t)i * (2 * (size_t)width + 1) + width - i;
}

static int last_of(int n, int width, int i)
{
    return i + width < n ? i + width : n - 1;
}

static int has_pivot(const double *row, int k, int last)
{
    double largest = 0;
    for (int j = k; j <= last; j++) {
        largest = fmax(largest, fabs(row[j]));
    }
    return fabs(row[k]) > vanishing * largest;
}

int taut_strip_factor(int n, int width, double *a)
{
    for (int k = 0; k < n; k++) {
        const double *pivot = row_in(a, width, k);
        const int last = last_of(n, width, k);
        if (!has_pivot(pivot, k, last)) {
            return 0;
        }
        for (int i = k + 1; i <= last; i++) {
            double *row = row_of(a, width, i);
            row[k] /= pivot[k];
            for (int j = k + 1; j <= last; j++) {
                row[j] -= row[k] * pivot[j];
            }
        }
    }
    return 1;
}

static void subtract(double factor, const double *from, size_t count, double *x)
{
    for (size_t k = 0; k < count; k++) {
        x[k] -= factor * from[k];
    }
}

void taut_strip_solve(int n, int width, const double *a, size_t count, size_t step, double *x)
{
    for (int i = 0; i < n; i++) {
        const double *row = row_in(a, width, i);
        for (int j = i > width ? i - width : 0; j < i; j++) {
            subtract(row[j], x + (size_t)j * step, count, x + (size_t)i * step);
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        const double *row = row_in(a, width, i);
        for (int j = i + 1; j <= last_of(n, width, i); j++) {
            subtract(row[j], x + (size_t)j * step, count, x + (size_t)i * step);
        }
        for (size_t k = 0; k < count; k++) {
            x[(size_t)i * step + k] /= row[i];
        }
    }
}
