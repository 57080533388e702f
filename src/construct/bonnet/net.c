#include "construct/bonnet/net.h"

#include "core/elementary/elementary.h"

#include <math.h>

double taut_bonnet_frame_lambda(const taut_bonnet_problem *problem, int i)
{
    const double *l = problem->lambda;
    const int frames = problem->frames;
    return i == 0 ? l[0] : i + 1 == frames ? l[1] : l[0] + (l[1] - l[0]) * i / (frames - 1);
}

/* points = cos(theta) r + sin(theta) r*; theta = 0 leaves r as it is. */
static void turn_point(double theta, const double r[3], const double adjoint[3], double *point)
{
    const double c = theta == 0 ? 1 : taut_cos(theta), s = theta == 0 ? 0 : taut_sin(theta);
    for (int i = 0; i < 3; i++) {
        point[i] = c * r[i] + s * adjoint[i];
    }
}

/* r  = ((lambda t_i + s sin_i cosh_j)/w, (t_j + s lambda cos_i sinh_j)/w, s cos_i cosh_j)
 * r* = ((lambda t_j + s cos_i sinh_j)/w, -(t_i + s lambda sin_i cosh_j)/w, -s sin_i sinh_j) */
void taut_bonnet_net(double lambda, int sign, double theta, const taut_bonnet_rows *u,
                     const taut_bonnet_rows *v, double *points)
{
    const double w = sqrt((1 - lambda) * (1 + lambda)), s = sign;
    for (int i = 0; i < u->count; i++) {
        for (int j = 0; j < v->count; j++) {
            const double r[3] = {(lambda * u->t[i] + s * u->s[i] * v->c[j]) / w,
                                 (v->t[j] + s * lambda * u->c[i] * v->s[j]) / w,
                                 s * u->c[i] * v->c[j]};
            const double adjoint[3] = {(lambda * v->t[j] + s * u->c[i] * v->s[j]) / w,
                                       -(u->t[i] + s * lambda * u->s[i] * v->c[j]) / w,
                                       -s * u->s[i] * v->s[j]};
            turn_point(theta, r, adjoint, points + 3 * (i * v->count + j));
        }
    }
}

/* 2 (r_-(u, v) - r_-(0, 0)) / w^2 with f = u - sin u or sinh v - v, g = 1 - cos u or cosh v - 1,
 * e = 1 - lambda:
 *     x = 2/w^3 (-e u + f - sin u g),  y = 2/w^3 (e v - lambda (f - g sinh v)),
 *     z = 2/w^2 (g cosh v - g),  and so its adjoint. */
void taut_bonnet_normalised_net(double lambda, double theta, const taut_bonnet_rows *u,
                                const taut_bonnet_rows *v, double *points)
{
    const double e = 1 - lambda, w2 = e * (1 + lambda), w3 = w2 * sqrt(w2);
    for (int i = 0; i < u->count; i++) {
        for (int j = 0; j < v->count; j++) {
            const double r[3] = {2 / w3 * (-e * u->t[i] + u->f[i] - u->s[i] * v->g[j]),
                                 2 / w3 * (e * v->t[j] - lambda * (v->f[j] - u->g[i] * v->s[j])),
                                 2 / w2 * (u->g[i] * v->c[j] - v->g[j])};
            const double adjoint[3] = {2 / w3 * (-e * v->t[j] - v->f[j] + u->g[i] * v->s[j]),
                                       -2 / w3 *
                                           (e * u->t[i] + lambda * (u->f[i] - u->s[i] * v->g[j])),
                                       2 / w2 * u->s[i] * v->s[j]};
            turn_point(theta, r, adjoint, points + 3 * (i * v->count + j));
        }
    }
}

/* Bernstein coefficients of t, t^2, t^3 on [a, b], degree 3: their blossoms. */
static void powers(const double window[2], double c[3][4])
{
    const double a = window[0], b = window[1];
    for (int i = 0; i < 4; i++) {
        const double x = i > 2 ? b : a, y = i > 1 ? b : a, z = i > 0 ? b : a;
        c[0][i] = (x + y + z) / 3;
        c[1][i] = (x * y + y * z + z * x) / 3;
        c[2][i] = x * y * z;
    }
}

/* r  = (-(p - p^3/3 + p q^2), q - q^3/3 + p^2 q, p^2 - q^2)
 * r* = (-q - q^3/3 + p^2 q, -p - p^3/3 + p q^2, 2 p q) */
void taut_bonnet_enneper_net(double theta, const double p[2], const double q[2], double *points)
{
    double a[3][4], b[3][4];
    powers(p, a);
    powers(q, b);
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            const double r[3] = {-a[0][i] + a[2][i] / 3 - a[0][i] * b[1][j],
                                 b[0][j] - b[2][j] / 3 + a[1][i] * b[0][j], a[1][i] - b[1][j]};
            const double adjoint[3] = {-b[0][j] - b[2][j] / 3 + a[1][i] * b[0][j],
                                       -a[0][i] - a[2][i] / 3 + a[0][i] * b[1][j],
                                       2 * a[0][i] * b[0][j]};
            turn_point(theta, r, adjoint, points + 3 * (4 * i + j));
        }
    }
}
