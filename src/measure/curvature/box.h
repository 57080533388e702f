/* box.h -- the bounding box of the surface itself, not of its net. */
#ifndef TAUT_MEASURE_CURVATURE_BOX_H
#define TAUT_MEASURE_CURVATURE_BOX_H

#include "core/crew.h"
#include "taut/surface.h"

/* Tight to 1e-12 of the size of the net; of no meaning where the crew was stopped. */
void taut_box_of(const taut_surface *surface, const taut_crew *crew, double box[2][3]);

#endif /* TAUT_MEASURE_CURVATURE_BOX_H */
