/* crossings.h -- are the figures of nodes those of the curves that cross there, and laths cut to fit each other? */
#ifndef TAUT_CERTIFY_TRACE_CROSSINGS_H
#define TAUT_CERTIFY_TRACE_CROSSINGS_H

#include "certify/trace/audit.h"

/* Both curves of a node of details, at its lengths; 0 where there are none. */
int taut_net_spots_of_node(const taut_net_audit *audit, const taut_record *node,
                           taut_net_spot spots[2]);

/* Of each node `angle`, `tau`, `H`, `slot` and, of laths that stand, `slot_twisted`. */
void taut_net_crossings_look(const taut_net_audit *audit, taut_net_off *off);

/* Does the list `nodes` of a lath have all of its nodes, at their lengths? */
void taut_net_passed_look(const taut_net_audit *audit, const taut_net_line *line,
                          const taut_record *lath, taut_net_off *off);

/* `slots` of a lath that stands: one a node, at its place of the pattern, from its side, as wide as the other lath needs
 * that has turned against it, half as deep as the lath is wide. */
void taut_net_slots_look(const taut_net_audit *audit, const taut_net_line *line,
                         const taut_record *lath, const taut_net_course *course, taut_net_off *off);

/* The nodes of details, and the slot of a node in the list of a lath, or NULL. */
const taut_record *taut_net_nodes_of(const taut_net_audit *audit);
const taut_record *taut_net_slot_of(const taut_record *slots, const char *node);

#endif /* TAUT_CERTIFY_TRACE_CROSSINGS_H */
