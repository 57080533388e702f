/* bending.h -- how a lath bends and twists between its stations. */
#ifndef TAUT_TRACE_BENDING_H
#define TAUT_TRACE_BENDING_H

#include "trace/lath.h"

enum { TAUT_K_N, TAUT_K_G, TAUT_TAU_G, TAUT_BENDINGS };

typedef struct taut_bending {
    double value[TAUT_BENDINGS];
} taut_bending;

/* At t in [0, 1] of a segment, by the formulas of the field at the window's quintic; zeros where the
 * field has no direction. */
taut_bending taut_bending_at(const taut_carrier *carrier, taut_linefield_kind kind,
                             const taut_segment *segment, double t);

#endif /* TAUT_TRACE_BENDING_H */
