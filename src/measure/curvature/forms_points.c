/* forms_points.c -- fundamental forms and curvatures at parameters in no order: the surface's Taylor
 * polynomial of order 2 at each, whose coefficients are sums of differences of points. */
#include "measure/curvature/spot.h"
#include "platform/parallel.h"
#include "taut/limits.h"
#include "taut/measure.h"

#include <stddef.h>

/* The coefficients of s^i t^j are x_(u^i v^j) / (i! j!), in the order of TAUT_X, ... */
static const double factorials[6] = {1, 1, 1, 2, 1, 2};

typedef struct places {
    const taut_surface *surface;
    const double *u, *v;
    taut_forms *forms;
} places;

static void find_forms(void *context, int part, int from, int to)
{
    static const int no_shift[2] = {0, 0};
    const places *p = context;
    const taut_basis *bu = taut_surface_u(p->surface), *bv = taut_surface_v(p->surface);
    (void)part;
    for (int i = from; i < to; i++) {
        const int su = taut_basis_span(bu, p->u[i]), sv = taut_basis_span(bv, p->v[i]);
        taut_spot spot;
        double values[6][3];
        taut_spot_at(p->surface, su, sv, p->u[i], p->v[i], 2, 0, no_shift, &spot);
        for (int k = 0; k < 6; k++) {
            for (int c = 0; c < 3; c++) {
                values[k][c] = factorials[k] * spot.x[c].c[k];
            }
        }
        taut_forms_of((const double(*)[3])values, &p->forms[i]);
    }
}

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

taut_status taut_surface_forms_points(const taut_surface *surface, int count, const double *u,
                                      const double *v, int threads, taut_forms *forms)
{
    if (surface == NULL || u == NULL || v == NULL || forms == NULL || count < 0 || threads < 0 ||
        threads > TAUT_THREADS_MAX || !are_inside(taut_surface_u(surface), count, u) ||
        !are_inside(taut_surface_v(surface), count, v)) {
        return TAUT_BAD_ARGUMENT;
    }
    places all = {surface, u, v, forms};
    taut_parallel_for(count, threads, find_forms, &all);
    return TAUT_OK;
}
