/* depth.h -- how near the surfaces are at each point of the page, to tell what they hide.
 *
 * Two views of the same triangles: a grid of one page unit, whose cells know the nearest of them at their middle, and
 * the triangles by tiles of the page, for what a ray through a point itself meets.
 */
#ifndef TAUT_DRAW_DEPTH_H
#define TAUT_DRAW_DEPTH_H

#include "core/arena.h"

/* A triangle in the list of one tile. */
typedef struct taut_depth_entry {
    double corners[9];
    const struct taut_depth_entry *next;
} taut_depth_entry;

typedef struct taut_depth {
    int width, height;              /* cells of one page unit */
    float *nearest;                 /* [height][width]: -INFINITY where there is none */
    int columns, rows;              /* of tiles */
    const taut_depth_entry **tiles; /* [rows][columns] */
    taut_arena *arena;
    taut_depth_entry *room; /* for `left` more entries */
    size_t left;
} taut_depth;

/* What it takes is the arena's. 0 when memory runs out. */
int taut_depth_new(int width, int height, taut_arena *arena, taut_depth *depth);
/* Corners (x, y, depth), finite; parts beside the page are passed over. 0 when memory runs out. */
int taut_depth_triangle(taut_depth *depth, const double a[3], const double b[3], const double c[3]);
/* The depth of the cell that holds (x, y), or of the nearest one on the page. */
double taut_depth_at(const taut_depth *depth, double x, double y);
/* Is a finite point behind a surface? Only where rays through it and through four points about it, `reach` away, all
 * meet one that is nearer by more than `slack`: a line on a surface strays from the triangles by what chords do, and
 * where it lies along the end of a surface nothing beside it is hidden. */
int taut_depth_hides(const taut_depth *depth, const double at[3], double reach, double slack);

#endif /* TAUT_DRAW_DEPTH_H */
