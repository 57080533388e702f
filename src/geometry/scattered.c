/* scattered.c -- points at parameters in no order: one by one, the work shared by threads.
 *
 * Each point is that of taut_surface_eval or taut_curve_eval, so that a result does not depend on
 * what else was asked for in the same call. All parameters are looked at before anything is
 * written. */
#include "platform/parallel.h"
#include "taut/curve.h"
#include "taut/surface.h"

#include <assert.h>
#include <stddef.h>

/* NaN is in no range. */
static int are_inside(const taut_basis *basis, int count, const double *t)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    for (int i = 0; i < count; i++) {
        if (!(t[i] >= lo && t[i] <= hi)) {
            return 0;
        }
    }
    return 1;
}

typedef struct places {
    const taut_surface *surface; /* or NULL: of the curve, at u */
    const taut_curve *curve;
    const double *u, *v;
    int order;
    size_t numbers; /* of a point */
    double *values;
} places;

static void fill_surface(void *context, int part, int from, int to)
{
    const places *p = context;
    (void)part;
    for (int i = from; i < to; i++) {
        const taut_status status = taut_surface_eval(p->surface, p->u[i], p->v[i], p->order,
                                                     p->values + (size_t)i * p->numbers);
        assert(status == TAUT_OK);
        (void)status;
    }
}

static void fill_curve(void *context, int part, int from, int to)
{
    const places *p = context;
    (void)part;
    for (int i = from; i < to; i++) {
        const taut_status status =
            taut_curve_eval(p->curve, p->u[i], p->order, p->values + (size_t)i * p->numbers);
        assert(status == TAUT_OK);
        (void)status;
    }
}

static int are_legal(int count, int threads, int order, int order_max)
{
    return count >= 0 && threads >= 0 && threads <= TAUT_THREADS_MAX && order >= 0 &&
           order <= order_max;
}

taut_status taut_surface_eval_points(const taut_surface *surface, int count, const double *u,
                                     const double *v, int order, int threads, double *values)
{
    if (surface == NULL || u == NULL || v == NULL || values == NULL ||
        !are_legal(count, threads, order, 2) || !are_inside(taut_surface_u(surface), count, u) ||
        !are_inside(taut_surface_v(surface), count, v)) {
        return TAUT_BAD_ARGUMENT;
    }
    places all = {.surface = surface,
                  .u = u,
                  .v = v,
                  .order = order,
                  .numbers = 3 * (size_t)TAUT_SURFACE_VECTORS(order),
                  .values = values};
    taut_parallel_for(count, threads, fill_surface, &all);
    return TAUT_OK;
}

taut_status taut_curve_eval_points(const taut_curve *curve, int count, const double *t, int order,
                                   int threads, double *values)
{
    if (curve == NULL || t == NULL || values == NULL ||
        !are_legal(count, threads, order, TAUT_ORDER_MAX) ||
        !are_inside(taut_curve_t(curve), count, t)) {
        return TAUT_BAD_ARGUMENT;
    }
    places all = {.curve = curve,
                  .u = t,
                  .order = order,
                  .numbers = 3 * (size_t)(order + 1),
                  .values = values};
    taut_parallel_for(count, threads, fill_curve, &all);
    return TAUT_OK;
}
