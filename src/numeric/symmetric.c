/* symmetric.c -- eigenvalues and vectors of small symmetric matrices: to a tridiagonal one by
 * Householder, then implicit QL steps with Wilkinson's shift ([GolubVanLoan2013] 8.3). */
#include "numeric/dense.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { STEPS_MAX = 60 }; /* for one eigenvalue; two or three are usual */

static double dot_product(int n, const double *x, const double *y)
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) {
        sum += x[i] * y[i];
    }
    return sum;
}

/* Clears column k below its second entry, w the unit vector of the reflection I - 2 w w': what is
 * left of a is reflected from both sides, w takes the column's place and the entry is returned. */
static double reflect(int n, double *a, int k, double *p)
{
    double *const w = a + (int64_t)k * n;
    const double length = sqrt(dot_product(n - k - 1, w + k + 1, w + k + 1));
    const double entry = w[k + 1] > 0 ? -length : length;
    double norm = 0.0, half = 0.0;
    w[k + 1] -= entry;
    norm = sqrt(dot_product(n - k - 1, w + k + 1, w + k + 1));
    if (!(norm > 0)) {
        return entry;
    }
    for (int i = k + 1; i < n; i++) {
        w[i] /= norm;
    }
    for (int i = k + 1; i < n; i++) {
        p[i] = 2 * dot_product(n - k - 1, a + (int64_t)i * n + k + 1, w + k + 1);
    }
    half = dot_product(n - k - 1, p + k + 1, w + k + 1);
    for (int i = k + 1; i < n; i++) {
        p[i] -= half * w[i];
    }
    for (int j = k + 1; j < n; j++) {
        for (int i = k + 1; i < n; i++) {
            a[i + (int64_t)j * n] -= w[i] * p[j] + p[i] * w[j];
        }
    }
    return entry;
}

/* v = the product of the reflections that a's columns keep. */
static void gather(int n, const double *a, double *v)
{
    memset(v, 0, (size_t)n * (size_t)n * sizeof *v);
    for (int j = 0; j < n; j++) {
        v[j + (int64_t)j * n] = 1.0;
    }
    for (int k = n - 3; k >= 0; k--) {
        const double *const w = a + (int64_t)k * n;
        for (int j = k + 1; j < n; j++) {
            double *const column = v + (int64_t)j * n;
            const double part = 2 * dot_product(n - k - 1, w + k + 1, column + k + 1);
            for (int i = k + 1; i < n; i++) {
                column[i] -= part * w[i];
            }
        }
    }
}

/* One step from place m up to l: e[l] shrinks, by the third power near the end. */
static void chase(int n, int l, int m, double *d, double *e, double *v)
{
    const double slope = (d[l + 1] - d[l]) / (2 * e[l]), root = sqrt(1.0 + slope * slope);
    double g = d[m] - d[l] + e[l] / (slope + (slope < 0 ? -root : root));
    double s = 1.0, c = 1.0, p = 0.0, t = 0.0;
    for (int i = m - 1; i >= l; i--) {
        const double f = s * e[i], b = c * e[i], r = sqrt(f * f + g * g);
        double *const left = v + (int64_t)i * n, *const right = left + n;
        e[i + 1] = r;
        if (!(r > 0)) { /* parted here */
            d[i + 1] -= p;
            e[m] = 0.0;
            return;
        }
        s = f / r;
        c = g / r;
        g = d[i + 1] - p;
        t = (d[i] - g) * s + 2 * c * b;
        p = s * t;
        d[i + 1] = g + p;
        g = c * t - b;
        for (int k = 0; k < n; k++) {
            const double x = left[k], y = right[k];
            left[k] = c * x - s * y;
            right[k] = s * x + c * y;
        }
    }
    d[l] -= p;
    e[l] = g;
    e[m] = 0.0;
}

static void sort(int n, double *values, double *v)
{
    for (int j = 0; j < n; j++) {
        int smallest = j;
        for (int k = j + 1; k < n; k++) {
            smallest = values[k] < values[smallest] ? k : smallest;
        }
        for (int i = 0; i < n && smallest != j; i++) {
            const double keep = v[i + (int64_t)j * n];
            v[i + (int64_t)j * n] = v[i + (int64_t)smallest * n];
            v[i + (int64_t)smallest * n] = keep;
        }
        if (smallest != j) {
            const double keep = values[j];
            values[j] = values[smallest];
            values[smallest] = keep;
        }
    }
}

/* To a largest entry of about 1, by a power of two, so that no square leaves the range. */
static int scale_down(int n, double *a)
{
    double largest = 0.0;
    int power = 0;
    for (int64_t k = 0; k < (int64_t)n * n; k++) {
        largest = fmax(largest, fabs(a[k]));
    }
    (void)frexp(largest, &power);
    for (int64_t k = 0; k < (int64_t)n * n; k++) {
        a[k] = ldexp(a[k], -power);
    }
    return power;
}

void taut_symmetric_eigen(int n, double *a, double *values, double *v)
{
    double e[TAUT_EIGEN_MAX] = {0}, scratch[TAUT_EIGEN_MAX];
    const int power = scale_down(n, a);
    assert(n >= 1 && n <= TAUT_EIGEN_MAX);
    for (int k = 0; k < n - 2; k++) {
        e[k] = reflect(n, a, k, scratch);
    }
    if (n > 1) {
        e[n - 2] = a[n - 1 + (int64_t)(n - 2) * n];
    }
    for (int k = 0; k < n; k++) {
        values[k] = a[k + (int64_t)k * n];
    }
    gather(n, a, v);
    for (int l = 0; l < n; l++) {
        for (int step = 0; step < STEPS_MAX; step++) {
            int m = l;
            while (m < n - 1 &&
                   fabs(e[m]) > 0.5 * DBL_EPSILON * (fabs(values[m]) + fabs(values[m + 1]))) {
                m++;
            }
            if (m == l) {
                break;
            }
            chase(n, l, m, values, e, v);
        }
    }
    for (int k = 0; k < n; k++) {
        values[k] = ldexp(values[k], power);
    }
    sort(n, values, v);
}
