/* summary.h -- what is told of a whole lath: sums and the largest of its bends, and its drift. */
#ifndef TAUT_CONSTRUCT_TRACE_SUMMARY_H
#define TAUT_CONSTRUCT_TRACE_SUMMARY_H

#include "trace/bending.h"
#include "trace/net.h"

typedef struct taut_lath_summary {
    double turn, twist; /* int |k_g| ds, int |tau_g| ds */
    int is_turning;     /* tau_g changes its sign */
    taut_lath_most most[TAUT_BENDINGS];
    double
        drift; /* how far an end moves where the curve is followed at a hundredth of the tolerance */
    taut_status status;
} taut_lath_summary;

/* One a lath, in the net's arena, by its threads; the same for any number of them. TAUT_NO_MEMORY,
 * TAUT_INTERRUPTED. */
taut_status taut_lath_summaries_new(const taut_net *net, taut_lath_summary **summaries);

#endif /* TAUT_CONSTRUCT_TRACE_SUMMARY_H */
