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

/* Least speed and largest curvature: samples, and the roots of the derivatives between them. */
void taut_pipe_bend_extremes(const taut_pipe_arc *arc, int samples, taut_pipe_bend *bend);
/* The integrals, by equal `intervals` of 16 Gauss points: to 1e-10 with 16 of them on arcs without
 * sharp peaks ([WangBai2018] section 9). */
void taut_pipe_bend_integrals(const taut_pipe_arc *arc, int intervals, taut_pipe_bend *bend);

#endif /* TAUT_PIPE_BEND_H */
