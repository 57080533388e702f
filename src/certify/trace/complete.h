/* complete.h -- how many nodes a net has, by the ends of its curves alone.
 *
 * On a disc where both families exist everywhere, a curve of one crosses one of the other at most
 * once; and where both end on the border, exactly when their ends separate each other on it, or they
 * share one: a lens between leaves of two transverse line fields holds index +1/2 or more. So single places where
 * the fields vanish do not matter where their index is negative (certify/trace/turning.h); asymptotic ones of a surface
 * with K < 0 around them have no other.
 */
#ifndef TAUT_CERTIFY_TRACE_COMPLETE_H
#define TAUT_CERTIFY_TRACE_COMPLETE_H

#include "certify/trace/lines.h"

/* The claim, where it can be judged: all curves end on the border of a window that is no tube, and
 * the net exists on a grid, or is proved to exist everywhere (is_proved): then the claim is exact.
 * TAUT_NO_MEMORY. */
taut_status taut_net_complete_add(const taut_net_lines *lines, int is_proved, taut_arena *arena,
                                  taut_certificate *certificate);

#endif /* TAUT_CERTIFY_TRACE_COMPLETE_H */
