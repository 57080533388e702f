/* low.h -- the patch of bidegree n + 3 (docs page section 10.1).
 *
 * In homogeneous coordinates p = (W R, W) the tangent plane along an edge is spanned by p, p', p'',
 * so the cross derivative may be
 *     S_v = a p + b p' + c p''     with scalar cubics a, b, c,
 * of degree n + 3. Weights at the corners agree by themselves.
 */
#ifndef TAUT_ASYMPTOTIC_LOW_H
#define TAUT_ASYMPTOTIC_LOW_H

#include "construct/asymptotic/patch.h"

/* Fills the boundary rows and the rows beside them, and the inner weights with 1; patch->m is
 * n + 3. The three free numbers of each corner's twist keep the weights positive and c away from
 * 0. TAUT_NO_SOLUTION where they cannot, or where an edge has an inflection. */
taut_status taut_low_fill(const taut_quad *quad, int report_singular, taut_patch *patch,
                          taut_error *error);

#endif /* TAUT_ASYMPTOTIC_LOW_H */
