/* fold.h -- the claims no-fold and no-overlap: a flat piece turns over nowhere, and does not lie over itself. */
#ifndef TAUT_CERTIFY_PATTERN_FOLD_H
#define TAUT_CERTIFY_PATTERN_FOLD_H

#include "certify/pattern/cloth.h"

/* TAUT_NO_MEMORY. */
taut_status taut_cloth_add_folds(const taut_cloth *cloth, taut_arena *arena,
                                 taut_certificate *certificate);

#endif /* TAUT_CERTIFY_PATTERN_FOLD_H */
