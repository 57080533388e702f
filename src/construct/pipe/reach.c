/* reach.c -- the pairs of points on a grid over the composite axis; local minima made exact by
 * damped Newton steps ([WangBai2018] section 9). */
#include "construct/pipe/reach.h"

#include "core/constants.h"
#include "core/vec3.h"
#include "numeric/bernstein.h"

#include <math.h>
#include <string.h>

enum { NEWTON_STEPS = 60, GOLDEN_STEPS = 60, NUMBERS = 4, OF_PAIR = 20 /* operations */ };

/* A curvature below this, over the size of the axis, cannot be told from none. */
static const double straight = 1e-12;

/* The axis while it is looked at: samples double[count * (samples + 1)][NUMBERS], point and arc
 * length. */
typedef struct composite_axis {
    const taut_pipe_composite *composite;
    double (*samples)[NUMBERS];
    int count;                /* of samples, all arcs */
    int per_arc;              /* samples - 1 of one arc */
    double length;            /* of the arcs */
    double apart;             /* pi / kappa_max */
    double ends[2][3];        /* where the straight pipes begin, */
    double leave[2][3];       /* and their unit directions, away from the arcs */
    double (*balls)[NUMBERS]; /* of the arcs: centre and radius of their points */
    double best;              /* the smallest distance so far, */
    double binding[2];        /* and where */
} composite_axis;

/* Along the axis, the shorter way round where it is closed. */
static double separation(const composite_axis *a, double from, double to)
{
    const double way = fabs(to - from);
    return a->composite->closed ? fmin(way, a->length - way) : way;
}

static void offer_pair(composite_axis *a, double distance, double from, double to)
{
    if (distance < a->best) {
        a->best = distance;
        a->binding[0] = from;
        a->binding[1] = to;
    }
}

/* Points and arc lengths (Simpson's rule between samples: they only tell near from far). */
static void sample_axis(composite_axis *a)
{
    double length = 0;
    for (int k = 0; k < a->composite->count; k++) {
        const taut_pipe_arc *arc = &a->composite->arcs[k];
        double before = 0;
        for (int i = 0; i <= a->per_arc; i++) {
            double *s = a->samples[k * (a->per_arc + 1) + i];
            taut_pipe_jet jet;
            taut_pipe_arc_jet(arc, (double)i / a->per_arc, &jet);
            if (i > 0) {
                double middle[3];
                taut_bernstein_point(arc->degree - 1, 3, &arc->velocity[0][0],
                                     (i - 0.5) / a->per_arc, middle, NULL);
                length += (before + 4 * taut_norm(middle) + jet.speed) / (6 * a->per_arc);
            }
            before = jet.speed;
            memcpy(s, jet.point, 3 * sizeof *s);
            s[3] = length;
            if (i == 0 && k == 0) {
                memcpy(a->ends[0], jet.point, sizeof a->ends[0]);
                for (int c = 0; c < 3; c++) {
                    a->leave[0][c] = -jet.tangent[c];
                }
            }
            memcpy(a->ends[1], jet.point, sizeof a->ends[1]);
            memcpy(a->leave[1], jet.tangent, sizeof a->leave[1]);
        }
    }
    a->count = a->composite->count * (a->per_arc + 1);
    a->length = length;
}

/* Arc length at parameter t of arc k, between samples. */
static double length_at(const composite_axis *a, int k, double t)
{
    const int i = (int)fmin(a->per_arc - 1, floor(t * a->per_arc));
    const double part = t * a->per_arc - i;
    const double(*s)[NUMBERS] = (const double(*)[NUMBERS])a->samples + k * (a->per_arc + 1) + i;
    return (1 - part) * s[0][3] + part * s[1][3];
}

static double clamp(double x, double lo, double hi)
{
    return fmin(hi, fmax(lo, x));
}

/* One candidate pair made a local minimum of |p(s) - q(t)|^2 / 2: Newton steps with as much of the
 * identity added as it takes to go down, inside both arcs and apart. */
static void refine_pair(composite_axis *a, const int arc[2], const double start[2])
{
    const taut_pipe_arc *p = &a->composite->arcs[arc[0]], *q = &a->composite->arcs[arc[1]];
    double x[2] = {start[0], start[1]}, damping = 1e-3;
    taut_pipe_jet at[2];
    double apart[3], value = 0;

    taut_pipe_arc_jet(p, x[0], &at[0]);
    taut_pipe_arc_jet(q, x[1], &at[1]);
    taut_difference(at[0].point, at[1].point, apart);
    value = taut_dot(apart, apart);
    for (int step = 0; step < NEWTON_STEPS && value > 0; step++) {
        const double g0 = taut_dot(apart, at[0].d1), g1 = -taut_dot(apart, at[1].d1);
        const double h01 = -taut_dot(at[0].d1, at[1].d1);
        double h00 = taut_dot(at[0].d1, at[0].d1) + taut_dot(apart, at[0].d2);
        double h11 = taut_dot(at[1].d1, at[1].d1) - taut_dot(apart, at[1].d2);
        const double size = taut_dot(at[0].d1, at[0].d1) + taut_dot(at[1].d1, at[1].d1);
        double next[2], there[3], lower = 0, det = 0;
        taut_pipe_jet jet[2];
        h00 += damping * size;
        h11 += damping * size;
        det = h00 * h11 - h01 * h01;
        if (!(det > 0) || !(h00 > 0)) {
            damping = 10 * damping + 1e-6;
            continue;
        }
        next[0] = clamp(x[0] - (h11 * g0 - h01 * g1) / det, 0, 1);
        next[1] = clamp(x[1] - (h00 * g1 - h01 * g0) / det, 0, 1);
        taut_pipe_arc_jet(p, next[0], &jet[0]);
        taut_pipe_arc_jet(q, next[1], &jet[1]);
        taut_difference(jet[0].point, jet[1].point, there);
        lower = taut_dot(there, there);
        if (!(lower < value) || separation(a, length_at(a, arc[0], next[0]),
                                           length_at(a, arc[1], next[1])) < a->apart) {
            if (damping > 1e6) {
                break;
            }
            damping = 10 * damping + 1e-9;
            continue;
        }
        damping *= 0.1;
        memcpy(x, next, sizeof x);
        memcpy(at, jet, sizeof at);
        memcpy(apart, there, sizeof apart);
        value = lower;
    }
    offer_pair(a, sqrt(value), length_at(a, arc[0], x[0]), length_at(a, arc[1], x[1]));
}

static double sample_distance(const composite_axis *a, int i, int j)
{
    return taut_length_between(a->samples[i], a->samples[j]); /* at unit size */
}

/* Is pair (i, j) no farther than its neighbours on the grid? */
static int is_local(const composite_axis *a, int i, int j, double distance)
{
    for (int di = -1; di <= 1; di++) {
        for (int dj = -1; dj <= 1; dj++) {
            const int m = i + di, n = j + dj;
            if (m >= 0 && n < a->count && m < n &&
                separation(a, a->samples[m][3], a->samples[n][3]) >= a->apart &&
                sample_distance(a, m, n) < distance) {
                return 0;
            }
        }
    }
    return 1;
}

/* The longest part of an arc between two samples. */
static double longest_step(const composite_axis *a, int k)
{
    const int row = a->per_arc + 1;
    double longest = 0;
    for (int i = k * row; i + 1 < (k + 1) * row; i++) {
        longest = fmax(longest, a->samples[i + 1][3] - a->samples[i][3]);
    }
    return longest;
}

/* No curvature at all: a line run through evenly. */
static int is_line(const taut_pipe_arc *arc)
{
    double most = 0;
    for (int i = 0; i < 3 * (2 * arc->degree - 3); i++) {
        most = fmax(most, fabs(arc->cross[i / 3][i % 3]));
    }
    return arc->degree == 2 && most == 0;
}

/* Two lines: their distance is least inside both, or at an end of one, at the foot on the other. */
static void line_with_line(composite_axis *a, int k, int l)
{
    const taut_pipe_arc *p = &a->composite->arcs[k], *q = &a->composite->arcs[l];
    double d[3], e[3], w[3], places[5][2];
    taut_difference(p->points[2], p->points[0], d);
    taut_difference(q->points[2], q->points[0], e);
    taut_difference(q->points[0], p->points[0], w);
    const double dd = taut_dot(d, d), de = taut_dot(d, e), ee = taut_dot(e, e);
    const double dw = taut_dot(d, w), ew = taut_dot(e, w), det = dd * ee - de * de;
    places[0][0] = det > 0 ? clamp((dw * ee - de * ew) / det, 0, 1) : 0;
    places[0][1] = clamp((places[0][0] * de - ew) / ee, 0, 1);
    for (int end = 0; end < 2; end++) {
        places[1 + end][0] = end;
        places[1 + end][1] = clamp((end * de - ew) / ee, 0, 1);
        places[3 + end][0] = clamp((end * de + dw) / dd, 0, 1);
        places[3 + end][1] = end;
    }
    for (int i = 0; i < 5; i++) {
        const double from = length_at(a, k, places[i][0]), to = length_at(a, l, places[i][1]);
        double apart[3] = {w[0], w[1], w[2]};
        taut_add_scaled(places[i][1], e, apart);
        taut_add_scaled(-places[i][0], d, apart);
        if (separation(a, from, to) >= a->apart) {
            offer_pair(a, taut_norm(apart), from, to);
        }
    }
}

static void arc_with_arc(composite_axis *a, int k, int l)
{
    const int row = a->per_arc + 1, arc[2] = {k, l};
    /* a grid step on either side can bring a pair nearer by no more than this */
    const double slack = longest_step(a, k) + longest_step(a, l);
    const double gap = taut_distance(a->balls[k], a->balls[l]) - a->balls[k][3] - a->balls[l][3];
    if (gap >= a->best) {
        return;
    }
    if (is_line(&a->composite->arcs[k]) && is_line(&a->composite->arcs[l])) {
        if (k != l) {
            line_with_line(a, k, l);
        }
        return;
    }
    for (int i = k * row; i < (k + 1) * row; i++) {
        if (taut_pulse_beat(a->composite->pulse, OF_PAIR * row)) {
            return;
        }
        for (int j = l > k ? l * row : i + 1; j < (l + 1) * row; j++) {
            const double distance = sample_distance(a, i, j);
            if (distance < a->best + slack &&
                separation(a, a->samples[i][3], a->samples[j][3]) >= a->apart &&
                is_local(a, i, j, distance)) {
                const double start[2] = {(double)(i % row) / a->per_arc,
                                         (double)(j % row) / a->per_arc};
                refine_pair(a, arc, start);
            }
        }
    }
}

static void enclose_arcs(composite_axis *a)
{
    const int row = a->per_arc + 1;
    for (int k = 0; k < a->composite->count; k++) {
        double *const ball = a->balls[k];
        memcpy(ball, a->samples[k * row + a->per_arc / 2], 3 * sizeof *ball);
        ball[3] = 0;
        for (int i = k * row; i < (k + 1) * row; i++) {
            ball[3] = fmax(ball[3], taut_distance(a->samples[i], ball));
        }
        ball[3] += longest_step(a, k);
    }
}

static void arcs_with_arcs(composite_axis *a)
{
    enclose_arcs(a);
    for (int k = 0; k < a->composite->count; k++) {
        for (int l = k; l < a->composite->count; l++) {
            arc_with_arc(a, k, l);
        }
    }
}

/* The distance from a point to straight pipe `side`; *along is where its foot lies there. */
static double to_tail(const composite_axis *a, int side, const double point[3], double *along)
{
    double d[3];
    taut_difference(point, a->ends[side], d);
    *along = clamp(taut_dot(d, a->leave[side]), 0, a->composite->tails[side]);
    taut_add_scaled(-*along, a->leave[side], d);
    return taut_norm(d);
}

/* The distance of the point at t of arc k from a straight pipe; INFINITY where it is not apart. */
static double tail_distance(const composite_axis *a, int side, int k, double t, double *along,
                            double *at)
{
    double point[3], distance = 0;
    taut_pipe_arc_point(&a->composite->arcs[k], t, point);
    distance = to_tail(a, side, point, along);
    *at = length_at(a, k, t);
    return *along + (side == 0 ? *at : a->length - *at) >= a->apart ? distance : INFINITY;
}

static void offer_tail(composite_axis *a, int side, double distance, double along, double at)
{
    offer_pair(a, distance, side == 0 ? -along : at, side == 0 ? at : a->length + along);
}

static void arc_with_tail(composite_axis *a, int side, int k)
{
    const double ratio = 0.61803398874989485;
    double along = 0, at = 0;
    for (int i = 0; i <= a->per_arc; i++) {
        const double step = 1.0 / a->per_arc, t = i * step;
        const double here = tail_distance(a, side, k, t, &along, &at);
        double lo = fmax(0, t - step), hi = fmin(1, t + step);
        double other = 0, unused = 0;
        if (isinf(here) || here > a->best + 2 * a->length / a->per_arc) {
            continue;
        }
        offer_tail(a, side, here, along, at);
        other = fmin(i > 0 ? tail_distance(a, side, k, lo, &unused, &unused) : INFINITY,
                     i < a->per_arc ? tail_distance(a, side, k, hi, &unused, &unused) : INFINITY);
        for (int n = 0; n < GOLDEN_STEPS && other >= here; n++) {
            const double left = hi - ratio * (hi - lo), right = lo + ratio * (hi - lo);
            double along_left = 0, at_left = 0, along_right = 0, at_right = 0;
            const double d_left = tail_distance(a, side, k, left, &along_left, &at_left);
            const double d_right = tail_distance(a, side, k, right, &along_right, &at_right);
            offer_tail(a, side, d_left, along_left, at_left);
            offer_tail(a, side, d_right, along_right, at_right);
            *(d_left <= d_right ? &hi : &lo) = d_left <= d_right ? right : left;
        }
    }
}

static void offer_tails(composite_axis *a, double s, double r)
{
    double d[3];
    if (!isfinite(s) || !isfinite(r) || s + a->length + r < a->apart) {
        return;
    }
    taut_difference(a->ends[1], a->ends[0], d);
    taut_add_scaled(r, a->leave[1], d);
    taut_add_scaled(-s, a->leave[0], d);
    offer_pair(a, taut_norm(d), -s, a->length + r);
}

/* The two straight pipes: |w + r b - s a|^2 is least in the inside or on a side of its domain. */
static void tail_with_tail(composite_axis *a)
{
    const double *const lengths = a->composite->tails;
    double w[3];
    taut_difference(a->ends[1], a->ends[0], w);
    const double ab = taut_dot(a->leave[0], a->leave[1]);
    const double aw = taut_dot(a->leave[0], w), bw = taut_dot(a->leave[1], w);
    const double det = 1 - ab * ab;

    if (det > 0) {
        const double s = (aw - ab * bw) / det, r = (ab * aw - bw) / det;
        if (s >= 0 && s <= lengths[0] && r >= 0 && r <= lengths[1]) {
            offer_tails(a, s, r);
        }
    }
    for (int side = 0; side < 2; side++) {
        const double s = side == 0 ? 0 : lengths[0], r = side == 0 ? 0 : lengths[1];
        if (isfinite(s)) {
            offer_tails(a, s, clamp(ab * s - bw, 0, lengths[1]));
        }
        if (isfinite(r)) {
            offer_tails(a, clamp(aw + ab * r, 0, lengths[0]), r);
        }
    }
}

void taut_pipe_reach_of(const taut_pipe_composite *composite, double *scratch,
                        taut_pipe_reach *reach)
{
    composite_axis a = {.composite = composite,
                        .samples = (double(*)[NUMBERS])(void *)scratch,
                        .per_arc =
                            composite->samples > 0 ? composite->samples : TAUT_PIPE_REACH_SAMPLES,
                        .best = INFINITY};
    double turning = 0;

    a.balls = a.samples + (size_t)composite->count * (TAUT_PIPE_REACH_SAMPLES + 1);
    *reach = (taut_pipe_reach){.radius = INFINITY};
    for (int k = 0; k < composite->count; k++) {
        taut_pipe_bend bend;
        taut_pipe_bend_extremes(&composite->arcs[k], 2 * a.per_arc, &bend);
        taut_pipe_bend_integrals(&composite->arcs[k], composite->samples > 0 ? 4 : 16, &bend);
        turning += bend.turning;
        if (bend.curvature > reach->curvature) {
            reach->curvature = bend.curvature;
            reach->curvature_at = bend.curvature_at;
            reach->curvature_arc = k;
        }
    }
    if (!(reach->curvature > straight)) {
        reach->curvature = 0;
        return;
    }
    reach->radius = 1 / reach->curvature;
    /* a chord at right angles to the axis at both its ends needs a turn of pi between them */
    reach->shortcut =
        turning < 0.999 * TAUT_PI && isinf(composite->tails[0]) && isinf(composite->tails[1]);
    if (reach->shortcut) {
        return;
    }
    a.apart = TAUT_PI / reach->curvature;
    a.best = 2 / reach->curvature; /* others do not bind */
    sample_axis(&a);
    arcs_with_arcs(&a);
    for (int side = 0; side < 2; side++) {
        for (int k = 0; k < composite->count && composite->tails[side] > 0; k++) {
            arc_with_tail(&a, side, k);
        }
    }
    if (composite->tails[0] > 0 || composite->tails[1] > 0) {
        tail_with_tail(&a);
    }
    if (a.best < 2 / reach->curvature) {
        reach->radius = 0.5 * a.best;
        reach->by_distance = 1;
        memcpy(reach->binding, a.binding, sizeof a.binding);
    }
}
