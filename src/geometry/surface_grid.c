/* surface_grid.c -- evaluation on a grid, by the tensor structure.
 *
 * Basis functions are worked out once per line, then each row contracts the net along u into one
 * polygon per derivative of u, and the points of the row contract those along v: Q_k[j] = sum_a
 * d^kN_a(u) P[a][j],     x_{u^k v^l} = sum_b d^lN_b(v) Q_k[b] The v parameters are taken in blocks
 * whose basis functions and values stay in the first cache while all rows pass over them; only the
 * columns of the net that a block needs are contracted.
 */
#include "core/memory.h"
#include "core/parallel.h"
#include "geometry/grid_kernel.h"
#include "geometry/net.h"
#include "geometry/table.h"
#include "taut/surface.h"

#include <string.h>

/* Streamed stores pay once the result is larger than the caches keep for later use. */
static const size_t streaming_bytes = (size_t)4 << 20;

static const int order_u[6] = {0, 1, 0, 2, 1, 0};
static const int order_v[6] = {0, 0, 1, 0, 1, 2};

enum { VECTORS_MAX = 6, DIM_MAX = 4, ORDERS = 3 };

/* What all threads share; nothing in it changes while they run. */
typedef struct grid {
    const taut_grid_ops *ops;
    const taut_table *u;
    const double *basis_v; /* [order+1][local_v][stride]: functions at all v parameters */
    const int *first_v;    /* [nv] */
    size_t basis_stride;
    int local_v, nv, order, dim, columns;
    const double *net; /* [nu][columns][dim] */
    int streaming;
    double *values;
    double *scratch; /* one part per thread */
    size_t scratch_part;
} grid;

/* The basis functions of v with parameters innermost. */
static void transpose_table(const taut_table *table, size_t stride, double *planes)
{
    for (int i = 0; i < table->count; i++) {
        for (int k = 0; k <= table->order; k++) {
            const double *row = taut_table_row(table, i, k);
            for (int b = 0; b < table->local; b++) {
                planes[(size_t)(k * table->local + b) * stride + (size_t)i] = row[b];
            }
        }
    }
}

/* Cuts a block into runs of one span each; *low and *high are the columns it needs. */
static int find_runs(const grid *g, int start, int count, taut_grid_run *runs, int *low, int *high)
{
    int n = 0;
    *low = g->columns;
    *high = 0;
    for (int j = 0; j < count; j++) {
        const int first = g->first_v[start + j];
        if (n == 0 || runs[n - 1].first != first) {
            runs[n++] = (taut_grid_run){j, j, first};
        }
        runs[n - 1].to = j + 1;
        *low = first < *low ? first : *low;
        *high = first + g->local_v > *high ? first + g->local_v : *high;
    }
    for (int i = 0; i < n; i++) {
        runs[i].first -= *low;
    }
    return n;
}

/* One block of one row. */
static void fill_block(const grid *g, int row, int start, int count, const taut_grid_run *runs,
                       int run_count, int low, int high, double *polygons, double *planes)
{
    const int vectors = TAUT_SURFACE_VECTORS(g->order);
    const size_t length = (size_t)(high - low) * (size_t)g->dim;
    const size_t row_stride = (size_t)g->columns * (size_t)g->dim;
    const double *rows =
        g->net + (size_t)g->u->first[row] * row_stride + (size_t)low * (size_t)g->dim;

    for (int k = 0; k <= g->order; k++) {
        g->ops->contract(g->u->local, taut_table_row(g->u, row, k), rows, row_stride, length,
                         polygons + (size_t)k * row_stride);
    }
    for (int r = 0; r < run_count; r++) {
        for (int k = 0; k < vectors; k++) {
            const double *basis =
                g->basis_v + (size_t)(order_v[k] * g->local_v) * g->basis_stride + start;
            g->ops->accumulate(&runs[r], g->local_v, g->dim, basis, g->basis_stride,
                               polygons + (size_t)order_u[k] * row_stride,
                               planes + k * g->dim * TAUT_GRID_STRIDE);
        }
    }
    if (g->dim == 4) {
        g->ops->project(g->order, count, planes);
    }
    g->ops->interleave(vectors, g->dim, count, planes, g->streaming,
                       g->values +
                           ((size_t)row * (size_t)g->nv + (size_t)start) * (size_t)(3 * vectors));
}

/* Rows from..to-1: blocks outside, rows inside. */
static void fill_rows(void *context, int part, int from, int to)
{
    const grid *g = context;
    double *polygons = g->scratch + (size_t)part * g->scratch_part;
    double planes[VECTORS_MAX * DIM_MAX * TAUT_GRID_STRIDE];
    taut_grid_run runs[TAUT_GRID_BLOCK];

    memset(planes, 0, sizeof planes);
    for (int start = 0; start < g->nv; start += TAUT_GRID_BLOCK) {
        const int count = g->nv - start < TAUT_GRID_BLOCK ? g->nv - start : TAUT_GRID_BLOCK;
        int low = 0, high = 0;
        const int run_count = find_runs(g, start, count, runs, &low, &high);
        for (int row = from; row < to; row++) {
            fill_block(g, row, start, count, runs, run_count, low, high, polygons, planes);
        }
    }
    g->ops->fence();
}

/* Takes scratch, transposes the table of v, brings the net into homogeneous form if it has weights,
 * and runs the threads. */
static taut_status fill_grid(const taut_surface *surface, const taut_table *tu,
                             const taut_table *tv, int threads, double *values)
{
    const double *weights = taut_surface_weights(surface);
    const int columns = taut_basis_count(taut_surface_v(surface));
    const size_t points = (size_t)taut_basis_count(taut_surface_u(surface)) * (size_t)columns;
    const int dim = weights != NULL ? 4 : 3;
    const size_t stride = (size_t)tv->count + TAUT_GRID_PAD;
    const size_t planes = (size_t)((tv->order + 1) * tv->local);
    const size_t part = ((size_t)ORDERS * (size_t)columns * (size_t)dim + 7) / 8 * 8;
    const int parts = threads > 1 ? threads : 1;
    double *basis = taut_alloc_aligned(planes * stride, sizeof(double));
    double *net = weights != NULL ? taut_alloc_aligned(4 * points, sizeof(double)) : NULL;
    double *scratch = taut_alloc_aligned(part * (size_t)parts, sizeof(double));
    const size_t bytes = (size_t)tu->count * (size_t)tv->count *
                         (size_t)TAUT_SURFACE_VECTORS(tv->order) * 3 * sizeof(double);
    taut_status status = TAUT_NO_MEMORY;

    if (basis != NULL && scratch != NULL && (weights == NULL || net != NULL)) {
        grid g = {.ops = taut_grid_ops_chosen(),
                  .u = tu,
                  .basis_v = basis,
                  .first_v = tv->first,
                  .basis_stride = stride,
                  .local_v = tv->local,
                  .nv = tv->count,
                  .order = tv->order,
                  .dim = dim,
                  .columns = columns,
                  .net = net != NULL ? net : taut_surface_points(surface),
                  .streaming = bytes >= streaming_bytes,
                  .values = values,
                  .scratch = scratch,
                  .scratch_part = part};
        memset(basis, 0, planes * stride * sizeof(double));
        transpose_table(tv, stride, basis);
        if (net != NULL) {
            taut_net_homogeneous(points, taut_surface_points(surface), weights, net);
        }
        taut_parallel_for(tu->count, parts, fill_rows, &g);
        status = TAUT_OK;
    }
    taut_free(basis);
    taut_free(net);
    taut_free(scratch);
    return status;
}

taut_status taut_surface_eval_grid(const taut_surface *surface, int nu, const double *u, int nv,
                                   const double *v, int order, int threads, double *values)
{
    taut_table *tu = NULL, *tv = NULL;
    taut_status status = TAUT_OK;

    if (surface == NULL || u == NULL || v == NULL || values == NULL || nu < 0 || nv < 0 ||
        order < 0 || order > 2 || threads < 0 || threads > TAUT_THREADS_MAX) {
        return TAUT_BAD_ARGUMENT;
    }
    status = taut_table_new(taut_surface_u(surface), nu, u, NULL, order, &tu);
    if (status == TAUT_OK) {
        status = taut_table_new(taut_surface_v(surface), nv, v, NULL, order, &tv);
    }
    if (status == TAUT_OK && nu > 0 && nv > 0) {
        status = fill_grid(surface, tu, tv, threads, values);
    }
    taut_table_free(tu);
    taut_table_free(tv);
    return status;
}
