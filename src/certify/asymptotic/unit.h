/* unit.h -- a model and its problem brought to unit size by a power of two, which changes no digit.
 *
 * Products of eight lengths and more leave the range of doubles from sizes of some 1e40 on, and what
 * became NaN or infinite cannot be judged. Everything is judged at unit size; curvatures found there
 * are 2^exponent times those of the model.
 */
#ifndef TAUT_CERTIFY_ASYMPTOTIC_UNIT_H
#define TAUT_CERTIFY_ASYMPTOTIC_UNIT_H

#include "certify/asymptotic/parts.h"
#include "core/arena.h"

/* Points times 2^-exponent, the largest coordinate then being in [1/2, 1), and the weights of the
 * patch times a power of two likewise. The arena owns what is made. `problem` may be NULL: then
 * *scaled is not written. TAUT_NO_MEMORY. */
taut_status taut_asymptotic_unit(const taut_asymptotic_model *model,
                                 const taut_asymptotic_problem *problem, taut_arena *arena,
                                 taut_asymptotic_model *unit, taut_asymptotic_problem *scaled,
                                 int *exponent);

#endif /* TAUT_CERTIFY_ASYMPTOTIC_UNIT_H */
