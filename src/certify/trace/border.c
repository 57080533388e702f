/* border.c
 *
 *     the border as t from 0 to 4: v0, u1, v1, u0; the ends of all stretches of the family that lie on it
 *     the integral of measure |T x dx| with its sign, T the family's direction carried on, between them and the knots, by Gauss's
 *     rule on pieces of these parts, twice around
 *     in the second turn, and to the first end of the third, of each piece's end: the nearest value of the last ends before it;
 *     more than one, as curves of other seeds may end between; anew where the net does not exist between
 *     from one end to the next a part and a half is as good as one, if the next one is that far: a curve a part behind the
 *     one would be nearer than half a part to the other
 */
#include "certify/trace/border.h"

#include "certify/trace/family.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <math.h>

enum { SIDES = 4, PIECES = 4 /* of a part */, NODES = 8, LAST = 3 };
/* Over a side: an end lies on the border. */
static const double on_border = 1e-9;
/* Of a part: quadrature of both sides. */
static const double same_part = 1e-3;

typedef struct border {
    taut_net_cells *cells;
    int on, family;
    taut_trace_net net;
    taut_trace_by by;
    double lo[2], width[2];
    double tangent[3]; /* of the family, carried on; 0 before it is known */
    double nodes[NODES], weights[NODES];
    double *stops; /* ends and knots, in order, 0 to 4 */
    int *is_end;
    int count;
} border;

static void place_of(const border *b, double t, double at[2], double way[2])
{
    const int side = t < 1 ? 0 : t < 2 ? 1 : t < 3 ? 2 : 3, d = side % 2;
    const double share = side < 2 ? t - side : side + 1 - t;
    at[d] = b->lo[d] + fmin(fmax(share, 0), 1) * b->width[d];
    at[1 - d] = b->lo[1 - d] + (side == 1 || side == 2 ? b->width[1 - d] : 0);
    way[d] = side < 2 ? b->width[d] : -b->width[d];
    way[1 - d] = 0;
}

/* The measure across the family per t; NaN where the net does not exist. */
static double rate_at(border *b, double t)
{
    double at[2], side[2], way[2], s[3][3], tangent[3], along[3], across[3];
    taut_forms f;

    place_of(b, t, at, side);
    if (!taut_net_cells_look(b->cells, b->on, at, s, &f) ||
        !taut_net_family_way(b->net, b->family, &f, way) ||
        (b->net == TAUT_TRACE_ASYMPTOTIC && !(f.gaussian < 0))) {
        return NAN;
    }
    for (int c = 0; c < 3; c++) {
        tangent[c] = way[0] * s[1][c] + way[1] * s[2][c];
        along[c] = side[0] * s[1][c] + side[1] * s[2][c];
    }
    const double length = taut_norm(tangent);
    const double sign = taut_dot(tangent, b->tangent) < 0 ? -1 : 1;
    for (int c = 0; c < 3; c++) {
        b->tangent[c] = tangent[c] *= sign / length;
    }
    taut_cross(f.normal, tangent, across);
    const double square =
        b->net == TAUT_TRACE_ASYMPTOTIC ? -f.gaussian : f.mean * f.mean - f.gaussian;
    const int is_conformal = b->by == TAUT_TRACE_CONFORMAL && b->net != TAUT_TRACE_ISOPARAMETRIC;
    return taut_dot(across, along) * (is_conformal ? sqrt(sqrt(fmax(square, 0))) : 1);
}

static double measure_between(border *b, double from, double to)
{
    double sum = 0;
    for (int k = 0; k < NODES; k++) {
        sum += b->weights[k] * rate_at(b, (from + to) / 2 + (to - from) / 2 * b->nodes[k]);
    }
    return sum * (to - from) / 2;
}

/* ---- where it stops ---- */

static void add_stop(border *b, double t, int is_end)
{
    int k = b->count++;
    for (; k > 0 && b->stops[k - 1] > t; k--) {
        b->stops[k] = b->stops[k - 1];
        b->is_end[k] = b->is_end[k - 1];
    }
    b->stops[k] = t;
    b->is_end[k] = is_end;
}

/* An end of a stretch, on every side that it lies on. */
static void add_end(border *b, const double at[2])
{
    double share[2];
    for (int d = 0; d < 2; d++) {
        share[d] = (at[d] - b->lo[d]) / b->width[d];
    }
    for (int side = 0; side < SIDES; side++) {
        const int d = side % 2, is_high = side == 1 || side == 2;
        const double t = side < 2 ? share[d] : 1 - share[d];
        if (fabs(share[1 - d] - is_high) <= on_border && t >= -on_border && t <= 1 + on_border) {
            add_stop(b, side + fmin(fmax(t, 0), 1), 1);
        }
    }
}

static taut_status find_stops(const taut_net_lines *lines, const taut_surface *surface,
                              taut_arena *arena, border *b)
{
    const taut_basis *basis[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    size_t most = 2 * SIDES + 1;
    for (int d = 0; d < 2; d++) {
        most += 2 * (size_t)taut_basis_span_count(basis[d]);
    }
    for (int i = 0; i < lines->count; i++) {
        most += 4 * (size_t)lines->lines[i].count; /* corners are on two sides */
    }
    b->stops = taut_arena_take(arena, most, sizeof *b->stops);
    b->is_end = taut_arena_take(arena, most, sizeof *b->is_end);
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int side = 0; side < SIDES; side++) {
        const int d = side % 2;
        for (int k = 0; k <= taut_basis_span_count(basis[d]); k++) {
            const double share = (taut_basis_breaks(basis[d])[k] - b->lo[d]) / b->width[d];
            add_stop(b, side + (side < 2 ? share : 1 - share), 0);
        }
    }
    for (int i = 0; i < lines->count; i++) {
        const taut_net_line *line = &lines->lines[i];
        for (int k = 0; line->family == b->family && k < line->count; k++) {
            const taut_basis *t = taut_curve_t(line->window[k]);
            for (int end = 0; line->on[k] == b->on && end < 2; end++) {
                double at[3];
                taut_curve_eval(line->window[k], end == 0 ? taut_basis_lo(t) : taut_basis_hi(t), 0,
                                at);
                add_end(b, at);
            }
        }
    }
    return TAUT_OK;
}

/* ---- once around ---- */

/* The sum so far, those at the ends before, the farthest from the last of these since the last one, and of all. */
typedef struct tally {
    double sum, farthest, gap, part;
    double *ends;
    int count;
} tally;

static void judge(tally *all)
{
    double nearest = INFINITY;
    for (int k = all->count > LAST ? all->count - LAST : 0; k < all->count; k++) {
        nearest = fmin(nearest, fabs(all->sum - all->ends[k]));
    }
    all->farthest = fmax(all->farthest, nearest);
}

/* What is behind the last end is done: at the next one, or where the net ends. */
static void settle(tally *all, int is_end)
{
    const int k = all->count - 1;
    const int is_one = is_end && k >= 0 && all->farthest <= (1.5 + same_part) * all->part &&
                       fabs(all->sum - all->ends[k]) >= (0.5 - same_part) * all->part;
    all->gap = fmax(all->gap, is_one ? fmin(all->farthest, all->part) : all->farthest);
    all->farthest = 0;
}

taut_status taut_net_border_gap(const taut_net_lines *lines, taut_net_cells *cells, int on,
                                int family, taut_trace_by by, double part, taut_arena *arena,
                                double *gap)
{
    const taut_surface *surface = cells->surfaces[on];
    border b = {.cells = cells, .on = on, .family = family, .net = lines->net, .by = by};
    tally all = {.part = part};

    for (int d = 0; d < 2; d++) {
        const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
        b.lo[d] = taut_basis_lo(basis);
        b.width[d] = taut_basis_hi(basis) - b.lo[d];
    }
    taut_gauss_rule(NODES, b.nodes, b.weights);
    *gap = 0;
    if (find_stops(lines, surface, arena, &b) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    all.ends = taut_arena_take(arena, 3 * (size_t)b.count, sizeof *all.ends);
    if (all.ends == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < 2 * b.count || (i < 3 * b.count && all.farthest > 0); i++) {
        const int k = i % b.count;
        const double from = b.stops[k], to = k + 1 < b.count ? b.stops[k + 1] : SIDES;
        if (b.is_end[k]) {
            settle(&all, 1);
            if (i >= 2 * b.count) {
                break;
            }
            all.ends[all.count++] = all.sum;
        }
        for (int piece = 0; to > from && piece < PIECES; piece++) {
            all.sum += measure_between(&b, from + (to - from) * piece / PIECES,
                                       from + (to - from) * (piece + 1) / PIECES);
            if (isnan(all.sum)) { /* what is behind begins anew at the next end */
                settle(&all, 0);
                all = (tally){.gap = all.gap, .part = part, .ends = all.ends};
            } else if (i >= b.count && all.count > 0) {
                judge(&all);
            }
        }
    }
    *gap = all.gap;
    return TAUT_OK;
}
