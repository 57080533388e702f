/* pieces.h -- do the flat pieces of a net lie on their sheets, beside each other? */
#ifndef TAUT_CERTIFY_TRACE_PIECES_H
#define TAUT_CERTIFY_TRACE_PIECES_H

#include "certify/trace/lines.h"

/* Adds the claim `pattern`: how many pieces of details lie over another one's box or over the border of their
 * sheet, or are no outline, and how many laths have none, or not as long and wide as they are said to be, or are not the
 * strips that were asked for; exact, by comparisons alone. Left out where neither the problem (or
 * NULL) nor details speak of pieces. TAUT_NO_MEMORY. */
taut_status taut_net_pieces_add(const taut_net_lines *lines, const taut_trace_problem *problem,
                                double tolerance, taut_arena *arena, taut_certificate *certificate);

#endif /* TAUT_CERTIFY_TRACE_PIECES_H */
