/* end_weights.h -- the two edges at a corner must end with the same weight there.
 *
 * Where they do not, the message names the nearest weights that do: at each corner the geometric
 * mean, by which the logarithms of both change least, put in as printed.
 */
#ifndef TAUT_ASYMPTOTIC_END_WEIGHTS_H
#define TAUT_ASYMPTOTIC_END_WEIGHTS_H

#include "construct/asymptotic/quad.h"

/* The weight that edge `edge` of corner data has at an end: the first or the last it gives. */
double taut_corner_end_weight(const taut_asymptotic_corners *corners, int edge, int end);

/* Corner data: TAUT_NO_SOLUTION with all weights, the inner ones of degree 3 as they are. */
taut_status taut_end_weights_of_data(const taut_asymptotic_corners *corners, taut_error *error);

/* Given curves, of these degrees before they were raised: TAUT_NO_SOLUTION with c and q for each
 * curve. To multiply weight j by c q^j leaves a curve unchanged. */
taut_status taut_end_weights_of_curves(const taut_quad *quad, const int degrees[4],
                                       taut_error *error);

#endif /* TAUT_ASYMPTOTIC_END_WEIGHTS_H */
