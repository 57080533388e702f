/* of.h -- the surface that curves or pieces are on: is it the one that was given, or what its problem makes? And the curves of
 * its window as details tell them. */
#ifndef TAUT_CERTIFY_COMMON_OF_H
#define TAUT_CERTIFY_COMMON_OF_H

#include "certify/common/audit.h"
#include "core/arena.h"
#include "taut/construct.h"

/* One of model and of. */
typedef struct taut_certify_given {
    const taut_model *model;
    const taut_problem *of;
    const char *surface; /* its name there, or NULL: the only one */
    int all;             /* or nonzero: all surfaces of the model, and `surface` is not looked at */
    int count;           /* with `all`: those of them that come first, 0: all that there are */
} taut_certify_given;

/* Adds the claim `surface`: numbers that differ from the model's that was given (exact), or claims that do not hold of what was
 * made first, the surface alone under the details of details.of. */
taut_status taut_certify_of(const taut_model *model, const taut_surface *surface,
                            const taut_certify_given *given, taut_arena *arena,
                            const taut_audit *audit, taut_certificate *certificate,
                            taut_error *error);
/* The surface that a document names in a model, or the first one; NULL. */
const taut_surface *taut_certify_named(const taut_model *model, const char *name);

#endif /* TAUT_CERTIFY_COMMON_OF_H */
