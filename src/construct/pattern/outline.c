#include "construct/pattern/outline.h"

#include "construct/pattern/line.h"
#include "core/elementary/elementary.h"
#include "geometry/keep.h"
#include "numeric/quadrature.h"
#include "pattern/flat/line.h"

#include <math.h>
#include <string.h>

enum {
    NODES = 6,
    FIRST = 16,
    MOST = 512,
    LOOK = 8 /* places a span, for extremes */
};
/* How uneven the speed may be, and a step of Newton's that is rounding. */
static const double even = 5e-11, settled = 1e-15;
/* Of a coordinate: rounding, and how much higher than the places that are looked at the curve may be between them. */
static const double rounding = 1e-13, higher = 1e-3;
enum { THIRDS = 60 };
/* An edge may be longer or shorter by so much for ending in the spline's corner, over its length. */
static const double longer_most = 4e-10;

/* ---- the curve of exact speed ---- */

typedef struct edge_source {
    const taut_pattern_layout *layout;
    const taut_pattern_cut *cut;
    int piece, edge;
    const taut_curve *spline;
    int is_movable; /* some edge of the piece is free to end elsewhere */
} edge_source;

/* y' and y'' of the curve. */
static void slopes_at(const edge_source *e, double s, double slope[2][2])
{
    double y[3][3], speed[2] = {0, 0};
    taut_curve_eval(e->spline, s, 2, y[0]);
    taut_pattern_held_speed(e->layout, e->cut, e->piece, e->edge, s, speed);
    const double length = taut_hypot(y[1][0], y[1][1]);
    const double way[2] = {y[1][0] / length, y[1][1] / length};
    const double turn = (way[0] * y[2][1] - way[1] * y[2][0]) / length;
    for (int d = 0; d < 2; d++) {
        slope[0][d] = speed[0] * way[d];
    }
    slope[1][0] = speed[1] * way[0] - speed[0] * turn * way[1];
    slope[1][1] = speed[1] * way[1] + speed[0] * turn * way[0];
}

/* The largest share by which the speed between stations is off. */
static double unevenness(const edge_source *e, const taut_curve *curve, int spans)
{
    const int graded = e->layout->pieces[e->piece].is_graded;
    double most = 0;
    for (int k = 0; k < 2 * spans; k++) {
        const double s = taut_flat_place(spans, graded, k / 2, k % 2 == 0 ? -0.58 : 0.58);
        double y[2][3], speed[2] = {0, 0};
        taut_curve_eval(curve, s, 1, y[0]);
        taut_pattern_held_speed(e->layout, e->cut, e->piece, e->edge, s, speed);
        most = fmax(most, fabs(taut_hypot(y[1][0], y[1][1]) / speed[0] - 1));
    }
    return most;
}

/* `moved`: how far from the spline's corner it ends. */
static taut_status exact_edge(const edge_source *e, taut_arena *arena, const taut_curve **curve,
                              double moved[2], taut_pattern_outline *outline)
{
    double nodes[NODES], weights[NODES], before = INFINITY;
    const int graded = e->layout->pieces[e->piece].is_graded;
    taut_gauss_rule(NODES, nodes, weights);
    const int own = taut_basis_span_count(taut_curve_t(e->spline));
    for (int spans = own > FIRST ? own : FIRST; spans <= MOST; spans *= 2) {
        taut_pattern_station *at = taut_arena_take(arena, (size_t)spans + 1, sizeof *at);
        double y[1][3], slope[2][2], length = 0;
        if (at == NULL) {
            return TAUT_NO_MEMORY;
        }
        taut_curve_eval(e->spline, 0, 0, y[0]);
        for (int k = 0; k <= spans; k++) {
            const double s = taut_flat_break(spans, graded, k);
            slopes_at(e, s, slope);
            at[k].x = s;
            memcpy(at[k].y[0], y[0], sizeof at[k].y[0]);
            memcpy(at[k].y[1], slope, sizeof slope);
            const double half = k < spans ? taut_flat_half(spans, graded, k) : 0;
            for (int q = 0; k < spans && q < NODES; q++) {
                slopes_at(e, s + half * (1 + nodes[q]), slope);
                y[0][0] += weights[q] * half * slope[0][0];
                y[0][1] += weights[q] * half * slope[0][1];
                length += weights[q] * half * taut_hypot(slope[0][0], slope[0][1]);
            }
        }
        taut_curve_eval(e->spline, 1, 0, y[0]);
        const double gap[2] = {y[0][0] - at[spans].y[0][0], y[0][1] - at[spans].y[0][1]};
        const double *way = at[spans].y[1];
        const double along = (gap[0] * way[0] + gap[1] * way[1]) / taut_hypot(way[0], way[1]);
        outline->closure = fmax(outline->closure, taut_hypot(gap[0], gap[1]));
        outline->longer = fmax(outline->longer, fabs(along) / length);
        const int is_moved = e->is_movable && fabs(along) > longer_most * length;
        for (int d = 0; d < 2; d++) {
            moved[d] = is_moved ? -gap[d] : 0;
        }
        if (!is_moved) {
            memcpy(at[spans].y[0], y[0], sizeof at[spans].y[0]);
        }
        const taut_status status = taut_pattern_quintics(spans, at, arena, curve);
        if (status != TAUT_OK) {
            return status;
        }
        const double off = unevenness(e, *curve, spans);
        if (off <= even || off > before / 2) {
            break;
        }
        before = off;
    }
    return TAUT_OK;
}

/* ---- the line to cut along ---- */

/* Edges end to end. */
static taut_status close_edges(const taut_curve *const edges[TAUT_FLAT_EDGES], taut_arena *arena,
                               const taut_curve **cut)
{
    taut_pattern_part parts[TAUT_FLAT_EDGES];
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        parts[e] = (taut_pattern_part){edges[e], taut_pattern_edge_is_back[e], e, e + 1};
    }
    return taut_pattern_join(TAUT_FLAT_EDGES, parts, arena, cut);
}

/* Of places t[0] to t[2] that are looked at, the one in the middle not below the others: the top of the hill between them, by thirds. */
static double climb(const taut_curve *curve, int axis, double sign, const double t[3])
{
    double lo = t[0], hi = t[2], top = -INFINITY;
    for (int round = 0; round < THIRDS; round++) {
        const double at[2] = {lo + (hi - lo) / 3, hi - (hi - lo) / 3};
        double value[2];
        for (int k = 0; k < 2; k++) {
            double y[1][3];
            taut_curve_eval(curve, at[k], 0, y[0]);
            value[k] = sign * y[0][axis];
            top = fmax(top, value[k]);
        }
        *(value[0] < value[1] ? &lo : &hi) = at[value[0] < value[1] ? 0 : 1];
    }
    return top;
}

/* The top of any hill that is higher than all that was found, which Newton's method may have missed. */
static double highest(const taut_curve *curve, int axis, double sign, double best)
{
    const taut_basis *basis = taut_curve_t(curve);
    const double *breaks = taut_basis_breaks(basis);
    const int places = taut_basis_span_count(basis) * LOOK;
    const double found = best;
    double t[3] = {breaks[0], breaks[0], breaks[0]}, value[3] = {0};
    for (int i = 0; i <= places + 1; i++) {
        const int at = i < places ? i : places;
        const int span = at < places ? at / LOOK : at / LOOK - 1;
        double y[1][3];
        t[0] = t[1];
        t[1] = t[2];
        t[2] = breaks[span] + (breaks[span + 1] - breaks[span]) * (at - span * LOOK) / LOOK;
        taut_curve_eval(curve, t[2], 0, y[0]);
        value[0] = value[1];
        value[1] = value[2];
        value[2] = sign * y[0][axis];
        if (i > 0 && (i == 1 || value[1] >= value[0]) && value[1] >= value[2] &&
            value[1] > found - higher) {
            const double top = climb(curve, axis, sign, t);
            best = top > best + rounding ? top : best;
        }
    }
    return best;
}

/* Where a curve reaches farthest along an axis (sign 1) or against it (-1): from the best of many places on by Newton's method. */
static double reach(const taut_curve *curve, int axis, double sign)
{
    const taut_basis *basis = taut_curve_t(curve);
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    double best = -INFINITY, at = 0, lo = 0, hi = 0;
    for (int i = 0; i < spans; i++) {
        for (int k = 0; k <= LOOK; k++) {
            const double t = breaks[i] + (breaks[i + 1] - breaks[i]) * k / LOOK;
            double y[3];
            taut_curve_eval(curve, t, 0, y);
            if (sign * y[axis] > best) {
                best = sign * y[axis];
                at = t;
                lo = breaks[i > 0 && k == 0 ? i - 1 : i];
                hi = breaks[i + 1 < spans && k == LOOK ? i + 2 : i + 1];
            }
        }
    }
    for (int round = 0; round < 8; round++) {
        double y[3][3];
        taut_curve_eval(curve, at, 2, y[0]);
        const double step = -y[1][axis] / y[2][axis];
        if (!(sign * y[2][axis] < 0) || !(fabs(step) > settled)) {
            break;
        }
        const double next = fmin(fmax(at + step, lo), hi);
        taut_curve_eval(curve, next, 0, y[0]);
        if (!(sign * y[0][axis] > best)) {
            break;
        }
        best = sign * y[0][axis];
        at = next;
    }
    return sign * highest(curve, axis, sign, best);
}

/* What a closed line goes around. */
static double area_of(const taut_curve *curve)
{
    const taut_basis *basis = taut_curve_t(curve);
    const double *breaks = taut_basis_breaks(basis);
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int i = 0; i < taut_basis_span_count(basis); i++) {
        const double half = (breaks[i + 1] - breaks[i]) / 2;
        for (int q = 0; q < NODES; q++) { /* exact: degree 9 */
            double y[2][3];
            taut_curve_eval(curve, breaks[i] + half * (1 + nodes[q]), 1, y[0]);
            sum += weights[q] * half * (y[0][0] * y[1][1] - y[0][1] * y[1][0]) / 2;
        }
    }
    return sum;
}

void taut_pattern_outline_bound(taut_pattern_outline *outline)
{
    for (int d = 0; d < 2; d++) {
        outline->low[d] = reach(outline->cut, d, -1);
        outline->high[d] = reach(outline->cut, d, 1);
    }
    outline->area = area_of(outline->cut);
}

/* The corners where edges begin and end, as s or t grows: of right and start, right and end, left and end, left and start. */
static const int corners_of[TAUT_FLAT_EDGES][2] = {{0, 1}, {1, 2}, {3, 2}, {0, 3}};

/* Moves of corners: along an edge that is held from the one to the other as it is `moved`, and else none. */
static void move_corners(const int is_rigid[TAUT_FLAT_EDGES],
                         const double moved[TAUT_FLAT_EDGES][2], double corners[4][2])
{
    static const int order[4] = {0, 3, 1, 2};
    int is_known[4] = {0, 0, 0, 0};
    memset(corners, 0, sizeof(double[4][2]));
    for (int k = 0; k < 4; k++) {
        is_known[order[k]] = 1;
        for (int e = 0; e < 2 * TAUT_FLAT_EDGES; e++) { /* twice: the way around is one of edges */
            const int edge = e % TAUT_FLAT_EDGES, a = corners_of[edge][0], b = corners_of[edge][1];
            for (int d = 0; is_rigid[edge] && d < 2; d++) {
                if (is_known[a] && !is_known[b]) {
                    corners[b][d] = corners[a][d] + moved[edge][d];
                } else if (is_known[b] && !is_known[a]) {
                    corners[a][d] = corners[b][d] - moved[edge][d];
                }
            }
            is_known[a] |= is_rigid[edge] && is_known[b];
            is_known[b] |= is_rigid[edge] && is_known[a];
        }
    }
}

/* An edge with its ends moved; one that is held, as it is. */
static taut_status move_edge(taut_arena *arena, int is_rigid, const double from[2],
                             const double to[2], const taut_curve **edge)
{
    const size_t count = (size_t)taut_basis_count(taut_curve_t(*edge));
    double *points = taut_arena_copy(arena, taut_curve_points(*edge), count, sizeof(double[3]));
    taut_curve *moved = NULL;
    if (points == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int d = 0; d < 2; d++) {
        for (size_t k = 0; is_rigid && k < count; k++) {
            points[3 * k + (size_t)d] += from[d];
        }
        if (!is_rigid) {
            points[d] += from[d];
            points[3 * (count - 1) + (size_t)d] += to[d];
        }
    }
    const taut_status status =
        taut_curve_new(NULL, taut_curve_t(*edge), points, NULL, &moved, NULL);
    *edge = moved;
    return status == TAUT_OK && taut_keep_curve(arena, moved) ? TAUT_OK : TAUT_NO_MEMORY;
}

static taut_status move_edges(taut_arena *arena, const int is_rigid[TAUT_FLAT_EDGES],
                              const double moved[TAUT_FLAT_EDGES][2], taut_pattern_outline *outline)
{
    double corners[4][2];
    taut_status status = TAUT_OK;
    move_corners(is_rigid, moved, corners);
    for (int e = 0; status == TAUT_OK && e < TAUT_FLAT_EDGES; e++) {
        const double *from = corners[corners_of[e][0]], *to = corners[corners_of[e][1]];
        if (from[0] != 0 || from[1] != 0 || (!is_rigid[e] && (to[0] != 0 || to[1] != 0))) {
            status = move_edge(arena, is_rigid[e], from, to, &outline->edges[e]);
        }
    }
    return status;
}

taut_status taut_pattern_outline_new(const taut_pattern_layout *layout, const taut_pattern_cut *cut,
                                     int piece, taut_arena *arena, taut_pattern_outline *outline)
{
    const taut_pattern_piece *one = &layout->pieces[piece];
    taut_status status = TAUT_OK;
    double moved[TAUT_FLAT_EDGES][2] = {{0, 0}};
    int is_held[TAUT_FLAT_EDGES], is_rigid[TAUT_FLAT_EDGES], is_movable = 0;
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        double speed[2];
        is_held[e] = taut_pattern_held_speed(layout, cut, piece, e, 0, speed);
        is_rigid[e] = is_held[e] || one->bounds[e].is_point;
        is_movable |= !is_rigid[e] && !cut->is_straight;
    }

    *outline = (taut_pattern_outline){.closure = 0};
    for (int e = 0; status == TAUT_OK && e < TAUT_FLAT_EDGES; e++) {
        outline->edges[e] = one->edges[e];
        if (is_held[e]) {
            const edge_source source = {layout, cut, piece, e, one->edges[e], is_movable};
            status = exact_edge(&source, arena, &outline->edges[e], moved[e], outline);
        }
    }
    if (status == TAUT_OK && is_movable) {
        status = move_edges(arena, is_rigid, (const double(*)[2])moved, outline);
    }
    if (status == TAUT_OK) {
        status = close_edges(outline->edges, arena, &outline->cut);
    }
    if (status == TAUT_OK) {
        taut_pattern_outline_bound(outline);
    }
    return status;
}
