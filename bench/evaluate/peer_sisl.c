/* peer_sisl.c -- SISL: the grid routine s1506 and the point routine s1421. */
#include "machine.h"
#include "peer.h"

#include <sisl.h>
#include <stdlib.h>
#include <string.h>

/* SISL wants homogeneous points with the first direction fastest. */
static SISLSurf *surface(const peer_task *task)
{
    const int n = task->n;
    double *net = malloc((size_t)(n * n * 4) * sizeof(double));
    SISLSurf *made = NULL;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            const double w = task->weights[i * n + j];
            for (int c = 0; c < 3; c++) {
                net[4 * (j * n + i) + c] = w * task->points[3 * (i * n + j) + c];
            }
            net[4 * (j * n + i) + 3] = w;
        }
    }
    made = newSurf(n, n, 4, 4, (double *)(size_t)task->knots, (double *)(size_t)task->knots, net, 2,
                   3, 1);
    free(net);
    return made;
}

/* s1506 lays points out with the first direction fastest, derivatives as x, xu, xv, xuu, xuv, xvv.
 */
double peer_sisl_grid(const peer_task *task, int order, double *values)
{
    const int g = task->grid, vectors = (order + 1) * (order + 2) / 2;
    const size_t numbers = (size_t)g * (size_t)g * 3;
    double *out = malloc(numbers * (size_t)vectors * sizeof(double));
    double *normals = malloc(numbers * sizeof(double));
    SISLSurf *s = surface(task);
    int status = 0;
    double took = 0;

    memset(out, 0, numbers * (size_t)vectors * sizeof(double));
    memset(normals, 0, numbers * sizeof(double));
    took = bench_cpu_seconds();
    s1506(s, order, g, (double *)(size_t)task->t, g, (double *)(size_t)task->t, out, normals,
          &status);
    took = bench_cpu_seconds() - took;
    for (int i = 0; i < g; i++) {
        for (int j = 0; j < g; j++) {
            memcpy(values + ((size_t)i * (size_t)g + (size_t)j) * (size_t)(vectors * 3),
                   out + ((size_t)j * (size_t)g + (size_t)i) * (size_t)(vectors * 3),
                   (size_t)(vectors * 3) * sizeof(double));
        }
    }
    freeSurf(s);
    free(out);
    free(normals);
    return status < 0 ? -1 : took;
}

/* s1421 gives derivatives in the order x, xu, xv, xuu, xuv, xvv too. */
double peer_sisl_point(const peer_task *task, int order, double *values)
{
    const int g = task->grid, vectors = (order + 1) * (order + 2) / 2;
    SISLSurf *s = surface(task);
    double derive[27], normal[3], at[2];
    int left1 = 0, left2 = 0, status = 0;
    double took = bench_cpu_seconds();

    for (int i = 0; i < g; i++) {
        for (int j = 0; j < g; j++) {
            at[0] = task->t[i];
            at[1] = task->t[j];
            s1421(s, order, at, &left1, &left2, derive, normal, &status);
            memcpy(values + ((size_t)i * (size_t)g + (size_t)j) * (size_t)(vectors * 3), derive,
                   (size_t)(vectors * 3) * sizeof(double));
        }
    }
    took = bench_cpu_seconds() - took;
    freeSurf(s);
    return status < 0 ? -1 : took;
}
