/* side.h -- the long edges of pieces: seams and borders, as quintic splines of the window over arc length.
 *
 * Both pieces of a seam have one and the same spline.
 */
#ifndef TAUT_CONSTRUCT_PATTERN_SIDE_H
#define TAUT_CONSTRUCT_PATTERN_SIDE_H

#include "taut/curve.h"
#include "trace/curve.h"

enum { TAUT_SIDE_NAME = 16 };

typedef struct taut_pattern_side {
    char name[TAUT_SIDE_NAME]; /* "S1", or of a border the edge, "u0" */
    int is_seam;
    int border;               /* where it is none: 0 to 3, u0, u1, v0, v1 */
    const taut_curve *window; /* points (u, v, 0); the arena's */
    taut_lath_part part;      /* and in space, in the surface's own unit */
    double length;            /* in the carrier's unit */
    double ends[2][2];        /* u, v */
    int owners[2];            /* the pieces whose right, and whose left it is, or -1 */
    double share;             /* of a seam of true length: flat over that of the surface */
} taut_pattern_side;

/* The geodesic between two places of the window; `tolerance` over the size. TAUT_NO_SOLUTION, reason "no-geodesic". */
taut_status taut_pattern_geodesic(const taut_carrier *carrier, const double from[2],
                                  const double to[2], const taut_monitor *monitor,
                                  taut_arena *arena, taut_pattern_side *side, taut_error *error);
/* An edge of the window (0 to 3: u0, u1, v0, v1), backwards or not. */
taut_status taut_pattern_border(const taut_carrier *carrier, int edge, int backwards,
                                const taut_monitor *monitor, taut_arena *arena,
                                taut_pattern_side *side, taut_error *error);

/* The place at the share x of the length, and its first and second derivative by x. */
void taut_pattern_side_at(const taut_pattern_side *side, double x, double w[3][2]);

#endif /* TAUT_CONSTRUCT_PATTERN_SIDE_H */
