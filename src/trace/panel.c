/* panel.c
 *
 *     of each step p, q from node to node on a curve of the first family: on both curves that cross there the next nodes
 *     r, t to one side; a quad where those are on one curve, and next to each other. It lies to the left of one of its two curves and
 *     to the right of the other, or on one side of both, where they run against each other
 */
#include "trace/panel.h"

#include "core/vec3.h"

#include <math.h>
#include <stdlib.h>

/* The nodes of a lath along it. */
typedef struct row {
    int *nodes, count;
    int is_ring; /* it closes: behind the last one is the first */
} row;

static double s_on(const taut_net *net, int node, int lath)
{
    const taut_node *n = &net->nodes.list[node];
    return n->s[n->laths[0] == lath ? 0 : 1];
}

static taut_status make_rows(const taut_net *net, row *rows)
{
    for (int k = 0; k < net->nodes.count; k++) {
        for (int side = 0; side < 2; side++) {
            rows[net->nodes.list[k].laths[side]].count++;
        }
    }
    for (int i = 0; i < net->count; i++) {
        rows[i].nodes = taut_arena_take(net->arena, (size_t)rows[i].count + 1, sizeof(int));
        rows[i].is_ring = net->laths[i].ended[1] == TAUT_END_CLOSED && rows[i].count > 2;
        rows[i].count = 0;
        if (rows[i].nodes == NULL) {
            return TAUT_NO_MEMORY;
        }
    }
    for (int k = 0; k < 2 * net->nodes.count; k++) {
        const int lath = net->nodes.list[k / 2].laths[k % 2];
        row *r = &rows[lath];
        int i = r->count++;
        for (; i > 0 && s_on(net, r->nodes[i - 1], lath) > s_on(net, k / 2, lath); i--) {
            r->nodes[i] = r->nodes[i - 1];
        }
        r->nodes[i] = k / 2;
    }
    return TAUT_OK;
}

/* The place next to one, forwards or backwards; -1 where there is none. */
static int beside(const row *r, int place, int step)
{
    const int next = place + step;
    return next >= 0 && next < r->count ? next : r->is_ring ? (next + r->count) % r->count : -1;
}

static int place_in(const row *r, int node)
{
    int i = 0;
    while (i < r->count && r->nodes[i] != node) {
        i++;
    }
    return i;
}

static void tangent_at(const taut_net *net, int lath, int node, double tangent[3])
{
    const taut_lath *on = &net->laths[lath];
    const double s = s_on(net, node, lath);
    double space[TAUT_QUINTIC][3], x[3], bend[3];
    int k = 0;
    while (k + 1 < on->count && s > on->segments[k].to.s) {
        k++;
    }
    const taut_segment *segment = &on->segments[k];
    taut_segment_space(segment, space);
    const double length = segment->to.s - segment->from.s;
    taut_quintic_at(3, space[0], fmin(fmax((s - segment->from.s) / length, 0), 1), x, tangent,
                    bend);
}

/* The next node on the curve that crosses `lath` at `node`, to the left of it (side 1) or the right (-1); -1 where there is
 * none. */
static int next_beside(const taut_net *net, const row *rows, int lath, int node, int side)
{
    const taut_node *n = &net->nodes.list[node];
    const int other = n->laths[n->laths[0] == lath ? 1 : 0];
    const int place = place_in(&rows[other], node);
    double along[3], across[3], left[3];

    tangent_at(net, lath, node, along);
    tangent_at(net, other, node, across);
    taut_cross(n->normal, along, left);
    const int next = beside(&rows[other], place, side * taut_dot(left, across) > 0 ? 1 : -1);
    return next >= 0 ? rows[other].nodes[next] : -1;
}

/* The distance of the diagonals of a quad p, q, t, r over their mean length. */
static double planarity_of(const taut_net *net, const int corners[4])
{
    const double *x[4];
    double a[3], b[3], side[3], across[3];
    for (int k = 0; k < 4; k++) {
        x[k] = net->nodes.list[corners[k]].x;
    }
    taut_difference(x[2], x[0], a);
    taut_difference(x[3], x[1], b);
    taut_difference(x[1], x[0], side);
    taut_cross(a, b, across);
    const double area = taut_length(across), mean = (taut_length(a) + taut_length(b)) / 2;
    return area > 0 ? fabs(taut_dot(side, across)) / (area * mean) : 0;
}

static void look_beside(const taut_net *net, const row *rows, int lath, int k, int side,
                        taut_panels *panels)
{
    const int p = rows[lath].nodes[k], q = rows[lath].nodes[beside(&rows[lath], k, 1)];
    const int r = next_beside(net, rows, lath, p, side), t = next_beside(net, rows, lath, q, side);

    if (r < 0 || t < 0 || net->nodes.list[r].laths[0] != net->nodes.list[t].laths[0] ||
        net->nodes.list[p].laths[1] == net->nodes.list[q].laths[1]) {
        return;
    }
    const int far = net->nodes.list[r].laths[0];
    const int from = place_in(&rows[far], r), to = place_in(&rows[far], t);
    const int is_against = beside(&rows[far], to, 1) == from; /* to this side of that one too */
    if (far == lath || (!is_against && beside(&rows[far], from, 1) != to)) {
        return;
    }
    if (is_against ? far < lath : side < 0) {
        return;
    }
    taut_panel *panel = &panels->list[panels->count++];
    *panel =
        side > 0 ? (taut_panel){.corners = {p, q, t, r}} : (taut_panel){.corners = {q, p, r, t}};
    panel->planarity = planarity_of(net, panel->corners);
    panels->planarity = fmax(panels->planarity, panel->planarity);
}

taut_status taut_panels_of(const taut_net *net, taut_panels *panels)
{
    row *rows = taut_arena_take(net->arena, (size_t)net->count + 1, sizeof *rows);

    *panels = (taut_panels){
        .list = taut_arena_take(net->arena, 2 * (size_t)net->nodes.count + 1,
                                sizeof *panels->list)}; /* of a step on both sides at most */
    if (rows == NULL || panels->list == NULL || make_rows(net, rows) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < net->count; i++) {
        for (int k = 0;
             net->laths[i].family == 0 && k < rows[i].count && beside(&rows[i], k, 1) >= 0; k++) {
            look_beside(net, rows, i, k, 1, panels);
            look_beside(net, rows, i, k, -1, panels);
        }
    }
    return TAUT_OK;
}
