/* turning.h -- are there places that principal directions turn round once forwards, as where two curvatures are equal?
 *
 * Two curves of a net that cross twice enclose index +1/2 or more. Where curvatures jump at a knot, the directions of
 * the two sides count as joined by those of all curvatures between them, so that a place of a knot may have an index
 * too.
 */
#ifndef TAUT_CERTIFY_TRACE_TURNING_H
#define TAUT_CERTIFY_TRACE_TURNING_H

#include "taut/surface.h"

/* 0 where the search found no such place: two of opposite sign that are nearer to each other than it looks may be
 * missed. 1 where it found one, or could not tell. */
int taut_net_turns_forwards(const taut_surface *surface);

#endif /* TAUT_CERTIFY_TRACE_TURNING_H */
