/* arc.h -- plane quintic splines as Bezier pieces, whose control points hold them. */
#ifndef TAUT_CERTIFY_PATTERN_ARC_H
#define TAUT_CERTIFY_PATTERN_ARC_H

#include "taut/basis.h"

#include <stddef.h>

enum { TAUT_CLOTH_ARC = 6 };

typedef struct taut_cloth_arc {
    double p[TAUT_CLOTH_ARC][2];
} taut_cloth_arc;

/* The Bezier points of one span of a quintic B-spline by its blossoms, of the control points alive on it, two numbers each at
 * `stride`. */
void taut_cloth_arc_of(const taut_basis *basis, int span, const double *alive, size_t stride,
                       double out[TAUT_CLOTH_ARC][2]);
void taut_cloth_arc_halve(const taut_cloth_arc *whole, taut_cloth_arc *low, taut_cloth_arc *high);

#endif /* TAUT_CERTIFY_PATTERN_ARC_H */
