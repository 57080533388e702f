/* met.h -- do curves of a net cross where no node is? */
#ifndef TAUT_CERTIFY_TRACE_MET_H
#define TAUT_CERTIFY_TRACE_MET_H

#include "certify/trace/lines.h"

/* How many crossings no node of details is at, of curves of both families, of geodesics of all pairs: those that their
 * chords in the window show, and Newton confirms, not within 1e-6 of the size of an end; the first one's curves in
 * `where`. A crossing between two places of a curve that chords do not show may be missed. TAUT_NO_MEMORY. */
taut_status taut_net_met(const taut_net_lines *lines, taut_arena *arena, double *unmet,
                         char where[96]);

#endif /* TAUT_CERTIFY_TRACE_MET_H */
