/* peer.h -- the same task for each library: a rational bicubic surface on a grid. */
#ifndef TAUT_BENCH_PEER_H
#define TAUT_BENCH_PEER_H

#ifdef __cplusplus
extern "C" {
#endif

typedef struct peer_task {
    int n;                 /* control points per direction */
    const double *knots;   /* [n + 4], both directions */
    const double *points;  /* [n][n][3] */
    const double *weights; /* [n][n] */
    int grid;              /* parameters per direction */
    const double *t;       /* [grid] */
} peer_task;

/* Each evaluates the whole grid and writes values[i][j][vectors][3] in taut's order of vectors;
 * returns the CPU seconds of the evaluation alone (a library's own output layout is converted
 * outside the clock). order 0 or 2. Negative: it failed. */
double peer_sisl_grid(const peer_task *task, int order, double *values);  /* s1506 */
double peer_sisl_point(const peer_task *task, int order, double *values); /* s1421, with its hint */
double peer_occt_cached(const peer_task *task, int order, double *values); /* GeomAdaptor_Surface */

#ifdef __cplusplus
}
#endif
#endif /* TAUT_BENCH_PEER_H */
