/* node.h -- where laths of one family cross those of the other. */
#ifndef TAUT_TRACE_NODE_H
#define TAUT_TRACE_NODE_H

#include "trace/lath.h"

typedef struct taut_node {
    int laths[2];   /* indices */
    int occurrence; /* 1, or more where the same two cross again */
    const taut_carrier *on;
    double s[2], at[2], x[3], normal[3];
    double angle;     /* acute, between the tangents */
    double tau, mean; /* sqrt(-K), or 0; H */
    int is_on_border;
} taut_node;

typedef struct taut_nodes {
    taut_arena *arena;
    taut_node *list;
    int count, room;
} taut_nodes;

/* Adds the crossings of laths of the first family with those of the second (of geodesics: of all), pair by
 * pair in the order of the laths, each pair's in the order of its first. TAUT_NO_MEMORY. */
taut_status taut_nodes_find(taut_trace_net net, const taut_lath *laths, int count,
                            taut_nodes *nodes);

#endif /* TAUT_TRACE_NODE_H */
