/* strains.h -- how a flat piece is strained, of places on a grid that has its border. */
#ifndef TAUT_CONSTRUCT_PATTERN_STRAINS_H
#define TAUT_CONSTRUCT_PATTERN_STRAINS_H

#include "construct/pattern/piece.h"

/* pulse may be NULL. */
taut_pattern_strains taut_pattern_strains_of(const taut_pattern_piece *piece, taut_pulse *pulse);

#endif /* TAUT_CONSTRUCT_PATTERN_STRAINS_H */
