/* task.h -- the Dirichlet problem that peers are given: bicubic, n x n unknown points, uniform knots,
 * a wavy frame over the unit square. */
#ifndef TAUT_BENCH_DIRICHLET_TASK_H
#define TAUT_BENCH_DIRICHLET_TASK_H

#include "peer.h"

#include <stddef.h>

/* Zeroed; ends the program where there is no memory. */
double *bench_numbers(size_t count);
/* Control point (i, j) of the frame of a net of m x m. */
void bench_frame_point(int m, int i, int j, double point[3]);
peer_task bench_task_new(int n);
void bench_task_free(peer_task *task);

#endif /* TAUT_BENCH_DIRICHLET_TASK_H */
