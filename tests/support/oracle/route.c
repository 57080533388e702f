/* route.c -- the axis of a round pipe: places, nearest points, the tube around it. */
#include "oracle/route.h"

#include <math.h>
#include <string.h>

int oracle_route_of(const taut_curve *axis, oracle_route *route)
{
    memset(route, 0, sizeof *route);
    if (!oracle_line_of(axis, &route->line)) {
        return 0;
    }
    route->lo = route->line.t.lo;
    route->hi = route->line.t.hi;
    for (int i = 0; i <= ROUTE_PLACES; i++) {
        oracle_real x[3][3];
        oracle_line_eval(&route->line, route->lo + (route->hi - route->lo) * i / ROUTE_PLACES, x);
        for (int k = 0; k < 3; k++) {
            route->place[i][k] = (double)x[0][k];
        }
    }
    for (int e = 0; e < 2; e++) {
        oracle_real x[3][3];
        oracle_line_eval(&route->line, e ? route->hi : route->lo, x);
        for (int k = 0; k < 3; k++) {
            route->end[e][k] = x[0][k];
            route->way[e][k] = x[1][k] / oracle_norm(x[1]);
        }
    }
    return 1;
}

void oracle_route_at(const oracle_route *route, oracle_real s, oracle_real x[3], oracle_real way[3],
                     oracle_real *speed)
{
    oracle_real y[3][3];

    if (s < route->lo || s > route->hi) {
        const int e = s > route->hi;
        const oracle_real d = s - (e ? route->hi : route->lo);
        for (int k = 0; k < 3; k++) {
            x[k] = route->end[e][k] + d * route->way[e][k];
            way[k] = route->way[e][k];
        }
        *speed = 1;
        return;
    }
    oracle_line_eval(&route->line, s, y);
    *speed = oracle_norm(y[1]);
    for (int k = 0; k < 3; k++) {
        x[k] = y[0][k];
        way[k] = y[1][k] / *speed;
    }
}

/* The parameter of the nearest point from a first guess, by Gauss and Newton's step, held inside. */
static oracle_real nearest(const oracle_route *route, const oracle_real p[3], oracle_real s,
                           oracle_real lo, oracle_real hi)
{
    for (int turn = 0; turn < 10; turn++) {
        oracle_real x[3], way[3], speed, d[3], move;
        oracle_route_at(route, s, x, way, &speed);
        for (int k = 0; k < 3; k++) {
            d[k] = p[k] - x[k];
        }
        move = oracle_dot(d, way) / speed;
        s = fminl(hi, fmaxl(lo, s + move));
        if (fabsl(move) < 1e-17L) {
            break;
        }
    }
    return s;
}

/* The distance of p from the part lo .. hi of the axis, and where: the nearest of some places, then
 * Newton's steps, held inside. */
static oracle_real distance_to(const oracle_route *route, const oracle_real p[3], oracle_real *at)
{
    oracle_real best = INFINITY, s = route->lo, y[3][3], d[3];
    double least = INFINITY;

    for (int i = 0; i <= ROUTE_PLACES; i++) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            const double e = (double)p[k] - route->place[i][k];
            sum += e * e;
        }
        if (sum < least) {
            least = sum;
            s = route->lo + (route->hi - route->lo) * i / ROUTE_PLACES;
        }
    }
    const oracle_real step = (route->hi - route->lo) / ROUTE_PLACES;
    oracle_real a = fmaxl(route->lo, s - step), b = fminl(route->hi, s + step);
    for (int turn = 0; turn < 60; turn++) { /* the slope changes sign between a and b */
        oracle_line_eval(&route->line, s, y);
        for (int k = 0; k < 3; k++) {
            d[k] = y[0][k] - p[k];
        }
        if (oracle_norm(d) < best) {
            best = oracle_norm(d);
            *at = s;
        }
        const oracle_real slope = oracle_dot(d, y[1]);
        const oracle_real bend = oracle_dot(y[1], y[1]) + oracle_dot(d, y[2]);
        *(slope > 0 ? &b : &a) = s;
        const oracle_real next = s - slope / bend, before = s;
        s = bend > 0 && next >= a && next <= b ? next : (a + b) / 2;
        if (fabsl(s - before) < 1e-14L * step) {
            break;
        }
    }
    return best;
}

/* How often the ring at u goes around the axis, and whether it closes. */
static int ring_is_whole(const oracle_sheet *sheet, const oracle_route *route, oracle_real u,
                         oracle_real at, double radius)
{
    oracle_real c[3], way[3], speed, x[6][3], first[3] = {0}, last[3], before[3] = {0}, turn = 0;
    const int n = 8 * sheet->v.spans + 16;

    oracle_route_at(route, at, c, way, &speed);
    for (int i = 0; i <= n; i++) {
        oracle_real d[3], cross[3], along;
        oracle_sheet_eval(sheet, u, sheet->v.lo + ((oracle_real)sheet->v.hi - sheet->v.lo) * i / n,
                          0, x);
        for (int k = 0; k < 3; k++) {
            last[k] = x[0][k];
            d[k] = x[0][k] + sheet->middle[k] - c[k];
        }
        along = oracle_dot(d, way);
        for (int k = 0; k < 3; k++) {
            d[k] -= along * way[k];
        }
        if (i == 0) {
            memcpy(first, last, sizeof first);
        } else {
            oracle_cross(before, d, cross);
            turn += atan2l(oracle_dot(cross, way), oracle_dot(before, d));
        }
        memcpy(before, d, sizeof before);
    }
    for (int k = 0; k < 3; k++) {
        last[k] -= first[k];
    }
    return oracle_norm(last) <= 1e-5L * radius && fabsl(fabsl(turn) - 6.283185307179586L) < 1e-2L;
}

oracle_real oracle_tube_along(const oracle_sheet *sheet, const oracle_route *route, double radius)
{
    oracle_real worst = 0, lowest = 1, highest = 0;
    const int per = 1, around = sheet->v.spans > 8 ? 1 : 2;

    for (int i = 0; i < sheet->u.spans * per; i++) {
        const oracle_real lo = sheet->u.breaks[i / per];
        const oracle_real u = lo + (sheet->u.breaks[i / per + 1] - lo) * (i % per + 0.47L) / per;
        for (int j = 0; j < sheet->v.spans * around; j++) {
            const oracle_real vlo = sheet->v.breaks[j / around];
            const oracle_real v =
                vlo + (sheet->v.breaks[j / around + 1] - vlo) * (j % around + 0.53L) / around;
            oracle_real x[6][3], p[3], at;
            oracle_sheet_eval(sheet, u, v, 0, x);
            for (int k = 0; k < 3; k++) {
                p[k] = x[0][k] + sheet->middle[k];
            }
            const oracle_real d = distance_to(route, p, &at);
            worst = fmaxl(worst, fabsl(d - radius) / radius);
        }
    }
    for (int i = 0; i < 5; i++) { /* the other side */
        const oracle_real u = sheet->u.lo + ((oracle_real)sheet->u.hi - sheet->u.lo) * i / 4;
        oracle_real x[6][3], p[3], at;
        oracle_sheet_eval(sheet, u, sheet->v.lo, 0, x);
        for (int k = 0; k < 3; k++) {
            p[k] = x[0][k] + sheet->middle[k];
        }
        distance_to(route, p, &at);
        at = (at - route->lo) / (route->hi - route->lo);
        lowest = fminl(lowest, at);
        highest = fmaxl(highest, at);
        if (!ring_is_whole(sheet, route, u, route->lo + at * (route->hi - route->lo), radius)) {
            return INFINITY;
        }
    }
    return lowest > 1e-3L || highest < 1 - 1e-3L ? INFINITY : worst;
}

oracle_real oracle_settle(const oracle_route *one, oracle_real s, const oracle_route *other,
                          oracle_real t, double radius)
{
    const oracle_real lo[2] = {one->lo - one->reach[0], other->lo - other->reach[0]};
    const oracle_real hi[2] = {one->hi + one->reach[1], other->hi + other->reach[1]};
    oracle_real x[3], y[3], a[3], b[3], d[3], speed;

    for (int turn = 0; turn < 12; turn++) {
        oracle_route_at(other, t, y, b, &speed);
        s = nearest(one, y, s, lo[0], hi[0]);
        oracle_route_at(one, s, x, a, &speed);
        t = nearest(other, x, t, lo[1], hi[1]);
    }
    oracle_route_at(one, s, x, a, &speed);
    oracle_route_at(other, t, y, b, &speed);
    for (int k = 0; k < 3; k++) {
        d[k] = x[k] - y[k];
    }
    const oracle_real length = oracle_norm(d);
    if (fabsl(oracle_dot(d, a)) > 1e-6L * length || fabsl(oracle_dot(d, b)) > 1e-6L * length ||
        (one == other && fabsl(s - t) < 1e-3L * (hi[0] - lo[0])) || length < 1e-9L * radius) {
        return INFINITY;
    }
    return length / 2;
}

oracle_real oracle_sharpest(const oracle_route *route)
{
    oracle_real best = INFINITY, y[3][3], c[3];

    for (int i = 0; i <= 400; i++) {
        oracle_line_eval(&route->line, route->lo + (route->hi - route->lo) * i / 400, y);
        oracle_cross(y[1], y[2], c);
        best = fminl(best, powl(oracle_norm(y[1]), 3) / oracle_norm(c));
    }
    return best;
}
