/* spot.h -- a surface near one point: its Taylor polynomial of order 3, from a span of choice. */
#ifndef TAUT_MEASURE_CURVATURE_SPOT_H
#define TAUT_MEASURE_CURVATURE_SPOT_H

#include "measure/curvature/jet.h"
#include "taut/surface.h"

typedef struct taut_spot {
    taut_jet x[3];          /* coordinates, of points scaled by 2^-scale */
    double bound[TAUT_JET]; /* how large each coefficient could be for a net of this size: what its
                             * rounding is proportional to */
} taut_spot;

/* At (u, v) in the closed spans su, sv. order 0..3: coefficients beyond it are 0. The parameters of
 * the polynomial are those of the surface times 2^-shift[0], 2^-shift[1]. */
void taut_spot_at(const taut_surface *surface, int su, int sv, double u, double v, int order,
                  int scale, const int shift[2], taut_spot *spot);

#endif /* TAUT_MEASURE_CURVATURE_SPOT_H */
