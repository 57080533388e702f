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

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_VOLUME_H */
