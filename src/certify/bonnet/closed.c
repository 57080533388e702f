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
#include "certify/bonnet/local.h"
#include "certify/bonnet/parts.h"

#include "certify/common/verdict.h"
#include "core/constants.h"
#include "core/elementary/complex.h"

#include <math.h>

/* The largest coordinate met, the largest distance and noise, and where. */
typedef struct compared {
    double size, apart, noise;
    double at[2];
} compared;

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
        return sign > 0 ? taut_sinh(x) - x : x - taut_sin(x);
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
    const double su = taut_sin(0.5 * u), sv = taut_sinh(0.5 * v), gu = 2 * su * su,
                 gv = 2 * sv * sv;
    const double fu = third_rest(u, -1), fv = third_rest(v, 1);
    r[0][0] = f / w * (fu - (1 - lambda) * u - taut_sin(u) * gv);
    r[0][1] = f / w * ((1 - lambda) * v - lambda * (fv - gu * taut_sinh(v)));
    r[0][2] = f * (gu * taut_cosh(v) - gv);
    r[1][0] = f / w * (gu * taut_sinh(v) - fv - (1 - lambda) * v);
    r[1][1] = f / w * (lambda * (taut_sin(u) * gv - fu) - (1 - lambda) * u);
    r[1][2] = f * taut_sin(u) * taut_sinh(v);
    *gross = 2 * f / w *
                 (fabs(fu) + fabs(fv) + (1 - lambda) * (fabs(u) + fabs(v)) +
                  fabs(taut_sin(u)) * gv + gu * fabs(taut_sinh(v))) +
             2 * f * (gu * taut_cosh(v) + gv + fabs(taut_sin(u) * taut_sinh(v)));
}

/* A parameter is known to 2^-53 of itself, and so is what it moves: |u| |r_u| + |v| |r_v|. */
static void plain(double lambda, double s, double u, double v, double r[2][3], double *gross)
{
    const double w = w_of(lambda), f0 = taut_cosh(v) + s * lambda * taut_cos(u);
    r[0][0] = (lambda * u + s * taut_sin(u) * taut_cosh(v)) / w;
    r[0][1] = (v + s * lambda * taut_cos(u) * taut_sinh(v)) / w;
    r[0][2] = s * taut_cos(u) * taut_cosh(v);
    r[1][0] = (lambda * v + s * taut_cos(u) * taut_sinh(v)) / w;
    r[1][1] = -(u + s * lambda * taut_sin(u) * taut_cosh(v)) / w;
    r[1][2] = -s * taut_sin(u) * taut_sinh(v);
    *gross = (fabs(u) + fabs(v) + 2 * taut_cosh(v) + (fabs(u) + fabs(v)) * f0) / w;
}

static void exact_point(const taut_bonnet_frame *frame, double u, double v, double x[3],
                        double *gross)
{
    const taut_bonnet_problem *p = frame->problem;
    const double c = taut_cos(p->theta), s = taut_sin(p->theta);
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

/* Phi^(n) of r = Re Phi, n >= 1, zeta = u + i v; sizes of terms into *gross. */
static void phi(const taut_bonnet_frame *frame, int n, double u, double v, double complex out[3],
                double *gross)
{
    const taut_bonnet_problem *p = frame->problem;
    const double lambda = frame->lambda, s = p->normalize ? -1 : p->sign, w = w_of(lambda);
    const double f = p->normalize ? 2 / (w * w) : 1;
    const double complex zeta = u + I * v;
    const double complex sine = taut_sin(u) * taut_cosh(v) + I * taut_cos(u) * taut_sinh(v);
    const double complex cosine = taut_cos(u) * taut_cosh(v) - I * taut_sin(u) * taut_sinh(v);
    const double complex half =
        taut_sin(0.5 * u) * taut_cosh(0.5 * v) + I * taut_cos(0.5 * u) * taut_sinh(0.5 * v);

    if (p->normalize && lambda == 1) { /* (zeta^3/3 - zeta, -i (zeta + zeta^3/3), zeta^2) */
        const double complex cubic = n == 1 ? zeta * zeta : n == 2 ? 2 * zeta : n == 3 ? 2 : 0;
        out[0] = cubic - (n == 1 ? 1 : 0);
        out[1] = -I * (cubic + (n == 1 ? 1 : 0));
        out[2] = n == 1 ? 2 * zeta : n == 2 ? 2 : 0;
        *gross = 2 * (1 + taut_cabs(zeta)) * (1 + taut_cabs(zeta));
        return;
    }
    /* the n-th derivative of sin zeta and of cos zeta */
    const double turn = n % 4 == 0 || n % 4 == 1 ? 1 : -1;
    const double complex of_sine = turn * (n % 2 == 0 ? sine : cosine);
    const double complex of_cosine = n % 2 == 0 ? turn * cosine : -turn * sine;
    out[0] = f / w * s * of_sine;
    out[1] = -I * (f / w * s * lambda * of_sine);
    out[2] = f * s * of_cosine;
    *gross = f / w * 2 * taut_cosh(v);
    if (n == 1 && p->normalize) { /* 1 - cos zeta without cancellation */
        const double complex less = 2 * half * half;
        out[0] = f / w * (less - (1 - lambda));
        out[1] = -I * (f / w * (lambda * less + (1 - lambda)));
        *gross = f / w * (taut_cabs(less) + 1 - lambda) + f * taut_cabs(sine);
    } else if (n == 1) {
        out[0] += f / w * lambda;
        out[1] -= I * f / w;
        *gross += f / w;
    }
}

/* Of the formula, times L^(d+e), in the same way as those of a piece of the net: d^d/du^d d^e/dv^e
 * Re Phi = Re i^e Phi^(d+e). error[d][e] of a coordinate. */
static void formula_local(const taut_bonnet_frame *frame, const taut_bonnet_piece *piece,
                          double length, double x[4][4][3], double error[4][4])
{
    static const double complex powers[4] = {1, I, -1, -I};
    const double theta = frame->problem->theta;
    const double complex turn = theta == 0 ? 1 : taut_cos(theta) - I * taut_sin(theta);

    for (int n = 1; n <= 6; n++) {
        double complex derivative[3];
        double gross = 0;
        phi(frame, n, piece->middle[0], piece->middle[1], derivative, &gross);
        for (int d = n > 3 ? n - 3 : 0; d <= n && d < 4; d++) {
            const double factor = taut_pow(length, n);
            for (int c = 0; c < 3; c++) {
                x[d][n - d][c] = factor * creal(powers[n - d] * turn * derivative[c]);
            }
            error[d][n - d] = 16 * TAUT_UNIT_ROUNDOFF * factor * gross;
        }
    }
}

/* How far the net is from the formula on one piece, over the whole of it, and what rounding
 * explains of that. */
static void compare_piece(const taut_surface *surface, const taut_bonnet_scale *scale,
                          const taut_bonnet_frame *frame, const taut_bonnet_piece *piece,
                          compared *all)
{
    taut_bonnet_local l;
    double x[4][4][3], error[4][4], apart = 0, noise = 0, gross = 0;

    taut_bonnet_local_of(surface, scale, 0, piece, &l);
    formula_local(frame, piece, l.unit_length, x, error);
    exact_point(frame, piece->middle[0], piece->middle[1], x[0][0], &gross);
    error[0][0] = 4 * TAUT_UNIT_ROUNDOFF * gross;
    for (int d = 0; d < 4; d++) {
        for (int e = 0; e < 4; e++) {
            double most = 0;
            for (int c = 0; c < 3; c++) {
                const double from = d + e == 0 ? l.origin[c] : 0;
                most = taut_certify_max(most, fabs(l.x[d][e][c] + from - x[d][e][c]));
            }
            const double by = l.bound[0][d] * l.bound[1][e];
            apart += by * (most + l.own[d][e] + error[d][e]);
            noise += by * (l.points[d][e] + l.own[d][e] + error[d][e]);
        }
    }
    for (int c = 0; c < 3; c++) {
        all->size = fmax(all->size, fabs(x[0][0][c]));
    }
    noise += 16 * TAUT_UNIT_ROUNDOFF * gross;
    all->noise = taut_certify_max(all->noise, noise);
    if (!(apart <= all->apart)) {
        all->apart = apart;
        all->at[0] = piece->middle[0];
        all->at[1] = piece->middle[1];
    }
}

/* Are the bases those of the formula? */
static int has_bases(const taut_surface *surface, const taut_bonnet_frame *frame)
{
    const double wanted = frame->problem->normalize && frame->lambda == 1 ? 0 : 1;
    double sign[2] = {0, 0};
    return taut_bonnet_sign_of(taut_surface_u(surface), &sign[0]) &&
           taut_bonnet_sign_of(taut_surface_v(surface), &sign[1]) && sign[0] == -wanted &&
           sign[1] == wanted;
}

void taut_bonnet_against_formula(const taut_surface *surface, const taut_bonnet_scale *scale,
                                 const taut_bonnet_frame *frame, taut_bonnet_finding *found)
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    compared all = {0, 0, 0, {0, 0}};
    double lo[2], hi[2], aside = 0;

    if (!has_bases(surface, frame)) {
        taut_bonnet_raise(found, 1, 0, 0, 0);
        return;
    }
    window_of(frame, lo, hi);
    for (int d = 0; d < 2; d++) {
        aside = fmax(aside, fmax(fabs(taut_basis_lo(bases[d]) - lo[d]),
                                 fabs(taut_basis_hi(bases[d]) - hi[d])));
    }
    const taut_bonnet_cuts cuts = taut_bonnet_cuts_of(surface);
    for (int i = 0; i < cuts.count[0]; i++) {
        for (int j = 0; j < cuts.count[1]; j++) {
            const taut_bonnet_piece piece = taut_bonnet_piece_at(surface, &cuts, i, j);
            compare_piece(surface, scale, frame, &piece, &all);
        }
    }
    taut_bonnet_raise(found, taut_certify_max(aside, all.apart) / all.size, all.noise / all.size,
                      all.at[0], all.at[1]);
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
        add_product(&t, 1, v,
                    between(x + 2 * x * x * x / 3 + taut_pow(x, 5) / 5,
                            y + 2 * y * y * y / 3 + taut_pow(y, 5) / 5));
        add_product(&t, 2, between(p * p * p / 3, q * q * q / 3),
                    between(x + x * x * x / 3, y + y * y * y / 3));
        add_product(&t, 1, u, between(taut_pow(p, 5) / 5, taut_pow(q, 5) / 5));
        scale = 1;
    } else {
        add_product(&t, 1, u,
                    between(0.5 * lo[1] + 0.25 * taut_sinh(2 * lo[1]),
                            0.5 * hi[1] + 0.25 * taut_sinh(2 * hi[1])));
        add_product(&t, 2 * a, between(taut_sin(lo[0]), taut_sin(hi[0])),
                    between(taut_sinh(lo[1]), taut_sinh(hi[1])));
        add_product(&t, a * a, v,
                    between(0.5 * lo[0] + 0.25 * taut_sin(2 * lo[0]),
                            0.5 * hi[0] + 0.25 * taut_sin(2 * hi[0])));
        scale = frame->problem->normalize ? 4 / (w * w * w * w * w * w) : 1 / (w * w);
    }
    *area = scale * t.value;
    *noise = 4 * TAUT_UNIT_ROUNDOFF * t.gross / fabs(t.value);
}

/* sinh v int du / (cosh v + a cos u) from 0: atan(q tan(u/2)), beyond its first jump u/2 + atan of
 * ((q - 1) sin cos / (cos^2 + q sin^2)). */
static double along_v(double lambda, double a, double u, double v)
{
    const double half = taut_sinh(0.5 * v), low = 1 - lambda;
    const double minus = 2 * half * half + (a > 0 ? low : 1 - a); /* cosh v - a */
    const double plus = 2 * half * half + (a > 0 ? 1 + a : low);
    const double q = sqrt(minus / plus), s = taut_sin(0.5 * u), c = taut_cos(0.5 * u);
    const double turn = fabs(u) <= 3 ? taut_atan2(q * s, c)
                                     : 0.5 * u + taut_atan2((q - 1) * s * c, c * c + q * s * s);
    return 2 * taut_sinh(v) / sqrt(minus * plus) * turn;
}

/* -a sin u int dv / (cosh v + b) from 0, b = a cos u; 1 - |a| |cos u| = 1 - |a| + 2 |a| sin^2(u/2)
 * or the like. */
static double along_u(double lambda, double a, double u, double v)
{
    const double s = taut_sin(0.5 * u), c = taut_cos(0.5 * u);
    const double minus = 1 - lambda + 2 * lambda * s * s; /* 1 - lambda cos u */
    const double plus = 1 - lambda + 2 * lambda * c * c;
    const double ratio = a > 0 ? minus / plus : plus / minus;
    return -2 * a * taut_sin(u) / sqrt(minus * plus) * taut_atan(sqrt(ratio) * taut_tanh(0.5 * v));
}

/* 2 q int dp / (1 + p^2 + q^2) from 0, of Enneper's surface. */
static double along_enneper(double p, double q)
{
    const double root = sqrt(1 + q * q);
    return 2 * q / root * taut_atan(p / root);
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
