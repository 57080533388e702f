#include "construct/pipe/bend.h"

#include "core/vec3.h"
#include "numeric/bernstein.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <stddef.h>

enum { GAUSS = 16, ROOT_STEPS = 80, GRADED = 32 };

static const double cusp = 1e-12;

int taut_pipe_bend_is_cusp(const taut_pipe_bend *bend)
{
    return !(bend->least_speed > cusp);
}

/* A derivative whose roots are wanted, positive where the quantity grows. */
typedef double (*slope_function)(const taut_pipe_arc *arc, double t);

/* Half the derivative of |P'|^2. */
static double speed_slope(const taut_pipe_arc *arc, double t)
{
    double d1[3], d2[3];
    taut_bernstein_point(arc->degree - 1, 3, &arc->velocity[0][0], t, d1, d2);
    return taut_dot(d1, d2);
}

/* A positive multiple of the derivative of kappa^2 = N / D^3, N = |P' x P''|^2, D = |P'|^2:
 *     (N' D - 3 N D') / 2                                       ([WangBai2018] section 5) */
static double curvature_slope(const taut_pipe_arc *arc, double t)
{
    double d1[3], d2[3], cross[3], cross1[3];
    taut_bernstein_point(arc->degree - 1, 3, &arc->velocity[0][0], t, d1, d2);
    taut_bernstein_point(2 * arc->degree - 4, 3, &arc->cross[0][0], t, cross, cross1);
    return taut_dot(cross, cross1) * taut_dot(d1, d1) -
           3 * taut_dot(cross, cross) * taut_dot(d1, d2);
}

/* The root in [lo, hi] of a slope with values of unlike sign there: regula falsi, the stale end
 * halved (Illinois). */
static double find_root(slope_function f, const taut_pipe_arc *arc, double lo, double hi,
                        double f_lo, double f_hi)
{
    int stale = 0;
    for (int step = 0; step < ROOT_STEPS && hi - lo > 0x1p-52; step++) {
        double t = (lo * f_hi - hi * f_lo) / (f_hi - f_lo);
        double f_t = 0;
        if (!(t > lo && t < hi)) {
            t = 0.5 * (lo + hi);
        }
        f_t = f(arc, t);
        if ((f_t > 0) == (f_lo > 0)) {
            lo = t;
            f_lo = f_t;
            f_hi *= stale < 0 ? 0.5 : 1;
            stale = -1;
        } else {
            hi = t;
            f_hi = f_t;
            f_lo *= stale > 0 ? 0.5 : 1;
            stale = 1;
        }
        if (f_t == 0) {
            return t;
        }
    }
    return 0.5 * (lo + hi);
}

/* How fast the curve runs and how much it bends at t, and how both change there. */
typedef struct pace {
    double speed, curvature;
    double speed_slope, curvature_slope; /* of the functions above */
} pace;

static pace pace_at(const taut_pipe_arc *arc, double t)
{
    double d1[3], d2[3], cross[3], cross1[3];
    pace p = {0, 0, 0, 0};
    taut_bernstein_point(arc->degree - 1, 3, &arc->velocity[0][0], t, d1, d2);
    taut_bernstein_point(2 * arc->degree - 4, 3, &arc->cross[0][0], t, cross, cross1);
    const double square = taut_dot(d1, d1), bent = taut_dot(cross, cross);
    p.speed = sqrt(square);
    p.curvature = p.speed > 0 ? sqrt(bent) / (p.speed * p.speed * p.speed) : 0;
    p.speed_slope = taut_dot(d1, d2);
    p.curvature_slope = taut_dot(cross, cross1) * square - 3 * bent * p.speed_slope;
    return p;
}

static void record_pace(const pace *p, double t, taut_pipe_bend *bend)
{
    if (p->speed < bend->least_speed) {
        bend->least_speed = p->speed;
        bend->least_speed_at = t;
    }
    if (p->curvature > bend->curvature) {
        bend->curvature = p->curvature;
        bend->curvature_at = t;
    }
}

static void record_root(slope_function f, const taut_pipe_arc *arc, double lo, double hi,
                        double f_lo, double f_hi, taut_pipe_bend *bend)
{
    const double t = find_root(f, arc, lo, hi, f_lo, f_hi);
    const pace p = pace_at(arc, t);
    record_pace(&p, t, bend);
}

/* Parameter i of -GRADED .. samples + GRADED, increasing: equal steps, and ever smaller ones
 * towards both ends, where a short handle beside a long one makes a sharp bend. */
static double sample_parameter(int i, int samples)
{
    const double step = 1.0 / samples;
    return i < 0          ? (i == -GRADED ? 0 : step * ldexp(1, i))
           : i > samples  ? (i == samples + GRADED ? 1 : 1 - step * ldexp(1, samples - i))
           : i == 0       ? 0.5 * step
           : i == samples ? 1 - 0.5 * step
                          : i * step;
}

void taut_pipe_bend_extremes(const taut_pipe_arc *arc, int samples, taut_pipe_bend *bend)
{
    double largest = 0, before = 0;
    pace last = pace_at(arc, 0);

    bend->curvature = 0;
    bend->curvature_at = 0;
    bend->least_speed = last.speed;
    bend->least_speed_at = 0;
    for (int i = 0; i < arc->degree; i++) {
        largest = fmax(largest, sqrt(taut_dot(arc->velocity[i], arc->velocity[i])));
    }
    for (int i = -GRADED; i <= samples + GRADED; i++) {
        const double t = sample_parameter(i, samples);
        const pace p = pace_at(arc, t);
        record_pace(&p, t, bend);
        if (i > -GRADED && last.speed_slope < 0 && p.speed_slope > 0) {
            record_root(speed_slope, arc, before, t, last.speed_slope, p.speed_slope, bend);
        }
        if (i > -GRADED && last.curvature_slope > 0 && p.curvature_slope < 0) {
            record_root(curvature_slope, arc, before, t, last.curvature_slope, p.curvature_slope,
                        bend);
        }
        before = t;
        last = p;
    }
    bend->least_speed = largest > 0 ? bend->least_speed / largest : 0;
}

void taut_pipe_bend_integrals(const taut_pipe_arc *arc, int intervals, taut_pipe_bend *bend)
{
    double nodes[GAUSS], weights[GAUSS];

    taut_gauss_rule(GAUSS, nodes, weights);
    bend->length = bend->turning = bend->bending = 0;
    for (int i = 0; i < intervals; i++) {
        for (int k = 0; k < GAUSS; k++) {
            /* t = s^2 (3 - 2s) brings nodes to the ends, where curvature may peak */
            const double s = (i + 0.5 + 0.5 * nodes[k]) / intervals;
            const pace p = pace_at(arc, s * s * (3 - 2 * s));
            const double ds = 0.5 * weights[k] / intervals * 6 * s * (1 - s) * p.speed;
            bend->length += ds;
            bend->turning += p.curvature * ds;
            bend->bending += p.curvature * p.curvature * ds;
        }
    }
}
