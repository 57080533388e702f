/* lines.h -- one direction of a grid, cut into groups of points for the kernels. */
#ifndef TAUT_GEOMETRY_GRID_LINES_H
#define TAUT_GEOMETRY_GRID_LINES_H

#include "geometry/grid/kernel.h"
#include "geometry/grid/table.h"

/* Consecutive points whose columns of the net are contracted together. */
typedef struct taut_grid_block {
    int start, points; /* of the line */
    int group, count;  /* of the groups; their `first` counts from low */
    int low, high;     /* columns of the net that are needed */
    int single;        /* each group is one point, repeated */
} taut_grid_block;

typedef struct taut_grid_lines {
    int size; /* of a group */
    int block_count;
    taut_grid_block *blocks;
    taut_grid_group *groups;
    double *basis;
} taut_grid_lines;

enum {
    TAUT_GRID_BLOCK = 256, /* points in a block of groups */
    TAUT_GRID_BLOCK_MAX =
        TAUT_GRID_GROUP_MAX * TAUT_GRID_GROUP_MAX /* room for any block's groups */
};

/* Groups are the same for any number of threads. TAUT_NO_MEMORY leaves *lines empty. */
taut_status taut_grid_lines_make(const taut_table *table, int group_size, taut_grid_lines *lines);
void taut_grid_lines_clear(taut_grid_lines *lines);

#endif /* TAUT_GEOMETRY_GRID_LINES_H */
