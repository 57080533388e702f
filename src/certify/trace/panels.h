/* panels.h -- are the panels of details the quads between the nodes of the net, and as plane as they are said to be? */
#ifndef TAUT_CERTIFY_TRACE_PANELS_H
#define TAUT_CERTIFY_TRACE_PANELS_H

#include "certify/trace/audit.h"

/* `panels`, `panel_count` and `max_planarity`; with the problem, where it asks for them. TAUT_NO_MEMORY. */
taut_status taut_net_panels_look(const taut_net_audit *audit, taut_arena *arena, taut_net_off *off);

#endif /* TAUT_CERTIFY_TRACE_PANELS_H */
