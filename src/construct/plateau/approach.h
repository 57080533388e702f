/* approach.h -- nets come near the least area along normals first.
 *
 * Moves within the surface make steps of the whole net slow, and many. Along normals there are none
 * ([WuWang2011] 7.2): a few cheap steps bring the area to where the whole net has little left to
 * gain. */
#ifndef TAUT_CONSTRUCT_PLATEAU_APPROACH_H
#define TAUT_CONSTRUCT_PLATEAU_APPROACH_H

#include "construct/plateau/trust_region.h"
#include "taut/surface.h"

/* The net moves along the normals of `first`, whose net it is, and the region and *products go
 * on as they would have; net and region stay as they are where no minimum is found that way.
 * TAUT_INTERRUPTED, TAUT_NO_MEMORY. */
taut_status taut_plateau_approach(taut_area_functional *functional, const taut_dirichlet_form *form,
                                  const taut_mask *mask, const taut_surface *first, double aspect,
                                  const taut_monitor *monitor, taut_trust_region *region,
                                  double *net, int *products, taut_error *error);

#endif /* TAUT_CONSTRUCT_PLATEAU_APPROACH_H */
