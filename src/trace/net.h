/* net.h -- a whole net: its seeds in their order, a lath each, and the nodes.
 *
 *     of each seed, of each family it is for: its places, and a lath through each
 *     cells: the laths through a lattice on one curve of the other family, and where the border of
 *            the window, measured across the family, is a part away from the last lath, one more
 *     the crossings of all pairs
 */
#ifndef TAUT_TRACE_NET_H
#define TAUT_TRACE_NET_H

#include "core/pulse.h"
#include "trace/mark.h"
#include "trace/node.h"

/* A seed that has no curve. */
typedef struct taut_left_out {
    const taut_carrier *on;
    int family;
    double at[2];
    taut_linefield_fault fault;
    int is_along; /* it runs along the edge that seeds it */
    int is_short; /* it leaves the window both ways at once */
} taut_left_out;

typedef struct taut_net {
    int carrier_count;
    taut_carrier *const *carriers; /* of all surfaces that curves may lie on */
    const taut_carrier *carrier;   /* the one that seeds are looked at on */
    const taut_trace_problem *problem;
    taut_lath_options options;
    int threads; /* that curves are followed by; 0: 1 */
    taut_pulse
        *pulse; /* of what is found of the curves once they are followed; NULL: nobody watches */
    taut_arena *arena;
    taut_lath *laths;
    int count, room, of_family[2];
    taut_marks marks; /* of laths from seeds */
    taut_nodes nodes;
    taut_left_out *left_out;
    int left_count;
} taut_net;

/* Fills a net whose carriers, carrier (the first one's), problem, options, threads and arena are set; the same for any
 * number of threads. Errors as of taut_trace_make. */
taut_status taut_net_trace(taut_net *net, const taut_monitor *monitor, taut_error *error);

#endif /* TAUT_TRACE_NET_H */
