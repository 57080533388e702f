/* documents.c -- what a number of a document costs to write and to read, as documents grow: one
 * large net, then many curves and claims. A cost in proportion to the size shows as one figure in
 * each column. */
#include "machine.h"

#include "taut/taut.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { ROUNDS = 5, COLUMNS = 100 };

static char folder[] = "/tmp/taut-bench-XXXXXX";
static char path[64];

static void require(taut_status status, const taut_error *error)
{
    if (status != TAUT_OK) {
        printf("%s %s\n", error->where, error->message);
        exit(taut_status_exit_code(status));
    }
}

/* Uniform in [-1, 1], the same sequence in every run. */
static double random_number(void)
{
    static unsigned long long state = 20240613;
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(state >> 11) * 0x1p-52 - 1;
}

/* A net of rows x COLUMNS points of many digits on one B-spline surface. */
static taut_model *model_of_net(int rows)
{
    const size_t count = 3 * (size_t)rows * COLUMNS;
    taut_basis_spec spec = {.type = "bspline", .degree = 3, .count = rows};
    double *points = malloc(sizeof(double) * count);
    taut_basis *u = NULL, *v = NULL;
    taut_surface *surface = NULL;
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};

    for (size_t i = 0; points != NULL && i < count; i++) {
        points[i] = random_number();
    }
    require(taut_basis_new(&spec, 0, &u, &error), &error);
    spec.count = COLUMNS;
    require(taut_basis_new(&spec, 0, &v, &error), &error);
    require(taut_surface_new("net", u, v, points, NULL, &surface, &error), &error);
    require(taut_model_new(&model), &error);
    require(taut_model_add_surface(model, surface), &error);
    taut_basis_free(u);
    taut_basis_free(v);
    free(points);
    return model;
}

/* So many straight curves, and a claim for each. */
static taut_model *model_of_parts(int count)
{
    const taut_basis_spec spec = {.type = "bezier", .degree = 1};
    const taut_claim claim = {.claim = "c", .residual = 1, .limit = 2, .holds = TAUT_TRUE};
    taut_basis *t = NULL;
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_error error = {.status = TAUT_OK};

    require(taut_basis_new(&spec, 0, &t, &error), &error);
    require(taut_model_new(&model), &error);
    require(taut_certificate_new("x", &certificate), &error);
    for (int i = 0; i < count; i++) {
        const double points[6] = {i, 0, 0, i, 1, 1};
        taut_curve *curve = NULL;
        require(taut_curve_new("", t, points, NULL, &curve, &error), &error);
        require(taut_model_add_curve(model, curve), &error);
        require(taut_certificate_add(certificate, &claim), &error);
    }
    taut_model_set_certificate(model, certificate);
    taut_basis_free(t);
    return model;
}

/* The best of ROUNDS; frees the model. */
static void time_model(taut_model *model, const char *what, int count)
{
    double writing = INFINITY, reading = INFINITY;
    taut_error error = {.status = TAUT_OK};
    for (int round = 0; round < ROUNDS; round++) {
        taut_model *back = NULL;
        const double start = bench_cpu_seconds();
        require(taut_model_write(model, path, NULL, &error), &error);
        const double middle = bench_cpu_seconds();
        require(taut_model_read(path, &back, &error), &error);
        reading = fmin(reading, bench_cpu_seconds() - middle);
        writing = fmin(writing, middle - start);
        taut_model_free(back);
    }
    printf("%-20s %8d  %9.1f %7.0f  %9.1f %7.0f\n", what, count, 1e3 * writing,
           1e9 * writing / count, 1e3 * reading, 1e9 * reading / count);
    taut_model_free(model);
}

int main(void)
{
    if (mkdtemp(folder) == NULL) {
        return 5;
    }
    snprintf(path, sizeof path, "%s/model.json", folder);
    printf("%s\n%-20s %8s  %9s %7s  %9s %7s\n", bench_processor(), "", "count", "written ms",
           "ns each", "read ms", "ns each");
    for (int rows = 250; rows <= 16000; rows *= 4) {
        time_model(model_of_net(rows), "points", rows * COLUMNS);
    }
    for (int count = 5000; count <= 80000; count *= 4) {
        time_model(model_of_parts(count), "curves and claims", count);
    }
    unlink(path);
    rmdir(folder);
    return 0;
}
