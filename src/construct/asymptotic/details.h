/* details.h -- what the construction decided, as a record. */
#ifndef TAUT_ASYMPTOTIC_DETAILS_H
#define TAUT_ASYMPTOTIC_DETAILS_H

#include "construct/asymptotic/branch.h"
#include "construct/asymptotic/ribbon.h"

/* Everything the record tells; pointers may be NULL where there is nothing to tell. */
typedef struct taut_asymptotic_story {
    const taut_quad *quad;
    const taut_patch *patch;
    const taut_ribbon *ribbons; /* [4], for the patch of degree 5n - 7 */
    const taut_branches *branches;
    double curve_energy, patch_energy;
} taut_asymptotic_story;

/* A new record, or NULL when memory runs out. */
taut_record *taut_asymptotic_details(const taut_asymptotic_story *story);

#endif /* TAUT_ASYMPTOTIC_DETAILS_H */
