/* straight.h -- curves of a net that are straight lines of the window, all at one angle.
 *
 * On minimal surfaces with planar lines of curvature in their conformal parameters, and wherever parameter
 * lines are curves of the net, the field has one direction over the whole window ([XuWang2006] section 8).
 * Such curves are followed along that line: places are exact, lengths and the like are quadratures of
 * |x_u a + x_v b|.
 */
#ifndef TAUT_TRACE_STRAIGHT_H
#define TAUT_TRACE_STRAIGHT_H

#include "trace/follow.h"

/* Looks for such families; fills carrier->way. */
void taut_straight_find(taut_carrier *carrier);

/* The direction of a family's lines in the window, of unit length; NULL where they are none. */
const double *taut_straight_way(const taut_carrier *carrier, taut_linefield_kind kind);

/* The state t on along the line, in the cell of `from`, against the direction where t < 0. */
void taut_straight_move(const taut_carrier *carrier, taut_linefield_kind kind,
                        const taut_walk_state *from, double t, taut_walk_state *to);
/* The t that is h long in space, h >= 0; +1 or -1 times that, as the state goes. */
double taut_straight_reach(const taut_carrier *carrier, taut_linefield_kind kind,
                           const taut_walk_state *from, double h);
/* ab and bend of a station: those of the line. x: derivatives up to the second there. */
void taut_straight_station(const double *way, const double x[TAUT_CARRIER_VECTORS][3],
                           taut_station *at);

#endif /* TAUT_TRACE_STRAIGHT_H */
