/* seams.h -- claims about the lines of a pattern: cover, on-surface, geodesic, edges, seams, lengths. */
#ifndef TAUT_CERTIFY_PATTERN_SEAMS_H
#define TAUT_CERTIFY_PATTERN_SEAMS_H

#include "certify/pattern/cloth.h"

/* docs/pattern.md says what each residual is. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_cloth_add_lines(const taut_cloth *cloth, taut_arena *arena,
                                 taut_certificate *certificate);

#endif /* TAUT_CERTIFY_PATTERN_SEAMS_H */
