/* test_sizes.c -- as much as there may be, and one more: told by number, before memory is taken for
 * it, or left out and said so; and the least there may be.
 *
 * needs: posix
 */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS, MAP_NORESERVE */
#include "check.h"
#include "folder.h"
#include "shapes.h"

#include "core/memory.h"
#include "io/cad/answer.h"
#include "io/problem/net_document.h"
#include "page/html_page.h"
#include "taut/limits.h"
#include "taut/read.h"
#include "taut/write.h"

#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

/* More bytes than a document may have: a text of zeros that takes no memory. */
static void test_text(void)
{
    const size_t length = (size_t)TAUT_FILE_MAX + 1;
    char *text = mmap(NULL, length, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(text != MAP_FAILED, "room for addresses");
    if (text == MAP_FAILED) {
        return;
    }
    CHECK(taut_model_read_text(text, length, "zeros", &model, &error) == TAUT_BAD_INPUT &&
              model == NULL,
          "%s", error.message);
    CHECK(error.found == TAUT_FILE_MAX + 1 && error.limit == TAUT_FILE_MAX &&
              strcmp(error.reason, "size") == 0,
          "%s", error.message);
    munmap(text, length);
}

/* A net of 7072 x n points, its rows the same one. */
static taut_status shape_of(uint32_t n, int shape[2], taut_error *error)
{
    enum { ROWS = 7072 };
    taut_json_value *points = calloc(n, sizeof *points), *rows = calloc(ROWS, sizeof *rows);
    for (uint32_t i = 0; i < n; i++) {
        points[i].kind = TAUT_JSON_NULL;
    }
    for (int i = 0; i < ROWS; i++) {
        rows[i] = (taut_json_value){TAUT_JSON_ARRAY, n, {.items = points}};
    }
    const taut_json_value net = {TAUT_JSON_ARRAY, ROWS, {.items = rows}};
    const taut_json root = {NULL, NULL, NULL, 0, NULL};
    const taut_json at = {&net, &root, "points", 0, NULL};
    const taut_status status = taut_net_document_shape(&at, &shape[0], &shape[1], error);
    free(points);
    free(rows);
    return status;
}

static void test_net(void)
{
    int shape[2] = {-1, -1};
    taut_error error = {.status = TAUT_OK};
    CHECK(shape_of(7071, shape, &error) == TAUT_BAD_INPUT && shape[0] == -1 && shape[1] == -1,
          "7072 x 7071");
    CHECK(strcmp(error.where, "/points") == 0 && error.found == 7072.0 * 7071 &&
              error.limit == TAUT_POINTS_MAX && strcmp(error.reason, "size") == 0,
          "%s: %s", error.where, error.message);
    CHECK(shape_of(7070, shape, &error) == TAUT_OK && shape[0] == 7072 && shape[1] == 7070,
          "%d x %d", shape[0], shape[1]);
}

static size_t read_on(void *context, void *to, size_t room)
{
    return fread(to, 1, room, context);
}

/* One curve more than a model may have, out of a CAD file. */
static void test_items(void)
{
    static const double knots[4] = {0, 0, 1, 1}, points[6] = {0, 0, 0, 1, 2, 3};
    const taut_cad_item line = {"", {1, 0}, {2, 0}, {knots, NULL}, points, NULL, 0, NULL,
                                0,  0,      {0}};
    taut_cad_result result = {.notes = taut_record_new_list()};
    taut_error error = {.status = TAUT_OK};
    FILE *file = tmpfile();
    taut_cad_source source = {.more = read_on, .context = file};
    CHECK(taut_model_new(&result.model) == TAUT_OK, "model");
    for (int i = 0; i <= TAUT_OBJECTS_MAX; i++) {
        taut_cad_put_item(file, &line);
    }
    rewind(file);
    CHECK(taut_cad_get_all(&source, &result, &error) == TAUT_BAD_INPUT && !result.has_ended, "%s",
          error.message);
    CHECK(strcmp(error.where, "/curves/100000") == 0 &&
              strcmp(error.message, "found more than 100000 curves") == 0,
          "%s: %s", error.where, error.message);
    CHECK(taut_model_curve_count(result.model) == TAUT_OBJECTS_MAX, "the others are there");
    fclose(file);
    taut_model_free(result.model);
    taut_record_free(result.notes);
}

/* A page shows the first surfaces and curves of very many, and says how many it leaves out. */
static void test_page(void)
{
    enum { SURFACES = 4690, CURVES = 203 };
    static const double line[2][3] = {{0, 0, 0}, {1, 2, 3}};
    const taut_write_options options = {.title = ""};
    taut_surface *saddle = shape_saddle(0.5);
    taut_curve *curve = shape_curve(shape_bezier(1, 0, 1), &line[0][0], NULL);
    taut_error error = {.status = TAUT_OK};
    taut_model *model = NULL;
    char *text = NULL;
    size_t length = 0;
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    for (int i = 0; i < SURFACES; i++) {
        taut_surface *copy = NULL;
        CHECK(taut_surface_copy(saddle, &copy) == TAUT_OK &&
                  taut_model_add_surface(model, copy) == TAUT_OK,
              "surface %d", i);
    }
    for (int i = 0; i < CURVES; i++) {
        taut_curve *copy = NULL;
        CHECK(taut_curve_copy(curve, &copy) == TAUT_OK &&
                  taut_model_add_curve(model, copy) == TAUT_OK,
              "curve %d", i);
    }
    CHECK(taut_html_data(model, &options, &text, &length, &error) == TAUT_OK, "%s", error.message);
    CHECK(text != NULL && strstr(text, "The last 3 surfaces are left out.") != NULL, "surfaces");
    CHECK(text != NULL && strstr(text, "The last 3 curves are left out.") != NULL, "curves");
    taut_free(text);
    taut_model_free(model);
    taut_surface_free(saddle);
    taut_curve_free(curve);
}

/* A surface that is one point has no triangle of any size: glTF, which wants one, gets them all. */
static void test_point(void)
{
    static const double points[4][3] = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    const taut_write_options options = {.divide = 2, .format = "glb"};
    const char *const path = in_folder("point.glb");
    char *bytes = NULL;
    size_t length = 0;
    taut_error error = {.status = TAUT_OK};
    taut_model *model = NULL;
    model = shape_model(
        shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1), &points[0][0], NULL));
    CHECK(taut_model_write(model, path, &options, &error) == TAUT_OK, "%s", error.message);
    bytes = file_bytes(path, &length);
    /* four cells are eight triangles; their indices are the last bytes, of nine vertices */
    CHECK(strstr(bytes + 20, "\"count\": 24") != NULL, "%s", bytes + 20);
    for (size_t i = 1; i <= 24; i++) {
        uint32_t index = 9;
        memcpy(&index, bytes + length - 4 * i, sizeof index);
        CHECK(index < 9, "index %u", index);
    }
    taut_model_free(model);
    free(bytes);
}

int main(void)
{
    folder_make();
    test_text();
    test_net();
    test_items();
    test_page();
    test_point();
    folder_remove();
    return check_failures != 0;
}
