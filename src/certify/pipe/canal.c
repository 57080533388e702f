/* canal.c -- canal surfaces: envelopes of spheres about the axis ([WangBai2018] section 10.5).
 *
 * A point x is on the envelope where h(t) = |x - P(t)| - r(t) vanishes with h'(t) = 0; h is then
 * its distance from it to first order. h'' > 0 there is the condition that the envelope is regular:
 *     |x - P| h'' / |P'|^2 = 1 - r_s^2 - r r_ss - kappa_n r sqrt(1 - r_s^2)
 */
#include "certify/pipe/parts.h"
#include "core/constants.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <math.h>

enum { GAUSS = 12, INTERVALS = 32, NEWTON_STEPS = 20 };

/* r with its derivatives by the curve's parameter, local. */
static void evaluate_radius(const taut_pipe_parts *parts, double t, double r[3])
{
    const double scale = parts->line.scale;
    const double first = parts->ellipses[0].a / scale;
    const double change = parts->ellipses[1].a / scale - first;
    r[0] = first + change * t * t * (3 - 2 * t);
    r[1] = change * 6 * t * (1 - t);
    r[2] = change * 6 * (1 - 2 * t);
}

/* The axis with two derivatives by the curve's parameter. */
static void evaluate_axis(const taut_pipe_parts *parts, double t, double d[3][3])
{
    const taut_pipe_line *line = &parts->line;
    int i = 0;
    while (i + 1 < line->count && t > line->pieces[i].hi) {
        i++;
    }
    const double width = line->pieces[i].hi - line->pieces[i].lo;
    taut_pipe_piece_eval(&line->pieces[i], (t - line->pieces[i].lo) / width, 2, d);
    for (int k = 0; k < 3; k++) {
        d[1][k] /= width;
        d[2][k] /= width * width;
    }
}

double taut_pipe_canal_miss(const taut_pipe_parts *parts, const double x[3], double t,
                            double *convex)
{
    double d[3][3], r[3], apart[3], distance = 0;
    for (int step = 0; step <= NEWTON_STEPS; step++) {
        double slope = 0, bend = 0, along = 0, move = 0;
        evaluate_axis(parts, t, d);
        evaluate_radius(parts, t, r);
        taut_difference(d[0], x, apart);
        distance = taut_norm(apart);
        along = taut_dot(apart, d[1]);
        slope = along / distance - r[1];
        bend = (taut_dot(d[1], d[1]) + taut_dot(apart, d[2])) / distance -
               along * along / (distance * distance * distance) - r[2];
        *convex = distance * bend / taut_dot(d[1], d[1]);
        move = bend > 0 ? slope / bend : 0;
        if (fabs(move) < 1e-10 || step == NEWTON_STEPS) { /* h is flat there */
            break;
        }
        t = fmin(1, fmax(0, t - move));
    }
    return fabs(distance - r[0]) * parts->line.scale / parts->radius;
}

/* 2 pi integral of r (1 + r_s^2),  pi integral of r^2 (1 - r_s^2) (1 - r_s^2 - r r_ss), by arc
 * length */
void taut_pipe_canal_measures(const taut_pipe_parts *parts, double *area, double *volume)
{
    const double scale = parts->line.scale;
    double nodes[GAUSS], weights[GAUSS];
    *area = *volume = 0;
    taut_gauss_rule(GAUSS, nodes, weights);
    for (int k = 0; k < INTERVALS * GAUSS; k++) {
        const double t = (k / GAUSS + 0.5 * (1 + nodes[k % GAUSS])) / INTERVALS;
        double d[3][3], r[3], speed = 0;
        evaluate_axis(parts, t, d);
        evaluate_radius(parts, t, r);
        speed = taut_norm(d[1]);
        const double ds = 0.5 / INTERVALS * weights[k % GAUSS] * speed;
        const double rs = r[1] / speed;
        const double rss = (r[2] - rs * taut_dot(d[1], d[2]) / speed) / (speed * speed);
        *area += 2 * TAUT_PI * ds * r[0] * (1 + rs * rs);
        *volume += TAUT_PI * ds * r[0] * r[0] * (1 - rs * rs) * (1 - rs * rs - r[0] * rss);
    }
    *area *= scale * scale;
    *volume *= scale * scale * scale;
}
