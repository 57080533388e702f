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
#include "taut/monitor.h"

/* Fills patch->net; patch->m is n + 3. Inner weights are 1; the three free numbers of each corner's
 * twist and the inner points make A_2 = *energy least as far as Gauss-Newton steps go that keep
 * the weights positive and c away from 0. TAUT_NO_SOLUTION where nothing does, or where an edge has
 * an inflection. */
taut_status taut_low_fill(const taut_quad *quad, int report_singular, const taut_monitor *monitor,
                          taut_patch *patch, double *energy, taut_error *error);

#endif /* TAUT_ASYMPTOTIC_LOW_H */
