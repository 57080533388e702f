#include "construct/pipe/bend.h"

#include "core/vec3.h"
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
typedef double (*slope)(const taut_pipe_arc *arc, double t);

/* Half the derivative of |P'|^2. */
static double speed_slope(const taut_pipe_arc *arc, double t)
{
    double d1[3], d2[3];
    taut_pipe_bernstein(arc->degree - 1, arc->velocity, t, d1, d2);
    return taut_dot(d1, d2);
}

/* A positive multiple of the derivative of kappa^2 = N / D^3, N = |P' x P''|^2, D = |P'|^2:
 *     (N' D - 3 N D') / 2                                       ([WangBai2018] section 5) */
static double curvature_slope(const taut_pipe_arc *arc, double t)
{
    double d1[3], d2[3], cross[3], cross1[3];
    taut_pipe_bernstein(arc->degree - 1, arc->velocity, t, d1, d2);
    taut_pipe_bernstein(2 * arc->degree - 4, arc->cross, t, cross, cross1);
    return taut_dot(cross, cross1) * taut_dot(d1, d1) -
           3 * taut_dot(cross, cross) * taut_dot(d1, d2);
}

/* The root in [lo, hi] of a slope with values of unlike sign there: regula falsi, the stale end
 * halved (Illinois). */
static double root(slope f, const taut_pipe_arc *arc, double lo, double hi, double f_lo,
                   double f_hi)
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

static double speed_at(const taut_pipe_arc *arc, double t)
{
    double d1[3];
    taut_pipe_bernstein(arc->degree - 1, arc->velocity, t, d1, NULL);
    return sqrt(taut_dot(d1, d1));
}

static void take(const taut_pipe_arc *arc, double t, taut_pipe_bend *bend)
{
    taut_pipe_jet jet;
    taut_pipe_arc_jet(arc, t, &jet);
    if (jet.speed < bend->least_speed) {
        bend->least_speed = jet.speed;
        bend->least_speed_at = t;
    }
    if (jet.curvature > bend->curvature) {
        bend->curvature = jet.curvature;
        bend->curvature_at = t;
    }
}

/* Parameter i of -GRADED .. samples + GRADED, increasing: equal steps, and ever smaller ones
 * towards both ends, where a short handle beside a long one makes a sharp bend. */
static double place(int i, int samples)
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
    double largest = 0, before = 0, before_speed = 0, before_curvature = 0;

    bend->curvature = 0;
    bend->curvature_at = 0;
    bend->least_speed = speed_at(arc, 0);
    bend->least_speed_at = 0;
    for (int i = 0; i < arc->degree; i++) {
        largest = fmax(largest, sqrt(taut_dot(arc->velocity[i], arc->velocity[i])));
    }
    for (int i = -GRADED; i <= samples + GRADED; i++) {
        const double t = place(i, samples);
        const double s = speed_slope(arc, t), c = curvature_slope(arc, t);
        take(arc, t, bend);
        if (i > -GRADED && before_speed < 0 && s > 0) {
            take(arc, root(speed_slope, arc, before, t, before_speed, s), bend);
        }
        if (i > -GRADED && before_curvature > 0 && c < 0) {
            take(arc, root(curvature_slope, arc, before, t, before_curvature, c), bend);
        }
        before = t;
        before_speed = s;
        before_curvature = c;
    }
    bend->least_speed = largest > 0 ? bend->least_speed / largest : 0;
}

void taut_pipe_bend_integrals(const taut_pipe_arc *arc, int panels, taut_pipe_bend *bend)
{
    double nodes[GAUSS], weights[GAUSS];

    taut_gauss_rule(GAUSS, nodes, weights);
    bend->length = bend->turning = bend->bending = 0;
    for (int i = 0; i < panels; i++) {
        for (int k = 0; k < GAUSS; k++) {
            /* t = s^2 (3 - 2s) brings nodes to the ends, where curvature may peak */
            const double s = (i + 0.5 + 0.5 * nodes[k]) / panels;
            taut_pipe_jet jet;
            double ds = 0;
            taut_pipe_arc_jet(arc, s * s * (3 - 2 * s), &jet);
            ds = 0.5 * weights[k] / panels * 6 * s * (1 - s) * jet.speed;
            bend->length += ds;
            bend->turning += jet.curvature * ds;
            bend->bending += jet.curvature * jet.curvature * ds;
        }
    }
}
