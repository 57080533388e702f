/* strip.h -- laths cut flat and straight: what bending and twisting does to them, how long they are
 * cut, where their slots are. Lengths in the carrier's unit.
 *
 *     standing: x + h n, which bends by k_g and is cut along a curve of curvature k_n
 *     plank:    x + h S, which bends by k_n and is cut along a curve of curvature k_g
 *
 * and strips that only bend, about their rulings:
 *
 *     developable: x + h (n + eta T),  eta = tau_g/k_g    where 1 + h (eta' - k_n (1 + eta^2)) > 0
 *     envelope:    x + h (S - zeta T), zeta = tau_g/k_n   where 1 - h (zeta' + k_g (1 + zeta^2)) > 0
 */
#ifndef TAUT_TRACE_STRIP_H
#define TAUT_TRACE_STRIP_H

#include "trace/net.h"
#include "trace/unroll.h"

typedef struct taut_slot {
    int node;                /* of the net's */
    int side;                /* 0: cut from the +n side, 1: from the other */
    double s;                /* of the lath */
    double at, width, depth; /* on the pattern, along its axis */
} taut_slot;

typedef struct taut_strip_stress {
    double bending, torsion, helix, combined, use; /* where `combined` is the largest; N/mm^2 */
    double at;
    double thickest, widest; /* what bending alone, or helix alone, would allow; INFINITY: any */
} taut_strip_stress;

typedef struct taut_strip {
    double edge_length, mean_stretch, cut_length;
    double end[3];       /* x, y, theta of the pattern's axis */
    double least_radius; /* INFINITY: it stays flat */
    int has_stress;
    taut_strip_stress stress;
    taut_slot *slots; /* along the lath */
    int slot_count;
    taut_unrolled unrolled; /* the axis of its pattern */
} taut_strip;

/* A point of the pattern's axis. */
typedef struct taut_axis_point {
    double s;           /* of the lath */
    double cut;         /* along the axis, as it is cut */
    double x, y, theta; /* from the origin along x */
    double
        skew; /* how far the strip's ruling goes along it for each length across: eta, -zeta, or 0 */
} taut_axis_point;

/* The axis of a lath's pattern, in the net's arena: its ends, the places `stops` (rising), and so many
 * between that a polyline at half the width to both sides is within `sagitta` of the band's edges. */
taut_status taut_strip_axis(const taut_net *net, const taut_strip *strip, const taut_lath *lath,
                            double sagitta, int stop_count, const double *stops,
                            taut_axis_point **points, int *count);

/* A strip a lath, in the net's arena; play: of the slots, in the document's unit. TAUT_NO_MEMORY;
 * TAUT_NO_SOLUTION, reasons "folds", "developable" and "slots". */
taut_status taut_strips_new(const taut_net *net, double play, taut_strip **strips,
                            taut_error *error);

/* Is it near the surface, not the normal? And does it only bend? */
int taut_strip_lies(taut_trace_strip strip);
int taut_strip_only_bends(taut_trace_strip strip);

/* The largest cot(gamma/2) over the heights of the slot that the lath `side` (0, 1) of a node has, gamma
 * the acute angle there of what crosses; 0 where they fall together on the way. */
double taut_slot_twisted(const taut_net *net, const taut_node *node, int side, double width);

#endif /* TAUT_TRACE_STRIP_H */
