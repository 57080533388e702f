/* integrals.h -- all integral figures of a surface in one pass. */
#ifndef TAUT_MEASURE_INTEGRATE_INTEGRALS_H
#define TAUT_MEASURE_INTEGRATE_INTEGRALS_H

#include "core/crew.h"
#include "taut/surface.h"

/* A number beyond the range of doubles is NaN. Errors are 0 where they are below 1e-10 of the
 * figure; else they are those of quadrature and of rounding together. */
typedef struct taut_surface_integrals {
    double area, area_error;
    double dirichlet, dirichlet_error;
    double isothermality, isothermality_error;
    double bending, bending_error; /* order 2; else 0 */
    double mean_abs;               /* order 2: of |H| over the area; NaN where the area is 0 */
    double
        mean_square; /* order 2: of H^2 over the area; NaN where that is 0 or no integral is found */
} taut_surface_integrals;

/* order 1: those of first derivatives; 2: all. TAUT_NO_MEMORY. */
taut_status taut_surface_integrals_of(const taut_surface *surface, int order, const taut_crew *crew,
                                      taut_surface_integrals *integrals);

/* One alone. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_surface_bending_of(const taut_surface *surface, const taut_crew *crew,
                                    double *energy, double *error);
taut_status taut_surface_dirichlet_of(const taut_surface *surface, const taut_crew *crew,
                                      double *energy);
taut_status taut_surface_isothermality_of(const taut_surface *surface, const taut_crew *crew,
                                          double *isothermality);

/* Of these only the area and those of H; the others 0. */
taut_status taut_surface_mean(const taut_surface *surface, const taut_crew *crew,
                              taut_surface_integrals *integrals);

/* What a certificate of least area tells of the mean curvature, and no more: figures of
 * taut_measure_surface, mean_abs to four digits only. */
typedef struct taut_mean_figures {
    double area, area_error;
    double mean_abs; /* of H over the area; NaN where the area is 0 */
    double rms;      /* root of the mean of H^2 over the area; NaN where there is none */
    double max_abs;  /* of H over the closed uniform grid; NaN where no point has a normal */
} taut_mean_figures;

/* grid 2..TAUT_GRID_MAX parameters a direction. TAUT_NO_MEMORY. */
taut_status taut_mean_figures_of(const taut_surface *surface, int grid, const taut_crew *crew,
                                 taut_mean_figures *figures);

/* Of these the largest alone, which no integral has to be found for. TAUT_NO_MEMORY. */
taut_status taut_mean_largest(const taut_surface *surface, int grid, const taut_crew *crew,
                              double *most);

#endif /* TAUT_MEASURE_INTEGRATE_INTEGRALS_H */
