/* quasi_kernel.c -- the two upper functions of a segment, in forms that lose no digits.
 *
 * The matrix that [XuWang2006] prints has condition 110 a^-3; these forms (minimal-mesh page,
 * sections 3 and 9) keep the error below a few units of 2^-53 of the largest function:
 *
 *     U_2    = c g (k(a) - f/g)        U_3    = f / f(a)
 *     U_2'   = c (k s - g)             U_3'   = g / f(a)
 *     U_2''  = c (k x - s)             U_3''  = s / f(a)         s, x: sin, cos or sinh, cosh
 *     U_2''' = c (-+ k s - x)          U_3''' = x / f(a)         - circular, + hyperbolic
 *
 * f by its series below t = 2. A long hyperbolic segment has k near 1; there, with q = 1 - k and
 * g(t) q(t) = t - 1 + exp(-t),
 *
 *     U_2 = c g (q(t) - q),  U_2' = c (1 - e^-t - q s),  U_2'' = c (e^-t - q x),
 *     U_2''' = c (-e^-t - q s)
 *
 * Below a = 2^-27 both kinds are the cubic Bernstein polynomials to within a^2/2 < 2^-54.
 */
#include "basis/quasi_kernel.h"

#include "core/elementary/elementary.h"

#include <math.h>

enum { SERIES = 12 }; /* enough for t <= 2: the first term left out is below 1e-18 of the sum */

static const double inverse_odd_factorial[SERIES] = {
    /* 1 / (2 i + 3)! */
    1.0 / 6,
    1.0 / 120,
    1.0 / 5040,
    1.0 / 362880,
    1.0 / 39916800,
    1.0 / 6227020800.0,
    1.0 / 1307674368000.0,
    1.0 / 355687428096000.0,
    1.0 / 121645100408832000.0,
    1.0 / 51090942171709440000.0,
    1.0 / 25852016738884976640000.0,
    1.0 / 15511210043330985984000000.0,
};

/* t^3/3! +- t^5/5! + ...: t - sin t for sign -1, sinh t - t for sign 1; |t| <= 2. */
static double f_series(double sign, double t)
{
    const double x = sign * t * t;
    double sum = inverse_odd_factorial[SERIES - 1];
    for (int i = SERIES - 2; i >= 0; i--) {
        sum = inverse_odd_factorial[i] + x * sum;
    }
    return t * t * t * sum;
}

/* sum_{i>=0} (2i+2)/(2i+3)! sign^i h^(2i+3): sin h - h cos h, or h cosh h - sinh h; |h| <= 2. */
static double d_series(double sign, double h)
{
    const double x = sign * h * h;
    double sum = 2 * SERIES * inverse_odd_factorial[SERIES - 1];
    for (int i = SERIES - 2; i >= 0; i--) {
        sum = (2 * i + 2) * inverse_odd_factorial[i] + x * sum;
    }
    return h * h * h * sum;
}

static int is_polynomial(double length)
{
    return length < 0x1p-27;
}

static void prepare_polynomial(double a, taut_quasi_segment *segment)
{
    segment->length = a;
    segment->f = a * a * a / 6;
    segment->k = a / 3;
    segment->q = 1 - a / 3;
    segment->c = 18 / (a * a * a);
    segment->rho = 1.0 / 6;
}

/* U_2 = 3 s^2 (1 - s), U_3 = s^3, s = t/a, and a^-1 for each derivative. */
static void half_polynomial(double a, double t, int order, double (*values)[2])
{
    const double s = t / a;
    const double rows[TAUT_QUASI_ROWS][2] = {{3 * s * s * (1 - s), s * s * s},
                                             {(6 - 9 * s) * s, 3 * s * s},
                                             {6 - 18 * s, 6 * s},
                                             {-18, 6}};
    double scale = 1;
    for (int d = 0; d <= order; d++) {
        values[d][0] = scale * rows[d][0];
        values[d][1] = scale * rows[d][1];
        scale /= a;
    }
}

/* c g (k - f/g), 0 exactly at the far end. */
static double upper_value(const taut_quasi_segment *segment, double f, double g)
{
    return g > 0 ? segment->c * g * (segment->k - f / g) : 0;
}

static double f_circular(double t)
{
    return t < 2 ? f_series(-1, t) : t - taut_sin(t);
}

static void prepare_circular(double a, taut_quasi_segment *segment)
{
    const double h = a / 2, s = taut_sin(h);

    if (is_polynomial(a)) {
        prepare_polynomial(a, segment);
        return;
    }
    segment->length = a;
    segment->f = f_circular(a);
    segment->k = segment->f / (2 * s * s);
    segment->q = 1 - segment->k;
    segment->c = s * s * s / (d_series(-1, h) * segment->f);
    segment->rho = segment->k / (2 * a);
}

static void half_circular(const taut_quasi_segment *segment, double t, int order,
                          double (*values)[2])
{
    if (is_polynomial(segment->length)) {
        half_polynomial(segment->length, t, order, values);
        return;
    }
    double sh, xh;
    taut_sin_cos(t / 2, &sh, &xh);
    const double f = f_circular(t), g = 2 * sh * sh;
    const double s = 2 * sh * xh, x = 1 - g;
    const double c = segment->c, k = segment->k;

    values[0][0] = upper_value(segment, f, g);
    values[0][1] = f / segment->f;
    if (order >= 1) {
        values[1][0] = c * (k * s - g);
        values[1][1] = g / segment->f;
    }
    if (order >= 2) {
        values[2][0] = c * (k * x - s);
        values[2][1] = s / segment->f;
    }
    if (order >= 3) {
        values[3][0] = c * (-k * s - x);
        values[3][1] = x / segment->f;
    }
}

static double middle_circular(double length)
{
    return taut_cos(length / 2);
}

static double f_hyperbolic(double t)
{
    return t < 2 ? f_series(1, t) : taut_sinh(t) - t;
}

/* Long enough that k is nearer to 1 than to 0. */
static int is_long(double length)
{
    return length >= 2;
}

static void prepare_hyperbolic(double a, taut_quasi_segment *segment)
{
    const double h = a / 2, s = taut_sinh(h);

    if (is_polynomial(a)) {
        prepare_polynomial(a, segment);
        return;
    }
    segment->length = a;
    segment->f = f_hyperbolic(a);
    segment->k = segment->f / (2 * s * s);
    segment->q = is_long(a) ? (a + taut_expm1(-a)) / (2 * s * s) : 1 - segment->k;
    /* s^3 / (h cosh h - s), divided by s where s^3 could overflow */
    segment->c = h < 2 ? s * s * s / (d_series(1, h) * segment->f)
                       : s * s / (h / taut_tanh(h) - 1) / segment->f;
    segment->rho = segment->k / (2 * a);
}

static void half_hyperbolic(const taut_quasi_segment *segment, double t, int order,
                            double (*values)[2])
{
    if (is_polynomial(segment->length)) {
        half_polynomial(segment->length, t, order, values);
        return;
    }
    double sh, xh;
    taut_sinh_cosh(t / 2, &sh, &xh);
    const double f = f_hyperbolic(t), g = 2 * sh * sh;
    const double s = 2 * sh * xh, x = 1 + g;
    const double c = segment->c, k = segment->k, q = segment->q;
    const int by_q = is_long(segment->length) && t > 1;

    values[0][0] = by_q ? c * g * ((t + taut_expm1(-t)) / g - q) : upper_value(segment, f, g);
    values[0][1] = f / segment->f;
    if (order >= 1) {
        values[1][0] = by_q ? c * (-taut_expm1(-t) - q * s) : c * (k * s - g);
        values[1][1] = g / segment->f;
    }
    if (order >= 2) {
        values[2][0] = by_q ? c * (taut_exp(-t) - q * x) : c * (k * x - s);
        values[2][1] = s / segment->f;
    }
    if (order >= 3) {
        values[3][0] = by_q ? c * (-taut_exp(-t) - q * s) : c * (k * s - x);
        values[3][1] = x / segment->f;
    }
}

static double middle_hyperbolic(double length)
{
    return taut_cosh(length / 2);
}

/* y(t) = y(m) cos(t - m) + y'(m) sin(t - m); reach is at most pi/2. */
static void growth_circular(double reach, double *at, double *slope)
{
    *at = 1;
    *slope = taut_sin(reach);
}

static void growth_hyperbolic(double reach, double *at, double *slope)
{
    *at = taut_cosh(reach);
    *slope = taut_sinh(reach);
}

const taut_quasi_kernel taut_quasi_circular = {prepare_circular, half_circular, -1, middle_circular,
                                               growth_circular};
const taut_quasi_kernel taut_quasi_hyperbolic = {prepare_hyperbolic, half_hyperbolic, 1,
                                                 middle_hyperbolic, growth_hyperbolic};
