/* least_strain.c
 *
 * Let all stretches of a one-to-one flattening be in [a, b], beta = b/a. Then max |strain| >= (beta - 1)/(beta + 1), and of a curve gamma of
 * length l at least r from the border, |k_g| <= eps, k^2 <= K <= k1^2 on the points N within r of it, N not lying over itself,
 *
 *     beta >= (q l + pi r) / (l cos kr + pi/k sin kr),    q^2 = 1 - eps^2 l^2 / (4 - k1^2 l^2) = q^2(l)
 *     l <= 2/k1,   r < pi/(2 k1),   k1 r < arctan(k1/eps),   l <= 2 r / sqrt(beta^2 - q^2)
 *
 * and of a disc of radius rho that does not lie over itself, on which K <= -k^2, each beta0 with
 *
 *     beta0 <= asinh(sinh(kr) sin(pi/n)) / (kr sin(pi/n)),   r = rho/beta0,   is one of beta
 *
 * (docs/pattern.md, "The strain that no cutting avoids"). Here all of it is enclosed:
 *
 *     K            over cells of the piece, halved until its range is narrow; of all cells within r in space, which is less than in the piece
 *     r            from below by distances in space: of chords of the axis and of the border, less what the curves leave them by
 *     l, eps       of g_ss and k_g over parts of the axis
 *     N            does not lie over itself where iint max(K, 0) dA + eps l < pi (there)
 *
 * Rounding is some 1e-13 of what is compared, and taken off at the end with `rounding`.
 */
#include "geometry/chart/least_strain.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <string.h>

enum {
    STATIONS = 64, /* parts of the axis, and columns of cells */
    FINE = 2,      /* chords of each */
    ROWS = 4,      /* cells of a column */
    BORDER = 128,  /* chords of an edge */
    DEPTH = 2,     /* so often a cell is halved both ways */
    POINTS = 12,
    ROUNDS = 60
};
/* A range of K that is so narrow over its size is not halved. */
static const double narrow = 0.05;
static const double rounding = 1e-9;
/* Operations, about, of a column or an edge. */
static const double work_of_column = 4e6;

typedef struct chord {
    double ends[2][3];
    double off; /* the curve leaves it by no more */
} chord;

/* A part of the axis. */
typedef struct part_of_axis {
    taut_range length;
    double bend; /* |k_g| */
    double near; /* no place of it is nearer to the border */
} part_of_axis;

typedef struct ground {
    const taut_chart *chart;
    chord axis[STATIONS * FINE];
    part_of_axis parts[STATIONS];
    double near[STATIONS + 1];        /* of the places between parts */
    taut_range gauss[STATIONS];       /* of columns */
    double reach[STATIONS][STATIONS]; /* [column][part]: no places of both are nearer */
    double positive;                  /* iint max(K, 0) dA, at most */
} ground;

/* ---- curvature ---- */

/* K where X_u .. X_vv are these; 0 where the normal may vanish. *area: |X_u x X_v|. */
static int gauss_of(const taut_range x[6][3], taut_range *gauss, double *area)
{
    taut_range n[3];
    taut_range_cross(x[1], x[2], n);
    const taut_range square = taut_range_dot(n, n);
    const taut_range l = taut_range_dot(x[3], n), m = taut_range_dot(x[4], n),
                     o = taut_range_dot(x[5], n);
    const taut_range form = taut_range_minus(taut_range_times(l, o), taut_range_square(m));
    *gauss = taut_range_times(
        form, (taut_range){1 / (square.hi * square.hi), 1 / (square.lo * square.lo)});
    *area = sqrt(square.hi);
    return square.lo > 0;
}

/* The tangents and the normal in the middle of a part of the window; 0 where there is none. */
static int frame_of(const taut_surface *surface, const double from[2], const double to[2],
                    double frame[3][3])
{
    double x[3][3];
    if (taut_surface_eval(surface, (from[0] + to[0]) / 2, (from[1] + to[1]) / 2, 1, x[0]) !=
        TAUT_OK) {
        return 0;
    }
    return taut_enclose_frame((const double(*)[3])x, frame);
}

/* Of a cell; adds its positive curvature. */
static int look_at_cell(const taut_chart *chart, const taut_chart_part *part, int depth,
                        taut_range *gauss, double *positive)
{
    taut_range w[6][2], of[6][3], own;
    double area, frame[3][3];
    if (!taut_chart_window(chart, part, w)) {
        return 0;
    }
    const double from[2] = {w[0][0].lo, w[0][1].lo}, to[2] = {w[0][0].hi, w[0][1].hi};
    if (!frame_of(chart->surface, from, to, frame) ||
        !taut_enclose_surface(chart->surface, from, to, (const double(*)[3])frame, of)) {
        return 0;
    }
    const int is_known = gauss_of((const taut_range(*)[3])of, &own, &area);
    const double middle[2] = {(part->from[0] + part->to[0]) / 2, (part->from[1] + part->to[1]) / 2};
    if (depth > 0 && !(is_known && own.hi - own.lo <= narrow * taut_range_size(own))) {
        for (int k = 0; k < 4; k++) {
            taut_chart_part quarter = *part;
            for (int d = 0; d < 2; d++) {
                *(k >> d & 1 ? &quarter.from[d] : &quarter.to[d]) = middle[d];
            }
            if (!look_at_cell(chart, &quarter, depth - 1, gauss, positive)) {
                return 0;
            }
        }
        return 1;
    }
    const taut_range turn =
        taut_range_minus(taut_range_times(w[1][0], w[2][1]), taut_range_times(w[1][1], w[2][0]));
    *positive += fmax(own.hi, 0) * area * taut_range_size(turn) * (part->to[0] - part->from[0]) *
                 (part->to[1] - part->from[1]);
    *gauss = taut_range_join(*gauss, own);
    return is_known;
}

/* ---- distances ---- */

static double from_chord(const double x[3], const chord *c)
{
    double way[3], to[3], rest[3];
    for (int d = 0; d < 3; d++) {
        way[d] = c->ends[1][d] - c->ends[0][d];
        to[d] = x[d] - c->ends[0][d];
    }
    const double square = taut_dot(way, way);
    const double share = square > 0 ? fmin(fmax(taut_dot(to, way) / square, 0), 1) : 0;
    for (int d = 0; d < 3; d++) {
        rest[d] = to[d] - share * way[d];
    }
    return taut_norm(rest);
}

/* No places of both are nearer: along a chord the distance from the other one is convex. */
static double between_chords(const chord *a, const chord *b)
{
    double middle[3];
    for (int d = 0; d < 3; d++) {
        middle[d] = (a->ends[0][d] + a->ends[1][d]) / 2;
    }
    const double most = fmax(from_chord(a->ends[0], b), from_chord(a->ends[1], b));
    return 2 * from_chord(middle, b) - most - a->off - b->off;
}

static double from_box(const double x[3], const taut_range box[3])
{
    double off[3];
    for (int d = 0; d < 3; d++) {
        off[d] = fmax(fmax(box[d].lo - x[d], x[d] - box[d].hi), 0);
    }
    return taut_norm(off);
}

/* Between two places of a line of the piece: off its chord by at most |X''| h^2/8. */
static int chord_of(const taut_chart *chart, const taut_chart_part *part, int along, chord *out)
{
    taut_range x[6][3];
    double at[3][3], square = 0;
    if (!taut_chart_enclose(chart, part, NULL, x)) {
        return 0;
    }
    for (int end = 0; end < 2; end++) {
        const double *place = end == 0 ? part->from : part->to;
        if (!taut_chart_at(chart, place[0], place[1], at)) {
            return 0;
        }
        memcpy(out->ends[end], at[0], sizeof at[0]);
    }
    for (int c = 0; c < 3; c++) {
        const double most = taut_range_size(x[along == 0 ? 3 : 5][c]);
        square += most * most;
    }
    const double step = part->to[along] - part->from[along];
    out->off = sqrt(square) * step * step / 8;
    return 1;
}

/* ---- the piece ---- */

/* Length and k_g of a chord's part of the axis. */
static int add_to_part(const taut_chart *chart, const taut_chart_part *part, part_of_axis *sum)
{
    taut_range x[6][3], n[3], side[3];
    if (!taut_chart_enclose(chart, part, NULL, x)) {
        return 0;
    }
    const taut_range g = taut_range_dot(x[1], x[1]);
    const double step = part->to[0] - part->from[0];
    taut_range_cross(x[1], x[2], n);
    taut_range_cross(n, x[1], side);
    const double area = sqrt(taut_range_dot(n, n).lo);
    const double bend = taut_range_size(taut_range_dot(x[3], side)) / (area * g.lo * sqrt(g.lo));
    sum->length = taut_range_add(sum->length, (taut_range){step * sqrt(g.lo), step * sqrt(g.hi)});
    sum->bend = fmax(sum->bend, bend);
    return bend < INFINITY;
}

static int look_at_axis(ground *w)
{
    for (int i = 0; i < STATIONS; i++) {
        w->parts[i] = (part_of_axis){.length = {0, 0}, .near = INFINITY};
    }
    for (int i = 0; i < STATIONS * FINE; i++) {
        const taut_chart_part part = {{(double)i / (STATIONS * FINE), 0.5},
                                      {(i + 1.0) / (STATIONS * FINE), 0.5}};
        if (!chord_of(w->chart, &part, 0, &w->axis[i]) ||
            !add_to_part(w->chart, &part, &w->parts[i / FINE])) {
            return 0;
        }
    }
    return 1;
}

/* How near the axis comes to a chord of the border. */
static void come_near(ground *w, const chord *border)
{
    for (int i = 0; i < STATIONS * FINE; i++) {
        part_of_axis *part = &w->parts[i / FINE];
        part->near = fmin(part->near, between_chords(&w->axis[i], border));
        if (i % FINE == 0) {
            w->near[i / FINE] =
                fmin(w->near[i / FINE], from_chord(w->axis[i].ends[0], border) - border->off);
        }
    }
}

static int look_at_border(ground *w)
{
    for (int i = 0; i <= STATIONS; i++) {
        w->near[i] = i < STATIONS ? INFINITY : 0;
    }
    for (int e = 0; e < TAUT_CHART_EDGES; e++) {
        const int along = e == TAUT_CHART_END || e == TAUT_CHART_START;
        const double fixed = e == TAUT_CHART_END || e == TAUT_CHART_LEFT;
        for (int i = 0; i < BORDER; i++) {
            taut_chart_part part;
            chord border;
            part.from[along] = (double)i / BORDER;
            part.to[along] = (i + 1.0) / BORDER;
            part.from[1 - along] = part.to[1 - along] = fixed;
            if (!chord_of(w->chart, &part, along, &border)) {
                return 0;
            }
            come_near(w, &border);
        }
    }
    return 1;
}

static int look_at_column(ground *w, int column)
{
    w->gauss[column] = (taut_range){INFINITY, -INFINITY};
    for (int i = 0; i < STATIONS; i++) {
        w->reach[column][i] = INFINITY;
    }
    for (int k = 0; k < ROWS; k++) {
        const taut_chart_part part = {{(double)column / STATIONS, (double)k / ROWS},
                                      {(column + 1.0) / STATIONS, (k + 1.0) / ROWS}};
        taut_range x[6][3];
        if (!taut_chart_enclose(w->chart, &part, NULL, x) ||
            !look_at_cell(w->chart, &part, DEPTH, &w->gauss[column], &w->positive)) {
            return 0;
        }
        for (int i = 0; i < STATIONS * FINE; i++) {
            const chord *c = &w->axis[i];
            const double half = taut_length_between(c->ends[0], c->ends[1]) / 2 + c->off;
            double middle[3];
            for (int d = 0; d < 3; d++) {
                middle[d] = (c->ends[0][d] + c->ends[1][d]) / 2;
            }
            double *reach = &w->reach[column][i / FINE];
            *reach = fmin(*reach, from_box(middle, x[0]) - half);
        }
    }
    return 1;
}

static int look(ground *w, taut_pulse *pulse)
{
    if (!look_at_axis(w) || taut_pulse_beat(pulse, work_of_column) || !look_at_border(w)) {
        return 0;
    }
    for (int i = 0; i < STATIONS; i++) {
        if (!look_at_column(w, i) || taut_pulse_beat(pulse, work_of_column)) {
            return 0;
        }
    }
    return 1;
}

/* K of all columns within r of the parts from a to b. */
static taut_range gauss_near(const ground *w, int a, int b, double r)
{
    taut_range gauss = {INFINITY, -INFINITY};
    for (int column = 0; column < STATIONS; column++) {
        double reach = INFINITY;
        for (int i = a; i < b; i++) {
            reach = fmin(reach, w->reach[column][i]);
        }
        gauss = reach <= r ? taut_range_join(gauss, w->gauss[column]) : gauss;
    }
    return gauss;
}

/* ---- the theorem ---- */

/* Of a curve of length l; 1 where a condition is not met. */
static double beta_of(double l, double r, double eps, double q2, taut_range gauss)
{
    const double k = sqrt(gauss.lo), k1 = sqrt(gauss.hi);
    if (!(k1 * l < 2) || !(2 * k1 * r < TAUT_PI) || !(q2 > 0) || !(k1 * r < taut_atan2(k1, eps))) {
        return 1;
    }
    return (sqrt(q2) * l + TAUT_PI * r) / (l * taut_cos(k * r) + TAUT_PI / k * taut_sin(k * r));
}

static void take(taut_least_strain *least, double beta, double at, double length, double radius)
{
    const double strain = (beta - 1) / (beta + 1) - rounding * (beta - 1);
    if (strain > least->strain) {
        *least = (taut_least_strain){strain, at, length, radius};
    }
}

/* gamma from station a to station b, or the place there. It is as long as it is, between l.lo and l.hi: with q of the longest, beta is a
 * quotient of linear functions of l, least at one of them. */
static void try_dome(const ground *w, int a, int b, taut_least_strain *least)
{
    double r = a == b ? w->near[a] : INFINITY, eps = 0;
    taut_range l = {0, 0};
    for (int i = a; i < b; i++) {
        l = taut_range_add(l, w->parts[i].length);
        r = fmin(r, w->parts[i].near);
        eps = fmax(eps, w->parts[i].bend);
    }
    const taut_range gauss = gauss_near(w, a == b ? a - 1 : a, a == b ? a + 1 : b, r);
    if (!(r > 0) || !(gauss.lo > 0) || !(w->positive + eps * l.hi < TAUT_PI)) {
        return;
    }
    const double q2 = 1 - eps * eps * l.hi * l.hi / (4 - gauss.hi * l.hi * l.hi);
    const double beta = fmin(beta_of(l.lo, r, eps, q2, gauss), beta_of(l.hi, r, eps, q2, gauss));
    if (l.hi * l.hi * (beta * beta - q2) <= 4 * r * r) {
        take(least, beta, (a + b) / (2.0 * STATIONS), l.lo, r);
    }
}

static double asinh_of(double x)
{
    return taut_log(x + sqrt(1 + x * x));
}

static void try_saddle(const ground *w, int at, taut_least_strain *least)
{
    const double rho = w->near[at], share = taut_sin(TAUT_PI / POINTS);
    const taut_range gauss = gauss_near(w, at - 1, at + 1, rho);
    if (!(rho > 0) || !(gauss.hi < 0) || !(w->positive < TAUT_PI)) {
        return;
    }
    const double k = sqrt(-gauss.hi), most = 1 / (2 * taut_cos(2 * TAUT_PI / POINTS) - 1);
    double low = 1, high = most;
    for (int round = 0; round < ROUNDS; round++) { /* what the right side leaves falls in beta */
        const double beta = (low + high) / 2, x = k * rho / beta;
        *(asinh_of(taut_sinh(x) * share) / (x * share) >= beta ? &low : &high) = beta;
    }
    take(least, low, (double)at / STATIONS, 0, rho);
}

taut_least_strain taut_chart_least_strain(const taut_chart *chart, taut_pulse *pulse)
{
    ground w = {.chart = chart};
    taut_least_strain least = {.strain = 0};
    if (!taut_chart_is_smooth(chart) || !look(&w, pulse)) {
        return least;
    }
    for (int a = 1; a < STATIONS; a++) {
        for (int b = a; b < STATIONS; b++) {
            try_dome(&w, a, b, &least);
        }
        try_saddle(&w, a, &least);
    }
    return least;
}
