#include "construct/pipe/bend.h"

#include "core/vec3.h"
#include "numeric/bernstein.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <stddef.h>

enum { ROOT_STEPS = 80, GRADED = 32 };

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

static int is_reached(const taut_pipe_bend_stop *stop, double curvature)
{
    return curvature >= stop->curvature || stop->factor * curvature >= stop->room;
}

/* Reached at t: the first place to look at from now on. */
static void remember(taut_pipe_bend_stop *stop, double t)
{
    int k = 0;
    while (k < stop->count && stop->at[k] != t) {
        k++;
    }
    k = k < TAUT_PIPE_BEND_STOPS ? k : TAUT_PIPE_BEND_STOPS - 1;
    stop->count = k == stop->count ? k + 1 : stop->count;
    for (; k > 0; k--) {
        stop->at[k] = stop->at[k - 1];
    }
    stop->at[0] = t;
}

/* Is it reached where it was before? */
static int is_reached_again(const taut_pipe_arc *arc, taut_pipe_bend_stop *stop)
{
    for (int k = 0; k < stop->count; k++) {
        const double t = stop->at[k];
        if (is_reached(stop, pace_at(arc, t).curvature)) {
            remember(stop, t);
            return 1;
        }
    }
    return 0;
}

void taut_pipe_bend_extremes(const taut_pipe_arc *arc, int samples, taut_pipe_bend *bend)
{
    taut_pipe_bend_stop never = {.curvature = INFINITY, .room = INFINITY};
    (void)taut_pipe_bend_extremes_below(arc, samples, &never, bend);
}

int taut_pipe_bend_extremes_below(const taut_pipe_arc *arc, int samples, taut_pipe_bend_stop *stop,
                                  taut_pipe_bend *bend)
{
    double largest = 0, before = 0;

    if (is_reached_again(arc, stop)) {
        return 0;
    }
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
        if (is_reached(stop, bend->curvature)) {
            remember(stop, bend->curvature_at);
            return 0;
        }
        before = t;
        last = p;
    }
    bend->least_speed = largest > 0 ? bend->least_speed / largest : 0;
    return 1;
}

/* ---- integrals ---- */

typedef struct gauss {
    double nodes[TAUT_PIPE_GAUSS], weights[TAUT_PIPE_GAUSS];
} gauss;

static void fill_interval(int degree, int i, int intervals, const gauss *rule,
                          taut_pipe_nodes *nodes)
{
    for (int k = 0; k < TAUT_PIPE_GAUSS; k++) {
        /* t = s^2 (3 - 2s) brings nodes to the ends, where curvature may peak */
        const double s = (i + 0.5 + 0.5 * rule->nodes[k]) / intervals;
        const double t = s * s * (3 - 2 * s);
        double values[2 * TAUT_PIPE_DEGREE_MAX];

        nodes->weight[k] = 0.5 * rule->weights[k] / intervals * 6 * s * (1 - s);
        taut_bernstein_eval(degree - 1, 0, t, values);
        for (int j = 0; j < degree; j++) {
            nodes->velocity[j][k] = values[j];
        }
        taut_bernstein_eval(2 * degree - 4, 0, t, values);
        for (int j = 0; j < 2 * degree - 3; j++) {
            nodes->cross[j][k] = values[j];
        }
    }
}

void taut_pipe_nodes_fill(int degree, int intervals, taut_pipe_nodes *nodes)
{
    gauss rule;
    taut_gauss_rule(TAUT_PIPE_GAUSS, rule.nodes, rule.weights);
    for (int i = 0; i < intervals; i++) {
        fill_interval(degree, i, intervals, &rule, &nodes[i]);
    }
}

/* squares[k] = |sum c_j values[j][k]|^2. */
static void find_squares(int count, const double (*c)[3], const double (*values)[TAUT_PIPE_GAUSS],
                         double *squares)
{
    double x[3][TAUT_PIPE_GAUSS] = {{0}};

    for (int j = 0; j < count; j++) {
        for (int d = 0; d < 3; d++) {
            for (int k = 0; k < TAUT_PIPE_GAUSS; k++) {
                x[d][k] += c[j][d] * values[j][k];
            }
        }
    }
    for (int k = 0; k < TAUT_PIPE_GAUSS; k++) {
        squares[k] = x[0][k] * x[0][k] + x[1][k] * x[1][k] + x[2][k] * x[2][k];
    }
}

static void add_interval(const taut_pipe_arc *arc, const taut_pipe_nodes *nodes,
                         taut_pipe_bend *bend)
{
    double squares[TAUT_PIPE_GAUSS], bent[TAUT_PIPE_GAUSS];

    find_squares(arc->degree, arc->velocity, nodes->velocity, squares);
    find_squares(2 * arc->degree - 3, arc->cross, nodes->cross, bent);
    for (int k = 0; k < TAUT_PIPE_GAUSS; k++) {
        const double speed = sqrt(squares[k]);
        const double curvature = speed > 0 ? sqrt(bent[k]) / (speed * speed * speed) : 0;
        const double ds = nodes->weight[k] * speed;
        bend->length += ds;
        bend->turning += curvature * ds;
        bend->bending += curvature * curvature * ds;
    }
}

void taut_pipe_bend_integrals(const taut_pipe_arc *arc, int intervals, taut_pipe_bend *bend)
{
    gauss rule;

    taut_gauss_rule(TAUT_PIPE_GAUSS, rule.nodes, rule.weights);
    bend->length = bend->turning = bend->bending = 0;
    for (int i = 0; i < intervals; i++) {
        taut_pipe_nodes nodes;
        fill_interval(arc->degree, i, intervals, &rule, &nodes);
        add_interval(arc, &nodes, bend);
    }
}

int taut_pipe_bend_integrals_below(const taut_pipe_arc *arc, int intervals,
                                   const taut_pipe_nodes *nodes, int by_length, double most,
                                   taut_pipe_bend *bend)
{
    bend->length = bend->turning = bend->bending = 0;
    for (int i = 0; i < intervals; i++) {
        add_interval(arc, &nodes[i], bend);
        if ((by_length ? bend->length * bend->bending : bend->bending) >= most) {
            return 0;
        }
    }
    return 1;
}
