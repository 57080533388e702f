#include "problem/film_complex.h"

#include "core/fail.h"
#include "core/vec3.h"
#include "problem/film_ropes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const edge_names[4] = {"u0", "u1", "v0", "v1"};
static const char *const corner_names[4] = {"u0v0", "u1v0", "u0v1", "u1v1"};
static const double knots_alike = 1e-12; /* of the range */
static const double gap_meeting = 1e-9;  /* of the size */
static const double gap_one = 0x1p-48;   /* of the size: points that are one but for rounding */

const taut_film_problem *taut_film_complex_of(const taut_film_problem *problem,
                                              taut_film_lone *room)
{
    if (problem->patch_count > 0) {
        return problem;
    }
    room->problem = room->patch = *problem;
    room->patch.name = problem->name != NULL ? problem->name : "film";
    room->problem.patch_count = 1;
    room->problem.patches = &room->patch;
    if (problem->ring != TAUT_FILM_OPEN) {
        const int first = problem->ring == TAUT_FILM_RING_U ? 0 : 2;
        for (int k = 0; k < 2; k++) {
            room->sides[k] = (taut_film_side){0, first + k, 0};
        }
        room->seam = (taut_film_seam){.count = 2, .sides = room->sides};
        room->problem.seam_count = 1;
        room->problem.seams = &room->seam;
    }
    return &room->problem;
}

/* ---- what holds corners ---- */

static int add_plane(taut_film_hold *hold, const taut_film_guide *plane, double gap)
{
    return taut_film_hold_add(hold, plane->direction, taut_dot(plane->direction, plane->point),
                              gap);
}

static int add_line(taut_film_hold *hold, const taut_film_guide *line, double gap)
{
    for (int c = 0; c < 3; c++) {
        const double axis[3] = {c == 0, c == 1, c == 2};
        double across[3];
        taut_cross(line->direction, axis, across);
        if (taut_norm(across) > 0.1 * taut_norm(line->direction) &&
            !taut_film_hold_add(hold, across, taut_dot(across, line->point), gap)) {
            return 0;
        }
    }
    return 1;
}

static int add_point(taut_film_hold *hold, const double point[3], double gap)
{
    int meets = 1;
    for (int c = 0; c < 3; c++) {
        const double axis[3] = {c == 0, c == 1, c == 2};
        meets &= taut_film_hold_add(hold, axis, point[c], gap);
    }
    return meets;
}

/* ---- what is one ---- */

static int root_of(int *up, int a)
{
    while (up[a] != a) {
        a = up[a] = up[up[a]];
    }
    return a;
}

static void unite(int *up, int a, int b)
{
    a = root_of(up, a);
    b = root_of(up, b);
    up[a > b ? a : b] = a > b ? b : a;
}

static void side_name(const taut_film_problem *problem, const taut_film_side *side, char name[96])
{
    snprintf(name, 96, "%s%.80s.%s", side->reversed ? "-" : "", problem->patches[side->patch].name,
             edge_names[side->edge]);
}

/* Knot k of a basis over [0, 1], or of the basis run backwards. */
static double knot_of(const taut_basis *basis, int k, int reversed)
{
    const double lo = taut_basis_lo(basis), length = taut_basis_hi(basis) - lo;
    const int p = taut_basis_degree(basis), n = taut_basis_count(basis), knots = n + p + 1;
    taut_basis_spec spec;

    taut_basis_spec_of(basis, &spec);
    const int at = reversed ? knots - 1 - k : k;
    const double t = spec.knots != NULL ? (spec.knots[at] - lo) / length : at > p;
    return reversed ? 1 - t : t;
}

static const taut_basis *basis_of(const taut_film_problem *problem, const taut_film_side *side)
{
    const taut_film_problem *patch = &problem->patches[side->patch];
    return side->edge < 2 ? patch->v : patch->u;
}

static taut_status check_alike(const taut_film_problem *problem, int s, int k, taut_error *error)
{
    const taut_film_side *a = &problem->seams[s].sides[0], *b = &problem->seams[s].sides[k];
    const taut_basis *one = basis_of(problem, a), *other = basis_of(problem, b);
    const int n = taut_basis_count(one), p = taut_basis_degree(one);
    char names[2][96], where[32];

    side_name(problem, a, names[0]);
    side_name(problem, b, names[1]);
    snprintf(where, sizeof where, "/seams/%d", s);
    if (taut_basis_count(other) != n || taut_basis_degree(other) != p) {
        return taut_fail(error, TAUT_BAD_INPUT, "seam-mismatch", where, taut_basis_count(other), n,
                         "edge %s has %d functions of degree %d and edge %s has %d of degree %d: "
                         "give both the same basis",
                         names[0], n, p, names[1], taut_basis_count(other),
                         taut_basis_degree(other));
    }
    for (int j = 0; j < n + p + 1; j++) {
        const double x = knot_of(one, j, a->reversed), y = knot_of(other, j, b->reversed);
        if (!(fabs(x - y) <= knots_alike)) {
            return taut_fail(error, TAUT_BAD_INPUT, "seam-mismatch", where, y, x,
                             "knot %d of edge %s is at %.17g of its range and that of edge %s at "
                             "%.17g: give both the same knots, as they are run",
                             j, names[0], x, names[1], y);
        }
    }
    return TAUT_OK;
}

static taut_status check_seam(const taut_film_problem *problem, int s, taut_error *error)
{
    const taut_film_seam *seam = &problem->seams[s];
    taut_status status = TAUT_OK;

    for (int k = 0; status == TAUT_OK && k < seam->count; k++) {
        const taut_film_side *side = &seam->sides[k];
        const taut_film_edge *edge = &problem->patches[side->patch].edges[side->edge];
        char name[96], where[32];
        int often = 0;
        side_name(problem, side, name);
        snprintf(where, sizeof where, "/seams/%d/%d", s, k);
        for (int j = 0; j < problem->seam_count; j++) {
            for (int m = 0; m < problem->seams[j].count; m++) {
                often += problem->seams[j].sides[m].patch == side->patch &&
                         problem->seams[j].sides[m].edge == side->edge;
            }
        }
        if (often > 1 || edge->kind != TAUT_FILM_FIXED || edge->curve != NULL) {
            return taut_fail(error, TAUT_BAD_INPUT, "edge-conflict", where, often, 1,
                             often > 1
                                 ? "edge %s is in a seam %d times, expected once"
                                 : "edge %s is in a seam, and held or drawn too: leave out one "
                                   "of them (seams: %d)",
                             name, often);
        }
        status = check_alike(problem, s, k, error);
    }
    return status;
}

static taut_status find_nodes(taut_film_complex *c, taut_arena *arena)
{
    const taut_film_problem *problem = c->problem;
    int *up = taut_arena_take(arena, (size_t)c->points, sizeof(int));

    c->node = taut_arena_take(arena, (size_t)c->points, sizeof(int));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < c->points; k++) {
        up[k] = k;
    }
    for (int s = 0; s < problem->seam_count; s++) {
        const taut_film_seam *seam = &problem->seams[s];
        const int n = taut_basis_count(basis_of(problem, &seam->sides[0]));
        for (int j = 1; j < seam->count; j++) {
            for (int k = 0; k < n; k++) {
                unite(up, taut_film_complex_run(c, &seam->sides[0], k),
                      taut_film_complex_run(c, &seam->sides[j], k));
            }
        }
    }
    for (int p = 0; p < problem->patch_count; p++) {
        for (int e = 0; e < 4; e++) {
            const taut_film_side side = {p, e, 0};
            for (int k = 1; problem->patches[p].edges[e].kind == TAUT_FILM_POLE &&
                            k < taut_film_complex_along(&problem->patches[p], e);
                 k++) {
                unite(up, taut_film_complex_run(c, &side, 0), taut_film_complex_run(c, &side, k));
            }
        }
    }
    for (int k = 0; k < c->points; k++) {
        const int root = root_of(up, k);
        c->node[k] = root == k ? c->nodes++ : c->node[root];
    }
    return TAUT_OK;
}

/* ---- what holds ---- */

static taut_status refuse_corner(const taut_film_complex *c, int p, int k, taut_error *error)
{
    char where[64];
    const taut_film_problem *patch = &c->problem->patches[p];
    const taut_film_hold *hold = &c->holds[taut_film_complex_corner(c, p, k)];
    double held[3] = {0, 0, 0}, gap = taut_none;

    snprintf(where, sizeof where, "/patches/%d/corners/%s", p, corner_names[k]);
    taut_film_hold_onto(hold, held);
    if (patch->has_corner[k]) {
        gap = taut_distance(held, patch->corners[k]);
    }
    return taut_fail(
        error, TAUT_BAD_INPUT, "corner-conflict", where, gap, 0,
        "corner %s of patch %.80s is one with another by its seams, and what holds them "
        "does not meet: they are %.3g apart",
        corner_names[k], patch->name, gap);
}

static void end_of(const taut_curve *curve, int end, double x[3])
{
    const taut_basis *t = taut_curve_t(curve);
    (void)taut_curve_eval(curve, end == 0 ? taut_basis_lo(t) : taut_basis_hi(t), 0, x);
}

static taut_status hold_corners(taut_film_complex *c, int p, double size, taut_error *error)
{
    const taut_film_problem *patch = &c->problem->patches[p];
    const double gap = gap_meeting * size;

    for (int k = 0; k < 4; k++) {
        taut_film_hold *hold = &c->holds[taut_film_complex_corner(c, p, k)];
        const taut_film_corner_kind kind = patch->corner_kinds[k];
        const int meets = kind == TAUT_FILM_HELD && patch->has_corner[k]
                              ? add_point(hold, patch->corners[k], gap_one * size)
                          : kind == TAUT_FILM_ON_LINE  ? add_line(hold, &patch->guides[k], gap)
                          : kind == TAUT_FILM_ON_PLANE ? add_plane(hold, &patch->guides[k], gap)
                                                       : 1;
        if (!meets) {
            return refuse_corner(c, p, k, error);
        }
    }
    return TAUT_OK;
}

static taut_status hold_ends(taut_film_complex *c, int p, double gap, taut_error *error)
{
    const taut_film_problem *patch = &c->problem->patches[p];

    for (int e = 0; e < 4; e++) {
        for (int end = 0; patch->edges[e].curve != NULL && end < 2; end++) {
            const int k = taut_film_edge_corner(e, end);
            double x[3];
            end_of(patch->edges[e].curve, end, x);
            if (!add_point(&c->holds[taut_film_complex_corner(c, p, k)], x, gap)) {
                char where[64];
                snprintf(where, sizeof where, "/patches/%d/edges/%s/fixed", p, edge_names[e]);
                return taut_fail(
                    error, TAUT_BAD_INPUT, "curve-ends", where, taut_none, gap,
                    "the curve of edge %.80s.%s misses corner %s: u0 and u1 run with v, "
                    "v0 and v1 with u",
                    patch->name, edge_names[e], corner_names[k]);
            }
        }
    }
    return TAUT_OK;
}

static int has_plane(const taut_film_edge *edge)
{
    return edge->kind == TAUT_FILM_SLIDE || (edge->kind == TAUT_FILM_CABLE && edge->has_plane);
}

static taut_status hold_edge(taut_film_complex *c, const taut_film_side *side,
                             const taut_film_edge *edge, double gap, taut_error *error)
{
    const taut_film_problem *patch = &c->problem->patches[side->patch];

    for (int k = 0; has_plane(edge) && k < taut_film_complex_along(patch, side->edge); k++) {
        if (!add_plane(&c->holds[taut_film_complex_node(c, side, k)], &edge->plane, gap)) {
            char where[64];
            snprintf(where, sizeof where, "/patches/%d/edges/%s", side->patch,
                     edge_names[side->edge]);
            return taut_fail(error, TAUT_BAD_INPUT, "corner-conflict", where, taut_none, gap,
                             "an end of edge %.80s.%s is not in the plane of the edge", patch->name,
                             edge_names[side->edge]);
        }
    }
    return TAUT_OK;
}

/* Is the edge held whole? */
static int is_fixed(const taut_film_problem *problem, int p, int e)
{
    return problem->patches[p].edges[e].kind == TAUT_FILM_FIXED &&
           taut_film_complex_seam(problem, p, e) < 0;
}

static taut_status mark_fixed(taut_film_complex *c, int p, taut_error *error)
{
    const taut_film_problem *patch = &c->problem->patches[p];

    for (int e = 0; e < 4; e++) {
        const taut_film_side side = {p, e, 0};
        const int n = taut_film_complex_along(patch, e);
        for (int k = 0; is_fixed(c->problem, p, e) && k < n; k++) {
            const int node = taut_film_complex_node(c, &side, k);
            if ((k == 0 || k == n - 1) && c->holds[node].count < 3) {
                char where[64];
                snprintf(where, sizeof where, "/patches/%d/edges/%s", p, edge_names[e]);
                return taut_fail_expected(error, TAUT_BAD_INPUT, "corner-missing", where, taut_none,
                                          "corners that are held, or a curve",
                                          "edge %.80s.%s is held, and an end of it is not",
                                          patch->name, edge_names[e]);
            }
            c->fixed[node] = 1;
        }
    }
    return TAUT_OK;
}

double taut_film_complex_size(const taut_film_problem *problem)
{
    const double *first = NULL;
    double size = 0;

    for (int p = 0; p < problem->patch_count; p++) {
        const taut_film_problem *patch = &problem->patches[p];
        for (int k = 0; k < 4; k++) {
            first = first == NULL && patch->has_corner[k] ? patch->corners[k] : first;
            size = first != NULL && patch->has_corner[k]
                       ? fmax(size, taut_distance(patch->corners[k], first))
                       : size;
        }
        for (int e = 0; e < 4; e++) {
            const taut_curve *curve = patch->edges[e].curve;
            const int n = curve != NULL ? taut_basis_count(taut_curve_t(curve)) : 0;
            for (int k = 0; k < n; k++) {
                const double *x = taut_curve_points(curve) + 3 * k;
                first = first == NULL ? x : first;
                size = fmax(size, taut_distance(x, first));
            }
        }
    }
    return size;
}

static taut_status find_holds(taut_film_complex *c, taut_error *error)
{
    const taut_film_problem *problem = c->problem;
    const double size = taut_film_complex_size(problem), gap = gap_meeting * size;
    taut_status status = TAUT_OK;

    for (int p = 0; status == TAUT_OK && p < problem->patch_count; p++) {
        status = hold_corners(c, p, size, error);
    }
    for (int p = 0; status == TAUT_OK && p < problem->patch_count; p++) {
        status = hold_ends(c, p, gap, error);
    }
    for (int p = 0; status == TAUT_OK && p < problem->patch_count; p++) {
        for (int e = 0; status == TAUT_OK && e < 4; e++) {
            const taut_film_side side = {p, e, 0};
            status = hold_edge(c, &side, &problem->patches[p].edges[e], gap, error);
        }
    }
    for (int s = 0; status == TAUT_OK && s < problem->seam_count; s++) {
        status = hold_edge(c, &problem->seams[s].sides[0], &problem->seams[s].edge, gap, error);
    }
    for (int p = 0; status == TAUT_OK && p < problem->patch_count; p++) {
        status = mark_fixed(c, p, error);
    }
    return status;
}

/* Does a cable or an edge that is held end at a node? */
static int has_end(const taut_film_complex *c, int node)
{
    int has = c->fixed[node];
    for (int k = 0; k < c->strand_count; k++) {
        const taut_film_side *side = &c->strands[k].side;
        const int last = taut_film_complex_along(&c->problem->patches[side->patch], side->edge) - 1;
        has |= taut_film_complex_node(c, side, 0) == node ||
               taut_film_complex_node(c, side, last) == node;
    }
    return has;
}

/* A pole that is held alone holds nothing, and one that two cables of its patch meet in is drawn straight. */
static taut_status check_poles(const taut_film_complex *c, taut_error *error)
{
    for (int k = 0; k < 4 * c->problem->patch_count; k++) {
        const int p = k / 4, e = k % 4;
        const taut_film_problem *patch = &c->problem->patches[p];
        const int node = taut_film_complex_corner(c, p, taut_film_edge_corner(e, 0));
        const taut_film_edge *beside = &patch->edges[e < 2 ? 2 : 0];
        char where[64];
        snprintf(where, sizeof where, "/patches/%d/edges/%s", p, edge_names[e]);
        if (patch->edges[e].kind != TAUT_FILM_POLE) {
            continue;
        }
        if (c->holds[node].count == 0 && beside[0].kind == TAUT_FILM_CABLE &&
            beside[1].kind == TAUT_FILM_CABLE) {
            return taut_fail(error, TAUT_NO_SOLUTION, "no-corner", where, taut_none, taut_none,
                             "the two cables that meet in the free pole %.80s.%s draw it straight, "
                             "and it is no corner: hold it, or keep it on a line or in a plane",
                             patch->name, edge_names[e]);
        }
        if (c->holds[node].count == 3 && !has_end(c, node)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "point-support", where, taut_none, taut_none,
                             "the pole %.80s.%s is held, and neither a cable nor an edge that is "
                             "held ends there: a point holds no film: use a ring, or cables that "
                             "end there",
                             patch->name, edge_names[e]);
        }
    }
    return TAUT_OK;
}

/* Do all holds together leave a translation? */
static taut_status check_support(const taut_film_complex *c, taut_error *error)
{
    taut_film_hold all = {.count = 0};

    for (int a = 0; a < c->nodes; a++) {
        for (int k = 0; k < c->holds[a].count; k++) {
            (void)taut_film_hold_add(&all, c->holds[a].normals[k], 0, INFINITY);
        }
    }
    for (int k = 0; all.count < 3 && k < 3; k++) {
        const double axis[3] = {k == 0, k == 1, k == 2};
        const int before = all.count;
        (void)taut_film_hold_add(&all, axis, 0, INFINITY);
        if (all.count > before) {
            const double *free = all.normals[before];
            return taut_fail(error, TAUT_NO_SOLUTION, "floating", "/patches", before, 3,
                             "nothing holds the film along (%.6g, %.6g, %.6g): hold a corner or an "
                             "edge",
                             free[0], free[1], free[2]);
        }
    }
    return TAUT_OK;
}

/* ---- what moves how ---- */

/* Cables of one force are of one kind, as edges of one cable are: where two end in a vertex and nothing else does, it may lie anywhere
 * along them. */
static int cable_kind(const taut_film_complex *c, const taut_film_edge *edge)
{
    int k = 0, first = 0;

    while (c->strands[k].edge != edge) {
        k++;
    }
    const taut_film_edge *law = c->ropes[c->strands[k].rope].edge;
    while (first < c->strands[k].rope &&
           !(law->law == TAUT_FILM_FORCE && c->ropes[first].edge->law == TAUT_FILM_FORCE &&
             c->ropes[first].edge->force == law->force)) {
        first++;
    }
    return 1000 + first;
}

/* What kind of line the edge of a side is, or 0: of one number run on into each other. */
static int line_kind(const taut_film_complex *c, int p, int e)
{
    const taut_film_edge *edge = &c->problem->patches[p].edges[e];
    const int s = taut_film_complex_seam(c->problem, p, e);

    if (s >= 0) {
        const taut_film_seam *seam = &c->problem->seams[s];
        return seam->edge.kind == TAUT_FILM_CABLE ? cable_kind(c, &seam->edge)
               : seam->count > 2                  ? 2
                                                  : 0;
    }
    return edge->kind == TAUT_FILM_CABLE   ? cable_kind(c, edge)
           : edge->kind == TAUT_FILM_SLIDE ? 3
                                           : 0;
}

static void mark_line(taut_film_complex *c, int p, int e, int *ends, int *kinds)
{
    const int kind = line_kind(c, p, e), n = taut_film_complex_along(&c->problem->patches[p], e);
    const int s = taut_film_complex_seam(c->problem, p, e);
    const taut_film_side side = {p, e, 0};
    const taut_film_side *first = s >= 0 ? &c->problem->seams[s].sides[0] : &side;

    if (kind == 0 || first->patch != p || first->edge != e) {
        return; /* of a seam the first edge speaks */
    }
    for (int k = 0; k < n; k++) {
        const int node = taut_film_complex_node(c, &side, k);
        const int is_end = k == 0 || k == n - 1;
        c->line[node] = side;
        c->at[node] = k;
        if (!is_end) {
            c->kind[node] = TAUT_FILM_NODE_LINE;
        } else {
            kinds[node] = ends[node] == 0 || kinds[node] == kind ? kind : -1;
            ends[node]++;
        }
    }
}

static taut_status find_kinds(taut_film_complex *c, taut_arena *arena)
{
    int *ends = taut_arena_take(arena, (size_t)c->nodes, sizeof(int));
    int *kinds = taut_arena_take(arena, (size_t)c->nodes, sizeof(int));

    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    memset(c->kind, TAUT_FILM_NODE_INSIDE, (size_t)c->nodes);
    for (int p = 0; p < c->problem->patch_count; p++) {
        for (int e = 0; e < 4; e++) {
            mark_line(c, p, e, ends, kinds);
        }
    }
    for (int a = 0; a < c->nodes; a++) {
        if (ends[a] > 0) {
            c->kind[a] = ends[a] == 2 && kinds[a] > 0 ? TAUT_FILM_NODE_LINE : TAUT_FILM_NODE_VERTEX;
        }
        c->kind[a] = c->fixed[a] || c->holds[a].count == 3 ? TAUT_FILM_NODE_HELD : c->kind[a];
    }
    return TAUT_OK;
}

static taut_status find_strands(taut_film_complex *c, taut_arena *arena)
{
    const taut_film_problem *problem = c->problem;

    c->strands = taut_arena_take(
        arena, 4 * (size_t)problem->patch_count + (size_t)problem->seam_count, sizeof *c->strands);
    if (c->strands == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int p = 0; p < problem->patch_count; p++) {
        for (int e = 0; e < 4; e++) {
            if (problem->patches[p].edges[e].kind == TAUT_FILM_CABLE) {
                c->strands[c->strand_count++] =
                    (taut_film_strand){{p, e, 0}, &problem->patches[p].edges[e], -1, -1};
            }
        }
    }
    for (int s = 0; s < problem->seam_count; s++) {
        if (problem->seams[s].edge.kind == TAUT_FILM_CABLE) {
            taut_film_side side = problem->seams[s].sides[0];
            side.reversed = 0;
            c->strands[c->strand_count++] =
                (taut_film_strand){side, &problem->seams[s].edge, s, -1};
        }
    }
    return TAUT_OK;
}

taut_status taut_film_complex_new(const taut_film_problem *problem, taut_arena *arena,
                                  taut_film_complex *complex, taut_error *error)
{
    taut_film_complex *const c = complex;
    taut_status status = TAUT_OK;

    *c = (taut_film_complex){.problem = problem};
    for (int s = 0; status == TAUT_OK && s < problem->seam_count; s++) {
        status = check_seam(problem, s, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    c->first = taut_arena_take(arena, (size_t)problem->patch_count + 1, sizeof(int));
    if (c->first == NULL) {
        return taut_fail_memory(error);
    }
    for (int p = 0; p < problem->patch_count; p++) {
        c->first[p] = c->points;
        c->points +=
            taut_basis_count(problem->patches[p].u) * taut_basis_count(problem->patches[p].v);
    }
    c->first[problem->patch_count] = c->points;
    if (find_nodes(c, arena) != TAUT_OK || find_strands(c, arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = taut_film_ropes_find(c, arena, error);
    if (status != TAUT_OK) {
        return status;
    }
    c->kind = taut_arena_take(arena, (size_t)c->nodes, 1);
    c->fixed = taut_arena_take(arena, (size_t)c->nodes, 1);
    c->line = taut_arena_take(arena, (size_t)c->nodes, sizeof *c->line);
    c->at = taut_arena_take(arena, (size_t)c->nodes, sizeof(int));
    c->holds = taut_arena_take(arena, (size_t)c->nodes, sizeof *c->holds);
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = find_holds(c, error);
    if (status == TAUT_OK) {
        status = check_support(c, error);
    }
    if (status == TAUT_OK) {
        status = check_poles(c, error);
    }
    if (status == TAUT_OK) {
        status = taut_film_ropes_check(c, error);
    }
    if (status == TAUT_OK && find_kinds(c, arena) != TAUT_OK) {
        status = taut_fail_memory(error);
    }
    return status;
}
