/* flat.c -- the boundary of a flat film of many patches, side by side:
 *
 *     edges in no seam, each with a node at either end; one closed walk along all of them
 *     corners    nodes that are held; the edges between two of them are a side: one straight edge, or cables of one force
 *     the plane  across Newell's vector of the corners, which they run round counter-clockwise
 */
#include "construct/film/complex/flat.h"

#include "construct/film/edges.h"
#include "construct/film/polygon.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

static const double flat_share = 1e-12; /* of the size: of what lies in a plane, or on a line */

typedef struct border {
    int count;    /* of edges */
    int *ends[2]; /* [count]: nodes */
    int *ropes;   /* [count]; -1: straight and held */
    int sides;    /* of the polygon */
    int *corners; /* [sides]: nodes */
    int *drawn;   /* [sides]: ropes; -1 */
} border;

static int is_held(const taut_film_complex *c, int node)
{
    return c->holds[node].count == 3;
}

/* Do the nodes of an edge lie on a line? */
static int is_straight(const taut_film_layout *l, const taut_film_side *side)
{
    const taut_film_complex *c = &l->complex;
    const int count = taut_film_complex_along(&c->problem->patches[side->patch], side->edge);
    const double *a = l->start + 3 * taut_film_complex_node(c, side, 0),
                 *b = l->start + 3 * taut_film_complex_node(c, side, count - 1);
    double chord[3], from[3], across[3];

    taut_difference(b, a, chord);
    for (int k = 1; k < count - 1; k++) {
        taut_difference(l->start + 3 * taut_film_complex_node(c, side, k), a, from);
        taut_cross(chord, from, across);
        if (!(taut_norm(across) <= flat_share * taut_norm(chord))) {
            return 0;
        }
    }
    return taut_norm(chord) > 0;
}

/* The cable of given force that an edge is part of, or -1. */
static int rope_of(const taut_film_complex *c, int p, int e)
{
    for (int k = 0; k < c->strand_count; k++) {
        const taut_film_strand *strand = &c->strands[k];
        if (strand->seam < 0 && strand->side.patch == p && strand->side.edge == e) {
            return strand->rope;
        }
    }
    return -1;
}

/* One tension, no cells, threads, lines or poles, and nothing that slides? */
static int is_plain(const taut_film_layout *l)
{
    const taut_film_problem *problem = l->complex.problem;

    for (int p = 0; p < problem->patch_count; p++) {
        if (l->tensions[p] != l->tensions[0] || taut_film_has_density(&problem->patches[p])) {
            return 0;
        }
    }
    for (int s = 0; s < problem->seam_count; s++) {
        if (problem->seams[s].count != 2 || problem->seams[s].edge.kind == TAUT_FILM_CABLE) {
            return 0;
        }
    }
    for (int a = 0; a < l->complex.nodes; a++) {
        if (l->complex.holds[a].count == 1 || l->complex.holds[a].count == 2) {
            return 0;
        }
    }
    return problem->cell_count == 0;
}

/* 0: an edge in no seam is neither straight nor drawn by a given force. */
static int take_edges(const taut_film_layout *l, border *b)
{
    const taut_film_complex *c = &l->complex;

    b->count = 0;
    for (int k = 0; k < 4 * c->problem->patch_count; k++) {
        const taut_film_side side = {k / 4, k % 4, 0};
        if (taut_film_complex_seam(c->problem, side.patch, side.edge) >= 0) {
            continue;
        }
        const taut_film_edge_kind kind = c->problem->patches[side.patch].edges[side.edge].kind;
        const int rope = rope_of(c, side.patch, side.edge);
        if (rope >= 0 ? l->drawn[rope].law != TAUT_FILM_FORCE
                      : kind != TAUT_FILM_FIXED || !is_straight(l, &side)) {
            return 0;
        }
        const int last = taut_film_complex_along(&c->problem->patches[side.patch], side.edge) - 1;
        b->ends[0][b->count] = taut_film_complex_node(c, &side, 0);
        b->ends[1][b->count] = taut_film_complex_node(c, &side, last);
        b->ropes[b->count++] = rope;
    }
    return b->count > 2;
}

/* The edge after `from` at a node, where just one more is there; -1. */
static int next_of(const border *b, int from, int node)
{
    int next = -1, count = 0;
    for (int k = 0; k < b->count; k++) {
        if (k != from && (b->ends[0][k] == node || b->ends[1][k] == node)) {
            next = k;
            count++;
        }
    }
    return count == 1 ? next : -1;
}

/* Once round, from a corner that is held. 0: it is not one closed walk of sides. */
static int walk(const taut_film_layout *l, border *b)
{
    const taut_film_complex *c = &l->complex;
    int edge = 0, way = 0, left = b->count;

    while (edge < b->count && !is_held(c, b->ends[0][edge])) {
        edge++;
    }
    const int first = edge < b->count ? b->ends[0][edge] : -1;
    for (; left > 0; left--) {
        const int from = edge >= 0 && edge < b->count ? b->ends[way][edge] : -1;
        if (from < 0) {
            return 0;
        }
        const int rope = b->ropes[edge];
        if (is_held(c, from)) {
            b->corners[b->sides] = from;
            b->drawn[b->sides++] = rope;
        } else if (rope < 0 || b->drawn[b->sides - 1] < 0 ||
                   l->drawn[rope].ratio != l->drawn[b->drawn[b->sides - 1]].ratio) {
            return 0;
        }
        const int to = b->ends[1 - way][edge];
        if (to == first && left > 1) {
            return 0;
        }
        edge = next_of(b, edge, to);
        way = edge >= 0 && b->ends[0][edge] != to;
        if (left == 1) {
            return to == first && b->sides > 2;
        }
    }
    return 0;
}

/* Counter-clockwise in the plane across n; 0: what is held is not in a plane. */
static int lay_flat(const taut_film_layout *l, const border *b, taut_film_arc *arcs)
{
    const taut_film_complex *c = &l->complex;
    const double *at = l->start + 3 * b->corners[0];
    double n[3] = {0, 0, 0}, e[2][3];

    for (int k = 0; k < b->sides; k++) {
        double one[3], other[3], across[3];
        taut_difference(l->start + 3 * b->corners[k], at, one);
        taut_difference(l->start + 3 * b->corners[(k + 1) % b->sides], at, other);
        taut_cross(one, other, across);
        taut_add_scaled(1, across, n);
    }
    const double size = taut_norm(n);
    taut_difference(l->start + 3 * b->corners[1], at, e[0]);
    const double length = taut_norm(e[0]);
    if (!(size > flat_share) || !(length > 0)) {
        return 0;
    }
    for (int k = 0; k < 3; k++) {
        n[k] /= size;
        e[0][k] /= length;
    }
    taut_cross(n, e[0], e[1]);
    for (int a = 0; a < c->nodes; a++) {
        double from[3];
        taut_difference(l->start + 3 * a, at, from);
        if (is_held(c, a) && !(fabs(taut_dot(from, n)) <= flat_share)) {
            return 0;
        }
    }
    for (int k = 0; k < b->sides; k++) {
        double flat[2][2];
        for (int end = 0; end < 2; end++) {
            double from[3];
            taut_difference(l->start + 3 * b->corners[(k + end) % b->sides], at, from);
            flat[end][0] = taut_dot(from, e[0]);
            flat[end][1] = taut_dot(from, e[1]);
        }
        taut_film_arc_set(&arcs[k], flat[0], flat[1],
                          b->drawn[k] >= 0 ? l->drawn[b->drawn[k]].ratio : 0);
    }
    return 1;
}

static taut_status refuse_weak(const taut_film_layout *l, const border *b,
                               taut_film_polygon *polygon, taut_error *error)
{
    const double factor = taut_film_polygon_factor(polygon);
    char where[TAUT_FILM_ROPE_WHERE], name[TAUT_FILM_NAME];
    int k = 0;

    while (b->drawn[k] < 0) {
        k++;
    }
    const double force = l->complex.ropes[b->drawn[k]].edge->force;
    taut_film_rope_where(&l->complex, b->drawn[k], "force", where);
    taut_film_rope_name(&l->complex, b->drawn[k], name);
    return taut_fail(error, TAUT_NO_SOLUTION, "cable-too-weak", where, force, factor * force,
                     "the cables are too weak for this flat film of tension %g: with these forces "
                     "their arcs touch or do not span their chords (proved); expected more than "
                     "%.15g times the forces (%.15g for cable %s), or so much less tension",
                     l->tensions[0], factor, factor * force, name);
}

taut_status taut_film_complex_flat_check(const taut_film_layout *layout, taut_arena *arena,
                                         taut_error *error)
{
    const size_t most = 4 * (size_t)layout->complex.problem->patch_count;
    border b = {.ends = {taut_arena_take(arena, most, sizeof(int)),
                         taut_arena_take(arena, most, sizeof(int))},
                .ropes = taut_arena_take(arena, most, sizeof(int)),
                .corners = taut_arena_take(arena, most, sizeof(int)),
                .drawn = taut_arena_take(arena, most, sizeof(int))};
    taut_film_arc *arcs = taut_arena_take(arena, most, sizeof *arcs);

    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (layout->complex.rope_count == 0 || !is_plain(layout) || !take_edges(layout, &b) ||
        !walk(layout, &b) || !lay_flat(layout, &b, arcs)) {
        return TAUT_OK;
    }
    taut_film_polygon polygon = {.count = b.sides, .sides = arcs};
    int has_cable = 0;
    for (int k = 0; k < b.sides; k++) {
        has_cable |= b.drawn[k] >= 0;
    }
    return !has_cable || taut_film_polygon_is_crossed(&polygon) ||
                   taut_film_polygon_exists(&polygon, 1)
               ? TAUT_OK
               : refuse_weak(layout, &b, &polygon, error);
}
