/* density.h -- a quadratic energy in the place of the area: that of threads with given forces per width.
 *
 *     P = 1/2 sum_g w_g (a_g |x_u|^2 + b_g |x_v|^2),     dP = K x,   K the metric operator with G / W = a, E / W = b, F = 0
 *
 * so that the operators of the area (construct/plateau/area.h) with theta = 1 are those of P, whatever theta is asked for: P is its own
 * second-order model. Slopes are over the unit interval. The normals of the net are found all the same.
 */
#ifndef TAUT_CONSTRUCT_PLATEAU_DENSITY_H
#define TAUT_CONSTRUCT_PLATEAU_DENSITY_H

#include "construct/plateau/area.h"

struct taut_area_density {
    double *along_u, *along_v; /* [u.count][v.count]: a, b */
    double *image;             /* [nu][nv][3]: scratch */
};

/* For nodes of the functional, in the arena; a and b are 0 yet. TAUT_NO_MEMORY. */
taut_status taut_area_density_new(const taut_area_functional *functional, taut_arena *arena,
                                  taut_area_density *density);

#endif /* TAUT_CONSTRUCT_PLATEAU_DENSITY_H */
