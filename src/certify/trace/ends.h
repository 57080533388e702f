/* ends.h -- may a curve of a net end there, for the reason that is told of it? */
#ifndef TAUT_CERTIFY_TRACE_ENDS_H
#define TAUT_CERTIFY_TRACE_ENDS_H

#include "certify/trace/audit.h"

/* How far end 0 or 1 of a line is from where a curve of this net may end as `ended` of its lath says, over the size:
 *
 *   edge, corner          from that border, or those two, where no curve goes on across it
 *   closed                from the other end
 *   parabolic, envelope   from K = 0; whether the curve has a cusp there or touches that line
 *   flat, umbilic         from R = 0, with H as well or not
 *   crease                0 at a knot across which the normal jumps, or the curvature, to where there is no net
 *   singular              from where the normal vanishes
 *   length                from the length asked for, from the seed on
 *   seed                  0 where a geodesic begins, or goes to
 *
 * INFINITY for another word, and where the reason is none of this net or this place. `longest`: taut_net_longest. */
double taut_net_end_away(const taut_net_audit *audit, const taut_net_line *line, int end,
                         double longest);

/* How long curves may be each way: by the document, or without it as long as the longest that is told to end so;
 * INFINITY where none is. */
double taut_net_longest(const taut_net_audit *audit);

#endif /* TAUT_CERTIFY_TRACE_ENDS_H */
