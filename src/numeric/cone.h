/* cone.h -- the largest b.x where lengths of linear maps are bounded, by a barrier.
 *
 *     maximise b.x      subject to |A_i x| <= 1,      A_i x in R^3
 *
 * x has `shared` numbers that every A_i may see, and then `own` for each block, which only the places of
 * the block see: double[shared + blocks own]. What is climbed is
 *
 *     b.x / mu + sum_i log(1 - |A_i x|^2)
 *
 * by Newton's steps ([BoydVandenberghe2004] 11.3 and 11.6): its top is inside all cones, and within mu
 * times their number of the largest b.x. 0 is inside whatever the A_i are, and so is each x made
 * shorter: places may be added at any time.
 */
#ifndef TAUT_NUMERIC_CONE_H
#define TAUT_NUMERIC_CONE_H

#include "core/arena.h"
#include "numeric/band.h"

typedef struct taut_cone {
    int shared, own, blocks;
    int count, room; /* places, and how many there may be */
    double *rows;    /* [room][3][shared + own]: the A_i, by what they see */
    int *block;      /* [room]; -1: one that sees only what is shared */
    double *at;      /* [2][room][3]: A_i x, and A_i of a step */
    double *gram;    /* [shared + own][shared + own], lower triangle: what one block adds */
    double *scratch; /* [4][shared + own] */
    double *slope, *step;
    taut_band matrix;
    double *tiles; /* of its factors, or NULL */
} taut_cone;

/* The arena owns it all. TAUT_NO_MEMORY. */
taut_status taut_cone_new(int shared, int own, int blocks, int room, taut_arena *arena,
                          taut_cone *cone);

/* A place of block, or of none (-1): its double[3][shared + own], zero, to be filled in. NULL where
 * there is no room. */
double *taut_cone_add(taut_cone *cone, int block);

/* Climbs from x, which lies inside, by as many steps at most. x stays inside. Cost of a step
 * O(count (shared + own)^2 + n^3), n = shared + blocks own. TAUT_NO_SOLUTION: b.x has no largest
 * value that the doubles can tell, and x is as far as it came; TAUT_INTERRUPTED. */
taut_status taut_cone_climb(taut_cone *cone, const double *b, double mu, int steps, double *x,
                            taut_pulse *pulse);

/* y = A x of rows double[3][shared + own] of a block. */
void taut_cone_apply(const taut_cone *cone, const double *rows, int block, const double *x,
                     double y[3]);

#endif /* TAUT_NUMERIC_CONE_H */
