/* piece.h -- a piece between four edges, as a map of (s, t) in [0, 1]^2 into the surface.
 *
 *     (u, v)(s, t) = (1 - t) right(s) + t left(s) + (1 - s) (start(t) - its chord) + s (end(t) - its chord)
 *
 * the patch of Coons in the window: right and left in proportion to their own arc length, and so start and end where they are sewn to
 * something, or where their speed jumps at a knot and is that of all lines between them; where not, straight lines of the window run
 * across.
 */
#ifndef TAUT_CONSTRUCT_PATTERN_PIECE_H
#define TAUT_CONSTRUCT_PATTERN_PIECE_H

#include "construct/pattern/side.h"
#include "geometry/border_distance.h"
#include "geometry/chart/chart.h"
#include "pattern/flat/flat.h"

/* An edge of a piece, as s or t grows. */
typedef struct taut_pattern_bound {
    int side; /* of the layout's: a stretch of it; -1: along a border, to which nothing is sewn */
    const taut_pattern_side *line; /* that side, or NULL */
    int border;                    /* of the window, 0 to 3: u0, u1, v0, v1; -1 */
    int is_point;                  /* start or end: it has no length, the piece has three sides */
    double from, to;               /* shares of the side's length */
    double share;      /* where it is held and not sewn: flat over the surface's length */
    double ends[2][2]; /* the places where it begins and ends */
} taut_pattern_bound;

/* Where compensation fades out: near an edge of the window that does not yield. */
typedef struct taut_pattern_fade {
    taut_border border; /* lengths are those of the surface's own unit */
    double length;
    int is_faded[2]; /* of warp and weft */
} taut_pattern_fade;

/* How a flat piece is strained, of places on a grid that has its border. */
typedef struct taut_pattern_strains {
    double low, high, at[2]; /* principal ones; at: of the larger one, in (s, t) */
    double at_low[2];
    double warp[2], weft[2], shear;
    int is_folded; /* somewhere, at fold */
    double fold[2];
} taut_pattern_strains;

typedef struct taut_pattern_piece {
    char name[TAUT_SIDE_NAME];
    const taut_carrier *carrier;
    int ground; /* the surface that it is part of */
    int strip;  /* pieces of one strip have one number */
    taut_pattern_bound bounds[TAUT_FLAT_EDGES];
    double shares[2]; /* by which warp and weft are cut smaller, away from `fades` */
    int fade_count;
    const taut_pattern_fade *fades;
    int spans[2];   /* of its flat piece */
    int is_graded;  /* nonzero: narrower next to corners */
    int is_hard[2]; /* in pass 1 and 2: on some spans it took many steps */
    /* where lengths are to settle: of edges and in the middle, of the flat piece of so many spans; how far from those of half as many */
    double lengths[TAUT_FLAT_EDGES + 2], unsettled;
    int measured;
    double drift; /* of the lines to sew off the edges of the coarser flat piece, over the size */
    const double *
        log_scale; /* coefficients of a spline on these (conformal.h); NULL: what is laid flat is the piece's own metric */
    double curvature; /* iint K dA */
    int is_developable;
    taut_flat alone, flat; /* of pass 1 and 2, in the carrier's unit */
    const taut_curve *alone_edges[TAUT_FLAT_EDGES],
        *edges[TAUT_FLAT_EDGES];  /* theirs, as s or t grows */
    taut_pattern_strains strains; /* of flat */
} taut_pattern_piece;

/* The place of the window, and its derivatives: w, w_s, w_t, w_ss, w_st, w_tt. */
void taut_pattern_piece_window(const taut_pattern_piece *piece, double s, double t, double w[6][2]);
/* g_ss, g_st, g_tt. */
void taut_pattern_piece_metric(const taut_pattern_piece *piece, double s, double t, double g[3]);
/* 1 / F0 of warp and weft there. */
void taut_pattern_piece_shrink(const taut_pattern_piece *piece, double s, double t,
                               double shrink[2]);

/* Both as taut_flat_strip has them: of one s after the other, whose long edges are kept for the next place. */
typedef struct taut_pattern_kept {
    double s; /* NAN: none yet */
    double sides[2][3][2];
} taut_pattern_kept;
typedef struct taut_pattern_across {
    const taut_pattern_piece *piece;
    taut_pattern_kept *kept;
} taut_pattern_across;
void taut_pattern_across_metric(const void *across, double s, double t, double g[3]);
void taut_pattern_across_shrink(const void *across, double s, double t, double shrink[2]);
/* k_g ds/ds of the line t = const, k_g dt/dt of the line s = const, and the Gauss curvature. */
void taut_pattern_piece_bends(const taut_pattern_piece *piece, double s, double t, double bend[2],
                              double *gauss);
/* |X_x| along an edge, s or t, and its derivative. */
void taut_pattern_bound_speed(const taut_pattern_piece *piece, int edge, double x, double speed[2]);
/* The same map, whose places are bounded; lengths are those of the surface's own unit. */
taut_chart taut_pattern_piece_chart(const taut_pattern_piece *piece);
/* Is something sewn to the edge? */
int taut_pattern_is_sewn(const taut_pattern_piece *piece, int edge);
/* The length of an edge on the surface, in the carrier's unit. */
double taut_pattern_bound_length(const taut_pattern_piece *piece, int edge);

#endif /* TAUT_CONSTRUCT_PATTERN_PIECE_H */
