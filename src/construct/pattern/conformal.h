/* conformal.h -- pieces laid flat without changing an angle.
 *
 *     the metric e^(2 phi) G has no curvature where  Laplace phi = K  ([doCarmo1976] 4-2, exercise 18)
 *
 * so that a piece with phi made flat without strain is one of G without a change of angles, e^phi times as large. Of all such maps this
 * one has phi = 0 on the border: the one whose scale varies least (the theorem of Chebyshev and Grave), and which keeps the length of
 * every edge.
 */
#ifndef TAUT_CONSTRUCT_PATTERN_CONFORMAL_H
#define TAUT_CONSTRUCT_PATTERN_CONFORMAL_H

#include "construct/pattern/piece.h"

/* Into piece->log_scale, in the arena: a spline of degree 5 on so many spans as the piece's, 0 on the border, by Galerkin's method.
 * pulse may be NULL. TAUT_NO_MEMORY, TAUT_NO_SOLUTION, TAUT_INTERRUPTED. */
taut_status taut_pattern_find_scale(taut_pattern_piece *piece, taut_pulse *pulse,
                                    taut_arena *arena);
/* As taut_pattern_across_metric: e^(2 phi) G. */
void taut_pattern_scaled_metric(const void *across, double s, double t, double g[3]);

#endif /* TAUT_CONSTRUCT_PATTERN_CONFORMAL_H */
