/* rule.h -- the seams that a rule asks for: where each begins and ends, and how it runs between. */
#ifndef TAUT_CONSTRUCT_PATTERN_RULE_H
#define TAUT_CONSTRUCT_PATTERN_RULE_H

#include "construct/pattern/layout.h"

typedef struct taut_pattern_seams {
    taut_pattern_side *list;
    int count;
    int ends[2]; /* borders that all seams run from and to, opposite ones; -1: not known yet */
} taut_pattern_seams;

/* All but butts: from border to border, from seams->ends[0] to seams->ends[1] where they join these two; where they are not known, those
 * of the first seam. `count`: of strips, where the rule tells none. TAUT_BAD_INPUT, reasons outside, curve and count; TAUT_NO_SOLUTION,
 * reasons no-geodesic, singular, crease and shape. */
taut_status taut_pattern_rule_seams(const taut_pattern_ground *ground,
                                    const taut_pattern_rule *rule, int index, int count,
                                    taut_pattern_seams *seams, taut_error *error);

/* Is a border of the window one place of the surface? */
int taut_pattern_is_place(const taut_carrier *carrier, int border);
/* Does a place lie on a border of the window? */
int taut_pattern_is_on(const taut_carrier *carrier, const double at[2], int border);

#endif /* TAUT_CONSTRUCT_PATTERN_RULE_H */
