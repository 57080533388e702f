/* fade.h -- where the compensation of a pattern fades out. */
#ifndef TAUT_CERTIFY_PATTERN_FADE_H
#define TAUT_CERTIFY_PATTERN_FADE_H

#include "certify/pattern/cloth.h"

/* Edges that do not yield, as the document says, or details; pieces are known. TAUT_NO_MEMORY. */
taut_status taut_cloth_read_fades(taut_cloth *cloth, taut_arena *arena);

#endif /* TAUT_CERTIFY_PATTERN_FADE_H */
