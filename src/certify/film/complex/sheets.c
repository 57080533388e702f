#include "certify/film/complex/sheets.h"

#include "certify/common/lowest.h"
#include "certify/common/verdict.h"
#include "certify/film/sheet.h"
#include "core/vec3.h"
#include "geometry/exponent.h"
#include "geometry/keep.h"
#include "numeric/quadrature.h"
#include "numeric/sum.h"
#include "problem/film_cells.h"
#include "problem/film_ropes.h"

#include <math.h>
#include <string.h>

static taut_status make_axis(const taut_basis *basis, int extra, taut_arena *arena,
                             taut_sheet_axis *axis)
{
    double node[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX];
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis), wanted = taut_basis_local(basis) + extra;
    const int each = wanted < TAUT_GAUSS_MAX ? wanted : TAUT_GAUSS_MAX, count = spans * each;
    int *span = taut_arena_take(arena, (size_t)count, sizeof(int));
    double *at = taut_arena_take(arena, (size_t)count, sizeof(double));

    axis->at = at;
    axis->weights = taut_arena_take(arena, (size_t)count, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_gauss_rule(each, node, weight);
    for (int k = 0; k < count; k++) {
        const double lo = breaks[k / each], hi = breaks[k / each + 1];
        span[k] = k / each;
        at[k] = fmin(hi, lo + 0.5 * (hi - lo) * (1 + node[k % each]));
        axis->weights[k] = 0.5 * (hi - lo) * weight[k % each];
    }
    const taut_status status = taut_table_new(basis, count, at, span, 1, &axis->table);
    return status != TAUT_OK || !taut_keep_table(arena, axis->table) ? TAUT_NO_MEMORY : TAUT_OK;
}

/* x_u, x_v at a node of a patch. */
typedef struct place {
    double x[3], u[3], v[3], normal[3]; /* x, x_u, x_v, x_u x x_v */
    double e, f, g, w, weight;
} place;

static void find_place(const taut_sheets *s, int p, int a, int b, place *at)
{
    const taut_table *u = s->axes[2 * p].table, *v = s->axes[2 * p + 1].table;
    const int nv = taut_basis_count(s->complex->problem->patches[p].v);
    const double *nu0 = taut_table_row(u, a, 0), *nu1 = taut_table_row(u, a, 1);
    const double *nv0 = taut_table_row(v, b, 0), *nv1 = taut_table_row(v, b, 1);
    const double *points = s->points + 3 * s->complex->first[p];

    memset(at->x, 0, sizeof at->x);
    memset(at->u, 0, sizeof at->u);
    memset(at->v, 0, sizeof at->v);
    for (int i = 0; i < u->local; i++) {
        for (int j = 0; j < v->local; j++) {
            const double *x = points + 3 * ((u->first[a] + i) * nv + v->first[b] + j);
            taut_add_scaled(nu0[i] * nv0[j], x, at->x);
            taut_add_scaled(nu1[i] * nv0[j], x, at->u);
            taut_add_scaled(nu0[i] * nv1[j], x, at->v);
        }
    }
    taut_cross(at->u, at->v, at->normal);
    at->e = taut_dot(at->u, at->u);
    at->f = taut_dot(at->u, at->v);
    at->g = taut_dot(at->v, at->v);
    at->w = taut_length(at->normal);
    at->weight = s->axes[2 * p].weights[a] * s->axes[2 * p + 1].weights[b];
}

static void scale_point(const taut_sheets *s, const double from[3], double to[3])
{
    const double *origin = taut_surface_points(s->surfaces[0]);
    for (int k = 0; k < 3; k++) {
        to[k] = (from[k] / 2 - origin[k] / 2) * taut_half_factor(s->unit);
    }
}

static int has_threads(const taut_sheets *s, int p)
{
    return taut_film_sheet_has_threads(&s->complex->problem->patches[p]);
}

static void find_threads(const taut_sheets *s, int p, int a, int b, double threads[2])
{
    const taut_film_problem *patch = &s->complex->problem->patches[p];
    taut_film_threads_of(patch, s->surfaces[p], taut_film_threads_tension(patch),
                         s->axes[2 * p].at[a], s->axes[2 * p + 1].at[b], threads);
}

/* What one patch adds; its own derivatives and moments in local[points of the patch][6]. */
static void add_patch(taut_sheets *s, int p, double *local)
{
    const taut_film_complex *c = s->complex;
    const taut_table *u = s->axes[2 * p].table, *v = s->axes[2 * p + 1].table;
    const int nv = taut_basis_count(c->problem->patches[p].v);
    const int count = c->first[p + 1] - c->first[p];
    taut_sum area = {0, 0}, cone = {0, 0}, stored = {0, 0};
    double whole[3] = {0, 0, 0}; /* iint x_u x x_v */

    memset(local, 0, (size_t)count * 6 * sizeof(double));
    for (int a = 0; a < u->count; a++) {
        for (int b = 0; b < v->count; b++) {
            place at;
            double du[3], dv[3];
            find_place(s, p, a, b, &at);
            taut_sum_add(&area, at.weight * at.w);
            taut_sum_add(&cone, at.weight * taut_dot(at.x, at.normal) / 3);
            taut_add_scaled(at.weight / 3, at.normal, whole);
            const double share = at.w > 0 ? s->shares[p] * at.weight / at.w : 0;
            for (int k = 0; k < 3; k++) {
                du[k] = share * (at.g * at.u[k] - at.f * at.v[k]);
                dv[k] = share * (at.e * at.v[k] - at.f * at.u[k]);
            }
            if (has_threads(s, p)) {
                double threads[2];
                find_threads(s, p, a, b, threads);
                for (int k = 0; k < 3; k++) {
                    du[k] = s->shares[p] * at.weight * threads[0] * at.u[k];
                    dv[k] = s->shares[p] * at.weight * threads[1] * at.v[k];
                }
                taut_sum_add(&stored, 0.5 * at.weight * (threads[0] * at.e + threads[1] * at.g));
            }
            for (int i = 0; i < u->local; i++) {
                for (int j = 0; j < v->local; j++) {
                    double *to = local + 6 * ((u->first[a] + i) * nv + v->first[b] + j);
                    const double n0 = taut_table_row(u, a, 0)[i], m0 = taut_table_row(v, b, 0)[j];
                    taut_add_scaled(taut_table_row(u, a, 1)[i] * m0, du, to);
                    taut_add_scaled(n0 * taut_table_row(v, b, 1)[j], dv, to);
                    taut_add_scaled(at.weight * n0 * m0, at.normal, to + 3);
                }
            }
        }
    }
    s->areas[p] = ldexp(taut_sum_total(&area), 2 * s->unit);
    s->stored[p] = ldexp(taut_sum_total(&stored), 2 * s->unit);
    double largest = 0;
    for (int k = 0; k < count; k++) {
        largest = taut_certify_max(taut_largest_coordinate(local + 6 * k), largest);
    }
    for (int k = 0; k < count; k++) {
        const int node = c->node[c->first[p] + k];
        const double *g = local + 6 * k, *n = g + 3;
        s->scales[node] = taut_certify_max(largest, s->scales[node]);
        s->threads[node] |= (unsigned char)has_threads(s, p);
        taut_add_scaled(1, g, s->gradient + 3 * node);
        taut_add_scaled(taut_dot(n, s->moments + 3 * node) < 0 ? -1 : 1, n, s->moments + 3 * node);
    }
    for (int k = 0; k < c->problem->cell_count; k++) {
        const int turn = taut_film_cell_turn(&c->problem->cells[k], p);
        double from[3];
        scale_point(s, c->problem->cells[k].from, from);
        s->volumes[k] += turn * ldexp(taut_sum_total(&cone) - taut_dot(from, whole), 3 * s->unit);
        for (int i = 0; i < count; i++) {
            taut_add_scaled(turn, local + 6 * i + 3,
                            s->swells + 3 * (k * c->nodes + c->node[c->first[p] + i]));
        }
    }
}

/* x_t of an edge at a node of its axis. */
static void find_slope(const taut_sheets *s, const taut_film_side *side, int node, double d[3])
{
    const taut_film_complex *c = s->complex;
    const taut_film_problem *patch = &c->problem->patches[side->patch];
    const taut_table *t = s->axes[2 * side->patch + (side->edge < 2)].table;

    memset(d, 0, 3 * sizeof(double));
    for (int i = 0; i < t->local; i++) {
        const int at =
            c->first[side->patch] + taut_film_complex_point(patch, side->edge, t->first[node] + i);
        taut_add_scaled(taut_table_row(t, node, 1)[i], s->points + 3 * at, d);
    }
}

/* dL of a strand, to `to` double[nodes][3], `ratio` times; its length. */
static double add_strand(taut_sheets *s, int k, double ratio, double *to)
{
    const taut_film_side *side = &s->complex->strands[k].side;
    const taut_sheet_axis *axis = &s->axes[2 * side->patch + (side->edge < 2)];
    taut_sum length = {0, 0};

    for (int n = 0; n < axis->table->count; n++) {
        double d[3];
        find_slope(s, side, n, d);
        const double speed = taut_length(d);
        taut_sum_add(&length, axis->weights[n] * speed);
        for (int i = 0; i < axis->table->local; i++) {
            const int node = taut_film_complex_node(s->complex, side, axis->table->first[n] + i);
            taut_add_scaled(ratio * axis->weights[n] * taut_table_row(axis->table, n, 1)[i] / speed,
                            d, to + 3 * node);
        }
    }
    return ldexp(taut_sum_total(&length), s->unit);
}

/* Cables whose force is given or follows from their length; stretches of the others, and of elastic ones. */
static taut_status add_ropes(taut_sheets *s)
{
    const taut_film_complex *c = s->complex;

    for (int r = 0; r < c->rope_count; r++) {
        if (c->ropes[r].edge->law != TAUT_FILM_FORCE) {
            s->stretches[r] = taut_arena_take(s->arena, (size_t)c->nodes, 3 * sizeof(double));
        } else {
            s->forces[r] = c->ropes[r].edge->force;
            s->ratios[r] = ldexp(s->forces[r] / s->tension, -s->unit);
        }
    }
    if (taut_arena_status(s->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < c->strand_count; k++) {
        const int r = c->strands[k].rope, stretches = s->stretches[r] != NULL;
        s->lengths[r] += add_strand(s, k, stretches ? 1 : s->ratios[r],
                                    stretches ? s->stretches[r] : s->gradient);
    }
    for (int r = 0; r < c->rope_count; r++) {
        const taut_film_edge *law = c->ropes[r].edge;
        if (law->law == TAUT_FILM_ELASTIC) {
            const double longer = s->lengths[r] - law->unstressed;
            s->forces[r] = fmax(0, law->stiffness * longer / law->unstressed);
            s->ratios[r] = ldexp(s->forces[r] / s->tension, -s->unit);
            s->springs[r] = longer > 0 ? law->stiffness / law->unstressed / s->tension : 0;
            for (int i = 0; i < 3 * c->nodes; i++) {
                s->gradient[i] += s->ratios[r] * s->stretches[r][i];
            }
        }
    }
    return TAUT_OK;
}

/* Along a cable its force counts where it is more than what the sheets do; it hides nothing of sheets beyond. */
static void scale_cables(taut_sheets *s)
{
    const taut_film_complex *c = s->complex;

    for (int k = 0; k < c->strand_count; k++) {
        const taut_film_side *side = &c->strands[k].side;
        const int count = taut_film_complex_along(&c->problem->patches[side->patch], side->edge);
        for (int i = 0; i < count; i++) {
            double *scale = &s->scales[taut_film_complex_node(c, side, i)];
            *scale = taut_certify_max(s->ratios[c->strands[k].rope], *scale);
        }
    }
}

/* ---- moves ---- */

/* The ways of a node, at most three; how many. */
static int find_ways(const taut_sheets *s, int node, double *ways)
{
    const taut_film_complex *c = s->complex;
    taut_film_hold hold = c->holds[node];
    double x[3];

    if (c->kind[node] == TAUT_FILM_NODE_HELD) {
        return 0;
    }
    if (c->kind[node] == TAUT_FILM_NODE_INSIDE && !s->threads[node]) {
        memcpy(x, s->moments + 3 * node, sizeof x);
        for (int k = 0; k < hold.count; k++) {
            taut_add_scaled(-taut_dot(x, hold.normals[k]), hold.normals[k], x);
        }
        const double size = taut_length(x);
        for (int k = 0; k < 3 && size > 0; k++) {
            ways[k] = x[k] / size;
        }
        return size > 0;
    }
    if (c->kind[node] == TAUT_FILM_NODE_LINE && !s->threads[node]) {
        taut_film_complex_tangent(c, s->points, node, x);
        (void)taut_film_hold_add(&hold, x, 0, INFINITY);
    }
    return taut_film_hold_left(&hold, ways);
}

static taut_status find_moves(taut_sheets *s)
{
    const int nodes = s->complex->nodes;

    s->first = taut_arena_take(s->arena, (size_t)nodes + 1, sizeof(int));
    s->way = taut_arena_take(s->arena, (size_t)nodes, 9 * sizeof(double));
    if (taut_arena_status(s->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int a = 0; a < nodes; a++) {
        s->first[a] = s->moves;
        s->moves += find_ways(s, a, s->way + 3 * s->moves);
    }
    s->first[nodes] = s->moves;
    return TAUT_OK;
}

/* ---- pressures ---- */

/* s[m][m] = L D L': how many of D are above 0. */
static int factor_small(int m, double *s)
{
    int positive = 0;

    for (int i = 0; i < m; i++) {
        for (int j = 0; j <= i; j++) {
            double sum = s[i * m + j];
            for (int k = 0; k < j; k++) {
                sum -= s[i * m + k] * s[j * m + k] * s[k * m + k];
            }
            s[i * m + j] = i == j ? sum : sum / s[j * m + j];
        }
        positive += s[i * m + i] > 0;
    }
    return positive;
}

static void solve_small(int m, const double *s, double *x)
{
    for (int i = 0; i < m; i++) {
        for (int k = 0; k < i; k++) {
            x[i] -= s[i * m + k] * x[k];
        }
    }
    for (int i = m - 1; i >= 0; i--) {
        x[i] /= s[i * m + i];
        for (int k = i + 1; k < m; k++) {
            x[i] -= s[k * m + i] * x[k];
        }
    }
}

/* What is kept: cells of given volume, cables of given length, and, with springs, elastic ones. */
typedef struct kept {
    int count, cells;
    int *which; /* [count]: cell, rope */
} kept;

static taut_status find_kept(const taut_sheets *s, int with_springs, taut_arena *arena, kept *k)
{
    const taut_film_complex *c = s->complex;

    *k = (kept){.which = taut_arena_take(
                    arena, (size_t)c->problem->cell_count + (size_t)c->rope_count, sizeof(int))};
    if (k->which == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < c->problem->cell_count; i++) {
        if (c->problem->cells[i].has_volume) {
            k->which[k->cells++] = i;
        }
    }
    k->count = k->cells;
    for (int r = 0; r < c->rope_count; r++) {
        if (taut_film_rope_is_given(c->ropes[r].edge) || (with_springs && s->springs[r] > 0)) {
            k->which[k->count++] = r;
        }
    }
    return TAUT_OK;
}

/* dV or -dL of row i: [nodes][3], with its sign. */
static const double *row_of(const taut_sheets *s, const kept *k, int i, double *sign)
{
    *sign = i < k->cells ? 1 : -1;
    return i < k->cells ? s->swells + 3 * (size_t)k->which[i] * (size_t)s->complex->nodes
                        : s->stretches[k->which[i]];
}

static double row_along(const taut_sheets *s, const kept *k, int i, int node, int move)
{
    double sign = 1;
    const double *row = row_of(s, k, i, &sign);
    return sign * taut_dot(s->way + 3 * move, row + 3 * node);
}

/* Least squares of the derivatives along moves, g - sum p dV + sum r dL. */
static taut_status find_multipliers(taut_sheets *s)
{
    const taut_film_complex *c = s->complex;
    kept held;

    if (find_kept(s, 0, s->arena, &held) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    const int m = held.count;
    double *p = taut_arena_take(s->arena, (size_t)m, sizeof(double));
    double *square = taut_arena_take(s->arena, (size_t)m * (size_t)m, sizeof(double));
    if (taut_arena_status(s->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < c->problem->cell_count; k++) {
        const taut_film_cell *given = &c->problem->cells[k];
        s->pressures[k] = given->has_volume ? 0 : ldexp(given->pressure / s->tension, s->unit);
        for (int i = 0; i < 3 * c->nodes; i++) {
            s->gradient[i] -= s->pressures[k] * s->swells[3 * k * c->nodes + i];
        }
    }
    for (int a = 0; a < c->nodes; a++) {
        for (int move = s->first[a]; move < s->first[a + 1]; move++) {
            const double g = taut_dot(s->way + 3 * move, s->gradient + 3 * a);
            for (int i = 0; i < m; i++) {
                const double along = row_along(s, &held, i, a, move);
                p[i] += along * g;
                for (int j = 0; j <= i; j++) {
                    square[i * m + j] += along * row_along(s, &held, j, a, move);
                }
            }
        }
    }
    (void)factor_small(m, square);
    solve_small(m, square, p);
    for (int i = 0; i < m; i++) {
        double sign = 1;
        const double *row = row_of(s, &held, i, &sign);
        for (int k = 0; k < 3 * c->nodes; k++) {
            s->gradient[k] -= p[i] * sign * row[k];
        }
        if (i < held.cells) {
            s->pressures[held.which[i]] = p[i];
        } else {
            s->ratios[held.which[i]] = p[i];
            s->forces[held.which[i]] = s->tension * ldexp(p[i], s->unit);
        }
    }
    for (int q = 0; q < c->problem->patch_count; q++) {
        for (int k = 0; k < c->problem->cell_count; k++) {
            s->pull[q] += taut_film_cell_turn(&c->problem->cells[k], q) * s->pressures[k];
        }
    }
    return TAUT_OK;
}

static void scale_points(taut_sheets *s)
{
    const taut_film_complex *c = s->complex;
    const double *origin = taut_surface_points(s->surfaces[0]);

    for (int p = 0; p < c->problem->patch_count; p++) {
        const double *from = taut_surface_points(s->surfaces[p]);
        for (int k = 0; k < 3 * (c->first[p + 1] - c->first[p]); k++) {
            s->points[3 * c->first[p] + k] = from[k] / 2 - origin[k % 3] / 2;
        }
    }
    s->half = taut_largest((size_t)c->points, s->points);
    s->unit = taut_exponent(s->half) + 1;
    const double factor = taut_half_factor(s->unit);
    for (int k = 0; k < 3 * c->points; k++) {
        s->points[k] *= factor;
    }
}

taut_status taut_sheets_new(const taut_film_complex *complex, const taut_surface *const *surfaces,
                            int extra, taut_arena *arena, taut_sheets *sheets)
{
    taut_sheets *const s = sheets;
    const size_t patches = (size_t)complex->problem->patch_count, nodes = (size_t)complex->nodes,
                 ropes = (size_t)complex->rope_count;

    *s = (taut_sheets){.arena = arena, .complex = complex, .surfaces = surfaces};
    s->points = taut_arena_take(arena, (size_t)complex->points, 3 * sizeof(double));
    s->shares = taut_arena_take(arena, patches, sizeof(double));
    s->ratios = taut_arena_take(arena, ropes, sizeof(double));
    s->forces = taut_arena_take(arena, ropes, sizeof(double));
    s->springs = taut_arena_take(arena, ropes, sizeof(double));
    s->stretches = taut_arena_take(arena, ropes, sizeof *s->stretches);
    s->lengths = taut_arena_take(arena, ropes, sizeof(double));
    s->axes = taut_arena_take(arena, patches, 2 * sizeof *s->axes);
    s->gradient = taut_arena_take(arena, nodes, 3 * sizeof(double));
    s->moments = taut_arena_take(arena, nodes, 3 * sizeof(double));
    s->scales = taut_arena_take(arena, nodes, sizeof(double));
    const size_t cells = (size_t)complex->problem->cell_count;
    s->swells = taut_arena_take(arena, cells * nodes, 3 * sizeof(double));
    s->volumes = taut_arena_take(arena, cells, sizeof(double));
    s->pressures = taut_arena_take(arena, cells, sizeof(double));
    s->pull = taut_arena_take(arena, patches, sizeof(double));
    s->areas = taut_arena_take(arena, patches, sizeof(double));
    s->stored = taut_arena_take(arena, patches, sizeof(double));
    s->threads = taut_arena_take(arena, nodes, 1);
    double *local = taut_arena_take(arena, (size_t)complex->points, 6 * sizeof(double));
    taut_status status = taut_arena_status(arena);
    for (size_t k = 0; status == TAUT_OK && k < 2 * patches; k++) {
        const taut_film_problem *patch = &complex->problem->patches[k / 2];
        status = make_axis(k % 2 == 0 ? patch->u : patch->v, extra, arena, &s->axes[k]);
    }
    if (status != TAUT_OK) {
        return status;
    }
    scale_points(s);
    s->tension = taut_film_threads_tension(&complex->problem->patches[0]);
    for (size_t p = 0; p < patches; p++) {
        s->shares[p] = taut_film_threads_tension(&complex->problem->patches[p]) / s->tension;
        add_patch(s, (int)p, local);
    }
    status = add_ropes(s);
    if (status == TAUT_OK) {
        status = find_moves(s);
    }
    if (status == TAUT_OK) {
        status = find_multipliers(s);
    }
    scale_cables(s);
    return status;
}

/* ---- the second variation ---- */

/* K and M in envelopes: row i from column low[i] to i; rows in an order of their own. */
typedef struct envelope {
    int rows;
    int *row;      /* [moves]: where a move is */
    int *low;      /* [rows] */
    size_t *start; /* [rows]: of column low[i] */
    size_t size;
    double *k, *m, *l; /* l: the factor, its last entry of each row D */
    taut_pulse *pulse; /* once it says stop, nothing here has a meaning */
} envelope;

enum { LOCAL_MOST = 3 * 121 };
static const size_t envelope_most = 60000000;
static const double work_of_pair = 40; /* operations of two moves at a node, roughly */

/* What is alive on one cell: its moves, and the function and way of each. */
typedef struct cell {
    int count;
    int moves[LOCAL_MOST], functions[LOCAL_MOST];
} cell;

static void find_cell(const taut_sheets *s, int p, int a, int b, cell *made)
{
    const taut_table *u = s->axes[2 * p].table, *v = s->axes[2 * p + 1].table;
    const int nv = taut_basis_count(s->complex->problem->patches[p].v);

    made->count = 0;
    for (int i = 0; i < u->local; i++) {
        for (int j = 0; j < v->local; j++) {
            const int node =
                s->complex->node[s->complex->first[p] + (u->first[a] + i) * nv + v->first[b] + j];
            for (int m = s->first[node]; m < s->first[node + 1]; m++) {
                made->moves[made->count] = m;
                made->functions[made->count++] = i * v->local + j;
            }
        }
    }
}

/* A walk over all cells: each the first node of its span; returns 0 at the end. */
typedef struct walk {
    int p, a, b;
} walk;

static int next_cell(const taut_sheets *s, walk *w)
{
    const taut_film_problem *problem = s->complex->problem;

    while (w->p < problem->patch_count) {
        const taut_table *u = s->axes[2 * w->p].table, *v = s->axes[2 * w->p + 1].table;
        const int eu = u->count / taut_basis_span_count(problem->patches[w->p].u),
                  ev = v->count / taut_basis_span_count(problem->patches[w->p].v);
        if (w->b + ev < v->count && w->a >= 0) {
            w->b += ev;
            return 1;
        }
        if (w->a + eu < u->count || w->a < 0) {
            w->a = w->a < 0 ? 0 : w->a + eu;
            w->b = 0;
            return 1;
        }
        w->p++;
        w->a = -1;
        w->b = 0;
    }
    return 0;
}

/* Order of breadth: nodes by distance from where the last walk from the first one ended, reversed. */
static taut_status find_order(const taut_sheets *s, taut_arena *arena, envelope *e, cell *at)
{
    const size_t moves = (size_t)s->moves;
    int cells = 0, all = 0;

    for (walk w = {0, -1, 0}; next_cell(s, &w);) {
        find_cell(s, w.p, w.a, w.b, at);
        cells++;
        all += at->count;
    }
    int *first = taut_arena_take(arena, (size_t)cells + 1, sizeof(int));
    int *member = taut_arena_take(arena, (size_t)all + 1, sizeof(int));
    int *of = taut_arena_take(arena, (size_t)all + 1, sizeof(int));
    int *end = taut_arena_take(arena, moves + 1, sizeof(int));
    int *queue = taut_arena_take(arena, moves, sizeof(int));
    int *seen = taut_arena_take(arena, moves, sizeof(int));
    e->row = taut_arena_take(arena, moves, sizeof(int));
    e->low = taut_arena_take(arena, moves, sizeof(int));
    e->start = taut_arena_take(arena, moves, sizeof(size_t));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    int n = 0, k = 0;
    for (walk w = {0, -1, 0}; next_cell(s, &w); k++) {
        find_cell(s, w.p, w.a, w.b, at);
        first[k] = n;
        for (int i = 0; i < at->count; i++) {
            member[n++] = at->moves[i];
            end[at->moves[i] + 1]++;
        }
    }
    first[cells] = n;
    for (int m = 0; m < s->moves; m++) {
        end[m + 1] += end[m];
    }
    for (k = 0; k < cells; k++) {
        for (int i = first[k]; i < first[k + 1]; i++) {
            of[end[member[i]]++] = k; /* afterwards end[m] is where those of m end */
        }
    }
    int begin = 0;
    for (int round = 1; round <= 3; round++) {
        int head = 0, tail = 0;
        for (int m = -1; m < s->moves;
             m++) { /* -1: where to begin; then what is not reached from there */
            const int from = m < 0 ? begin : m;
            if (from < s->moves && seen[from] != round) {
                seen[from] = round;
                queue[tail++] = from;
            }
            for (; head < tail; head++) {
                const int here = queue[head];
                for (int i = here == 0 ? 0 : end[here - 1]; i < end[here]; i++) {
                    for (int j = first[of[i]]; j < first[of[i] + 1]; j++) {
                        if (seen[member[j]] != round) {
                            seen[member[j]] = round;
                            queue[tail++] = member[j];
                        }
                    }
                }
            }
        }
        begin = tail > 0 ? queue[tail - 1] : 0;
    }
    e->rows = s->moves;
    for (int i = 0; i < s->moves; i++) {
        e->row[queue[i]] = s->moves - 1 - i;
    }
    for (int i = 0; i < s->moves; i++) {
        e->low[i] = i;
    }
    for (k = 0; k < cells; k++) {
        int least = s->moves;
        for (int i = first[k]; i < first[k + 1]; i++) {
            least = e->row[member[i]] < least ? e->row[member[i]] : least;
        }
        for (int i = first[k]; i < first[k + 1]; i++) {
            int *low = &e->low[e->row[member[i]]];
            *low = least < *low ? least : *low;
        }
    }
    for (int i = 0; i < s->moves; i++) {
        e->start[i] = e->size;
        e->size += (size_t)(i - e->low[i] + 1);
    }
    return TAUT_OK;
}

static void add_entry(const envelope *e, int a, int b, double k, double m)
{
    const int i = e->row[a] > e->row[b] ? e->row[a] : e->row[b];
    const int j = e->row[a] > e->row[b] ? e->row[b] : e->row[a];
    const size_t at = e->start[i] + (size_t)(j - e->low[i]);

    e->k[at] += k;
    e->m[at] += m;
}

/* What Gauss node (a, b) of a patch adds. */
static void add_node(const taut_sheets *s, int p, int a, int b, const cell *at, const envelope *e)
{
    const taut_table *u = s->axes[2 * p].table, *v = s->axes[2 * p + 1].table;
    double still[LOCAL_MOST], du[LOCAL_MOST], dv[LOCAL_MOST], along[LOCAL_MOST];
    place x;

    find_place(s, p, a, b, &x);
    if (!(x.w > 0)) {
        return;
    }
    for (int i = 0; i < at->count; i++) {
        const int iu = at->functions[i] / v->local, iv = at->functions[i] % v->local;
        const double n0 = taut_table_row(u, a, 0)[iu], m0 = taut_table_row(v, b, 0)[iv];
        along[i] = taut_dot(x.normal, s->way + 3 * at->moves[i]) / x.w;
        still[i] = n0 * m0;
        du[i] = taut_table_row(u, a, 1)[iu] * m0;
        dv[i] = n0 * taut_table_row(v, b, 1)[iv];
    }
    const double share = s->shares[p] * x.weight;
    double threads[2] = {0, 0};
    if (has_threads(s, p)) {
        find_threads(s, p, a, b, threads);
    }
    for (int i = 0; i < at->count; i++) {
        const double *mi = s->way + 3 * at->moves[i];
        const double fu = share * along[i] * (x.g * du[i] - x.f * dv[i]) / x.w,
                     fv = share * along[i] * (x.e * dv[i] - x.f * du[i]) / x.w;
        for (int j = 0; j <= i; j++) {
            const double *mj = s->way + 3 * at->moves[j];
            const double tense = threads[0] > 0
                                     ? share * taut_dot(mi, mj) *
                                           (threads[0] * du[i] * du[j] + threads[1] * dv[i] * dv[j])
                                     : along[j] * (fu * du[j] + fv * dv[j]) +
                                           share * (du[i] * dv[j] - du[j] * dv[i]) *
                                               taut_det(mi, mj, x.normal) / x.w;
            const double k =
                tense - 0.5 * x.weight * s->pull[p] *
                            (taut_det(mi, mj, x.v) * (still[i] * du[j] - still[j] * du[i]) +
                             taut_det(mi, mj, x.u) * (still[j] * dv[i] - still[i] * dv[j]));
            const double m = x.weight * x.w * along[i] * along[j] * still[i] * still[j];
            /* two functions at one node that is a pole: both ways fall on one entry */
            const double often = i != j && at->moves[i] == at->moves[j] ? 2 : 1;
            add_entry(e, at->moves[i], at->moves[j], often * k, often * m);
        }
    }
}

/* Lines: what cables add to K, and all of them to M. */
static void add_line(const taut_sheets *s, const taut_film_side *side, double ratio,
                     const envelope *e)
{
    const taut_sheet_axis *axis = &s->axes[2 * side->patch + (side->edge < 2)];
    const taut_table *t = axis->table;

    for (int n = 0; n < axis->table->count; n++) {
        double d[3];
        find_slope(s, side, n, d);
        const double speed = taut_length(d);
        const double size = 2 * s->half * taut_half_factor(s->unit) / 2;
        for (int a = 0; a < t->local; a++) {
            for (int b = 0; b < t->local; b++) {
                const int na = taut_film_complex_node(s->complex, side, t->first[n] + a),
                          nb = taut_film_complex_node(s->complex, side, t->first[n] + b);
                for (int i = s->first[na]; i < s->first[na + 1]; i++) {
                    for (int j = s->first[nb]; j < s->first[nb + 1]; j++) {
                        const double *mi = s->way + 3 * i, *mj = s->way + 3 * j;
                        const double across =
                            taut_dot(mi, mj) - taut_dot(mi, d) * taut_dot(mj, d) / (speed * speed);
                        if (e->row[j] <= e->row[i]) { /* of each pair once */
                            add_entry(e, i, j,
                                      ratio * axis->weights[n] * taut_table_row(t, n, 1)[a] *
                                          taut_table_row(t, n, 1)[b] * across / speed,
                                      size * axis->weights[n] * speed * taut_table_row(t, n, 0)[a] *
                                          taut_table_row(t, n, 0)[b] * across);
                        }
                    }
                }
            }
        }
    }
}

static void add_lines(const taut_sheets *s, const envelope *e)
{
    const taut_film_complex *c = s->complex;
    const taut_film_problem *problem = c->problem;

    for (int k = 0; k < c->strand_count; k++) {
        add_line(s, &c->strands[k].side, s->ratios[c->strands[k].rope], e);
    }
    for (int p = 0; p < problem->patch_count; p++) {
        for (int k = 0; k < 4; k++) {
            const taut_film_side side = {p, k, 0};
            if (problem->patches[p].edges[k].kind == TAUT_FILM_SLIDE) {
                add_line(s, &side, 0, e);
            }
        }
    }
    for (int k = 0; k < problem->seam_count; k++) {
        if (problem->seams[k].count > 2 && problem->seams[k].edge.kind != TAUT_FILM_CABLE) {
            taut_film_side side = problem->seams[k].sides[0];
            side.reversed = 0;
            add_line(s, &side, 0, e);
        }
    }
}

/* l = the factor of K - shift M: how many pivots are not positive. */
static int factor(const envelope *e, double shift)
{
    int negative = 0;

    for (int i = 0; i < e->rows; i++) {
        double *row = e->l + e->start[i] - e->low[i];
        const double *k = e->k + e->start[i] - e->low[i], *m = e->m + e->start[i] - e->low[i];
        for (int j = e->low[i]; j < i; j++) {
            const double *other = e->l + e->start[j] - e->low[j];
            const int from = e->low[j] > e->low[i] ? e->low[j] : e->low[i];
            double sum = k[j] - shift * m[j];
            for (int q = from; q < j; q++) {
                sum -= row[q] * other[q];
            }
            row[j] = sum; /* L D */
        }
        double pivot = k[i] - shift * m[i];
        for (int j = e->low[i]; j < i; j++) {
            const double scaled = row[j];
            row[j] = scaled / e->l[e->start[j] + (size_t)(j - e->low[j])];
            pivot -= scaled * row[j];
        }
        row[i] = pivot != 0 ? pivot : 1e-300;
        negative += !(pivot > 0);
        const double length = i - e->low[i];
        if (taut_pulse_beat(e->pulse, length * length)) {
            return 0;
        }
    }
    return negative;
}

static void solve(const envelope *e, double *x)
{
    for (int i = 0; i < e->rows; i++) {
        const double *row = e->l + e->start[i] - e->low[i];
        for (int j = e->low[i]; j < i; j++) {
            x[i] -= row[j] * x[j];
        }
    }
    for (int i = 0; i < e->rows; i++) {
        x[i] /= e->l[e->start[i] + (size_t)(i - e->low[i])];
    }
    for (int i = e->rows - 1; i >= 0; i--) {
        const double *row = e->l + e->start[i] - e->low[i];
        for (int j = e->low[i]; j < i; j++) {
            x[j] -= row[j] * x[i];
        }
    }
}

static void multiply(const envelope *e, const double *a, const double *x, double *y)
{
    memset(y, 0, (size_t)e->rows * sizeof(double));
    for (int i = 0; i < e->rows; i++) {
        const double *row = a + e->start[i] - e->low[i];
        for (int j = e->low[i]; j < i; j++) {
            y[i] += row[j] * x[j];
            y[j] += row[j] * x[i];
        }
        y[i] += row[i] * x[i];
    }
}

static double dot(int n, const double *x, const double *y)
{
    double sum = 0;
    for (int i = 0; i < n; i++) {
        sum += x[i] * y[i];
    }
    return sum;
}

/* What given volumes and lengths hold, and springs stiffen: rows of dV and -dL in the order of the envelope, and what the last factor
 * makes of them. A spring adds k dL dL' to K, which is a row with 1 / k on the diagonal of s (Woodbury). */
typedef struct border {
    int count;
    double *springs; /* [count]: 1 / k; 0 where nothing gives way */
    double *c;       /* [count][rows] */
    double *z;       /* [count][rows]: (K - shift M)^-1 c */
    double *s;       /* [count][count]: c z + springs, factored */
    double *p;       /* [count]: scratch */
} border;

static taut_status make_border(const taut_sheets *s, const envelope *e, taut_arena *arena,
                               border *b)
{
    const size_t rows = (size_t)e->rows;
    kept held;

    if (find_kept(s, 1, arena, &held) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    b->count = held.count;
    const size_t count = (size_t)b->count;
    b->springs = taut_arena_take(arena, count, sizeof(double));
    b->p = taut_arena_take(arena, count, sizeof(double));

    b->c = taut_arena_take(arena, count * rows, sizeof(double));
    b->z = taut_arena_take(arena, count * rows, sizeof(double));
    b->s = taut_arena_take(arena, count * count, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int i = held.cells; i < held.count; i++) {
        const double k = s->springs[held.which[i]];
        b->springs[i] = k > 0 ? 1 / k : 0;
    }
    for (int a = 0; a < s->complex->nodes; a++) {
        for (int move = s->first[a]; move < s->first[a + 1]; move++) {
            for (int i = 0; i < b->count; i++) {
                b->c[(size_t)i * rows + (size_t)e->row[move]] = row_along(s, &held, i, a, move);
            }
        }
    }
    return TAUT_OK;
}

/* As factor, of what the border leaves: negative pivots there are fewer by as many as its rows take (Haynsworth). */
static int factor_held(const envelope *e, const border *b, double shift)
{
    const int negative = factor(e, shift);

    for (int i = 0; i < b->count; i++) {
        double *z = b->z + (size_t)i * (size_t)e->rows;
        memcpy(z, b->c + (size_t)i * (size_t)e->rows, (size_t)e->rows * sizeof(double));
        solve(e, z);
        for (int j = 0; j <= i; j++) {
            b->s[i * b->count + j] =
                dot(e->rows, b->c + (size_t)j * (size_t)e->rows, z) + (i == j ? b->springs[i] : 0);
        }
    }
    return negative + factor_small(b->count, b->s) - b->count;
}

/* x, a solution without the border, is made one with it. */
static void hold(const envelope *e, const border *b, double *x)
{
    double *const p = b->p;

    for (int i = 0; i < b->count; i++) {
        p[i] = dot(e->rows, b->c + (size_t)i * (size_t)e->rows, x);
    }
    solve_small(b->count, b->s, p);
    for (int i = 0; i < b->count; i++) {
        for (int k = 0; k < e->rows; k++) {
            x[k] -= p[i] * b->z[(size_t)i * (size_t)e->rows + (size_t)k];
        }
    }
}

/* x' (sum k dL dL') x. */
static double stored_in(const envelope *e, const border *b, const double *x)
{
    double sum = 0;
    for (int i = 0; i < b->count; i++) {
        const double along = dot(e->rows, b->c + (size_t)i * (size_t)e->rows, x);
        sum += b->springs[i] > 0 ? along * along / b->springs[i] : 0;
    }
    return sum;
}

/* What the factors at hand solve. */
typedef struct bordered {
    const envelope *e;
    const border *b;
} bordered;

static void solve_of(const void *of, double *x)
{
    const bordered *s = of;
    solve(s->e, x);
    hold(s->e, s->b, x);
}

static void weigh_of(const void *of, const double *x, double *y)
{
    const bordered *s = of;
    multiply(s->e, s->e->m, x, y);
}

/* Shifts fall until nothing lies below. */
static taut_status iterate(const envelope *e, const border *b, taut_arena *arena, double *lowest)
{
    enum { FALLS = 60 };
    const size_t rows = (size_t)e->rows;
    double *x = taut_arena_take(arena, rows, sizeof(double));
    double *y = taut_arena_take(arena, rows, sizeof(double));
    double shift = 0;

    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; factor_held(e, b, shift) > 0; k++) {
        if (k == FALLS || taut_pulse_is_stopped(e->pulse)) {
            return TAUT_NOT_CONVERGED;
        }
        shift = shift == 0 ? -1 : 4 * shift;
    }
    if (taut_pulse_is_stopped(e->pulse)) {
        return TAUT_INTERRUPTED;
    }
    const bordered at = {e, b};
    const taut_lowest form = {.count = e->rows,
                              .of = &at,
                              .solve = solve_of,
                              .weigh = weigh_of,
                              .work = 8.0 * (double)e->size};
    const taut_status status = taut_certify_lowest(&form, arena, e->pulse, x);
    if (status == TAUT_OK) {
        multiply(e, e->k, x, y);
        *lowest = dot(e->rows, x, y) + stored_in(e, b, x); /* x is of unit mass */
    }
    return status == TAUT_OK && !isfinite(*lowest) ? TAUT_NOT_CONVERGED : status;
}

/* K and M of all sheets and lines. TAUT_INTERRUPTED. */
static taut_status fill(const taut_sheets *s, envelope *e, cell *at)
{
    const taut_film_problem *problem = s->complex->problem;

    for (walk w = {0, -1, 0}; next_cell(s, &w);) {
        const int eu =
            s->axes[2 * w.p].table->count / taut_basis_span_count(problem->patches[w.p].u);
        const int ev =
            s->axes[2 * w.p + 1].table->count / taut_basis_span_count(problem->patches[w.p].v);
        find_cell(s, w.p, w.a, w.b, at);
        for (int k = 0; k < eu * ev; k++) {
            add_node(s, w.p, w.a + k / ev, w.b + k % ev, at, e);
        }
        if (taut_pulse_beat(e->pulse, work_of_pair * at->count * at->count * (eu * ev))) {
            return TAUT_INTERRUPTED;
        }
    }
    add_lines(s, e);
    return TAUT_OK;
}

taut_status taut_sheets_lowest(const taut_sheets *sheets, double limit, taut_pulse *pulse,
                               double *lowest, int *below)
{
    const taut_sheets *s = sheets;
    taut_arena *arena = taut_arena_new();
    envelope e = {.pulse = pulse};
    border held = {.count = 0};
    cell *at = taut_arena_take(arena, 1, sizeof *at);
    taut_status status = taut_arena_status(arena);

    *below = -1;
    if (status == TAUT_OK) {
        status = find_order(s, arena, &e, at);
    }
    if (status == TAUT_OK && (e.size > envelope_most || e.rows == 0)) {
        taut_arena_free(arena);
        return TAUT_NOT_CONVERGED;
    }
    if (status == TAUT_OK) {
        e.k = taut_arena_take(arena, e.size, sizeof(double));
        e.m = taut_arena_take(arena, e.size, sizeof(double));
        e.l = taut_arena_take(arena, e.size, sizeof(double));
        status = taut_arena_status(arena);
    }
    if (status == TAUT_OK) {
        status = fill(s, &e, at);
    }
    if (status == TAUT_OK) {
        status = make_border(s, &e, arena, &held);
    }
    if (status == TAUT_OK) {
        const double size = 2 * s->half * taut_half_factor(s->unit) / 2;
        *below = factor_held(&e, &held, limit / (size * size));
        status =
            taut_pulse_is_stopped(pulse) ? TAUT_INTERRUPTED : iterate(&e, &held, arena, lowest);
        *lowest *= size * size;
    }
    taut_arena_free(arena);
    return status;
}
