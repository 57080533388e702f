/* details.h -- what is told of a pattern: docs/pattern.md says what each member is. */
#ifndef TAUT_CONSTRUCT_PATTERN_DETAILS_H
#define TAUT_CONSTRUCT_PATTERN_DETAILS_H

#include "construct/pattern/outline.h"
#include "construct/pattern/roll.h"
#include "taut/record.h"

/* Members pattern, cloth, compensation, seam_length, pieces, seams, roll, domain, warnings. */
void taut_pattern_describe(const taut_pattern_layout *layout, const taut_pattern_cut *cut,
                           const taut_pattern_problem *problem,
                           const taut_pattern_outline *outlines, const taut_pattern_roll *roll,
                           double gap, taut_record *details);

#endif /* TAUT_CONSTRUCT_PATTERN_DETAILS_H */
