/* told.h -- what details tell of a net beside its laths, nodes and panels. */
#ifndef TAUT_CERTIFY_TRACE_TOLD_H
#define TAUT_CERTIFY_TRACE_TOLD_H

#include "certify/trace/audit.h"

/* That no lath and no node is there twice, `border` of nodes, `kinks`, `left_out`, `hyperbolic_share` and
 * `singular_points`. TAUT_NO_MEMORY. */
taut_status taut_net_told_look(const taut_net_audit *audit, taut_arena *arena, taut_net_off *off);

#endif /* TAUT_CERTIFY_TRACE_TOLD_H */
