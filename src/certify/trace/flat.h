/* flat.h -- are the flat pieces of a lath the bands along its pattern, cut and marked where others cross it? */
#ifndef TAUT_CERTIFY_TRACE_FLAT_H
#define TAUT_CERTIFY_TRACE_FLAT_H

#include "certify/trace/audit.h"

/* Of the pieces of a lath, laid so that their axes begin and end as the pattern's stretches do: `outline`, twice half of the
 * width from the axis; `slots`, where the lath's own list says, and as large; `lines`, drill crosses of planks, and an arrow to
 * the end; `texts`, the piece's name at both ends, n on the side of the normal, and the name of each lath that crosses, beside
 * its place. What bounds a piece and what is drilled is held to twice the tolerance that it is drawn to. */
void taut_net_flat_look(const taut_net_audit *audit, const taut_net_line *line,
                        const taut_record *lath, const taut_net_course *course, taut_net_off *off);

#endif /* TAUT_CERTIFY_TRACE_FLAT_H */
