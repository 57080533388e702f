/* vertices.c -- docs/papers/minimal-mesh.md section 11, divided through by powers of w.
 *
 * With sign -, u = w p, v = w q, and x^ = 2 (r - r(0,0)) / w^2 of the normalised family, the
 * tangent planes n.X = h at (u, v) become, with e = 1 - lambda = w^2 / (1 + lambda),
 *
 *     n = (-w sin u, -w sinh v, lambda cosh v - cos u)
 *     h = cosh v - lambda cos u - lambda u sin u - v sinh v
 *
 * Differences over the two nodes in u and in v, and the mean of all four, are three planes that
 * determine the vertex. Every function is written as a power of its argument times a series in its
 * square, so that w^3 and w^4 divide out:
 *
 *     f3 = (x - sin x)/x^3       s3 = (sin x - x cos x)/x^3     c2 = (1 - cos x)/x^2
 *     s1 = sin x / x             q4 = (2 - 2 cos x - x sin x)/x^4
 *
 * and the same of sinh and cosh with the signs that make them positive.
 */
#include "construct/panels/vertices.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"

#include <math.h>

/* One direction: circular, or hyperbolic. */
typedef struct kernel {
    double sign; /* of x^2 in the series */
    double (*sine)(double);
    double (*cosine)(double);
} kernel;

static const kernel circular = {-1, taut_sin, taut_cos}, hyperbolic = {1, taut_sinh, taut_cosh};

/* sum_j (2 j + 2)^weighted / (2 j + first)! (sign x^2)^j, |x| <= 1 */
static double series(const kernel *k, double x, int first, int weighted)
{
    enum { TERMS = 10 }; /* 20 / 23! is below 2^-60 of the sum */
    double factorial = 1, power = 1, sum = 0;
    for (int n = 2; n <= first; n++) {
        factorial *= n;
    }
    for (int j = 0; j < TERMS; j++) {
        sum += (weighted ? 2.0 * j + 2 : 1.0) * power / factorial;
        power *= k->sign * x * x;
        factorial *= (2.0 * j + first + 1) * (2.0 * j + first + 2);
    }
    return sum;
}

static double s1(const kernel *k, double x)
{
    return x == 0 ? 1 : k->sine(x) / x;
}

static double c2(const kernel *k, double x)
{
    const double half = s1(k, 0.5 * x);
    return 0.5 * half * half;
}

static double f3(const kernel *k, double x)
{
    return fabs(x) <= 1 ? series(k, x, 3, 0) : k->sign * (k->sine(x) - x) / (x * x * x);
}

static double s3(const kernel *k, double x)
{
    return fabs(x) <= 1 ? series(k, x, 3, 1)
                        : k->sign * (x * k->cosine(x) - k->sine(x)) / (x * x * x);
}

static double q4(const kernel *k, double x)
{
    return fabs(x) <= 1 ? series(k, x, 4, 1)
                        : (k->sign * x * k->sine(x) - 2 * (k->cosine(x) - 1)) / (x * x * x * x);
}

/* What one direction brings to the vertex at t of step 2 h. */
typedef struct side {
    double sine, cosine; /* sin(w t)/w, cos(w t) */
    double share;        /* cos(w h): what the mean of two leaves of them */
    double even;         /* mean of t^2 c2 over the two nodes */
    double odd;          /* mean of t^2 s1 */
    double fourth;       /* mean of t^4 q4 */
    double difference;   /* t^3 s3 + h^2 (s3/s1)(h) sine */
} side;

static side side_of(const kernel *k, double w, double t, double h)
{
    side s = {t * s1(k, w * t), k->cosine(w * t), k->cosine(w * h), 0, 0, 0, 0};
    for (int node = -1; node <= 1; node += 2) {
        const double at = t + node * h, square = at * at;
        s.even += 0.5 * square * c2(k, w * at);
        s.odd += 0.5 * square * s1(k, w * at);
        s.fourth += 0.5 * square * square * q4(k, w * at);
    }
    s.difference = t * t * t * s3(k, w * t) + h * h * s3(k, w * h) / s1(k, w * h) * s.sine;
    return s;
}

static double line(const taut_panels_window *window, int d, int i)
{
    return window->middle[d] + (i - 0.5 * window->count[d]) * window->step[d];
}

/* The three planes
 *     cos u x - sin u/w z = r1,   cosh v y - lambda sinh v/w z = r2,
 *     -cos(a/2) sin u/w x - cosh(b/2) sinh v/w y + m z = r3 */
double taut_panels_conical(const taut_panels_window *window, int i, int j, double x[3])
{
    const double l = window->lambda, w = window->w, e = 1 / (1 + l); /* (1 - lambda) / w^2 */
    const side u = side_of(&circular, w, line(window, 0, i), 0.5 * window->step[0]);
    const side v = side_of(&hyperbolic, w, line(window, 1, j), 0.5 * window->step[1]);
    const double r1 = -2 * (e * u.sine + l * u.difference);
    const double r2 = 2 * (e * v.sine + v.difference);
    const double r3 = 2 * (u.fourth - v.fourth + e * (u.odd - u.even - v.even));
    const double m = u.even + v.even - e * v.cosine * v.share;
    /* y out of the third by the second, whose cosh v is never small */
    const double m2 = m - l * v.share * v.sine * v.sine / v.cosine;
    const double r4 = r3 + v.share * v.sine * r2 / v.cosine;
    const double determinant = u.cosine * m2 - u.share * u.sine * u.sine;

    x[2] = (u.cosine * r4 + u.share * u.sine * r1) / determinant;
    x[0] = (m2 * r1 + u.sine * r4) / determinant;
    x[1] = (r2 + l * v.sine * x[2]) / v.cosine;
    /* determinant = -(cos(a/2) cosh v - lambda cosh(b/2) cos u) / (w^2 cosh v): its share of what
     * it is for a = b = 0 */
    if (w * window->step[0] >= TAUT_PI) {
        return 0;
    }
    const double p = line(window, 0, i), q = line(window, 1, j);
    return -determinant * v.cosine /
           (e + q * q * c2(&hyperbolic, w * q) + l * p * p * c2(&circular, w * p));
}

void taut_panels_surface(const taut_panels_window *window, int i, int j, double x[3])
{
    const double l = window->lambda, w = window->w, e = 1 / (1 + l);
    const double p = line(window, 0, i), q = line(window, 1, j);
    const double u2 = p * p * c2(&circular, w * p), v2 = q * q * c2(&hyperbolic, w * q);
    x[0] = 2 * (-e * p + p * p * p * f3(&circular, w * p) - p * s1(&circular, w * p) * v2);
    x[1] = 2 * (e * q + l * (u2 * q * s1(&hyperbolic, w * q) - q * q * q * f3(&hyperbolic, w * q)));
    x[2] = 2 * (u2 * taut_cosh(w * q) - v2);
}

/* The surface, but with n sin a for the parameter n a and m sinh b for m b. */
void taut_panels_circular(const taut_panels_window *window, int i, int j, double x[3])
{
    const double l = window->lambda, w = window->w, e = 1 / (1 + l);
    const double n[2] = {i - 0.5 * window->count[0], j - 0.5 * window->count[1]};
    const double a = window->step[0], b = window->step[1];
    const double a3 = n[0] * a * a * a * f3(&circular, w * a);   /* n (a - sin a) */
    const double b3 = n[1] * b * b * b * f3(&hyperbolic, w * b); /* m (sinh b - b) */
    taut_panels_surface(window, i, j, x);
    x[0] += 2 * (e * w * w * a3 - a3);
    x[1] += 2 * (e * w * w * b3 + l * b3);
}

void taut_panels_place(const taut_panels_window *window, const double x[3], double placed[3])
{
    for (int c = 0; c < 3; c++) {
        const double *row = window->matrix[c];
        placed[c] = row[0] * (window->factor * x[0]) + row[1] * (window->factor * x[1]) +
                    row[2] * (window->factor * x[2] + window->lift) + row[3];
    }
}
