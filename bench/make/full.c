/* full.c -- least areas by the method "full" over those by "normal", whole processes, in one run.
 *
 * CPU time of `taut make`, one thread, without the bound of the least area; best of ROUNDS. Nets of
 * a known boundary: flat, Scherk's, wavy, steep, of graded knots, rational, of degree 2 to 6, from
 * 10 to 200 points a side.
 *
 *     bench-full
 */
#include "evolver.h"
#include "machine.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { ROUNDS = 3, NAME = 64, KNOTS_MOST = 256 };

typedef enum shape { FLAT, SCHERK, WAVY, STEEP, SKEW } shape;

typedef struct boundary {
    const char *name;
    shape shape;
    int degree, count;
    int is_graded, is_rational;
} boundary;

static const boundary boundaries[] = {
    {"flat, bent sides, 24 x 24", FLAT, 3, 24, 0, 0},
    {"Scherk, degree 5, 10 x 10", SCHERK, 5, 10, 0, 0},
    {"Scherk, 20 x 20", SCHERK, 3, 20, 0, 0},
    {"steep waves, 30 x 30", STEEP, 3, 30, 0, 0},
    {"steep skew quadrilateral, degree 4, 20 x 20", SKEW, 4, 20, 0, 0},
    {"wavy, degree 6, 16 x 16", WAVY, 6, 16, 0, 0},
    {"wavy, weights 1 to 2.5, 20 x 20", WAVY, 3, 20, 0, 1},
    {"wavy, knots graded by cubes, 30 x 30", WAVY, 3, 30, 1, 0},
    {"wavy, degree 2, 40 x 40", WAVY, 2, 40, 0, 0},
    {"wavy, 60 x 60", WAVY, 3, 60, 0, 0},
    {"wavy, 100 x 100", WAVY, 3, 100, 0, 0},
    {"wavy, 200 x 200", WAVY, 3, 200, 0, 0},
};

static char folder[] = "/tmp/bench-full-XXXXXX", in_path[NAME], out_path[NAME];

static void fail(const char *what)
{
    fprintf(stderr, "bench-full: %s\n", what);
    exit(6);
}

static void point_of(shape which, double u, double v, double p[3])
{
    p[0] = u;
    p[1] = v;
    p[2] = 0;
    switch (which) {
    case FLAT:
        p[0] += 0.3 * sin(2 * v);
        p[1] += 0.2 * u * u;
        break;
    case SCHERK:
        p[0] = 2.2 * (u - 0.5);
        p[1] = 2.2 * (v - 0.5);
        p[2] = log(cos(p[0]) / cos(p[1]));
        break;
    case WAVY:
        p[2] = 0.3 * sin(3 * u) * cos(5 * v) + 0.2 * u * v;
        break;
    case STEEP:
        p[2] = 2 * u * (1 - u) * cos(6.283185307179586 * v);
        break;
    case SKEW:
        p[2] = 3 * u * v + 3 * (1 - u) * (1 - v);
        break;
    }
}

/* Clamped knots on [0, 1], even or by cubes; returns how many. */
static int find_knots(const boundary *b, double *knots)
{
    const int spans = b->count - b->degree;
    int made = 0;
    for (int k = -b->degree; k <= spans + b->degree; k++) {
        const double t = fmin(1, fmax(0, (double)k / spans));
        knots[made++] = b->is_graded ? t * t * t : t;
    }
    return made;
}

static void write_basis(FILE *file, const char *name, const boundary *b, const double *knots,
                        int count)
{
    fprintf(file, "  \"%s\": { \"type\": \"bspline\", \"degree\": %d, \"knots\": [", name,
            b->degree);
    for (int k = 0; k < count; k++) {
        fprintf(file, "%s%.17g", k > 0 ? ", " : "", knots[k]);
    }
    fputs("] },\n", file);
}

static void write_document(const boundary *b, const char *method)
{
    double knots[KNOTS_MOST], greville[KNOTS_MOST];
    const int count = find_knots(b, knots);
    FILE *file = fopen(in_path, "w");

    if (file == NULL) {
        fail(in_path);
    }
    for (int i = 0; i < b->count; i++) {
        greville[i] = 0;
        for (int k = 1; k <= b->degree; k++) {
            greville[i] += knots[i + k] / b->degree;
        }
    }
    fprintf(file,
            "{ \"taut\": 1, \"construct\": \"plateau\", \"least\": false, \"method\": \"%s\",\n",
            method);
    write_basis(file, "u", b, knots, count);
    write_basis(file, "v", b, knots, count);
    for (int part = 0; part < (b->is_rational ? 2 : 1); part++) {
        fprintf(file, "%s[", part == 0 ? "  \"points\": " : ",\n  \"weights\": ");
        for (int i = 0; i < b->count; i++) {
            fputs(i > 0 ? ",\n    [" : "[", file);
            for (int j = 0; j < b->count; j++) {
                const double u = greville[i], v = greville[j];
                const int last = b->count - 1;
                double p[3];
                point_of(b->shape, u, v, p);
                fputs(j > 0 ? ", " : "", file);
                if (part == 1) {
                    fprintf(file, "%.17g", 1 + 2 * u * (1 - u) + v);
                } else if (i % last == 0 || j % last == 0) {
                    fprintf(file, "[%.17g, %.17g, %.17g]", p[0], p[1], p[2]);
                } else {
                    fputs("null", file);
                }
            }
            fputs("]", file);
        }
        fputs("]", file);
    }
    fputs(" }\n", file);
    fclose(file);
}

static double time_document(const boundary *b, const char *method)
{
    const char *const arguments[] = {BENCH_TAUT, "make",      in_path, "-o", out_path,
                                     "--quiet",  "--threads", "1",     NULL};
    double least = INFINITY;

    write_document(b, method);
    for (int k = 0; k < ROUNDS; k++) {
        const double once = bench_run(arguments, "/dev/null");
        if (once < 0) {
            fail(b->name);
        }
        least = fmin(least, once);
    }
    return least;
}

int main(void)
{
    if (mkdtemp(folder) == NULL) {
        fail(folder);
    }
    snprintf(in_path, sizeof in_path, "%s/in.json", folder);
    snprintf(out_path, sizeof out_path, "%s/out.json", folder);
    printf("%s, one thread, CPU time\n%-45s %11s %9s %6s\n", bench_processor(), "", "normal, ms",
           "full, ms", "ratio");
    for (size_t k = 0; k < sizeof boundaries / sizeof *boundaries; k++) {
        const double normal = time_document(&boundaries[k], "normal");
        const double full = time_document(&boundaries[k], "full");
        printf("%-45s %11.1f %9.1f %6.2f\n", boundaries[k].name, 1e3 * normal, 1e3 * full,
               full / normal);
        fflush(stdout);
    }
    remove(in_path);
    remove(out_path);
    rmdir(folder);
    return 0;
}
