/* seam.h -- where curves go on from one surface to the next: edges that are one line in space, with one
 * normal.
 */
#ifndef TAUT_TRACE_SEAM_H
#define TAUT_TRACE_SEAM_H

#include "trace/carrier.h"

/* What an edge is joined to. */
typedef struct taut_seam {
    const taut_carrier *to;
    int edge;        /* u0, u1, v0, v1 of it: 2 d + side */
    int is_reversed; /* the two run against each other */
} taut_seam;

/* Do the ends of two edges lie within `room` of each other, over the size? 0 no, 1 as the edges run, -1 against
 * each other. An edge whose ends are one place has no direction, and is no seam. */
int taut_seam_ends_meet(const taut_carrier *a, int edge_a, const taut_carrier *b, int edge_b,
                        double room);
/* Do their normals agree in the middle of the first edge? Then curves may go on. */
int taut_seam_agrees(const taut_carrier *a, int edge_a, const taut_seam *seam);

/* The edge of the window that a place lies on and (a, b) leads out of, or -1. */
int taut_seam_out(const taut_carrier *carrier, const double at[2], const double ab[2]);
/* The place of the surface beyond an edge that is the same in space; NULL where there is no seam, or it is
 * farther away than a curve may jump. */
const taut_carrier *taut_seam_cross(const taut_carrier *carrier, int edge, const double at[2],
                                    double there[2]);

#endif /* TAUT_TRACE_SEAM_H */
