/* surface_grid.c -- evaluation on a grid, by the tensor structure.
 *
 * Basis functions are worked out once per line, then each row contracts the net along u into one
 * polygon per derivative of u, and the points of the row contract those along v:
 *     Q_k[j] = sum_a d^kN_a(u) P[a][j],     x_{u^k v^l} = sum_b d^lN_b(v) Q_k[b]
 * The v parameters are taken in blocks whose basis functions stay in the first cache while all rows
 * pass over them; only the columns of the net that a block needs are contracted.
 */
#include "core/memory.h"
#include "geometry/grid/lines.h"
#include "geometry/grid/table.h"
#include "geometry/net.h"
#include "platform/parallel.h"
#include "taut/surface.h"

#include <stdint.h>
#include <string.h>

/* Streamed stores pay once the result is larger than the caches keep for later use. Rows that do not begin where they
 * may be streamed to are streamed from a copy, which pays later still. */
static const size_t streaming_bytes = (size_t)4 << 20, copying_bytes = (size_t)32 << 20;

enum { VECTORS_MAX = 6, ORDERS = 3 };

/* What all threads share; nothing in it changes while they run. */
typedef struct grid {
    const taut_grid_ops *ops;
    const taut_table *u;
    const taut_grid_lines *lines; /* of v */
    int nv, order, dim, columns;
    const double *net; /* [nu][columns][dim] */
    int streaming, copying;
    double *values;
    double *scratch; /* one part per thread: polygons, then the points of one block */
    size_t scratch_part, polygons_part;
} grid;

/* The first points of the groups, from where whole groups were written to where they belong. */
static void place_points(const grid *g, int is_single, int count, const double *points,
                         double *values)
{
    const size_t numbers = (size_t)TAUT_SURFACE_VECTORS(g->order) * 3;
    if (!is_single && g->streaming) {
        g->ops->copy((size_t)count * numbers, points, values);
    } else if (!is_single) {
        memcpy(values, points, (size_t)count * numbers * sizeof(double));
    } else {
        for (int i = 0; i < count; i++) {
            memcpy(values + (size_t)i * numbers, points + (size_t)(i * g->lines->size) * numbers,
                   numbers * sizeof(double));
        }
    }
}

/* One block of one row. */
static void fill_block(const grid *g, int row, const taut_grid_block *block, double *polygons,
                       double *points)
{
    const size_t row_stride = (size_t)g->columns * (size_t)g->dim;
    const double *rows =
        g->net + (size_t)g->u->first[row] * row_stride + (size_t)(block->low * g->dim);
    const size_t numbers = (size_t)TAUT_SURFACE_VECTORS(g->order) * 3;
    double *values = g->values + ((size_t)row * (size_t)g->nv + (size_t)block->start) * numbers;
    const int is_streamed = g->streaming && (uintptr_t)values % 32 == 0;
    const int is_direct = !block->single && (is_streamed || !g->copying);
    const int whole = is_direct ? block->points / g->lines->size : 0; /* groups */
    const int placed = whole * g->lines->size;
    const taut_grid_group *groups = g->lines->groups + block->group;

    for (int k = 0; k <= g->order; k++) {
        g->ops->contract(g->u->local, taut_table_row(g->u, row, k), rows, row_stride,
                         (size_t)((block->high - block->low) * g->dim),
                         polygons + (size_t)k * row_stride);
    }
    g->ops->fill(g->order, g->dim, is_streamed, groups, whole, polygons, row_stride, values);
    if (whole < block->count) {
        g->ops->fill(g->order, g->dim, 0, groups + whole, block->count - whole, polygons,
                     row_stride, points);
        place_points(g, block->single, block->points - placed, points,
                     values + (size_t)placed * numbers);
    }
}

/* Rows from..to-1: blocks outside, rows inside. */
static void fill_rows(void *context, int part, int from, int to)
{
    const grid *g = context;
    double *polygons = g->scratch + (size_t)part * g->scratch_part;
    for (int i = 0; i < g->lines->block_count; i++) {
        for (int row = from; row < to; row++) {
            fill_block(g, row, &g->lines->blocks[i], polygons, polygons + g->polygons_part);
        }
    }
    g->ops->fence();
}

/* What the evaluation works with, and frees. */
typedef struct grid_work {
    taut_table *u, *v;
    taut_grid_lines lines;
    double *net, *scratch;
} grid_work;

static void clear_work(grid_work *work)
{
    taut_table_free(work->u);
    taut_table_free(work->v);
    taut_grid_lines_clear(&work->lines);
    taut_free(work->net);
    taut_free(work->scratch);
}

/* Takes scratch, cuts v into groups, brings the net into homogeneous form if it has weights, and
 * runs the threads. */
static taut_status fill_grid(const taut_surface *surface, int threads, grid_work *work,
                             double *values)
{
    const double *weights = taut_surface_weights(surface);
    const taut_table *tu = work->u, *tv = work->v;
    const int columns = taut_basis_count(taut_surface_v(surface));
    const size_t points = (size_t)taut_basis_count(taut_surface_u(surface)) * (size_t)columns;
    const int dim = weights != NULL ? 4 : 3;
    const size_t polygons = ((size_t)ORDERS * (size_t)columns * (size_t)dim + 7) / 8 * 8;
    const size_t part = polygons + (size_t)TAUT_GRID_BLOCK_MAX * VECTORS_MAX * 3;
    const int parts = threads > 1 ? threads : 1;
    const size_t bytes = (size_t)tu->count * (size_t)tv->count *
                         (size_t)TAUT_SURFACE_VECTORS(tv->order) * 3 * sizeof(double);
    const taut_grid_ops *ops = taut_grid_ops_chosen();

    work->net = weights != NULL ? taut_alloc_aligned(4 * points, sizeof(double)) : NULL;
    work->scratch = taut_alloc_aligned(part * (size_t)parts, sizeof(double));
    if (work->scratch == NULL || (weights != NULL && work->net == NULL) ||
        taut_grid_lines_make(tv, ops->group, &work->lines) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    if (weights != NULL) {
        taut_net_homogeneous(points, taut_surface_points(surface), weights, work->net);
    }
    grid g = {.ops = ops,
              .u = tu,
              .lines = &work->lines,
              .nv = tv->count,
              .order = tv->order,
              .dim = dim,
              .columns = columns,
              .net = weights != NULL ? work->net : taut_surface_points(surface),
              .streaming = bytes >= streaming_bytes,
              .copying = bytes >= copying_bytes,
              .values = values,
              .scratch = work->scratch,
              .scratch_part = part,
              .polygons_part = polygons};
    taut_parallel_for(tu->count, parts, fill_rows, &g);
    return TAUT_OK;
}

taut_status taut_surface_eval_grid(const taut_surface *surface, int nu, const double *u, int nv,
                                   const double *v, int order, int threads, double *values)
{
    grid_work work = {.net = NULL};
    taut_status status = TAUT_OK;

    if (surface == NULL || u == NULL || v == NULL || values == NULL || nu < 0 || nv < 0 ||
        order < 0 || order > 2 || threads < 0 || threads > TAUT_THREADS_MAX) {
        return TAUT_BAD_ARGUMENT;
    }
    status = taut_table_new(taut_surface_u(surface), nu, u, NULL, order, &work.u);
    if (status == TAUT_OK) {
        status = taut_table_new(taut_surface_v(surface), nv, v, NULL, order, &work.v);
    }
    if (status == TAUT_OK && nu > 0 && nv > 0) {
        status = fill_grid(surface, threads, &work, values);
    }
    clear_work(&work);
    return status;
}
