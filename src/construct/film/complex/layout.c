#include "construct/film/complex/layout.h"

#include "construct/common/curve_fit.h"
#include "construct/film/edges.h"
#include "construct/film/greville.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "problem/film_cells.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SWEEPS = 1000 };
static const double swept = 1e-4;      /* of the longest edge */
static const double no_length = 1e-12; /* of the longest, squared */
static const double gap_held = 1e-9;   /* of the size: a held point and the start's */

/* ---- corners ---- */

/* Where corners are held or said to be near. */
static void take_given(taut_film_layout *l, unsigned char *is_set)
{
    const taut_film_complex *c = &l->complex;

    for (int p = 0; p < c->problem->patch_count; p++) {
        const taut_film_problem *patch = &c->problem->patches[p];
        for (int k = 0; k < 4; k++) {
            const int node = taut_film_complex_corner(c, p, k);
            if (c->holds[node].count == 3) {
                taut_film_hold_onto(&c->holds[node], l->points + 3 * node);
                is_set[node] = 1;
            } else if (patch->has_corner[k] && !is_set[node]) {
                memcpy(l->points + 3 * node, patch->corners[k], 3 * sizeof(double));
                is_set[node] = 1;
            }
        }
    }
}

/* One round: corners that are not set, at the mean of those set that their edges lead to. How many were set. */
static int take_means(taut_film_layout *l, unsigned char *is_set, double *sums, int *counts)
{
    const taut_film_complex *c = &l->complex;
    int set = 0;

    memset(sums, 0, 3 * (size_t)c->nodes * sizeof(double));
    memset(counts, 0, (size_t)c->nodes * sizeof(int));
    for (int p = 0; p < c->problem->patch_count; p++) {
        for (int k = 0; k < 4; k++) {
            const int node = taut_film_complex_corner(c, p, k);
            for (int way = 1; way <= 2; way++) {
                const int other = taut_film_complex_corner(c, p, k ^ way);
                if (!is_set[node] && is_set[other]) {
                    taut_add_scaled(1, l->points + 3 * other, sums + 3 * node);
                    counts[node]++;
                }
            }
        }
    }
    for (int a = 0; a < c->nodes; a++) {
        if (counts[a] > 0) {
            for (int k = 0; k < 3; k++) {
                l->points[3 * a + k] = sums[3 * a + k] / counts[a];
            }
            is_set[a] = 1;
            set++;
        }
    }
    return set;
}

static int is_closed(const taut_film_complex *c, int p, int e)
{
    return taut_film_complex_corner(c, p, taut_film_edge_corner(e, 0)) ==
           taut_film_complex_corner(c, p, taut_film_edge_corner(e, 1));
}

/* Poles of rings of one patch, whose corners are all one with the ends of the curve. */
static void take_poles(taut_film_layout *l, unsigned char *is_set)
{
    const taut_film_complex *c = &l->complex;

    for (int k = 0; k < 4 * c->problem->patch_count; k++) {
        const int p = k / 4, e = k % 4;
        const int node = taut_film_complex_corner(c, p, taut_film_edge_corner(e, 0));
        const taut_curve *curve = c->problem->patches[p].edges[e ^ 1].curve;
        const int n = curve != NULL ? taut_basis_count(taut_curve_t(curve)) : 0;
        if (c->problem->patches[p].edges[e].kind != TAUT_FILM_POLE || is_set[node] ||
            !is_closed(c, p, e ^ 1)) {
            continue;
        }
        for (int i = 0; i < n; i++) {
            taut_add_scaled(1.0 / n, taut_curve_points(curve) + 3 * i, l->points + 3 * node);
        }
        is_set[node] = 1;
    }
}

void taut_film_strips(const taut_film_problem *problem, int *class)
{
    const int count = 2 * problem->patch_count;

    for (int k = 0; k < count; k++) {
        class[k] = k;
    }
    for (int s = 0; s < problem->seam_count; s++) {
        const taut_film_side *side = problem->seams[s].sides;
        for (int j = 1; j < problem->seams[s].count; j++) {
            const int one = class[2 * side[0].patch + side[0].edge / 2],
                      other = class[2 * side[j].patch + side[j].edge / 2];
            for (int k = 0; k < count; k++) {
                class[k] = class[k] == other ? one : class[k];
            }
        }
    }
}

/* weights[2 p + d]: 1 over the mean square of the lengths of the edges of patch p along v (d = 0) or u, and of all others of their
 * strip. 0: a strip has no length, because all its edges begin and end at one corner so far. */
static int find_weights(const taut_film_layout *l, int *class, double *weights)
{
    const int count = 2 * l->complex.problem->patch_count;
    double least = INFINITY, most = 0;

    taut_film_strips(l->complex.problem, class);
    for (int k = 0; k < count; k++) {
        double sum = 0;
        int edges = 0;
        for (int other = 0; other < count; other++) {
            for (int e = other % 2 * 2; class[other] == class[k] && e < other % 2 * 2 + 2; e++) {
                const taut_film_complex *c = &l->complex;
                const int a = taut_film_complex_corner(c, other / 2, taut_film_edge_corner(e, 0)),
                          b = taut_film_complex_corner(c, other / 2, taut_film_edge_corner(e, 1));
                const double length = taut_distance(l->points + 3 * a, l->points + 3 * b);
                sum += length * length;
                edges += length > 0;
            }
        }
        weights[k] = sum > 0 && isfinite(sum) ? edges / sum : 1;
        least = fmin(least, edges > 0 ? sum / edges : 0);
        most = fmax(most, edges > 0 ? sum / edges : 0);
    }
    return least > no_length * most;
}

/* One sweep: corners that move, at the weighted mean of those that their edges lead to. The longest way that one went, over the
 * longest edge. */
static double even_out(taut_film_layout *l, const unsigned char *is_given, const double *weights,
                       double *sums)
{
    const taut_film_complex *c = &l->complex;
    double longest = 0, size = 0;

    memset(sums, 0, 4 * (size_t)c->nodes * sizeof(double));
    for (int p = 0; p < c->problem->patch_count; p++) {
        for (int k = 0; k < 4; k++) {
            const int node = taut_film_complex_corner(c, p, k);
            for (int way = 1; way <= 2; way++) {
                const int other = taut_film_complex_corner(c, p, k ^ way);
                const double weight = weights[2 * p + (way == 1)];
                if (other != node) {
                    taut_add_scaled(weight, l->points + 3 * other, sums + 4 * node);
                    sums[4 * node + 3] += weight;
                }
                size = fmax(size, taut_distance(l->points + 3 * node, l->points + 3 * other));
            }
        }
    }
    for (int a = 0; a < c->nodes; a++) {
        if (sums[4 * a + 3] > 0 && !is_given[a]) {
            double x[3];
            for (int k = 0; k < 3; k++) {
                x[k] = sums[4 * a + k] / sums[4 * a + 3];
            }
            taut_film_hold_onto(&c->holds[a], x);
            longest = fmax(longest, taut_distance(x, l->points + 3 * a));
            memcpy(l->points + 3 * a, x, sizeof x);
        }
    }
    return size > 0 ? longest / size : 0;
}

/* Corners that are not given: means, from those that are given on; then all of them evened out, so that no patch is folded where
 * what holds them is convex (Tutte). */
static taut_status lay_corners(taut_film_layout *l, taut_arena *arena, taut_error *error)
{
    const taut_film_complex *c = &l->complex;
    const size_t nodes = (size_t)c->nodes, patches = (size_t)c->problem->patch_count;
    unsigned char *is_set = taut_arena_take(arena, nodes, 1);
    double *sums = taut_arena_take(arena, nodes, 4 * sizeof(double));
    int *counts = taut_arena_take(arena, nodes, sizeof(int));
    int *class = taut_arena_take(arena, patches, 2 * sizeof(int));
    double *weights = taut_arena_take(arena, patches, 2 * sizeof(double));

    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    take_given(l, is_set);
    take_poles(l, is_set);
    const unsigned char *is_given = taut_arena_copy(arena, is_set, nodes, 1);
    if (is_given == NULL) {
        return taut_fail_memory(error);
    }
    while (take_means(l, is_set, sums, counts) > 0) {
    }
    for (int p = 0; p < c->problem->patch_count; p++) {
        for (int k = 0; k < 4; k++) {
            const int node = taut_film_complex_corner(c, p, k);
            taut_film_hold_onto(&c->holds[node], l->points + 3 * node);
        }
    }
    if (!find_weights(l, class, weights)) {
        for (size_t k = 0; k < 2 * patches; k++) {
            weights[k] = 1;
        }
        for (int k = 0; k < SWEEPS && even_out(l, is_given, weights, sums) > swept; k++) {
        }
        (void)find_weights(l, class, weights);
    }
    for (int k = 0; k < SWEEPS && even_out(l, is_given, weights, sums) > swept; k++) {
    }
    return TAUT_OK;
}

/* ---- edges ---- */

static taut_status fit_edge(taut_film_layout *l, const taut_film_side *side,
                            const taut_basis *basis, double *row, taut_error *error)
{
    const taut_film_complex *c = &l->complex;
    const taut_curve *curve = c->problem->patches[side->patch].edges[side->edge].curve;
    const int n = taut_basis_count(basis);
    double ends[2][3], deviation = 0;

    if (taut_basis_equal(taut_curve_t(curve), basis) && taut_curve_weights(curve) == NULL) {
        memcpy(row, taut_curve_points(curve), 3 * (size_t)n * sizeof(double));
        return TAUT_OK;
    }
    for (int end = 0; end < 2; end++) {
        memcpy(ends[end], l->points + 3 * taut_film_complex_node(c, side, end * (n - 1)),
               sizeof ends[end]);
    }
    const taut_status status =
        taut_curve_fit(curve, basis, (const double(*)[3])ends, row, &deviation);
    l->deviation = fmax(l->deviation, deviation);
    l->fitted++;
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error)
           : status == TAUT_OK
               ? status
               : taut_fail(error, TAUT_NOT_CONVERGED, "curve-fit", "/patches", taut_none, taut_none,
                           "the curve of an edge of patch %.80s cannot be fitted to its basis: the "
                           "knots, the degree or the points are too extreme",
                           c->problem->patches[side->patch].name);
}

/* Does a closed edge begin as the one opposite to it? */
static int has_model(const taut_film_complex *c, int p, int e)
{
    const taut_film_problem *patch = &c->problem->patches[p];
    return patch->edges[e].curve == NULL && patch->edges[e].kind != TAUT_FILM_POLE &&
           patch->edges[e ^ 1].curve != NULL && is_closed(c, p, e);
}

static taut_status lay_edge(taut_film_layout *l, int p, int e, taut_arena *arena, taut_error *error)
{
    const taut_film_complex *c = &l->complex;
    const taut_film_problem *patch = &c->problem->patches[p];
    const taut_basis *basis = e < 2 ? patch->v : patch->u;
    const taut_film_side side = {p, e, 0};
    const int n = taut_basis_count(basis);
    double *row = taut_arena_take(arena, (size_t)n, 3 * sizeof(double));
    double *at = taut_arena_take(arena, (size_t)n, sizeof(double));

    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (has_model(c, p, e)) {
        const taut_film_side model = {p, e ^ 1, 0};
        for (int k = 0; k < n; k++) {
            memcpy(row + 3 * k, l->points + 3 * taut_film_complex_node(c, &model, k),
                   3 * sizeof(double));
        }
    } else if (patch->edges[e].curve != NULL) {
        const taut_status status = fit_edge(l, &side, basis, row, error);
        if (status != TAUT_OK) {
            return status;
        }
    } else {
        const double *a = l->points + 3 * taut_film_complex_node(c, &side, 0),
                     *b = l->points + 3 * taut_film_complex_node(c, &side, n - 1);
        taut_film_greville(basis, at);
        for (int k = 0; k < n; k++) {
            for (int i = 0; i < 3; i++) {
                row[3 * k + i] = k == 0       ? a[i]
                                 : k == n - 1 ? b[i]
                                              : (1 - at[k]) * a[i] + at[k] * b[i];
            }
        }
    }
    for (int k = 1; k < n - 1; k++) {
        double *x = l->points + 3 * taut_film_complex_node(c, &side, k);
        memcpy(x, row + 3 * k, 3 * sizeof(double));
        if (c->kind[taut_film_complex_node(c, &side, k)] != TAUT_FILM_NODE_HELD) {
            taut_film_hold_onto(&c->holds[taut_film_complex_node(c, &side, k)], x);
        }
    }
    return TAUT_OK;
}

static int ends_move(const taut_film_complex *c, int p, int e)
{
    for (int end = 0; end < 2; end++) {
        if (c->holds[taut_film_complex_corner(c, p, taut_film_edge_corner(e, end))].count == 3) {
            return 0;
        }
    }
    return 1;
}

/* Does the edge begin straight, for want of something better? */
static int may_bow(const taut_film_complex *c, int p, int e)
{
    const taut_film_edge *edge = &c->problem->patches[p].edges[e];
    const int s = taut_film_complex_seam(c->problem, p, e);
    return s >= 0 ? c->problem->seams[s].edge.kind != TAUT_FILM_CABLE && !is_closed(c, p, e)
                  : (edge->kind == TAUT_FILM_SLIDE ||
                     (edge->kind == TAUT_FILM_CABLE && edge->has_plane && ends_move(c, p, e))) &&
                        !has_model(c, p, e);
}

/* bow: of held curves how far their points are from where those of their chords would be. Is there one? */
static int take_bows(const taut_film_layout *l, double *at, double *bow)
{
    const taut_film_complex *c = &l->complex;
    int found = 0;

    for (int k = 0; k < 4 * c->problem->patch_count; k++) {
        const taut_film_problem *patch = &c->problem->patches[k / 4];
        const taut_film_side side = {k / 4, k % 4, 0};
        const int n = taut_film_complex_along(patch, side.edge);
        if (patch->edges[side.edge].curve == NULL || is_closed(c, side.patch, side.edge)) {
            continue;
        }
        const double *a = l->points + 3 * taut_film_complex_node(c, &side, 0),
                     *b = l->points + 3 * taut_film_complex_node(c, &side, n - 1);
        taut_film_greville(side.edge < 2 ? patch->v : patch->u, at);
        for (int i = 1; i < n - 1; i++) {
            const int node = taut_film_complex_node(c, &side, i);
            for (int j = 0; j < 3; j++) {
                bow[3 * node + j] = l->points[3 * node + j] - (1 - at[i]) * a[j] - at[i] * b[j];
            }
        }
        found = 1;
    }
    return found;
}

/* One sweep: lines take the mean of what is opposite to them, across the chord where both have the same two ends. The most that one
 * changed by. */
static double even_bows(const taut_film_layout *l, double *bow, double *sums)
{
    const taut_film_complex *c = &l->complex;
    double most = 0;

    memset(sums, 0, 4 * (size_t)c->nodes * sizeof(double));
    for (int k = 0; k < 4 * c->problem->patch_count; k++) {
        const taut_film_side side = {k / 4, k % 4, 0}, other = {k / 4, k % 4 ^ 1, 0};
        const int n = taut_film_complex_along(&c->problem->patches[side.patch], side.edge);
        const int first = taut_film_complex_node(c, &side, 0),
                  last = taut_film_complex_node(c, &side, n - 1);
        double chord[3] = {0, 0, 0};
        if (first == taut_film_complex_node(c, &other, 0) &&
            last == taut_film_complex_node(c, &other, n - 1)) {
            taut_difference(l->points + 3 * last, l->points + 3 * first, chord);
        }
        const double square = taut_dot(chord, chord);
        for (int i = 1; may_bow(c, side.patch, side.edge) && i < n - 1; i++) {
            const double *from = bow + 3 * taut_film_complex_node(c, &other, i);
            double *sum = sums + 4 * taut_film_complex_node(c, &side, i);
            taut_add_scaled(1, from, sum);
            taut_add_scaled(square > 0 ? -taut_dot(from, chord) / square : 0, chord, sum);
            sum[3]++;
        }
    }
    for (int a = 0; a < c->nodes; a++) {
        for (int j = 0; sums[4 * a + 3] > 0 && j < 3; j++) {
            const double now = sums[4 * a + j] / sums[4 * a + 3];
            most = fmax(most, fabs(now - bow[3 * a + j]));
            bow[3 * a + j] = now;
        }
    }
    return most;
}

/* Lines between held curves begin as curved as these. */
static taut_status bow_edges(taut_film_layout *l, taut_arena *arena, taut_error *error)
{
    const taut_film_complex *c = &l->complex;
    double *bow = taut_arena_take(arena, (size_t)c->nodes, 3 * sizeof(double));
    double *sums = taut_arena_take(arena, (size_t)c->nodes, 4 * sizeof(double));
    double *at = taut_arena_take(arena, (size_t)c->points, sizeof(double));

    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (!take_bows(l, at, bow)) {
        return TAUT_OK;
    }
    const double size = taut_film_complex_size(c->problem);
    for (int k = 0; k < SWEEPS && even_bows(l, bow, sums) > swept * size; k++) {
    }
    for (int a = 0; a < c->nodes; a++) {
        if (sums[4 * a + 3] > 0) {
            taut_add_scaled(1, bow + 3 * a, l->points + 3 * a);
            taut_film_hold_onto(&c->holds[a], l->points + 3 * a);
        }
    }
    return TAUT_OK;
}

/* The net of Coons. */
static taut_status fill_patch(taut_film_layout *l, int p, taut_arena *arena, taut_error *error)
{
    const taut_film_complex *c = &l->complex;
    const taut_film_problem *patch = &c->problem->patches[p];
    const int nu = taut_basis_count(patch->u), nv = taut_basis_count(patch->v);
    const int *node = c->node + c->first[p];
    double *at_u = taut_arena_take(arena, (size_t)nu, sizeof(double));
    double *at_v = taut_arena_take(arena, (size_t)nv, sizeof(double));

    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_film_greville(patch->u, at_u);
    taut_film_greville(patch->v, at_v);
    for (int i = 1; i < nu - 1; i++) {
        for (int j = 1; j < nv - 1; j++) {
            const double a = at_u[i], b = at_v[j];
            const int at[8] = {j, (nu - 1) * nv + j, i * nv, i * nv + nv - 1,
                               0, (nu - 1) * nv,     nv - 1, nu * nv - 1};
            const double share[8] = {
                1 - a, a, 1 - b, b, -(1 - a) * (1 - b), -a * (1 - b), -(1 - a) * b, -a * b};
            double *x = l->points + 3 * node[i * nv + j];
            memset(x, 0, 3 * sizeof(double));
            for (int k = 0; k < 8; k++) {
                taut_add_scaled(share[k], l->points + 3 * node[at[k]], x);
            }
        }
    }
    return TAUT_OK;
}

/* ---- a start that is given ---- */

/* Points of a patch, NaN where none is given: of nodes that are held where they are, of others from there on, by the first patch
 * that has them. */
static taut_status take_start(taut_film_layout *l, int p, double gap, unsigned char *seen,
                              taut_error *error)
{
    const taut_film_complex *c = &l->complex;
    const double *start = c->problem->patches[p].start;
    const int first = c->first[p], count = start != NULL ? c->first[p + 1] - first : 0;

    for (int k = 0; k < count; k++) {
        const int node = c->node[first + k];
        const double *given = start + 3 * k;
        double x[3] = {given[0], given[1], given[2]};
        if (!isfinite(taut_norm(given))) {
            continue;
        }
        if (c->kind[node] == TAUT_FILM_NODE_HELD) {
            memcpy(x, l->points + 3 * node, sizeof x);
        } else {
            taut_film_hold_onto(&c->holds[node], x);
        }
        const double away = taut_distance(x, given);
        if (!(away <= gap)) {
            const int nv = taut_basis_count(c->problem->patches[p].v);
            return taut_fail(error, TAUT_BAD_INPUT, "start", "/start", away, gap,
                             "point (%d, %d) of the start of patch %.80s is %.3g away from what "
                             "holds the film there, expected at most %.3g",
                             k / nv, k % nv, c->problem->patches[p].name, away, gap);
        }
        if (!seen[node]) {
            memcpy(l->points + 3 * node, x, sizeof x);
            seen[node] = 1;
        }
    }
    return TAUT_OK;
}

static taut_status take_starts(taut_film_layout *l, taut_arena *arena, taut_error *error)
{
    const taut_film_problem *problem = l->complex.problem;
    const double gap = gap_held * taut_film_complex_size(problem);
    unsigned char *seen = taut_arena_take(arena, (size_t)l->complex.nodes, 1);
    taut_status status = seen != NULL ? TAUT_OK : taut_fail_memory(error);

    for (int p = 0; status == TAUT_OK && p < problem->patch_count; p++) {
        status = take_start(l, p, gap, seen, error);
    }
    return status;
}

/* ---- forces ---- */

static taut_status take_forces(taut_film_layout *l, taut_error *error)
{
    const taut_film_complex *c = &l->complex;

    for (int p = 0; p < c->problem->patch_count; p++) {
        l->tensions[p] = taut_film_tension(&c->problem->patches[p]);
    }
    return taut_film_laws_find(c, &l->scaling, l->points, l->tensions, l->drawn, error);
}

static taut_status take_cells(taut_film_layout *l, taut_error *error)
{
    const taut_film_problem *problem = l->complex.problem;
    const int unit = l->scaling.outer + l->scaling.inner;

    for (int k = 0; k < problem->cell_count; k++) {
        const taut_film_cell *cell = &problem->cells[k];
        const double given = cell->has_volume ? ldexp(cell->volume, -3 * unit)
                                              : ldexp(cell->pressure / l->tensions[0], unit);
        char where[48];
        taut_scaling_apply(&l->scaling, 1, cell->from, NULL, l->from + 3 * k);
        (cell->has_volume ? l->volumes : l->pressures)[k] = given;
        snprintf(where, sizeof where, "/cells/%d/%s", k, cell->has_volume ? "volume" : "pressure");
        if (fabs(given) > TAUT_FILM_FORCE_MAX ||
            (cell->has_volume && fabs(given) < 1 / TAUT_FILM_FORCE_MAX) ||
            !(taut_norm(l->from + 3 * k) <= TAUT_FILM_FORCE_MAX)) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", where, given, taut_none,
                             "the %s of a cell is %.3g in the film's %s, or its \"from\" is far "
                             "from the film: expected 1e-6 to 1e6",
                             cell->has_volume ? "volume" : "pressure", given,
                             cell->has_volume ? "size cubed" : "tension over its size");
        }
    }
    return TAUT_OK;
}

static taut_status check_area(const taut_film_layout *l, taut_error *error)
{
    const taut_film_complex *c = &l->complex;

    for (int p = 0; p < c->problem->patch_count; p++) {
        int equal = 0;
        double size = 0;
        for (int k = 0; k < 4; k++) {
            size = fmax(size, taut_distance(l->points + 3 * taut_film_complex_corner(c, p, k),
                                            l->points + 3 * taut_film_complex_corner(c, p, k ^ 3)));
        }
        for (int e = 0; e < 4; e++) {
            const int a = taut_film_edge_corner(e, 0), b = taut_film_edge_corner(e, 1);
            equal +=
                c->problem->patches[p].edges[e].kind != TAUT_FILM_POLE &&
                c->problem->patches[p].edges[e].curve == NULL && !has_model(c, p, e) &&
                !(taut_distance(l->points + 3 * taut_film_complex_corner(c, p, a),
                                l->points + 3 * taut_film_complex_corner(c, p, b)) > 1e-9 * size);
        }
        if (equal > 0 || size == 0) {
            char where[64];
            snprintf(where, sizeof where, "/patches/%d/corners", p);
            return taut_fail(
                error, TAUT_NO_SOLUTION, "no-area", where, equal, 0,
                "two corners of patch %.80s are one and no pole, or start as one: give "
                "corners that differ, or say where they are near",
                c->problem->patches[p].name);
        }
    }
    return TAUT_OK;
}

taut_status taut_film_layout_new(const taut_film_problem *problem, taut_arena *arena,
                                 taut_film_layout *layout, taut_error *error)
{
    taut_film_layout *const l = layout;
    *l = (taut_film_layout){.fitted = 0};
    taut_status status = taut_film_complex_new(problem, arena, &l->complex, error);
    const taut_film_complex *c = &l->complex;

    if (status == TAUT_OK) {
        status = taut_film_cells_check(c, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    l->points = taut_arena_take(arena, (size_t)c->nodes, 3 * sizeof(double));
    l->known = taut_arena_take(arena, (size_t)c->nodes, 1);
    l->start = taut_arena_take(arena, (size_t)c->nodes, 3 * sizeof(double));
    l->tensions = taut_arena_take(arena, (size_t)problem->patch_count, sizeof(double));
    l->drawn = taut_arena_take(arena, (size_t)c->rope_count, sizeof *l->drawn);
    l->pressures = taut_arena_take(arena, (size_t)problem->cell_count, sizeof(double));
    l->volumes = taut_arena_take(arena, (size_t)problem->cell_count, sizeof(double));
    l->from = taut_arena_take(arena, (size_t)problem->cell_count, 3 * sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = lay_corners(l, arena, error);
    for (int k = 0; status == TAUT_OK && k < 8 * problem->patch_count; k++) {
        const int p = k / 4 % problem->patch_count, with_model = k >= 4 * problem->patch_count;
        if (has_model(c, p, k % 4) == with_model) {
            status = lay_edge(l, p, k % 4, arena, error);
        }
    }
    if (status == TAUT_OK) {
        status = bow_edges(l, arena, error);
    }
    for (int p = 0; status == TAUT_OK && p < problem->patch_count; p++) {
        status = fill_patch(l, p, arena, error);
    }
    if (status == TAUT_OK) {
        status = take_starts(l, arena, error);
    }
    if (status == TAUT_OK) {
        status = check_area(l, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    unsigned char *all = taut_arena_take(arena, (size_t)c->nodes, 1);
    if (all == NULL) {
        return taut_fail_memory(error);
    }
    memset(all, 1, (size_t)c->nodes);
    for (int a = 0; a < c->nodes; a++) {
        l->known[a] = c->kind[a] == TAUT_FILM_NODE_HELD;
    }
    l->scaling = taut_scaling_of((size_t)c->nodes, l->points, all);
    taut_scaling_apply(&l->scaling, (size_t)c->nodes, l->points, NULL, l->start);
    status = take_forces(l, error);
    return status == TAUT_OK ? take_cells(l, error) : status;
}
