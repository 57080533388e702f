#include "trace/divide.h"

#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <stdlib.h>
#include <string.h>

enum { NODES = 8, PIECES = 16 /* a span that is crossed */, ROUNDS = 40 };

/* Of t in [0, 1]: a step that is rounding. */
static const double settled = 4e-16;

/* The measure per t at a place of the line. */
static double rate_at(const taut_ruler *r, double t)
{
    const double way[2] = {r->to[0] - r->from[0], r->to[1] - r->from[1]};
    double x[TAUT_CARRIER_VECTORS][3], along[3], at[2];
    taut_form_pair forms;
    int span[2];

    if (r->by == TAUT_TRACE_PARAMETER) {
        return 1;
    }
    for (int d = 0; d < 2; d++) {
        at[d] = fmin(fmax(r->from[d] + t * way[d], r->carrier->lo[d]), r->carrier->hi[d]);
    }
    taut_carrier_cell(r->carrier, at, NULL, span);
    taut_carrier_at(r->carrier, span, at, 2, x);
    taut_linefield_tangent((const double(*)[3])x, way, along);
    const double speed = taut_length(along);
    if (r->by == TAUT_TRACE_LENGTH) {
        return speed;
    }
    taut_carrier_forms((const double(*)[3])x, &forms);
    return forms.w > 0 ? speed * taut_linefield_measure(r->net, &forms) : 0;
}

static double measure_between(const taut_ruler *r, double from, double to)
{
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int k = 0; k < NODES; k++) {
        sum += weights[k] * rate_at(r, (from + to) / 2 + (to - from) / 2 * nodes[k]);
    }
    return sum * (to - from) / 2;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Where the line crosses breaks, 0 and 1 among them, sorted; how many. */
static int crossings(const taut_ruler *r, double *t)
{
    int count = 0;
    t[count++] = 0;
    t[count++] = 1;
    for (int d = 0; d < 2; d++) {
        const double *breaks = taut_basis_breaks(r->carrier->basis[d]);
        const int spans = taut_basis_span_count(r->carrier->basis[d]);
        const double way = r->to[d] - r->from[d];
        for (int k = 1; way != 0 && k < spans; k++) {
            const double at = (breaks[k] - r->from[d]) / way;
            if (at > 0 && at < 1) {
                t[count++] = at;
            }
        }
    }
    qsort(t, (size_t)count, sizeof *t, by_size);
    return count;
}

taut_status taut_ruler_new(taut_arena *arena, const taut_carrier *carrier, taut_trace_net net,
                           taut_trace_by by, const double from[2], const double to[2],
                           taut_ruler *ruler)
{
    const size_t most = 2 + (size_t)taut_basis_span_count(carrier->basis[0]) +
                        (size_t)taut_basis_span_count(carrier->basis[1]);
    double *breaks = taut_arena_take(arena, most, sizeof(double));

    *ruler = (taut_ruler){
        .carrier = carrier, .net = net, .by = by, .from = {from[0], from[1]}, .to = {to[0], to[1]}};
    ruler->t = taut_arena_take(arena, PIECES * most + 1, sizeof(double));
    ruler->sum = taut_arena_take(arena, PIECES * most + 1, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    const int count = crossings(ruler, breaks);
    for (int i = 0; i + 1 < count; i++) {
        for (int k = 0; k < PIECES; k++) {
            const double a = breaks[i] + (breaks[i + 1] - breaks[i]) * k / PIECES;
            const double b = k == PIECES - 1
                                 ? breaks[i + 1]
                                 : breaks[i] + (breaks[i + 1] - breaks[i]) * (k + 1) / PIECES;
            const int next = ++ruler->count;
            ruler->t[next] = b;
            ruler->sum[next] = ruler->sum[next - 1] + measure_between(ruler, a, b);
        }
    }
    return TAUT_OK;
}

/* The t of [low, high] where the measure from t = low is `target`. */
static double solve(const taut_ruler *r, double low, double high, double target)
{
    const double begin = low;
    double t = (low + high) / 2;
    for (int round = 0; round < ROUNDS; round++) {
        const double value = measure_between(r, begin, t) - target, rate = rate_at(r, t);
        if (value > 0) {
            high = t;
        } else {
            low = t;
        }
        double next = t - value / rate;
        if (value == 0 || fabs(next - t) <= settled) { /* before the bracket may throw it off */
            return fmin(fmax(next, low), high);
        }
        if (!(next > low) || !(next < high)) {
            next = (low + high) / 2;
        }
        t = next;
    }
    return t;
}

void taut_ruler_at(const taut_ruler *r, double target, double at[2])
{
    int k = 0;
    while (k < r->count - 1 && !(r->sum[k + 1] >= target)) {
        k++;
    }
    double t = r->t[k + 1];
    if (target <= 0) {
        t = 0;
    } else if (target < r->sum[r->count]) {
        t = solve(r, r->t[k], r->t[k + 1], target - r->sum[k]);
    }
    for (int d = 0; d < 2; d++) {
        at[d] = t <= 0 ? r->from[d] : t >= 1 ? r->to[d] : r->from[d] + t * (r->to[d] - r->from[d]);
        at[d] = fmin(fmax(at[d], r->carrier->lo[d]), r->carrier->hi[d]);
    }
}

static double of_station(const taut_station *at, taut_trace_by by)
{
    return by == TAUT_TRACE_CONFORMAL ? at->measure : at->s;
}

int taut_lath_at(taut_linefield_kind kind, const taut_lath *lath, taut_trace_by by, double target,
                 taut_station *station)
{
    int k = 0;
    while (k < lath->count - 1 && !(of_station(&lath->segments[k].to, by) >= target)) {
        k++;
    }
    const taut_segment *segment = &lath->segments[k];
    const taut_carrier *carrier = segment->start.on;
    const double begin = of_station(&segment->from, by), end = of_station(&segment->to, by);
    const double low = segment->from.s, high = segment->to.s;
    double s = low + (high - low) * fmin(fmax((target - begin) / (end - begin), 0), 1);

    for (int round = 0; round < ROUNDS; round++) {
        double x[TAUT_CARRIER_VECTORS][3];
        taut_form_pair forms;
        if (!taut_segment_state(kind, segment, s, station)) {
            return 0;
        }
        taut_carrier_at(carrier, segment->start.span, station->at, 2, x);
        taut_carrier_forms((const double(*)[3])x, &forms);
        const double rate =
            by == TAUT_TRACE_CONFORMAL ? taut_linefield_measure(kind.net, &forms) : 1;
        const double next = fmin(fmax(s - (of_station(station, by) - target) / rate, low), high);
        if (!(fabs(next - s) > 1e-15 * carrier->size)) {
            return 1;
        }
        s = next;
    }
    return 1;
}
