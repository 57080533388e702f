/* unit.h -- surfaces at size 1: their squares are in range whatever their own size. */
#ifndef TAUT_CERTIFY_COMMON_UNIT_H
#define TAUT_CERTIFY_COMMON_UNIT_H

#include "taut/surface.h"

/* The exponent of the largest coordinate; 0 of a surface at the origin. */
int taut_certify_unit_of(const taut_surface *surface);

/* The surface 2^-unit times as large, the caller's; weights as they are. TAUT_NO_MEMORY. */
taut_status taut_certify_scaled(const taut_surface *surface, int unit, taut_surface **scaled);

#endif /* TAUT_CERTIFY_COMMON_UNIT_H */
