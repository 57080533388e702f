/* spacing.h -- do the curves of a net stand where a seed of equal parts puts them?
 */
#ifndef TAUT_CERTIFY_TRACE_SPACING_H
#define TAUT_CERTIFY_TRACE_SPACING_H

#include "certify/trace/cells.h"
#include "certify/trace/lines.h"

/* Of the seeds of a document that part edges, lines, laths, or the two curves through the node of a lattice: how far,
 * over a part, the measure along the line is from equal parts where curves of the family cross it; *where says at
 * which seed. Negative: there is no such seed, or curves pass a seam of one surface with itself. TAUT_NO_MEMORY. */
taut_status taut_net_spacing(const taut_net_lines *lines, taut_net_cells *cells,
                             const taut_trace_problem *problem, taut_arena *arena, double *residual,
                             int *where);

#endif /* TAUT_CERTIFY_TRACE_SPACING_H */
