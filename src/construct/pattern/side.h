/* side.h -- the lines that pieces lie between: seams and borders, as quintic splines of the window over arc length.
 *
 * All pieces along a seam have one and the same spline, or stretches of it.
 */
#ifndef TAUT_CONSTRUCT_PATTERN_SIDE_H
#define TAUT_CONSTRUCT_PATTERN_SIDE_H

#include "taut/curve.h"
#include "trace/curve.h"

enum { TAUT_SIDE_NAME = 24, TAUT_SIDE_MEAN = 6 };

/* How a seam runs. */
typedef enum taut_pattern_side_kind {
    TAUT_SIDE_GEODESIC = 0,
    TAUT_SIDE_LINE,  /* a parameter line */
    TAUT_SIDE_CURVE, /* as a curve that is given */
    TAUT_SIDE_CIRCLE /* at one distance from a pole */
} taut_pattern_side_kind;

/* A piece along a side: its edge from `from` to `to` of the side's length, as s or t grows. */
typedef struct taut_pattern_holder {
    int piece, edge;
    int hand; /* 0: it lies to the left of the side, 1: to the right; of two surfaces, on the first or the second */
    double from, to; /* from > to where it runs against the side */
} taut_pattern_holder;

typedef struct taut_pattern_side {
    char name[TAUT_SIDE_NAME]; /* "S1", or of a border the edge, "u0" */
    int is_seam;
    char seam[TAUT_SIDE_NAME];   /* "S1": where a ring closes, of both its borders */
    int twin;                    /* the side of the other one, or of another surface's; -1: none */
    int is_turned;               /* which runs the other way */
    int is_fine;                 /* a border that is followed more closely than others */
    int ground;                  /* the surface that it is on */
    taut_pattern_side_kind kind; /* of a seam */
    int border;                  /* where it is on one: 0 to 3, u0, u1, v0, v1; -1 */
    const taut_curve *window;    /* points (u, v, 0); the arena's */
    taut_lath_part part;         /* and in space, in the surface's own unit */
    double length;               /* in the carrier's unit */
    double ends[2][2];           /* u, v */
    double share;                /* of a seam of true length: flat over that of the surface */
    int holder_count;
    taut_pattern_holder *holders; /* those to the left first, from its beginning on */
    int is_jointed;               /* more than one of them on one hand: pieces meet on it */
    double mean[TAUT_SIDE_MEAN];  /* then: the stretch it is held at, by Legendre's polynomials */
} taut_pattern_side;

/* *at: where the way from one place to the next crosses a knot line over which the normal jumps. */
int taut_pattern_crease_between(const taut_carrier *carrier, const double from[2],
                                const double to[2], double at[2]);

/* The geodesic between two places of the window; `tolerance` over the size. TAUT_NO_SOLUTION, reasons "no-geodesic" and, where there
 * is a kink between them, "crease". */
taut_status taut_pattern_geodesic(const taut_carrier *carrier, const double from[2],
                                  const double to[2], const taut_monitor *monitor,
                                  taut_arena *arena, taut_pattern_side *side, taut_error *error);
/* The parameter line `held` (0: u, 1: v) = value, backwards or not. */
taut_status taut_pattern_parameter_line(const taut_carrier *carrier, int held, double value,
                                        int backwards, const taut_monitor *monitor,
                                        taut_arena *arena, taut_pattern_side *side,
                                        taut_error *error);
/* Where the geodesic square to another one at a place of it begins and ends, on the border to its right and left; ways: directions in
 * space into the window there; its whole length. */
taut_status taut_pattern_square_ends(const taut_carrier *carrier, const taut_station *station,
                                     const taut_monitor *monitor, taut_arena *arena,
                                     double ends[2][2], double ways[2][3], double *length,
                                     taut_error *error);
/* A geodesic from ends[0] along a direction, so long that it ends at ends[1]. */
taut_status taut_pattern_geodesic_along(const taut_carrier *carrier, const double ends[2][2],
                                        const double way[3], double length,
                                        const taut_monitor *monitor, taut_arena *arena,
                                        taut_pattern_side *side, taut_error *error);
/* A geodesic as a lath, between two places. */
taut_status taut_pattern_geodesic_lath(const taut_carrier *carrier, const double from[2],
                                       const double to[2], const taut_monitor *monitor,
                                       taut_arena *arena, taut_lath *lath, taut_error *error);
/* A lath that was made otherwise, with side->ends; `held`: the coordinate that is the same all along it, or -1. */
taut_status taut_pattern_take_lath(const taut_carrier *carrier, const taut_lath *lath, int held,
                                   taut_arena *arena, taut_pattern_side *side, taut_error *error);
/* An edge of the window (0 to 3: u0, u1, v0, v1), backwards or not. */
taut_status taut_pattern_border(const taut_carrier *carrier, int edge, int backwards,
                                const taut_monitor *monitor, taut_arena *arena,
                                taut_pattern_side *side, taut_error *error);

/* The place at the share x of the length, and its first and second derivative by x. */
void taut_pattern_side_at(const taut_pattern_side *side, double x, double w[3][2]);

#endif /* TAUT_CONSTRUCT_PATTERN_SIDE_H */
