/* rational.c -- the matrix by quadrature, block row by block row.
 *
 *     R_ij = w_ij N_i N_j / w,     w = sum_s c_s N_s,     c_s = sum_t w_st N_t
 *     R_ij,u = w_ij N_j (N_i' w - N_i w_u) / w^2 = w_ij N_j sum_s c_s (N_i' N_s - N_i N_s') / w^2
 *
 * likewise in v. Written so, the term s = i drops out: where one function is nearly all of w, its
 * small slope is not the difference of two large numbers. At each node of the tensor rule the
 * slopes of the k h functions alive there, then the products of all pairs.
 */
#include "construct/dirichlet/rational.h"

#include "core/arena.h"
#include "core/fail.h"
#include "core/memory.h"
#include "geometry/grid/table.h"
#include "geometry/keep.h"
#include "geometry/nurbs/cells.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <string.h>

/* Gauss quadrature along one direction of a surface, over the unit interval. */
typedef struct line_rule {
    int count;         /* nodes */
    taut_table *table; /* order 1; slopes over the unit interval, not the basis' own range */
    double *weights;   /* [count], their sum is 1 */
    double *roundings; /* [count]: |t| over the width of its span, what a rounding of t is there */
    double reach;      /* max |t| over the length of the range */
} line_rule;

struct taut_dirichlet_rational {
    const taut_basis *u, *v;
    int nu, nv, k, h;  /* functions, and functions alive on a span */
    taut_arena *arena; /* of all but the rules */
    taut_cells *cells_u, *cells_v;
    double *weights;   /* [nu][nv] */
    int nodes;         /* a cell */
    taut_arena *rules; /* of the next two */
    line_rule along_u, along_v;
    double fu, fv;
    double *blocks;   /* [nu][k][nv][2h-1]: A(ij, (i+e)(j+d)) at [i][e][j][d + h-1] */
    double *row_sums; /* [nu][nv] */
    double *slopes;   /* [2][k][h]: R_u and R_v at one node */
    double *sums;     /* [2][k h][k h]: of a pair of cells, and of one line of it */
    double roundings;
    double work; /* pairs of functions at nodes, of all assemblies so far */
};

/* What assemblies of all rules together may cost: so many pairs of functions at nodes, some ten
 * seconds, or so many times those of the first rule if no span were cut. */
static const struct {
    double pairs_least, first_rules;
} limits = {1e10, 60};

void taut_dirichlet_rational_free(taut_dirichlet_rational *form)
{
    if (form != NULL) {
        taut_cells_free(form->cells_u);
        taut_cells_free(form->cells_v);
        taut_arena_free(form->rules);
        taut_arena_free(form->arena);
        taut_free(form);
    }
}

/* ---- rules ---- */

/* Parameters and spans of the nodes, and what else the rule holds of them. */
static void place_nodes(const taut_basis *basis, const taut_cells *cells, int nodes, double *t,
                        int *spans, line_rule *rule)
{
    double node[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX];
    const double length = taut_basis_hi(basis) - taut_basis_lo(basis);

    taut_gauss_rule(nodes, node, weight);
    rule->reach = fmax(fabs(taut_basis_lo(basis)), fabs(taut_basis_hi(basis))) / length;
    for (int i = 0; i < rule->count; i++) {
        const int k = i / nodes, g = i % nodes, span = cells->span[k];
        t[i] = taut_cells_at(cells, k, node[g]);
        spans[i] = span;
        rule->weights[i] = 0.5 * weight[g] * ((cells->hi[k] - cells->lo[k]) / length);
        rule->roundings[i] = fabs(t[i]) / taut_cells_finest(basis, span);
    }
}

static void scale_slopes(taut_table *table, double factor)
{
    for (int i = 0; i < table->count; i++) {
        double *slopes = table->values + ((size_t)i * 2 + 1) * (size_t)table->local;
        for (int a = 0; a < table->local; a++) {
            slopes[a] *= factor;
        }
    }
}

/* `nodes` Gauss nodes, 1..TAUT_GAUSS_MAX, on every cell. TAUT_NO_MEMORY. */
static taut_status make_rule(const taut_basis *basis, const taut_cells *cells, int nodes,
                             taut_arena *arena, line_rule *rule)
{
    const size_t count = (size_t)cells->count * (size_t)nodes;
    double *t = taut_arena_take(arena, count, sizeof(double));
    int *spans = taut_arena_take(arena, count, sizeof(int));
    taut_status status = TAUT_OK;

    rule->count = (int)count;
    rule->weights = taut_arena_take(arena, count, sizeof(double));
    rule->roundings = taut_arena_take(arena, count, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    place_nodes(basis, cells, nodes, t, spans, rule);
    status = taut_table_new(basis, rule->count, t, spans, 1, &rule->table);
    if (status != TAUT_OK) {
        return status;
    }
    scale_slopes(rule->table, taut_basis_hi(basis) - taut_basis_lo(basis));
    return taut_keep_table(arena, rule->table) ? TAUT_OK : TAUT_NO_MEMORY;
}

/* ---- the matrix ---- */

/* out[a] = sum_s c_s (N_a' N_s - N_a N_s'), over the `count` functions alive. */
static void find_wronskians(int count, const double *c, const double *n, const double *dn,
                            double *out)
{
    for (int a = 0; a < count; a++) {
        out[a] = 0;
        for (int s = 0; s < count; s++) {
            out[a] += c[s] * (dn[a] * n[s] - n[a] * dn[s]);
        }
    }
}

static double dot(int count, const double *x, const double *y)
{
    double sum = 0;
    for (int i = 0; i < count; i++) {
        sum += x[i] * y[i];
    }
    return sum;
}

/* slopes = R_ij,u, then R_ij,v, of the functions alive at node (p, q). Returns what a rounding of
 * the parameters does there. */
static double find_slopes(const taut_dirichlet_rational *form, int p, int q, double *slopes)
{
    const int k = form->k, h = form->h;
    const line_rule *ru = &form->along_u, *rv = &form->along_v;
    const double *n = taut_table_row(ru->table, p, 0), *dn = taut_table_row(ru->table, p, 1);
    const double *m = taut_table_row(rv->table, q, 0), *dm = taut_table_row(rv->table, q, 1);
    const double *weights = form->weights + (size_t)ru->table->first[p] * (size_t)form->nv +
                            (size_t)rv->table->first[q];
    double rows[TAUT_DEGREE_MAX + 1], columns[TAUT_DEGREE_MAX + 1];
    double along_u[TAUT_DEGREE_MAX + 1], along_v[TAUT_DEGREE_MAX + 1];
    double w = 0;

    memset(columns, 0, (size_t)h * sizeof(double));
    for (int a = 0; a < k; a++) {
        rows[a] = dot(h, weights + (size_t)a * (size_t)form->nv, m);
        for (int b = 0; b < h; b++) {
            columns[b] += weights[(size_t)a * (size_t)form->nv + (size_t)b] * n[a];
        }
    }
    w = dot(k, rows, n);
    find_wronskians(k, rows, n, dn, along_u);
    find_wronskians(h, columns, m, dm, along_v);
    for (int a = 0; a < k; a++) {
        for (int b = 0; b < h; b++) {
            const double share = weights[(size_t)a * (size_t)form->nv + (size_t)b] / w;
            slopes[a * h + b] = share * m[b] * (along_u[a] / w);
            slopes[(k + a) * h + b] = share * n[a] * (along_v[b] / w);
        }
    }
    return 1 + ru->roundings[p] + rv->roundings[q] + ru->reach * fabs(dot(k, rows, dn) / w) +
           rv->reach * fabs(dot(h, columns, dm) / w);
}

static double *block_row(const taut_dirichlet_rational *form, int i, int e, int j)
{
    const size_t width = 2 * (size_t)form->h - 1;
    return form->blocks +
           (((size_t)i * (size_t)form->k + (size_t)e) * (size_t)form->nv + (size_t)j) * width;
}

/* line[ab][a'b'] += the products of all pairs with a <= a' at node (p, q). */
static void add_node(taut_dirichlet_rational *form, int p, int q, double *line)
{
    const int k = form->k, h = form->h;
    const double weight = form->along_u.weights[p] * form->along_v.weights[q];
    const double *su = form->slopes, *sv = form->slopes + k * h;

    form->roundings = fmax(form->roundings, find_slopes(form, p, q, form->slopes));
    for (int ab = 0; ab < k * h; ab++) {
        const double fu = weight * form->fu * su[ab], fv = weight * form->fv * sv[ab];
        double *row = line + (size_t)ab * (size_t)(k * h);
        for (int other = ab / h * h; other < k * h; other++) {
            row[other] += fu * su[other] + fv * sv[other];
        }
    }
}

/* Moves the sums of one pair of cells, whose first functions are i and j, to the blocks. */
static void scatter_sums(taut_dirichlet_rational *form, int i, int j, const double *sums)
{
    const int k = form->k, h = form->h;
    for (int ab = 0; ab < k * h; ab++) {
        const int a = ab / h, b = ab % h;
        for (int e = 0; a + e < k; e++) {
            const double *from = sums + (size_t)ab * (size_t)(k * h) + (size_t)((a + e) * h);
            double *row = block_row(form, i + a, e, j + b) + (h - 1 - b);
            for (int d = 0; d < h; d++) {
                row[d] += from[d];
            }
        }
    }
}

/* One pair of cells: nodes of a line first, then lines, then, in the blocks, cells. Sums of a few
 * dozen terms each keep the rounding of hundreds of thousands small ([Higham2002] 4.2). */
static void add_cells(taut_dirichlet_rational *form, int cell_u, int cell_v)
{
    const size_t size = (size_t)(form->k * form->h) * (size_t)(form->k * form->h);
    double *sums = form->sums, *line = form->sums + size;
    const int p0 = cell_u * form->nodes, q0 = cell_v * form->nodes;

    memset(sums, 0, size * sizeof(double));
    for (int p = p0; p < p0 + form->nodes; p++) {
        memset(line, 0, size * sizeof(double));
        for (int q = q0; q < q0 + form->nodes; q++) {
            add_node(form, p, q, line);
        }
        for (size_t i = 0; i < size; i++) {
            sums[i] += line[i];
        }
    }
    scatter_sums(form, form->along_u.table->first[p0], form->along_v.table->first[q0], sums);
}

static void add_row_sums(taut_dirichlet_rational *form)
{
    memset(form->row_sums, 0, (size_t)form->nu * (size_t)form->nv * sizeof(double));
    for (int i = 0; i < form->nu; i++) {
        for (int e = 0; e < form->k && i + e < form->nu; e++) {
            double *here = form->row_sums + (size_t)i * (size_t)form->nv;
            double *there = form->row_sums + (size_t)(i + e) * (size_t)form->nv;
            for (int j = 0; j < form->nv; j++) {
                const double *row = block_row(form, i, e, j);
                const int from = form->h - 1 < j ? 1 - form->h : -j;
                const int to = form->h - 1 < form->nv - 1 - j ? form->h - 1 : form->nv - 1 - j;
                for (int d = from; d <= to; d++) {
                    here[j] += fabs(row[d + form->h - 1]);
                    there[j + d] += e > 0 ? fabs(row[d + form->h - 1]) : 0;
                }
            }
        }
    }
}

static size_t blocks_size(const taut_dirichlet_rational *form)
{
    return (size_t)form->nu * (size_t)form->k * (size_t)form->nv * (2 * (size_t)form->h - 1);
}

static double count_pairs(const taut_dirichlet_rational *form, double cells, int nodes)
{
    const double alive = (double)form->k * form->h;
    return cells * nodes * nodes * alive * alive;
}

static int first_nodes(const taut_dirichlet_rational *form)
{
    return (form->k > form->h ? form->k : form->h) + 2;
}

/* May another assembly with so many nodes be made? */
static int may_assemble(const taut_dirichlet_rational *form, int nodes)
{
    const double cells = (double)form->cells_u->count * form->cells_v->count;
    const double spans =
        (double)taut_basis_span_count(form->u) * (double)taut_basis_span_count(form->v);
    return form->work + count_pairs(form, cells, nodes) <=
           fmax(limits.pairs_least,
                limits.first_rules * count_pairs(form, spans, first_nodes(form)));
}

static void assemble(taut_dirichlet_rational *form)
{
    form->work +=
        count_pairs(form, (double)form->cells_u->count * form->cells_v->count, form->nodes);
    memset(form->blocks, 0, blocks_size(form) * sizeof(double));
    form->roundings = 0;
    for (int a = 0; a < form->cells_u->count; a++) {
        for (int b = 0; b < form->cells_v->count; b++) {
            add_cells(form, a, b);
        }
    }
    add_row_sums(form);
}

static taut_status set_nodes(taut_dirichlet_rational *form, int nodes)
{
    taut_arena *rules = taut_arena_new();
    line_rule u, v;

    if (make_rule(form->u, form->cells_u, nodes, rules, &u) != TAUT_OK ||
        make_rule(form->v, form->cells_v, nodes, rules, &v) != TAUT_OK) {
        taut_arena_free(rules);
        return TAUT_NO_MEMORY;
    }
    taut_arena_free(form->rules);
    form->rules = rules;
    form->along_u = u;
    form->along_v = v;
    form->nodes = nodes;
    assemble(form);
    return TAUT_OK;
}

static taut_status prepare(taut_dirichlet_rational *form, const double *weights, taut_error *error)
{
    const size_t nu = (size_t)form->nu, nv = (size_t)form->nv;
    const size_t alive = (size_t)form->k * (size_t)form->h;
    taut_arena *arena = form->arena;

    form->weights = taut_arena_copy(arena, weights, nu * nv, sizeof(double));
    form->row_sums = taut_arena_take(arena, nu * nv, sizeof(double));
    form->slopes = taut_arena_take(arena, 2 * alive, sizeof(double));
    form->sums = taut_arena_take(arena, 2 * alive * alive, sizeof(double));
    form->blocks =
        taut_arena_take_raw(arena, blocks_size(form), sizeof(double)); /* zeroed in use */
    if (taut_arena_status(arena) != TAUT_OK ||
        taut_cells_new(form->u, form->nv, weights, nv, 1, &form->cells_u) != TAUT_OK ||
        taut_cells_new(form->v, form->nu, weights, 1, nv, &form->cells_v) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    form->nodes = first_nodes(form);
    if (!may_assemble(form, form->nodes)) {
        return taut_dirichlet_rational_refuse(form, error);
    }
    return set_nodes(form, form->nodes) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

taut_status taut_dirichlet_rational_new(const taut_basis *u, const taut_basis *v,
                                        const double *weights, taut_dirichlet_rational **form,
                                        taut_error *error)
{
    taut_dirichlet_rational *made = taut_alloc_zero(1, sizeof *made);
    taut_status status = TAUT_OK;

    if (made == NULL) {
        return taut_fail_memory(error);
    }
    made->u = u;
    made->v = v;
    made->nu = taut_basis_count(u);
    made->nv = taut_basis_count(v);
    made->k = taut_basis_local(u);
    made->h = taut_basis_local(v);
    made->fu = made->fv = 1;
    made->arena = taut_arena_new();
    status = prepare(made, weights, error);
    if (status != TAUT_OK) {
        taut_dirichlet_rational_free(made);
        return status;
    }
    *form = made;
    return TAUT_OK;
}

taut_status taut_dirichlet_rational_raise(taut_dirichlet_rational *form)
{
    const int more = form->nodes + form->nodes / 2;
    const int nodes = more < TAUT_GAUSS_MAX ? more : TAUT_GAUSS_MAX;
    return form->nodes < TAUT_GAUSS_MAX && may_assemble(form, nodes) ? set_nodes(form, nodes)
                                                                     : TAUT_NOT_CONVERGED;
}

taut_status taut_dirichlet_rational_refuse(const taut_dirichlet_rational *form, taut_error *error)
{
    return taut_fail(error, TAUT_NOT_CONVERGED, "weights-vary", "/weights", taut_none, taut_none,
                     "the weights vary too much from point to point: the integrals ask for more "
                     "than %d x %d Gauss nodes on each of %d x %d panels; bring the weights nearer "
                     "to each other",
                     form->nodes, form->nodes, form->cells_u->count, form->cells_v->count);
}

void taut_dirichlet_rational_scale(taut_dirichlet_rational *form, double fu, double fv)
{
    if (fu != form->fu || fv != form->fv) {
        form->fu = fu;
        form->fv = fv;
        assemble(form);
    }
}

double taut_dirichlet_rational_row_sum(const taut_dirichlet_rational *form, int i, int j)
{
    return form->row_sums[(size_t)i * (size_t)form->nv + (size_t)j];
}

double taut_dirichlet_rational_diagonal(const taut_dirichlet_rational *form, int i, int j)
{
    return block_row(form, i, 0, j)[form->h - 1];
}

double taut_dirichlet_rational_roundings(const taut_dirichlet_rational *form)
{
    return form->roundings;
}

static void add_multiple(double factor, const double *x, double *y)
{
    y[0] += factor * x[0];
    y[1] += factor * x[1];
    y[2] += factor * x[2];
}

/* y_i += B x_{i+e} and, off the diagonal, y_{i+e} += B^T x_i. */
static void apply_block(const taut_dirichlet_rational *form, int i, int e, const double *x,
                        double *y)
{
    const size_t here = 3 * (size_t)i * (size_t)form->nv;
    const size_t there = 3 * (size_t)(i + e) * (size_t)form->nv;
    for (int j = 0; j < form->nv; j++) {
        const double *row = block_row(form, i, e, j) + (form->h - 1);
        const int from = form->h - 1 < j ? 1 - form->h : -j;
        const int to = form->h - 1 < form->nv - 1 - j ? form->h - 1 : form->nv - 1 - j;
        const size_t point = here + 3 * (size_t)j;
        for (int d = from; d <= to; d++) {
            const size_t other = there + 3 * (size_t)(j + d);
            add_multiple(row[d], x + other, y + point);
            if (e > 0) {
                add_multiple(row[d], x + point, y + other);
            }
        }
    }
}

void taut_dirichlet_rational_apply(const taut_dirichlet_rational *form, const double *x, double *y)
{
    memset(y, 0, 3 * (size_t)form->nu * (size_t)form->nv * sizeof(double));
    for (int i = 0; i < form->nu; i++) {
        for (int e = 0; e < form->k && i + e < form->nu; e++) {
            apply_block(form, i, e, x, y);
        }
    }
}

/* x_u and x_v at node (p, q): sums over R_st of their slopes. */
static void surface_slopes(const taut_dirichlet_rational *form, int p, int q, const double *x,
                           double found[2][3])
{
    const int k = form->k, h = form->h;
    const size_t first = (size_t)form->along_v.table->first[q];

    (void)find_slopes(form, p, q, form->slopes);
    memset(found, 0, 6 * sizeof(double));
    for (int a = 0; a < k; a++) {
        const size_t i = (size_t)(form->along_u.table->first[p] + a);
        const double *row = x + 3 * (i * (size_t)form->nv + first);
        for (int b = 0; b < h; b++) {
            add_multiple(form->slopes[a * h + b], row + 3 * b, found[0]);
            add_multiple(form->slopes[(k + a) * h + b], row + 3 * b, found[1]);
        }
    }
}

void taut_dirichlet_rational_energies(const taut_dirichlet_rational *form, const double *x,
                                      double halves[2])
{
    halves[0] = halves[1] = 0;
    for (int p = 0; p < form->along_u.count; p++) {
        for (int q = 0; q < form->along_v.count; q++) {
            const double weight = 0.5 * form->along_u.weights[p] * form->along_v.weights[q];
            double found[2][3];
            surface_slopes(form, p, q, x, found);
            for (int c = 0; c < 3; c++) {
                halves[0] += weight * found[0][c] * found[0][c];
                halves[1] += weight * found[1][c] * found[1][c];
            }
        }
    }
}
