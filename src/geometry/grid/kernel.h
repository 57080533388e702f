/* kernel.h -- the inner loops of grid evaluation, one table per instruction set.
 *
 * A group is a few consecutive v parameters, as many as a kernel works on side by side. Its sums
 * run over all basis functions that any of its points has, with zeros where a point has not.
 */
#ifndef TAUT_GEOMETRY_GRID_KERNEL_H
#define TAUT_GEOMETRY_GRID_KERNEL_H

#include <stddef.h>

enum { TAUT_GRID_GROUP_MAX = 16 };

typedef struct taut_grid_group {
    int first, local;    /* the polygon points alive somewhere in the group */
    const double *basis; /* [order + 1][local][group]: functions and derivatives, point by point */
} taut_grid_group;

typedef struct taut_grid_ops {
    const char *name;
    int group; /* points in a group, at most TAUT_GRID_GROUP_MAX */
    /* polygon[c] = sum_a n[a] row[a][c], c = 0..length-1; rows are row_stride apart. */
    void (*contract)(int local, const double *n, const double *rows, size_t row_stride,
                     size_t length, double *polygon);
    /* The points of all groups, whole groups always: sums over the polygons (one for each
     * derivative of u, polygon_stride apart), quotient rule where dim is 4, and
     * out[j][vector][3]; streaming: past the caches, out must be aligned to 32 bytes. */
    void (*fill)(int order, int dim, int streaming, const taut_grid_group *groups, int count,
                 const double *polygons, size_t polygon_stride, double *out);
    /* Copies past the caches, wherever `to` lies. */
    void (*copy)(size_t count, const double *from, double *to);
    /* Makes streamed stores visible to other threads. */
    void (*fence)(void);
} taut_grid_ops;

/* The table in use on this machine, or the one that TAUT_KERNEL in the environment names
 * (baseline, avx2, avx512). */
const taut_grid_ops *taut_grid_ops_chosen(void);

extern const taut_grid_ops taut_grid_baseline;
#if defined(__x86_64__)
extern const taut_grid_ops taut_grid_avx2;
extern const taut_grid_ops taut_grid_avx512;
#endif

#endif /* TAUT_GEOMETRY_GRID_KERNEL_H */
