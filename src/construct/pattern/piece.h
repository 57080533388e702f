/* piece.h -- a piece between two sides, as a map of (s, t) in [0, 1]^2 into the surface.
 *
 *     (u, v)(s, t) = (1 - t) right(s) + t left(s)
 *
 * right and left in proportion to their own arc length: straight lines of the window run across.
 */
#ifndef TAUT_CONSTRUCT_PATTERN_PIECE_H
#define TAUT_CONSTRUCT_PATTERN_PIECE_H

#include "construct/pattern/side.h"
#include "pattern/flat/flat.h"

enum { TAUT_PIECE_RIGHT = 0, TAUT_PIECE_LEFT = 1 };

typedef struct taut_pattern_piece {
    char name[TAUT_SIDE_NAME];
    const taut_carrier *carrier;
    int sides[2];                     /* right and left, of the layout's */
    const taut_pattern_side *edge[2]; /* and those */
    double curvature;                 /* iint K dA */
    int is_developable;
    taut_flat alone, flat; /* of pass 1 and 2, in the carrier's unit */
    const taut_curve *alone_edges[TAUT_FLAT_EDGES],
        *edges[TAUT_FLAT_EDGES]; /* theirs, as s or t grows */
} taut_pattern_piece;

/* The place of the window, and its derivatives: w, w_s, w_t, w_ss, w_st (w_tt is 0). */
void taut_pattern_piece_window(const taut_pattern_piece *piece, double s, double t, double w[5][2]);
/* g_ss, g_st, g_tt, as taut_flat_strip has it; context: the piece. */
void taut_pattern_piece_metric(const void *piece, double s, double t, double g[3]);
/* k_g ds/ds of the line t = const, k_g dt/dt of the line s = const, and the Gauss curvature. */
void taut_pattern_piece_bends(const taut_pattern_piece *piece, double s, double t, double bend[2],
                              double *gauss);

#endif /* TAUT_CONSTRUCT_PATTERN_PIECE_H */
