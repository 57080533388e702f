/* layout.h -- the pieces that the rules cut a surface in. */
#ifndef TAUT_CONSTRUCT_PATTERN_LAYOUT_H
#define TAUT_CONSTRUCT_PATTERN_LAYOUT_H

#include "construct/pattern/piece.h"
#include "taut/pattern.h"

/* The edge of another surface that one is sewn to. */
typedef struct taut_pattern_mate {
    int is_there, ground, edge;
    int is_reversed; /* the two run against each other */
} taut_pattern_mate;

/* What is cut: a surface, or one of several. */
typedef struct taut_pattern_ground {
    const taut_carrier *carrier;
    const char *name;        /* of one of several; or NULL */
    const taut_model *model; /* curves that seams run along are in it */
    int is_ring[2];          /* u0 and u1, v0 and v1 are one line */
    int is_pole[4];          /* u0, u1, v0, v1 are one place */
    taut_pattern_mate mates[4];
    const taut_monitor *monitor;
    taut_arena *arena;
} taut_pattern_ground;

typedef struct taut_pattern_layout {
    const taut_carrier *carrier; /* of the first surface: all have one frame */
    const taut_pattern_ground *grounds;
    int ground_count;
    taut_arena *arena;
    taut_pattern_side *sides;
    int side_count;
    taut_pattern_piece *pieces;
    int piece_count;
} taut_pattern_layout;

/* How many strips the rule makes that tells no number, and in how many parts butts cut each strip where they tell nothing ([TAUT_PATTERN_PIECES_MAX],
 * by a piece's `strip`). */
typedef struct taut_pattern_counts {
    int strips;
    const int *parts;
} taut_pattern_counts;

/* Cuts each surface by the rules in their order. TAUT_BAD_INPUT, reasons outside, curve, count, rule; TAUT_NO_SOLUTION, reasons no-geodesic,
 * crossing, shape, singular, crease. */
taut_status taut_pattern_lay_out(const taut_pattern_ground *grounds, int ground_count,
                                 const taut_pattern_problem *problem,
                                 const taut_pattern_counts *counts, taut_pattern_layout *layout,
                                 taut_error *error);

#endif /* TAUT_CONSTRUCT_PATTERN_LAYOUT_H */
