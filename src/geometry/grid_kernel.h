/* grid_kernel.h -- the inner loops of grid evaluation, one table per instruction set.
 *
 * A block is a run of consecutive v parameters in one row of the grid. Its values are first made
 * component by component ("planes": double plane[component][TAUT_GRID_STRIDE]), which is how
 * they vectorise, then interleaved into the caller's array.
 */
#ifndef TAUT_GEOMETRY_GRID_KERNEL_H
#define TAUT_GEOMETRY_GRID_KERNEL_H

#include <stddef.h>

enum {
    TAUT_GRID_BLOCK = 128,  /* points in a block */
    TAUT_GRID_STRIDE = 144, /* a plane: a block and what a last vector may overrun */
    TAUT_GRID_PAD = 16      /* numbers past the end of a basis plane that must be readable */
};

/* A run of points in one span: plane[c][from..to) from one polygon. */
typedef struct taut_grid_run {
    int from, to; /* within the block */
    int first;    /* the first polygon point alive, counted from the polygon's start */
} taut_grid_run;

typedef struct taut_grid_ops {
    const char *name;
    /* out[c][j] = sum_b basis[b][j] polygon[(first + b) dim + c], c = 0..dim-1, over the points of
     * the run; up to TAUT_GRID_PAD further points may be overwritten. basis[b] starts at
     * basis + b basis_stride. */
    void (*accumulate)(const taut_grid_run *run, int local, int dim, const double *basis,
                       size_t basis_stride, const double *polygon, double *out);
    /* polygon[c] = sum_a n[a] row[a][c], c = 0..length-1; rows are row_stride apart. */
    void (*contract)(int local, const double *n, const double *rows, size_t row_stride,
                     size_t length, double *polygon);
    /* The quotient rule in place: planes 4k + c hold (wx, wy, wz, w) of vector k on entry, planes
     * 4k + c, c < 3, the derivatives of x on return. */
    void (*project)(int order, int count, double *planes);
    /* values[j][k][c] = plane[k dim + c][j], c < 3; streaming: past the caches where aligned. */
    void (*interleave)(int vectors, int dim, int count, const double *planes, int streaming,
                       double *values);
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
