#include "construct/film/complex/parting.h"

#include "construct/film/cone.h"
#include "construct/film/edges.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "taut/operations.h"

#include <math.h>
#include <string.h>

enum { SWEEPS = 2000, REFINEMENTS = 6 };
static const double swept = 1e-6; /* of a share */

/* ---- rims ---- */

static int is_fixed(const taut_film_problem *problem, int p, int e)
{
    return problem->patches[p].edges[e].kind == TAUT_FILM_FIXED &&
           taut_film_complex_seam(problem, p, e) < 0;
}

/* Of mirrors the film goes on beyond. */
static int is_slide(const taut_film_problem *problem, int p, int e)
{
    const taut_film_edge *edge = &problem->patches[p].edges[e];
    return edge->kind == TAUT_FILM_SLIDE && !edge->is_mirror;
}

typedef int is_rim(const taut_film_problem *problem, int p, int e);

/* The smallest of the labels of the nodes of an edge, to all of them. Did one change? */
static int join_edge(const taut_film_complex *c, int p, int e, int *label)
{
    const taut_film_side side = {p, e, 0};
    const int n = taut_film_complex_along(&c->problem->patches[p], e);
    int least = c->nodes, changed = 0;

    for (int k = 0; k < n; k++) {
        const int node = taut_film_complex_node(c, &side, k);
        const int now = label[node] >= 0 ? label[node] : node;
        least = now < least ? now : least;
    }
    for (int k = 0; k < n; k++) {
        const int node = taut_film_complex_node(c, &side, k);
        changed |= label[node] != least;
        label[node] = least;
    }
    return changed;
}

/* label: of nodes of such edges the least node of what they join, -1 of the others. */
static void join_edges(const taut_film_complex *c, is_rim *is_one, int *label)
{
    int changed = 1;

    for (int a = 0; a < c->nodes; a++) {
        label[a] = -1;
    }
    while (changed) {
        changed = 0;
        for (int k = 0; k < 4 * c->problem->patch_count; k++) {
            if (is_one(c->problem, k / 4, k % 4)) {
                changed |= join_edge(c, k / 4, k % 4, label);
            }
        }
    }
}

/* Labels become rims from `first` on; how many there are then. Labels on nodes of a rim are none of another. */
static int take_rims(const taut_film_complex *c, const int *label, int first, signed char *rim)
{
    int count = first;

    for (int a = 0; a < c->nodes && count < 3; a++) {
        if (label[a] == a) {
            int is_free = 1;
            for (int b = a; b < c->nodes; b++) {
                is_free &= label[b] != a || rim[b] < 0;
            }
            for (int b = a; is_free && b < c->nodes; b++) {
                rim[b] = label[b] == a ? (signed char)count : rim[b];
            }
            count += is_free;
        }
    }
    return count;
}

static void find_way(const taut_film_layout *l, taut_film_parting *parting)
{
    int counts[2] = {0, 0};
    double sums[2][3] = {{0, 0, 0}, {0, 0, 0}};

    for (int a = 0; a < l->complex.nodes; a++) {
        const int r = parting->rim[a];
        if (r >= 0) {
            taut_add_scaled(1, l->start + 3 * a, sums[r]);
            counts[r]++;
        }
    }
    for (int k = 0; k < 3; k++) {
        parting->way[k] = sums[1][k] / counts[1] - sums[0][k] / counts[0];
    }
}

/* One sweep over the nodes of all nets; the most that a share changed by. */
static double even_shares(const taut_film_complex *c, const taut_film_parting *parting,
                          double *sums)
{
    double most = 0;

    memset(sums, 0, 2 * (size_t)c->nodes * sizeof(double));
    for (int p = 0; p < c->problem->patch_count; p++) {
        const taut_film_problem *patch = &c->problem->patches[p];
        const int nu = taut_basis_count(patch->u), nv = taut_basis_count(patch->v);
        const int *node = c->node + c->first[p];
        for (int k = 0; k < nu * nv; k++) {
            for (int way = 0; way < 2; way++) {
                const int next = way == 0 ? k + nv : k + 1;
                if (way == 0 ? next < nu * nv : next % nv != 0) {
                    const int a = node[k], b = node[next];
                    sums[2 * a] += parting->share[b];
                    sums[2 * b] += parting->share[a];
                    sums[2 * a + 1]++;
                    sums[2 * b + 1]++;
                }
            }
        }
    }
    for (int a = 0; a < c->nodes; a++) {
        if (parting->rim[a] < 0 && sums[2 * a + 1] > 0) {
            const double now = sums[2 * a] / sums[2 * a + 1];
            most = fmax(most, fabs(now - parting->share[a]));
            parting->share[a] = now;
        }
    }
    return most;
}

/* Is a corner held that no rim has? */
static int has_other(const taut_film_complex *c, const taut_film_parting *parting)
{
    for (int a = 0; a < c->nodes; a++) {
        if (c->holds[a].count == 3 && parting->rim[a] < 0) {
            return 1;
        }
    }
    return 0;
}

taut_status taut_film_parting_new(const taut_film_layout *layout, taut_arena *arena,
                                  taut_film_parting *parting)
{
    const taut_film_complex *c = &layout->complex;
    const size_t nodes = (size_t)c->nodes;
    int *label = taut_arena_take(arena, nodes, sizeof(int));

    *parting = (taut_film_parting){.rim = taut_arena_take(arena, nodes, 1)};
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    memset(parting->rim, -1, nodes);
    join_edges(c, is_fixed, label);
    parting->count = take_rims(c, label, 0, parting->rim);
    if (parting->count == 1) {
        join_edges(c, is_slide, label);
        parting->count = take_rims(c, label, 1, parting->rim);
        parting->slides = 1;
    }
    if (parting->count != 2 || c->problem->cell_count > 0 || has_other(c, parting)) {
        parting->count = 0;
        return TAUT_OK;
    }
    find_way(layout, parting);
    return TAUT_OK;
}

taut_status taut_film_parting_spread(const taut_film_layout *layout, taut_arena *arena,
                                     taut_film_parting *parting)
{
    const taut_film_complex *c = &layout->complex;
    double *sums = taut_arena_take(arena, (size_t)c->nodes, 2 * sizeof(double));

    parting->share = taut_arena_take(arena, (size_t)c->nodes, sizeof(double));
    parting->class = taut_arena_take(arena, 2 * (size_t)c->problem->patch_count, sizeof(int));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int a = 0; a < c->nodes; a++) {
        parting->share[a] = parting->rim[a] >= 0 ? parting->rim[a] : 0.5;
    }
    for (int k = 0; k < SWEEPS && even_shares(c, parting, sums) > swept; k++) {
    }
    return TAUT_OK;
}

/* ---- the cone ---- */

/* Is it one film of one tension, of sheets that are joined two by two, between edges that are held? */
static int is_plain(const taut_film_layout *l, unsigned char *seen)
{
    const taut_film_problem *problem = l->complex.problem;
    int reached = 1, grows = 1;

    for (int k = 0; k < 4 * problem->patch_count; k++) {
        const taut_film_edge_kind kind = problem->patches[k / 4].edges[k % 4].kind;
        if (kind != TAUT_FILM_FIXED || l->tensions[k / 4] != l->tensions[0] ||
            taut_film_has_density(&problem->patches[k / 4])) {
            return 0;
        }
    }
    for (int s = 0; s < problem->seam_count; s++) {
        if (problem->seams[s].count != 2 || problem->seams[s].edge.kind == TAUT_FILM_CABLE) {
            return 0;
        }
    }
    seen[0] = 1;
    while (grows) {
        grows = 0;
        for (int s = 0; s < problem->seam_count; s++) {
            const int a = problem->seams[s].sides[0].patch, b = problem->seams[s].sides[1].patch;
            if (seen[a] != seen[b]) {
                seen[a] = seen[b] = 1;
                reached++;
                grows = 1;
            }
        }
    }
    return reached == problem->patch_count;
}

/* An edge that is held, in the user's unit. */
static taut_status take_curve(const taut_film_layout *l, int p, int e, taut_arena *arena,
                              taut_curve **curve)
{
    const taut_film_complex *c = &l->complex;
    const taut_film_problem *patch = &c->problem->patches[p];
    const taut_film_side side = {p, e, 0};
    const int n = taut_film_complex_along(patch, e);
    double *row = taut_arena_take(arena, (size_t)n, 3 * sizeof(double));

    if (row == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < n; k++) {
        memcpy(row + 3 * k, l->points + 3 * taut_film_complex_node(c, &side, k),
               3 * sizeof(double));
    }
    return taut_curve_new(NULL, e < 2 ? patch->v : patch->u, row, NULL, curve, NULL);
}

/* Points of an edge whose spans are halved until they lie near it, appended to a rim. */
static taut_status add_points(const taut_film_layout *l, int p, int e, taut_arena *arena,
                              taut_film_rims *rims, int r)
{
    taut_curve *curve = NULL;
    taut_status status = take_curve(l, p, e, arena, &curve);

    for (int k = 0; k < REFINEMENTS && status == TAUT_OK; k++) {
        taut_curve *fine = NULL;
        status = taut_curve_refine(curve, &fine, NULL);
        if (status == TAUT_OK) {
            taut_curve_free(curve);
            curve = fine;
        }
    }
    if (status == TAUT_OK) {
        const int more = taut_basis_count(taut_curve_t(curve)), before = rims->count[r];
        double *both = taut_arena_take(arena, (size_t)(before + more), 3 * sizeof(double));
        status = both == NULL ? TAUT_NO_MEMORY : TAUT_OK;
        if (both != NULL) {
            if (before > 0) {
                memcpy(both, rims->points[r], 3 * (size_t)before * sizeof(double));
            }
            memcpy(both + 3 * before, taut_curve_points(curve), 3 * (size_t)more * sizeof(double));
            rims->points[r] = both;
            rims->count[r] += more;
        }
    }
    taut_curve_free(curve);
    return status;
}

static taut_status take_points(const taut_film_layout *l, const taut_film_parting *parting,
                               taut_arena *arena, taut_film_rims *rims)
{
    const taut_film_complex *c = &l->complex;
    taut_status status = TAUT_OK;

    for (int k = 0; status == TAUT_OK && k < 4 * c->problem->patch_count; k++) {
        if (is_fixed(c->problem, k / 4, k % 4)) {
            const taut_film_side side = {k / 4, k % 4, 0};
            status = add_points(l, k / 4, k % 4, arena, rims,
                                parting->rim[taut_film_complex_node(c, &side, 0)]);
        }
    }
    return status;
}

static void find_middles(const taut_film_rims *rims, double middles[6])
{
    memset(middles, 0, 6 * sizeof(double));
    for (int r = 0; r < 2; r++) {
        for (int k = 0; k < rims->count[r]; k++) {
            taut_add_scaled(1.0 / rims->count[r], rims->points[r] + 3 * k, middles + 3 * r);
        }
    }
}

taut_status taut_film_parting_check(const taut_film_layout *layout,
                                    const taut_film_parting *parting, taut_arena *arena,
                                    taut_error *error)
{
    unsigned char *seen = taut_arena_take(arena, (size_t)layout->complex.problem->patch_count, 1);
    taut_film_rims rims = {.height = 0};
    double axis[6];

    if (seen == NULL) {
        return TAUT_NO_MEMORY;
    }
    if (parting->count != 2 || parting->slides || !is_plain(layout, seen)) {
        return TAUT_OK;
    }
    if (take_points(layout, parting, arena, &rims) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    find_middles(&rims, axis);
    taut_add_scaled(-1, axis, axis + 3);
    return taut_film_cone_widest(&rims, axis) > 0
               ? taut_film_cone_refuse(&rims, 9, "/patches", error)
               : TAUT_OK;
}

taut_status taut_film_parting_discs(const taut_film_layout *layout,
                                    const taut_film_parting *parting, taut_arena *arena,
                                    double *area)
{
    const taut_film_complex *c = &layout->complex;
    unsigned char *seen = taut_arena_take(arena, (size_t)c->problem->patch_count, 1);
    taut_film_rims rims = {.height = 0};
    double tips[6];
    taut_status status = seen != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    *area = 0;
    if (status != TAUT_OK || parting->count != 2 || parting->slides || !is_plain(layout, seen)) {
        return status;
    }
    status = take_points(layout, parting, arena, &rims);
    find_middles(&rims, tips);
    for (int k = 0; status == TAUT_OK && k < 4 * c->problem->patch_count; k++) {
        if (is_fixed(c->problem, k / 4, k % 4)) {
            const taut_film_side side = {k / 4, k % 4, 0};
            taut_curve *curve = NULL;
            status = take_curve(layout, k / 4, k % 4, arena, &curve);
            if (status == TAUT_OK) {
                *area += taut_film_cone_area(
                    curve, tips + 3 * parting->rim[taut_film_complex_node(c, &side, 0)]);
            }
            taut_curve_free(curve);
        }
    }
    return status;
}

/* ---- the neck ---- */

/* The shortest line of a patch along u (way 1) or v (way 0); of the first and last alone where `ends` says so. */
static double shortest_line(const taut_film_complex *c, const double *x, int p, int way, int ends)
{
    const taut_film_problem *patch = &c->problem->patches[p];
    const int nu = taut_basis_count(patch->u), nv = taut_basis_count(patch->v);
    const int lines = way == 1 ? nv : nu, along = way == 1 ? nu : nv;
    const int *node = c->node + c->first[p];
    double shortest = INFINITY;

    for (int k = 0; k < lines; k += ends ? lines - 1 : 1) {
        double length = 0;
        for (int i = 1; i < along; i++) {
            const int a = way == 1 ? (i - 1) * nv + k : k * nv + i - 1,
                      b = way == 1 ? i * nv + k : k * nv + i;
            length += taut_distance(x + 3 * node[a], x + 3 * node[b]);
        }
        shortest = fmin(shortest, length);
    }
    return shortest;
}

double taut_film_parting_neck(const taut_film_layout *layout, const double *x, int *class)
{
    const taut_film_complex *c = &layout->complex;
    const int count = 2 * c->problem->patch_count;
    double neck = INFINITY;

    taut_film_strips(c->problem, class);
    for (int k = 0; k < count; k++) {
        double now = 0, start = 0;
        for (int other = 0; other < count; other++) {
            if (class[other] == class[k]) {
                now += shortest_line(c, x, other / 2, 1 - other % 2, 0);
                start += shortest_line(c, layout->start, other / 2, 1 - other % 2, 1);
            }
        }
        neck = fmin(neck, now / start);
    }
    return neck;
}
