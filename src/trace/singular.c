#include "trace/singular.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"

#include <math.h>
#include <string.h>

enum {
    CELLS_MOST = 16, /* a span, along each direction */
    CELLS_LEAST = 4,
    CELLS = 64, /* in all, where that leaves a span CELLS_LEAST */
    DEPTH = 12, /* halvings of a side */
    NEWTON = 60,
    CIRCLE = 16,
    HALVES = 24 /* of a cell */
};
/* A side is halved where the vector turns by more: 60 degrees of a direction are 120 of the vector. */
static const double largest_turn = 2 * TAUT_PI / 3;
/* Lines of the grid are moved by this share of a cell: zeros love the middle of windows. */
static const double aside = 0.137;
/* Newton's differences, when it stops, and the circle, over the window's sides. */
static const double difference = 1e-6, settled = 1e-14, radius = 1e-3;
/* Over the window's sides: two that are one. */
static const double one_point = 1e-6;
/* Halves of a cell are unequal too; and |w| of a zero that they lead to, over its largest on the circle. */
static const double part = 0.4567, vanishes = 1e-6;
/* The mean curvature below which a point is flat, over the largest R; and over the largest on the circle, as beside a pole
 * R is large without bound. */
static const double flat_enough = 1e-6, flat_within = 1e-3;

static void vector_at(const taut_carrier *carrier, const double at[2], double w[2], double *mean)
{
    double x[TAUT_CARRIER_VECTORS][3];
    taut_form_pair f;

    taut_carrier_forms_at(carrier, at, x, &f);
    w[0] = w[1] = 0;
    if (f.w > 0) {
        const double ew = f.e * f.w;
        w[0] = f.l / f.e - (f.n * f.e * f.e - 2 * f.m * f.e * f.f + f.l * f.f * f.f) / (ew * f.w);
        w[1] = 2 * (f.m * f.e - f.l * f.f) / ew;
        *mean = taut_form_pair_mean(&f);
    }
}

static double turn_between(const double a[2], const double b[2])
{
    return taut_atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
}

/* Does the vector turn by less than 90 degrees along each side of a cell? Then by less than 360 around it, which is by 0. */
static int turns_little(double w[4][2])
{
    int little = 1;
    for (int k = 0; k < 4; k++) {
        const double *a = w[k], *b = w[(k + 1) % 4];
        little &= a[0] * b[0] + a[1] * b[1] > 0;
    }
    return little;
}

/* How far the vector turns along a side. */
static double turn_along(const taut_carrier *carrier, const double from[2], const double a[2],
                         const double to[2], const double b[2], int depth)
{
    const double turn = turn_between(a, b);
    if (fabs(turn) <= largest_turn || depth == 0) {
        return turn;
    }
    const double middle[2] = {(from[0] + to[0]) / 2, (from[1] + to[1]) / 2};
    double w[2], mean = 0;
    vector_at(carrier, middle, w, &mean);
    return turn_along(carrier, from, a, middle, w, depth - 1) +
           turn_along(carrier, middle, w, to, b, depth - 1);
}

/* The zero near a place, by Newton with differences; 0 where it leads away. */
static int solve(const taut_carrier *carrier, const double room[2], double at[2])
{
    const double first[2] = {at[0], at[1]};
    for (int round = 0; round < NEWTON; round++) {
        double w[2], slopes[2][2], mean = 0, largest = 0;
        vector_at(carrier, at, w, &mean);
        for (int d = 0; d < 2; d++) {
            const double h = difference * (carrier->hi[d] - carrier->lo[d]);
            double low[2] = {at[0], at[1]}, high[2] = {at[0], at[1]}, a[2], b[2];
            low[d] -= h;
            high[d] += h;
            vector_at(carrier, low, a, &mean);
            vector_at(carrier, high, b, &mean);
            slopes[0][d] = (b[0] - a[0]) / (2 * h);
            slopes[1][d] = (b[1] - a[1]) / (2 * h);
        }
        const double area = slopes[0][0] * slopes[1][1] - slopes[0][1] * slopes[1][0];
        const double step[2] = {(w[0] * slopes[1][1] - w[1] * slopes[0][1]) / area,
                                (w[1] * slopes[0][0] - w[0] * slopes[1][0]) / area};
        for (int d = 0; d < 2; d++) {
            if (!isfinite(step[d])) {
                return round > 0;
            }
            at[d] -= step[d];
            largest = fmax(largest, fabs(step[d]) / (carrier->hi[d] - carrier->lo[d]));
            if (!(fabs(at[d] - first[d]) <= 2 * room[d]) || !(at[d] > carrier->lo[d]) ||
                !(at[d] < carrier->hi[d])) {
                return 0;
            }
        }
        if (largest <= settled) {
            break;
        }
    }
    return 1;
}

/* *largest: twice R on the circle. */
static double index_of(const taut_carrier *carrier, const double at[2], double *largest)
{
    double around = 0, before[2], here[2], w[2][2], mean = 0;
    *largest = 0;
    for (int k = 0; k <= CIRCLE; k++) {
        const double angle = 2 * TAUT_PI * (k % CIRCLE) / CIRCLE;
        here[0] = at[0] + radius * (carrier->hi[0] - carrier->lo[0]) * taut_cos(angle);
        here[1] = at[1] + radius * (carrier->hi[1] - carrier->lo[1]) * taut_sin(angle);
        for (int d = 0; d < 2; d++) {
            here[d] = fmin(fmax(here[d], carrier->lo[d]), carrier->hi[d]);
        }
        vector_at(carrier, here, w[k % 2], &mean);
        *largest = fmax(*largest, taut_hypot(w[k % 2][0], w[k % 2][1]));
        around += k > 0 ? turn_along(carrier, before, w[(k + 1) % 2], here, w[k % 2], DEPTH) : 0;
        memcpy(before, here, sizeof before);
    }
    return floor(around / (2 * TAUT_PI) + 0.5) / 2;
}

static double turns_round(const taut_carrier *carrier, const double low[2], const double high[2])
{
    double at[4][2], w[4][2], around = 0, mean = 0;
    for (int k = 0; k < 4; k++) {
        at[k][0] = k == 1 || k == 2 ? high[0] : low[0];
        at[k][1] = k >= 2 ? high[1] : low[1];
        vector_at(carrier, at[k], w[k], &mean);
    }
    for (int k = 0; k < 4; k++) {
        around += turn_along(carrier, at[k], w[k], at[(k + 1) % 4], w[(k + 1) % 4], DEPTH);
    }
    return around;
}

/* The part of a cell that is still turned round, halved again and again: from its middle Newton does not lead away. */
static int solve_closely(const taut_carrier *carrier, const double from[2], const double to[2],
                         double at[2])
{
    double low[2] = {from[0], from[1]}, high[2] = {to[0], to[1]};
    for (int k = 0; k < HALVES; k++) {
        const int d = k % 2;
        const double cut = low[d] + part * (high[d] - low[d]);
        double below[2] = {high[0], high[1]};
        below[d] = cut;
        if (fabs(turns_round(carrier, low, below)) > TAUT_PI) {
            high[d] = cut;
        } else {
            low[d] = cut;
        }
    }
    const double room[2] = {high[0] - low[0], high[1] - low[1]};
    at[0] = (low[0] + high[0]) / 2;
    at[1] = (low[1] + high[1]) / 2;
    return solve(carrier, room, at);
}

static int is_known(const taut_carrier *carrier, const double at[2], const taut_singular *list,
                    int count)
{
    int is_there = 0;
    for (int k = 0; k < count; k++) {
        int is_one = 1;
        for (int d = 0; d < 2; d++) {
            const double range = carrier->hi[d] - carrier->lo[d];
            is_one &= fabs(list[k].at[d] - at[d]) <= one_point * range;
        }
        is_there |= is_one;
    }
    return is_there;
}

static void take(const taut_carrier *carrier, int flat, const double low[2], const double high[2],
                 taut_singular list[TAUT_SINGULAR_MAX], int *count)
{
    const double room[2] = {high[0] - low[0], high[1] - low[1]};
    taut_singular found = {.at = {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2}};
    double w[2], mean = 0, largest = 0;
    int is_close = 0;

    if (*count == TAUT_SINGULAR_MAX) {
        return;
    }
    /* the steps from two cells may lead to one, or away from the one in this cell */
    if (!solve(carrier, room, found.at) || is_known(carrier, found.at, list, *count)) {
        is_close = solve_closely(carrier, low, high, found.at);
        if (!is_close || is_known(carrier, found.at, list, *count)) {
            return;
        }
    }
    vector_at(carrier, found.at, w, &mean);
    found.index = index_of(carrier, found.at, &largest);
    const double least = fmin(flat_enough * carrier->roundest, flat_within * largest);
    if (found.index != 0 && (!flat || fabs(mean) <= least) &&
        (!is_close || taut_hypot(w[0], w[1]) <= vanishes * largest)) {
        list[(*count)++] = found;
    }
}

static int cells_along(const taut_carrier *carrier, int d)
{
    const int spans = taut_basis_span_count(carrier->basis[d]), each = CELLS / spans;
    return spans * (each < CELLS_LEAST ? CELLS_LEAST : each > CELLS_MOST ? CELLS_MOST : each);
}

static double line_at(const taut_carrier *carrier, int d, int k, int cells)
{
    const double lo = carrier->lo[d], hi = carrier->hi[d];
    return k == 0 ? lo : k == cells ? hi : lo + (hi - lo) * (k + aside) / cells;
}

int taut_singular_find(const taut_carrier *carrier, int flat, taut_singular list[TAUT_SINGULAR_MAX])
{
    const int cells[2] = {cells_along(carrier, 0), cells_along(carrier, 1)};
    int count = 0;

    for (int i = 0; i < cells[0]; i++) {
        double at[4][2], w[4][2], mean = 0;
        const double u[2] = {line_at(carrier, 0, i, cells[0]),
                             line_at(carrier, 0, i + 1, cells[0])};
        for (int j = 0; j < cells[1]; j++) {
            const double v[2] = {line_at(carrier, 1, j, cells[1]),
                                 line_at(carrier, 1, j + 1, cells[1])};
            double around = 0;
            /* around the cell: the side at v[0] is the last one's at v[1], backwards */
            for (int k = 0; k < 4; k++) {
                at[k][0] = u[k == 1 || k == 2];
                at[k][1] = v[k >= 2];
            }
            if (j == 0) {
                vector_at(carrier, at[0], w[0], &mean);
                vector_at(carrier, at[1], w[1], &mean);
            } else {
                memcpy(w[0], w[3], sizeof w[0]);
                memcpy(w[1], w[2], sizeof w[1]);
            }
            vector_at(carrier, at[2], w[2], &mean);
            vector_at(carrier, at[3], w[3], &mean);
            for (int k = 0; k < 4 && !turns_little(w); k++) {
                around += turn_along(carrier, at[k], w[k], at[(k + 1) % 4], w[(k + 1) % 4], DEPTH);
            }
            if (fabs(around) > TAUT_PI) {
                const double low[2] = {u[0], v[0]}, high[2] = {u[1], v[1]};
                take(carrier, flat, low, high, list, &count);
            }
        }
    }
    return count;
}
