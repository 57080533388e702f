/* unavoidable.c
 *
 * Let all stretches of a one-to-one flattening be in [a, b], beta = b/a. Then max |strain| >= (beta - 1)/(beta + 1), and of a curve gamma of
 * length l at least r from the border, |k_g| <= eps, k^2 <= K <= k1^2 on the points N within r of it,
 *
 *     beta >= beta0 = (q l + pi r) / (l cos kr + pi/k sin kr),    q^2 = 1 - eps^2 l^2 / (4 - k1^2 l^2),
 *     l <= 2/k1,   r < pi/(2 k1),   k1 r < arctan(k1/eps),   l <= 2 r / sqrt(beta0^2 - q^2)
 *
 * (f(N) holds a neighbourhood of f(gamma), whose border is longer than that of N can be made), and of a disc of radius rho on which
 * K <= -k^2, r = rho/beta0,
 *
 *     beta >= beta0 = asinh(sinh(kr) sin(pi/n)) / (kr sin(pi/n))
 *
 * (n points around it are farther apart than in the plane); l = 0 is [Milnor1969]. gamma is part of the axis t = 1/2. Distances and
 * curvatures are those of rays and of a grid: a check, not a bound.
 */
#include "certify/pattern/unavoidable.h"

#include "certify/pattern/ray.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "geometry/chart/least_strain.h"
#include "numeric/quadrature.h"

#include <math.h>

enum {
    STEPS = TAUT_CLOTH_STATIONS,
    ACROSS = 8,
    NODES = 8,
    DIRECTIONS = 12,
    RAY_STEPS = 6,
    POINTS = 12,
    ROUNDS = 24,
    FIXED = 60
};
/* The golden section. */
static const double golden = 0.61803398874989484820;
/* gamma ends so far from the ends of the axis, in s. */
static const double end_of_axis = 1e-6;
/* And places are so far from tips. */
static const double next_to_tip = 1e-3;
/* K times area that is none, and k_g times length. */
static const double no_curvature = 1e-11;
/* Of the distance of one place: operations, roughly. */
static const double work_of_distance = 1e6;

typedef struct ground {
    const taut_cloth *cloth;
    const taut_cloth_piece *piece;
    taut_cloth_station *at;
    taut_pulse *pulse;
} ground;

/* ---- the golden section ---- */

typedef struct climber {
    const ground *ground;
    double middle;           /* of gamma */
    taut_cloth_limit *limit; /* takes what is found */
} climber;

/* The largest value between lo and hi, of a function with one hill there; it keeps what it finds by itself. */
static void climb(const climber *c, double (*value)(const climber *, double), double lo, double hi)
{
    double x[2] = {hi - golden * (hi - lo), lo + golden * (hi - lo)};
    double y[2] = {value(c, x[0]), value(c, x[1])};
    for (int round = 0; round < ROUNDS; round++) {
        const int keep = y[0] < y[1]; /* the one that stays inside */
        *(keep ? &lo : &hi) = x[!keep];
        x[!keep] = x[keep];
        y[!keep] = y[keep];
        x[keep] = keep ? lo + golden * (hi - lo) : hi - golden * (hi - lo);
        y[keep] = value(c, x[keep]);
    }
}

/* ---- the axis ---- */

/* At a tip curvature is lost in rounding: as next to it. */
static double away_from_tips(const taut_cloth_piece *piece, double s)
{
    const double low = piece->is_point[TAUT_CLOTH_START] ? next_to_tip : 0;
    const double high = piece->is_point[TAUT_CLOTH_END] ? 1 - next_to_tip : 1;
    return fmin(fmax(s, low), high);
}

/* Length of the axis from s = a to b, or of the cross line of s = a from t = 0 to b. */
static double length_of(const ground *w, double a, double b, int is_across)
{
    double nodes[NODES], weights[NODES], sum = 0;
    taut_cloth_across across;
    taut_gauss_rule(NODES, nodes, weights);
    for (int q = 0; q < NODES; q++) {
        double g[3];
        const double x = (1 + nodes[q]) / 2;
        if (q == 0 || !is_across) {
            taut_cloth_across_at(w->cloth, w->piece, is_across ? a : a + (b - a) * x, 1, &across);
        }
        taut_cloth_metric_on(w->cloth, &across, is_across ? b * x : 0.5, g);
        sum += weights[q] / 2 * (is_across ? b * sqrt(g[2]) : (b - a) * sqrt(g[0]));
    }
    return sum;
}

static double distance_at(const ground *w, double s)
{
    const double at[2] = {s, 0.5}, half = length_of(w, s, 0.5, 1), whole = length_of(w, s, 1, 1);
    double limit = fmin(half, whole - half);
    const int near = s < 0.5 ? (int)floor(s * STEPS) : (int)ceil(s * STEPS);
    const double rest = length_of(w, near / (double)STEPS, s, 0);
    const double from_start = w->at[near].from_start + rest;
    limit = fmin(limit, fmin(from_start, w->at[STEPS].from_start - from_start));
    return limit > 0 && !taut_pulse_beat(w->pulse, work_of_distance)
               ? taut_cloth_distance(w->cloth, w->piece, at, limit)
               : 0;
}

/* 0 where the surface has no curvature somewhere. */
static int measure(const ground *w)
{
    for (int i = 0; i <= STEPS; i++) {
        taut_cloth_station *one = &w->at[i];
        const double s = away_from_tips(w->piece, (double)i / STEPS);
        taut_cloth_spot spot;
        one->low = INFINITY;
        one->high = -INFINITY;
        for (int k = 0; k <= ACROSS; k++) {
            if (!taut_cloth_spot_at(w->cloth, w->piece, s, (double)k / ACROSS, &spot)) {
                return 0;
            }
            one->low = fmin(one->low, spot.gauss);
            one->high = fmax(one->high, spot.gauss);
            one->bend = 2 * k == ACROSS ? fabs(spot.bend) : one->bend;
        }
        one->from_start =
            i > 0 ? w->at[i - 1].from_start + length_of(w, (i - 1.0) / STEPS, s, 0) : 0;
        one->across = length_of(w, s, 1, 1);
    }
    for (int i = 1; i < STEPS; i++) {
        w->at[i].distance = distance_at(w, (double)i / STEPS);
    }
    return 1;
}

/* ---- K > 0 ---- */

/* beta0 of gamma from s = a to s = b, d the distances of its ends; 1 where there is none. */
static double beta_of_curve(const ground *w, double a, double b, const double d[2], double *length,
                            double *radius)
{
    double r = fmin(d[0], d[1]), low = INFINITY, high = -INFINITY, eps = 0;
    const double begin = length_of(w, 0, a, 0), l = b > a ? length_of(w, a, b, 0) : 0;

    for (int i = 1; i < STEPS; i++) {
        const double s = (double)i / STEPS;
        r = s > a && s < b ? fmin(r, w->at[i].distance) : r;
    }
    for (int i = 0; i <= STEPS; i++) { /* and of the stations next to those within r */
        const double before = w->at[i > 0 ? i - 1 : 0].from_start;
        const double after = w->at[i < STEPS ? i + 1 : STEPS].from_start;
        if (after > begin - r && before < begin + l + r) {
            low = fmin(low, w->at[i].low);
            high = fmax(high, w->at[i].high);
            eps = fmax(eps, w->at[i].bend);
        }
    }
    if (!(low > 0) || !(r > 0)) {
        return 1;
    }
    const double k = sqrt(low), k1 = sqrt(high);
    eps = eps * l > no_curvature ? eps : 0;
    const double q2 = 1 - eps * eps * l * l / (4 - k1 * k1 * l * l);
    if (!(k1 * l < 2) || !(2 * k1 * r < TAUT_PI) || !(q2 > 0) || !(k1 * r < taut_atan2(k1, eps))) {
        return 1;
    }
    const double beta =
        (sqrt(q2) * l + TAUT_PI * r) / (l * taut_cos(k * r) + TAUT_PI / k * taut_sin(k * r));
    *length = l;
    *radius = r;
    return beta > 1 && l * l * (beta * beta - q2) <= 4 * r * r ? beta : 1;
}

static void take(taut_cloth_limit *limit, double beta, double at, double length, double radius)
{
    const double strain = (beta - 1) / (beta + 1);
    if (strain > limit->unavoidable) {
        limit->unavoidable = strain;
        limit->at = at;
        limit->length = length;
        limit->radius = radius;
    }
}

static double beta_about(const climber *c, double half)
{
    const double ends[2] = {c->middle - half, c->middle + half};
    const double d[2] = {distance_at(c->ground, ends[0]), distance_at(c->ground, ends[1])};
    double length = 0, radius = 0;
    const double beta = beta_of_curve(c->ground, ends[0], ends[1], d, &length, &radius);
    take(c->limit, beta, c->middle, length, radius);
    return beta;
}

/* The best part of the axis between stations. */
static void look_at_domes(const ground *w, taut_cloth_limit *limit)
{
    double best = 1, length = 0, radius = 0;
    for (int i = 1; i < STEPS; i++) {
        for (int k = i; k < STEPS; k++) {
            const double a = (double)i / STEPS, b = (double)k / STEPS;
            const double d[2] = {w->at[i].distance, w->at[k].distance};
            const double beta = beta_of_curve(w, a, b, d, &length, &radius);
            if (beta > best) {
                best = beta;
                limit->dome[0] = a;
                limit->dome[1] = b;
                take(limit, beta, (a + b) / 2, length, radius);
            }
        }
    }
}

/* It is made longer or shorter about its middle. */
static void refine_dome(const ground *w, taut_cloth_limit *limit)
{
    const climber c = {w, (limit->dome[0] + limit->dome[1]) / 2, limit};
    const double half = (limit->dome[1] - limit->dome[0]) / 2;
    const double most = fmin(c.middle, 1 - c.middle) - end_of_axis;
    climb(&c, beta_about, fmax(half - 1.0 / STEPS, 0), fmin(half + 1.0 / STEPS, most));
}

/* ---- K < 0 ---- */

static double asinh_of(double x)
{
    return taut_log(x + sqrt(1 + x * x));
}

/* beta0 of the disc about s on the axis. */
static double beta_of_disc(const ground *w, double s, double rho)
{
    const double at[2] = {s, 0.5};
    double high = -INFINITY, beta = 1;
    for (int k = 0; rho > 0 && k < DIRECTIONS; k++) {
        taut_cloth_ray ray;
        taut_cloth_ray_from(w->cloth, w->piece, at, 2 * TAUT_PI * k / DIRECTIONS, rho,
                            rho / RAY_STEPS, &ray);
        high = ray.border == -2 ? INFINITY : fmax(high, ray.gauss[1]);
    }
    if (!(high < 0)) {
        return 1;
    }
    const double k = sqrt(-high), share = taut_sin(TAUT_PI / POINTS);
    for (int round = 0; round < FIXED; round++) { /* falls as r = rho/beta does */
        const double x = k * rho / beta;
        const double next = asinh_of(taut_sinh(x) * share) / (x * share);
        if (!(fabs(next - beta) > 1e-15)) {
            break;
        }
        beta = next;
    }
    return beta <= 1 / (2 * taut_cos(2 * TAUT_PI / POINTS) - 1) ? beta : 1;
}

static double beta_around(const climber *c, double s)
{
    const double rho = distance_at(c->ground, s), beta = beta_of_disc(c->ground, s, rho);
    take(c->limit, beta, s, 0, rho);
    return beta;
}

static void look_at_saddles(const ground *w, taut_cloth_limit *limit)
{
    double best = 1;
    for (int i = 1; i < STEPS; i++) {
        const double beta = beta_of_disc(w, (double)i / STEPS, w->at[i].distance);
        if (beta > best) {
            best = beta;
            limit->saddle = (double)i / STEPS;
            take(limit, beta, limit->saddle, 0, w->at[i].distance);
        }
    }
}

/* ---- what strips of constant curvature need ---- */

static double expected_at(const climber *c, double at)
{
    const double s = away_from_tips(c->ground->piece, at);
    const double half = length_of(c->ground, s, 1, 1) / 2;
    double most = 0;
    for (int k = 0; k <= ACROSS; k++) {
        taut_cloth_spot spot;
        if (taut_cloth_spot_at(c->ground->cloth, c->ground->piece, s, (double)k / ACROSS, &spot)) {
            most = fmax(most, fabs(spot.gauss) * half * half / 4);
        }
    }
    c->limit->expected = fmax(c->limit->expected, most);
    return most;
}

static void look_at_widths(const ground *w, taut_cloth_limit *limit)
{
    const climber c = {w, 0, limit};
    double best = 0;
    limit->wide = 0;
    for (int i = 0; i <= STEPS; i++) {
        const double one = expected_at(&c, (double)i / STEPS);
        limit->wide = one > best ? (double)i / STEPS : limit->wide;
        best = fmax(best, one);
    }
}

void taut_cloth_limit_of(const taut_cloth *cloth, const taut_cloth_piece *piece, taut_pulse *pulse,
                         taut_cloth_limit *limit)
{
    const ground w = {cloth, piece, limit->stations, pulse};
    double low = INFINITY, high = -INFINITY;

    *limit = (taut_cloth_limit){.unavoidable = 0,
                                .dome = {(double)NAN, (double)NAN},
                                .saddle = (double)NAN,
                                .wide = (double)NAN};
    if (!measure(&w)) {
        return;
    }
    for (int i = 0; i <= STEPS; i++) {
        low = fmin(low, w.at[i].low);
        high = fmax(high, w.at[i].high);
    }
    const double wide = w.at[STEPS / 2].across * w.at[STEPS].from_start;
    if (fmax(fabs(low), fabs(high)) * wide < no_curvature) {
        return;
    }
    look_at_widths(&w, limit);
    if (high > 0) {
        look_at_domes(&w, limit);
    }
    if (low < 0) {
        look_at_saddles(&w, limit);
    }
}

void taut_cloth_limit_refine(const taut_cloth *cloth, const taut_cloth_piece *piece, int what,
                             taut_pulse *pulse, taut_cloth_limit *limit)
{
    static const double step = 1.0 / STEPS;
    const ground w = {cloth, piece, limit->stations, pulse};
    const climber c = {&w, 0, limit};

    if ((what & TAUT_CLOTH_EXPECTED) && limit->wide >= 0) {
        climb(&c, expected_at, fmax(limit->wide - step, 0), fmin(limit->wide + step, 1));
    }
    if ((what & TAUT_CLOTH_UNAVOIDABLE) && limit->dome[0] >= 0) {
        refine_dome(&w, limit);
    }
    if ((what & TAUT_CLOTH_UNAVOIDABLE) && limit->saddle >= 0) {
        climb(&c, beta_around, limit->saddle - step, limit->saddle + step);
    }
}

double taut_cloth_limit_proved(const taut_cloth *cloth, const taut_cloth_piece *piece,
                               taut_pulse *pulse)
{
    const taut_chart chart = taut_cloth_chart(cloth, piece);
    return taut_chart_least_strain(&chart, pulse).strain;
}
