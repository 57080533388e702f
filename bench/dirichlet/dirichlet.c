/* dirichlet.c -- the Dirichlet problem on a bicubic surface of n x n unknown points, three
 * coordinates, uniform knots, beside CHOLMOD and dense fast diagonalisation by LAPACK, in one run.
 *
 * Everything counts, from the banded Gram matrices to the points; one thread each; CPU time; rounds
 * are interleaved and the best of each is kept. Residuals ||R - A X|| / ||R|| are taken in twice
 * the working precision. OpenBLAS is told the processor's best kernels, which it does not always
 * find by itself.
 *
 *     bench-dirichlet [--json] [--large] [--huge] [--rounds N]
 *
 * --large adds n = 800 and 1600 without CHOLMOD, --huge adds CHOLMOD to them (13 GiB, minutes).
 */
#include "machine.h"
#include "peer.h"
#include "task.h"

#include "geometry/nurbs/gram.h"
#include "numeric/kernel/kernel.h"
#include "numeric/tensor/apply.h"
#include "numeric/tensor/solver.h"
#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { DEGREE = 3, TAUT = 0, CHOLMOD = 1, LAPACK = 2, METHODS = 3 };

typedef struct options {
    int json, large, huge, rounds;
} options;

typedef struct result {
    int n;
    double seconds[METHODS], residual[METHODS]; /* negative: not run */
    double modes, dense; /* taut: new alone; solve for a right-hand side without zeros */
    double refined;      /* residual after one refinement */
    double make;         /* taut_dirichlet_make */
    double memory;       /* peak beyond input and output, in units of the data */
} result;

static void fail(const char *what)
{
    fprintf(stderr, "bench-dirichlet: %s\n", what);
    exit(6);
}

static void *memory(size_t count)
{
    return bench_numbers(count);
}

static size_t entries(int n)
{
    return 3 * (size_t)n * (size_t)n;
}

/* ---- taut ---- */

static taut_tensor_solver *make_solver(const peer_task *task)
{
    taut_tensor_solver *solver = NULL;
    if (taut_tensor_solver_new(&task->k, &task->m, &task->k, &task->m, 1.0, 1.0, NULL, &solver) !=
        TAUT_OK) {
        fail("no solver");
    }
    return solver;
}

static double run_taut(const peer_task *task, double *x, double *modes)
{
    memcpy(x, task->right, entries(task->n) * sizeof *x);
    const double begun = bench_cpu_seconds();
    taut_tensor_solver *solver = make_solver(task);
    *modes = bench_cpu_seconds() - begun;
    if (taut_tensor_solver_solve(solver, 3, x) != TAUT_OK) {
        fail("no memory");
    }
    taut_tensor_solver_free(solver);
    return bench_cpu_seconds() - begun;
}

/* A solve alone, for a right-hand side without zeros. */
static double run_dense(const peer_task *task, double *x)
{
    taut_tensor_solver *solver = make_solver(task);
    for (size_t i = 0; i < entries(task->n); i++) {
        x[i] = 1.0 + (double)(i % 11);
    }
    const double begun = bench_cpu_seconds();
    if (taut_tensor_solver_solve(solver, 3, x) != TAUT_OK) {
        fail("no memory");
    }
    const double took = bench_cpu_seconds() - begun;
    taut_tensor_solver_free(solver);
    return took;
}

/* The whole of taut_dirichlet_make, checks and residuals included, on n x n unknown points. */
static double run_make(int n)
{
    const int m = n + 2;
    const size_t count = (size_t)m * (size_t)m;
    const taut_basis_spec spec = {.type = "bspline", .degree = DEGREE, .count = m};
    double *points = memory(3 * count), took = 0.0;
    unsigned char *known = calloc(count, 1);
    taut_basis *basis = NULL;
    taut_model *model = NULL;
    if (known == NULL || taut_basis_new(&spec, 0, &basis, NULL) != TAUT_OK) {
        fail("no memory");
    }
    for (int k = 0; k < m * m; k++) {
        const int i = k / m, j = k % m;
        known[k] = i == 0 || j == 0 || i == m - 1 || j == m - 1;
        points[3 * k] = i;
        points[3 * k + 1] = j;
        points[3 * k + 2] = 0.3 * m * sin(9.0 * i / m + 1.0) * cos(7.0 * j / m);
    }
    const taut_dirichlet_problem problem = {
        .u = basis, .v = basis, .points = points, .known = known};
    const double begun = bench_cpu_seconds();
    if (taut_dirichlet_make(&problem, NULL, &model, NULL) != TAUT_OK) {
        fail("not made");
    }
    took = bench_cpu_seconds() - begun;
    taut_model_free(model);
    taut_basis_free(basis);
    free(known);
    free(points);
    return took;
}

static double residual(const peer_task *task, const double *x)
{
    const taut_tensor tensor = {&task->k, &task->m, &task->k, &task->m, 1.0, 1.0, NULL};
    double *r = memory(entries(task->n)), norm = 0.0;
    if (taut_tensor_residual(&tensor, 3, task->right, x, r, &norm) != TAUT_OK) {
        fail("no memory");
    }
    free(r);
    return norm;
}

static double refined(const peer_task *task, double *x)
{
    taut_tensor_solver *solver = make_solver(task);
    if (taut_tensor_solver_refine(solver, 3, task->right, x, NULL) != TAUT_OK) {
        fail("no memory");
    }
    taut_tensor_solver_free(solver);
    return residual(task, x);
}

/* A line "name:  number kB" of /proc/self/status, in bytes. */
static double status_bytes(const char *name)
{
    char line[256];
    double kilobytes = 0.0;
    FILE *file = fopen("/proc/self/status", "r");
    while (file != NULL && fgets(line, sizeof line, file) != NULL) {
        if (strncmp(line, name, strlen(name)) == 0) {
            kilobytes = atof(line + strlen(name) + 1);
        }
    }
    if (file != NULL) {
        fclose(file);
    }
    return 1024.0 * kilobytes;
}

/* In a process of its own: what resident memory gains at its peak while taut solves in place. */
static double run_memory(const peer_task *task)
{
    int ends[2];
    double gained = -1.0, modes = 0.0;
    if (pipe(ends) != 0) {
        return gained;
    }
    const pid_t child = fork();
    if (child == 0) {
        double *x = memory(entries(task->n));
        memcpy(x, task->right, entries(task->n) * sizeof *x);
        const double before = status_bytes("VmRSS");
        FILE *reset = fopen("/proc/self/clear_refs", "w"); /* 5: start the peak over */
        if (reset != NULL) {
            fputs("5", reset);
            fclose(reset);
        }
        run_taut(task, x, &modes);
        gained = (status_bytes("VmHWM") - before) / ((double)entries(task->n) * sizeof *x);
        _exit(write(ends[1], &gained, sizeof gained) == sizeof gained ? 0 : 1);
    }
    close(ends[1]);
    if (child < 0 || read(ends[0], &gained, sizeof gained) != sizeof gained) {
        gained = -1.0;
    }
    close(ends[0]);
    waitpid(child, NULL, 0);
    return gained;
}

/* ---- the run ---- */

static void keep(double *best, double seconds)
{
    *best = *best < 0.0 || seconds < *best ? seconds : *best;
}

static result run(int n, const options *asked)
{
    result r = {.n = n, .modes = -1.0, .dense = -1.0, .make = -1.0};
    peer_task task = bench_task_new(n);
    double *x = memory(entries(n));
    double modes = 0.0;
    r.memory = run_memory(&task);
    for (int m = 0; m < METHODS; m++) {
        r.seconds[m] = r.residual[m] = -1.0;
    }
    /* the small ones often: they vary most and cost nothing */
    const int rounds = n >= 800 ? 1 : asked->rounds, times = n <= 100   ? 20
                                                             : n <= 200 ? 5
                                                             : n <= 800 ? 3
                                                                        : 2;
    for (int round = 0; round < rounds; round++) {
        if (n < 800 || asked->huge) {
            keep(&r.seconds[CHOLMOD], peer_cholmod(&task, x));
            r.residual[CHOLMOD] = residual(&task, x);
        }
        for (int t = 0; t < (times + 1) / 2; t++) {
            keep(&r.seconds[LAPACK], peer_lapack(&task, x));
        }
        r.residual[LAPACK] = residual(&task, x);
        for (int t = 0; t < times; t++) {
            keep(&r.dense, run_dense(&task, x));
            keep(&r.seconds[TAUT], run_taut(&task, x, &modes));
            keep(&r.modes, modes);
            keep(&r.make, run_make(n));
        }
        r.residual[TAUT] = residual(&task, x);
    }
    r.refined = refined(&task, x);
    free(x);
    bench_task_free(&task);
    return r;
}

/* Operations of the dense solve: two products of n x n by n x 3n, halved by the symmetry of uniform
 * knots. */
static double dense_rate(const result *r)
{
    return 6.0 * r->n * r->n * r->n / r->dense;
}

static double ratio(const result *r, int method)
{
    return r->seconds[method] < 0.0 ? -1.0 : r->seconds[method] / r->seconds[TAUT];
}

/* A number of JSON; what was not run is null. */
static const char *json(double x, char room[32])
{
    snprintf(room, 32, x < 0.0 ? "null" : "%.4g", x);
    return room;
}

static void print_json(const result *r, double peak, int is_last)
{
    char room[5][32];
    printf("    { \"n\": %d, \"taut_ms\": %.4g, \"taut_modes_ms\": %.4g, \"cholmod_ms\": %s, "
           "\"lapack_ms\": %.4g,\n"
           "      \"over_cholmod\": %s, \"over_lapack\": %.4g, \"residual\": %.3g, "
           "\"residual_refined\": %.3g,\n"
           "      \"residual_cholmod\": %s, \"residual_lapack\": %s, \"memory\": %s, "
           "\"dense_ms\": %.4g,\n"
           "      \"make_ms\": %.4g, \"dense_share_of_peak\": %.3g }%s\n",
           r->n, 1e3 * r->seconds[TAUT], 1e3 * r->modes, json(1e3 * r->seconds[CHOLMOD], room[0]),
           1e3 * r->seconds[LAPACK], json(ratio(r, CHOLMOD), room[1]), ratio(r, LAPACK),
           r->residual[TAUT], r->refined, json(r->residual[CHOLMOD], room[2]),
           json(r->residual[LAPACK], room[3]), json(r->memory, room[4]), 1e3 * r->dense,
           1e3 * r->make, dense_rate(r) / peak, is_last ? "" : ",");
}

static void print_row(const result *r, double peak)
{
    char cholmod[2][32] = {"-", "-"};
    if (r->seconds[CHOLMOD] >= 0.0) {
        snprintf(cholmod[0], sizeof cholmod[0], "%.1f", 1e3 * r->seconds[CHOLMOD]);
        snprintf(cholmod[1], sizeof cholmod[1], "%.0fx", ratio(r, CHOLMOD));
    }
    printf("%5d %9.3f %9.3f %10s %9.2f %8s %7.1fx  %8.1e %8.1e %8.1e %8.1e %7.2f %9.2f %5.0f%% "
           "%9.2f\n",
           r->n, 1e3 * r->seconds[TAUT], 1e3 * r->modes, cholmod[0], 1e3 * r->seconds[LAPACK],
           cholmod[1], ratio(r, LAPACK), r->residual[TAUT], r->refined, r->residual[CHOLMOD],
           r->residual[LAPACK], r->memory, 1e3 * r->dense, 100.0 * dense_rate(r) / peak,
           1e3 * r->make);
    fflush(stdout);
}

/* Starts over with OpenBLAS told what to use, unless someone already did. */
static void choose_blas(char **argv)
{
    if (getenv("OPENBLAS_CORETYPE") != NULL && getenv("OPENBLAS_NUM_THREADS") != NULL) {
        return;
    }
#if defined(__x86_64__)
    const char *core = __builtin_cpu_supports("avx512f") ? "SkylakeX"
                       : __builtin_cpu_is("amd")         ? "Zen"
                                                         : "Haswell";
    setenv("OPENBLAS_CORETYPE", core, __builtin_cpu_supports("avx2") ? 0 : 1);
#else
    setenv("OPENBLAS_CORETYPE", "", 0);
#endif
    setenv("OPENBLAS_NUM_THREADS", "1", 1);
    execv("/proc/self/exe", argv);
}

int main(int argc, char **argv)
{
    static const int sizes[] = {50, 100, 200, 400, 800, 1600};
    options asked = {.rounds = 3};
    choose_blas(argv);
    for (int i = 1; i < argc; i++) {
        asked.json |= strcmp(argv[i], "--json") == 0;
        asked.huge |= strcmp(argv[i], "--huge") == 0;
        asked.large |= strcmp(argv[i], "--large") == 0 || strcmp(argv[i], "--huge") == 0;
        if (strcmp(argv[i], "--rounds") == 0 && i + 1 < argc) {
            asked.rounds = atoi(argv[++i]);
        }
    }
    const double peak = bench_fma_rate(), gemm = peer_gemm_rate(1000);
    if (asked.json) {
        printf("{ \"processor\": \"%s\", \"kernel\": \"%s\", \"blas\": \"%s\", \"threads\": 1,\n"
               "  \"fma_rate\": %.4g, \"dgemm_rate\": %.4g,\n  \"rows\": [\n",
               bench_processor(), taut_kernel_name(), peer_blas_core(), peak, gemm);
    } else {
        printf("%s, one thread, CPU time, best of %d rounds; taut's kernels: %s; OpenBLAS's: %s\n"
               "fused multiply-add peak %.1f Gflop/s, dgemm 1000^3 %.1f Gflop/s\n\n"
               "%5s %9s %9s %10s %9s %8s %8s  %8s %8s %8s %8s %7s %9s %6s %9s\n",
               bench_processor(), asked.rounds, taut_kernel_name(), peer_blas_core(), 1e-9 * peak,
               1e-9 * gemm, "n", "taut ms", "(modes)", "CHOLMOD ms", "LAPACK ms", "/CHOLMOD",
               "/LAPACK", "residual", "refined", "CHOLMOD", "LAPACK", "memory", "dense ms", "peak",
               "make ms");
    }
    const int count = asked.large ? 6 : 4;
    for (int i = 0; i < count; i++) {
        const result r = run(sizes[i], &asked);
        if (asked.json) {
            print_json(&r, peak, i == count - 1);
        } else {
            print_row(&r, peak);
        }
    }
    printf("%s", asked.json ? "  ] }\n"
                            : "\nmemory: peak beyond the right-hand side, which the solution "
                              "replaces, in units of its "
                              "size.\ndense: a solve alone for a right-hand side without zeros, "
                              "and its share of the "
                              "multiply-add peak.\nmake: taut_dirichlet_make, all of it.\n");
    return 0;
}
