/* roll.h -- the claim roll: flat pieces on their roll, apart from each other and inside it. */
#ifndef TAUT_CERTIFY_PATTERN_ROLL_H
#define TAUT_CERTIFY_PATTERN_ROLL_H

#include "certify/pattern/cloth.h"

/* TAUT_NO_MEMORY. */
taut_status taut_cloth_add_roll(const taut_cloth *cloth, taut_arena *arena,
                                taut_certificate *certificate);

#endif /* TAUT_CERTIFY_PATTERN_ROLL_H */
