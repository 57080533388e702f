/* cloth.h -- a pattern as the certificate sees it: the pieces of the model with their sides in the window, which the model's details
 * give and which prove themselves.
 *
 * A piece is X(w(s, t)), w the patch of Coons between right and left, curves of the window over [0, 1] of their lengths, and start and
 * end: such curves where they are sewn to something, and else straight. Edges may be parts of their curves. Lengths are those of the
 * surface at size 1: times 2^-unit.
 */
#ifndef TAUT_CERTIFY_PATTERN_CLOTH_H
#define TAUT_CERTIFY_PATTERN_CLOTH_H

#include "core/arena.h"
#include "core/crew.h"
#include "geometry/chart/chart.h"
#include "taut/model.h"
#include "taut/pattern.h"

/* Edges counter-clockwise. */
enum { TAUT_CLOTH_RIGHT = 0, TAUT_CLOTH_END, TAUT_CLOTH_LEFT, TAUT_CLOTH_START, TAUT_CLOTH_EDGES };

typedef struct taut_cloth_side {
    const char *name;
    const taut_surface *on; /* scaled: of several the one in whose window it is */
    int mate;               /* the side of another surface that it is sewn to; -1 */
    int is_turned;          /* it runs against its seam, which is told as its mate runs */
    const char *
        seam; /* its name; of a border that is sewn, where a ring closes, another one; NULL: a border */
    const char *kind;         /* of a seam: geodesic, line, curve */
    const taut_curve *space;  /* of a seam, in the model's unit; NULL: a border of the window */
    const taut_curve *window; /* points (u, v, 0) */
    double length;            /* its range, times 2^-unit */
    double share;             /* as details tell it: flat over true length; NaN: nothing told */
} taut_cloth_side;

typedef struct taut_cloth_piece {
    const char *name;
    const taut_surface *on;      /* scaled: of several the one that it is part of */
    int index;                   /* of the flat surface in the model */
    int sides[TAUT_CLOTH_EDGES]; /* what edges are parts of; -1: a straight part of a border */
    int is_sewn[TAUT_CLOTH_EDGES];
    double held
        [TAUT_CLOTH_EDGES]; /* of those that are held and not sewn: flat over true length, as it is told; NaN */
    int is_point[TAUT_CLOTH_EDGES];   /* start or end: of no length, flat or on the surface */
    double part[TAUT_CLOTH_EDGES][2]; /* shares of the side, as s or t grows */
    int kept
        [2]; /* 1 + the coordinate of the window in which start, or end, a circle around the other one, which is a tip, holds all along
                  * the piece; 0: none */
    const taut_surface *flat;                  /* scaled; the arena's */
    const taut_curve *edges[TAUT_CLOTH_EDGES]; /* as s or t grows, in the model's unit */
    double lengths[TAUT_CLOTH_EDGES], flat_lengths[TAUT_CLOTH_EDGES]; /* lengths.h; times 2^-unit */
    const taut_curve *cut;
    double allowance[TAUT_CLOTH_EDGES]; /* told to be left along each, in the model's unit */
    int border
        [TAUT_CLOTH_EDGES];   /* the edge of the window that each is told to be on; -1: a seam */
    int is_developed;         /* told to be without strain */
    double at[2];             /* on the roll, in the model's unit */
    int is_placed, is_turned; /* is_turned: by half a turn about its origin */
} taut_cloth_piece;

/* An edge near which compensation fades out, of a surface that is cut. */
typedef struct taut_cloth_fade {
    const taut_surface *on; /* scaled */
    int edge, is_faded[2];  /* of warp and weft */
    double length;          /* times 2^-unit */
    double (*places)[3];    /* [TAUT_CLOTH_PLACES + 1] of the edge; the arena's */
} taut_cloth_fade;
enum { TAUT_CLOTH_PLACES = 512 };

typedef struct taut_cloth {
    const taut_model *model;
    const taut_pattern_problem *problem; /* or NULL */
    int surface_count;                   /* that are cut: the first ones of the model */
    int is_several;                      /* pieces and sides tell theirs */
    taut_surface *const *surfaces;       /* scaled; the arena's */
    int unit;
    double size; /* of the largest scaled surface */
    int side_count, piece_count;
    taut_cloth_side *sides;
    taut_cloth_piece *pieces;
    int missing; /* objects that details speak of and that are not there, or not what they are to be */
    char where[96];
    /* what was asked for */
    int is_true, is_straight, has_law;
    int is_conformal; /* angles are kept, and W is that of nothing that was made least */
    int has_seam;     /* lengths that are held have a compensation of their own, `seam` */
    double seam;
    double law[4]; /* D11, D22, D12, D33 */
    double warp, weft, thread;
    int fade_count;
    taut_cloth_fade *fades;
    double strain; /* that none is to be above; 0: none */
    const taut_crew *crew;
    double tolerance;
} taut_cloth;

/* Reads it, in the arena. TAUT_NO_MEMORY; TAUT_BAD_INPUT, reasons "details" and "model". */
taut_status taut_cloth_read(taut_arena *arena, const taut_model *model,
                            const taut_pattern_problem *problem, taut_cloth *cloth,
                            taut_error *error);

/* Right and left at one s: places of the window, and their derivatives by s up to `order`, at most 2. */
typedef struct taut_cloth_across {
    const taut_cloth_piece *piece;
    double s;
    double sides[2][3][2];
    double
        corners[2][2]
               [2]; /* of start and end that are parts of sides: where they meet right and left */
} taut_cloth_across;
void taut_cloth_across_at(const taut_cloth *cloth, const taut_cloth_piece *piece, double s,
                          int order, taut_cloth_across *across);
/* Between them, of order 1: w, and its derivatives by s and t. 0 where a side leaves the window. */
int taut_cloth_window_on(const taut_cloth *cloth, const taut_cloth_across *across, double t,
                         double w[3][2]);
/* Of order 2: w_ss, w_st and w_tt after them. */
int taut_cloth_bend_on(const taut_cloth *cloth, const taut_cloth_across *across, double t,
                       double w[6][2]);
/* g_ss, g_st, g_tt there; 0 where there is none. */
int taut_cloth_metric_on(const taut_cloth *cloth, const taut_cloth_across *across, double t,
                         double g[3]);
int taut_cloth_metric(const taut_cloth *cloth, const taut_cloth_piece *piece, double s, double t,
                      double g[3]);
/* 1 / F0 of warp and weft where the place is `w` of the window. */
void taut_cloth_shrink(const taut_cloth *cloth, const taut_cloth_piece *piece, const double w[2],
                       double shrink[2]);
/* What is left there of the compensation of the one that an edge is nearer to. */
double taut_cloth_left(const taut_cloth *cloth, const taut_cloth_piece *piece, int edge,
                       const double w[2]);
/* The place of a side at a share of it. */
void taut_cloth_side_at(const taut_cloth_side *side, double share, double at[2]);
/* Of two pieces that are sewn together, those whose lengths are the seam's: to its left, or on the first of two surfaces. */
int taut_cloth_is_first(const taut_cloth *cloth, const taut_cloth_piece *piece, int edge);
/* Does an edge lie to the left of its side (0), or to its right? */
static inline int taut_cloth_hand(int edge)
{
    return edge == TAUT_CLOTH_LEFT || edge == TAUT_CLOTH_START;
}
/* The piece by its edges in the window, whose places are bounded. */
taut_chart taut_cloth_chart(const taut_cloth *cloth, const taut_cloth_piece *piece);
/* A curve of the model, plane, at t: y, y', .. up to `order`, times 2^-unit. */
void taut_cloth_line(const taut_cloth *cloth, const taut_curve *curve, double t, int order,
                     double y[][3]);

#endif /* TAUT_CERTIFY_PATTERN_CLOTH_H */
