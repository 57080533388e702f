/* volume.c -- volume and area of a closed shell, to know its outside and whether it has an inside.
 *
 *     V = sum of  1/3 int (x - o) . (x_u x x_v) du dv,    A = sum of  int |x_u x x_v| du dv
 *
 *     lid on a loop from p:   1/6 (p - o) . int (x - o) x x' dt,  against the way round the surface
 *
 * by Gauss rules on each pair of spans. Only the sign of V, and V / A against what counts as one
 * point, are used: four nodes a span are exact for V up to degree 2 and near it for what is smooth.
 */
#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "shell/parts.h"

#include <math.h>

enum { NODES = 4, VECTORS = 3, AT_ONCE = 1 << 16 };

/* All nodes of a basis, or their weights, in t[span count * NODES]. */
static void fill_nodes(const taut_basis *basis, double *t, double *weights)
{
    const double *breaks = taut_basis_breaks(basis);
    double node[NODES], weight[NODES];
    taut_gauss_rule(NODES, node, weight);
    for (int k = 0; k < taut_basis_span_count(basis); k++) {
        const double half = 0.5 * (breaks[k + 1] - breaks[k]);
        for (int g = 0; g < NODES; g++) {
            t[NODES * k + g] =
                fmin(breaks[k + 1], fmax(breaks[k], breaks[k] + half * (1 + node[g])));
            weights[NODES * k + g] = half * weight[g];
        }
    }
}

/* So many rows of nodes at once: a call costs as much as the whole net has points, so they are to be
 * few; at least one. */
static size_t rows_at_once(size_t nu, size_t nv)
{
    const size_t fit = AT_ONCE / nv;
    return fit < 1 ? 1 : fit < nu ? fit : nu;
}

static size_t node_count(const taut_basis *basis)
{
    return NODES * (size_t)taut_basis_span_count(basis);
}

size_t taut_shell_volume_room(const taut_surface *surface)
{
    const size_t nu = node_count(taut_surface_u(surface)), nv = node_count(taut_surface_v(surface));
    return 2 * nu + 2 * nv + 3 * VECTORS * nv * rows_at_once(nu, nv);
}

/* One row: x, x_u, x_v at each node of v. */
static void add_row(size_t nv, double weight, const double *weight_v, const double *values,
                    const double origin[3], int scale, double sign, taut_shell_content *content)
{
    for (size_t j = 0; j < nv; j++) {
        const double *x = values + 3 * VECTORS * j;
        double arm[3], along_u[3], along_v[3], normal[3];
        for (int c = 0; c < 3; c++) {
            arm[c] = ldexp(x[c] - origin[c], -scale);
            along_u[c] = ldexp(x[3 + c], -scale) * weight;
            along_v[c] = ldexp(x[6 + c], -scale) * weight_v[j];
        }
        taut_cross(along_u, along_v, normal);
        content->volume += sign * taut_dot(arm, normal) / 3;
        content->area += taut_norm(normal);
    }
}

taut_status taut_shell_add_volume(const taut_surface *surface, const double origin[3], int scale,
                                  double sign, double *room, taut_shell_content *content)
{
    const size_t nu = node_count(taut_surface_u(surface)), nv = node_count(taut_surface_v(surface));
    const size_t rows = rows_at_once(nu, nv);
    double *u = room, *weight_u = u + nu, *v = weight_u + nu, *weight_v = v + nv,
           *values = weight_v + nv;

    fill_nodes(taut_surface_u(surface), u, weight_u);
    fill_nodes(taut_surface_v(surface), v, weight_v);
    for (size_t i = 0; i < nu; i += rows) {
        const size_t here = nu - i < rows ? nu - i : rows;
        const taut_status status =
            taut_surface_eval_grid(surface, (int)here, u + i, (int)nv, v, 1, 1, values);
        if (status != TAUT_OK) {
            return status;
        }
        for (size_t k = 0; k < here; k++) {
            add_row(nv, weight_u[i + k], weight_v, values + 3 * VECTORS * nv * k, origin, scale,
                    sign, content);
        }
    }
    return TAUT_OK;
}

taut_status taut_shell_add_lid(const taut_surface *surface, int edge, const double origin[3],
                               int scale, double sign, double *room, taut_shell_content *content)
{
    const int along_v = edge % 4 < 2;
    const taut_basis *basis = along_v ? taut_surface_v(surface) : taut_surface_u(surface);
    const taut_basis *held = along_v ? taut_surface_u(surface) : taut_surface_v(surface);
    const double at = edge % 2 ? taut_basis_hi(held) : taut_basis_lo(held);
    const size_t count = node_count(basis);
    double *t = room, *weight = t + count, apex[3] = {0, 0, 0}, sum[3] = {0, 0, 0};

    fill_nodes(basis, t, weight);
    for (size_t i = 0; i < count; i++) {
        double values[3 * VECTORS], arm[3], way[3], turn[3];
        const taut_status status =
            taut_surface_eval(surface, along_v ? at : t[i], along_v ? t[i] : at, 1, values);
        if (status != TAUT_OK) {
            return status;
        }
        for (int c = 0; c < 3; c++) {
            arm[c] = ldexp(values[c] - origin[c], -scale);
            way[c] = ldexp(values[(along_v ? 6 : 3) + c], -scale);
            apex[c] = i == 0 ? arm[c] : apex[c];
        }
        taut_cross(arm, way, turn);
        taut_add_scaled(weight[i], turn, sum);
    }
    content->volume += (taut_shell_is_along(edge) ? -sign : sign) * taut_dot(apex, sum) / 6;
    return TAUT_OK;
}
