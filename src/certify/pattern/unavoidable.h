/* unavoidable.h -- the strain that no flat piece avoids, of the Gauss curvature alone. */
#ifndef TAUT_CERTIFY_PATTERN_UNAVOIDABLE_H
#define TAUT_CERTIFY_PATTERN_UNAVOIDABLE_H

#include "certify/pattern/cloth.h"

typedef struct taut_cloth_limit {
    double
        unavoidable; /* of any one-to-one flattening the largest |strain| is no less; 0 where none is known */
    double
        expected; /* the least that seams of any length allow in a long strip: max |K| (width/4)^2 */
    double at, length,
        radius; /* where the first was found: s on the axis, and l, r times 2^-unit */
} taut_cloth_limit;

/* pulse: NULL is fine; once it says stop the limit has no meaning. */
void taut_cloth_limit_of(const taut_cloth *cloth, const taut_cloth_piece *piece, taut_pulse *pulse,
                         taut_cloth_limit *limit);

#endif /* TAUT_CERTIFY_PATTERN_UNAVOIDABLE_H */
