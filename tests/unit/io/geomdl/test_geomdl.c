/* test_geomdl.c -- geomdl's exchange JSON, out and in; B-spline knots in openNURBS's convention. */
#include "check.h"
#include "folder.h"
#include "models.h"

#include "taut/operations.h"
#include "taut/read.h"
#include "taut/write.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static taut_model *written_and_read(const taut_model *model, const char *name,
                                    const taut_write_options *options)
{
    const char *const path = in_folder(name);
    taut_model *back = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_model_write(model, path, options, &error) == TAUT_OK, "%s", error.message);
    CHECK(taut_model_read(path, &back, &error) == TAUT_OK, "%s: %s", error.where, error.message);
    remove(path);
    return back;
}

/* Surfaces come back as NURBS, bit for bit; a file of surfaces holds no curves. */
static void test_surfaces(void)
{
    for (int trial = 0; trial < 40; trial++) {
        taut_model *model = NULL, *back = NULL;
        const int count = random_int(1, 4);
        CHECK(taut_model_new(&model) == TAUT_OK, "model");
        for (int i = 0; i < count; i++) {
            add_some_surface(model, i % 2 ? "a \"name\"" : "");
        }
        add_some_curve(model, "left out");
        back = written_and_read(model, "a.geomdl.json", NULL);
        CHECK(back != NULL && taut_model_surface_count(back) == count, "count");
        CHECK(back != NULL && taut_model_curve_count(back) == 0, "curves");
        for (int i = 0; back != NULL && i < count; i++) {
            taut_surface *nurbs = NULL;
            CHECK(taut_surface_to_nurbs(taut_model_surface(model, i), 1, &nurbs, NULL, NULL) ==
                      TAUT_OK,
                  "nurbs");
            CHECK(same_surface(taut_model_surface(back, i), nurbs), "surface %d", i);
            taut_surface_free(nurbs);
        }
        taut_model_free(model);
        taut_model_free(back);
    }
}

static void test_curves(void)
{
    for (int trial = 0; trial < 40; trial++) {
        taut_model *model = NULL, *back = NULL;
        const int count = random_int(1, 4);
        CHECK(taut_model_new(&model) == TAUT_OK, "model");
        for (int i = 0; i < count; i++) {
            add_some_curve(model, "curve");
        }
        back = written_and_read(model, "a.GEOMDL.json", NULL);
        CHECK(back != NULL && taut_model_curve_count(back) == count, "count");
        for (int i = 0; back != NULL && i < count; i++) {
            taut_curve *nurbs = NULL;
            CHECK(taut_curve_to_nurbs(taut_model_curve(model, i), 1, &nurbs, NULL, NULL) == TAUT_OK,
                  "nurbs");
            CHECK(same_curve(taut_model_curve(back, i), nurbs), "curve %d", i);
            taut_curve_free(nurbs);
        }
        taut_model_free(model);
        taut_model_free(back);
    }
}

/* A plane curve of two coordinates, as geomdl exports one; what only geomdl knows is passed over.
 */
static void test_plane_curve(void)
{
    static const char text[] =
        "{\"shape\": {\"type\": \"curve\", \"count\": 1, \"data\": [{\"type\": \"spline\", "
        "\"rational\": true, \"dimension\": 2, \"degree\": 2, \"id\": 7, \"knotvector\": [0.0, 0.0,"
        " 0.0, 1.0, 1.0, 1.0], \"control_points\": {\"points\": [[1, 0], [1, 1], [0, 1]], "
        "\"weights\": [1, 0.7071067811865476, 1]}, \"delta\": 0.01}]}}";
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_model_read_text(text, strlen(text), "text", &model, &error) == TAUT_OK, "%s: %s",
          error.where, error.message);
    for (int k = 0; model != NULL && k <= 10; k++) {
        double x[3];
        CHECK(taut_curve_eval(taut_model_curve(model, 0), k / 10.0, 0, x) == TAUT_OK, "eval");
        CHECK_NEAR(hypot(x[0], x[1]), 1, 1e-15, "a quarter of the unit circle at %d", k);
        CHECK(x[2] == 0, "z = %g", x[2]);
    }
    taut_model_free(model);
}

/* Each is refused, with the place of what is wrong. */
static void test_refused(void)
{
#define CURVE(degree, knots, points)                                                               \
    "{\"shape\": {\"type\": \"curve\", \"count\": 1, \"data\": [{\"degree\": " degree              \
    ", \"knotvector\": " knots ", \"control_points\": {\"points\": " points "}}]}}"
    static const struct {
        const char *text, *where;
    } wrong[] = {
        {"{\"shape\": 3}", "/shape"},
        {"{\"shape\": {\"type\": \"volume\", \"data\": []}}", "/shape/type"},
        {"{\"shape\": {\"type\": \"curve\", \"data\": []}}", "/shape/data"},
        {"{\"shape\": {\"type\": \"curve\", \"count\": 9, \"data\": [{}]}}", "/shape/count"},
        {"{\"shape\": {\"type\": \"curve\", \"data\": [[]]}}", "/shape/data/0"},
        {CURVE("1", "[0,0,1,1]", "[[0,0,0]]"), "/shape/data/0/control_points/points"},
        {CURVE("1", "[0,0,1,1]", "[[0,0,0],[1,0,null]]"),
         "/shape/data/0/control_points/points/1/2"},
        {CURVE("1", "[0,0,1,1]", "[[0,0,0],[1,0,1e999]]"), "text:1:132"},
        {CURVE("3", "[0,0,1,1]", "[[0,0,0],[1,0,0]]"), "/shape/data/0/knotvector"},
        {CURVE("1", "[0,0,1,1,1]", "[[0,0,0],[1,0,0]]"), "/shape/data/0/knotvector"},
        {CURVE("1", "[0,1,0,1]", "[[0,0,0],[1,0,0]]"), "/shape/data/0/knotvector"},
        {CURVE("2000000000", "[0,0,1,1]", "[[0,0,0],[1,0,0]]"), "/shape/data/0/degree"},
        {"{\"shape\": {\"type\": \"surface\", \"data\": [{\"degree_u\": 1, \"degree_v\": 1, "
         "\"knotvector_u\": [0,0,1,1], \"knotvector_v\": [0,0,1,1], \"size_u\": 2000000000, "
         "\"size_v\": 2000000000, \"control_points\": {\"points\": [[0,0,0]]}}]}}",
         "/shape/data/0/size_u"},
        {"{\"shape\": {\"type\": \"surface\", \"data\": [{\"size_u\": 1000000, \"size_v\": 51}]}}",
         "/shape/data/0"},
        {CURVE("1", "[0,0.5,1]", "[[0,0,0],[1,0,0]]"), "/shape/data/0/knotvector"},
        {"{\"shape\": {\"type\": \"surface\", \"data\": [{\"degree_u\": 1, \"degree_v\": 1, "
         "\"knotvector_u\": [0,0,1,1], \"knotvector_v\": [0,0,1,1], \"size_u\": 2, \"size_v\": 3, "
         "\"control_points\": {\"points\": [[0,0,0],[0,1,0],[1,0,0],[1,1,0]]}}]}}",
         "/shape/data/0/control_points/points"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        taut_model *model = NULL;
        taut_error error = {.status = TAUT_OK};
        const taut_status status =
            taut_model_read_text(wrong[i].text, strlen(wrong[i].text), "text", &model, &error);
        CHECK(status == TAUT_BAD_INPUT && model == NULL, "%zu: status %d", i, (int)status);
        CHECK(strcmp(error.where, wrong[i].where) == 0, "%zu: \"%s\", expected \"%s\": %s", i,
              error.where, wrong[i].where, error.message);
        taut_model_free(model);
    }
}

/* Too many points are told by their number; a model of nothing makes no file. */
static void test_numbers(void)
{
    static const char large[] = "{\"shape\": {\"type\": \"surface\", \"data\": [{\"size_u\": "
                                "1000000, \"size_v\": 51}]}}";
    taut_model *model = NULL;
    taut_error error = {.status = TAUT_OK};
    const char *const path = in_folder("none.geomdl.json");
    CHECK(taut_model_read_text(large, sizeof large - 1, "text", &model, &error) == TAUT_BAD_INPUT &&
              error.found == 51e6 && error.limit == 5e7 && strcmp(error.reason, "size") == 0,
          "%s: %g", error.message, error.found);
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    CHECK(taut_model_write(model, path, NULL, &error) == TAUT_NO_SOLUTION &&
              strcmp(error.reason, "empty") == 0,
          "%s", error.message);
    CHECK(access(path, F_OK) != 0, "a file is there");
    taut_model_free(model);
}

/* Cut anywhere but in the white space at its end, a file is refused. */
static void test_cut(void)
{
    const char *const path = in_folder("cut.geomdl.json");
    char *bytes = NULL;
    size_t length = 0;
    taut_model *model = NULL;
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    add_some_surface(model, "cut");
    CHECK(taut_model_write(model, path, NULL, NULL) == TAUT_OK, "write");
    taut_model_free(model);
    bytes = file_bytes(path, &length);
    for (int k = 0; k < 50; k++) {
        const size_t cut = (length - 2) * (size_t)k / 49;
        taut_model *back = NULL;
        CHECK(taut_model_read_text(bytes, cut, "cut", &back, NULL) == TAUT_BAD_INPUT, "%zu of %zu",
              cut, length);
        taut_model_free(back);
    }
    remove(path);
    free(bytes);
}

/* Without the outermost knots a document says the same B-splines: the reader knows both forms. */
static void test_short_knots(void)
{
    for (int trial = 0; trial < 40; trial++) {
        const taut_write_options options = {.short_knots = 1};
        taut_model *model = NULL, *back = NULL;
        CHECK(taut_model_new(&model) == TAUT_OK, "model");
        add_some_surface(model, "s");
        add_some_curve(model, "c");
        back = written_and_read(model, "short.json", &options);
        CHECK(back != NULL &&
                  same_surface(taut_model_surface(back, 0), taut_model_surface(model, 0)),
              "surface");
        CHECK(back != NULL && same_curve(taut_model_curve(back, 0), taut_model_curve(model, 0)),
              "curve");
        taut_model_free(model);
        taut_model_free(back);
    }
}

int main(void)
{
    random_seed(20260308);
    folder_make();
    test_surfaces();
    test_curves();
    test_plane_curve();
    test_refused();
    test_numbers();
    test_cut();
    test_short_knots();
    CHECK(folder_entries() == 0, "something was left behind");
    folder_remove();
    return check_failures != 0;
}
