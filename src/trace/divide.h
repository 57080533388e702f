/* divide.h -- straight lines of the window, and laths, cut into parts of equal measure. */
#ifndef TAUT_TRACE_DIVIDE_H
#define TAUT_TRACE_DIVIDE_H

#include "trace/lath.h"

/* A straight line of the window with its measure summed up over many short pieces. */
typedef struct taut_ruler {
    const taut_carrier *carrier;
    taut_trace_net net;
    taut_trace_by by;
    double from[2], to[2];
    int count;   /* of pieces */
    double *t;   /* [count + 1], 0 to 1 */
    double *sum; /* [count + 1], 0 to the whole */
} taut_ruler;

/* In the arena. TAUT_NO_MEMORY. */
taut_status taut_ruler_new(taut_arena *arena, const taut_carrier *carrier, taut_trace_net net,
                           taut_trace_by by, const double from[2], const double to[2],
                           taut_ruler *ruler);
/* The place where the measure is `target`, 0 to the whole. */
void taut_ruler_at(const taut_ruler *ruler, double target, double at[2]);

/* The place of a lath where its measure (or with `by` length, its length) is `target`; 0 where it
 * cannot be stepped to. */
int taut_lath_at(taut_linefield_kind kind, const taut_lath *lath, taut_trace_by by, double target,
                 taut_station *station);

#endif /* TAUT_TRACE_DIVIDE_H */
