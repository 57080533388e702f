/* area.h -- the claim that the pieces are all of the surface: their areas against its own. */
#ifndef TAUT_CERTIFY_PATTERN_AREA_H
#define TAUT_CERTIFY_PATTERN_AREA_H

#include "certify/certify_ops.h"
#include "certify/pattern/cloth.h"

/* *area: of all pieces, times 4^-unit. TAUT_NO_MEMORY. */
taut_status taut_cloth_add_exhausts(const taut_cloth *cloth, double *area,
                                    taut_certificate *certificate);

#endif /* TAUT_CERTIFY_PATTERN_AREA_H */
