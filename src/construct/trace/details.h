/* details.h -- what is told of a net: docs/trace.md says what each member is. */
#ifndef TAUT_CONSTRUCT_TRACE_DETAILS_H
#define TAUT_CONSTRUCT_TRACE_DETAILS_H

#include "taut/record.h"
#include "trace/curve.h"
#include "trace/strip.h"

/* Members trace, laths, nodes, hyperbolic_share, drift, singular_points, panel_count and max_planarity, left_out, kinks,
 * warnings; strips: one a lath, or NULL. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_trace_describe(const taut_net *net, const taut_strip *strips,
                                taut_record *details);

/* "A3B5", a second one of the same two "A3B5.2". */
void taut_trace_node_name(const taut_net *net, const taut_node *node, char *text, size_t size);

#endif /* TAUT_CONSTRUCT_TRACE_DETAILS_H */
