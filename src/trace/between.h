/* between.h -- the geodesic from one place to another. */
#ifndef TAUT_TRACE_BETWEEN_H
#define TAUT_TRACE_BETWEEN_H

#include "trace/follow.h"

typedef struct taut_between {
    double along[3]; /* the direction it starts in, in space */
    double length;
    int is_found;    /* 0: there is none inside the window, or none was found */
    int is_shortest; /* 0: neighbours meet it before the end: it is not the shortest way */
} taut_between;

/* TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_geodesic_between(const taut_carrier *carrier, const double from[2],
                                  const double to[2], const taut_follow_options *options,
                                  taut_arena *arena, taut_between *found);

#endif /* TAUT_TRACE_BETWEEN_H */
