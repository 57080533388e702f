/* details.h -- what is told of a pattern: docs/pattern.md says what each member is. */
#ifndef TAUT_CONSTRUCT_PATTERN_DETAILS_H
#define TAUT_CONSTRUCT_PATTERN_DETAILS_H

#include "construct/pattern/allowance.h"
#include "construct/pattern/roll.h"
#include "taut/record.h"

/* What there is to tell of. */
typedef struct taut_pattern_told {
    const taut_pattern_layout *layout;
    const taut_pattern_cut *cut;
    const taut_pattern_problem *problem;
    const taut_pattern_outline *outlines; /* of each piece */
    const taut_pattern_margin *margins;   /* of each piece */
    const taut_pattern_roll *roll;
    double gap;
    double bias; /* NaN: none */
} taut_pattern_told;

/* Members pattern, cloth, compensation, seam_length, marks, strain, pieces, seams, hems, roll, domain, warnings. */
void taut_pattern_describe(const taut_pattern_told *told, taut_record *details);

#endif /* TAUT_CONSTRUCT_PATTERN_DETAILS_H */
