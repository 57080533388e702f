/* spread.h -- how far the weights of a surface are apart, where they meet.
 *
 * A weight W beside weights of 1 makes a layer of width 1/W in the parameters, in which the surface does all its
 * turning. Cells are halved down to 2^-48 of a span (cells.h); a layer thinner than a few of these is seen by no rule,
 * and rules that see nothing of it agree about a number that is wrong.
 */
#ifndef TAUT_GEOMETRY_NURBS_SPREAD_H
#define TAUT_GEOMETRY_NURBS_SPREAD_H

#include "taut/surface.h"

/* Weights of a span further apart than this, along a line of the net, make layers that no cell resolves. */
#define TAUT_SPREAD_MAX 0x1p43

/* The largest quotient of two weights of one line of the net whose functions are alive on one span; 1 without weights.
 * Lines one by one, as factors per row or column change the parameters more than the surface, and cells follow them. */
double taut_weight_spread(const taut_surface *surface);

#endif /* TAUT_GEOMETRY_NURBS_SPREAD_H */
