/* cable.h -- an edge of the net drawn by a cable: its length counts beside the area.
 *
 *     F = A + r L,     L = int |x_t| dt,    r = force of the cable over the tension of the film
 *     dL  = int t . d_t,                    t = x_t / |x_t|
 *     d2L = int |d_t - (t . d_t) t|^2 / |x_t|
 *
 * As with the area (construct/plateau/area.h) the metric operator is that of d2L without the
 * projection: L(x + d) <= L(x) + dL d + 1/2 int |d_t|^2 / |x_t| for every d. Where x_t is zero there
 * is no tangent and nothing counts.
 *
 * A cable that gives way has a law instead of a force,
 *
 *     C(L) = p^2 / (2 k),    p = max(0, r_0 + k (L - L_0)),    C' = p,  C'' = k where p > 0
 *
 * elastic with r_0 = 0, and the augmented Lagrangian of a given length L_0 with its multiplier r_0
 * ([NocedalWright2006] 17.3). r is p then, and the second derivative has k dL dL^T more.
 */
#ifndef TAUT_CONSTRUCT_PLATEAU_CABLE_H
#define TAUT_CONSTRUCT_PLATEAU_CABLE_H

#include "core/arena.h"
#include "geometry/nurbs/loop.h"
#include "taut/basis.h"

#include <stddef.h>

enum { TAUT_AREA_CABLE_STATE = 4 }; /* t, weight / |x_t| */

typedef struct taut_area_cable {
    size_t first, step; /* its points in the net: first, first + step, ... */
    double tension; /* r, in the unit of the net; the caller's to set, or p of the last gradient */
    double stiffness;    /* k; 0: a force, the next two mean nothing */
    double base, target; /* r_0, L_0 */
    int count;           /* its points */
    int nodes, local;    /* Gauss nodes in all, functions alive at each */
    int *alive;          /* [nodes]: the first of them */
    double *slope;       /* [nodes][local], over the unit interval */
    double *weight;      /* [nodes]: their sum is 1 */
    double *state;       /* [nodes][TAUT_AREA_CABLE_STATE] of the last gradient */
    double *
        pull; /* [count][3]: dL of the last gradient, where there is a stiffness, or of taut_area_cable_pull */
} taut_area_cable;

/* local + extra nodes a span, in the arena. TAUT_NO_MEMORY. */
taut_status taut_area_cable_new(const taut_basis *basis, int extra, size_t first, size_t step,
                                taut_arena *arena, taut_area_cable *cable);

/* The cable goes around: its points are those of geometry/nurbs/loop.h. */
void taut_area_cable_open(const taut_loop *around, taut_area_cable *cable);

/* C at a length. */
double taut_area_cable_energy(const taut_area_cable *cable, double length);
/* L of net double[][3]. */
double taut_area_cable_length(const taut_area_cable *cable, const double *net);
/* The same; gradient += r dL, and the operators below are those of this net from now on. */
double taut_area_cable_gradient(taut_area_cable *cable, const double *net, double *gradient);
/* cable->pull = dL of the last gradient. */
void taut_area_cable_pull(taut_area_cable *cable);
/* product += (r ((1 - theta) d2L + theta metric) + k dL dL^T) direction. */
void taut_area_cable_product(const taut_area_cable *cable, double theta, const double *direction,
                             double *product);

#endif /* TAUT_CONSTRUCT_PLATEAU_CABLE_H */
