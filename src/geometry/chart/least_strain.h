/* least_strain.h -- the strain that no flat piece avoids, proved of the Gauss curvature alone, before anything is laid flat. */
#ifndef TAUT_GEOMETRY_CHART_LEAST_STRAIN_H
#define TAUT_GEOMETRY_CHART_LEAST_STRAIN_H

#include "core/pulse.h"
#include "geometry/chart/chart.h"

typedef struct taut_least_strain {
    double
        strain; /* of any one-to-one flattening the largest |strain| is no less; 0 where nothing is proved */
    double at, length, radius; /* by what: s on the axis t = 1/2, l and r in the surface's unit */
} taut_least_strain;

/* pulse: NULL is fine; once it says stop nothing is proved. */
taut_least_strain taut_chart_least_strain(const taut_chart *chart, taut_pulse *pulse);

#endif /* TAUT_GEOMETRY_CHART_LEAST_STRAIN_H */
