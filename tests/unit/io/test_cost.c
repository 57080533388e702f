/* test_cost.c -- reading and writing cost in proportion to the size. */
#include "check.h"

#include "taut/read.h"
#include "taut/write.h"

#include <stdlib.h>
#include <time.h>
#include <unistd.h>

static char folder[] = "/tmp/taut-test-XXXXXX";
static char path[64];

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* A net of rows x 100 random points on one B-spline surface. */
static taut_model *tall_model(int rows)
{
    taut_basis_spec spec = {.type = "bspline", .degree = 3, .count = rows};
    const int columns = 100;
    double *points = malloc(sizeof(double) * 3 * (size_t)rows * (size_t)columns);
    taut_basis *u = NULL, *v = NULL;
    taut_surface *surface = NULL;
    taut_model *model = NULL;

    for (int i = 0; i < 3 * rows * columns; i++) {
        points[i] = random_in(-1, 1);
    }
    CHECK(taut_basis_new(&spec, 0, &u, NULL) == TAUT_OK, "u");
    spec.count = columns;
    CHECK(taut_basis_new(&spec, 0, &v, NULL) == TAUT_OK, "v");
    CHECK(taut_surface_new("tall", u, v, points, NULL, &surface, NULL) == TAUT_OK, "surface");
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    CHECK(taut_model_add_surface(model, surface) == TAUT_OK, "add");
    taut_basis_free(u);
    taut_basis_free(v);
    free(points);
    return model;
}

/* The least time of several to write and to read. */
static void time_model(int rows, double *writing, double *reading)
{
    taut_model *model = tall_model(rows);
    *writing = *reading = INFINITY;
    for (int trial = 0; trial < 5; trial++) {
        taut_model *back = NULL;
        const double start = seconds();
        CHECK(taut_model_write(model, path, NULL, NULL) == TAUT_OK, "write");
        const double middle = seconds();
        CHECK(taut_model_read(path, &back, NULL) == TAUT_OK, "read");
        *writing = fmin(*writing, middle - start);
        *reading = fmin(*reading, seconds() - middle);
        taut_model_free(back);
    }
    taut_model_free(model);
}

/* Four times the size: four times the cost, where a quadratic one would be sixteen times; 7 lies
 * between with room for a busy machine. */
static void test_size(void)
{
    double small[2], large[2];
    time_model(250, &small[0], &small[1]);
    time_model(1000, &large[0], &large[1]);
    CHECK(large[0] < 7 * small[0], "writing: %.3g s and %.3g s", small[0], large[0]);
    CHECK(large[1] < 7 * small[1], "reading: %.3g s and %.3g s", small[1], large[1]);
}

/* Many surfaces, many claims. */
static double time_many(int count)
{
    static const char head[] = "{\"taut\":1,\"certificate\":{\"construct\":\"x\",\"claims\":[";
    static const char claim[] = "{\"claim\":\"c\",\"residual\":1,\"limit\":2,\"holds\":true},";
    static const char middle[] = "{\"claim\":\"c\",\"residual\":1,\"limit\":2,\"holds\":true}]},"
                                 "\"curves\":[";
    static const char curve[] = "{\"t\":{\"type\":\"bezier\",\"degree\":1},"
                                "\"points\":[[0,0,0],[1,1,1]]},";
    char *text = malloc((size_t)count * 160 + 400);
    double least = INFINITY;
    size_t n = (size_t)sprintf(text, "%s", head);
    for (int i = 0; i < count; i++) {
        n += (size_t)sprintf(text + n, "%s", claim);
    }
    n += (size_t)sprintf(text + n, "%s", middle);
    for (int i = 0; i < count; i++) {
        n += (size_t)sprintf(text + n, "%s", curve);
    }
    n--; /* the last comma */
    n += (size_t)sprintf(text + n, "]}");
    for (int trial = 0; trial < 5; trial++) {
        taut_model *model = NULL;
        taut_error error = {.status = TAUT_OK};
        const double start = seconds();
        CHECK(taut_model_read_text(text, n, "many", &model, &error) == TAUT_OK, "%s %s",
              error.where, error.message);
        least = fmin(least, seconds() - start);
        taut_model_free(model);
    }
    free(text);
    return least;
}

static void test_many(void)
{
    const double small = time_many(5000), large = time_many(20000);
    CHECK(large < 7 * small, "%.3g s and %.3g s", small, large);
}

int main(void)
{
    random_seed(20240613);
    if (mkdtemp(folder) == NULL) {
        return 1;
    }
    snprintf(path, sizeof path, "%s/model.json", folder);
    test_size();
    test_many();
    unlink(path);
    rmdir(folder);
    return check_failures != 0;
}
