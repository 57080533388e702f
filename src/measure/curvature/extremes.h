/* extremes.h -- the largest and smallest curvatures and forms over a closed uniform grid. */
#ifndef TAUT_MEASURE_CURVATURE_EXTREMES_H
#define TAUT_MEASURE_CURVATURE_EXTREMES_H

#include "core/crew.h"
#include "taut/surface.h"

#include <stdint.h>

typedef struct taut_extremes {
    double max_abs_mean; /* NaN, and so the next, where no point has a normal */
    double max_abs_mean_at[2];
    double min_gaussian, max_gaussian;
    double max_e_minus_g, max_f, max_laplacian;
    int64_t singular; /* grid points where the normal vanishes, seen from any side */
} taut_extremes;

/* TAUT_NO_MEMORY. */
taut_status taut_extremes_of(const taut_surface *surface, int grid, const taut_crew *crew,
                             taut_extremes *extremes);

#endif /* TAUT_MEASURE_CURVATURE_EXTREMES_H */
