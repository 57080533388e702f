/* layout.c -- strips across: geodesics between the places that cut both edges in equal parts.
 *
 * They count from the low end of the first edge. A piece's t runs to the left of its s, seen from the side of the normal: towards
 * falling u where s runs with v.
 */
#include "construct/pattern/layout.h"

#include "core/fail.h"
#include "trace/divide.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ALONG = 32, ACROSS = 4, CHAIN = 64 };
/* The least area element that is one, over the largest. */
static const double least_area = 1e-9;

/* Places [count + 1] on an edge, as u or v grows. */
static taut_status divide(const taut_carrier *carrier, int edge, taut_pattern_by by, int count,
                          taut_arena *arena, double (*at)[2], taut_error *error)
{
    const int held = edge / 2, along = 1 - held;
    double ends[2][2];
    taut_ruler ruler;

    for (int end = 0; end < 2; end++) {
        ends[end][held] = edge % 2 == 0 ? carrier->lo[held] : carrier->hi[held];
        ends[end][along] = end == 0 ? carrier->lo[along] : carrier->hi[along];
    }
    const taut_trace_by measure =
        by == TAUT_PATTERN_BY_PARAMETER ? TAUT_TRACE_PARAMETER : TAUT_TRACE_LENGTH;
    if (taut_ruler_new(arena, carrier, TAUT_TRACE_GEODESIC, measure, ends[0], ends[1], &ruler) !=
        TAUT_OK) {
        return taut_fail_memory(error);
    }
    memcpy(at[0], ends[0], sizeof ends[0]);
    memcpy(at[count], ends[1], sizeof ends[1]);
    for (int k = 1; k < count; k++) {
        taut_ruler_at(&ruler, ruler.sum[ruler.count] * k / count, at[k]);
    }
    return TAUT_OK;
}

/* Do two straight lines of the window meet? */
static int meet(const double a[2], const double b[2], const double c[2], const double d[2])
{
    const double p = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    const double q = (b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0]);
    const double r = (d[0] - c[0]) * (a[1] - c[1]) - (d[1] - c[1]) * (a[0] - c[0]);
    const double s = (d[0] - c[0]) * (b[1] - c[1]) - (d[1] - c[1]) * (b[0] - c[0]);
    return p * q < 0 && r * s < 0;
}

static taut_status fail_crossing(const taut_pattern_piece *piece, const double at[2],
                                 taut_error *error)
{
    return taut_fail(error, TAUT_NO_SOLUTION, "crossing", "/seams", taut_none, taut_none,
                     "%s and %s, the sides of piece %s, cross or turn over at (%.6g, %.6g)",
                     piece->edge[0]->name, piece->edge[1]->name, piece->name, at[0], at[1]);
}

/* The sides of a piece do not cross, and it turns over nowhere. */
static taut_status check_piece(const taut_pattern_piece *piece, taut_error *error)
{
    double chain[2][CHAIN + 1][2], w[5][2];
    const double *low = piece->carrier->lo, *high = piece->carrier->hi;
    const double window = (high[0] - low[0]) * (high[1] - low[1]);

    for (int side = 0; side < 2; side++) {
        for (int i = 0; i <= CHAIN; i++) {
            taut_pattern_piece_window(piece, (double)i / CHAIN, side, w);
            memcpy(chain[side][i], w[0], sizeof w[0]);
        }
    }
    for (int i = 0; i < CHAIN; i++) {
        for (int k = 0; k < CHAIN; k++) {
            if (meet(chain[0][i], chain[0][i + 1], chain[1][k], chain[1][k + 1])) {
                return fail_crossing(piece, chain[0][i], error);
            }
        }
    }
    for (int i = 0; i <= ALONG; i++) {
        for (int k = 0; k <= ACROSS; k++) {
            double g[3];
            const double s = (double)i / ALONG, t = (double)k / ACROSS;
            taut_pattern_piece_window(piece, s, t, w);
            if (!(w[1][0] * w[2][1] - w[1][1] * w[2][0] > least_area * least_area * window)) {
                return fail_crossing(piece, w[0], error);
            }
            taut_pattern_piece_metric(piece, s, t, g);
            if (!(g[0] * g[2] - g[1] * g[1] > least_area * least_area * g[0] * g[2])) {
                return taut_fail(error, TAUT_NO_SOLUTION, "singular", "/of", taut_none, taut_none,
                                 "the surface has no normal at (%.6g, %.6g), in piece %s", w[0][0],
                                 w[0][1], piece->name);
            }
        }
    }
    return TAUT_OK;
}

static taut_status add_sides(taut_pattern_layout *layout, const taut_pattern_rule *rule, int count,
                             const taut_monitor *monitor, taut_error *error)
{
    const int first = (int)rule->edges[0], second = (int)rule->edges[1], held = first / 2;
    const size_t places = (size_t)count + 1;
    double(*from)[2] = taut_arena_take(layout->arena, places, sizeof *from);
    double(*to)[2] = taut_arena_take(layout->arena, places, sizeof *to);

    if (from == NULL || to == NULL) {
        return taut_fail_memory(error);
    }
    taut_status status =
        divide(layout->carrier, first, rule->by, count, layout->arena, from, error);
    if (status == TAUT_OK) {
        status = divide(layout->carrier, second, rule->by, count, layout->arena, to, error);
    }
    for (int k = 0; status == TAUT_OK && k <= count; k++) {
        taut_pattern_side *side = &layout->sides[layout->side_count++];
        side->owners[0] = side->owners[1] = -1;
        if (k == 0 || k == count) {
            const int edge = 2 * (1 - held) + (k == count);
            status = taut_pattern_border(layout->carrier, edge, first % 2, monitor, layout->arena,
                                         side, error);
        } else {
            snprintf(side->name, sizeof side->name, "S%d", k);
            status = taut_pattern_geodesic(layout->carrier, from[k], to[k], monitor, layout->arena,
                                           side, error);
        }
    }
    return status;
}

taut_status taut_pattern_lay_out(const taut_carrier *carrier, const taut_pattern_rule *rule,
                                 int count, const taut_monitor *monitor, taut_arena *arena,
                                 taut_pattern_layout *layout, taut_error *error)
{
    const int first = (int)rule->edges[0];
    const int lies_left = first == TAUT_EDGE_V0 || first == TAUT_EDGE_U1; /* the lower side */

    *layout = (taut_pattern_layout){.carrier = carrier, .arena = arena};
    layout->sides = taut_arena_take(arena, (size_t)count + 1, sizeof *layout->sides);
    layout->pieces = taut_arena_take(arena, (size_t)count, sizeof *layout->pieces);
    if (layout->sides == NULL || layout->pieces == NULL) {
        return taut_fail_memory(error);
    }
    taut_status status = add_sides(layout, rule, count, monitor, error);
    for (int k = 0; status == TAUT_OK && k < count; k++) {
        taut_pattern_piece *piece = &layout->pieces[layout->piece_count++];
        snprintf(piece->name, sizeof piece->name, "P%d", k + 1);
        piece->carrier = carrier;
        for (int side = 0; side < 2; side++) {
            piece->sides[side] = (side == TAUT_PIECE_LEFT) == lies_left ? k : k + 1;
            piece->edge[side] = &layout->sides[piece->sides[side]];
            layout->sides[piece->sides[side]].owners[side] = k;
        }
        status = check_piece(piece, error);
    }
    return status;
}
