/* spacing.h -- do the curves of a net stand where a seed of equal parts puts them?
 */
#ifndef TAUT_CERTIFY_TRACE_SPACING_H
#define TAUT_CERTIFY_TRACE_SPACING_H

#include "certify/trace/cells.h"
#include "certify/trace/lines.h"

/* Of the seeds of a document that part edges, lines, laths, or the two curves through the node of a lattice: how far,
 * over a part, the measure along the line is from equal parts where curves of the family cross it; of those at a
 * place, how far the nearest curve of the family is from it, over the size, and of geodesics whether it goes the way
 * that it is sent. *where says at which seed. unit: of the cells' surfaces; fit: how far curves are from the surface, over
 * the size, which places along them are not held to. Negative: there is no document.
 * TAUT_NO_MEMORY. */
taut_status taut_net_spacing(const taut_net_lines *lines, taut_net_cells *cells, int unit,
                             double fit, const taut_trace_problem *problem, taut_arena *arena,
                             double *residual, int *where);

#endif /* TAUT_CERTIFY_TRACE_SPACING_H */
