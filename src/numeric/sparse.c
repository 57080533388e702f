/* sparse.c -- least degree, then fronts.
 *
 *     order    a node that is eliminated joins its cliques into one, without itself; nodes that are left with this clique alone
 *              have no other neighbours and go with it, at no fill
 *     factor   front of a group: its rows of A, what the groups below left of theirs, added; its own
 *              columns eliminated; what is left goes to the group that joined its clique
 */
#include "numeric/sparse.h"

#include "core/arena.h"
#include "core/memory.h"
#include "numeric/front.h"

#include <string.h>

/* A list of ints that grows in an arena. */
typedef struct list {
    int *at;
    int count;
} list;

/* Nodes that are eliminated together, and what their clique is. */
typedef struct group {
    int *nodes; /* its own, then the others of its clique */
    int own, count;
    int rows, own_rows;
    int parent, child, next; /* groups, -1: none; children in the order they came */
    double *columns;         /* [rows][own_rows]: L below, D on the diagonal */
    double *update;          /* [rows - own_rows] squared, until the parent takes it */
} group;

struct taut_sparse {
    taut_arena *arena;
    int nodes, rows;
    unsigned char *sizes;
    int *row;        /* [nodes] */
    list *neighbors; /* [nodes]: blocks of A, itself too */
    group *groups;
    int group_count;
    int *place; /* [nodes]: scratch: its first row in a front */
    double work;
    double *gathered; /* [rows] */
};

/* What is known while the order is found. */
typedef struct graph {
    taut_arena *arena;
    list *cliques; /* [count]: members */
    int *owner;    /* [count]: the group that made it, -1: given; */
    int *joined;   /* [count]: is it part of another by now? */
    int count;
    list *of;    /* [nodes]: cliques of a node */
    int *degree; /* [nodes]; -1: gone */
    int *mark;   /* [nodes] */
    int stamp;
    int *scratch; /* [nodes] */
} graph;

/* The members of the cliques of a node, itself first, into scratch: how many. */
static int gather(graph *g, int node)
{
    int count = 0;

    g->stamp++;
    g->mark[node] = g->stamp;
    g->scratch[count++] = node;
    for (int k = 0; k < g->of[node].count; k++) {
        const list *clique = &g->cliques[g->of[node].at[k]];
        for (int m = 0; m < clique->count; m++) {
            const int other = clique->at[m];
            if (g->mark[other] != g->stamp && g->degree[other] >= 0) {
                g->mark[other] = g->stamp;
                g->scratch[count++] = other;
            }
        }
    }
    return count;
}

static int weigh(const taut_sparse *s, const int *nodes, int count)
{
    int rows = 0;
    for (int k = 0; k < count; k++) {
        rows += s->sizes[nodes[k]];
    }
    return rows;
}

/* A copy; of no numbers it is no NULL either, which is left to want of memory. */
static list keep(taut_arena *arena, const int *from, int count)
{
    list kept = {taut_arena_take(arena, (size_t)count + 1, sizeof(int)), count};
    if (kept.at == NULL) {
        kept.count = 0;
    } else if (count > 0) {
        memcpy(kept.at, from, (size_t)count * sizeof(int));
    }
    return kept;
}

/* Joins the cliques of `pivot` into clique number g->count, without the group's own. */
static taut_status eliminate(taut_sparse *s, graph *g, int pivot)
{
    group *const made = &s->groups[s->group_count];
    const int count = gather(g, pivot), clique = g->count++;
    int *nodes = taut_arena_copy(g->arena, g->scratch, (size_t)count, sizeof(int));

    made->nodes = taut_arena_take(s->arena, (size_t)count, sizeof(int));
    if (nodes == NULL || made->nodes == NULL) {
        return TAUT_NO_MEMORY;
    }
    made->parent = made->child = made->next = -1;
    for (int k = 0; k < g->of[pivot].count; k++) {
        const int old = g->of[pivot].at[k];
        if (g->owner[old] >= 0) { /* in the order they came: the last is put in front */
            s->groups[g->owner[old]].parent = s->group_count;
            s->groups[g->owner[old]].next = made->child;
            made->child = g->owner[old];
        }
        g->joined[old] = 1;
    }
    g->owner[clique] = s->group_count++;
    for (int k = 1; k < count; k++) { /* whose cliques were joined */
        list *of = &g->of[nodes[k]];
        int left = 0;
        for (int m = 0; m < of->count; m++) {
            if (!g->joined[of->at[m]]) {
                of->at[left++] = of->at[m];
            }
        }
        of->at[left++] = clique; /* at least one was joined */
        of->count = left;
    }
    int own = 0, others = 0;
    for (int k = 0; k < count; k++) {
        if (k == 0 || g->of[nodes[k]].count == 1) {
            made->nodes[own++] = nodes[k];
            g->degree[nodes[k]] = -1;
        } else {
            g->scratch[others++] = nodes[k];
        }
    }
    memcpy(made->nodes + own, g->scratch, (size_t)others * sizeof(int));
    made->own = own;
    made->count = count;
    made->own_rows = weigh(s, made->nodes, own);
    made->rows = weigh(s, made->nodes, count);
    s->work += (double)made->own_rows * made->rows * made->rows;
    g->cliques[clique] = keep(g->arena, made->nodes + own, others);
    for (int k = 0; k < others; k++) {
        const int node = made->nodes[own + k];
        g->degree[node] = weigh(s, g->scratch, gather(g, node));
    }
    return taut_arena_status(g->arena);
}

static taut_status order(taut_sparse *s, graph *g)
{
    for (int a = 0; a < s->nodes; a++) {
        const int count = gather(g, a);
        g->degree[a] = weigh(s, g->scratch, count);
        s->neighbors[a] = keep(s->arena, g->scratch, count);
    }
    for (taut_status status = taut_arena_status(s->arena);;) {
        int pivot = -1;
        for (int a = 0; a < s->nodes; a++) {
            if (g->degree[a] >= 0 && (pivot < 0 || g->degree[a] < g->degree[pivot])) {
                pivot = a;
            }
        }
        if (pivot < 0 || status != TAUT_OK) {
            return status;
        }
        status = eliminate(s, g, pivot);
    }
}

static taut_status prepare(taut_sparse *s, int cliques, const int *first, const int *members,
                           graph *g)
{
    const size_t nodes = (size_t)s->nodes, most = (size_t)cliques + nodes;

    g->cliques = taut_arena_take(g->arena, most, sizeof *g->cliques);
    g->owner = taut_arena_take(g->arena, most, sizeof(int));
    g->joined = taut_arena_take(g->arena, most, sizeof(int));
    g->of = taut_arena_take(g->arena, nodes, sizeof *g->of);
    g->degree = taut_arena_take(g->arena, nodes, sizeof(int));
    g->mark = taut_arena_take(g->arena, nodes, sizeof(int));
    g->scratch = taut_arena_take(g->arena, nodes, sizeof(int));
    int *all = taut_arena_take(g->arena, (size_t)first[cliques] + nodes, sizeof(int));
    if (taut_arena_status(g->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    g->count = cliques;
    for (int k = 0; k < cliques; k++) {
        g->owner[k] = -1;
        g->cliques[k] = keep(g->arena, members + first[k], first[k + 1] - first[k]);
        for (int m = first[k]; m < first[k + 1]; m++) {
            g->of[members[m]].count++;
        }
    }
    for (size_t a = 0; a < nodes; a++) { /* room for one more, the clique that is made */
        g->of[a].at = all;
        all += g->of[a].count + 1;
        g->of[a].count = 0;
    }
    for (int k = 0; k < cliques; k++) {
        for (int m = first[k]; m < first[k + 1]; m++) {
            list *of = &g->of[members[m]];
            of->at[of->count++] = k;
        }
    }
    return taut_arena_status(g->arena);
}

static taut_status plan(taut_sparse *s, int cliques, const int *first, const int *members)
{
    graph g = {.arena = taut_arena_new()};
    taut_status status = prepare(s, cliques, first, members, &g);

    if (status == TAUT_OK) {
        status = order(s, &g);
    }
    taut_arena_free(g.arena);
    for (int k = 0; status == TAUT_OK && k < s->group_count; k++) {
        group *at = &s->groups[k];
        at->columns =
            taut_arena_take(s->arena, (size_t)at->rows * (size_t)at->own_rows + 1, sizeof(double));
    }
    return status == TAUT_OK ? taut_arena_status(s->arena) : status;
}

taut_status taut_sparse_new(int nodes, const unsigned char *sizes, int cliques, const int *first,
                            const int *members, taut_sparse **sparse)
{
    taut_sparse *s = taut_alloc_zero(1, sizeof *s);
    if (s == NULL) {
        return TAUT_NO_MEMORY;
    }
    s->arena = taut_arena_new();
    s->nodes = nodes;
    s->sizes = taut_arena_copy(s->arena, sizes, (size_t)nodes, 1);
    s->row = taut_arena_take(s->arena, (size_t)nodes, sizeof(int));
    s->place = taut_arena_take(s->arena, (size_t)nodes, sizeof(int));
    s->neighbors = taut_arena_take(s->arena, (size_t)nodes, sizeof *s->neighbors);
    s->groups = taut_arena_take(s->arena, (size_t)nodes, sizeof *s->groups);
    for (int a = 0; taut_arena_status(s->arena) == TAUT_OK && a < nodes; a++) {
        s->row[a] = s->rows;
        s->rows += sizes[a];
    }
    s->gathered = taut_arena_take(s->arena, (size_t)s->rows + 1, sizeof(double));
    taut_status status = taut_arena_status(s->arena);
    if (status == TAUT_OK) {
        status = plan(s, cliques, first, members);
    }
    if (status != TAUT_OK) {
        taut_sparse_free(s);
        return status;
    }
    *sparse = s;
    return TAUT_OK;
}

static void drop_updates(taut_sparse *s)
{
    for (int k = 0; k < s->group_count; k++) {
        taut_free(s->groups[k].update);
        s->groups[k].update = NULL;
    }
}

void taut_sparse_free(taut_sparse *sparse)
{
    if (sparse != NULL) {
        taut_arena_free(sparse->arena);
        taut_free(sparse);
    }
}

int taut_sparse_rows(const taut_sparse *sparse)
{
    return sparse->rows;
}

int taut_sparse_row(const taut_sparse *sparse, int node)
{
    return sparse->row[node];
}

double taut_sparse_work(const taut_sparse *sparse)
{
    return sparse->work;
}

/* ---- the factor ---- */

/* The rows of A of the group's own nodes, into the lower half of the front. */
static void load_rows(taut_sparse *s, const group *at, taut_sparse_block *block,
                      const void *context, double *front)
{
    const size_t stride = taut_front_stride((size_t)at->rows);
    int place = 0;

    for (int k = 0; k < at->count; k++) {
        s->place[at->nodes[k]] = place;
        place += s->sizes[at->nodes[k]];
    }
    for (int k = 0; k < at->own; k++) {
        const int a = at->nodes[k], na = s->sizes[a];
        const int column = s->place[a];
        for (int m = 0; na > 0 && m < s->neighbors[a].count; m++) {
            const int b = s->neighbors[a].at[m], nb = s->sizes[b], row = s->place[b];
            double entries[9];
            if (row < column || nb == 0) { /* -1: gone before */
                continue;
            }
            block(context, b, a, entries);
            for (int i = 0; i < nb; i++) {
                for (int j = 0; j < na; j++) {
                    front[(size_t)(row + i) * stride + (size_t)(column + j)] = entries[i * na + j];
                }
            }
        }
    }
}

/* What a group below left, added where its nodes are now. */
static void add_update(const taut_sparse *s, const group *child, int *at, double *front,
                       size_t stride)
{
    const size_t count = (size_t)(child->rows - child->own_rows);
    size_t n = 0;

    for (int k = child->own; k < child->count; k++) {
        for (int i = 0; i < s->sizes[child->nodes[k]]; i++) {
            at[n++] = s->place[child->nodes[k]] + i;
        }
    }
    for (size_t i = 0; i < count; i++) {
        for (size_t j = 0; j <= i; j++) {
            const size_t p = (size_t)at[i], q = (size_t)at[j];
            front[p > q ? p * stride + q : q * stride + p] += child->update[i * count + j];
        }
    }
}

static taut_status store(group *at, const double *front)
{
    const size_t rows = (size_t)at->rows, own = (size_t)at->own_rows, left = rows - own;
    const size_t stride = taut_front_stride(rows);

    for (size_t i = 0; i < rows; i++) {
        memcpy(at->columns + i * own, front + i * stride, own * sizeof(double));
    }
    at->update = taut_alloc(left * left + 1, sizeof(double));
    if (at->update == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < left; i++) {
        memcpy(at->update + i * left, front + (own + i) * stride + own, (i + 1) * sizeof(double));
    }
    return TAUT_OK;
}

static taut_status factor_group(taut_sparse *s, int k, taut_sparse_block *block,
                                const void *context, double *front, double *work, int *scratch,
                                taut_pulse *pulse, int *negative)
{
    group *at = &s->groups[k];
    const size_t rows = (size_t)at->rows, own = (size_t)at->own_rows;

    taut_front_clear(rows, front);
    load_rows(s, at, block, context, front);
    for (int child = at->child; child >= 0; child = s->groups[child].next) {
        add_update(s, &s->groups[child], scratch, front, taut_front_stride(rows));
        taut_free(s->groups[child].update);
        s->groups[child].update = NULL;
    }
    *negative += taut_front_factor(rows, own, front, work, pulse);
    for (int m = 0; m < at->own; m++) {
        s->place[at->nodes[m]] = -1;
    }
    return taut_pulse_is_stopped(pulse) ? TAUT_INTERRUPTED : store(at, front);
}

taut_status taut_sparse_factor(taut_sparse *sparse, taut_sparse_block *block, const void *context,
                               taut_pulse *pulse, int *negative)
{
    taut_arena *arena = taut_arena_new();
    size_t most = 0;

    for (int k = 0; k < sparse->group_count; k++) {
        const size_t rows = (size_t)sparse->groups[k].rows;
        most = rows > most ? rows : most;
    }
    double *front = taut_arena_take_raw(arena, taut_front_size(most), sizeof(double));
    double *work = taut_arena_take_raw(arena, taut_front_scratch(most), sizeof(double));
    int *scratch = taut_arena_take_raw(arena, most + 1, sizeof(int));
    taut_status status = taut_arena_status(arena);
    *negative = 0;
    for (int a = 0; a < sparse->nodes; a++) {
        sparse->place[a] = 0;
    }
    for (int k = 0; status == TAUT_OK && k < sparse->group_count; k++) {
        status = factor_group(sparse, k, block, context, front, work, scratch, pulse, negative);
    }
    drop_updates(sparse);
    taut_arena_free(arena);
    return status;
}

/* x of a group's rows, and back. */
static size_t take_rows(const taut_sparse *s, const group *at, const double *x, double *rows)
{
    size_t n = 0;
    for (int k = 0; k < at->count; k++) {
        for (int i = 0; i < s->sizes[at->nodes[k]]; i++) {
            rows[n++] = x[s->row[at->nodes[k]] + i];
        }
    }
    return n;
}

static void put_rows(const taut_sparse *s, const group *at, const double *rows, double *x)
{
    size_t n = 0;
    for (int k = 0; k < at->count; k++) {
        for (int i = 0; i < s->sizes[at->nodes[k]]; i++) {
            x[s->row[at->nodes[k]] + i] = rows[n++];
        }
    }
}

void taut_sparse_solve(const taut_sparse *sparse, double *x)
{
    for (int g = 0; g < sparse->group_count; g++) {
        const group *at = &sparse->groups[g];
        const size_t own = (size_t)at->own_rows, rows = take_rows(sparse, at, x, sparse->gathered);
        double *y = sparse->gathered;
        for (size_t i = 1; i < rows; i++) {
            for (size_t k = 0; k < own && k < i; k++) {
                y[i] -= at->columns[i * own + k] * y[k];
            }
        }
        put_rows(sparse, at, y, x);
    }
    for (int g = sparse->group_count - 1; g >= 0; g--) {
        const group *at = &sparse->groups[g];
        const size_t own = (size_t)at->own_rows, rows = take_rows(sparse, at, x, sparse->gathered);
        double *y = sparse->gathered;
        for (size_t k = own; k-- > 0;) {
            y[k] /= at->columns[k * own + k];
            for (size_t i = k + 1; i < rows; i++) {
                y[k] -= at->columns[i * own + k] * y[i];
            }
        }
        put_rows(sparse, at, y, x);
    }
}
