/* plateau.c -- least areas beside Surface Evolver, to given errors of the area, in one run.
 *
 * Two patches of known area between four curves (Bezier curves of degree 18, good to rounding):
 * Scherk's and the catenoid's. Taut: method "normal", the fastest degree and number of points that
 * reach the error; within the process, best of five, and as a whole process with certificate and
 * output. Evolver: levels of refinement until the error is reached, with quadratic elements as is
 * its habit, and with the fastest of these and Lagrange elements of degree 4 and 6. CPU time of
 * one thread. The bound of the least area is left out: Evolver proves nothing. Prints a table, or JSON with --json.
 */
#include "evolver.h"
#include "machine.h"

#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
    LEVELS = 3,
    CASES = 2,
    REPEATS = 5,
    EVOLVER_MAX = 6,
    EVOLVER_REPEATS = 3,
    POINTS_MAX = 30,
    DEGREE_MAX = 6
};

typedef struct sample {
    double seconds, error;
    int iterations, products;
} sample;

typedef struct peer {
    double seconds, error;
    int degree, levels;
} peer;

typedef struct best {
    sample inside;
    int degree, points;
    double process;          /* whole, seconds */
    peer quadratic, fastest; /* Evolver */
} best;

static const char *const names[CASES] = {"scherk", "catenoid"};
static const double areas[CASES] = {5.6975122115870573, 2.1280059723370761};
static const double wanted[LEVELS] = {1e-6, 1e-8, 1e-10};
static char curves[CASES][16384];

static void read_curves(int which)
{
    char path[512];
    snprintf(path, sizeof path, BENCH_FILES "/%s.json", names[which]);
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        exit(5);
    }
    curves[which][fread(curves[which], 1, sizeof curves[which] - 1, file)] = '\0';
    fclose(file);
}

static void write_problem(int which, int degree, int points, char *text, size_t size)
{
    snprintf(text, size,
             "{ \"taut\": 1, \"construct\": \"plateau\", \"method\": \"normal\",\n"
             "  \"least\": false,\n"
             "  \"u\": { \"type\": \"bspline\", \"degree\": %d, \"count\": %d },\n"
             "  \"v\": { \"type\": \"bspline\", \"degree\": %d, \"count\": %d },\n"
             "  \"curves\": %s }\n",
             degree, points, degree, points, curves[which]);
}

static double detail(const taut_model *model, const char *key)
{
    return taut_record_number(taut_record_get(taut_model_details(model), key));
}

/* From the problem in memory to the model. */
static sample solve(int which, int degree, int points, int repeats)
{
    static char text[32768];
    taut_problem *problem = NULL;
    sample f = {INFINITY, INFINITY, 0, 0};
    write_problem(which, degree, points, text, sizeof text);
    if (taut_problem_read_text(text, strlen(text), "bench", &problem, NULL) != TAUT_OK) {
        exit(3);
    }
    for (int k = 0; k < repeats; k++) {
        taut_model *model = NULL;
        const double start = bench_cpu_seconds();
        if (taut_make(problem, NULL, &model, NULL) == TAUT_OK) {
            double area = 0;
            f.seconds = fmin(f.seconds, bench_cpu_seconds() - start);
            taut_surface_area(taut_model_surface(model, 0), &area, NULL);
            f.error = fabs(area / areas[which] - 1);
            f.iterations = (int)detail(model, "iterations");
            f.products = (int)detail(model, "products");
        }
        taut_model_free(model);
    }
    taut_problem_free(problem);
    return f;
}

/* The fastest that reaches the error, by degree and points. */
static void search(int which, double error, best *b)
{
    b->inside.seconds = INFINITY;
    for (int degree = 3; degree <= DEGREE_MAX; degree++) {
        for (int points = degree + 2; points <= POINTS_MAX; points++) {
            const sample f = solve(which, degree, points, 1);
            if (f.error <= error) {
                const sample again = solve(which, degree, points, REPEATS);
                if (again.seconds < b->inside.seconds) {
                    b->inside = again;
                    b->degree = degree;
                    b->points = points;
                }
                break;
            }
        }
    }
}

static double process(int which, const best *b)
{
    static char text[32768];
    char folder[] = "/tmp/bench-plateau-XXXXXX", in[64], out[64];
    double took = INFINITY;
    if (mkdtemp(folder) == NULL) {
        exit(5);
    }
    snprintf(in, sizeof in, "%s/in.json", folder);
    snprintf(out, sizeof out, "%s/out.json", folder);
    FILE *file = fopen(in, "w");
    if (file == NULL) {
        exit(5);
    }
    write_problem(which, b->degree, b->points, text, sizeof text);
    fputs(text, file);
    fclose(file);
    const char *const arguments[] = {BENCH_TAUT, "make", in, "-o", out, "--quiet", NULL};
    for (int k = 0; k < REPEATS; k++) {
        const double once = bench_run(arguments, "/dev/null");
        took = once >= 0 ? fmin(took, once) : took;
    }
    remove(in);
    remove(out);
    rmdir(folder);
    return took;
}

static int most_levels(int degree)
{
    return degree == 2 ? EVOLVER_MAX : degree == 4 ? 4 : 3;
}

/* The first refinement that reaches the error, from `levels` on; best of three where it is fast. */
static peer evolve(int which, int degree, int levels, double error)
{
    char file[512];
    peer found = {0, INFINITY, degree, levels - 1};
    snprintf(file, sizeof file, BENCH_FILES "/%s.fe", names[which]);
    while (!(found.error <= error) && found.levels < most_levels(degree)) {
        found.levels++;
        found.seconds = INFINITY;
        for (int k = 0; k < EVOLVER_REPEATS; k++) {
            double seconds = 0;
            found.error =
                fabs(bench_evolver(file, degree, found.levels, &seconds) / areas[which] - 1);
            found.seconds = fmin(found.seconds, seconds);
            k = seconds > 1 ? EVOLVER_REPEATS : k;
        }
    }
    return found;
}

static void compare(int which, best rows[LEVELS])
{
    int levels = 2;
    for (int k = 0; k < LEVELS; k++) {
        best *b = &rows[k];
        search(which, wanted[k], b);
        b->process = process(which, b);
        b->quadratic = k > 0 && rows[k - 1].quadratic.error <= wanted[k]
                           ? rows[k - 1].quadratic
                           : evolve(which, 2, levels, wanted[k]);
        levels = b->quadratic.levels;
        b->fastest = b->quadratic;
        for (int degree = 4; degree <= 6; degree += 2) {
            const peer other = evolve(which, degree, 2, wanted[k]);
            if (other.error <= wanted[k] &&
                (b->fastest.error > wanted[k] || other.seconds < b->fastest.seconds)) {
                b->fastest = other;
            }
        }
    }
}

static void print_peer(int json, const char *name, const peer *p, double error, double process)
{
    if (json) {
        printf(", \"%s\": { \"degree\": %d, \"levels\": %d, \"ms\": %.4g, \"reached\": %.3g }",
               name, p->degree, p->levels, 1e3 * p->seconds, p->error);
    } else {
        printf(" %d/%d %8.1f %8.1e%s%7.1f", p->degree, p->levels, 1e3 * p->seconds, p->error,
               p->error <= error ? " " : "*", p->seconds / process);
    }
}

static void print_row(int json, int which, int k, const best *b)
{
    if (json) {
        printf("%s\n    { \"case\": \"%s\", \"error\": %g, \"degree\": %d, \"points\": %d, "
               "\"reached\": %.3g,\n      \"solver_ms\": %.4g, \"process_ms\": %.4g, "
               "\"iterations\": %d, \"products\": %d",
               which + k > 0 ? "," : "", names[which], wanted[k], b->degree, b->points,
               b->inside.error, 1e3 * b->inside.seconds, 1e3 * b->process, b->inside.iterations,
               b->inside.products);
    } else {
        printf("%-9s%6.0e  p=%d n=%-2d %8.1e %7.3f %7.2f ", names[which], wanted[k], b->degree,
               b->points, b->inside.error, 1e3 * b->inside.seconds, 1e3 * b->process);
    }
    print_peer(json, "quadratic", &b->quadratic, wanted[k], b->process);
    print_peer(json, "fastest", &b->fastest, wanted[k], b->process);
    printf(json ? " }" : "\n");
}

/* Steps and products as the net grows. */
static void growth(int json)
{
    static const int counts[] = {10, 20, 40, 100, 200, 400};
    printf(json ? "\n  ],\n  \"growth\": [" : "\nScherk, cubic:  n, steps, products, ms, error\n");
    for (int k = 0; k < 6; k++) {
        const sample f = solve(0, 3, counts[k], 1);
        printf(json ? "%s\n    { \"points\": %d, \"iterations\": %d, \"products\": %d, "
                      "\"solver_ms\": %.4g, \"reached\": %.3g }"
                    : "%s%4d %6d %9d %11.2f %9.1e\n",
               json && k > 0 ? "," : "", counts[k], f.iterations, f.products, 1e3 * f.seconds,
               f.error);
    }
    printf(json ? "\n  ] }\n" : "\n");
}

int main(int argc, char **argv)
{
    const int json = argc > 1 && strcmp(argv[1], "--json") == 0;
    best rows[CASES][LEVELS];

    memset(rows, 0, sizeof rows);
    for (int c = 0; c < CASES; c++) {
        read_curves(c);
        compare(c, rows[c]);
    }
    printf(json ? "{ \"processor\": \"%s\",\n  \"rows\": ["
                : "%s, one thread, CPU time; * the error was not reached\n",
           bench_processor());
    if (!json) {
        printf("%-9s%6s  %-9s %6s %7s %7s   %-27s %s\n", "", "error", "taut", "reached", "solver",
               "process", "evolver, quadratic", "evolver, fastest");
        printf("%-9s%6s  %-9s %7s %7s %7s   %-27s %s\n", "", "", "", "", "ms", "ms",
               "p/levels ms reached ratio", "p/levels ms reached ratio");
    }
    for (int c = 0; c < CASES; c++) {
        for (int k = 0; k < LEVELS; k++) {
            print_row(json, c, k, &rows[c][k]);
        }
    }
    growth(json);
    return 0;
}
