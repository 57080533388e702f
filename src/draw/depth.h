/* depth.h -- how near the surfaces are at each point of the page, to tell what they hide. */
#ifndef TAUT_DRAW_DEPTH_H
#define TAUT_DRAW_DEPTH_H

#include "core/arena.h"

typedef struct taut_depth {
    int width, height; /* cells of one page unit */
    float *nearest;    /* [height][width]: -INFINITY where there is none */
} taut_depth;

/* 0 when memory runs out. */
int taut_depth_new(int width, int height, taut_arena *arena, taut_depth *depth);
/* Corners (x, y, depth), finite; parts beside the page are passed over. */
void taut_depth_triangle(taut_depth *depth, const double a[3], const double b[3],
                         const double c[3]);
/* The depth of the cell that holds (x, y), or of the nearest one on the page. */
double taut_depth_at(const taut_depth *depth, double x, double y);
/* Is a finite point behind a surface? Not when it is within `slack` of it, nor when it is nearer
 * than the farthest of the nine cells around: on a steep surface the depth changes by more than
 * any slack from one cell to the next. */
int taut_depth_hides(const taut_depth *depth, const double at[3], double slack);

#endif /* TAUT_DRAW_DEPTH_H */
