/* bend.h -- how sharply an arc turns: extremes and integrals. */
#ifndef TAUT_PIPE_BEND_H
#define TAUT_PIPE_BEND_H

#include "construct/pipe/arc.h"

typedef struct taut_pipe_bend {
    double least_speed; /* over the largest control vector of P'; 0 where that is 0 */
    double least_speed_at;
    double curvature; /* the largest, ends included */
    double curvature_at;
    double length, turning, bending; /* integrals of 1, curvature, its square along the arc */
} taut_pipe_bend;

/* Is the arc a cusp there: |P'| below 1e-12 of its control vectors? A thousand times the rounding
 * of P', and far below any speed that leaves a curvature a pipe could follow. */
int taut_pipe_bend_is_cusp(const taut_pipe_bend *bend);

/* What an arc is no longer looked at for: a curvature of `curvature`, or `factor` times it of `room`; NULL where one is
 * asked for: no stop. `at`: where it was reached last times, the last first: it is looked for there first. */
enum { TAUT_PIPE_BEND_STOPS = 4 };
typedef struct taut_pipe_bend_stop {
    double curvature, factor, room;
    int count;
    double at[TAUT_PIPE_BEND_STOPS];
} taut_pipe_bend_stop;

/* Least speed and largest curvature: samples, and the roots of the derivatives between them. */
void taut_pipe_bend_extremes(const taut_pipe_arc *arc, int samples, taut_pipe_bend *bend);
/* The same; 0, and nothing in bend means anything, as soon as the stop is reached. */
int taut_pipe_bend_extremes_below(const taut_pipe_arc *arc, int samples, taut_pipe_bend_stop *stop,
                                  taut_pipe_bend *bend);
/* The Gauss points of one interval: weights with dt/ds, and the values of the Bernstein functions of P' and of P' x P'' there. */
enum { TAUT_PIPE_GAUSS = 16 };
typedef struct taut_pipe_nodes {
    double weight[TAUT_PIPE_GAUSS];
    double velocity[TAUT_PIPE_DEGREE_MAX][TAUT_PIPE_GAUSS];
    double cross[2 * TAUT_PIPE_DEGREE_MAX - 3][TAUT_PIPE_GAUSS];
} taut_pipe_nodes;

/* Of all arcs of a degree: nodes[intervals]. */
void taut_pipe_nodes_fill(int degree, int intervals, taut_pipe_nodes *nodes);

/* The integrals, by equal `intervals` of 16 Gauss points: to 1e-10 with 16 of them on arcs without
 * sharp peaks ([WangBai2018] section 9). */
void taut_pipe_bend_integrals(const taut_pipe_arc *arc, int intervals, taut_pipe_bend *bend);
/* The same with nodes of the arc's degree; 0, and nothing in bend means anything, as soon as what is there of bending, or of length
 * times bending where that counts, is as much as `most`. */
int taut_pipe_bend_integrals_below(const taut_pipe_arc *arc, int intervals,
                                   const taut_pipe_nodes *nodes, int by_length, double most,
                                   taut_pipe_bend *bend);

#endif /* TAUT_PIPE_BEND_H */
