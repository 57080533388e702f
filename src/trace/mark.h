/* mark.h -- where laths come to the border of a window: end there, pass to another surface or over a seam, or close.
 *
 * A place of the border is t in [0, 4), once around from the corner of least u and v along growing u. */
#ifndef TAUT_TRACE_MARK_H
#define TAUT_TRACE_MARK_H

#include "trace/lath.h"

typedef struct taut_mark {
    const taut_carrier *on;
    int family;
    double t;
    int passing; /* equal of one passing, and above 0; 0: an end; below 0: it closes there */
} taut_mark;

/* Marks of laths in the order of these. */
typedef struct taut_marks {
    taut_arena *arena;
    taut_mark *list;
    int count, room, passings;
} taut_marks;

taut_status taut_marks_add(taut_marks *marks, const taut_lath *lath);

/* The last one of a family on a carrier in (from, to], as t or t + 4; -1 where there is none. */
double taut_marks_last(const taut_marks *marks, const taut_carrier *on, int family, double from,
                       double to);

/* The first lath's end, or passing; -1 where there is none. */
double taut_marks_first(const taut_marks *marks, const taut_carrier *on, int family);

#endif /* TAUT_TRACE_MARK_H */
