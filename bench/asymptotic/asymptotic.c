/* asymptotic.c -- seconds to make and to certify the worked examples of the construction
 * `asymptotic`, and its streamed Householder triangle beside LAPACK's dgeqrf on the same matrix,
 * one thread, in one run. Usage: bench-asymptotic EXAMPLES-FOLDER
 */
#include "machine.h"

#include "numeric/dense.h"
#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void dgeqrf_(const int *rows, const int *columns, double *a, const int *ld, double *tau,
             double *work, const int *size, int *info);

enum { ROUNDS = 3 };

/* Makes and certifies one example; the best of ROUNDS each. */
static void time_example(const char *folder, const char *name)
{
    char path[512];
    double make = INFINITY, certify = INFINITY;
    (void)snprintf(path, sizeof path, "%s/%s.json", folder, name);
    for (int round = 0; round < ROUNDS; round++) {
        taut_problem *problem = NULL;
        taut_model *model = NULL;
        taut_certificate *certificate = NULL;
        taut_error error;
        double start = 0.0;
        if (taut_problem_read(path, &problem, &error) != TAUT_OK) {
            printf("%s: %s\n", path, error.message);
            exit(5);
        }
        start = bench_cpu_seconds();
        if (taut_make(problem, NULL, &model, &error) != TAUT_OK) {
            printf("%s: %s\n", path, error.message);
            exit(1);
        }
        make = fmin(make, bench_cpu_seconds() - start);
        start = bench_cpu_seconds();
        if (taut_certify(model, problem, NULL, &certificate, &error) != TAUT_OK) {
            exit(1);
        }
        certify = fmin(certify, bench_cpu_seconds() - start);
        taut_certificate_free(certificate);
        taut_model_free(model);
        taut_problem_free(problem);
    }
    printf("  %-20s make %8.4f s   certify %8.4f s\n", name, make, certify);
}

/* Bidegree m: (m-3)^2 + 3 columns, 2m + 14 blocks of 3 (2m + 14) rows. */
static void time_triangle(int m)
{
    const int nodes = 2 * m + 14, block = 3 * nodes, rows = block * nodes;
    const int columns = (m - 3) * (m - 3) + 3, size = 64 * columns;
    const size_t count = (size_t)rows * (size_t)columns;
    double *a = malloc(count * sizeof *a), *part = malloc((size_t)(block * columns) * sizeof *part);
    double *r = calloc((size_t)(columns * columns), sizeof *r);
    double *tau = malloc((size_t)columns * sizeof *tau),
           *work = malloc((size_t)size * sizeof *work);
    double ours = 0.0, lapack = 0.0, difference = 0.0, largest = 0.0;
    int info = 0;
    if (a == NULL || part == NULL || r == NULL || tau == NULL || work == NULL) {
        exit(6);
    }
    srand(1);
    for (size_t k = 0; k < count; k++) {
        a[k] = rand() / (double)RAND_MAX - 0.5;
    }
    for (int b = 0; b < nodes; b++) {
        double start = 0.0;
        for (int j = 0; j < columns; j++) {
            memcpy(part + (long)j * block, a + (long)j * rows + (long)b * block,
                   (size_t)block * sizeof *part);
        }
        start = bench_cpu_seconds();
        taut_qr_append(columns, r, block, part);
        ours += bench_cpu_seconds() - start;
    }
    lapack = bench_cpu_seconds();
    dgeqrf_(&rows, &columns, a, &rows, tau, work, &size, &info);
    lapack = bench_cpu_seconds() - lapack;
    for (int j = 0; j < columns; j++) {
        for (int i = 0; i <= j; i++) { /* rows may differ in sign */
            const double x = fabs(r[(long)j * columns + i]), y = fabs(a[(long)j * rows + i]);
            difference = fmax(difference, fabs(x - y));
            largest = fmax(largest, y);
        }
    }
    printf("  m = %2d: %5d x %3d   taut %8.4f s   LAPACK %8.4f s   ratio %5.2f   differ by %.1e\n",
           m, rows, columns, ours, lapack, ours / lapack, difference / largest);
    free(work);
    free(tau);
    free(r);
    free(part);
    free(a);
}

int main(int argc, char **argv)
{
    static const char *const names[] = {"asymptotic-1", "asymptotic-2",   "asymptotic-3",
                                        "asymptotic-5", "asymptotic-6",   "asymptotic-low",
                                        "asymptotic-4", "asymptotic-4-in"};
    printf("%s\nExamples, best of %d:\n", bench_processor(), ROUNDS);
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        time_example(argc > 1 ? argv[1] : "examples", names[k]);
    }
    printf("Triangle of the thin plate:\n");
    time_triangle(8);
    time_triangle(13);
    time_triangle(18);
    return 0;
}
