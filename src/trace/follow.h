/* follow.h -- one curve of a field from a seed to where it ends, one way.
 *
 *     at each step:  near K = 0 the last piece by its own variable (trace/parabolic.h)
 *                    a step of order 8 in the polynomial of the cell, refused where it turns or errs
 *                    the first event within it: a border of the cell, the seed again, the length
 *                    at a border of the cell: the neighbour's polynomial from there, or the end
 */
#ifndef TAUT_TRACE_FOLLOW_H
#define TAUT_TRACE_FOLLOW_H

#include "core/arena.h"
#include "taut/monitor.h"
#include "trace/field.h"

/* What is integrated along: u, v, the twist int |tau_g| ds, the measure; of geodesics a and b too. */
enum {
    TAUT_WALK_U,
    TAUT_WALK_V,
    TAUT_WALK_TWIST,
    TAUT_WALK_MEASURE,
    TAUT_WALK_A,
    TAUT_WALK_B,
    TAUT_WALK_COUNT
};

typedef enum taut_walk_end {
    TAUT_END_NONE = 0,
    TAUT_END_EDGE,
    TAUT_END_CORNER,
    TAUT_END_PARABOLIC,
    TAUT_END_ENVELOPE,
    TAUT_END_FLAT,
    TAUT_END_UMBILIC,
    TAUT_END_CLOSED,
    TAUT_END_CREASE,
    TAUT_END_SINGULAR,
    TAUT_END_LENGTH,
    TAUT_END_SEED, /* followed one way only */
    TAUT_END_STALLED,
    TAUT_END_SINK /* who was handed its steps had enough */
} taut_walk_end;

/* Where a curve is: a place of a cell, and which way it goes in space. */
typedef struct taut_walk_state {
    const taut_carrier *on; /* whose place it is */
    double y[TAUT_WALK_COUNT];
    double s;          /* from the seed */
    int span[2];       /* the cell whose polynomial counts */
    double tangent[3]; /* unit */
} taut_walk_state;

/* All that is told of a point of the curve; of unit speed. */
typedef struct taut_station {
    const taut_carrier *on;
    double s, at[2], ab[2], bend[2];
    double x[3], tangent[3], acceleration[3], normal[3];
    double k_n, k_g, tau_g, twist, measure;
    double
        blind; /* so far from it, along the curve, bends are rounding, as where it ends at a pole */
} taut_station;

/* A step: between two points in one cell. */
typedef struct taut_piece {
    taut_walk_state start; /* to step from again */
    double h;
    taut_station from, to;
    int near_parabolic; /* it was not stepped by arc length */
} taut_piece;

/* A corner of a curve, from this angle on. */
#define TAUT_LEAST_KINK 1e-8
typedef struct taut_kink {
    const taut_carrier *on;
    double at[2], angle; /* radians */
} taut_kink;

enum { TAUT_KINKS_MAX = 64 };

typedef struct taut_walk {
    taut_arena *arena;
    taut_piece *pieces;
    int count, room;
    taut_walk_end end;
    int edges[2]; /* which edges it ends on: d and side as 2 d + side, -1 for none */
    double end_at[2];
    const taut_carrier *end_on;
    taut_walk_state last; /* where it ended */
    taut_kink kinks[TAUT_KINKS_MAX];
    int kink_count;
    double drift; /* sum of the estimated errors */
} taut_walk;

typedef struct taut_follow_options {
    double tolerance;  /* of a step, over the size */
    double max_length; /* in the carrier's unit */
    int is_bare; /* where it goes alone: no stations, no twist and measure, and nothing for a sink */
    const taut_monitor *monitor; /* asked at every step, or NULL */
    double done;                 /* what it is told: the share before this curve */
    int (*sink)(void *context, const taut_piece *piece); /* or NULL; nonzero: enough */
    void *context;
} taut_follow_options;

/* The state at a seed that goes in the direction `along` in space: of the two the one with
 * tangent . along >= 0. Geodesics start in the direction ab. What is wrong, if anything. */
taut_linefield_fault taut_walk_start(const taut_carrier *carrier, taut_linefield_kind kind,
                                     const double at[2], const int span[2], const double along[3],
                                     taut_walk_state *state);

/* A state on a break of direction d whose cell lies above it (up) or below: where curvatures jump there, the way that
 * is nearer to the tangent before may lead back, and the two sides would send the curve to and fro. A curve of a net
 * crosses the break: its direction turns through those of all curvatures between the two, which never lie along the
 * break where the net exists on both sides. So the way into the cell it is, by a corner of more than a right angle.
 * Geodesics, and curves that run along the break, are left as they are. */
void taut_walk_enter(taut_linefield_kind kind, int d, int up, taut_walk_state *state);

/* "edge", "parabolic", ... */
const char *taut_walk_end_word(taut_walk_end end);

/* A state on a border of its window that goes out of it, moved to where the curve goes on across a seam
 * (trace/seam.h), at a corner across several; 0 where it ends, and then `state` is as it was. */
int taut_walk_carry(taut_linefield_kind kind, taut_walk_state *state);

/* Follows from a state; walk is filled anew. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_follow(taut_linefield_kind kind, const taut_walk_state *start,
                        const taut_follow_options *options, taut_arena *arena, taut_walk *walk);

/* The state h on from another one, by one full step in its cell; 0 where there is none. */
int taut_walk_step(taut_linefield_kind kind, const taut_walk_state *from, double h,
                   taut_walk_state *to);
/* What is to be told of a state; 0 where its bend is infinite (then it is 0). */
int taut_walk_station(taut_linefield_kind kind, const taut_walk_state *state,
                      taut_station *station);

#endif /* TAUT_TRACE_FOLLOW_H */
