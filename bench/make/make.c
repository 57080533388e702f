/* make.c -- whole processes, from file to file, all constructions, in one run.
 *
 * Of each document: the CPU time of `taut make`, one thread, and within this process the shares of
 * reading, making, proving and writing. Beside films: Surface Evolver with its fastest elements, to
 * the same error of the area. Beside nets: what one would write by hand, which proves nothing: a
 * frame read by strtod, LAPACK's fast diagonalisation, points written by printf. Best of ROUNDS.
 *
 *     bench-make [--json]
 */
#include "evolver.h"
#include "machine.h"
#include "task.h"

#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { READ, MADE, PROVED, WRITTEN, PARTS, ROUNDS = 3, NAME = 64 };

typedef struct row {
    const char *name;
    double part[PARTS], whole; /* seconds */
    const char *peer;          /* or NULL */
    double peer_seconds;
} row;

static char folder[] = "/tmp/bench-make-XXXXXX";

static void fail(const char *what)
{
    fprintf(stderr, "bench-make: %s\n", what);
    exit(6);
}

static const char *path_of(const char *name)
{
    static char path[4][NAME];
    static int next = 0;
    char *made = path[next++ % 4];
    snprintf(made, NAME, "%s/%s", folder, name);
    return made;
}

static FILE *open_or_fail(const char *path, const char *mode)
{
    FILE *file = fopen(path, mode);
    if (file == NULL) {
        fail(path);
    }
    return file;
}

/* ---- documents ---- */

static void write_example(const char *name)
{
    const char *const arguments[] = {BENCH_TAUT, "example", name, NULL};
    if (bench_run(arguments, path_of("in.json")) < 0) {
        fail(name);
    }
}

/* A frame of a net of m x m, and nothing inside it. */
static void write_net(int m)
{
    FILE *file = open_or_fail(path_of("in.json"), "w");
    fprintf(file,
            "{ \"taut\": 1, \"construct\": \"dirichlet\",\n"
            "  \"u\": { \"type\": \"bspline\", \"degree\": 3, \"count\": %d },\n"
            "  \"v\": { \"type\": \"bspline\", \"degree\": 3, \"count\": %d },\n  \"points\": [\n",
            m, m);
    for (int i = 0; i < m; i++) {
        fputs(i > 0 ? ",\n[" : "[", file);
        for (int j = 0; j < m; j++) {
            double p[3];
            bench_frame_point(m, i, j, p);
            if (i == 0 || j == 0 || i == m - 1 || j == m - 1) {
                fprintf(file, "%s[%.17g, %.17g, %.17g]", j > 0 ? ", " : "", p[0], p[1], p[2]);
            } else {
                fputs(", null", file);
            }
        }
        fputs("]", file);
    }
    fputs("] }\n", file);
    fclose(file);
}

/* Scherk's patch between its curves, along normals, without the bound of the least area. */
static void write_scherk(int points)
{
    static char curves[32768];
    FILE *file = open_or_fail(BENCH_FILES "/scherk.json", "r");
    curves[fread(curves, 1, sizeof curves - 1, file)] = '\0';
    fclose(file);
    file = open_or_fail(path_of("in.json"), "w");
    fprintf(file,
            "{ \"taut\": 1, \"construct\": \"plateau\", \"method\": \"normal\", \"least\": false,\n"
            "  \"u\": { \"type\": \"bspline\", \"degree\": 6, \"count\": %d },\n"
            "  \"v\": { \"type\": \"bspline\", \"degree\": 6, \"count\": %d },\n"
            "  \"curves\": %s }\n",
            points, points, curves);
    fclose(file);
}

/* ---- taut ---- */

static void part(row *r, int which, double *since)
{
    const double now = bench_cpu_seconds();
    r->part[which] = fmin(r->part[which], now - *since);
    *since = now;
}

static void time_parts(row *r)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    double since = bench_cpu_seconds();
    if (taut_problem_read(path_of("in.json"), &problem, NULL) != TAUT_OK) {
        fail(r->name);
    }
    part(r, READ, &since);
    if (taut_make(problem, NULL, &model, NULL) != TAUT_OK) {
        fail(r->name);
    }
    part(r, MADE, &since);
    if (taut_certify(model, problem, NULL, &certificate, NULL) != TAUT_OK) {
        fail(r->name);
    }
    part(r, PROVED, &since);
    taut_model_set_certificate(model, certificate);
    if (taut_model_write(model, path_of("out.json"), NULL, NULL) != TAUT_OK) {
        fail(r->name);
    }
    part(r, WRITTEN, &since);
    taut_model_free(model);
    taut_problem_free(problem);
}

static void time_row(row *r)
{
    const char *const arguments[] = {
        BENCH_TAUT, "make", path_of("in.json"), "-o", path_of("out.json"), "--quiet", "--threads",
        "1",        NULL};
    r->whole = INFINITY;
    for (int k = 0; k < PARTS; k++) {
        r->part[k] = INFINITY;
    }
    for (int k = 0; k < ROUNDS; k++) {
        const double once = bench_run(arguments, "/dev/null");
        r->whole = once >= 0 ? fmin(r->whole, once) : r->whole;
        time_parts(r);
    }
}

/* ---- peers ---- */

static void peer_net(int m, row *r)
{
    const int n = m - 2;
    const char *in = path_of("frame.txt"), *out = path_of("net.txt");
    FILE *file = open_or_fail(in, "w");
    for (int k = 0; k < 4 * m; k++) {
        double p[3];
        bench_frame_point(m, k / 4, k % 4, p);
        fprintf(file, "%.17g %.17g %.17g\n", p[0], p[1], p[2]);
    }
    fclose(file);
    r->peer = "LAPACK, fast diagonalisation; proves nothing";
    r->peer_seconds = INFINITY;
    for (int round = 0; round < ROUNDS; round++) {
        double *x = bench_numbers(3 * (size_t)n * (size_t)n), start = bench_cpu_seconds(), took = 0,
               number;
        file = open_or_fail(in, "r");
        while (fscanf(file, "%lf", &number) == 1) {
        }
        fclose(file);
        took = bench_cpu_seconds() - start;
        peer_task task = bench_task_new(n);
        took += peer_lapack(&task, x);
        bench_task_free(&task);
        start = bench_cpu_seconds();
        file = open_or_fail(out, "w");
        for (size_t k = 0; k < (size_t)n * (size_t)n; k++) {
            fprintf(file, "%.17g %.17g %.17g\n", x[3 * k], x[3 * k + 1], x[3 * k + 2]);
        }
        fclose(file);
        r->peer_seconds = fmin(r->peer_seconds, took + bench_cpu_seconds() - start);
        free(x);
    }
    remove(in);
    remove(out);
}

/* The fastest elements that reach the error, as bench-plateau finds them. */
static void peer_evolver(double error, row *r)
{
    r->peer = "Surface Evolver, its fastest elements; proves nothing";
    r->peer_seconds = INFINITY;
    for (int degree = 2; degree <= 6; degree += 2) {
        for (int levels = 2; levels <= (degree == 2 ? 6 : degree == 4 ? 4 : 3); levels++) {
            double seconds = 0;
            const double area = bench_evolver(BENCH_FILES "/scherk.fe", degree, levels, &seconds);
            if (fabs(area / 5.6975122115870573 - 1) <= error) {
                r->peer_seconds = fmin(r->peer_seconds, seconds);
                break;
            }
        }
    }
}

/* ---- */

static void print_row(int json, int first, const row *r)
{
    const double *p = r->part, sum = p[READ] + p[MADE] + p[PROVED] + p[WRITTEN];
    if (json) {
        printf("%s\n    { \"name\": \"%s\", \"whole_ms\": %.4g, \"read\": %.3g, \"made\": %.3g, "
               "\"proved\": %.3g, \"written\": %.3g",
               first ? "" : ",", r->name, 1e3 * r->whole, p[READ] / sum, p[MADE] / sum,
               p[PROVED] / sum, p[WRITTEN] / sum);
        if (r->peer != NULL) {
            printf(", \"peer\": \"%s\", \"peer_ms\": %.4g", r->peer, 1e3 * r->peer_seconds);
        }
        printf(" }");
        return;
    }
    printf("%-28s %9.1f  %3.0f %3.0f %3.0f %3.0f", r->name, 1e3 * r->whole, 100 * p[READ] / sum,
           100 * p[MADE] / sum, 100 * p[PROVED] / sum, 100 * p[WRITTEN] / sum);
    if (r->peer != NULL) {
        printf("  %9.1f %6.1f  %s", 1e3 * r->peer_seconds, r->peer_seconds / r->whole, r->peer);
    }
    printf("\n");
}

int main(int argc, char **argv)
{
    static const char *const examples[] = {
        "bonnet-figure-4", "harmonic-fit", "biharmonic-c2",    "asymptotic-1",    "asymptotic-4",
        "pipe-auto",       "pipe-g2",      "pipe-run-harness", "plateau-curves",  "film-sail",
        "film-ring",       "film-bubbles", "trace-bonnet",     "trace-principal", "pattern-sail"};
    static const char *const scherk[] = {"plateau, Scherk to 1e-8", "plateau, Scherk to 1e-10"};
    static const char *const nets[] = {"dirichlet, 300 x 300", "dirichlet, 1000 x 1000"};
    const int json = argc > 1 && strcmp(argv[1], "--json") == 0;
    int first = 1;

    if (mkdtemp(folder) == NULL) {
        fail(folder);
    }
    printf(json ? "{ \"processor\": \"%s\",\n  \"rows\": [" : "%s, one thread, CPU time\n",
           bench_processor());
    if (!json) {
        printf("%-28s %9s  %s  %9s %6s\n", "", "whole, ms", "read made proved written, %",
               "peer, ms", "ratio");
    }
    for (int k = 0; k < 2; k++) {
        row r = {.name = nets[k]};
        write_net(k == 0 ? 300 : 1000);
        time_row(&r);
        peer_net(k == 0 ? 300 : 1000, &r);
        print_row(json, first, &r);
        first = 0;
    }
    for (int k = 0; k < 2; k++) {
        row r = {.name = scherk[k]};
        write_scherk(k == 0 ? 10 : 13);
        time_row(&r);
        peer_evolver(k == 0 ? 1e-8 : 1e-10, &r);
        print_row(json, first, &r);
    }
    for (size_t k = 0; k < sizeof examples / sizeof *examples; k++) {
        row r = {.name = examples[k]};
        write_example(examples[k]);
        time_row(&r);
        print_row(json, first, &r);
    }
    printf(json ? "\n  ] }\n" : "");
    remove(path_of("in.json"));
    remove(path_of("out.json"));
    rmdir(folder);
    return 0;
}
