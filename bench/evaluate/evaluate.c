/* evaluate.c -- grid and point evaluation beside SISL and OpenCASCADE, in one run.
 *
 * One rational bicubic surface of 20 x 20 points, 1000 x 1000 parameters, one thread each;
 * position, and position with first and second derivatives. Rounds are interleaved and the best of
 * each is kept; grids, which take a few milliseconds, alternate six times in each round. Every
 * result is compared with taut's. Prints a table, or JSON with --json.
 */
#include "machine.h"
#include "peer.h"

#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { N = 20, ROUNDS = 5, ROWS = 6, GRIDS = 6 };

typedef struct row {
    const char *name;
    double seconds[2];    /* position; with derivatives: CPU, best */
    double difference[2]; /* from taut's grid, relative to the largest number */
} row;

static taut_surface *make(const peer_task *task)
{
    const taut_basis_spec spec = {
        .type = "bspline", .degree = 3, .knots = task->knots, .knot_count = N + 4};
    taut_basis *basis = NULL;
    taut_surface *surface = NULL;
    if (taut_basis_new(&spec, N, &basis, NULL) != TAUT_OK ||
        taut_surface_new("", basis, basis, task->points, task->weights, &surface, NULL) !=
            TAUT_OK) {
        exit(6);
    }
    taut_basis_free(basis);
    return surface;
}

static double taut_grid(const taut_surface *surface, const peer_task *task, int order, int threads,
                        double *values, double *wall)
{
    const double start = bench_cpu_seconds(), start_wall = bench_wall_seconds();
    if (taut_surface_eval_grid(surface, task->grid, task->t, task->grid, task->t, order, threads,
                               values) != TAUT_OK) {
        exit(6);
    }
    *wall = bench_wall_seconds() - start_wall;
    return bench_cpu_seconds() - start;
}

static double taut_point(const taut_surface *surface, const peer_task *task, int order,
                         double *values)
{
    const int vectors = TAUT_SURFACE_VECTORS(order);
    const double start = bench_cpu_seconds();
    for (int i = 0; i < task->grid; i++) {
        for (int j = 0; j < task->grid; j++) {
            taut_surface_eval(surface, task->t[i], task->t[j], order,
                              values + ((long)i * task->grid + j) * vectors * 3);
        }
    }
    return bench_cpu_seconds() - start;
}

/* The same places as one list of pairs. */
static double taut_places(const taut_surface *surface, const peer_task *task, int order,
                          double *values)
{
    static double u[1000000], v[1000000];
    const int count = task->grid * task->grid;
    for (int i = 0; i < count; i++) {
        u[i] = task->t[i / task->grid];
        v[i] = task->t[i % task->grid];
    }
    const double start = bench_cpu_seconds();
    taut_surface_eval_points(surface, count, u, v, order, 1, values);
    return bench_cpu_seconds() - start;
}

static double difference(const double *a, const double *b, size_t count)
{
    double most = 0, size = 0;
    for (size_t i = 0; i < count; i++) {
        most = fmax(most, fabs(a[i] - b[i]));
        size = fmax(size, fabs(a[i]));
    }
    return most / size;
}

static void fill_task(peer_task *task)
{
    static double knots[N + 4], points[N * N * 3], weights[N * N], t[1000];
    for (int i = 0; i < N + 4; i++) {
        knots[i] = i < 4 ? 0 : i >= N ? 1 : (i - 3) / (double)(N - 3);
    }
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            points[3 * (i * N + j)] = i;
            points[3 * (i * N + j) + 1] = j;
            points[3 * (i * N + j) + 2] = sin(0.7 * i) * cos(0.9 * j);
            weights[i * N + j] = 1 + 0.3 * sin(i + 2.0 * j);
        }
    }
    for (int i = 0; i < 1000; i++) {
        t[i] = i / 999.0;
    }
    *task = (peer_task){N, knots, points, weights, 1000, t};
}

static void keep(row *r, int o, double took, const double *ours, const double *values, size_t count)
{
    if (took >= 0 && (r->seconds[o] <= 0 || took < r->seconds[o])) {
        r->seconds[o] = took;
    }
    r->difference[o] = difference(ours, values, count);
}

int main(int argc, char **argv)
{
    const int json = argc > 1 && strcmp(argv[1], "--json") == 0;
    row rows[ROWS] = {{.name = "taut grid"},
                      {.name = "taut point by point"},
                      {.name = "SISL s1506 grid"},
                      {.name = "SISL s1421 point by point, with hint"},
                      {.name = "OpenCASCADE GeomAdaptor, span cache"},
                      {.name = "taut list of places"}};
    double two_threads = 1e30, one_thread = 1e30, wall = 0;
    peer_task task;
    fill_task(&task);
    const size_t points = (size_t)task.grid * (size_t)task.grid;
    double *ours = aligned_alloc(64, points * 18 * sizeof(double));
    double *theirs = aligned_alloc(64, points * 18 * sizeof(double));
    taut_surface *surface = make(&task);
    memset(ours, 0, points * 18 * sizeof(double));
    memset(theirs, 0, points * 18 * sizeof(double));
    const double store = bench_store_rate(theirs, points * 18 * sizeof(double));

    for (int round = 0; round < ROUNDS; round++) {
        for (int o = 0; o < 2; o++) {
            const int order = 2 * o;
            const size_t count = points * (size_t)TAUT_SURFACE_VECTORS(order) * 3;
            for (int again = 0; again < GRIDS; again++) {
                keep(&rows[0], o, taut_grid(surface, &task, order, 1, ours, &wall), ours, ours,
                     count);
                one_thread = order == 2 ? fmin(one_thread, wall) : one_thread;
                keep(&rows[2], o, peer_sisl_grid(&task, order, theirs), ours, theirs, count);
            }
            for (int again = 0; order == 2 && again < GRIDS; again++) {
                taut_grid(surface, &task, order, 2, ours, &wall);
                two_threads = fmin(two_threads, wall);
            }
            keep(&rows[1], o, taut_point(surface, &task, order, theirs), ours, theirs, count);
            keep(&rows[3], o, peer_sisl_point(&task, order, theirs), ours, theirs, count);
            keep(&rows[5], o, taut_places(surface, &task, order, theirs), ours, theirs, count);
            keep(&rows[4], o, peer_occt_cached(&task, order, theirs), ours, theirs, count);
        }
    }
    if (json) {
        printf("{ \"processor\": \"%s\", \"store_rate\": %.4g, \"fma_rate\": %.4g, "
               "\"two_threads\": %.3g,\n  \"rows\": [",
               bench_processor(), store, bench_fma_rate(), one_thread / two_threads);
    } else {
        printf("%s, one thread, CPU time, best of %d\n%-38s %10s %10s %12s %12s %9s\n",
               bench_processor(), ROUNDS, "", "pos Mpt/s", "D2 Mpt/s", "taut/it pos", "taut/it D2",
               "differs");
    }
    for (int r = 0; r < ROWS; r++) {
        const double mega = (double)points * 1e-6;
        if (json) {
            printf("%s\n    { \"name\": \"%s\", \"position\": %.5g, \"second\": %.5g }",
                   r > 0 ? "," : "", rows[r].name, mega / rows[r].seconds[0],
                   mega / rows[r].seconds[1]);
        } else {
            printf("%-38s %10.2f %10.2f %12.2f %12.2f %9.1e\n", rows[r].name,
                   mega / rows[r].seconds[0], mega / rows[r].seconds[1],
                   rows[r].seconds[0] / rows[0].seconds[0], rows[r].seconds[1] / rows[0].seconds[1],
                   fmax(rows[r].difference[0], rows[r].difference[1]));
        }
    }
    if (json) {
        printf("\n  ] }\n");
    } else {
        printf("%-38s %10.2f %10.2f %12.2f %12.2f\n", "writing the result (streamed stores)",
               store / 24e6, store / 144e6,
               rows[0].seconds[0] > 0 ? 24e6 / store / rows[0].seconds[0] : 0,
               144e6 / store / rows[0].seconds[1]);
        printf("two threads against one, D2, wall: %.2f;  store rate %.1f GB/s, FMA peak %.1f "
               "GFLOP/s\n",
               one_thread / two_threads, store * 1e-9, bench_fma_rate() * 1e-9);
    }
    taut_surface_free(surface);
    free(ours);
    free(theirs);
    return 0;
}
