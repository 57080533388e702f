/* test_cost.c -- reading and writing take memory in proportion to the size: four times the
 * document, four times the blocks and the bytes, resized blocks counted whole each time. What grew
 * by one each time, or was copied whole for each part, would take sixteen times the bytes.
 * `make bench-documents` has the times. */
#include "check.h"
#include "fault.h"
#include "folder.h"

#include "taut/read.h"
#include "taut/write.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

static const char *path;

typedef struct cost {
    double blocks;
    double bytes;
} cost;

static void start_counting(void)
{
    fault_arm(LONG_MAX, 0);
}

static cost counted(void)
{
    const cost found = {(double)fault_counted(), (double)fault_bytes()};
    fault_disarm();
    return found;
}

/* What is taken whatever the size makes the quotient less than 4; a block that grows by doubling
 * may end just over a power of two, which makes the bytes up to twice as many. */
static void check_proportional(cost small, cost large, const char *what)
{
    CHECK(large.blocks < 4.5 * small.blocks, "%s: %g blocks, then %g", what, small.blocks,
          large.blocks);
    CHECK(large.bytes < 8 * small.bytes, "%s: %g bytes, then %g", what, small.bytes, large.bytes);
    printf("%-24s %8.0f and %8.0f blocks, %10.0f and %10.0f bytes\n", what, small.blocks,
           large.blocks, small.bytes, large.bytes);
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

static void count_net(int rows, cost *writing, cost *reading)
{
    taut_model *model = tall_model(rows);
    taut_model *back = NULL;
    start_counting();
    CHECK(taut_model_write(model, path, NULL, NULL) == TAUT_OK, "write");
    *writing = counted();
    start_counting();
    CHECK(taut_model_read(path, &back, NULL) == TAUT_OK, "read");
    *reading = counted();
    taut_model_free(back);
    taut_model_free(model);
}

/* A large net. */
static void test_net(void)
{
    cost small[2], large[2];
    count_net(250, &small[0], &small[1]);
    count_net(1000, &large[0], &large[1]);
    check_proportional(small[0], large[0], "a net written");
    check_proportional(small[1], large[1], "a net read");
}

/* So many claims and curves. */
static cost count_parts(int count)
{
    static const char head[] = "{\"taut\":1,\"certificate\":{\"construct\":\"x\",\"claims\":[";
    static const char claim[] = "{\"claim\":\"c\",\"residual\":1,\"limit\":2,\"holds\":true}";
    static const char middle[] = "]},\"curves\":[";
    static const char curve[] = "{\"t\":{\"type\":\"bezier\",\"degree\":1},"
                                "\"points\":[[0,0,0],[1,1,1]]}";
    char *text = malloc((size_t)count * (sizeof claim + sizeof curve) + 400);
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    size_t n = (size_t)sprintf(text, "%s", head);
    for (int i = 0; i < count; i++) {
        n += (size_t)sprintf(text + n, "%s%s", i > 0 ? "," : "", claim);
    }
    n += (size_t)sprintf(text + n, "%s", middle);
    for (int i = 0; i < count; i++) {
        n += (size_t)sprintf(text + n, "%s%s", i > 0 ? "," : "", curve);
    }
    n += (size_t)sprintf(text + n, "]}");
    start_counting();
    CHECK(taut_model_read_text(text, n, "parts", &model, &error) == TAUT_OK, "%s %s", error.where,
          error.message);
    const cost found = counted();
    taut_model_free(model);
    free(text);
    return found;
}

static void test_parts(void)
{
    check_proportional(count_parts(5000), count_parts(20000), "claims and curves read");
}

int main(void)
{
    random_seed(20240613);
    folder_make();
    path = in_folder("model.json");
    test_net();
    test_parts();
    folder_remove();
    return check_failures != 0;
}
