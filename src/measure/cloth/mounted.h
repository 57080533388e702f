/* mounted.h -- where a place of a flat piece of cloth is when it is mounted, and how it is strained there: by the model and details of a
 * pattern (docs/pattern.md). To be looked at: what is proved is the certificate's.
 *
 *     x(s, t) = X((1 - t) right(s) + t left(s)),     C = J^-T G J^-1,     strains sqrt(eigenvalues of F0^-1 C F0^-1) - 1
 */
#ifndef TAUT_MEASURE_CLOTH_MOUNTED_H
#define TAUT_MEASURE_CLOTH_MOUNTED_H

#include "core/arena.h"
#include "geometry/border_distance.h"
#include "taut/model.h"

typedef struct taut_mounted {
    const taut_surface *surface, *flat; /* flat: NULL where there is no such piece */
    const taut_curve
        *sides[4];      /* right, end, left and start in the window; ends that are straight: NULL */
    double parts[4][2]; /* the shares of them that edges are */
    int kept
        [4]; /* 1 + the coordinate of the window in which a circle around a tip at the other end holds all along; 0: none */
    double shrink[2]; /* 1 / F0, of warp and weft, away from edges that do not yield */
    int fade_count;
    taut_border borders[4]; /* these */
    double lengths[4];      /* over which compensation fades out */
    int is_faded[4][2];
} taut_mounted;

/* Of a flat surface of the model; what it makes is the arena's. TAUT_NO_MEMORY. */
taut_status taut_mounted_new(const taut_model *model, const taut_surface *flat, taut_arena *arena,
                             taut_mounted *mounted);

/* The place, its normal, and the principal strain beyond the compensation that is larger in size; NaN where there is none. */
void taut_mounted_at(const taut_mounted *mounted, double s, double t, double point[3],
                     double normal[3], double *strain);

#endif /* TAUT_MEASURE_CLOTH_MOUNTED_H */
