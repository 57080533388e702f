#include "certify/harmonic/residual.h"

#include "certify/common/verdict.h"

#include <float.h>
#include <math.h>
#include <stdint.h>

/* The five factors of relation (2) at index i of degree n: of points i+2, i+1, i, i-1, i-2. They
 * vanish by themselves where those are outside the net. */
static void fill_factors(int n, int i, double f[5])
{
    const double a0 = (double)(n - i) * (n - i - 1), a1 = 2.0 * i * (n - i),
                 a2 = (double)i * (i - 1);
    f[0] = a0;
    f[1] = a1 - 2 * a0;
    f[2] = a0 - 2 * a1 + a2;
    f[3] = a1 - 2 * a2;
    f[4] = a2;
}

/* sum_k f[k] p[i + 2 - k] 2^-unit, points outside the net left out; p strides `stride` points. In
 * twice the precision: the factors sum to 0, and what is left of points far from the origin is the
 * difference that they stand for. */
static taut_twice apply_factors(const double f[5], int n, int i, const double *points,
                                int64_t first, int64_t stride, int c, int unit)
{
    taut_twice sum = {0, 0};
    for (int k = 0; k < 5; k++) {
        const int at = i + 2 - k;
        if (at >= 0 && at <= n && f[k] != 0) {
            const double x = ldexp(points[3 * (first + at * stride) + c], -unit);
            sum = taut_twice_add(sum, taut_twice_product(f[k], x));
        }
    }
    return sum;
}

/* 2^unit is within a factor 2 of the largest coordinate. */
static int unit_of(const double *points, int64_t count)
{
    double largest = 0;
    for (int64_t k = 0; k < 3 * count; k++) {
        largest = fmax(largest, fabs(points[k]));
    }
    return largest > 0 ? ilogb(largest) : 0;
}

/* The mean point, and the largest coordinate about it, over 2^unit. */
static double size_about_mean(const double *points, int64_t count, int unit, double mean[3])
{
    double size = 0;
    for (int c = 0; c < 3; c++) {
        mean[c] = 0;
        for (int64_t k = 0; k < count; k++) {
            mean[c] += ldexp(points[3 * k + c], -unit) / (double)count;
        }
        for (int64_t k = 0; k < count; k++) {
            size = fmax(size, fabs(ldexp(points[3 * k + c], -unit) - mean[c]));
        }
    }
    return size;
}

double taut_certify_extent(const double *points, const unsigned char *known, size_t count,
                           double *reach)
{
    double size = 0;
    *reach = 0;
    for (size_t c = 0; c < 3; c++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t k = 0; k < count; k++) {
            if (known == NULL || known[k]) {
                low = fmin(low, points[3 * k + c]);
                high = fmax(high, points[3 * k + c]);
            }
        }
        size = fmax(size, 0.5 * high - 0.5 * low);
        *reach = fmax(*reach, fmax(fabs(low), fabs(high)));
    }
    return size;
}

taut_edge taut_certify_shared_edge(const taut_surface *p, const taut_surface *q)
{
    if (taut_basis_hi(taut_surface_u(p)) == taut_basis_lo(taut_surface_u(q))) {
        return TAUT_EDGE_U1;
    }
    if (taut_basis_lo(taut_surface_u(p)) == taut_basis_hi(taut_surface_u(q))) {
        return TAUT_EDGE_U0;
    }
    return taut_basis_hi(taut_surface_v(p)) == taut_basis_lo(taut_surface_v(q)) ? TAUT_EDGE_V1
                                                                                : TAUT_EDGE_V0;
}

void taut_certify_laplacian(int n, int m, const taut_twice w[2], const taut_twice *net,
                            taut_twice *laplacian)
{
    for (int i = 0; i <= n; i++) {
        double fu[5];
        fill_factors(n, i, fu);
        for (int j = 0; j <= m; j++) {
            double fv[5];
            fill_factors(m, j, fv);
            for (int c = 0; c < 3; c++) {
                taut_twice u = {0, 0}, v = {0, 0};
                for (int k = 0; k < 5; k++) {
                    const int row = i + 2 - k, column = j + 2 - k;
                    if (row >= 0 && row <= n) {
                        const taut_twice x = net[3 * (row * (m + 1) + j) + c];
                        u = taut_twice_add(u, taut_twice_scale(fu[k], x));
                    }
                    if (column >= 0 && column <= m) {
                        const taut_twice x = net[3 * (i * (m + 1) + column) + c];
                        v = taut_twice_add(v, taut_twice_scale(fv[k], x));
                    }
                }
                laplacian[3 * (i * (m + 1) + j) + c] =
                    taut_twice_add(taut_twice_times(w[0], u), taut_twice_times(w[1], v));
            }
        }
    }
}

void taut_certify_laplacian_weights(double a, double b, taut_twice w[2])
{
    const int unit = ilogb(fmax(a, b));
    const double x = ldexp(a, -unit), y = ldexp(b, -unit);
    const taut_twice aa = taut_twice_product(x, x), bb = taut_twice_product(y, y);
    const taut_twice one = taut_twice_of(1);
    w[0] = a <= b ? one : taut_twice_over(bb, aa);
    w[1] = a <= b ? taut_twice_over(aa, bb) : one;
}

taut_harmonic_residual taut_harmonic_residual_of(const taut_surface *surface, int square)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const int n = taut_basis_degree(u), m = taut_basis_degree(v);
    const double a = square ? 1 : taut_basis_hi(u) - taut_basis_lo(u);
    const double b = square ? 1 : taut_basis_hi(v) - taut_basis_lo(v);
    const double *points = taut_surface_points(surface);
    taut_harmonic_residual found = {0, 0, 0, 1, 0, 0};
    double mean[3];
    const int unit = unit_of(points, (int64_t)(n + 1) * (m + 1));
    const double size = size_about_mean(points, (int64_t)(n + 1) * (m + 1), unit, mean);
    taut_twice w[2];

    taut_certify_laplacian_weights(a, b, w);
    for (int i = 0; i <= n; i++) {
        double fu[5];
        fill_factors(n, i, fu);
        for (int j = 0; j <= m; j++) {
            double fv[5];
            fill_factors(m, j, fv);
            for (int c = 0; c < 3; c++) {
                const taut_twice along_u = apply_factors(fu, n, i, points, j, m + 1, c, unit);
                const taut_twice along_v =
                    apply_factors(fv, m, j, points, (int64_t)i * (m + 1), 1, c, unit);
                const double r = fabs(taut_twice_round(taut_twice_add(
                    taut_twice_times(w[0], along_u), taut_twice_times(w[1], along_v))));
                if (!(r <= found.largest)) {
                    found.largest = r;
                    found.i = i;
                    found.j = j;
                }
            }
        }
    }
    for (int64_t k = 0; size > 0 && k < INT64_C(3) * (n + 1) * (m + 1); k++) {
        found.reach =
            taut_certify_max(found.reach, ldexp(fmax(fabs(points[k]), DBL_MIN), -unit) / size);
    }
    /* what the Laplacian of a net of this size may be: of degree 1 a direction has no part in it */
    const double most = fmax(n > 1 ? w[0].high * n * n : 0, m > 1 ? w[1].high * m * m : 0);
    found.scaled = size > 0 && found.largest > 0 ? found.largest / (most * size) : 0;
    found.size = ldexp(size, unit);
    found.largest = ldexp(found.largest / (fmin(a, b) * fmin(a, b)), unit);
    return found;
}
