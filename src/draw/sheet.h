/* sheet.h -- what is drawn of one surface: a grid of points and a value in each cell. */
#ifndef TAUT_DRAW_SHEET_H
#define TAUT_DRAW_SHEET_H

#include "core/arena.h"
#include "taut/surface.h"
#include "taut/write.h"

/* The grid lines in one direction: every break of the basis is one, until there are too many. */
typedef struct taut_lines {
    int count;              /* lines; cells are one fewer */
    double *at;             /* [count] parameters */
    double *middle;         /* [count - 1] parameters between them */
    unsigned char *is_knot; /* [count]: an inner break to be shown */
} taut_lines;

typedef struct taut_sheet {
    const taut_surface *surface;
    taut_lines u, v;
    double *points; /* [u.count][v.count][3]; not finite where the surface overflows */
    double *values; /* [u.count-1][v.count-1] H or K, NaN where there is none; NULL when plain */
} taut_sheet;

/* Samples a surface into about `cells` cells, or into `divide` by `divide` cells a knot span when
 * divide > 0 (fewer when that would be more than `most`). */
taut_status taut_sheet_new(const taut_surface *surface, int cells, int most,
                           const taut_write_options *options, taut_arena *arena, taut_sheet *sheet);

#endif /* TAUT_DRAW_SHEET_H */
