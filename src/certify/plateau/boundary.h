/* boundary.h -- the claim `boundary` of a film: its edges are the curves of the problem.
 *
 * Its residual is the largest distance of an edge from its curve at equal parts of their ranges,
 * proved (certify/common/curve_distance.h), over the largest distance of two control points of the curves
 * from the first. Its limit: 5/4 of the deviation that the model tells, which was found at samples,
 * over the same, and rounding, 64 (p + q + n) 2^-53 for degrees p, q and n points on an edge.
 */
#ifndef TAUT_CERTIFY_PLATEAU_BOUNDARY_H
#define TAUT_CERTIFY_PLATEAU_BOUNDARY_H

#include "taut/plateau.h"

/* Is the net of the film another one than the problem's? */
static inline int taut_plateau_has_new_net(const taut_plateau_problem *problem)
{
    return problem->curves[0] != NULL || problem->tolerance_area > 0;
}

taut_status taut_certify_plateau_boundary(const taut_surface *surface,
                                          const taut_plateau_problem *problem, double deviation,
                                          taut_certificate *certificate, taut_error *error);

#endif /* TAUT_CERTIFY_PLATEAU_BOUNDARY_H */
