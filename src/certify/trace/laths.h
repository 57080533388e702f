/* laths.h -- what details say of a curve's lath, beside the curve and the document. */
#ifndef TAUT_CERTIFY_TRACE_LATHS_H
#define TAUT_CERTIFY_TRACE_LATHS_H

#include "certify/trace/lines.h"

/* The lath of a curve in details; NULL where there is none. */
const taut_record *taut_net_lath_of(const taut_net_lines *lines, const taut_net_line *line);

/* How far the length of a lath in details is from that of the curve's range, over it; NAN where none is there. */
double taut_net_lath_off(const taut_net_lines *lines, const taut_net_line *line);

/* Is it the strip, as wide and as thick, that the document asks for? */
int taut_net_lath_is_asked(const taut_record *lath, const taut_trace_laths *laths);

#endif /* TAUT_CERTIFY_TRACE_LATHS_H */
