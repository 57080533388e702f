/* surface_grid.c -- evaluation on a grid, by the tensor structure.
 *
 * Basis functions are worked out once per line. Each row of the grid contracts the net along u into
 * one polygon per derivative of u, then each point contracts those along v:
 *     Q_k[j] = sum_a d^kN_a(u) P[a][j],     x_{u^k v^l} = sum_b d^lN_b(v) Q_k[b]
 */
#include "core/memory.h"
#include "geometry/net.h"
#include "geometry/table.h"
#include "taut/surface.h"

#include <string.h>

static const int order_u[6] = {0, 1, 0, 2, 1, 0};
static const int order_v[6] = {0, 0, 1, 0, 1, 2};

/* polygons[k][j*dim + c], k = 0..order, from the rows of the net alive at line i. */
static void contract_u(const taut_table *table, int i, size_t length, const double *net,
                       double *polygons)
{
    for (int k = 0; k <= table->order; k++) {
        const double *n = taut_table_row(table, i, k);
        double *polygon = polygons + (size_t)k * length;
        memset(polygon, 0, length * sizeof(double));
        for (int a = 0; a < table->local; a++) {
            const double *row = net + (size_t)(table->first[i] + a) * length;
            for (size_t c = 0; c < length; c++) {
                polygon[c] += n[a] * row[c];
            }
        }
    }
}

/* h[k][dim] at point j of the row. */
static void contract_v(const taut_table *table, int j, int dim, size_t length, int vectors,
                       const double *polygons, double *h)
{
    for (int k = 0; k < vectors; k++) {
        const double *n = taut_table_row(table, j, order_v[k]);
        const double *polygon =
            polygons + (size_t)order_u[k] * length + (size_t)(table->first[j] * dim);
        for (int c = 0; c < dim; c++) {
            double sum = 0;
            for (int b = 0; b < table->local; b++) {
                sum += n[b] * polygon[b * dim + c];
            }
            h[k * dim + c] = sum;
        }
    }
}

static void fill_grid(const taut_table *tu, const taut_table *tv, int dim, int columns,
                      const double *net, double *polygons, double *values)
{
    const int vectors = TAUT_SURFACE_VECTORS(tu->order);
    const size_t length = (size_t)columns * (size_t)dim;
    double h[6 * 4];

    for (int i = 0; i < tu->count; i++) {
        contract_u(tu, i, length, net, polygons);
        for (int j = 0; j < tv->count; j++) {
            double *out =
                values + ((size_t)i * (size_t)tv->count + (size_t)j) * (size_t)vectors * 3;
            if (dim == 3) {
                contract_v(tv, j, dim, length, vectors, polygons, out);
            } else {
                contract_v(tv, j, dim, length, vectors, polygons, h);
                taut_net_project(tu->order, h, out);
            }
        }
    }
}

taut_status taut_surface_eval_grid(const taut_surface *surface, int nu, const double *u, int nv,
                                   const double *v, int order, int threads, double *values)
{
    if (surface == NULL || u == NULL || v == NULL || values == NULL || nu < 0 || nv < 0 ||
        order < 0 || order > 2 || threads < 0) {
        return TAUT_BAD_ARGUMENT;
    }
    const int columns = taut_basis_count(taut_surface_v(surface));
    const size_t points = (size_t)taut_basis_count(taut_surface_u(surface)) * (size_t)columns;
    const double *weights = taut_surface_weights(surface);
    const int dim = weights != NULL ? 4 : 3;
    taut_table *tu = NULL, *tv = NULL;
    double *net = NULL;
    double *polygons =
        taut_alloc_aligned((size_t)(order + 1) * (size_t)columns * (size_t)dim, sizeof(double));
    taut_status status = polygons != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    if (status == TAUT_OK && weights != NULL) {
        net = taut_alloc_aligned(4 * points, sizeof(double));
        status = net != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    }
    if (status == TAUT_OK) {
        status = taut_table_new(taut_surface_u(surface), nu, u, NULL, order, &tu);
    }
    if (status == TAUT_OK) {
        status = taut_table_new(taut_surface_v(surface), nv, v, NULL, order, &tv);
    }
    if (status == TAUT_OK) {
        if (net != NULL) {
            taut_net_homogeneous(points, taut_surface_points(surface), weights, net);
        }
        fill_grid(tu, tv, dim, columns, net != NULL ? net : taut_surface_points(surface), polygons,
                  values);
    }
    taut_table_free(tu);
    taut_table_free(tv);
    taut_free(net);
    taut_free(polygons);
    return status;
}
