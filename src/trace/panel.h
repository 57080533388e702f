/* panel.h -- the quads between the nodes of a net: how many, and how plane. */
#ifndef TAUT_TRACE_PANEL_H
#define TAUT_TRACE_PANEL_H

#include "trace/net.h"

typedef struct taut_panel {
    int corners
        [4]; /* nodes, round it, the surface's normal towards who sees them counter-clockwise */
    double planarity; /* distance of the diagonals over their mean length */
} taut_panel;

typedef struct taut_panels {
    taut_panel *list; /* the net's arena's */
    int count;
    double planarity; /* the largest */
} taut_panels;

/* Of every four nodes that follow each other on two curves of either family. TAUT_NO_MEMORY. */
taut_status taut_panels_of(const taut_net *net, taut_panels *panels);

#endif /* TAUT_TRACE_PANEL_H */
