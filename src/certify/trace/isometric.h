/* isometric.h -- strips that only bend: is the edge that the details tell as long as that in space? */
#ifndef TAUT_CERTIFY_TRACE_ISOMETRIC_H
#define TAUT_CERTIFY_TRACE_ISOMETRIC_H

#include "certify/trace/cells.h"
#include "certify/trace/lines.h"

/* The largest relative difference of `edge_length` of details from the length of x + h (n + eta T), of
 * envelopes x + h (S - zeta T), h = width/2, in space; *where: the curve's name. cells: of surfaces times 2^-unit.
 * -1 where the document has no such strips with a width. */
double taut_net_isometric(const taut_net_lines *lines, taut_net_cells *cells, int unit,
                          const taut_trace_problem *problem, const char **where);

#endif /* TAUT_CERTIFY_TRACE_ISOMETRIC_H */
