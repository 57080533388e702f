/* volume.h -- what a patch adds to the volume of a cell, and its derivatives, at the Gauss nodes of its area functional.
 *
 *     V       = 1/3 iint y . (x_u x x_v),     y = x - from
 *     dV      = 1/3 iint d . (x_u x x_v) + d_u . (x_v x y) + d_v . (y x x_u)
 *     d N_b w = -[t] w at N_a:    t = 1/3 iint x_v (N_a N_b,u - N_a,u N_b) + x_u (N_a,v N_b - N_a N_b,v) + y (N_a,u N_b,v - N_a,v N_b,u)
 *
 * of d^2 V, [t] w = t x w: it is antisymmetric in each pair of functions, as what the area has beside its part along the normal.
 */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_VOLUME_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_VOLUME_H

#include "construct/plateau/area.h"

/* Of a Gauss node: x, x_u, x_v. */
enum { TAUT_VOLUME_PLACE = 9 };

/* places[u.count][v.count][TAUT_VOLUME_PLACE] of net double[nu][nv][3]; rows: scratch of 6 nv. */
void taut_volume_places(const taut_area_functional *area, const double *net, double *rows,
                        double *places);
/* V; share times its gradient is added to gradient double[nu][nv][3] where there is one. */
double taut_volume_patch(const taut_area_functional *area, const double *places,
                         const double from[3], double share, double *gradient);

/* Functions and slopes of a cell at a node. */
typedef struct taut_volume_pair {
    double value, u, v;
} taut_volume_pair;

/* pull x - lever in place of y, pull x_u, pull x_v: t of a pair (a, b), without the weight, is added to t[3]. */
static inline void taut_volume_pair_add(const double *place, double pull, const double lever[3],
                                        const taut_volume_pair *a, const taut_volume_pair *b,
                                        double t[3])
{
    const double along_v = pull / 3 * (a->value * b->u - a->u * b->value);
    const double along_u = pull / 3 * (a->v * b->value - a->value * b->v);
    const double both = (a->u * b->v - a->v * b->u) / 3;

    for (int k = 0; k < 3; k++) {
        t[k] +=
            along_v * place[6 + k] + along_u * place[3 + k] + both * (pull * place[k] - lever[k]);
    }
}

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_VOLUME_H */
