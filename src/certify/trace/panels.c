/* panels.c
 *
 *     each panel: four nodes, neighbours of each other on curves of both families in turn, and the nodes' points
 *     planarity of its points: the distance of the diagonals, as volume over area, over their mean length
 *     as many as there are: steps p, q of a curve whose neighbours r of p and t of q, to one side, are a step of another curve, each seen
 *     from both of its curves
 */
#include "certify/trace/panels.h"

#include "certify/common/verdict.h"
#include "certify/trace/crossings.h"
#include "certify/trace/laths.h"
#include "core/vec3.h"

#include <string.h>

/* Of a curve's length: its ends are one place. */
static const double one_place = 1e-9;

typedef struct spot {
    const char *name;
    const taut_record *point;
    int line[2];    /* of the audit's lines; -1 */
    double s[2];    /* on both */
    int turn;       /* 1 where the second curve goes to the left of the first one, else -1 */
    int next[2][2]; /* [curve][way]: the next node, or -1 */
} spot;

typedef struct spots {
    spot *list;
    int count;
} spots;

static double at_of(const taut_record *list, size_t k)
{
    return taut_record_number(taut_record_at(list, k));
}

static taut_status read_nodes(const taut_net_audit *audit, taut_arena *arena, spots *all)
{
    const taut_record *nodes = taut_record_get(taut_model_details(audit->lines->model), "nodes");
    all->count = (int)taut_record_count(nodes);
    all->list = taut_arena_take(arena, (size_t)all->count + 1, sizeof *all->list);
    for (int k = 0; all->list != NULL && k < all->count; k++) {
        const taut_record *node = taut_record_at(nodes, (size_t)k);
        const taut_net_line *both[2];
        spot *one = &all->list[k];
        *one = (spot){.name = taut_record_text(taut_record_get(node, "node")),
                      .point = taut_record_get(node, "point"),
                      .line = {-1, -1},
                      .next = {{-1, -1}, {-1, -1}}};
        taut_net_spot at[2];
        const int is_known = taut_net_lines_of_node(audit->lines, one->name, both) &&
                             taut_net_spots_of_node(audit, node, at);
        one->turn = is_known && taut_dot(at[0].sideways, at[1].tangent) > 0 ? 1 : -1;
        for (int side = 0; is_known && side < 2; side++) {
            one->line[side] = (int)(both[side] - audit->lines->lines);
            one->s[side] = at_of(taut_record_get(node, "s"), (size_t)side);
        }
    }
    return all->list != NULL ? TAUT_OK : TAUT_NO_MEMORY;
}

/* The neighbours of each node along its curves. */
static void find_neighbours(spots *all)
{
    for (int k = 0; k < all->count; k++) {
        for (int side = 0; side < 2; side++) {
            spot *one = &all->list[k];
            for (int j = 0; j < all->count; j++) {
                const spot *other = &all->list[j];
                if (j == k || one->line[side] < 0 || other->line[side] != one->line[side]) {
                    continue;
                }
                const int way =
                    other->s[side] > one->s[side] || (other->s[side] == one->s[side] && j > k);
                const int before = one->next[side][way];
                const double gap = fabs(other->s[side] - one->s[side]);
                if (before < 0 || gap < fabs(all->list[before].s[side] - one->s[side])) {
                    one->next[side][way] = j;
                }
            }
        }
    }
}

/* Behind the last node of a curve that closes is the first one, unless the two are one place, as nets of version 0.1 had it. */
static void close_rings(const taut_net_audit *audit, spots *all)
{
    for (int i = 0; i < audit->lines->count; i++) {
        const taut_net_line *line = &audit->lines->lines[i];
        const taut_record *ended = taut_record_get(taut_net_lath_of(audit->lines, line), "ended");
        const int side = line->family;
        int count = 0, first = -1, last = -1;
        for (int k = 0; k < all->count; k++) {
            if (all->list[k].line[side] == i) {
                count++;
                first = all->list[k].next[side][0] < 0 ? k : first;
                last = all->list[k].next[side][1] < 0 ? k : last;
            }
        }
        if (count > 2 && strcmp(taut_record_text(taut_record_at(ended, 0)), "closed") == 0 &&
            all->list[last].s[side] - all->list[first].s[side] < line->length * (1 - one_place)) {
            all->list[last].next[side][1] = first;
            all->list[first].next[side][0] = last;
        }
    }
}

static int are_next(const spots *all, int a, int b, int side)
{
    return all->list[a].next[side][0] == b || all->list[a].next[side][1] == b;
}

/* Quads p, q, t, r with p, q next to each other on a curve of the first family, and r, t on another one. */
static int count_quads(const spots *all)
{
    int count = 0;
    for (int p = 0; p < all->count; p++) {
        const int q = all->list[p].next[0][1];
        for (int way = 0; q >= 0 && way < 4; way++) {
            const int r = all->list[p].next[1][way % 2], t = all->list[q].next[1][way / 2];
            const int is_beside = /* both to one side */
                all->list[p].turn * (2 * (way % 2) - 1) == all->list[q].turn * (2 * (way / 2) - 1);
            count += is_beside && r >= 0 && t >= 0 && r != t &&
                     all->list[p].line[1] != all->list[q].line[1] &&
                     all->list[r].line[0] != all->list[p].line[0] &&
                     all->list[r].line[0] == all->list[t].line[0] && are_next(all, r, t, 0);
        }
    }
    return count / 2;
}

static int node_of(const spots *all, const char *name)
{
    for (int k = 0; k < all->count; k++) {
        if (strcmp(all->list[k].name, name) == 0) {
            return k;
        }
    }
    return -1;
}

/* Are these four nodes the corners of a quad of the net, in turn, and the points theirs? */
static int is_quad(const spots *all, const taut_record *panel, int corners[4])
{
    const taut_record *points = taut_record_get(panel, "points");
    for (size_t k = 0; k < 4; k++) {
        const char *name = taut_record_text(taut_record_at(taut_record_get(panel, "nodes"), k));
        corners[k] = node_of(all, name);
        for (size_t c = 0; corners[k] >= 0 && c < 3; c++) {
            if (at_of(taut_record_at(points, k), c) != at_of(all->list[corners[k]].point, c)) {
                return 0;
            }
        }
        if (corners[k] < 0) {
            return 0;
        }
    }
    return are_next(all, corners[0], corners[1], 0) && are_next(all, corners[2], corners[3], 0) &&
           are_next(all, corners[1], corners[2], 1) && are_next(all, corners[3], corners[0], 1);
}

static double planarity_of(const taut_net_audit *audit, const taut_record *panel)
{
    double x[4][3], a[3], b[3], side[3], across[3];
    for (size_t k = 0; k < 4; k++) {
        for (size_t c = 0; c < 3; c++) {
            x[k][c] =
                ldexp(at_of(taut_record_at(taut_record_get(panel, "points"), k), c), -audit->unit);
        }
    }
    taut_difference(x[2], x[0], a);
    taut_difference(x[3], x[1], b);
    taut_difference(x[3], x[0], side);
    taut_cross(b, a, across);
    const double area = taut_length(across);
    return area > 0 ? fabs(taut_dot(across, side)) / area / ((taut_length(a) + taut_length(b)) / 2)
                    : 0;
}

taut_status taut_net_panels_look(const taut_net_audit *audit, taut_arena *arena, taut_net_off *off)
{
    const taut_record *details = taut_model_details(audit->lines->model);
    const taut_record *panels = taut_record_get(details, "panels");
    const int is_asked = audit->problem != NULL ? audit->problem->panels : panels != NULL;
    const size_t count = taut_record_count(panels);
    spots all;
    double largest = 0;

    if (!is_asked) {
        taut_net_off_take(off, panels == NULL ? 0 : INFINITY, "", "panels");
        return TAUT_OK;
    }
    if (read_nodes(audit, arena, &all) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    find_neighbours(&all);
    close_rings(audit, &all);
    for (size_t k = 0; k < count; k++) {
        const taut_record *panel = taut_record_at(panels, k);
        const double planarity = planarity_of(audit, panel);
        int corners[4];
        largest = taut_certify_max(largest, planarity);
        taut_net_off_take(off, is_quad(&all, panel, corners) ? 0 : INFINITY, "panels", "nodes");
        taut_net_off_take(off,
                          fabs(taut_record_number(taut_record_get(panel, "planarity")) - planarity),
                          "panels", "planarity");
    }
    const double told = taut_record_number(taut_record_get(details, "panel_count"));
    const int is_all = (double)count == told && count == (size_t)count_quads(&all);
    taut_net_off_take(off, is_all ? 0 : INFINITY, "panels", "panel_count");
    taut_net_off_take(off,
                      fabs(taut_record_number(taut_record_get(details, "max_planarity")) - largest),
                      "panels", "max_planarity");
    return TAUT_OK;
}
