/* integrals.h -- all integral figures of a surface in one pass. */
#ifndef TAUT_MEASURE_INTEGRATE_INTEGRALS_H
#define TAUT_MEASURE_INTEGRATE_INTEGRALS_H

#include "taut/surface.h"

typedef struct taut_surface_integrals {
    double area, area_error;
    double dirichlet, bending, isothermality;
    double mean_abs; /* of H over the area; NaN where the area is 0 */
} taut_surface_integrals;

taut_status taut_surface_integrals_of(const taut_surface *surface, int threads,
                                      taut_surface_integrals *integrals);

/* Of these only the area, and mean_abs. */
taut_status taut_surface_mean(const taut_surface *surface, int threads, double *area,
                              double *mean_abs);

/* What a certificate of least area tells of the mean curvature, and no more: the same numbers as
 * taut_measure_surface, without its other figures. */
typedef struct taut_mean_figures {
    double area;
    double mean_abs; /* of H over the area; NaN where the area is 0 */
    double max_abs;  /* of H over the closed uniform grid; NaN where no point has a normal */
} taut_mean_figures;

/* grid 2..TAUT_GRID_MAX parameters a direction. TAUT_NO_MEMORY. */
taut_status taut_mean_figures_of(const taut_surface *surface, int grid, int threads,
                                 taut_mean_figures *figures);

#endif /* TAUT_MEASURE_INTEGRATE_INTEGRALS_H */
