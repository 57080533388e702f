/* lath.h -- a whole curve of a net: both ways from its seed, cut where its quintics are good enough.
 *
 * On a piece the curve is told by the quintic of Hermite over arc length, in space and in the window.
 */
#ifndef TAUT_TRACE_LATH_H
#define TAUT_TRACE_LATH_H

#include "trace/follow.h"

enum { TAUT_LATH_NAME = 16, TAUT_QUINTIC = 6 /* control points */ };

/* A piece of a lath: `from` and `to` as the lath runs, s from its beginning. `walk` steps from
 * walk.start, whose s + h stands for first + way (s + h) on the lath. */
typedef struct taut_segment {
    taut_station from, to;
    taut_walk_state start;
    double h, first;
    double twist,
        measure; /* at `start`, where it may not begin any more: it may have become longer */
    int way;     /* +1, or -1: stepped against the lath */
    int near_parabolic;
} taut_segment;

typedef struct taut_lath {
    char name[TAUT_LATH_NAME];
    int family;
    double seed[2], seed_s;
    double seed_tangent[3];
    taut_station at_seed;
    taut_segment *segments;
    int count, steps;
    taut_walk_end ended[2]; /* at the beginning, at the end */
    int edges[2][2];
    double ends[2][2];
    const taut_carrier *end_on[2];
    double length, twist, measure, drift;
    taut_kink *kinks;
    int kink_count;
    int is_longer; /* a geodesic to a place, and not the shortest way there */
} taut_lath;

typedef struct taut_lath_options {
    taut_follow_options follow;
    double tolerance; /* of the quintics, over the size */
    double residual;  /* of what the net claims: largest |k_n|/R, |tau_g|/R, or k_g times size */
} taut_lath_options;

/* The curve of the family through `at` that runs along `along` there (in space; for a geodesic its
 * direction); both: both ways. *fault says why there is none; the lath is then empty. TAUT_NO_MEMORY. */
taut_status taut_lath_trace(const taut_carrier *carrier, taut_linefield_kind kind,
                            const double at[2], const double along[3], int both,
                            const taut_lath_options *options, taut_arena *arena, taut_lath *lath,
                            taut_linefield_fault *fault);

/* Does the curve go on across a seam of the window, or on another surface, between them? */
int taut_station_passes_seam(const taut_station *a, const taut_station *b);
/* The quintics of a segment, as the lath runs. */
void taut_segment_space(const taut_segment *segment, double points[TAUT_QUINTIC][3]);
void taut_segment_window(const taut_segment *segment, double points[TAUT_QUINTIC][2]);
/* A quintic in `dim` (at most 3) coordinates at t in [0, 1] by de Casteljau: its value, a fifth of its
 * first derivative and a twentieth of its second. */
void taut_quintic_at(int dim, const double *points, double t, double *value, double *step,
                     double *bend);

/* The station of a state of the curve that a segment is stepped along, as the lath runs. */
void taut_segment_station(taut_linefield_kind kind, const taut_segment *segment,
                          const taut_walk_state *state, taut_station *station);
/* That of s of the lath on a segment, by one full step. 0 where there is none. */
int taut_segment_state(taut_linefield_kind kind, const taut_segment *segment, double s,
                       taut_station *station);

#endif /* TAUT_TRACE_LATH_H */
