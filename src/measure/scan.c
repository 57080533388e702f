#include "measure/scan.h"

#include "core/memory.h"
#include "geometry/net.h"

#include <string.h>

static const int order_u[6] = {0, 1, 0, 2, 1, 0};
static const int order_v[6] = {0, 0, 1, 0, 1, 2};

void taut_scan_free(taut_scan *scan)
{
    if (scan != NULL) {
        taut_table_free(scan->u);
        taut_table_free(scan->v);
        taut_free(scan->own);
        taut_free(scan);
    }
}

/* net[k] = (w (x - centre), w), the centre the middle point of the list. */
static taut_status homogeneous(const taut_surface *surface, size_t count, taut_scan *scan)
{
    const double *points = taut_surface_points(surface);
    const double *weights = taut_surface_weights(surface);

    scan->own = taut_alloc_aligned(4 * count, sizeof(double));
    if (scan->own == NULL) {
        return TAUT_NO_MEMORY;
    }
    memcpy(scan->centre, points + 3 * (count / 2), sizeof scan->centre);
    for (size_t k = 0; k < count; k++) {
        for (size_t c = 0; c < 3; c++) {
            scan->own[4 * k + c] = weights[k] * (points[3 * k + c] - scan->centre[c]);
        }
        scan->own[4 * k + 3] = weights[k];
    }
    scan->net = scan->own;
    return TAUT_OK;
}

taut_status taut_scan_new(const taut_surface *surface, const taut_lines *u, const taut_lines *v,
                          taut_scan **scan)
{
    const taut_basis *bu = taut_surface_u(surface), *bv = taut_surface_v(surface);
    const size_t count = (size_t)taut_basis_count(bu) * (size_t)taut_basis_count(bv);
    taut_scan *made = taut_alloc_zero(1, sizeof *made);
    taut_status status = made != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    if (status == TAUT_OK) {
        made->dim = taut_surface_weights(surface) != NULL ? 4 : 3;
        made->columns = taut_basis_count(bv);
        made->net = taut_surface_points(surface);
        status = made->dim == 4 ? homogeneous(surface, count, made) : TAUT_OK;
    }
    if (status == TAUT_OK) {
        status = taut_table_new(bu, u->count, u->t, u->span, 2, &made->u);
    }
    if (status == TAUT_OK) {
        status = taut_table_new(bv, v->count, v->t, v->span, 2, &made->v);
    }
    if (status != TAUT_OK) {
        taut_scan_free(made);
        return status;
    }
    *scan = made;
    return TAUT_OK;
}

size_t taut_scan_scratch(const taut_scan *scan)
{
    return 3 * (size_t)scan->columns * (size_t)scan->dim;
}

/* polygon[k][j*dim + c] for the derivatives k = 0, 1, 2 by u. */
static void contract_u(const taut_scan *scan, int i, double *polygons)
{
    const size_t length = (size_t)scan->columns * (size_t)scan->dim;
    const double *base = scan->net + (size_t)scan->u->first[i] * length;
    for (int k = 0; k <= 2; k++) {
        const double *n = taut_table_row(scan->u, i, k);
        double *polygon = polygons + (size_t)k * length;
        memset(polygon, 0, length * sizeof(double));
        for (int a = 0; a < scan->u->local; a++) {
            const double *row = base + (size_t)a * length;
            for (size_t c = 0; c < length; c++) {
                polygon[c] += n[a] * (k > 0 ? row[c] - base[c] : row[c]);
            }
        }
    }
}

/* h[6][dim] at entry j. */
static void contract_v(const taut_scan *scan, int j, const double *polygons, double *h)
{
    const size_t length = (size_t)scan->columns * (size_t)scan->dim;
    const size_t from = (size_t)scan->v->first[j] * (size_t)scan->dim;
    for (int k = 0; k < 6; k++) {
        const double *n = taut_table_row(scan->v, j, order_v[k]);
        const double *polygon = polygons + (size_t)order_u[k] * length + from;
        for (int c = 0; c < scan->dim; c++) {
            const double base = order_v[k] > 0 ? polygon[c] : 0;
            double sum = 0;
            for (int b = 0; b < scan->v->local; b++) {
                sum += n[b] * (polygon[b * scan->dim + c] - base);
            }
            h[k * scan->dim + c] = sum;
        }
    }
}

void taut_scan_line(const taut_scan *scan, int i, double *scratch, double *values)
{
    double h[6 * 4];
    contract_u(scan, i, scratch);
    for (int j = 0; j < scan->v->count; j++) {
        double *out = values + (size_t)j * 18;
        if (scan->dim == 3) {
            contract_v(scan, j, scratch, out);
            continue;
        }
        contract_v(scan, j, scratch, h);
        taut_net_project(2, h, out);
        for (int c = 0; c < 3; c++) {
            out[c] += scan->centre[c];
        }
    }
}
