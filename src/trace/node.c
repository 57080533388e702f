#include "trace/node.h"

#include "core/vec3.h"
#include "trace/straight.h"

#include <string.h>

enum { DEPTH = 9, ROUNDS = 12 };
/* Boxes are wider than the quintics by this, over the window; a node may lie that far, over the
 * size, beyond an end; nodes nearer than that are one. */
static const double margin = 1e-7, beyond = 1e-9, same = 1e-9;
/* Below this sine two laths of a pair do not cross but touch. */
static const double least_sine = 1e-7;
/* Over the size: how well the quintics know a crossing, and how small a step of Newton is taken along
 * the curves' tangents and bends instead of by one more full step. */
static const double roughly = 1e-6, small_step = 1e-8;

typedef struct box {
    double low[2], high[2];
} box;

static box box_of(const taut_carrier *carrier, const double points[TAUT_QUINTIC][2])
{
    box b;
    for (int d = 0; d < 2; d++) {
        const double room = margin * (carrier->hi[d] - carrier->lo[d]);
        double low = points[0][d], high = low;
        for (int k = 1; k < TAUT_QUINTIC; k++) {
            low = points[k][d] < low ? points[k][d] : low;
            high = points[k][d] > high ? points[k][d] : high;
        }
        b.low[d] = low - room;
        b.high[d] = high + room;
    }
    return b;
}

static int overlap(const box *a, const box *b)
{
    return a->low[0] <= b->high[0] && b->low[0] <= a->high[0] && a->low[1] <= b->high[1] &&
           b->low[1] <= a->high[1];
}

/* A lath in the window: the quintics of its segments, boxes around them, and one around all. */
typedef struct outline {
    double (*quintics)[TAUT_QUINTIC][2];
    box *boxes;
    box whole;
} outline;

/* What is searched: two segments, and what was found. */
typedef struct search {
    const taut_carrier *carrier; /* of both segments */
    taut_trace_net net;
    const taut_lath *laths;
    const outline *outlines;
    int index[2];
    const taut_segment *segments[2];
    const double *quintics[2];
    taut_nodes *nodes;
    taut_status status;
} search;

static taut_status push(taut_nodes *nodes, const taut_node *node)
{
    if (nodes->count == nodes->room) {
        const int room = nodes->room > 0 ? 2 * nodes->room : 64;
        taut_node *list = taut_arena_take_raw(nodes->arena, (size_t)room, sizeof *list);
        if (list == NULL) {
            return TAUT_NO_MEMORY;
        }
        if (nodes->count > 0) {
            memcpy(list, nodes->list, (size_t)nodes->count * sizeof *list);
        }
        nodes->list = list;
        nodes->room = room;
    }
    nodes->list[nodes->count++] = *node;
    return TAUT_OK;
}

static int is_border(const taut_carrier *carrier, const double at[2])
{
    for (int d = 0; d < 2; d++) {
        const double room = beyond * (carrier->hi[d] - carrier->lo[d]);
        const int low = at[d] <= carrier->lo[d] + room, high = at[d] >= carrier->hi[d] - room;
        if (!carrier->wraps[d] && ((low && carrier->seams[2 * d] == NULL) ||
                                   (high && carrier->seams[2 * d + 1] == NULL))) {
            return 1;
        }
    }
    return 0;
}

static void describe(const search *w, const taut_station at[2], taut_node *node)
{
    double on[TAUT_CARRIER_VECTORS][3], across[3];
    taut_form_pair forms;

    *node = (taut_node){.laths = {w->index[0], w->index[1]},
                        .occurrence = 1,
                        .on = w->carrier,
                        .s = {fmax(at[0].s, 0), fmax(at[1].s, 0)}, /* Newton's may be -1e-16 */
                        .at = {at[0].at[0], at[0].at[1]}};
    for (int d = 0; d < 2; d++) {
        node->at[d] = fmin(fmax(node->at[d], w->carrier->lo[d]), w->carrier->hi[d]);
    }
    taut_carrier_forms_at(w->carrier, node->at, on, &forms);
    memcpy(node->x, on[0], sizeof node->x);
    memcpy(node->normal, forms.normal, sizeof node->normal);
    taut_cross(at[0].tangent, at[1].tangent, across);
    node->angle = taut_atan2(taut_length(across), fabs(taut_dot(at[0].tangent, at[1].tangent)));
    const double gauss = taut_form_pair_gauss(&forms);
    node->tau = gauss < 0 ? sqrt(-gauss) : 0;
    node->mean = taut_form_pair_mean(&forms);
    node->is_on_border = is_border(w->carrier, node->at);
}

/* Are two lengths on a lath one place of it? On one that is closed its beginning is its end. */
static int is_one_length(const search *w, int index, double a, double b)
{
    const taut_lath *lath = &w->laths[index];
    const double room = 1e3 * same * w->carrier->size, apart = fabs(a - b);
    return apart <= room ||
           (lath->ended[1] == TAUT_END_CLOSED && fabs(apart - lath->length) <= room);
}

/* Is there one like it already, of these two laths? A curve that winds about another comes to the same place at other
 * lengths. */
static int is_known(const search *w, const taut_node *node)
{
    for (int k = w->nodes->count - 1; k >= 0; k--) {
        const taut_node *other = &w->nodes->list[k];
        if (other->laths[0] != node->laths[0] || other->laths[1] != node->laths[1]) {
            return 0;
        }
        if (taut_length_between(other->x, node->x) <= same * w->carrier->size &&
            is_one_length(w, node->laths[0], other->s[0], node->s[0]) &&
            is_one_length(w, node->laths[1], other->s[1], node->s[1])) {
            return 1;
        }
    }
    return 0;
}

/* A step of Newton towards where two lines of the window meet that have places and directions: how far along
 * each. 0 where they only touch. */
static int newton_step(const double at[2][2], const double way[2][2], double step[2])
{
    const double *p = way[0], *q = way[1];
    const double away[2] = {at[1][0] - at[0][0], at[1][1] - at[0][1]};
    const double det = p[1] * q[0] - p[0] * q[1];
    const double area = taut_hypot(p[0], p[1]) * taut_hypot(q[0], q[1]);

    if (!(fabs(det) > least_sine * area)) {
        return 0;
    }
    step[0] = (away[1] * q[0] - away[0] * q[1]) / det;
    step[1] = (away[1] * p[0] - away[0] * p[1]) / det;
    return 1;
}

/* Is s on the segment, or so far beside it? */
static int is_within(const taut_segment *segment, double s, double room)
{
    return s >= segment->from.s - room && s <= segment->to.s + room;
}

/* Where the quintics cross, from a first guess; 0 where they do not. */
static int cross_quintics(const search *w, double s[2])
{
    const double settled = 1e-13 * w->carrier->size;
    for (int round = 0; round < 2 * ROUNDS; round++) {
        double at[2][2], way[2][2], step[2];
        for (int k = 0; k < 2; k++) {
            const taut_segment *segment = w->segments[k];
            const double length = segment->to.s - segment->from.s;
            double bend[2] = {0, 0};
            taut_quintic_at(2, w->quintics[k], (s[k] - segment->from.s) / length, at[k], way[k],
                            bend);
            way[k][0] *= (TAUT_QUINTIC - 1) / length;
            way[k][1] *= (TAUT_QUINTIC - 1) / length;
        }
        if (!newton_step((const double(*)[2])at, (const double(*)[2])way, step)) {
            return 0;
        }
        for (int k = 0; k < 2; k++) {
            s[k] += step[k];
            if (!is_within(w->segments[k], s[k], w->segments[k]->to.s - w->segments[k]->from.s)) {
                return 0;
            }
        }
        if (fabs(step[0]) + fabs(step[1]) <= settled) {
            break;
        }
    }
    const double room = roughly * w->carrier->size;
    return is_within(w->segments[0], s[0], room) && is_within(w->segments[1], s[1], room);
}

/* A station so little further on that its Taylor polynomial says where. */
static void move_station(taut_station *station, double step)
{
    station->s += step;
    for (int d = 0; d < 2; d++) {
        station->at[d] += step * (station->ab[d] + step / 2 * station->bend[d]);
    }
    taut_add_scaled(step, station->acceleration, station->tangent);
}

/* Where two straight lines of the window cross; 0 where that is on neither segment. */
static int cross_lines(const search *w, const double *const lines[2], taut_station at[2],
                       double s[2])
{
    double from[2][2], ways[2][2], t[2];
    const double room = roughly;

    for (int k = 0; k < 2; k++) {
        memcpy(from[k], w->segments[k]->start.y, sizeof from[k]);
        memcpy(ways[k], lines[k], sizeof ways[k]);
    }
    if (!newton_step((const double(*)[2])from, (const double(*)[2])ways, t)) {
        return 0;
    }
    for (int k = 0; k < 2; k++) {
        const taut_segment *segment = w->segments[k];
        const int d = fabs(ways[k][0]) > fabs(ways[k][1]) ? 0 : 1;
        const double length = segment->to.at[d] - segment->from.at[d];
        const double share = (from[k][d] + t[k] * ways[k][d] - segment->from.at[d]) / length;
        if (!(share >= -room) || !(share <= 1 + room)) {
            return 0;
        }
    }
    const double place[2] = {from[0][0] + t[0] * ways[0][0], from[0][1] + t[0] * ways[0][1]};
    for (int k = w->nodes->count - 1; k >= 0; k--) { /* two lines cross once */
        const taut_node *other = &w->nodes->list[k];
        if (other->laths[0] != w->index[0] || other->laths[1] != w->index[1]) {
            break;
        }
        if (fabs(other->at[0] - place[0]) <= same * (w->carrier->hi[0] - w->carrier->lo[0]) &&
            fabs(other->at[1] - place[1]) <= same * (w->carrier->hi[1] - w->carrier->lo[1])) {
            return 0;
        }
    }
    for (int k = 0; k < 2; k++) {
        const taut_linefield_kind kind = {w->net, k};
        taut_walk_state state;
        taut_straight_move(w->carrier, kind, &w->segments[k]->start, t[k], &state);
        taut_segment_station(kind, w->segments[k], &state, &at[k]);
        s[k] = at[k].s;
    }
    return isfinite(s[0]) && isfinite(s[1]);
}

/* The crossing near s[0] and s[1]: of the quintics first, then Newton on both lengths, each iterate a full step from
 * where the segment begins. 0 where there is none. */
static int cross_curves(const search *w, taut_station at[2], double s[2])
{
    if (!cross_quintics(w, s)) {
        return 0;
    }
    for (int round = 0; round < ROUNDS; round++) {
        double places[2][2], ways[2][2], step[2];
        for (int k = 0; k < 2; k++) {
            const taut_linefield_kind kind = {w->net, k};
            if (!taut_segment_state(kind, w->segments[k], s[k], &at[k])) {
                return 0;
            }
            memcpy(places[k], at[k].at, sizeof places[k]);
            memcpy(ways[k], at[k].ab, sizeof ways[k]);
        }
        if (!newton_step((const double(*)[2])places, (const double(*)[2])ways, step)) {
            return 0;
        }
        s[0] += step[0];
        s[1] += step[1];
        if (fabs(step[0]) + fabs(step[1]) <= small_step * w->carrier->size) {
            move_station(&at[0], step[0]);
            move_station(&at[1], step[1]);
            break;
        }
    }
    return 1;
}

static void polish(search *w, double s0, double s1)
{
    const taut_linefield_kind kinds[2] = {{w->net, 0}, {w->net, 1}};
    const double *const lines[2] = {taut_straight_way(w->carrier, kinds[0]),
                                    taut_straight_way(w->carrier, kinds[1])};
    double s[2] = {s0, s1};
    taut_station at[2];
    taut_node node;

    if (lines[0] != NULL && lines[1] != NULL ? !cross_lines(w, lines, at, s)
                                             : !cross_curves(w, at, s)) {
        return;
    }
    const double room = beyond * w->carrier->size;
    if (!is_within(w->segments[0], s[0], room) || !is_within(w->segments[1], s[1], room)) {
        return;
    }
    describe(w, at, &node);
    if (!is_known(w, &node)) {
        w->status = push(w->nodes, &node);
    }
}

static void halve(const double points[TAUT_QUINTIC][2], double low[TAUT_QUINTIC][2],
                  double high[TAUT_QUINTIC][2])
{
    double work[TAUT_QUINTIC][2];
    memcpy(work, points, sizeof work);
    for (int level = 0; level < TAUT_QUINTIC; level++) {
        memcpy(low[level], work[0], sizeof low[level]);
        memcpy(high[TAUT_QUINTIC - 1 - level], work[TAUT_QUINTIC - 1 - level], sizeof high[level]);
        for (int k = 0; k < TAUT_QUINTIC - 1 - level; k++) {
            for (int d = 0; d < 2; d++) {
                work[k][d] = (work[k][d] + work[k + 1][d]) / 2;
            }
        }
    }
}

/* Is the quintic nearly its chord, so that Newton is safe? */
static int is_flat(const double points[TAUT_QUINTIC][2])
{
    const double chord[2] = {points[5][0] - points[0][0], points[5][1] - points[0][1]};
    const double length = taut_hypot(chord[0], chord[1]);
    for (int k = 1; k < TAUT_QUINTIC - 1; k++) {
        const double away[2] = {points[k][0] - points[0][0], points[k][1] - points[0][1]};
        if (!(fabs(away[0] * chord[1] - away[1] * chord[0]) <= 0.02 * length * length)) {
            return 0;
        }
    }
    return 1;
}

/* Is the part not larger than the room around it, so that its halves would meet whatever it meets? */
static int is_speck(const taut_carrier *carrier, const box *b)
{
    for (int d = 0; d < 2; d++) {
        if (!(b->high[d] - b->low[d] <= 4 * margin * (carrier->hi[d] - carrier->lo[d]))) {
            return 0;
        }
    }
    return 1;
}

/* Two parts [from, to] of the segments, while their boxes meet. */
static void bisect(search *w, const double p[TAUT_QUINTIC][2], const double q[TAUT_QUINTIC][2],
                   const double from[2], const double to[2], int depth)
{
    const box a = box_of(w->carrier, p), b = box_of(w->carrier, q);
    double halves[2][2][TAUT_QUINTIC][2];

    if (w->status != TAUT_OK || !overlap(&a, &b)) {
        return;
    }
    if (depth == 0 || (is_flat(p) && is_flat(q) && depth < DEPTH - 2) ||
        (is_speck(w->carrier, &a) && is_speck(w->carrier, &b))) {
        polish(w, (from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
        return;
    }
    halve(p, halves[0][0], halves[0][1]);
    halve(q, halves[1][0], halves[1][1]);
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
            const double middle[2] = {(from[0] + to[0]) / 2, (from[1] + to[1]) / 2};
            const double begin[2] = {i == 0 ? from[0] : middle[0], j == 0 ? from[1] : middle[1]};
            const double end[2] = {i == 0 ? middle[0] : to[0], j == 0 ? middle[1] : to[1]};
            bisect(w, (const double(*)[2])halves[0][i], (const double(*)[2])halves[1][j], begin,
                   end, depth - 1);
        }
    }
}

/* The new nodes in the order of the first lath, numbered where there are several. */
static void sort_new(taut_nodes *nodes, int first)
{
    for (int i = first + 1; i < nodes->count; i++) {
        const taut_node node = nodes->list[i];
        int k = i;
        for (; k > first && nodes->list[k - 1].s[0] > node.s[0]; k--) {
            nodes->list[k] = nodes->list[k - 1];
        }
        nodes->list[k] = node;
    }
    for (int i = first; i < nodes->count; i++) {
        nodes->list[i].occurrence = i - first + 1;
    }
}

/* The crossings of two laths, in the order of the first. */
static void cross_laths(search *w, int first, int second)
{
    const outline *a = &w->outlines[first], *b = &w->outlines[second];
    const int before = w->nodes->count;

    w->index[0] = first;
    w->index[1] = second;
    for (int i = 0; overlap(&a->whole, &b->whole) && i < w->laths[first].count; i++) {
        if (!overlap(&a->boxes[i], &b->whole)) {
            continue;
        }
        w->segments[0] = &w->laths[first].segments[i];
        w->carrier = w->segments[0]->start.on;
        w->quintics[0] = a->quintics[i][0];
        for (int j = 0; w->status == TAUT_OK && j < w->laths[second].count; j++) {
            w->segments[1] = &w->laths[second].segments[j];
            if (w->segments[1]->start.on == w->carrier && overlap(&a->boxes[i], &b->boxes[j])) {
                w->quintics[1] = b->quintics[j][0];
                const double from[2] = {w->segments[0]->from.s, w->segments[1]->from.s};
                const double to[2] = {w->segments[0]->to.s, w->segments[1]->to.s};
                bisect(w, (const double(*)[2])a->quintics[i], (const double(*)[2])b->quintics[j],
                       from, to, DEPTH);
            }
        }
    }
    sort_new(w->nodes, before);
}

static taut_status outline_of(const search *w, const taut_lath *lath, outline *made)
{
    taut_arena *arena = w->nodes->arena;
    made->quintics = taut_arena_take_raw(arena, (size_t)lath->count + 1, sizeof *made->quintics);
    made->boxes = taut_arena_take_raw(arena, (size_t)lath->count + 1, sizeof *made->boxes);
    made->whole = (box){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < lath->count; k++) {
        taut_segment_window(&lath->segments[k], made->quintics[k]);
        made->boxes[k] = box_of(lath->segments[k].start.on, (const double(*)[2])made->quintics[k]);
        for (int d = 0; d < 2; d++) {
            made->whole.low[d] = fmin(made->whole.low[d], made->boxes[k].low[d]);
            made->whole.high[d] = fmax(made->whole.high[d], made->boxes[k].high[d]);
        }
    }
    return TAUT_OK;
}

taut_status taut_nodes_find(taut_trace_net net, const taut_lath *laths, int count,
                            taut_nodes *nodes)
{
    outline *outlines = taut_arena_take(nodes->arena, (size_t)count + 1, sizeof *outlines);
    search w = {.net = net,
                .laths = laths,
                .outlines = outlines,
                .nodes = nodes,
                .status = outlines != NULL ? TAUT_OK : TAUT_NO_MEMORY};

    for (int i = 0; w.status == TAUT_OK && i < count; i++) {
        w.status = outline_of(&w, &laths[i], &outlines[i]);
    }
    for (int i = 0; i < count; i++) {
        for (int j = net == TAUT_TRACE_GEODESIC ? i + 1 : 0; w.status == TAUT_OK && j < count;
             j++) {
            if (net == TAUT_TRACE_GEODESIC || laths[i].family < laths[j].family) {
                cross_laths(&w, i, j);
            }
        }
    }
    return w.status;
}
