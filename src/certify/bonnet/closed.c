/* closed.c -- what the surface of a problem must be: points, area and total curvature in
 * closed form. With F0 = cosh v + a cos u, a = sign lambda, E = G = F0^2/w^2, and K dA = -Delta log
 * F0 du dv, so that ([XuWang2006] section 1; the divergence theorem on the rectangle)
 *
 *     w^2 area = iint cosh^2 v + 2 a cos u cosh v + a^2 cos^2 u
 *     iint K dA = -[ sinh v  int du / F0 ] - [ -a sin u  int dv / F0 ]      over opposite edges
 *     int du / (c + a cos u)  = 2 / sqrt(c^2 - a^2) atan(sqrt((c - a) / (c + a)) tan(u/2))
 *     int dv / (cosh v + b)   = 2 / sqrt(1 - b^2) atan(sqrt((1 - b) / (1 + b)) tanh(v/2))
 *
 * The associate family is isometric; the normalised one is 2 / w^2 times as large.
 */
#include "certify/bonnet/parts.h"

#include "core/constants.h"

#include <math.h>

static double w_of(double lambda)
{
    return sqrt((1 - lambda) * (1 + lambda));
}

/* The window in the parameters of the surface: low[2], high[2]. */
static void window_of(const taut_bonnet_frame *frame, double low[2], double high[2])
{
    const taut_bonnet_problem *p = frame->problem;
    const double w = p->normalize && frame->lambda < 1 ? w_of(frame->lambda) : 1;
    const double lengths[2] = {p->alpha, p->beta};
    for (int d = 0; d < 2; d++) {
        const int segments = p->segments[d] > 0 ? p->segments[d] : 1;
        low[d] = w * p->start[d];
        high[d] = low[d] + segments * (w * lengths[d]);
    }
}

/* x - sin x (sign -1) or sinh x - x (sign 1); the series below 1, where it needs no more terms. */
static double third_rest(double x, int sign)
{
    double sum = 0;
    if (fabs(x) > 1) {
        return sign > 0 ? sinh(x) - x : x - sin(x);
    }
    for (int n = 21; n >= 3; n -= 2) {
        sum = (1 + sign * sum) * x * x / (n * (n - 1));
    }
    return sum * x;
}

/* Enneper's surface and its adjoint; sizes of terms into *gross. */
static void enneper(double p, double q, double r[2][3], double *gross)
{
    r[0][0] = p * (p * p / 3 - q * q - 1);
    r[0][1] = q * (1 + p * p - q * q / 3);
    r[0][2] = (p - q) * (p + q);
    r[1][0] = q * (p * p - q * q / 3 - 1);
    r[1][1] = p * (q * q - p * p / 3 - 1);
    r[1][2] = 2 * p * q;
    *gross = (fabs(p) + fabs(q)) * (1 + p * p + q * q) + p * p + q * q;
}

/* r_- - r_-(0, 0) without cancellation near the origin, times 2/w^2. */
static void normalised(double lambda, double u, double v, double r[2][3], double *gross)
{
    const double w = w_of(lambda), f = 2 / (w * w);
    const double su = sin(0.5 * u), sv = sinh(0.5 * v), gu = 2 * su * su, gv = 2 * sv * sv;
    const double fu = third_rest(u, -1), fv = third_rest(v, 1);
    r[0][0] = f / w * (fu - (1 - lambda) * u - sin(u) * gv);
    r[0][1] = f / w * ((1 - lambda) * v - lambda * (fv - gu * sinh(v)));
    r[0][2] = f * (gu * cosh(v) - gv);
    r[1][0] = f / w * (gu * sinh(v) - fv - (1 - lambda) * v);
    r[1][1] = f / w * (lambda * (sin(u) * gv - fu) - (1 - lambda) * u);
    r[1][2] = f * sin(u) * sinh(v);
    *gross = 2 * f / w *
                 (fabs(fu) + fabs(fv) + (1 - lambda) * (fabs(u) + fabs(v)) + fabs(sin(u)) * gv +
                  gu * fabs(sinh(v))) +
             2 * f * (gu * cosh(v) + gv + fabs(sin(u) * sinh(v)));
}

/* A parameter is known to 2^-53 of itself, and so is what it moves: |u| |r_u| + |v| |r_v|. */
static void plain(double lambda, double s, double u, double v, double r[2][3], double *gross)
{
    const double w = w_of(lambda), f0 = cosh(v) + s * lambda * cos(u);
    r[0][0] = (lambda * u + s * sin(u) * cosh(v)) / w;
    r[0][1] = (v + s * lambda * cos(u) * sinh(v)) / w;
    r[0][2] = s * cos(u) * cosh(v);
    r[1][0] = (lambda * v + s * cos(u) * sinh(v)) / w;
    r[1][1] = -(u + s * lambda * sin(u) * cosh(v)) / w;
    r[1][2] = -s * sin(u) * sinh(v);
    *gross = (fabs(u) + fabs(v) + 2 * cosh(v) + (fabs(u) + fabs(v)) * f0) / w;
}

static void exact_point(const taut_bonnet_frame *frame, double u, double v, double x[3],
                        double *gross)
{
    const taut_bonnet_problem *p = frame->problem;
    const double c = cos(p->theta), s = sin(p->theta);
    double r[2][3];
    if (p->normalize && frame->lambda == 1) {
        enneper(u, v, r, gross);
    } else if (p->normalize) {
        normalised(frame->lambda, u, v, r, gross);
    } else {
        plain(frame->lambda, p->sign, u, v, r, gross);
    }
    for (int i = 0; i < 3; i++) {
        x[i] = p->theta == 0 ? r[0][i] : c * r[0][i] + s * r[1][i];
    }
}

/* The largest coordinate of the net: a quasi-B-spline's may be far outside of its surface. */
static double net_size(const taut_surface *surface)
{
    const long count =
        3L * taut_basis_count(taut_surface_u(surface)) * taut_basis_count(taut_surface_v(surface));
    double size = 0;
    for (long i = 0; i < count; i++) {
        size = fmax(size, fabs(taut_surface_points(surface)[i]));
    }
    return size;
}

void taut_bonnet_against_formula(const taut_surface *surface, const taut_bonnet_frame *frame,
                                 taut_bonnet_finding *found)
{
    enum { STEPS = 32 };
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    double lo[2], hi[2], size = 0, apart = 0, noise = net_size(surface), at[2] = {0, 0};

    window_of(frame, lo, hi);
    for (int k = 0; k < (STEPS + 1) * (STEPS + 1); k++) {
        const int step[2] = {k / (STEPS + 1), k % (STEPS + 1)};
        double t[2], x[3], exact[3], gross = 0, distance = 0;
        for (int d = 0; d < 2; d++) {
            const double a = taut_basis_lo(bases[d]), b = taut_basis_hi(bases[d]);
            t[d] = step[d] == STEPS ? b : a + (b - a) * step[d] / STEPS;
            distance = fmax(distance, fmax(fabs(a - lo[d]), fabs(b - hi[d])));
        }
        taut_surface_eval(surface, t[0], t[1], 0, x);
        exact_point(frame, t[0], t[1], exact, &gross);
        for (int c = 0; c < 3; c++) {
            size = fmax(size, fabs(exact[c]));
            distance = fmax(distance, fabs(x[c] - exact[c]));
        }
        noise = fmax(noise, gross);
        if (distance > apart) {
            apart = distance;
            at[0] = t[0];
            at[1] = t[1];
        }
    }
    taut_bonnet_raise(found, apart == 0 ? 0 : apart / size, 2 * TAUT_UNIT_ROUNDOFF * noise / size,
                      at[0], at[1]);
}

/* A number and the sum of the absolute values of its terms. */
typedef struct total {
    double value, gross;
} total;

static void add_term(total *t, double term, double gross)
{
    t->value += term;
    t->gross += gross;
}

/* int f over [lo, hi] from the two values of an antiderivative, times `factor`. */
static total between(double at_lo, double at_hi)
{
    return (total){at_hi - at_lo, fabs(at_hi) + fabs(at_lo)};
}

static void add_product(total *t, double factor, total a, total b)
{
    add_term(t, factor * a.value * b.value,
             fabs(factor) * (fabs(a.value) * b.gross + a.gross * fabs(b.value)));
}

void taut_bonnet_closed_area(const taut_bonnet_frame *frame, double *area, double *noise)
{
    const double w = w_of(frame->lambda), a = frame->problem->sign * frame->lambda;
    double lo[2], hi[2], scale = 0;
    total t = {0, 0}, u, v;

    window_of(frame, lo, hi);
    u = between(lo[0], hi[0]);
    v = between(lo[1], hi[1]);
    if (frame->lambda == 1) { /* (1 + p^2 + q^2)^2 */
        const double x = lo[0], y = hi[0], p = lo[1], q = hi[1];
        add_product(
            &t, 1, v,
            between(x + 2 * x * x * x / 3 + pow(x, 5) / 5, y + 2 * y * y * y / 3 + pow(y, 5) / 5));
        add_product(&t, 2, between(p * p * p / 3, q * q * q / 3),
                    between(x + x * x * x / 3, y + y * y * y / 3));
        add_product(&t, 1, u, between(pow(p, 5) / 5, pow(q, 5) / 5));
        scale = 1;
    } else {
        add_product(
            &t, 1, u,
            between(0.5 * lo[1] + 0.25 * sinh(2 * lo[1]), 0.5 * hi[1] + 0.25 * sinh(2 * hi[1])));
        add_product(&t, 2 * a, between(sin(lo[0]), sin(hi[0])), between(sinh(lo[1]), sinh(hi[1])));
        add_product(
            &t, a * a, v,
            between(0.5 * lo[0] + 0.25 * sin(2 * lo[0]), 0.5 * hi[0] + 0.25 * sin(2 * hi[0])));
        scale = frame->problem->normalize ? 4 / (w * w * w * w * w * w) : 1 / (w * w);
    }
    *area = scale * t.value;
    *noise = 4 * TAUT_UNIT_ROUNDOFF * t.gross / fabs(t.value);
}

/* sinh v int du / (cosh v + a cos u) from 0: atan(q tan(u/2)), beyond its first jump u/2 + atan of
 * ((q - 1) sin cos / (cos^2 + q sin^2)). */
static double along_v(double lambda, double a, double u, double v)
{
    const double half = sinh(0.5 * v), low = 1 - lambda;
    const double minus = 2 * half * half + (a > 0 ? low : 1 - a); /* cosh v - a */
    const double plus = 2 * half * half + (a > 0 ? 1 + a : low);
    const double q = sqrt(minus / plus), s = sin(0.5 * u), c = cos(0.5 * u);
    const double turn =
        fabs(u) <= 3 ? atan2(q * s, c) : 0.5 * u + atan2((q - 1) * s * c, c * c + q * s * s);
    return 2 * sinh(v) / sqrt(minus * plus) * turn;
}

/* -a sin u int dv / (cosh v + b) from 0, b = a cos u; 1 - |a| |cos u| = 1 - |a| + 2 |a| sin^2(u/2)
 * or the like. */
static double along_u(double lambda, double a, double u, double v)
{
    const double s = sin(0.5 * u), c = cos(0.5 * u);
    const double minus = 1 - lambda + 2 * lambda * s * s; /* 1 - lambda cos u */
    const double plus = 1 - lambda + 2 * lambda * c * c;
    const double ratio = a > 0 ? minus / plus : plus / minus;
    return -2 * a * sin(u) / sqrt(minus * plus) * atan(sqrt(ratio) * tanh(0.5 * v));
}

/* 2 q int dp / (1 + p^2 + q^2) from 0, of Enneper's surface. */
static double along_enneper(double p, double q)
{
    const double root = sqrt(1 + q * q);
    return 2 * q / root * atan(p / root);
}

void taut_bonnet_closed_curvature(const taut_bonnet_frame *frame, double *sum, double *noise)
{
    const double lambda = frame->lambda, a = frame->problem->sign * lambda;
    double end[2][2];
    total t = {0, 0};

    window_of(frame, end[0], end[1]);
    for (int k = 0; k < 4; k++) {
        const double u = end[k / 2][0], v = end[k % 2][1];
        const double sign = k / 2 == k % 2 ? -1 : 1;
        const double one = lambda == 1 ? along_enneper(u, v) : along_v(lambda, a, u, v);
        const double two = lambda == 1 ? along_enneper(v, u) : along_u(lambda, a, u, v);
        add_term(&t, sign * one, fabs(one));
        add_term(&t, sign * two, fabs(two));
    }
    *sum = t.value;
    *noise = 4 * TAUT_UNIT_ROUNDOFF * t.gross / fabs(t.value);
}
