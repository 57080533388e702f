/* turns.c
 *
 *     w = (p - r, 2 q) of the shape operator (p q; q r) in the frame of x_u: 0 where both curvatures are equal, and twice as many
 *     turns round such a place as the directions of lines of curvature, and of asymptotic ones, make
 *     told: |w| there is small beside the largest on a circle round it, and the turns on that circle are twice the index
 *     not told: a cell of a grid that w turns round, halved down to a place where w vanishes, with turns on wider circles too
 *
 * Flat points, of asymptotic nets, have H = 0 besides.
 */
#include "certify/trace/turns.h"

#include "certify/common/verdict.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"

#include <math.h>
#include <string.h>

enum { ROUND = 32, CLOSER = 10, GRID = 24, HALVES = 64, TOLD_MOST = 256, SIDES = 4 };
/* A part of the circle is halved where w turns by more. */
static const double much = 1;
/* Circles round a place that is told, and round one that is not, over the window's sides. */
static const double small = 1e-3, wide[2] = {1e-3, 0.04};
/* Over the window's sides: one point told twice. */
static const double one_place = 1e-6;
/* |w| at a place over its largest on the circle that the figure may have, where its limit is 1e-6; and of a place that should
 * have been told. */
static const double vanish_share = 1e-4, vanishes = 1e-5;
/* |H| over the largest R of a flat point, and of one that is none for sure. */
static const double flat = 1e-5, flat_for_sure = 1e-8;
/* Grid lines are moved by this share of a cell, and halves are unequal: zeros love the middle. */
static const double aside = 0.2718, part = 0.4567;

typedef struct window {
    const taut_net_audit *audit;
    int on;
    double lo[2], hi[2];
} window;

/* 0 where there is no normal. */
static int vector_at(const window *s, const double at[2], double w[2], double *mean)
{
    taut_forms f;
    if (!taut_net_cells_look(s->audit->cells, s->on, at, NULL, &f) || !f.regular) {
        w[0] = w[1] = NAN;
        return 0;
    }
    const double over = f.e * f.w;
    w[0] = f.l / f.e - (f.n * f.e * f.e - 2 * f.m * f.e * f.f + f.l * f.f * f.f) / (over * f.w);
    w[1] = 2 * (f.m * f.e - f.l * f.f) / over;
    *mean = f.mean;
    return 1;
}

static double turn_between(const double a[2], const double b[2])
{
    return taut_atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
}

static void on_circle(const window *s, const double middle[2], double radius, double angle,
                      double at[2])
{
    at[0] = middle[0] + radius * (s->hi[0] - s->lo[0]) * taut_cos(angle);
    at[1] = middle[1] + radius * (s->hi[1] - s->lo[1]) * taut_sin(angle);
    for (int d = 0; d < 2; d++) {
        at[d] = fmin(fmax(at[d], s->lo[d]), s->hi[d]);
    }
}

/* Between two angles of a circle, at which w is a and b. */
static double turn_on(const window *s, const double middle[2], double radius, const double angle[2],
                      const double a[2], const double b[2], int depth)
{
    const double turn = turn_between(a, b), half = (angle[0] + angle[1]) / 2;
    const double first[2] = {angle[0], half}, second[2] = {half, angle[1]};
    double at[2], w[2], mean = 0;
    if (fabs(turn) <= much || depth == 0 || isnan(turn)) {
        return turn;
    }
    on_circle(s, middle, radius, half, at);
    vector_at(s, at, w, &mean);
    return turn_on(s, middle, radius, first, a, w, depth - 1) +
           turn_on(s, middle, radius, second, w, b, depth - 1);
}

/* The turns once around a circle, cut off by the window; *largest: |w| there. NaN where there is no normal. */
static double turns_of(const window *s, const double middle[2], double radius, double *largest)
{
    double around = 0, at[2], w[2][2], mean = 0;
    *largest = 0;
    for (int k = 0; k <= ROUND; k++) {
        const double angle[2] = {2 * TAUT_PI * (k - 1) / ROUND, 2 * TAUT_PI * k / ROUND};
        on_circle(s, middle, radius, k == ROUND ? 0 : angle[1], at);
        vector_at(s, at, w[k % 2], &mean);
        *largest = fmax(*largest, taut_hypot(w[k % 2][0], w[k % 2][1]));
        around += k > 0 ? turn_on(s, middle, radius, angle, w[(k + 1) % 2], w[k % 2], CLOSER) : 0;
    }
    return around / (2 * TAUT_PI);
}

/* How far a point that is told is from one. */
static double point_off(const window *s, const double at[2], double index)
{
    const int is_asymptotic = s->audit->lines->net == TAUT_TRACE_ASYMPTOTIC;
    double w[2], mean = 0, largest = 0;
    for (int d = 0; d < 2; d++) {
        if (!(at[d] >= s->lo[d]) || !(at[d] <= s->hi[d])) {
            return INFINITY;
        }
    }
    const double turns = turns_of(s, at, small, &largest);
    if (!vector_at(s, at, w, &mean) || index == 0 ||
        (is_asymptotic && !(fabs(mean) <= flat * fmax(s->audit->roundest, largest)))) {
        return INFINITY;
    }
    return taut_certify_max(fabs(turns - 2 * index),
                            vanish_share * taut_hypot(w[0], w[1]) / largest);
}

/* Is it told before, to the circle's radius? */
static int is_twice(const window *s, const taut_record *list, size_t index, const double at[2])
{
    int is_there = 0;
    for (size_t k = 0; k < index; k++) {
        const taut_record *other = taut_record_at(list, k), *place = taut_record_get(other, "at");
        int is_near = taut_net_surface_of(s->audit, other) == s->on;
        for (int d = 0; d < 2; d++) {
            const double away = taut_record_number(taut_record_at(place, (size_t)d)) - at[d];
            is_near &= fabs(away) <= one_place * (s->hi[d] - s->lo[d]);
        }
        is_there |= is_near;
    }
    return is_there;
}

/* ---- those that are not told ---- */

typedef struct cell {
    double lo[2], hi[2];
} cell;

static double turn_along(const window *s, const double from[2], const double a[2],
                         const double to[2], const double b[2], int depth)
{
    const double turn = turn_between(a, b);
    const double half[2] = {(from[0] + to[0]) / 2, (from[1] + to[1]) / 2};
    double w[2], mean = 0;
    if (fabs(turn) <= much || depth == 0 || isnan(turn)) {
        return turn;
    }
    vector_at(s, half, w, &mean);
    return turn_along(s, from, a, half, w, depth - 1) + turn_along(s, half, w, to, b, depth - 1);
}

static int is_turned_round(const window *s, const cell *one)
{
    double at[SIDES][2], w[SIDES][2], around = 0, mean = 0;
    for (int k = 0; k < SIDES; k++) {
        at[k][0] = k == 1 || k == 2 ? one->hi[0] : one->lo[0];
        at[k][1] = k >= 2 ? one->hi[1] : one->lo[1];
        vector_at(s, at[k], w[k], &mean);
    }
    for (int k = 0; k < SIDES; k++) {
        const int next = (k + 1) % SIDES;
        around += turn_along(s, at[k], w[k], at[next], w[next], CLOSER);
    }
    return fabs(around) > TAUT_PI;
}

/* Is a point told within the cell, or beside it by its width? */
static int is_told(const window *s, const cell *one)
{
    const taut_record *list =
        taut_record_get(taut_model_details(s->audit->lines->model), "singular_points");
    int is_there = 0;
    for (size_t k = 0; k < taut_record_count(list); k++) {
        const taut_record *point = taut_record_at(list, k), *at = taut_record_get(point, "at");
        int is_near = taut_net_surface_of(s->audit, point) == s->on;
        for (int d = 0; d < 2; d++) {
            const double x = taut_record_number(taut_record_at(at, (size_t)d));
            const double room = one->hi[d] - one->lo[d];
            is_near &= x >= one->lo[d] - room && x <= one->hi[d] + room;
        }
        is_there |= is_near;
    }
    return is_there;
}

/* Is there a point in the cell that should have been told, as R vanishes there and directions turn round it, seen closely
 * and from afar? Not at knots where curvatures jump, where R does not vanish. */
static int hides_one(const window *s, cell one)
{
    const double room = 2 * small;
    double at[2], w[2], mean = 0, largest = 0;
    for (int k = 0; k < HALVES; k++) {
        const int d = k % 2;
        const double cut = one.lo[d] + part * (one.hi[d] - one.lo[d]);
        cell low = one;
        low.hi[d] = cut;
        if (is_turned_round(s, &low)) {
            one = low;
        } else {
            one.lo[d] = cut;
        }
    }
    for (int d = 0; d < 2; d++) {
        at[d] = (one.lo[d] + one.hi[d]) / 2;
        if (!(at[d] - s->lo[d] > room * (s->hi[d] - s->lo[d])) ||
            !(s->hi[d] - at[d] > room * (s->hi[d] - s->lo[d]))) {
            return 0;
        }
    }
    if (!vector_at(s, at, w, &mean)) {
        return 0;
    }
    for (int k = 0; k < 2; k++) {
        const double turns = turns_of(s, at, wide[k], &largest);
        if (!(fabs(turns) > 0.75) || !(taut_hypot(w[0], w[1]) <= vanishes * largest)) {
            return 0;
        }
    }
    return s->audit->lines->net != TAUT_TRACE_ASYMPTOTIC ||
           fabs(mean) <= flat_for_sure * s->audit->roundest;
}

static int leaves_one_out(const window *s)
{
    double line[2][GRID + 1];
    for (int d = 0; d < 2; d++) {
        for (int k = 0; k <= GRID; k++) {
            line[d][k] = k == 0      ? s->lo[d]
                         : k == GRID ? s->hi[d]
                                     : s->lo[d] + (s->hi[d] - s->lo[d]) * (k + aside) / GRID;
        }
    }
    for (int i = 0; i < GRID; i++) {
        for (int j = 0; j < GRID; j++) {
            const cell one = {{line[0][i], line[1][j]}, {line[0][i + 1], line[1][j + 1]}};
            if (is_turned_round(s, &one) && !is_told(s, &one) && hides_one(s, one)) {
                return 1;
            }
        }
    }
    return 0;
}

void taut_net_turns_look(const taut_net_audit *audit, taut_net_off *off)
{
    const taut_trace_net net = audit->lines->net;
    const taut_record *list =
        taut_record_get(taut_model_details(audit->lines->model), "singular_points");
    const size_t count = taut_record_count(list);

    if (audit->is_minimal || (net != TAUT_TRACE_ASYMPTOTIC && net != TAUT_TRACE_PRINCIPAL)) {
        taut_net_off_take(off, count == 0 ? 0 : (double)INFINITY, "net", "singular_points");
        return;
    }
    for (int on = 0; on < audit->lines->surface_count; on++) {
        window s = {.audit = audit, .on = on};
        for (int d = 0; d < 2; d++) {
            const taut_surface *surface = audit->cells->surfaces[on];
            const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
            s.lo[d] = taut_basis_lo(basis);
            s.hi[d] = taut_basis_hi(basis);
        }
        for (size_t k = 0; k < count; k++) {
            const taut_record *point = taut_record_at(list, k);
            const taut_record *place = taut_record_get(point, "at");
            const double at[2] = {taut_record_number(taut_record_at(place, 0)),
                                  taut_record_number(taut_record_at(place, 1))};
            if (taut_net_surface_of(audit, point) == on) {
                const double index = taut_net_number(point, "index");
                taut_net_off_take(
                    off, is_twice(&s, list, k, at) ? (double)INFINITY : point_off(&s, at, index),
                    "net", "singular_points");
            }
        }
        if (count < TOLD_MOST && leaves_one_out(&s)) {
            taut_net_off_take(off, INFINITY, "net", "singular_points");
        }
    }
}
