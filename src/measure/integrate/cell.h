/* cell.h -- the derivative vectors at the nodes of one cell, a rectangle within one span by one
 * span, and weighted sums over them.
 *
 * Everything is brought to size 1 by powers of two, which round nothing: points by 2^-scale,
 * parameters by 2^-shift[0], 2^-shift[1]. Points are taken relative to one of the cell's own, so
 * that rounding is that of the cell, not of its distance from the origin.
 */
#ifndef TAUT_MEASURE_INTEGRATE_CELL_H
#define TAUT_MEASURE_INTEGRATE_CELL_H

#include "taut/surface.h"

#include <stddef.h>

enum { TAUT_FIELDS_MAX = 20, TAUT_KEPT_MAX = 4, TAUT_NODES_KEPT = 1024 };

/* What a cell's rounding is judged by: bounds of |x_u|, |x_v|, |x_uu|, |x_uv|, |x_vv| in the order
 * of the vectors, from the size of its net and the sums of |basis functions|; [TAUT_X] is the size
 * itself. */
typedef struct taut_bounds {
    double of[6];
} taut_bounds;

/* The functions to be integrated, at `count` nodes: x[3*k + c][stride] is component c of vector k,
 * out[f][stride]. `ratio` is 2^(shift[1] - shift[0]), what |x_u| / |x_v| is to be multiplied by
 * to be that of the surface's own parameters. */
typedef void taut_fields(int count, int stride, const double *x, const taut_bounds *bounds,
                         double ratio, double *out);

/* A surface made ready. */
typedef struct taut_scaled_surface {
    const taut_basis *basis[2];
    const double *points, *weights;
    int dim;      /* 3, or 4 with weights */
    int local[2]; /* functions alive per direction */
    int scale;
    int shift[2];
} taut_scaled_surface;

void taut_scaled_surface_init(const taut_surface *surface, taut_scaled_surface *scaled);

/* The nodes of a rule in one interval of one span: basis functions to `order`, weights that sum to
 * the length of the interval (scaled). */
typedef struct taut_nodes {
    int count;
    double *values;    /* [count][order+1][local] */
    double *weights;   /* [count] */
    double largest[3]; /* over the nodes, of sum_a |N_a^(k)| */
} taut_nodes;

void taut_nodes_fill(const taut_scaled_surface *scaled, int direction, int span, double lo,
                     double hi, int order, int count, const double *rule_nodes,
                     const double *rule_weights, taut_nodes *nodes);

/* Scratch of one worker. */
typedef struct taut_cell_work {
    double *net;      /* [local u][local v][dim] of the cell at hand */
    double *polygons; /* [order+1][local v][dim] */
    double *field;    /* [6][3][stride] (with weights [6][4] until they are divided out) */
    double *out;      /* [TAUT_FIELDS_MAX][stride] */
    double *kept[TAUT_KEPT_MAX]; /* [TAUT_NODES_KEPT] each */
    int stride;                  /* nodes handled at a time */
    double size;                 /* of the cell's net, largest distance of a coordinate */
} taut_cell_work;

/* `row` is the largest number of nodes in v. 0 when memory runs out; free in any case. */
int taut_cell_work_init(const taut_scaled_surface *scaled, int row, taut_cell_work *work);
void taut_cell_work_free(taut_cell_work *work);

/* Takes the net of spans su, sv into the work. */
void taut_cell_load(const taut_scaled_surface *scaled, int su, int sv, taut_cell_work *work);

/* sums[f] = sum over the nodes of weight times out[f], f < field_count. The `kept` fields that
 * follow them go to work->kept[k], row by row, if there are no more than TAUT_NODES_KEPT nodes.
 * order is 1 or 2. */
void taut_cell_sum(const taut_scaled_surface *scaled, const taut_nodes *u, const taut_nodes *v,
                   int order, taut_fields *fields, int field_count, int kept, taut_cell_work *work,
                   double *sums);

/* The same fields at the nodes of row i, kept in work: vectors in field, fields in out. */
void taut_cell_row(const taut_scaled_surface *scaled, const taut_nodes *u, int i,
                   const taut_nodes *v, int order, taut_fields *fields, taut_cell_work *work);

#endif /* TAUT_MEASURE_INTEGRATE_CELL_H */
