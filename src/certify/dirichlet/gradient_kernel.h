/* gradient_kernel.h -- the sums of gradient.c over eight lines u = const at a time, one table per
 * instruction set. A lane is a line; what goes back to a row of the net is summed over the lanes in one order, so
 * that results are the same bit for bit at every width.
 */
#ifndef TAUT_CERTIFY_DIRICHLET_GRADIENT_KERNEL_H
#define TAUT_CERTIFY_DIRICHLET_GRADIENT_KERNEL_H

#include <stddef.h>

enum {
    TAUT_SHEAF = 8,    /* lines side by side */
    TAUT_CHANNELS = 4, /* three coordinates, and the gross */
    TAUT_POLYGONS = 10 /* on a line, a column: wx and its slope; w and its; the gross of both */
};

/* The integrals that are numbers: area, iint |x_u|^2, iint |x_v|^2 over the unit square, and of the
 * last two what rounding acts on, over 2 and the form's factor. */
enum { TAUT_AREA_SUM, TAUT_HALVES, TAUT_HALVES_GROSS = 3, TAUT_GRADIENT_SUMS = 5 };

/* The net, and the Gauss nodes of v; slopes are over the unit interval. */
typedef struct taut_gradient_net {
    int nv, local, nodes, count; /* columns; functions of v alive; nodes a cell; nodes in all */
    int is_area;
    const double *points;  /* [nu][nv][3] */
    const double *weights; /* [nu][nv] or NULL */
    const double *sizes;   /* [nu][nv] */
    const int *first;      /* [count]: of the functions alive */
    const double *values;  /* [count][2][local]: functions and slopes */
    const double *rule;    /* [count]: weights of the nodes */
    const double *roundings;
    double fu, fv, reach_u, reach_v; /* see gradient.c */
} taut_gradient_net;

/* Eight lines; those that are none have the weight 0. */
typedef struct taut_gradient_sheaf {
    int first, alive;               /* functions of u not 0 on one of them */
    const double *n, *slopes;       /* [alive][8] */
    const double *rule, *roundings; /* [8] */
} taut_gradient_sheaf;

typedef struct taut_gradient_ops {
    const char *name;
    /* rows[alive][nv][TAUT_CHANNELS] and sums[TAUT_GRADIENT_SUMS] += the sheaf's. Scratch: as many
     * numbers as taut_gradient_scratch says. */
    void (*add)(const taut_gradient_net *net, const taut_gradient_sheaf *sheaf, double *scratch,
                double *rows, double *sums);
} taut_gradient_ops;

static inline size_t taut_gradient_scratch(int local, int nodes)
{
    const size_t columns = (size_t)local * (TAUT_POLYGONS + 2 * TAUT_CHANNELS);
    return (columns + 3 * TAUT_CHANNELS * (size_t)nodes) * TAUT_SHEAF;
}

/* As taut_grid_ops_chosen. */
const taut_gradient_ops *taut_gradient_ops_chosen(void);

extern const taut_gradient_ops taut_gradient_baseline;
#if defined(__x86_64__)
extern const taut_gradient_ops taut_gradient_avx2;
extern const taut_gradient_ops taut_gradient_avx512;
#endif

#endif /* TAUT_CERTIFY_DIRICHLET_GRADIENT_KERNEL_H */
