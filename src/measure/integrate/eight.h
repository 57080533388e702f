/* eight.h -- first derivatives over eight neighbouring cells of a row, side by side: what integrals of
 * polynomial surfaces spend their time on.
 *
 * A lane is a cell, whose numbers are those of cell.c and integrals.c, operation by operation: the
 * kernels of all instruction sets, and the cells one by one, give the same bits.
 */
#ifndef TAUT_MEASURE_INTEGRATE_EIGHT_H
#define TAUT_MEASURE_INTEGRATE_EIGHT_H

#include "measure/integrate/job.h"

enum {
    TAUT_EIGHT = 8,       /* lanes */
    TAUT_EIGHT_FIELDS = 4 /* W; (r E - G/r)^2 + 4 F^2; E; G */
};

typedef struct taut_eight_sums {
    double of[TAUT_EIGHT_FIELDS][TAUT_EIGHT];
    double least[TAUT_EIGHT], most[TAUT_EIGHT]; /* W^2 over the nodes */
} taut_eight_sums;

typedef struct taut_eight_ops {
    const char *name;
    /* net[points][3][8] = (net - net[0]) factor, sizes[3][8] the largest |coordinates| of it. */
    void (*centre)(int points, double factor, double *net, double *sizes);
    /* Sums over the nodes of u (as of any cell) and v (values [count][2][local v][8], weights
     * [count][8]); polygons [2][local v][3][8] is scratch. */
    void (*sum)(const int local[2], const double *net, double ratio, const taut_nodes *u,
                const taut_nodes *v, double *polygons, taut_eight_sums *sums);
} taut_eight_ops;

/* As taut_grid_ops_chosen. */
const taut_eight_ops *taut_eight_ops_chosen(void);

extern const taut_eight_ops taut_eight_baseline;
#if defined(__x86_64__)
extern const taut_eight_ops taut_eight_avx2;
extern const taut_eight_ops taut_eight_avx512;
#endif

/* Scratch of one worker, in its job's arena. */
typedef struct taut_eight_work {
    const taut_eight_ops *ops;
    double *net, *polygons, *window;
    taut_nodes v[2];               /* [level], lanes side by side */
    double largest[2][TAUT_EIGHT]; /* nodes.largest of level 1, lane by lane: values, slopes */
    int first[TAUT_EIGHT], count;  /* of the cells at hand: the first function of v; cells */
    double width[TAUT_EIGHT];      /* of v, scaled */
} taut_eight_work;

void taut_eight_init(const taut_job *job, taut_eight_work *work);

/* Takes cells from .. from + count - 1 of v, count 1 .. 8, whose nodes [level][cell of the block] are
 * nodes[level] + from - block. */
void taut_eight_take(const taut_job *job, const taut_nodes *const nodes[2], int from, int count,
                     taut_eight_work *work);

/* Tries these cells in row i of cells of u, whose nodes are u[level]: value and error as of
 * taut_cell_try, and is_good[lane] 0 where more nodes or a closer look are needed. */
void taut_eight_try(const taut_job *job, int i, const taut_nodes *const u[2], taut_eight_work *work,
                    double value[TAUT_EIGHT][TAUT_FIELDS_MAX],
                    double error[TAUT_EIGHT][TAUT_FIELDS_MAX], int is_good[TAUT_EIGHT]);

#endif /* TAUT_MEASURE_INTEGRATE_EIGHT_H */
