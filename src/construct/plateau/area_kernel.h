/* area_kernel.h -- the inner loops of the area functional, one table per instruction set.
 *
 * Points of one cell see the same functions of v, so they are worked on side by side: `group` of
 * them, the last ones no points at all, with zeros for functions and weights. Nets lie in planes,
 * one per coordinate, `stride` apart.
 */
#ifndef TAUT_CONSTRUCT_PLATEAU_AREA_KERNEL_H
#define TAUT_CONSTRUCT_PLATEAU_AREA_KERNEL_H

#include <stddef.h>

enum {
    TAUT_AREA_GROUP_MAX = 256, /* TAUT_GAUSS_MAX, a multiple of TAUT_AREA_PAD */
    TAUT_AREA_STATE = 7,       /* n, w_g E / W, w_g F / W, w_g G / W, w_g */
    TAUT_AREA_BLOCK = 10,      /* of the Hessian: s n n^T in six numbers, t n in three, s */
    TAUT_AREA_PAD = 8          /* numbers beyond a plane that kernels may read and add 0 to */
};

/* The points of a line u = const in one cell of v. */
typedef struct taut_area_cell {
    int nodes, group; /* points; the same rounded up to lanes */
    int local, wide;  /* functions alive; the same rounded up */
    size_t stride;
    const double *value, *slope;     /* [local][group] */
    const double *values, *slopes;   /* [nodes][wide]: the same by node */
    const double *still, *along;     /* [3] planes from the first point alive: x, x_u on the line */
    const double *quotient;          /* [3][group]: 1 / w, w_u / w, w_v / w; or NULL */
    double *spread_still, *spread_u; /* [3] planes: what goes back with N_i, with N_i' */
} taut_area_cell;

/* Points of a cell whose parts of the Hessian are added up (construct/plateau/hessian_band.h). Of
 * each function alive at a point: p_u, p_v, w_g (G p_u - F p_v) / W, w_g (E p_v - F p_u) / W. */
typedef struct taut_area_pairs {
    int nodes, local, wide;                            /* wide: local rounded up */
    int begins;                                        /* the element is not yet anything */
    const double *slope_u, *slope_v, *flux_u, *flux_v; /* [nodes][wide] */
    const double
        *normal; /* [nodes][TAUT_AREA_BLOCK - 1]: n n^T, row by row to the diagonal; w_g n */
} taut_area_pairs;

typedef struct taut_area_ops {
    const char *name;
    int lanes; /* a power of two up to TAUT_AREA_PAD */
    /* still = sum_a n[a] row[a], along = sum_a d[a] row[a]; length a multiple of TAUT_AREA_PAD. */
    void (*contract)(int local, const double *n, const double *d, const double *rows, size_t length,
                     double *still, double *along);
    /* row[a] += n[a] still + d[a] along. */
    void (*spread)(int local, const double *n, const double *d, const double *still,
                   const double *along, size_t length, double *rows);
    /* w[group] = W. */
    void (*area)(const taut_area_cell *cell, double *w);
    /* The same, and the state [TAUT_AREA_STATE][group], and the gradient into the spread; weights
     * [group]. */
    void (*gradient)(const taut_area_cell *cell, const double *weights, double *state, double *w);
    /* The product of the direction in the polygons with the operator of the state and theta. */
    void (*product)(const taut_area_cell *cell, double theta, const double *state);
    /* element[local][TAUT_AREA_BLOCK][wide] += (or =, where it begins) the blocks of functions p and q, for q <= p and what
     * vectors add beyond. */
    void (*pairs)(const taut_area_pairs *points, double *element);
} taut_area_ops;

/* As taut_grid_ops_chosen. */
const taut_area_ops *taut_area_ops_chosen(void);

extern const taut_area_ops taut_area_baseline;
#if defined(__x86_64__)
extern const taut_area_ops taut_area_avx2;
extern const taut_area_ops taut_area_avx512;
#endif

#endif /* TAUT_CONSTRUCT_PLATEAU_AREA_KERNEL_H */
