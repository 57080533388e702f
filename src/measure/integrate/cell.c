/* cell.c -- the derivative vectors at the nodes of one cell, and weighted sums over them. */
#include "measure/integrate/job.h"

#include "basis/basis_ops.h"
#include "geometry/exponent.h"
#include "geometry/net.h"
#include "measure/curvature/place.h"

#include <math.h>
#include <string.h>

static const int order_u[6] = {0, 1, 0, 2, 1, 0};
static const int order_v[6] = {0, 0, 1, 0, 1, 2};

enum { BATCH = 64 }; /* nodes handled at a time: all of a batch stays in the first cache */

void taut_scaled_surface_init(const taut_surface *surface, taut_scaled_surface *scaled)
{
    scaled->basis[0] = taut_surface_u(surface);
    scaled->basis[1] = taut_surface_v(surface);
    scaled->points = taut_surface_points(surface);
    scaled->weights = taut_surface_weights(surface);
    scaled->dim = scaled->weights != NULL ? 4 : 3;
    for (int d = 0; d < 2; d++) {
        const taut_basis *basis = scaled->basis[d];
        scaled->local[d] = taut_basis_local(basis);
        scaled->shift[d] = taut_range_exponent(basis);
    }
    scaled->scale = taut_exponent(taut_half_size(taut_point_count(surface), scaled->points)) + 1;
}

void taut_nodes_fill(const taut_scaled_surface *scaled, int direction, int span, double lo,
                     double hi, int order, int count, const double *rule_nodes,
                     const double *rule_weights, taut_nodes *nodes)
{
    const taut_basis *basis = scaled->basis[direction];
    const int local = scaled->local[direction], shift = scaled->shift[direction];
    const double half = (hi - lo) / 2;

    nodes->count = count;
    memset(nodes->largest, 0, sizeof nodes->largest);
    memset(nodes->most, 0, (size_t)(order + 1) * (size_t)local * sizeof(double));
    for (int i = 0; i < count; i++) {
        double *values = nodes->values + (size_t)i * (size_t)(order + 1) * (size_t)local;
        nodes->weights[i] = ldexp(half, -shift) * rule_weights[i];
        double rest = 0;
        const double t = taut_node_place(lo, hi, rule_nodes[i], &rest);
        taut_basis_eval_beside(basis, span, t, rest, order, values);
        for (int k = 0; k <= order; k++) {
            const double factor = ldexp(1, k * shift);
            double sum = 0;
            for (int a = 0; a < local; a++) {
                values[k * local + a] *= factor;
                const double size = fabs(values[k * local + a]);
                nodes->most[k * local + a] = fmax(nodes->most[k * local + a], size);
                sum += size;
            }
            nodes->largest[k] = fmax(nodes->largest[k], sum);
        }
    }
}

void taut_cell_work_init(const taut_scaled_surface *scaled, int row, taut_arena *arena,
                         taut_cell_work *work)
{
    const size_t line = (size_t)scaled->local[1] * (size_t)scaled->dim;
    const int stride = row > BATCH ? row : BATCH;
    double *kept = taut_arena_take(arena, TAUT_KEPT_MAX * TAUT_NODES_KEPT, sizeof(double));

    *work = (taut_cell_work){
        .stride = stride,
        .net = taut_arena_take(arena, (size_t)scaled->local[0] * line, sizeof(double)),
        .polygons = taut_arena_take(arena, 3 * line, sizeof(double)),
        .field = taut_arena_take(arena, 24 * (size_t)stride, sizeof(double)),
        .out = taut_arena_take(arena, TAUT_FIELDS_MAX * (size_t)stride, sizeof(double)),
    };
    for (int k = 0; k < TAUT_KEPT_MAX && kept != NULL; k++) {
        work->kept[k] = kept + k * TAUT_NODES_KEPT;
    }
}

double taut_cross_share(const double sizes[3], double size)
{
    double most = 0;
    for (int c = 0; c < 3 && size > 0; c++) {
        most = fmax(most, (sizes[c] / size) * (sizes[(c + 1) % 3] / size));
    }
    return size > 0 ? fmin(1, 8 * most) : 1;
}

void taut_cell_load(const taut_scaled_surface *scaled, int su, int sv, taut_cell_work *work)
{
    const size_t columns = (size_t)taut_basis_count(scaled->basis[1]);
    const size_t first = (size_t)taut_basis_first(scaled->basis[0], su) * columns +
                         (size_t)taut_basis_first(scaled->basis[1], sv);
    const double *origin = scaled->points + 3 * first;
    const double factor = taut_half_factor(scaled->scale);
    const double unit = scaled->dim == 4 ? scaled->weights[first] : 1;
    double *out = work->net;

    double sizes[3] = {0};

    for (int a = 0; a < scaled->local[0]; a++) {
        const size_t row = first + (size_t)a * columns;
        for (int b = 0; b < scaled->local[1]; b++) {
            const double *x = scaled->points + 3 * (row + (size_t)b);
            const double w = scaled->dim == 4 ? scaled->weights[row + (size_t)b] / unit : 1;
            for (int c = 0; c < 3; c++) {
                const double value = (x[c] / 2 - origin[c] / 2) * factor;
                sizes[c] = fmax(sizes[c], fabs(value));
                out[c] = scaled->dim == 4 ? w * value : value;
            }
            if (scaled->dim == 4) {
                out[3] = w;
            }
            out += scaled->dim;
        }
    }
    work->size = fmax(sizes[0], fmax(sizes[1], sizes[2]));
    work->cross = taut_cross_share(sizes, work->size);
}

/* polygons[k][b][c] = sum_a N_a^(k)(u_i) net[a][b][c]. */
static void contract_u(const taut_scaled_surface *scaled, const taut_nodes *u, int i, int order,
                       taut_cell_work *work)
{
    const int local = scaled->local[0];
    const int length = scaled->local[1] * scaled->dim;
    for (int k = 0; k <= order; k++) {
        const double *n = u->values + ((size_t)i * (size_t)(order + 1) + (size_t)k) * (size_t)local;
        double *polygon = work->polygons + (size_t)k * (size_t)length;
        for (int c = 0; c < length; c++) {
            polygon[c] = n[0] * work->net[c];
        }
        for (int a = 1; a < local; a++) {
            const double *row = work->net + (size_t)a * (size_t)length;
            for (int c = 0; c < length; c++) {
                polygon[c] += n[a] * row[c];
            }
        }
    }
}

/* One vector k at all nodes j of v: field[c][at + j] = sum_b N_b^(l)(v_j) polygon[b][c]. */
static inline void contract_row(int dim, int local, const taut_nodes *v, int step, const double *n,
                                const double *polygon, size_t stride, double *field)
{
    for (int j = 0; j < v->count; j++) {
        double sum[4] = {0, 0, 0, 0};
        for (int b = 0; b < local; b++) {
            for (int c = 0; c < dim; c++) {
                sum[c] += n[b] * polygon[b * dim + c];
            }
        }
        for (int c = 0; c < dim; c++) {
            field[(size_t)c * stride + (size_t)j] = sum[c];
        }
        n += step;
    }
}

/* field[k][c][at + j] for all nodes j of v; without weights the position is not wanted. */
static void contract_v(const taut_scaled_surface *scaled, const taut_nodes *v, int order, int at,
                       taut_cell_work *work)
{
    const int local = scaled->local[1], dim = scaled->dim, step = (order + 1) * local;
    const size_t stride = (size_t)work->stride;
    const int vectors = TAUT_SURFACE_VECTORS(order);
    for (int k = dim == 4 ? 0 : 1; k < vectors; k++) {
        const double *polygon = work->polygons + (size_t)(order_u[k] * local * dim);
        const double *n = v->values + (size_t)(order_v[k] * local);
        double *field = work->field + (size_t)(k * dim) * stride + at;
        if (dim == 3) {
            contract_row(3, local, v, step, n, polygon, stride, field);
        } else {
            contract_row(4, local, v, step, n, polygon, stride, field);
        }
    }
}

/* The quotient rule of net.h over a batch, in place: field[k][4] becomes field[k][3]. */
static void project_batch(int order, int count, int stride, double *field)
{
    const int vectors = TAUT_SURFACE_VECTORS(order);
    for (int j = 0; j < count; j++) {
        double h[6 * 4], x[6 * 3];
        for (int k = 0; k < 4 * vectors; k++) {
            h[k] = field[k * stride + j];
        }
        taut_net_project(order, h, x);
        for (int k = 0; k < 3 * vectors; k++) {
            field[k * stride + j] = x[k];
        }
    }
}

/* The lesser of sum_ab w_ab max |N_a^(k)| max |N_b^(l)| and max w_ab max sum_a |N_a^(k)| max sum_b
 * |N_b^(l)| over the nodes, the first for weights that are far apart, the second for those that are
 * not: no derivative of w is larger, nor any of wx over the size. */
static double gross_weight(const taut_scaled_surface *scaled, const taut_nodes *u,
                           const taut_nodes *v, int k, int l, const taut_cell_work *work)
{
    const int local_u = scaled->local[0], local_v = scaled->local[1];
    const double *net = work->net;
    double sum = 0, most = 0;
    for (int a = 0; a < local_u; a++) {
        double row = 0;
        for (int b = 0; b < local_v; b++, net += 4) {
            row += v->most[l * local_v + b] * net[3];
            most = fmax(most, net[3]);
        }
        sum += u->most[k * local_u + a] * row;
    }
    return fmin(sum, most * u->largest[k] * v->largest[l]);
}

/* With weights, from the quotient rule
 *     w x_uv = (wx)_uv - w_u x_v - w_v x_u - w_uv x    and so on,
 * and the least w at the nodes of the batch: w varies little over a cell, whatever the weights of
 * its span do. */
static taut_bounds rational_bounds(const taut_scaled_surface *scaled, const taut_nodes *u,
                                   const taut_nodes *v, int order, int count,
                                   const taut_cell_work *work)
{
    const double *w = work->field + 3 * (size_t)work->stride;
    taut_bounds bounds = {{work->size}, work->cross};
    double least = INFINITY, r[6] = {0};

    for (int j = 0; j < count; j++) {
        least = fmin(least, w[j]);
    }
    for (int k = 1; k < TAUT_SURFACE_VECTORS(order); k++) {
        r[k] = gross_weight(scaled, u, v, order_u[k], order_v[k], work) / least;
        bounds.of[k] = 2 * work->size * r[k];
    }
    if (order > 1) {
        const double ru = r[TAUT_XU], rv = r[TAUT_XV], *of = bounds.of;
        bounds.of[TAUT_XUU] += 2 * ru * of[TAUT_XU];
        bounds.of[TAUT_XUV] += ru * of[TAUT_XV] + rv * of[TAUT_XU];
        bounds.of[TAUT_XVV] += 2 * rv * of[TAUT_XV];
    }
    return bounds;
}

/* Of the first `count` nodes in the work's field, before weights are divided out. */
static taut_bounds bounds_of(const taut_scaled_surface *scaled, const taut_nodes *u,
                             const taut_nodes *v, int order, int count, const taut_cell_work *work)
{
    taut_bounds bounds = {{0}, work->cross};
    if (scaled->dim == 4) {
        return rational_bounds(scaled, u, v, order, count, work);
    }
    for (int k = 0; k < TAUT_SURFACE_VECTORS(order); k++) {
        bounds.of[k] = work->size * u->largest[order_u[k]] * v->largest[order_v[k]];
    }
    return bounds;
}

/* The fields at the nodes of rows first .. first + rows - 1, one after the other. */
static void evaluate_rows(const taut_scaled_surface *scaled, const taut_nodes *u, int first,
                          int rows, const taut_nodes *v, int order, taut_fields *fields,
                          taut_cell_work *work)
{
    const double ratio = ldexp(1, scaled->shift[1] - scaled->shift[0]);
    for (int r = 0; r < rows; r++) {
        contract_u(scaled, u, first + r, order, work);
        contract_v(scaled, v, order, r * v->count, work);
    }
    const taut_bounds bounds = bounds_of(scaled, u, v, order, rows * v->count, work);
    if (scaled->dim == 4) {
        project_batch(order, rows * v->count, work->stride, work->field);
    }
    fields(rows * v->count, work->stride, work->field, &bounds, ratio, work->out);
}

void taut_cell_row(const taut_scaled_surface *scaled, const taut_nodes *u, int i,
                   const taut_nodes *v, int order, taut_fields *fields, taut_cell_work *work)
{
    evaluate_rows(scaled, u, i, 1, v, order, fields, work);
}

/* Adds the fields of one batch, `rows` lines of nodes from `first`. */
static void add_batch(const taut_nodes *u, int first, int rows, const taut_nodes *v,
                      int field_count, const taut_cell_work *work, double *sums)
{
    for (int f = 0; f < field_count; f++) {
        const double *out = work->out + (size_t)f * (size_t)work->stride;
        for (int i = 0; i < rows; i++) {
            double sum = 0;
            for (int j = 0; j < v->count; j++) {
                sum += v->weights[j] * out[i * v->count + j];
            }
            sums[f] += u->weights[first + i] * sum;
        }
    }
}

static void keep_batch(int first_field, int kept, int from, int count, const taut_cell_work *work)
{
    for (int k = 0; k < kept; k++) {
        memcpy(work->kept[k] + from, work->out + (size_t)(first_field + k) * (size_t)work->stride,
               (size_t)count * sizeof(double));
    }
}

/* Operations, as pulses count them, of a row of nodes. */
static double work_of_row(const taut_scaled_surface *scaled, const taut_nodes *v, int order)
{
    const double line = (double)scaled->local[1] * scaled->dim;
    return line * (scaled->local[0] * (order + 1) + v->count * TAUT_SURFACE_VECTORS(order));
}

void taut_cell_sum(const taut_scaled_surface *scaled, const taut_nodes *u, const taut_nodes *v,
                   int order, taut_fields *fields, int field_count, int kept, taut_cell_work *work,
                   double *sums)
{
    const int batch = work->stride / v->count;

    memset(sums, 0, (size_t)field_count * sizeof(double));
    for (int i = 0; i < u->count; i += batch) {
        const int rows = u->count - i < batch ? u->count - i : batch;
        evaluate_rows(scaled, u, i, rows, v, order, fields, work);
        add_batch(u, i, rows, v, field_count, work, sums);
        if (u->count * v->count <= TAUT_NODES_KEPT) {
            keep_batch(field_count, kept, i * v->count, rows * v->count, work);
        }
        if (taut_pulse_beat(work->pulse, rows * work_of_row(scaled, v, order))) {
            return;
        }
    }
}
