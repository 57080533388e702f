/* surface_eval.c -- one point of a surface: the sum over the functions alive there. */
#include "basis/basis_ops.h"
#include "geometry/net.h"
#include "taut/surface.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* Which derivative of u and of v each vector takes, in the order TAUT_X, TAUT_XU, ... */
static const int order_u[6] = {0, 1, 0, 2, 1, 0};
static const int order_v[6] = {0, 0, 1, 0, 1, 2};

static int is_inside(const taut_basis *basis, double t)
{
    return t >= taut_basis_lo(basis) && t <= taut_basis_hi(basis);
}

/* The functions alive at one point, and where the net's part they meet begins. */
typedef struct place {
    int local_u, local_v;
    int64_t columns, first; /* of the net; index of its first point */
    const double *n_u, *n_v;
} place;

/* h[k] = sum_ab d^kN (w x, w y, w z, w)_ab, along v first. `order` is a constant at each call, so
 * that the short loops over derivatives unroll. */
static inline void sum_net(const place *at, const double *points, const double *weights,
                           const int order, double h[6][4])
{
    for (int a = 0; a < at->local_u; a++) {
        const int64_t index = at->first + a * at->columns;
        double row[3][4] = {{0}};
        for (int b = 0; b < at->local_v; b++) {
            const double *point = points + 3 * (index + b);
            const double weight = weights != NULL ? weights[index + b] : 1;
            for (int l = 0; l <= order; l++) {
                const double m = at->n_v[l * at->local_v + b] * weight;
                row[l][0] += m * point[0];
                row[l][1] += m * point[1];
                row[l][2] += m * point[2];
                row[l][3] += m;
            }
        }
        for (int k = 0; k < TAUT_SURFACE_VECTORS(order); k++) {
            const double n = at->n_u[order_u[k] * at->local_u + a];
            for (int c = 0; c < 4; c++) {
                h[k][c] += n * row[order_v[k]][c];
            }
        }
    }
}

taut_status taut_surface_eval(const taut_surface *surface, double u, double v, int order,
                              double *values)
{
    double n_u[3 * (TAUT_DEGREE_MAX + 1)], n_v[3 * (TAUT_DEGREE_MAX + 1)];
    double h[6][4] = {{0}};

    if (surface == NULL || values == NULL || order < 0 || order > 2 ||
        !is_inside(taut_surface_u(surface), u) || !is_inside(taut_surface_v(surface), v)) {
        return TAUT_BAD_ARGUMENT;
    }
    const taut_basis *bu = taut_surface_u(surface), *bv = taut_surface_v(surface);
    const double *points = taut_surface_points(surface);
    const double *weights = taut_surface_weights(surface);
    const int su = taut_basis_span(bu, u), sv = taut_basis_span(bv, v);
    const int64_t columns = taut_basis_count(bv);
    const place at = {.local_u = bu->shape.local,
                      .local_v = bv->shape.local,
                      .columns = columns,
                      .first = bu->first[su] * columns + bv->first[sv],
                      .n_u = n_u,
                      .n_v = n_v};

    bu->ops->eval(bu, su, u, order, n_u);
    bv->ops->eval(bv, sv, v, order, n_v);
    if (order == 0) {
        sum_net(&at, points, weights, 0, h);
    } else if (order == 1) {
        sum_net(&at, points, weights, 1, h);
    } else {
        sum_net(&at, points, weights, 2, h);
    }
    if (weights != NULL) {
        taut_net_project(order, &h[0][0], values);
        return TAUT_OK;
    }
    for (int k = 0; k < TAUT_SURFACE_VECTORS(order); k++) {
        memcpy(values + 3 * k, h[k], 3 * sizeof(double));
    }
    return TAUT_OK;
}
