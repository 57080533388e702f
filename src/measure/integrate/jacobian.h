/* jacobian.h -- taut_surface_jacobian, watched. */
#ifndef TAUT_MEASURE_INTEGRATE_JACOBIAN_H
#define TAUT_MEASURE_INTEGRATE_JACOBIAN_H

#include "core/pulse.h"
#include "taut/measure.h"

/* pulse: told of the work, or NULL. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_jacobian_of(const taut_surface *surface, taut_pulse *pulse,
                             taut_jacobian *jacobian);

#endif /* TAUT_MEASURE_INTEGRATE_JACOBIAN_H */
