/* layout.c -- the window cut in pieces, rule by rule.
 *
 *     the window as one piece, from the first edge that seams run from to the opposite one
 *     each seam cuts the piece whose edges it begins and ends on: along it in two strips, or across it in two parts
 *     names: strips from the low end of the first edge on, seams as they are met
 *
 * A piece's t runs to the left of its s, seen from the side of the normal: towards falling u where s runs with v.
 */
#include "construct/pattern/layout.h"

#include "construct/pattern/pole.h"
#include "construct/pattern/rule.h"
#include "construct/pattern/trail.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ALONG = 32, ACROSS = 4, CHAIN = 64, ROUNDS = 200 };
/* The least area element that is one, over the largest. */
static const double least_area = 1e-9;
static const double same_line = 1e-9; /* of the window */
/* Of speeds, and of how they change over the window; rounding is below. */
static const double same_rate = 1e-6;

/* ---- pieces that are none ---- */

/* Where two straight lines of the window cross; 0: they do not. */
static int meet(const double a[2], const double b[2], const double c[2], const double d[2],
                double at[2])
{
    const double p = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    const double q = (b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0]);
    const double r = (d[0] - c[0]) * (a[1] - c[1]) - (d[1] - c[1]) * (a[0] - c[0]);
    const double s = (d[0] - c[0]) * (b[1] - c[1]) - (d[1] - c[1]) * (b[0] - c[0]);
    if (!(p * q < 0) || !(r * s < 0)) {
        return 0;
    }
    for (int k = 0; k < 2; k++) {
        at[k] = c[k] + (d[k] - c[k]) * p / (p - q);
    }
    return 1;
}

static void chain_of(const taut_pattern_side *side, double chain[CHAIN + 1][2])
{
    for (int i = 0; i <= CHAIN; i++) {
        double w[3][2];
        taut_pattern_side_at(side, (double)i / CHAIN, w);
        memcpy(chain[i], w[0], sizeof w[0]);
    }
}

/* Where two lines cross inside, as polygons. */
static int cross(const double a[CHAIN + 1][2], const double b[CHAIN + 1][2], double at[2])
{
    for (int i = 0; i < CHAIN; i++) {
        for (int k = 0; k < CHAIN; k++) {
            if (meet(a[i], a[i + 1], b[k], b[k + 1], at)) {
                return 1;
            }
        }
    }
    return 0;
}

static taut_status fail_crossing(const taut_pattern_piece *piece, const double at[2],
                                 taut_error *error)
{
    return taut_fail(error, TAUT_NO_SOLUTION, "crossing", "/seams", taut_none, taut_none,
                     "%s and %s, the sides of piece %s, cross or turn over at (%.6g, %.6g)",
                     piece->bounds[TAUT_FLAT_RIGHT].line->name,
                     piece->bounds[TAUT_FLAT_LEFT].line->name, piece->name, at[0], at[1]);
}

/* No piece runs over a crease: its sides may lie on one. Two steps at a time, since a place may lie on one too. */
static taut_status check_creases(const taut_pattern_piece *piece, taut_error *error)
{
    double grid[ALONG + 1][ACROSS + 1][2], at[2], w[6][2];
    int jumps = 0;

    for (int i = 0; i <= ALONG; i++) {
        for (int k = 0; k <= ACROSS; k++) {
            taut_pattern_piece_window(piece, (double)i / ALONG, (double)k / ACROSS, w);
            memcpy(grid[i][k], w[0], sizeof w[0]);
            jumps =
                jumps ||
                (i > 1 && taut_pattern_crease_between(piece->carrier, grid[i - 2][k], w[0], at)) ||
                (k > 1 && taut_pattern_crease_between(piece->carrier, grid[i][k - 2], w[0], at));
        }
    }
    return !jumps ? TAUT_OK
                  : taut_fail(error, TAUT_NO_SOLUTION, "crease", "/of", taut_none, taut_none,
                              "the surface has a kink at (%.6g, %.6g), within piece %s: run a "
                              "seam along it, or cut it there into surfaces of their own",
                              at[0], at[1], piece->name);
}

/* The sides of a piece do not cross, and it turns over nowhere. */
static taut_status check_piece(const taut_pattern_piece *piece, taut_error *error)
{
    double chain[2][CHAIN + 1][2], at[2], w[6][2];
    const double *low = piece->carrier->lo, *high = piece->carrier->hi;
    const double window = (high[0] - low[0]) * (high[1] - low[1]);

    for (int side = 0; side < 2; side++) {
        for (int i = 0; i <= CHAIN; i++) {
            taut_pattern_piece_window(piece, (double)i / CHAIN, side, w);
            memcpy(chain[side][i], w[0], sizeof w[0]);
        }
    }
    if (cross((const double(*)[2])chain[0], (const double(*)[2])chain[1], at)) {
        return fail_crossing(piece, at, error);
    }
    const int first = piece->bounds[TAUT_FLAT_START].is_point;
    const int last = ALONG - piece->bounds[TAUT_FLAT_END].is_point;
    double longest[2] = {0, 0}; /* squares of the derivatives along and across */
    for (int i = first; i <= last; i++) {
        for (int k = 0; k <= ACROSS; k++) {
            double g[3];
            taut_pattern_piece_metric(piece, (double)i / ALONG, (double)k / ACROSS, g);
            longest[0] = fmax(longest[0], g[0]);
            longest[1] = fmax(longest[1], g[2]);
        }
    }
    for (int i = first; i <= last; i++) {
        for (int k = 0; k <= ACROSS; k++) {
            double g[3];
            const double s = (double)i / ALONG, t = (double)k / ACROSS;
            taut_pattern_piece_window(piece, s, t, w);
            if (!(w[1][0] * w[2][1] - w[1][1] * w[2][0] > least_area * least_area * window)) {
                return fail_crossing(piece, w[0], error);
            }
            taut_pattern_piece_metric(piece, s, t, g);
            if (!(g[0] * g[2] - g[1] * g[1] > least_area * least_area * g[0] * g[2]) ||
                !(g[0] > least_area * least_area * longest[0]) ||
                !(g[2] > least_area * least_area * longest[1])) {
                return taut_fail(error, TAUT_NO_SOLUTION, "singular", "/of", taut_none, taut_none,
                                 "the surface has no normal at (%.6g, %.6g), in piece %s", w[0][0],
                                 w[0][1], piece->name);
            }
        }
    }
    return TAUT_OK;
}

/* It has three sides or four. */
static taut_status check_sides(const taut_pattern_piece *piece, taut_error *error)
{
    const taut_pattern_bound *start = &piece->bounds[TAUT_FLAT_START],
                             *end = &piece->bounds[TAUT_FLAT_END];
    if (start->is_point && end->is_point) {
        return taut_fail(error, TAUT_NO_SOLUTION, "shape", "/seams", taut_none, taut_none,
                         "piece %s has two sides, which meet at (%.6g, %.6g) and (%.6g, %.6g)",
                         piece->name, start->ends[0][0], start->ends[0][1], end->ends[0][0],
                         end->ends[0][1]);
    }
    return TAUT_OK;
}

/* ---- cutting ---- */

typedef struct laying {
    const taut_pattern_ground *ground; /* the surface that is being cut */
    int index, first_piece;            /* its number, and that of its first piece */
    const taut_pattern_problem *problem;
    const taut_pattern_counts *counts;
    taut_pattern_layout *layout;
    int side_room, strips;
    int *starts; /* of each surface, the border that its strips run from */
    taut_pattern_seams seams;
    taut_error *error;
} laying;

/* Room for one more side; its index, or -1. */
static int add_side(laying *l, const taut_pattern_side *side)
{
    taut_pattern_layout *layout = l->layout;
    if (layout->side_count == l->side_room) {
        l->side_room = 2 * l->side_room + 8;
        taut_pattern_side *grown =
            taut_arena_take(layout->arena, (size_t)l->side_room, sizeof *grown);
        if (grown == NULL) {
            return -1;
        }
        if (layout->side_count > 0) {
            memcpy(grown, layout->sides, (size_t)layout->side_count * sizeof *grown);
        }
        layout->sides = grown;
    }
    layout->sides[layout->side_count] = *side;
    layout->sides[layout->side_count].ground = l->index;
    return layout->side_count++;
}

static taut_status add_border(laying *l, int edge, int backwards, int is_fine, int *index)
{
    const taut_pattern_ground *g = l->ground;
    taut_pattern_side side = {.border = edge, .twin = -1, .is_fine = is_fine};
    const int held = edge / 2, begins = 2 * (1 - held);
    const double value = edge % 2 == 0 ? g->carrier->lo[held] : g->carrier->hi[held];
    if (g->is_pole[edge]) {
        return taut_fail(l->error, TAUT_NO_SOLUTION, "shape", "/seams", taut_none, taut_none,
                         "%s is one place: run strips from it to the opposite edge",
                         taut_edge_name((taut_edge)edge));
    }
    const taut_status status =
        g->is_pole[begins] || g->is_pole[begins + 1]
            ? taut_pattern_trail_line(g, held, value, NULL, backwards, &side, l->error)
            : taut_pattern_border(g->carrier, edge, backwards, g->monitor, g->arena, &side,
                                  l->error);
    snprintf(side.name, sizeof side.name, "%s", taut_edge_name((taut_edge)edge));
    if (status != TAUT_OK) {
        return status;
    }
    side.is_seam = g->is_ring[edge / 2] || g->mates[edge].is_there;
    *index = add_side(l, &side);
    return *index >= 0 ? TAUT_OK : taut_fail_memory(l->error);
}

static taut_status fail_pieces(const laying *l)
{
    return taut_fail(l->error, TAUT_BAD_INPUT, "count", "/seams", taut_none,
                     TAUT_PATTERN_PIECES_MAX, "found more than %d pieces", TAUT_PATTERN_PIECES_MAX);
}

static taut_pattern_bound whole(const taut_pattern_layout *layout, int side)
{
    taut_pattern_bound bound = {
        .side = side, .border = layout->sides[side].border, .from = 0, .to = 1};
    memcpy(bound.ends, layout->sides[side].ends, sizeof bound.ends);
    return bound;
}

/* The derivatives along a border at a place, in one of the spans beside it. */
static void along_border(const taut_carrier *carrier, int border, double at, int span,
                         double x[TAUT_CARRIER_VECTORS][3])
{
    const int held = border / 2, along = 1 - held;
    double place[2];
    int spans[2];
    place[held] = border % 2 == 0 ? carrier->lo[held] : carrier->hi[held];
    place[along] = at;
    taut_carrier_cell(carrier, place, NULL, spans);
    spans[along] = span;
    taut_carrier_at(carrier, spans, place, 2, x);
}

/* Does the speed along a border, or how it changes, jump at a knot, as that of arcs of circles does where they meet? Not where its
 * direction does: no line runs on there. */
static int has_uneven_speed(const taut_carrier *carrier, int border)
{
    const int along = 1 - border / 2;
    const double *breaks = taut_basis_breaks(carrier->basis[along]);
    const double range = carrier->hi[along] - carrier->lo[along];
    int is_uneven = 0;
    for (int k = 1; k < taut_basis_span_count(carrier->basis[along]); k++) {
        double x[2][TAUT_CARRIER_VECTORS][3], speeds[2], rates[2];
        for (int side = 0; side < 2; side++) {
            along_border(carrier, border, breaks[k], k - 1 + side, x[side]);
            const double *first = x[side][1 + along];
            speeds[side] = taut_norm(first);
            rates[side] = taut_dot(first, x[side][along == 0 ? 3 : 5]) / taut_dot(first, first);
        }
        if (taut_dot(x[0][1 + along], x[1][1 + along]) < (1 - same_line) * speeds[0] * speeds[1]) {
            return 0;
        }
        is_uneven |= fabs(speeds[1] - speeds[0]) > same_rate * speeds[0] ||
                     range * fabs(rates[1] - rates[0]) > same_rate;
    }
    return is_uneven;
}

/* Do lines between two opposite borders share out one as the other, at any speed? So it is of cylinders, cones, and all that is turned
 * or drawn out along a line. */
static int has_one_pace(const taut_carrier *carrier, int border)
{
    const int along = 1 - border / 2, first = border - border % 2;
    const double *breaks = taut_basis_breaks(carrier->basis[along]);
    double ratio = 0;
    for (int k = 0; k < taut_basis_span_count(carrier->basis[along]); k++) {
        for (int i = 0; i <= ACROSS; i++) {
            const double at = breaks[k] + (breaks[k + 1] - breaks[k]) * i / ACROSS;
            double x[2][TAUT_CARRIER_VECTORS][3];
            for (int end = 0; end < 2; end++) {
                along_border(carrier, first + end, at, k, x[end]);
            }
            const double own = taut_norm(x[1][1 + along]) / taut_norm(x[0][1 + along]);
            ratio = ratio > 0 ? ratio : own;
            if (!(fabs(own - ratio) <= same_rate * ratio)) {
                return 0;
            }
        }
    }
    return 1;
}

/* The window as one piece. */
static taut_status begin(laying *l)
{
    const int first = l->seams.ends[0], second = l->seams.ends[1], held = first / 2;
    const int lies_left = first == TAUT_EDGE_V0 || first == TAUT_EDGE_U1; /* the lower side */
    const int borders[2] = {2 * (1 - held) + lies_left, 2 * (1 - held) + !lies_left};
    taut_pattern_layout *layout = l->layout;
    taut_pattern_piece *piece = &layout->pieces[layout->piece_count];

    *piece = (taut_pattern_piece){
        .carrier = l->ground->carrier, .ground = l->index, .strip = l->strips++};
    for (int side = 0; side < 2; side++) {
        const int edge = side == 0 ? TAUT_FLAT_RIGHT : TAUT_FLAT_LEFT;
        int index = 0;
        const taut_status status = add_border(l, borders[side], first % 2, 0, &index);
        if (status != TAUT_OK) {
            return status;
        }
        piece->bounds[edge] = whole(layout, index);
    }
    for (int end = 0; end < 2; end++) {
        taut_pattern_bound *bound = &piece->bounds[end == 0 ? TAUT_FLAT_START : TAUT_FLAT_END];
        const int border = end == 0 ? first : second;
        *bound = (taut_pattern_bound){
            .side = -1, .border = border, .is_point = l->ground->is_pole[border]};
        memcpy(bound->ends[0], piece->bounds[TAUT_FLAT_RIGHT].ends[end], sizeof bound->ends[0]);
        memcpy(bound->ends[1], piece->bounds[TAUT_FLAT_LEFT].ends[end], sizeof bound->ends[1]);
        const int is_sewn = l->ground->is_ring[held] || l->ground->mates[border].is_there;
        if (!l->ground->is_pole[border] && /* as t runs */
            (is_sewn || (has_uneven_speed(l->ground->carrier, border) &&
                         has_one_pace(l->ground->carrier, border)))) {
            const int along = 1 - held;
            int index = 0;
            const taut_status status = add_border(
                l, border, bound->ends[0][along] > bound->ends[1][along], !is_sewn, &index);
            if (status != TAUT_OK) {
                return status;
            }
            *bound = whole(layout, index);
        }
    }
    for (int e = 0; e < 2; e++) { /* right and left, or end and start, are one line of a ring */
        const int one = piece->bounds[e].side, other = piece->bounds[e + 2].side;
        if (one >= 0 && other >= 0 && l->ground->is_ring[layout->sides[one].border / 2]) {
            layout->sides[one].twin = other;
            layout->sides[other].twin = one;
        }
    }
    if (layout->piece_count == TAUT_PATTERN_PIECES_MAX) {
        return fail_pieces(l);
    }
    layout->piece_count++;
    return TAUT_OK;
}

/* Is a place one of a circle around a pole? */
static int is_on_circle(const laying *l, const taut_pattern_bound *bound, const double at[2])
{
    const taut_pattern_side *side = bound->side >= 0 ? &l->layout->sides[bound->side] : NULL;
    const int held = l->seams.ends[0] / 2;
    double place[2];
    if (side == NULL || side->kind != TAUT_SIDE_CIRCLE) {
        return 0;
    }
    taut_pattern_circle_at(side, 1 - held, at[1 - held], place);
    return at[held] == place[held];
}

/* Of an edge that is not cut yet: a place inside it as a share of its side; -1: it is not there. */
static double share_of(const laying *l, const taut_pattern_bound *bound, const double at[2])
{
    const taut_pattern_layout *layout = l->layout;
    const taut_carrier *carrier = l->ground->carrier;
    if (bound->border < 0 ? !is_on_circle(l, bound, at)
                          : !taut_pattern_is_on(carrier, at, bound->border)) {
        return -1;
    }
    const int along = 1 - (bound->border < 0 ? l->seams.ends[0] : bound->border) / 2;
    double range[2] = {bound->from, bound->to};
    const double a = bound->ends[0][along], b = bound->ends[1][along];
    if ((at[along] - a) * (at[along] - b) > 0 || a == b) {
        return -1;
    }
    if (at[along] == a || at[along] == b) {
        return at[along] == a ? bound->from : bound->to;
    }
    if (bound->side < 0) {
        return 0.5; /* it has none */
    }
    for (int round = 0; round < ROUNDS && range[0] != range[1]; round++) { /* monotonous */
        const double middle = (range[0] + range[1]) / 2;
        double w[3][2];
        taut_pattern_side_at(&layout->sides[bound->side], middle, w);
        if (middle == range[0] || middle == range[1]) {
            break;
        }
        range[(w[0][along] - at[along]) * (b - a) > 0] = middle;
    }
    return (range[0] + range[1]) / 2;
}

/* The edge up to a place (which 0), or from it on (1). */
static void shorten(taut_pattern_bound *bound, int which, double share, const double at[2])
{
    memcpy(bound->ends[1 - which], at, sizeof bound->ends[0]);
    if (bound->side >= 0) {
        *(which == 0 ? &bound->to : &bound->from) = share;
    }
    bound->is_point |=
        bound->ends[0][0] == bound->ends[1][0] && bound->ends[0][1] == bound->ends[1][1];
}

/* A copy of a piece behind it, in the list; 0: there is no room. */
static taut_status split(laying *l, int index)
{
    taut_pattern_layout *layout = l->layout;
    if (layout->piece_count == TAUT_PATTERN_PIECES_MAX) {
        return fail_pieces(l);
    }
    memmove(&layout->pieces[index + 1], &layout->pieces[index],
            (size_t)(layout->piece_count - index) * sizeof *layout->pieces);
    layout->piece_count++;
    return TAUT_OK;
}

/* From start to end: two strips. shares: of the seam's ends on start and end. */
static taut_status cut_along(laying *l, int index, int side, const double shares[2])
{
    taut_pattern_layout *layout = l->layout;
    const taut_status status = split(l, index);
    if (status != TAUT_OK) {
        return status;
    }
    const int first = l->seams.ends[0];
    const int lies_left = first == TAUT_EDGE_V0 || first == TAUT_EDGE_U1;
    taut_pattern_piece *left = &layout->pieces[lies_left ? index : index + 1];
    taut_pattern_piece *right = &layout->pieces[lies_left ? index + 1 : index];
    const taut_pattern_bound seam = whole(layout, side);
    for (int end = 0; end < 2; end++) {
        const int edge = end == 0 ? TAUT_FLAT_START : TAUT_FLAT_END;
        shorten(&right->bounds[edge], 0, shares[end], seam.ends[end]);
        shorten(&left->bounds[edge], 1, shares[end], seam.ends[end]);
    }
    right->bounds[TAUT_FLAT_LEFT] = seam;
    left->bounds[TAUT_FLAT_RIGHT] = seam;
    layout->pieces[index + 1].strip = l->strips++;
    return TAUT_OK;
}

/* From right to left: a part to the start, and one to the end of the strip. */
static taut_status cut_across(laying *l, int index, int side, const double shares[2])
{
    taut_pattern_layout *layout = l->layout;
    const taut_status status = split(l, index);
    if (status != TAUT_OK) {
        return status;
    }
    taut_pattern_piece *near = &layout->pieces[index], *far = &layout->pieces[index + 1];
    const taut_pattern_bound seam = whole(layout, side);
    for (int end = 0; end < 2; end++) {
        const int edge = end == 0 ? TAUT_FLAT_RIGHT : TAUT_FLAT_LEFT;
        shorten(&near->bounds[edge], 0, shares[end], seam.ends[end]);
        shorten(&far->bounds[edge], 1, shares[end], seam.ends[end]);
    }
    near->bounds[TAUT_FLAT_END] = seam;
    far->bounds[TAUT_FLAT_START] = seam;
    return TAUT_OK;
}

/* The same around a pole: what it cuts off is a strip of its own. */
static taut_status cut_cap(laying *l, int index, int side, const double shares[2])
{
    const taut_status status = cut_across(l, index, side, shares);
    taut_pattern_piece *pieces = l->layout->pieces;
    if (status == TAUT_OK) {
        const int is_near = pieces[index].bounds[TAUT_FLAT_START].is_point;
        pieces[is_near ? index : index + 1].strip = l->strips++;
    }
    return status;
}

/* A seam that lies in no piece: it crosses another one, or leaves one that has no four sides. */
static taut_status fail_seam(const laying *l, const taut_pattern_side *seam, int rule)
{
    double chain[2][CHAIN + 1][2], at[2];
    char where[48];
    snprintf(where, sizeof where, "/seams/%d", rule);
    chain_of(seam, chain[0]);
    for (int k = 0; k < l->layout->side_count; k++) {
        chain_of(&l->layout->sides[k], chain[1]);
        if (l->layout->sides[k].border < 0 && l->layout->sides[k].ground == l->index &&
            cross((const double(*)[2])chain[0], (const double(*)[2])chain[1], at)) {
            return taut_fail(l->error, TAUT_NO_SOLUTION, "crossing", where, taut_none, taut_none,
                             "the seam from (%.6g, %.6g) to (%.6g, %.6g) crosses another one at "
                             "(%.6g, %.6g)",
                             seam->ends[0][0], seam->ends[0][1], seam->ends[1][0], seam->ends[1][1],
                             at[0], at[1]);
        }
    }
    return taut_fail(l->error, TAUT_NO_SOLUTION, "shape", where, taut_none, taut_none,
                     "the seam from (%.6g, %.6g) to (%.6g, %.6g) leaves a piece that has not four "
                     "sides",
                     seam->ends[0][0], seam->ends[0][1], seam->ends[1][0], seam->ends[1][1]);
}

/* Cuts the piece that a seam begins and ends on the borders of. */
static taut_status place_seam(laying *l, const taut_pattern_side *seam, int rule)
{
    static const int pairs[4][2] = {{TAUT_FLAT_START, TAUT_FLAT_END},
                                    {TAUT_FLAT_RIGHT, TAUT_FLAT_LEFT}};
    const taut_pattern_layout *layout = l->layout;
    for (int p = 0; p < 2; p++) {
        for (int k = l->first_piece; k < layout->piece_count; k++) {
            const taut_pattern_bound *bounds = layout->pieces[k].bounds;
            const double shares[2] = {share_of(l, &bounds[pairs[p][0]], seam->ends[0]),
                                      share_of(l, &bounds[pairs[p][1]], seam->ends[1])};
            if (shares[0] < 0 || shares[1] < 0) {
                continue;
            }
            const int side = add_side(l, seam);
            if (side < 0) {
                return taut_fail_memory(l->error);
            }
            if (seam->kind == TAUT_SIDE_CIRCLE) {
                return cut_cap(l, k, side, shares);
            }
            return p == 0 ? cut_along(l, k, side, shares) : cut_across(l, k, side, shares);
        }
    }
    return fail_seam(l, seam, rule);
}

/* ---- butts ---- */

/* The piece of a strip that a share of both its long edges lies in: as shares of their sides. */
static int find_part(const laying *l, int strip, double x, double shares[2])
{
    for (int k = 0; k < l->layout->piece_count; k++) {
        const taut_pattern_piece *piece = &l->layout->pieces[k];
        const taut_pattern_bound *right = &piece->bounds[TAUT_FLAT_RIGHT];
        const taut_pattern_bound *left = &piece->bounds[TAUT_FLAT_LEFT];
        if (piece->strip == strip && right->from < x && x < right->to && left->from < x &&
            x < left->to) {
            shares[0] = shares[1] = x;
            return k;
        }
    }
    return -1;
}

static taut_status cut_strip(laying *l, int strip, double x, int rule)
{
    const taut_pattern_ground *g = l->ground;
    taut_pattern_side seam = {.border = -1, .is_seam = 1, .twin = -1};
    double shares[2] = {0, 0}, w[3][2], ends[2][2];
    char where[48];
    const int k = find_part(l, strip, x, shares);

    snprintf(where, sizeof where, "/seams/%d", rule);
    if (k < 0) {
        return taut_fail(l->error, TAUT_BAD_INPUT, "outside", where, x, 1,
                         "found a butt at %.6g, expected one inside a piece, at a share of its "
                         "length that nothing else is at",
                         x);
    }
    for (int end = 0; end < 2; end++) {
        const taut_pattern_bound *bound =
            &l->layout->pieces[k].bounds[end == 0 ? TAUT_FLAT_RIGHT : TAUT_FLAT_LEFT];
        taut_pattern_side_at(&l->layout->sides[bound->side], shares[end], w);
        memcpy(ends[end], w[0], sizeof ends[end]);
        if (bound->border >= 0) { /* on it exactly */
            ends[end][bound->border / 2] = bound->ends[0][bound->border / 2];
        }
    }
    const taut_status status =
        taut_pattern_geodesic(g->carrier, ends[0], ends[1], g->monitor, g->arena, &seam, l->error);
    if (status != TAUT_OK) {
        return status;
    }
    const int side = add_side(l, &seam);
    return side >= 0 ? cut_across(l, k, side, shares) : taut_fail_memory(l->error);
}

/* Strips are numbered as they were cut: their order is that of the list, those of the surfaces before this one before. */
static int order_strips(const laying *l, int order[TAUT_PATTERN_PIECES_MAX])
{
    int count = 0;
    for (int k = 0; k < l->layout->piece_count; k++) {
        const int strip = l->layout->pieces[k].strip;
        if (count == 0 || order[count - 1] != strip) {
            order[count++] = strip;
        }
    }
    return count;
}

/* Each strip of this surface in as many equal parts as it is to have; of every second one the first and the last are halves, so that butts
 * of neighbours do not meet. */
static taut_status lay_equal_butts(laying *l, int index)
{
    const taut_pattern_piece *pieces = l->layout->pieces;
    int order[TAUT_PATTERN_PIECES_MAX];
    const int count = order_strips(l, order);
    taut_status status = TAUT_OK;

    for (int k = l->first_piece + 1; k < l->layout->piece_count; k++) {
        if (pieces[k].strip == pieces[k - 1].strip) {
            char where[48];
            snprintf(where, sizeof where, "/seams/%d/butt", index);
            return taut_fail(l->error, TAUT_BAD_INPUT, "rule", where, taut_none, taut_none,
                             "found \"auto\" where a strip is cut across already, expected strips "
                             "that are whole");
        }
    }
    for (int k = 0; k < count; k++) {
        const int parts = l->counts->parts[order[k]], is_staggered = k % 2;
        const int is_here = order[k] >= pieces[l->first_piece].strip;
        for (int i = 1; is_here && parts > 1 && status == TAUT_OK && i < parts + is_staggered;
             i++) {
            status = cut_strip(l, order[k], (i - is_staggered * 0.5) / parts, index);
        }
    }
    return status;
}

static taut_status lay_butts(laying *l, const taut_pattern_rule *rule, int index)
{
    int order[TAUT_PATTERN_PIECES_MAX];
    const int count = order_strips(l, order);
    char where[48];
    snprintf(where, sizeof where, "/seams/%d/butt", index);
    if (rule->strip >= count && l->index + 1 == l->layout->ground_count) {
        return taut_fail(l->error, TAUT_BAD_INPUT, "rule", where, rule->strip + 1, count,
                         "found a butt in P%d, expected one of the %d strips that rules before it "
                         "make",
                         rule->strip + 1, count);
    }
    taut_status status = TAUT_OK;
    const int is_here =
        rule->strip < count && order[rule->strip] >= l->layout->pieces[l->first_piece].strip;
    for (int k = 0; is_here && status == TAUT_OK && k < rule->value_count; k++) {
        status = cut_strip(l, order[rule->strip], rule->values[k], index);
    }
    return status;
}

/* ---- names ---- */

static taut_status take_names(laying *l)
{
    taut_pattern_layout *layout = l->layout;
    const size_t count = (size_t)layout->side_count;
    taut_pattern_side *sides = taut_arena_take(layout->arena, count, sizeof *sides);
    int *moved = taut_arena_take(layout->arena, count, sizeof *moved);
    int n = 0, seams = 0, strip = 0, part = 0;

    if (sides == NULL || moved == NULL) {
        return taut_fail_memory(l->error);
    }
    for (int k = 0; k < layout->piece_count; k++) {
        taut_pattern_piece *piece = &layout->pieces[k];
        const int first = l->starts[piece->ground];
        const int lies_left = first == TAUT_EDGE_V0 || first == TAUT_EDGE_U1;
        const int order[4] = {lies_left ? TAUT_FLAT_LEFT : TAUT_FLAT_RIGHT, TAUT_FLAT_START,
                              TAUT_FLAT_END, lies_left ? TAUT_FLAT_RIGHT : TAUT_FLAT_LEFT};
        const int is_next = k == 0 || piece->strip != layout->pieces[k - 1].strip;
        const int is_cut =
            k + 1 < layout->piece_count && layout->pieces[k + 1].strip == piece->strip;
        strip += is_next;
        part = is_next ? 1 : part + 1;
        if (is_next && !is_cut) {
            snprintf(piece->name, sizeof piece->name, "P%d", strip);
        } else {
            snprintf(piece->name, sizeof piece->name, "P%d-%d", strip, part);
        }
        for (int e = 0; e < 4; e++) {
            const int side = piece->bounds[order[e]].side;
            if (side < 0 || moved[side] > 0) {
                continue;
            }
            const int twin = layout->sides[side].twin;
            sides[n] = layout->sides[side];
            moved[side] = ++n;
            if (!sides[n - 1].is_seam || (twin >= 0 && moved[twin] == 0)) {
                continue; /* a ring closes, surfaces meet, where both borders are met */
            }
            snprintf(sides[n - 1].seam, sizeof sides[n - 1].seam, "S%d", ++seams);
            if (twin >= 0) {
                memcpy(sides[moved[twin] - 1].seam, sides[n - 1].seam, sizeof sides[n - 1].seam);
            } else {
                memcpy(sides[n - 1].name, sides[n - 1].seam, sizeof sides[n - 1].name);
            }
        }
    }
    for (int k = 0; k < n; k++) {
        sides[k].twin = sides[k].twin >= 0 ? moved[sides[k].twin] - 1 : -1;
    }
    layout->sides = sides;
    layout->side_count = n;
    for (int k = 0; k < layout->piece_count; k++) {
        for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
            taut_pattern_bound *bound = &layout->pieces[k].bounds[e];
            bound->side = bound->side >= 0 ? moved[bound->side] - 1 : -1;
            bound->line = bound->side >= 0 ? &sides[bound->side] : NULL;
        }
    }
    return TAUT_OK;
}

/* ---- who lies along which side ---- */

static int by_place(const void *a, const void *b)
{
    const taut_pattern_holder *p = a, *q = b;
    const double first = fmin(p->from, p->to), second = fmin(q->from, q->to);
    if (p->hand != q->hand) {
        return p->hand - q->hand;
    }
    return (first > second) - (first < second);
}

/* Where two surfaces meet along a side: whether it is the first of both. */
static int is_first(const taut_pattern_layout *layout, int side)
{
    return layout->sides[side].twin > side;
}

static int meets_another(const taut_pattern_layout *layout, int side)
{
    const int twin = layout->sides[side].twin;
    return twin >= 0 && layout->sides[twin].ground != layout->sides[side].ground;
}

/* An edge along a side or its twin, as the side runs. */
static taut_pattern_holder holder_of(const taut_pattern_layout *layout, int side, int piece, int e)
{
    const taut_pattern_bound *bound = &layout->pieces[piece].bounds[e];
    const int is_turned = bound->side != side && layout->sides[side].is_turned;
    const int hand = meets_another(layout, side) ? !is_first(layout, bound->side)
                                                 : e == TAUT_FLAT_LEFT || e == TAUT_FLAT_START;
    return (taut_pattern_holder){piece, e, hand, is_turned ? 1 - bound->from : bound->from,
                                 is_turned ? 1 - bound->to : bound->to};
}

static taut_status find_holders(laying *l)
{
    taut_pattern_layout *layout = l->layout;
    for (int k = 0; k < layout->side_count; k++) {
        taut_pattern_side *side = &layout->sides[k];
        int count = 0, hands[2] = {0, 0};
        for (int pass = 0; pass < 2; pass++) {
            count = 0;
            for (int i = 0; i < layout->piece_count; i++) {
                for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
                    const taut_pattern_bound *bound = &layout->pieces[i].bounds[e];
                    if (bound->side < 0 || (bound->side != k && side->twin != bound->side)) {
                        continue;
                    }
                    if (pass == 1) {
                        side->holders[count] = holder_of(layout, k, i, e);
                        hands[side->holders[count].hand]++;
                    }
                    count++;
                }
            }
            if (pass == 0) {
                side->holders =
                    taut_arena_take(layout->arena, (size_t)count + 1, sizeof *side->holders);
            }
            if (side->holders == NULL) {
                return taut_fail_memory(l->error);
            }
        }
        side->holder_count = count;
        side->is_jointed = hands[0] > 1 || hands[1] > 1;
        qsort(side->holders, (size_t)count, sizeof *side->holders, by_place);
    }
    return TAUT_OK;
}

/* ---- several surfaces ---- */

/* The side along a border of a surface; -1. */
static int border_side(const taut_pattern_layout *layout, int ground, int border)
{
    for (int k = 0; k < layout->side_count; k++) {
        if (layout->sides[k].ground == ground && layout->sides[k].border == border) {
            return k;
        }
    }
    return -1;
}

static int runs_back(const taut_pattern_side *side)
{
    const int along = 1 - side->border / 2;
    return side->ends[0][along] > side->ends[1][along];
}

/* Borders that surfaces share are one seam. */
static void sew_surfaces(const taut_pattern_layout *layout)
{
    for (int k = 0; k < layout->side_count; k++) {
        taut_pattern_side *side = &layout->sides[k];
        const taut_pattern_mate *mate =
            side->border >= 0 ? &layout->grounds[side->ground].mates[side->border] : NULL;
        const int twin =
            mate != NULL && mate->is_there ? border_side(layout, mate->ground, mate->edge) : -1;
        if (twin >= 0) {
            side->twin = twin;
            side->is_turned = mate->is_reversed ^ runs_back(side) ^ runs_back(&layout->sides[twin]);
        }
    }
}

/* ---- the whole ---- */

static int is_for(const taut_pattern_rule *rule, const taut_pattern_ground *ground)
{
    return rule->surface == NULL || ground->name == NULL ||
           strcmp(rule->surface, ground->name) == 0;
}

/* One surface, by the rules for it; whole where there are none. */
static taut_status cut_surface(laying *l)
{
    taut_pattern_layout *layout = l->layout;
    taut_status status = TAUT_OK;
    l->seams = (taut_pattern_seams){.ends = {-1, -1}};
    l->first_piece = layout->piece_count;
    for (int r = 0; status == TAUT_OK && r < l->problem->rule_count; r++) {
        const taut_pattern_rule *rule = &l->problem->rules[r];
        const int is_butt = rule->kind == TAUT_PATTERN_BUTT;
        if (!is_for(rule, l->ground)) {
            continue;
        }
        if (!is_butt) {
            status =
                taut_pattern_rule_seams(l->ground, rule, r, l->counts->strips, &l->seams, l->error);
        }
        if (status == TAUT_OK && layout->piece_count == l->first_piece) {
            status = begin(l);
        }
        for (int k = 0; !is_butt && status == TAUT_OK && k < l->seams.count; k++) {
            status = place_seam(l, &l->seams.list[k], r);
        }
        if (is_butt && status == TAUT_OK) {
            status = rule->strip < 0 ? lay_equal_butts(l, r) : lay_butts(l, rule, r);
        }
    }
    if (status == TAUT_OK && layout->piece_count == l->first_piece) {
        l->seams.ends[0] = TAUT_EDGE_V0;
        l->seams.ends[1] = TAUT_EDGE_V1;
        status = begin(l);
    }
    l->starts[l->index] = l->seams.ends[0];
    return status;
}

taut_status taut_pattern_lay_out(const taut_pattern_ground *grounds, int ground_count,
                                 const taut_pattern_problem *problem,
                                 const taut_pattern_counts *counts, taut_pattern_layout *layout,
                                 taut_error *error)
{
    taut_arena *arena = grounds->arena;
    laying l = {.problem = problem, .counts = counts, .layout = layout, .error = error};
    taut_status status = TAUT_OK;

    *layout = (taut_pattern_layout){.carrier = grounds->carrier,
                                    .grounds = grounds,
                                    .ground_count = ground_count,
                                    .arena = arena};
    layout->pieces = taut_arena_take(arena, TAUT_PATTERN_PIECES_MAX + 1, sizeof *layout->pieces);
    l.starts = taut_arena_take(arena, (size_t)ground_count, sizeof *l.starts);
    if (layout->pieces == NULL || l.starts == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; status == TAUT_OK && k < ground_count; k++) {
        l.ground = &grounds[k];
        l.index = k;
        status = cut_surface(&l);
    }
    if (status == TAUT_OK) {
        sew_surfaces(layout);
        status = take_names(&l);
    }
    if (status == TAUT_OK) {
        status = find_holders(&l);
    }
    for (int k = 0; status == TAUT_OK && k < layout->piece_count; k++) {
        status = check_sides(&layout->pieces[k], error);
    }
    for (int k = 0; status == TAUT_OK && k < layout->piece_count; k++) {
        status = check_piece(&layout->pieces[k], error);
        status = status == TAUT_OK ? check_creases(&layout->pieces[k], error) : status;
    }
    return status;
}
