/* gauss_bonnet.h -- the integral of K over a piece by its border alone. */
#ifndef TAUT_CERTIFY_PATTERN_GAUSS_BONNET_H
#define TAUT_CERTIFY_PATTERN_GAUSS_BONNET_H

#include "certify/pattern/cloth.h"

/* iint K dA of a piece of four sides; NaN where a side leaves the window or has no length somewhere. */
double taut_cloth_gauss_bonnet(const taut_cloth *cloth, const taut_cloth_piece *piece);

#endif /* TAUT_CERTIFY_PATTERN_GAUSS_BONNET_H */
