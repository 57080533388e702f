/* border.h -- how far apart curves of a family end on the border of a window. */
#ifndef TAUT_CERTIFY_TRACE_BORDER_H
#define TAUT_CERTIFY_TRACE_BORDER_H

#include "certify/trace/cells.h"
#include "certify/trace/lines.h"

/* The most that a place of the border of the window of a surface is, by the measure across the family, from the nearest of the
 * last ends of its curves before it, once around; 0 where none ends there, and a part where the next end is no farther than a
 * part and a half. The measure is that of the cells' surfaces: of (-K)^(1/4) ds and such, or of the length.
 * TAUT_NO_MEMORY. */
taut_status taut_net_border_gap(const taut_net_lines *lines, taut_net_cells *cells, int on,
                                int family, taut_trace_by by, double part, taut_arena *arena,
                                double *gap);

#endif /* TAUT_CERTIFY_TRACE_BORDER_H */
