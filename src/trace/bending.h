/* bending.h -- how a lath bends and twists between its stations. */
#ifndef TAUT_TRACE_BENDING_H
#define TAUT_TRACE_BENDING_H

#include "trace/lath.h"

enum { TAUT_K_N, TAUT_K_G, TAUT_TAU_G, TAUT_BENDINGS, TAUT_BENDING_NODES = 8 };

/* Radians along a segment that are rounding: what turns or twists less does neither, and has no largest bend to look for. */
static const double taut_least_angle = 1e-13;

typedef struct taut_lath_bending {
    double value[TAUT_BENDINGS];
} taut_lath_bending;

/* At t in [0, 1] of a segment, by the formulas of the field at the window's quintic; zeros where the
 * field has no direction. */
taut_lath_bending taut_lath_bending_at(taut_linefield_kind kind, const taut_segment *segment,
                                       double t);

/* A segment's ends and the nodes of Gauss's rule between them. */
typedef struct taut_lath_samples {
    taut_linefield_kind kind;
    const taut_segment *segment;
    double t[TAUT_BENDING_NODES + 2], weight[TAUT_BENDING_NODES + 2]; /* of [0, 1]; 0 at the ends */
    taut_lath_bending at[TAUT_BENDING_NODES + 2];
} taut_lath_samples;

void taut_lath_bending_sample(taut_linefield_kind kind, const taut_segment *segment,
                              taut_lath_samples *samples);

/* Of a segment whose largest bends are looked for: operations, roughly. */
#define TAUT_LATH_BENDING_WORK 1e6

/* What is to be the most: not negative. */
typedef double taut_lath_measure(const taut_lath_bending *bending, const void *context);

typedef struct taut_lath_most {
    double value, at; /* s of the lath */
} taut_lath_most;

/* The larger of *most and the largest on the segment: by its samples, and between them round
 * one that is larger than its neighbours; `ends`: round the segment's ends too, where the largest may lie
 * before the first node. */
void taut_lath_take_most(const taut_lath_samples *samples, taut_lath_measure *measure,
                         const void *context, int ends, taut_lath_most *most);

#endif /* TAUT_TRACE_BENDING_H */
