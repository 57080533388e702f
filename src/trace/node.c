#include "trace/node.h"

#include "core/vec3.h"

#include <string.h>

enum { DEPTH = 9, ROUNDS = 12 };
/* Boxes are wider than the quintics by this, over the window; a node may lie that far, over the
 * size, beyond an end; nodes nearer than that are one. */
static const double margin = 1e-7, beyond = 1e-9, same = 1e-9;
/* Below this sine two laths of a pair do not cross but touch. */
static const double least_sine = 1e-7;

typedef struct box {
    double low[2], high[2];
} box;

static box box_of(const double points[TAUT_QUINTIC][2], const double room[2])
{
    box b = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int k = 0; k < TAUT_QUINTIC; k++) {
        for (int d = 0; d < 2; d++) {
            b.low[d] = fmin(b.low[d], points[k][d] - room[d]);
            b.high[d] = fmax(b.high[d], points[k][d] + room[d]);
        }
    }
    return b;
}

static int overlap(const box *a, const box *b)
{
    return a->low[0] <= b->high[0] && b->low[0] <= a->high[0] && a->low[1] <= b->high[1] &&
           b->low[1] <= a->high[1];
}

/* What is searched: two segments, and what was found. */
typedef struct search {
    const taut_carrier *carrier;
    taut_trace_net net;
    const taut_lath *laths;
    int index[2];
    const taut_segment *segments[2];
    double room[2];
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
        if (!carrier->wraps[d] &&
            (at[d] <= carrier->lo[d] + room || at[d] >= carrier->hi[d] - room)) {
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

/* Is there one like it already, of these two laths? */
static int is_known(const search *w, const taut_node *node)
{
    for (int k = w->nodes->count - 1; k >= 0; k--) {
        const taut_node *other = &w->nodes->list[k];
        if (other->laths[0] != node->laths[0] || other->laths[1] != node->laths[1]) {
            return 0;
        }
        if (taut_length_between(other->x, node->x) <= same * w->carrier->size &&
            fabs(other->s[0] - node->s[0]) <= 1e3 * same * w->carrier->size) {
            return 1;
        }
    }
    return 0;
}

/* Newton on both lengths, each iterate a full step, from the middles of what is left. */
static void polish(search *w, double s0, double s1)
{
    double s[2] = {s0, s1};
    taut_station at[2];
    taut_node node;

    for (int round = 0; round < ROUNDS; round++) {
        for (int k = 0; k < 2; k++) {
            const taut_linefield_kind kind = {w->net, k};
            if (!taut_segment_state(w->carrier, kind, w->segments[k], s[k], &at[k])) {
                return;
            }
        }
        const double *p = at[0].ab, *q = at[1].ab;
        const double away[2] = {at[1].at[0] - at[0].at[0], at[1].at[1] - at[0].at[1]};
        const double det = p[1] * q[0] - p[0] * q[1];
        const double area = taut_hypot(p[0], p[1]) * taut_hypot(q[0], q[1]);
        if (!(fabs(det) > least_sine * area)) {
            return;
        }
        const double step[2] = {(away[1] * q[0] - away[0] * q[1]) / det,
                                (away[1] * p[0] - away[0] * p[1]) / det};
        for (int k = 0; k < 2; k++) {
            const taut_segment *segment = w->segments[k];
            const double length = segment->to.s - segment->from.s;
            s[k] += step[k];
            if (!(s[k] > segment->from.s - length) || !(s[k] < segment->to.s + length)) {
                return;
            }
        }
        if (fabs(step[0]) + fabs(step[1]) <= 1e-15 * w->carrier->size) {
            break;
        }
    }
    for (int k = 0; k < 2; k++) {
        const double room = beyond * w->carrier->size;
        if (!(s[k] >= w->segments[k]->from.s - room) || !(s[k] <= w->segments[k]->to.s + room)) {
            return;
        }
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

/* Two parts [from, to] of the segments, while their boxes meet. */
static void bisect(search *w, const double p[TAUT_QUINTIC][2], const double q[TAUT_QUINTIC][2],
                   const double from[2], const double to[2], int depth)
{
    const box a = box_of(p, w->room), b = box_of(q, w->room);
    double halves[2][2][TAUT_QUINTIC][2];

    if (w->status != TAUT_OK || !overlap(&a, &b)) {
        return;
    }
    if (depth == 0 || (is_flat(p) && is_flat(q) && depth < DEPTH - 2)) {
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

taut_status taut_nodes_between(const taut_carrier *carrier, taut_trace_net net,
                               const taut_lath *laths, int first, int second, taut_nodes *nodes)
{
    const int before = nodes->count;
    search w = {.carrier = carrier,
                .net = net,
                .laths = laths,
                .index = {first, second},
                .room = {margin * (carrier->hi[0] - carrier->lo[0]),
                         margin * (carrier->hi[1] - carrier->lo[1])},
                .nodes = nodes};

    for (int i = 0; i < laths[first].count; i++) {
        double p[TAUT_QUINTIC][2];
        w.segments[0] = &laths[first].segments[i];
        taut_segment_window(w.segments[0], p);
        const box a = box_of((const double(*)[2])p, w.room);
        for (int j = 0; w.status == TAUT_OK && j < laths[second].count; j++) {
            double q[TAUT_QUINTIC][2];
            w.segments[1] = &laths[second].segments[j];
            taut_segment_window(w.segments[1], q);
            const box b = box_of((const double(*)[2])q, w.room);
            if (overlap(&a, &b)) {
                const double from[2] = {w.segments[0]->from.s, w.segments[1]->from.s};
                const double to[2] = {w.segments[0]->to.s, w.segments[1]->to.s};
                bisect(&w, (const double(*)[2])p, (const double(*)[2])q, from, to, DEPTH);
            }
        }
    }
    sort_new(nodes, before);
    return w.status;
}
