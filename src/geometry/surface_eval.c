/* surface_eval.c -- one point of a surface: the sum over the functions alive there. */
#include "basis/basis_ops.h"
#include "geometry/net.h"
#include "taut/surface.h"

#include <math.h>
#include <string.h>

/* Which derivative of u and of v each vector takes, in the order TAUT_X, TAUT_XU, ... */
static const int order_u[6] = {0, 1, 0, 2, 1, 0};
static const int order_v[6] = {0, 0, 1, 0, 1, 2};

static int inside(const taut_basis *basis, double t)
{
    return t >= taut_basis_lo(basis) && t <= taut_basis_hi(basis);
}

/* h[k][dim] += sum_ab Nu[a] Nv[b] P[a][b], one row a at a time. */
static void add_row(int vectors, int dim, const double *weight_u, int a, int local_u,
                    const double *weight_v, int local_v, const double *row, const double *w,
                    double *h)
{
    for (int k = 0; k < vectors; k++) {
        const double nu = weight_u[order_u[k] * local_u + a];
        const double *nv = weight_v + (long)order_v[k] * local_v;
        for (int b = 0; b < local_v; b++) {
            const double n = nu * nv[b] * (w != NULL ? w[b] : 1);
            for (int c = 0; c < 3; c++) {
                h[k * dim + c] += n * row[3 * b + c];
            }
            if (w != NULL) {
                h[k * dim + 3] += n;
            }
        }
    }
}

taut_status taut_surface_eval(const taut_surface *surface, double u, double v, int order,
                              double *values)
{
    double weight_u[3 * (TAUT_DEGREE_MAX + 1)];
    double weight_v[3 * (TAUT_DEGREE_MAX + 1)];
    double h[6 * 4];
    const int vectors = TAUT_SURFACE_VECTORS(order);

    if (surface == NULL || values == NULL || order < 0 || order > 2 ||
        !inside(taut_surface_u(surface), u) || !inside(taut_surface_v(surface), v)) {
        return TAUT_BAD_ARGUMENT;
    }
    const taut_basis *bu = taut_surface_u(surface);
    const taut_basis *bv = taut_surface_v(surface);
    const double *points = taut_surface_points(surface);
    const double *weights = taut_surface_weights(surface);
    const int dim = weights != NULL ? 4 : 3;
    const int su = taut_basis_span(bu, u), sv = taut_basis_span(bv, v);
    const long columns = taut_basis_count(bv);

    bu->ops->eval(bu, su, u, order, weight_u);
    bv->ops->eval(bv, sv, v, order, weight_v);
    memset(h, 0, sizeof h);
    for (int a = 0; a < bu->shape.local; a++) {
        const long index = (bu->first[su] + a) * columns + bv->first[sv];
        add_row(vectors, dim, weight_u, a, bu->shape.local, weight_v, bv->shape.local,
                points + 3 * index, weights != NULL ? weights + index : NULL, h);
    }
    if (weights != NULL) {
        taut_net_project(order, h, values);
    } else {
        memcpy(values, h, (size_t)vectors * 3 * sizeof(double));
    }
    return TAUT_OK;
}
