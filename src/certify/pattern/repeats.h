/* repeats.h -- what the details of a pattern repeat of its document, and what they say of the roll. */
#ifndef TAUT_CERTIFY_PATTERN_REPEATS_H
#define TAUT_CERTIFY_PATTERN_REPEATS_H

#include "certify/pattern/cloth.h"
#include "certify/pattern/worst.h"

/* Words, and numbers to rounding; with the document all of them are told, and no others. What of the roll is left over. */
void taut_cloth_look_at_repeats(const taut_cloth *cloth, taut_worst *w);

#endif /* TAUT_CERTIFY_PATTERN_REPEATS_H */
