/* cable.h -- an edge of the net drawn by a cable: its length counts beside the area.
 *
 *     F = A + r L,     L = int |x_t| dt,    r = force of the cable over the tension of the film
 *     dL  = int t . d_t,                    t = x_t / |x_t|
 *     d2L = int |d_t - (t . d_t) t|^2 / |x_t|
 *
 * As with the area (construct/plateau/area.h) the metric operator is that of d2L without the
 * projection: L(x + d) <= L(x) + dL d + 1/2 int |d_t|^2 / |x_t| for every d. Where x_t is zero there
 * is no tangent and nothing counts.
 */
#ifndef TAUT_CONSTRUCT_PLATEAU_CABLE_H
#define TAUT_CONSTRUCT_PLATEAU_CABLE_H

#include "core/arena.h"
#include "taut/basis.h"

#include <stddef.h>

enum { TAUT_AREA_CABLE_STATE = 4 }; /* t, weight / |x_t| */

typedef struct taut_area_cable {
    size_t first, step; /* its points in the net: first, first + step, ... */
    double tension;     /* r, in the unit of the net; the caller's to set */
    int nodes, local;   /* Gauss nodes in all, functions alive at each */
    int *alive;         /* [nodes]: the first of them */
    double *slope;      /* [nodes][local], over the unit interval */
    double *weight;     /* [nodes]: their sum is 1 */
    double *state;      /* [nodes][TAUT_AREA_CABLE_STATE] of the last gradient */
} taut_area_cable;

/* local + extra nodes a span, in the arena. TAUT_NO_MEMORY. */
taut_status taut_area_cable_new(const taut_basis *basis, int extra, size_t first, size_t step,
                                taut_arena *arena, taut_area_cable *cable);

/* L of net double[][3]. */
double taut_area_cable_length(const taut_area_cable *cable, const double *net);
/* The same; gradient += r dL, and the operators below are those of this net from now on. */
double taut_area_cable_gradient(taut_area_cable *cable, const double *net, double *gradient);
/* product += r ((1 - theta) d2L + theta metric) direction. */
void taut_area_cable_product(const taut_area_cable *cable, double theta, const double *direction,
                             double *product);

#endif /* TAUT_CONSTRUCT_PLATEAU_CABLE_H */
