/* strain.h -- the claim `strain`, where it is proved between places too. */
#ifndef TAUT_CERTIFY_PATTERN_STRAIN_H
#define TAUT_CERTIFY_PATTERN_STRAIN_H

#include "certify/pattern/cloth.h"

/* A principal strain that no place of the piece exceeds, not above `limit`; `found`: of places that were looked at. NaN: not proved. */
double taut_cloth_strain_bound(const taut_cloth *cloth, const taut_cloth_piece *piece, double found,
                               double limit, taut_pulse *pulse);

#endif /* TAUT_CERTIFY_PATTERN_STRAIN_H */
