#include "construct/bonnet/net.h"

#include "basis/quasi_kernel.h"
#include "core/elementary/elementary.h"

#include <math.h>

/* The odd part of x - sin x or sinh x - x, accurate also for small x: x^3/6 -+ x^5/120 + ... */
static double cubic_rest(int hyperbolic, double x)
{
    const double sign = hyperbolic ? 1 : -1;
    double term = x * x * x / 6, sum = term;
    if (fabs(x) > 1) {
        return hyperbolic ? taut_sinh(x) - x : x - taut_sin(x);
    }
    for (int n = 4; fabs(term) > 1e-18 * fabs(sum); n += 2) {
        term *= sign * x * x / ((double)n * (n + 1));
        sum += term;
    }
    return sum;
}

/* 1 - cos x or cosh x - 1 */
static double square_rest(int hyperbolic, double x)
{
    const double half = hyperbolic ? taut_sinh(0.5 * x) : taut_sin(0.5 * x);
    return 2 * half * half;
}

/* Any function of the space has the coefficients
 *     phi(x0), phi(x0) + k phi'(x0), phi(x1) - k phi'(x1), phi(x1). */
static void fill_window(double k, double at0, double slope0, double at1, double slope1, double *c)
{
    c[0] = at0;
    c[1] = at0 + k * slope0;
    c[2] = at1 - k * slope1;
    c[3] = at1;
}

/* cosh x1 - k sinh x1 = (1-k) cosh x1 + k exp(-x1), and the like: k is near 1 on long segments,
 * where the plain forms lose as many digits as exp(x) has (section 9). */
static void hyperbolic_inner(const taut_quasi_segment *segment, double x0, double x1,
                             taut_bonnet_rows *rows)
{
    const double k = segment->k, q = segment->q;
    if (x1 > 0) {
        rows->c[2] = q * taut_cosh(x1) + k * taut_exp(-x1);
        rows->s[2] = q * taut_sinh(x1) - k * taut_exp(-x1);
    }
    if (x1 > 1) { /* nearer to zero f and g are smaller than what they come from */
        rows->f[2] = rows->s[2] - rows->t[2];
        rows->g[2] = rows->c[2] - 1;
    }
    if (x0 < 0) {
        rows->c[1] = q * taut_cosh(x0) + k * taut_exp(x0);
        rows->s[1] = q * taut_sinh(x0) + k * taut_exp(x0);
    }
    if (x0 < -1) {
        rows->f[1] = rows->s[1] - rows->t[1];
        rows->g[1] = rows->c[1] - 1;
    }
}

void taut_bonnet_bezier_rows(int hyperbolic, double start, double length, taut_bonnet_rows *rows)
{
    const taut_quasi_kernel *kernel = hyperbolic ? &taut_quasi_hyperbolic : &taut_quasi_circular;
    const double x0 = start, x1 = start + length;
    const double s0 = hyperbolic ? taut_sinh(x0) : taut_sin(x0),
                 c0 = hyperbolic ? taut_cosh(x0) : taut_cos(x0);
    const double s1 = hyperbolic ? taut_sinh(x1) : taut_sin(x1),
                 c1 = hyperbolic ? taut_cosh(x1) : taut_cos(x1);
    taut_quasi_segment segment;

    kernel->prepare(length, &segment);
    const double k = segment.k;
    rows->count = 4;
    fill_window(k, x0, 1, x1, 1, rows->t);
    fill_window(k, s0, c0, s1, c1, rows->s);
    fill_window(k, c0, hyperbolic ? s0 : -s0, c1, hyperbolic ? s1 : -s1, rows->c);
    fill_window(k, cubic_rest(hyperbolic, x0), square_rest(hyperbolic, x0),
                cubic_rest(hyperbolic, x1), square_rest(hyperbolic, x1), rows->f);
    fill_window(k, square_rest(hyperbolic, x0), s0, square_rest(hyperbolic, x1), s1, rows->g);
    if (hyperbolic && length > 1) {
        hyperbolic_inner(&segment, x0, x1, rows);
    }
    if (start == 0) { /* f vanishes threefold at 0: exact zeros instead of cancellation */
        const double h = 0.5 * length, sh = hyperbolic ? taut_sinh(h) : taut_sin(h);
        rows->f[1] = rows->f[2] = rows->g[1] = 0;
        /* 2 (sin h - h cos h) / sin h, 2 (h cosh h - sinh h) / sinh h, by m / f = c of the segment:
         * m = sin^3 h / (sin h - h cos h), so the quotient is 2 sin^2 h / m */
        rows->g[2] = 2 * sh * sh / (segment.c * segment.f);
    }
}

/* Knots start + i length; X_i = start + (i-1) length: t has X_i, the pair A s(X_i), A c(X_i), with
 * A = length / sin(length) or length / sinh(length). */
void taut_bonnet_bspline_rows(int hyperbolic, double start, double length, int segments,
                              taut_bonnet_rows *rows)
{
    const double amplitude = length / (hyperbolic ? taut_sinh(length) : taut_sin(length));
    rows->count = segments + 3;
    for (int i = 0; i < rows->count; i++) {
        const double x = start + (i - 1) * length;
        rows->t[i] = x;
        rows->s[i] = amplitude * (hyperbolic ? taut_sinh(x) : taut_sin(x));
        rows->c[i] = amplitude * (hyperbolic ? taut_cosh(x) : taut_cos(x));
    }
}
