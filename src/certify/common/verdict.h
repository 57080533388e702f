/* verdict.h -- comparisons that a NaN or an overflow cannot pass.
 *
 * fmax drops a NaN and `residual > limit` is false of one, so that what left the range of doubles
 * would hold. Here it leaves the claim open.
 */
#ifndef TAUT_CERTIFY_COMMON_VERDICT_H
#define TAUT_CERTIFY_COMMON_VERDICT_H

#include "taut/certify.h"

#include <math.h>

/* The larger, or a NaN where either is one; and the lesser. */
static inline double taut_certify_max(double a, double b)
{
    return isnan(a) || a > b ? a : b;
}

static inline double taut_certify_min(double a, double b)
{
    return isnan(a) || a < b ? a : b;
}

/* residual <= limit; undecided where either is not finite. */
static inline taut_verdict taut_certify_below(double residual, double limit)
{
    return !isfinite(residual) || !isfinite(limit) ? TAUT_UNDECIDED
           : residual <= limit                     ? TAUT_TRUE
                                                   : TAUT_FALSE;
}

/* value > limit; undecided where either is not finite. */
static inline taut_verdict taut_certify_above(double value, double limit)
{
    return !isfinite(value) || !isfinite(limit) ? TAUT_UNDECIDED
           : value > limit                      ? TAUT_TRUE
                                                : TAUT_FALSE;
}

/* What to say of a claim whose numbers are not finite. */
#define TAUT_CERTIFY_OUT_OF_RANGE "a value leaves the range of doubles"

/* And where weights are further apart than geometry/nurbs/spread.h lets any rule see. */
#define TAUT_CERTIFY_WEIGHTS_APART                                                                 \
    "weights of a span are more than 2^43 apart: no rule sees the layers they make"

#endif /* TAUT_CERTIFY_COMMON_VERDICT_H */
