/* gradient.c -- lines u = const of quadrature points, eight side by side.
 *
 * On a line the integrals over v are gathered per column of the net, then spread over the rows
 * whose functions are alive (gradient_kernel.h). Without weights phi = N_i N_j. With weights, w = sum w_st N_s N_t,
 *
 *     phi = w_ij N_i N_j / w,     phi_u = w_ij N_j (N_i' - N_i w_u / w) / w
 *
 * so the same sums run with x_u / w for x_u, and a third one takes N_i N_j (x_u w_u + ..) / w^2.
 */
#include "certify/dirichlet/gradient.h"

#include "certify/dirichlet/gradient_kernel.h"
#include "certify/dirichlet/remainder.h"
#include "core/arena.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "geometry/grid/table.h"
#include "geometry/keep.h"
#include "geometry/nurbs/cells.h"
#include "geometry/nurbs/spread.h"
#include "numeric/kernel/name.h"
#include "numeric/quadrature.h"
#include "platform/parallel.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum {
    BLOCK = 4,     /* sets of lines a task, at least */
    HALVINGS = 10, /* of cells, for the sake of a bound */
    ROUNDS = 10,   /* of halvings, for the sake of fewer nodes */
    FEW_NODES = 20,
    NODE_WORK = 200 /* operations at a node */
};

/* A remainder this small, of the integral of the absolute value, is no more than the rounding of the
 * sum; the area is at rest to 1e-10 or so, and its bounds cost more. Gauss points, and terms of the
 * cells' bounds, that a plan may cost. */
static const double dirichlet_goal = 0x1p-50, area_goal = 0x1p-46, points_most = 4e6,
                    pairs_most = 1e6;
/* Of the goal: what is missed on a cell that is not to be halved. */
static const double share_of_cell = 0x1p-4;
/* Gauss points that rules may be raised to where no bound decides: about a second of work. */
static const double raised_most = 0x1p24;

/* Gauss nodes on every span of a direction; slopes in the table are over the unit interval. */
typedef struct axis {
    taut_table *table; /* order 1 */
    double *t;
    double *weights;   /* their sum is 1 */
    double *roundings; /* degree |t| over the width of the span: what a rounding of t is there */
    double length;
    double reach; /* max |t| / length */
    int count;
    int alive; /* cells where one function is not 0, at most */
} axis;

typedef struct work {
    taut_arena *arena; /* of all below */
    axis u, v;
    int nu, nv;
    taut_surface *centred;
    const double *weights; /* of the surface, or NULL */
    double *sizes;         /* [nu][nv]: largest coordinate of each point as stored, in the unit */
    double fu, fv;         /* the larger one is 1 */
    int is_area;
    int unit;         /* its power of two */
    double roundings; /* see gradient.h */
    int nodes;        /* a cell; sums are taken over cells first, so that few terms meet */
    const taut_gradient_ops *ops;
} work;

static taut_status fill_axis(const taut_basis *basis, const taut_cells *cells, int nodes,
                             taut_arena *arena, axis *a)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    const double *breaks = taut_basis_breaks(basis);
    const size_t count = (size_t)cells->count * (size_t)nodes;
    double node[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX];

    a->count = (int)count;
    a->length = hi - lo;
    a->reach = fmax(fabs(lo), fabs(hi)) / a->length;
    a->t = taut_arena_take(arena, count, sizeof(double));
    a->weights = taut_arena_take(arena, count, sizeof(double));
    a->roundings = taut_arena_take(arena, count, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_gauss_rule(nodes, node, weight);
    for (int k = 0; k < a->count; k++) {
        const int cell = k / nodes, span = cells->span[cell];
        const double t = taut_cells_at(cells, cell, node[k % nodes]);
        const double width = cells->hi[cell] - cells->lo[cell];
        a->t[k] = t < breaks[span + 1] ? t : breaks[span]; /* the span of t must be this one */
        a->weights[k] = 0.5 * weight[k % nodes] * (width / a->length);
        a->roundings[k] = taut_basis_local(basis) * fabs(t) / taut_cells_finest(basis, span);
    }
    return TAUT_OK;
}

const taut_gradient_ops *taut_gradient_ops_chosen(void)
{
    return TAUT_KERNEL_OF(taut_gradient);
}

/* Every cell in 2^halvings alike, in the arena. */
static taut_status halve_cells(const taut_cells *cells, int halvings, taut_arena *arena,
                               taut_cells *out)
{
    const int parts = 1 << halvings;
    const size_t count = (size_t)cells->count * (size_t)parts;

    out->count = (int)count;
    out->lo = taut_arena_take(arena, count, sizeof(double));
    out->hi = taut_arena_take(arena, count, sizeof(double));
    out->span = taut_arena_take(arena, count, sizeof(int));
    for (size_t k = 0; k < count && taut_arena_status(arena) == TAUT_OK; k++) {
        const size_t whole = k / (size_t)parts, part = k % (size_t)parts;
        const double lo = cells->lo[whole], width = cells->hi[whole] - lo;
        out->span[k] = cells->span[whole];
        out->lo[k] = lo + ldexp(width, -halvings) * (double)part;
        out->hi[k] = (int)part + 1 == parts ? cells->hi[whole]
                                            : lo + ldexp(width, -halvings) * (double)(part + 1);
    }
    return taut_arena_status(arena);
}

/* The cells of direction d of a surface, in the arena. */
static taut_status cut_direction(const taut_surface *surface, int d, int halvings,
                                 taut_arena *arena, taut_cells *out)
{
    const taut_basis *basis[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const size_t nv = (size_t)taut_basis_count(basis[1]);
    taut_cells *cells = NULL;
    taut_status status =
        taut_cells_new(basis[d], taut_basis_count(basis[1 - d]), taut_surface_weights(surface),
                       d == 0 ? nv : 1, d == 0 ? 1 : nv, &cells);

    if (status == TAUT_OK) {
        status = halve_cells(cells, halvings, arena, out);
        taut_cells_free(cells);
    }
    return status;
}

/* The largest number of cells on the spans of one function. */
static int count_alive(const taut_basis *basis, const taut_cells *cells)
{
    const int local = taut_basis_local(basis);
    int most = 0;
    for (int from = 0, to = 0; from < cells->count; from++) {
        while (to < cells->count && taut_basis_first(basis, cells->span[to]) <
                                        taut_basis_first(basis, cells->span[from]) + local) {
            to++;
        }
        most = to - from > most ? to - from : most;
    }
    return most;
}

static taut_status make_axis(const taut_surface *surface, int d, const taut_gradient_rule *rule,
                             taut_arena *arena, axis *a)
{
    const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
    const taut_cells *cells = rule->cells[d];
    taut_cells halved;
    taut_status status = TAUT_OK;

    if (cells == NULL) {
        status = cut_direction(surface, d, rule->halvings, arena, &halved);
        cells = &halved;
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = fill_axis(basis, cells, rule->nodes, arena, a);
    a->alive = count_alive(basis, cells);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_table_new(basis, a->count, a->t, NULL, 1, &a->table);
    if (status != TAUT_OK) {
        return status;
    }
    for (int k = 0; k < a->count; k++) {
        double *slopes = a->table->values + (2 * (size_t)k + 1) * (size_t)a->table->local;
        for (int i = 0; i < a->table->local; i++) {
            slopes[i] *= a->length;
        }
    }
    return taut_keep_table(arena, a->table) ? TAUT_OK : TAUT_NO_MEMORY;
}

/* The exponent e with largest < 2^e, 0 for 0. */
static int exponent_of(double largest)
{
    int e = 0;
    (void)frexp(largest, &e);
    return e;
}

/* ldexp(x, -e), where the power is a number by one multiplication: as exact, or rounded as once. */
static double brought_down(double x, int e, double power)
{
    return power > 0 ? x * power : ldexp(x, -e);
}

/* 2^-e; 0 where that is no number. */
static double power_of(int e)
{
    return e > -1000 && e < 1000 ? ldexp(1, -e) : 0;
}

/* The surface with its points around 0 and of about unit size, and the sizes of the points as they
 * are. The unit is a power of two, so that scaling rounds nothing. */
static taut_status centre_surface(const taut_surface *surface, work *w)
{
    const size_t count = (size_t)w->nu * (size_t)w->nv;
    const double *p = taut_surface_points(surface);
    double *moved = taut_arena_take(w->arena, 3 * count, sizeof(double));
    double largest = 0, size = 0;
    taut_status status = TAUT_OK;
    int coarse = 0, fine = 0;

    w->sizes = taut_arena_take(w->arena, count, sizeof(double));
    if (taut_arena_status(w->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < 3 * count; i++) {
        largest = fmax(largest, fabs(p[i]));
    }
    coarse = exponent_of(largest);
    const double first = power_of(coarse);
    for (size_t i = 0; i < 3 * count; i++) { /* from the first point */
        moved[i] = brought_down(p[i], coarse, first) - brought_down(p[i % 3], coarse, first);
        size = fabs(moved[i]) > size ? fabs(moved[i]) : size;
    }
    fine = exponent_of(size);
    w->unit = coarse + fine;
    const double second = power_of(fine);
    for (size_t i = 0; i < 3 * count; i++) {
        moved[i] = brought_down(moved[i], fine, second);
    }
    for (size_t i = 0; i < count; i++) {
        /* numbers below DBL_MIN are stored with its rounding */
        const double x =
            fmax(fmax(fabs(p[3 * i]), DBL_MIN), fmax(fabs(p[3 * i + 1]), fabs(p[3 * i + 2])));
        w->sizes[i] = brought_down(brought_down(x, coarse, first), fine, second);
    }
    status = taut_surface_new("", taut_surface_u(surface), taut_surface_v(surface), moved,
                              w->weights, &w->centred, NULL);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_keep_surface(w->arena, w->centred) ? TAUT_OK : TAUT_NO_MEMORY;
}

/* The factors of |x_u|^2 and |x_v|^2 over the unit square. */
static void find_form_factors(const taut_surface *surface, double aspect, double *fu, double *fv)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double f =
        aspect * ((taut_basis_hi(v) - taut_basis_lo(v)) / (taut_basis_hi(u) - taut_basis_lo(u)));
    *fu = f >= 1 ? 1 : f * f;
    *fv = f >= 1 ? 1 / f / f : 1;
}

/* Terms that meet in one sum, of a cell and of the cells where a function is not 0, line by line; and
 * what each of them went through: values of functions, sums over the net, the form. Lines side by side
 * meet in fewer additions than that. */
static double count_roundings(const work *w, int nodes)
{
    double roundings = 24;
    for (int d = 0; d < 2; d++) {
        const axis *a = d == 0 ? &w->u : &w->v;
        roundings += nodes + a->alive + 8.0 * a->table->local;
    }
    return roundings;
}

/* w->arena is there, or NULL. */
static taut_status prepare(const taut_surface *surface, double aspect,
                           const taut_gradient_rule *rule, work *w)
{
    taut_status status = TAUT_OK;

    w->nu = taut_basis_count(taut_surface_u(surface));
    w->nv = taut_basis_count(taut_surface_v(surface));
    w->weights = taut_surface_weights(surface);
    status = make_axis(surface, 0, rule, w->arena, &w->u);
    if (status != TAUT_OK) {
        return status;
    }
    status = make_axis(surface, 1, rule, w->arena, &w->v);
    if (status != TAUT_OK) {
        return status;
    }
    status = centre_surface(surface, w);
    if (status != TAUT_OK) {
        return status;
    }
    w->nodes = rule->nodes;
    w->ops = taut_gradient_ops_chosen();
    find_form_factors(surface, aspect, &w->fu, &w->fv);
    w->roundings = count_roundings(w, rule->nodes);
    return taut_arena_status(w->arena);
}

/* A task of lines that follow each other, whole sets; no two that are two apart share a row. */
typedef struct block {
    int from, to; /* lines */
    double sums[TAUT_GRADIENT_SUMS];
} block;

/* What the tasks of one gradient share. */
typedef struct job {
    const work *w;
    taut_gradient_net net;
    taut_dirichlet_gradient *g;
    int set;  /* lines whose rows are summed before they go to the net's, so that few terms meet */
    int most; /* functions of u alive on a set, at most */
    block *blocks;
    int count;
    int parity;      /* of the blocks at hand */
    size_t numbers;  /* of one worker's scratch: */
    double *scratch; /* [workers][numbers] */
    size_t rows, n;  /* where in it rows[most][nv][TAUT_CHANNELS], n[2][most][TAUT_SHEAF] begin */
} job;

/* The last line of the set that begins at `line`, and the functions alive on it. */
static int end_of_set(const work *w, int line, int set, int *first, int *alive)
{
    const int end = w->u.count - line < set ? w->u.count : line + set;
    *first = w->u.table->first[line];
    *alive = w->u.table->first[end - 1] + w->u.table->local - *first;
    return end;
}

/* Functions and rule of eight lines from `line` on, before `end`; first: of the set. */
static void fill_sheaf(const work *w, int line, int end, double *n, double rule[2][TAUT_SHEAF],
                       taut_gradient_sheaf *sheaf)
{
    const taut_table *table = w->u.table;
    const int last = line + TAUT_SHEAF < end ? line + TAUT_SHEAF - 1 : end - 1;
    double *slopes = NULL;

    sheaf->first = table->first[line];
    sheaf->alive = table->first[last] + table->local - sheaf->first;
    slopes = n + (size_t)sheaf->alive * TAUT_SHEAF;
    memset(n, 0, 2 * (size_t)sheaf->alive * TAUT_SHEAF * sizeof(double));
    for (int l = 0; l < TAUT_SHEAF; l++) { /* those beyond the last are that one, without weight */
        const int at = line + l < last ? line + l : last;
        for (int a = 0; a < table->local; a++) {
            const int row = (table->first[at] - sheaf->first + a) * TAUT_SHEAF + l;
            n[row] = taut_table_row(table, at, 0)[a];
            slopes[row] = taut_table_row(table, at, 1)[a];
        }
        rule[0][l] = line + l <= last ? w->u.weights[at] : 0;
        rule[1][l] = w->u.roundings[at];
    }
    sheaf->n = n;
    sheaf->slopes = slopes;
    sheaf->rule = rule[0];
    sheaf->roundings = rule[1];
}

/* The rows of a set go to values and gross. */
static void end_set(const job *j, int first, int alive, const double *rows)
{
    const size_t from = (size_t)first * (size_t)j->w->nv;
    const size_t count = (size_t)alive * (size_t)j->w->nv;

    for (size_t i = 0; i < count; i++) {
        for (size_t c = 0; c < 3; c++) {
            j->g->values[3 * (from + i) + c] += rows[TAUT_CHANNELS * i + c];
        }
        j->g->gross[from + i] += rows[TAUT_CHANNELS * i + 3];
    }
}

static void integrate_block(void *context, int worker, int64_t task)
{
    const job *j = context;
    const work *w = j->w;
    block *b = &j->blocks[2 * task + j->parity];
    double *scratch = j->scratch + (size_t)worker * j->numbers, *rows = scratch + j->rows;

    for (int line = b->from, end = 0; line < b->to; line = end) {
        int first = 0, alive = 0;
        end = end_of_set(w, line, j->set, &first, &alive);
        memset(rows, 0, TAUT_CHANNELS * (size_t)alive * (size_t)w->nv * sizeof(double));
        for (int at = line; at < end; at += TAUT_SHEAF) {
            double rule[2][TAUT_SHEAF];
            taut_gradient_sheaf sheaf;
            fill_sheaf(w, at, end, scratch + j->n, rule, &sheaf);
            w->ops->add(&j->net, &sheaf, scratch,
                        rows + TAUT_CHANNELS * (size_t)(sheaf.first - first) * (size_t)w->nv,
                        b->sums);
        }
        end_set(j, first, alive, rows);
    }
}

/* Cuts the lines into blocks of some sets each, and finds the most functions alive on one. */
static taut_status cut_blocks(job *j)
{
    const work *w = j->w;
    int reached = 0, last = 0; /* the row after the block's before, and after this one's */

    j->blocks = taut_arena_take(w->arena, (size_t)w->u.count / (size_t)j->set + 1, sizeof(block));
    if (j->blocks == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int line = 0, from = 0, end = 0; line < w->u.count; line = end) {
        int first = 0, alive = 0;
        end = end_of_set(w, line, j->set, &first, &alive);
        if (line - from >= BLOCK * j->set && first >= reached) {
            j->blocks[j->count++] = (block){.from = from, .to = line};
            from = line;
            reached = last;
        }
        last = first + alive;
        j->most = alive > j->most ? alive : j->most;
        if (end == w->u.count) {
            j->blocks[j->count++] = (block){.from = from, .to = end};
        }
    }
    return TAUT_OK;
}

static void begin_net(const work *w, job *j)
{
    j->net = (taut_gradient_net){.nv = w->nv,
                                 .local = w->v.table->local,
                                 .nodes = w->nodes,
                                 .count = w->v.count,
                                 .is_area = w->is_area,
                                 .points = taut_surface_points(w->centred),
                                 .weights = w->weights,
                                 .sizes = w->sizes,
                                 .first = w->v.table->first,
                                 .values = w->v.table->values,
                                 .rule = w->v.weights,
                                 .roundings = w->v.roundings,
                                 .fu = w->fu,
                                 .fv = w->fv,
                                 .reach_u = w->u.reach,
                                 .reach_v = w->v.reach};
}

/* From the sums of the blocks, in their order. */
static void take_sums(const job *j, taut_dirichlet_gradient *g)
{
    const double ratio = j->w->v.length / j->w->u.length;
    double sums[TAUT_GRADIENT_SUMS] = {0};

    for (int b = 0; b < j->count; b++) {
        for (int i = 0; i < TAUT_GRADIENT_SUMS; i++) {
            sums[i] += j->blocks[b].sums[i];
        }
    }
    g->area = sums[TAUT_AREA_SUM];
    g->halves[0] = sums[TAUT_HALVES] * ratio;
    g->halves[1] = sums[TAUT_HALVES + 1] / ratio;
    if (!j->w->is_area) {
        g->halves_gross[0] = 2 * sums[TAUT_HALVES_GROSS] * ratio;
        g->halves_gross[1] = 2 * sums[TAUT_HALVES_GROSS + 1] / ratio;
    }
}

/* Operations of a block, as pulses count them. */
static double work_of_block(const job *j)
{
    return NODE_WORK * (double)(BLOCK * j->set) * j->w->v.count;
}

/* Blocks of even number, which share nothing, then those of odd number: any number of threads gives
 * the same sums in the same order. */
static taut_status integrate_surface(const work *w, const taut_crew *crew,
                                     taut_dirichlet_gradient *g)
{
    job j = {.w = w, .g = g, .set = (w->nodes + TAUT_SHEAF - 1) / TAUT_SHEAF * TAUT_SHEAF};

    if (cut_blocks(&j) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    begin_net(w, &j);
    const int workers = taut_crew_workers(crew, (j.count + 1) / 2);
    j.rows = taut_gradient_scratch(j.net.local, w->nodes);
    j.n = j.rows + TAUT_CHANNELS * (size_t)j.most * (size_t)w->nv;
    j.numbers = j.n + 2 * (size_t)j.most * TAUT_SHEAF;
    j.scratch = taut_arena_take(w->arena, (size_t)workers * j.numbers, sizeof(double));
    if (j.scratch == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (j.parity = 0; j.parity < 2; j.parity++) {
        const int tasks = (j.count + 1 - j.parity) / 2;
        if (taut_crew_run(crew, taut_parallel_workers(workers, tasks), tasks, work_of_block(&j),
                          integrate_block, &j)) {
            return TAUT_INTERRUPTED;
        }
    }
    take_sums(&j, g);
    return TAUT_OK;
}

static taut_status find_gradient(const taut_surface *surface, double aspect,
                                 const taut_gradient_rule *rule, work *w,
                                 taut_dirichlet_gradient *made)
{
    const taut_status status = prepare(surface, aspect, rule, w);
    const size_t count = (size_t)w->nu * (size_t)w->nv;

    if (status != TAUT_OK) {
        return status;
    }
    made->unit = w->unit;
    made->values = taut_alloc_zero(3 * count, sizeof(double));
    made->gross = taut_alloc_zero(count, sizeof(double));
    if (made->values == NULL || made->gross == NULL) {
        return TAUT_NO_MEMORY;
    }
    return integrate_surface(w, rule->crew, made);
}

static taut_status gradient_new(const taut_surface *surface, int is_area, double aspect,
                                const taut_gradient_rule *rule, taut_dirichlet_gradient *gradient)
{
    taut_dirichlet_gradient made = {.unit = 0};
    work w = {.arena = taut_arena_new(), .is_area = is_area};
    const taut_status status = find_gradient(surface, aspect, rule, &w, &made);

    taut_arena_free(w.arena);
    if (status != TAUT_OK) {
        taut_dirichlet_gradient_clear(&made);
        return status;
    }
    made.roundings = w.roundings;
    made.remainder = rule->remainder;
    made.points = (double)w.u.count * w.v.count;
    made.spans = (double)taut_basis_span_count(taut_surface_u(surface)) *
                 taut_basis_span_count(taut_surface_v(surface));
    *gradient = made;
    return TAUT_OK;
}

taut_status taut_dirichlet_gradient_new(const taut_surface *surface, double aspect,
                                        const taut_gradient_rule *rule,
                                        taut_dirichlet_gradient *gradient)
{
    return gradient_new(surface, 0, aspect, rule, gradient);
}

taut_status taut_area_gradient_new(const taut_surface *surface, const taut_gradient_rule *rule,
                                   taut_dirichlet_gradient *gradient)
{
    return gradient_new(surface, 1, 1, rule, gradient);
}

/* ---- where to halve: the rows and columns of cells that need it ---- */

typedef struct plan {
    taut_arena *arena;
    taut_remainder_request in;
    taut_cells cells[2];
    double goal; /* of the remainder: INFINITY where a cell has no bound */
    int is_enough;
    double cost; /* Gauss points of the best rule so far */
    taut_gradient_rule best;
    taut_cells taken[2]; /* its cells */
} plan;

/* Takes the cheapest rule on these cells whose remainder is below the noise, and else the best. */
static void take_rule(plan *p, const double remainder[TAUT_REMAINDER_RULES])
{
    for (int k = 0; k < TAUT_REMAINDER_RULES; k++) {
        const int nodes = taut_remainder_nodes[k];
        const double points = (double)p->cells[0].count * p->cells[1].count * nodes * nodes;
        const int enough = remainder[k] <= p->goal;
        if (points <= points_most && isfinite(remainder[k]) &&
            (enough ? !p->is_enough || points < p->cost
                    : !p->is_enough && remainder[k] < p->best.remainder)) {
            p->best =
                (taut_gradient_rule){.nodes = nodes, .remainder = remainder[k], .crew = p->in.crew};
            memcpy(p->taken, p->cells, sizeof p->taken);
            p->cost = points;
            p->is_enough = enough;
        }
    }
}

/* marks[d][k]: cell k of direction d is to be halved; returns how many. Cells without a bound come
 * first, in both directions; once all have one, those that miss too much, in the direction that
 * does. */
static int mark_cells(const plan *p, char *const marks[2])
{
    const double most = share_of_cell * p->goal;
    const size_t nv = (size_t)p->cells[1].count, pairs = (size_t)p->cells[0].count * nv;
    int count = 0;

    for (size_t k = 0; k < pairs; k++) {
        const double *missed = p->in.missed + 2 * k;
        const int is_unbounded = !isfinite(missed[0] + missed[1]);
        for (int d = 0; d < 2; d++) {
            char *mark = marks[d] + (d == 0 ? k / nv : k % nv);
            const int is_marked = is_unbounded || missed[d] > most;
            count += is_marked && !*mark;
            *mark = *mark || is_marked;
        }
    }
    return count;
}

static taut_status halve_marked(const taut_cells *cells, const char *marks, taut_arena *arena,
                                taut_cells *out)
{
    const size_t most = 2 * (size_t)cells->count;

    out->count = 0;
    out->lo = taut_arena_take(arena, most, sizeof(double));
    out->hi = taut_arena_take(arena, most, sizeof(double));
    out->span = taut_arena_take(arena, most, sizeof(int));
    for (int k = 0; k < cells->count && taut_arena_status(arena) == TAUT_OK; k++) {
        const double lo = cells->lo[k], hi = cells->hi[k], middle = lo + 0.5 * (hi - lo);
        const int parts = marks[k] && middle > lo && middle < hi ? 2 : 1;
        for (int part = 0; part < parts; part++) {
            out->lo[out->count] = part == 0 ? lo : middle;
            out->hi[out->count] = part + 1 == parts ? hi : middle;
            out->span[out->count++] = cells->span[k];
        }
    }
    return taut_arena_status(arena);
}

/* Bounds the rules on the cells at hand, and takes the best. */
static taut_status try_cells(plan *p)
{
    const size_t pairs = (size_t)p->cells[0].count * (size_t)p->cells[1].count;
    double remainder[TAUT_REMAINDER_RULES], scale = INFINITY;

    p->in.cells[0] = &p->cells[0];
    p->in.cells[1] = &p->cells[1];
    p->in.missed = taut_arena_take(p->arena, pairs, 2 * sizeof(double));
    if (p->in.missed == NULL ||
        taut_gradient_remainder(&p->in, p->arena, remainder, &scale) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    p->goal = (p->in.is_area ? area_goal : dirichlet_goal) * scale;
    take_rule(p, remainder);
    return TAUT_OK;
}

/* Halves what needs it. *is_done: nothing does, or it cannot be afforded. */
static taut_status refine_cells(plan *p, int *is_done)
{
    const double work_of_pair =
        (double)taut_basis_local(p->in.basis[0]) * taut_basis_local(p->in.basis[1]);
    taut_cells finer[2];
    char *marks[2];

    for (int d = 0; d < 2; d++) {
        marks[d] = taut_arena_take(p->arena, (size_t)p->cells[d].count, 1);
    }
    if (taut_arena_status(p->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    *is_done = mark_cells(p, marks) == 0;
    for (int d = 0; d < 2; d++) {
        if (halve_marked(&p->cells[d], marks[d], p->arena, &finer[d]) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
    }
    *is_done |= (double)finer[0].count * finer[1].count * work_of_pair > pairs_most;
    memcpy(p->cells, finer, sizeof finer);
    return TAUT_OK;
}

static taut_status search_rule(plan *p)
{
    int is_done = 0;

    for (int round = 0; !is_done; round++) {
        taut_status status = try_cells(p);
        if (status != TAUT_OK) {
            return status;
        }
        if ((p->is_enough && p->best.nodes <= FEW_NODES) ||
            round == (isfinite(p->goal) ? ROUNDS : HALVINGS)) {
            return TAUT_OK; /* half the nodes on half the cells will not do */
        }
        status = refine_cells(p, &is_done);
        if (status != TAUT_OK) {
            return status;
        }
    }
    return TAUT_OK;
}

static taut_status plan_rule(const taut_surface *surface, int is_area, double aspect,
                             const taut_crew *crew, taut_arena *arena, taut_gradient_rule *rule)
{
    plan p = {
        .arena = arena,
        .in = {.basis = {taut_surface_u(surface), taut_surface_v(surface)},
               .weights = taut_surface_weights(surface),
               .is_area = is_area,
               .crew = crew},
        .cost = INFINITY,
        .best = {.remainder = INFINITY, .crew = crew},
    };
    work w = {.arena = arena, .weights = p.in.weights};
    taut_status status = TAUT_OK;

    w.nu = taut_basis_count(p.in.basis[0]);
    w.nv = taut_basis_count(p.in.basis[1]);
    status = centre_surface(surface, &w);
    if (status != TAUT_OK) {
        return status;
    }
    p.in.points = taut_surface_points(w.centred);
    find_form_factors(surface, aspect, &p.in.fu, &p.in.fv);
    for (int d = 0; d < 2; d++) {
        if (cut_direction(surface, d, 0, arena, &p.cells[d]) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
    }
    status = search_rule(&p);
    *rule = p.best;
    for (int d = 0; d < 2 && status == TAUT_OK && rule->nodes > 0; d++) {
        status = taut_cells_copy(&p.taken[d], &rule->cells[d]);
    }
    return status;
}

taut_status taut_gradient_plan(const taut_surface *surface, int is_area, double aspect,
                               const taut_crew *crew, taut_gradient_rule *rule)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const int local =
        taut_basis_local(u) > taut_basis_local(v) ? taut_basis_local(u) : taut_basis_local(v);
    taut_gradient_rule made = {.remainder = INFINITY, .crew = crew};

    if (!is_area && taut_surface_weights(surface) == NULL && taut_basis_degree(u) >= 0 &&
        taut_basis_degree(v) >= 0) {
        *rule =
            (taut_gradient_rule){.nodes = local + 1, .crew = crew}; /* exact with one node less */
        return TAUT_OK;
    }
    if (taut_weight_spread(surface) > TAUT_SPREAD_MAX) {
        *rule = made;
        return TAUT_OK;
    }
    taut_arena *arena = taut_arena_new();
    const taut_status status = plan_rule(surface, is_area, aspect, crew, arena, &made);

    taut_arena_free(arena);
    if (status == TAUT_OK) {
        *rule = made;
    } else {
        taut_gradient_rule_clear(&made);
    }
    return status;
}

int taut_gradient_raise(taut_gradient_rule *rule, const taut_dirichlet_gradient *before)
{
    const int more = rule->nodes + rule->nodes / 2;
    const int nodes = more < TAUT_GAUSS_MAX ? more : TAUT_GAUSS_MAX;
    const double growth = (double)nodes / rule->nodes;
    const double most =
        fmax(raised_most, before->spans * (double)TAUT_GAUSS_MAX * (double)TAUT_GAUSS_MAX);

    if (nodes == rule->nodes || before->points * growth * growth > most) {
        return 0;
    }
    rule->nodes = nodes;
    return 1;
}

void taut_gradient_rule_clear(taut_gradient_rule *rule)
{
    taut_cells_free(rule->cells[0]);
    taut_cells_free(rule->cells[1]);
    memset(rule, 0, sizeof *rule);
}

void taut_dirichlet_gradient_clear(taut_dirichlet_gradient *gradient)
{
    taut_free(gradient->values);
    taut_free(gradient->gross);
    memset(gradient, 0, sizeof *gradient);
}
