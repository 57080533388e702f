#include "measure/curvature/scan.h"

#include "geometry/exponent.h"
#include "geometry/keep.h"
#include "geometry/net.h"

#include <string.h>

/* Sizes of a net from the origin: beyond that, differences of sums at points lose three digits. */
static const double far_away = 1024;

static int is_far(const taut_surface *surface)
{
    const size_t count = taut_point_count(surface);
    const double *points = taut_surface_points(surface);
    return taut_largest(count, points) / far_away > 2 * taut_half_size(count, points);
}

/* net[k] = x - the first point, which is in *centre; NULL when memory runs out. */
static const double *centred_net(taut_arena *arena, const double *points, size_t count,
                                 double centre[3])
{
    double *net = taut_arena_take(arena, 3 * count, sizeof(double));

    if (net == NULL) {
        return NULL;
    }
    memcpy(centre, points, 3 * sizeof(double));
    for (size_t k = 0; k < 3 * count; k++) {
        net[k] = points[k] - centre[k % 3];
    }
    return net;
}

/* net[k] = (w (x - centre), w), the centre the middle point of the list; NULL when memory runs out. */
static const double *homogeneous_net(taut_arena *arena, const taut_surface *surface, size_t count,
                                     double centre[3])
{
    const double *points = taut_surface_points(surface);
    const double *weights = taut_surface_weights(surface);
    double *net = taut_arena_take(arena, 4 * count, sizeof(double));

    if (net == NULL) {
        return NULL;
    }
    memcpy(centre, points + 3 * (count / 2), 3 * sizeof(double));
    for (size_t k = 0; k < count; k++) {
        for (size_t c = 0; c < 3; c++) {
            net[4 * k + c] = weights[k] * (points[3 * k + c] - centre[c]);
        }
        net[4 * k + 3] = weights[k];
    }
    return net;
}

static taut_status keep_table(taut_arena *arena, const taut_basis *basis,
                              const taut_parameters *parameters, taut_table **table)
{
    const taut_status status =
        taut_table_new(basis, parameters->count, parameters->t, parameters->span, 2, table);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_keep_table(arena, *table) ? TAUT_OK : TAUT_NO_MEMORY;
}

taut_status taut_scan_new(taut_arena *arena, const taut_surface *surface, const taut_parameters *u,
                          const taut_parameters *v, taut_scan **scan)
{
    const taut_basis *bu = taut_surface_u(surface), *bv = taut_surface_v(surface);
    const size_t count = (size_t)taut_basis_count(bu) * (size_t)taut_basis_count(bv);
    taut_scan *made = taut_arena_take(arena, 1, sizeof *made);
    taut_status status = TAUT_OK;

    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    made->dim = taut_surface_weights(surface) != NULL ? 4 : 3;
    made->columns = taut_basis_count(bv);
    made->is_far = is_far(surface);
    made->net = made->dim == 4 ? homogeneous_net(arena, surface, count, made->centre)
                : made->is_far
                    ? centred_net(arena, taut_surface_points(surface), count, made->centre)
                    : taut_surface_points(surface);
    status = keep_table(arena, bu, u, &made->u);
    if (status != TAUT_OK) {
        return status;
    }
    status = keep_table(arena, bv, v, &made->v);
    if (status != TAUT_OK) {
        return status;
    }
    *scan = made;
    return taut_arena_status(arena);
}

size_t taut_scan_scratch(const taut_scan *scan)
{
    return 3 * (size_t)scan->columns * (size_t)scan->dim;
}

/* polygons[j][k][c] for the derivatives k = 0, 1, 2 by u. */
static void contract_u(const taut_scan *scan, int i, double *polygons)
{
    const size_t dim = (size_t)scan->dim, columns = (size_t)scan->columns;
    const double *base = scan->net + (size_t)scan->u->first[i] * columns * dim;

    memset(polygons, 0, 3 * columns * dim * sizeof(double));
    for (size_t k = 0; k <= 2; k++) {
        const double *n = taut_table_row(scan->u, i, (int)k);
        for (size_t a = 0; a < (size_t)scan->u->local; a++) {
            const double *row = base + a * columns * dim;
            double *out = polygons + k * dim;
            for (size_t j = 0; j < columns; j++, out += 3 * dim) {
                for (size_t c = 0; c < dim; c++) {
                    out[c] +=
                        n[a] * (k > 0 ? row[j * dim + c] - base[j * dim + c] : row[j * dim + c]);
                }
            }
        }
    }
}

/* h[6][dim] at entry j: x, x_u, x_uu with N_b, x_v, x_uv with N_b', x_vv with N_b''. */
static inline void contract_v(const taut_scan *scan, int j, size_t dim, const double *polygons,
                              double *h)
{
    const double *n = taut_table_row(scan->v, j, 0), *d = taut_table_row(scan->v, j, 1);
    const double *e = taut_table_row(scan->v, j, 2);
    const double *base = polygons + (size_t)scan->v->first[j] * 3 * dim, *at = base;
    double still[12] = {0}, once[8] = {0}, twice[4] = {0};

    for (size_t b = 0; b < (size_t)scan->v->local; b++, at += 3 * dim) {
        for (size_t c = 0; c < 3 * dim; c++) {
            still[c] += n[b] * at[c];
        }
        for (size_t c = 0; c < 2 * dim; c++) {
            once[c] += d[b] * (at[c] - base[c]);
        }
        for (size_t c = 0; c < dim; c++) {
            twice[c] += e[b] * (at[c] - base[c]);
        }
    }
    memcpy(h, still, 2 * dim * sizeof(double));
    memcpy(h + 2 * dim, once, dim * sizeof(double));
    memcpy(h + 3 * dim, still + 2 * dim, dim * sizeof(double));
    memcpy(h + 4 * dim, once + dim, dim * sizeof(double));
    memcpy(h + 5 * dim, twice, dim * sizeof(double));
}

void taut_scan_line(const taut_scan *scan, int i, double *scratch, double *values)
{
    double h[6 * 4];
    contract_u(scan, i, scratch);
    for (int j = 0; j < scan->v->count; j++) {
        double *out = values + (size_t)j * 18;
        if (scan->dim == 3) {
            contract_v(scan, j, 3, scratch, out);
            continue;
        }
        contract_v(scan, j, 4, scratch, h);
        taut_net_project(2, h, out);
        for (int c = 0; c < 3 && !scan->is_far; c++) {
            out[c] += scan->centre[c];
        }
    }
}
