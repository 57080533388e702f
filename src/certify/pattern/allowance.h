/* allowance.h -- the claim `allowance`: the line that is cut is as far from the line that is sewn as was asked. */
#ifndef TAUT_CERTIFY_PATTERN_ALLOWANCE_H
#define TAUT_CERTIFY_PATTERN_ALLOWANCE_H

#include "certify/pattern/cloth.h"
#include "taut/certify.h"

/* Adds it where cloth is left anywhere. TAUT_NO_MEMORY. */
taut_status taut_cloth_add_allowance(const taut_cloth *cloth, taut_arena *arena,
                                     taut_certificate *certificate);
/* What a piece's line to cut along goes around, times 4^-unit. */
double taut_cloth_cut_area(const taut_cloth *cloth, const taut_cloth_piece *piece);

#endif /* TAUT_CERTIFY_PATTERN_ALLOWANCE_H */
