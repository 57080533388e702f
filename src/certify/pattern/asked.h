/* asked.h -- the claims that hold a pattern against what was asked for, and against what it tells of itself. */
#ifndef TAUT_CERTIFY_PATTERN_ASKED_H
#define TAUT_CERTIFY_PATTERN_ASKED_H

#include "certify/certify_ops.h"
#include "certify/pattern/energy.h"

/* layout (with the document), thread, compensation. TAUT_NO_MEMORY. */
taut_status taut_cloth_add_asked(const taut_cloth *cloth, taut_arena *arena,
                                 taut_certificate *certificate);
/* details: numbers that are told of pieces and seams, against the certificate's own. TAUT_NO_MEMORY. */
taut_status taut_cloth_add_told(const taut_cloth *cloth, const taut_cloth_state *states,
                                taut_certificate *certificate);

#endif /* TAUT_CERTIFY_PATTERN_ASKED_H */
