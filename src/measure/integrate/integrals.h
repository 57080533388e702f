/* integrals.h -- all integral figures of a surface in one pass. */
#ifndef TAUT_MEASURE_INTEGRATE_INTEGRALS_H
#define TAUT_MEASURE_INTEGRATE_INTEGRALS_H

#include "taut/surface.h"

typedef struct taut_figures {
    double area, area_error;
    double dirichlet, bending, isothermality;
    double mean_abs; /* of H over the area; NaN where the area is 0 */
} taut_figures;

taut_status taut_figures_of(const taut_surface *surface, int threads, taut_figures *figures);

/* Of these only the area, and mean_abs. */
taut_status taut_surface_mean(const taut_surface *surface, int threads, double *area,
                              double *mean_abs);

#endif /* TAUT_MEASURE_INTEGRATE_INTEGRALS_H */
