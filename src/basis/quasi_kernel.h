/* quasi_kernel.h -- one segment of the quasi-Bezier bases: {1, t, sin t, cos t} ("circular") and
 * {1, t, sinh t, cosh t} ("hyperbolic"). [XuWang2006] section 3.
 *
 * On a segment of length a, local t in [0, a], the four functions U_0..U_3 are
 *
 *     U_3 = f(t) / f(a)                       f = t - sin t     or  sinh t - t
 *     U_2 = m g(t) (k(a) - k(t)) / f(a)       g = 1 - cos t     or  cosh t - 1,   k = f/g
 *     U_1(t) = U_2(a - t),  U_0(t) = U_3(a - t)
 *     m = sin^3 h / (sin h - h cos h)  or  sinh^3 h / (h cosh h - sinh h),        h = a/2
 */
#ifndef TAUT_BASIS_QUASI_KERNEL_H
#define TAUT_BASIS_QUASI_KERNEL_H

/* What a segment's length decides, worked out once. */
typedef struct taut_quasi_segment {
    double length; /* a */
    double f;      /* f(a) */
    double k;      /* f(a)/g(a), the end derivative is 1/k: U_1'(0) = -U_0'(0) = 1/k */
    double q;      /* 1 - k, by g q = a + expm1(-a) where k is near 1; hyperbolic only */
    double c;      /* m / f(a) */
    double rho;    /* k/(2a): the quasi-B-spline at a knot is rho, 1 - 2 rho, rho */
} taut_quasi_segment;

enum { TAUT_QUASI_ROWS = 4 }; /* derivatives 0..3 */

typedef struct taut_quasi_kernel {
    void (*prepare)(double length, taut_quasi_segment *segment);
    /* values[d] = { U_2^(d)(t), U_3^(d)(t) }, d = 0..order, order <= 3, t in [0, length]. */
    void (*half)(const taut_quasi_segment *segment, double t, int order, double (*values)[2]);
    double sign; /* fourth derivatives are sign times the second: -1 circular, 1 hyperbolic */
    double (*middle)(double length); /* cos(length/2) or cosh(length/2) */
    /* y'' = -y, or y'' = y: |y(t)| <= at |y(m)| + slope |y'(m)| for |t - m| <= reach. */
    void (*growth)(double reach, double *at, double *slope);
} taut_quasi_kernel;

extern const taut_quasi_kernel taut_quasi_circular;   /* lengths in (0, pi] */
extern const taut_quasi_kernel taut_quasi_hyperbolic; /* lengths in (0, TAUT_QUASI_LONGEST] */

#define TAUT_QUASI_LONGEST 700.0 /* cosh of a hyperbolic segment must not overflow */

#endif /* TAUT_BASIS_QUASI_KERNEL_H */
