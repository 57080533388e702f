/* bending.h -- is the bending energy of a biharmonic surface the least for its first rows? */
#ifndef TAUT_CERTIFY_BIHARMONIC_BENDING_H
#define TAUT_CERTIFY_BIHARMONIC_BENDING_H

#include "core/pulse.h"
#include "taut/join.h"

typedef struct taut_bending_slope {
    double residual; /* the largest derivative of the energy over the norms of surface and
                      * direction */
    double noise;    /* what rounding the points can make it */
    int order;       /* of the derivative across the edge that the direction changes */
    int power;       /* how: by this power of the parameter along it */
} taut_bending_slope;

/* The energy iint |x_uu|^2 + 2 |x_uv|^2 + |x_vv|^2 is convex, so it is least exactly where it has
 * no slope along any biharmonic w of the bidegree whose derivatives 0..contact across `edge` vanish
 * there. Those w are written down as power series from the edge: with x the distance from it and y
 * along it
 *     w = sum_kl c[k][l] x^k y^l,
 *     k(k-1)(k-2)(k-3) c[k][l] = -2 (k-2)(k-3) (l+2)(l+1) c[k-2][l+2]
 *                                - (l+4)(l+3)(l+2)(l+1) c[k-4][l+4],
 * which begins with x^2 (contact 1) or x^3 times a power of y ([NiWang2015] section 8.4 counts
 * them). Bezier bases of one degree. No allocation. pulse: told of the work, or NULL; once it says stop
 * the slope has no meaning. */
taut_bending_slope taut_bending_slope_of(const taut_surface *surface, taut_edge edge, int contact,
                                         taut_pulse *pulse);

#endif /* TAUT_CERTIFY_BIHARMONIC_BENDING_H */
