/* test_refusals.c -- what taut_outputs and its kin refuse: nothing given, two outputs to one
 * place, endings and names that mean nothing; every refusal leaves no file. */
#include "check.h"
#include "folder.h"
#include "shapes.h"

#include "taut/draw.h"
#include "taut/model.h"
#include "taut/write.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MANY = 1000 }; /* models, more than a figure holds */

static void check_told(const char *what, taut_status status, taut_status expected,
                       const taut_error *error)
{
    CHECK(status == expected, "%s: status %d", what, (int)status);
    CHECK(error->status == expected && error->message[0] != '\0', "%s: \"%s\"", what,
          error->message);
}

static void test_nothing(const taut_model *model)
{
    const taut_model *const two[2] = {model, NULL};
    taut_outputs *outputs = NULL;
    taut_record *record = taut_record_new();
    taut_error e = {.status = TAUT_OK};
    size_t length = 7;
    char *text = NULL;
    CHECK(taut_outputs_new(&outputs) == TAUT_OK, "outputs");
    check_told("model", taut_outputs_model(outputs, NULL, "a.obj", NULL, &e), TAUT_BAD_ARGUMENT,
               &e);
    check_told("path", taut_outputs_model(outputs, model, NULL, NULL, &e), TAUT_BAD_ARGUMENT, &e);
    check_told("outputs", taut_outputs_model(NULL, model, "a.obj", NULL, &e), TAUT_BAD_ARGUMENT,
               &e);
    check_told("models", taut_outputs_models(outputs, 1, NULL, "a.svg", NULL, &e),
               TAUT_BAD_ARGUMENT, &e);
    check_told("no models", taut_outputs_models(outputs, 0, &model, "a.svg", NULL, &e),
               TAUT_BAD_ARGUMENT, &e);
    check_told("models' path", taut_outputs_models(outputs, 1, &model, NULL, NULL, &e),
               TAUT_BAD_ARGUMENT, &e);
    check_told("models' outputs", taut_outputs_models(NULL, 1, &model, "a.svg", NULL, &e),
               TAUT_BAD_ARGUMENT, &e);
    check_told("one model of two", taut_outputs_models(outputs, 2, two, "a.svg", NULL, &e),
               TAUT_BAD_ARGUMENT, &e);
    check_told("record", taut_outputs_record(outputs, NULL, "a", &e), TAUT_BAD_ARGUMENT, &e);
    check_told("record path", taut_outputs_record(outputs, record, NULL, &e), TAUT_BAD_ARGUMENT,
               &e);
    check_told("text", taut_outputs_text(outputs, NULL, 3, "a", &e), TAUT_BAD_ARGUMENT, &e);
    check_told("text path", taut_outputs_text(outputs, "abc", 3, NULL, &e), TAUT_BAD_ARGUMENT, &e);
    check_told("commit", taut_outputs_commit(NULL, &e), TAUT_BAD_ARGUMENT, &e);
    CHECK(taut_record_write(NULL, &text, &length) == TAUT_BAD_ARGUMENT && length == 7 &&
              text == NULL,
          "a record that is none");
    CHECK(taut_outputs_commit(outputs, &e) == TAUT_OK, "nothing to put in place is fine");
    taut_outputs_abandon(NULL);
    taut_outputs_abandon(outputs);
    taut_outputs_free(NULL);
    taut_outputs_free(outputs);
    taut_record_free(record);
}

static void test_places(const taut_model *model)
{
    taut_outputs *outputs = NULL;
    taut_error e = {.status = TAUT_OK};
    const taut_write_options other = {.surface = "other"};
    CHECK(taut_outputs_new(&outputs) == TAUT_OK, "outputs");
    CHECK(taut_outputs_text(outputs, "", 0, "./one.txt", &e) == TAUT_OK, "an empty text");
    check_told("twice", taut_outputs_text(outputs, "x", 1, "one.txt", &e), TAUT_BAD_ARGUMENT, &e);
    check_told("ending", taut_outputs_model(outputs, model, "m.xyz", NULL, &e), TAUT_BAD_ARGUMENT,
               &e);
    check_told("name", taut_outputs_model(outputs, model, "m.obj", &other, &e), TAUT_BAD_ARGUMENT,
               &e);
    check_told("folder", taut_outputs_model(outputs, model, "nowhere/m.obj", NULL, &e), TAUT_IO,
               &e);
    CHECK(access("one.txt", F_OK) != 0, "a file is there before its time");
    CHECK(taut_outputs_commit(outputs, &e) == TAUT_OK, "%s", e.message);
    CHECK(unlink("one.txt") == 0, "the empty text is not there");
    taut_outputs_free(outputs);
    CHECK(access("m.xyz", F_OK) != 0 && access("m.obj", F_OK) != 0, "a refused file is there");
}

/* Renaming fails over a folder that came after staging: the others are not put in place either. */
static void test_commit_fails(const taut_model *model)
{
    taut_outputs *outputs = NULL;
    taut_error e = {.status = TAUT_OK};
    CHECK(taut_outputs_new(&outputs) == TAUT_OK, "outputs");
    CHECK(taut_outputs_model(outputs, model, "late.obj", NULL, &e) == TAUT_OK, "%s", e.message);
    CHECK(system("mkdir late.obj") == 0, "a folder in its place");
    check_told("late", taut_outputs_commit(outputs, &e), TAUT_IO, &e);
    taut_outputs_free(outputs);
    CHECK(rmdir("late.obj") == 0, "the folder is empty and there");
}

/* The model in the format of the name is refused, for this reason (NULL: one of the mesh or the
 * page), and leaves no file. */
static void check_refused(const taut_model *model, const char *name,
                          const taut_write_options *options, taut_status expected,
                          const char *reason)
{
    taut_error e = {.status = TAUT_OK};
    check_told(name, taut_model_write(model, name, options, &e), expected, &e);
    CHECK(reason == NULL || strcmp(e.reason, reason) == 0, "%s: %s, %s", name, e.reason, e.message);
    CHECK(access(name, F_OK) != 0, "%s is there", name);
}

/* What a format cannot hold. */
static void test_contents(const taut_model *model)
{
    static const double huge[4][3] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 3.5e38}};
    static const double line[2][3] = {{0, 0, 0}, {1, 2, 3}};
    taut_model *large = NULL, *curves = NULL;
    CHECK(taut_model_new(&large) == TAUT_OK && taut_model_new(&curves) == TAUT_OK, "models");
    CHECK(taut_model_add_surface(large, shape_surface(shape_bezier(1, 0, 1), shape_bezier(1, 0, 1),
                                                      &huge[0][0], NULL)) == TAUT_OK,
          "large");
    CHECK(taut_model_add_curve(curves, shape_curve(shape_bezier(1, 0, 1), &line[0][0], NULL)) ==
              TAUT_OK,
          "curve");
    check_refused(large, "m.glb", NULL, TAUT_NO_SOLUTION, "single-precision");
    check_refused(large, "m.stl", NULL, TAUT_NO_SOLUTION, "single-precision");
    check_refused(curves, "m.vtu", NULL, TAUT_NO_SOLUTION, "empty");
    check_refused(curves, "m.json", &(taut_write_options){.surface = "face"}, TAUT_BAD_ARGUMENT,
                  "surface");
    check_refused(model, "m.vtu", &(taut_write_options){.divide = 4000}, TAUT_BAD_ARGUMENT,
                  "cells");
    taut_model_free(large);
    taut_model_free(curves);
}

/* So many cells that their number is no int, which must not wrap to a few. */
static void test_many_cells(void)
{
    double points[25][3];
    taut_model *model = NULL;
    for (int i = 0; i < 25; i++) {
        points[i][0] = i / 5;
        points[i][1] = i % 5;
        points[i][2] = 0;
    }
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    CHECK(taut_model_add_surface(model, shape_surface(shape_bspline(1, 5), shape_bspline(1, 5),
                                                      &points[0][0], NULL)) == TAUT_OK,
          "four spans each way");
    check_refused(model, "m.vtu", &(taut_write_options){.divide = (1 << 30) + 1}, TAUT_BAD_ARGUMENT,
                  NULL);
    check_refused(model, "m.vtu", &(taut_write_options){.divide = 0x7fffffff}, TAUT_BAD_ARGUMENT,
                  NULL);
    taut_model_free(model);
}

/* Too many models side by side; a library's format to a place that is no file. */
static void test_kinds(const taut_model *model)
{
    const taut_model *many[MANY];
    const taut_write_options iges = {.format = "iges"}, figures = {.formats = taut_draw_formats()};
    taut_outputs *outputs = NULL;
    taut_error e = {.status = TAUT_OK};
    CHECK(taut_outputs_new(&outputs) == TAUT_OK, "outputs");
    for (int i = 0; i < MANY; i++) {
        many[i] = model;
    }
    check_told("many", taut_outputs_models(outputs, MANY, many, "m.svg", &figures, &e),
               TAUT_BAD_ARGUMENT, &e);
    CHECK(strcmp(e.reason, "several") == 0 && e.found == MANY && e.limit < MANY, "\"%s\"",
          e.message);
    check_told("obj", taut_outputs_models(outputs, 2, many, "m.obj", NULL, &e), TAUT_BAD_ARGUMENT,
               &e);
    CHECK(strcmp(e.reason, "several") == 0 && e.limit == 1, "%s", e.message);
    check_told("iges", taut_outputs_model(outputs, model, "-", &iges, &e), TAUT_IO, &e);
    CHECK(strcmp(e.reason, "not-a-file") == 0, "\"%s\"", e.message);
    CHECK(taut_outputs_commit(outputs, &e) == TAUT_OK, "nothing is to be put in place");
    taut_outputs_free(outputs);
}

/* A page whose maker is told to stop is not written. */
static int stop_sampling(void *context, double done, const char *what)
{
    int *calls = context;
    (*calls)++;
    CHECK(done == 1 && strcmp(what, "sampling") == 0, "%g %s", done, what);
    return 1;
}

static void test_stopped(const taut_model *model)
{
    int calls = 0;
    const taut_write_options options = {.monitor = {stop_sampling, &calls},
                                        .formats = taut_draw_formats()};
    check_refused(model, "m.html", &options, TAUT_INTERRUPTED, NULL);
    CHECK(calls == 1, "%d calls", calls);
}

int main(void)
{
    taut_model *model = shape_model(shape_saddle(0.5));
    CHECK(chdir(folder_make()) == 0, "its own folder");
    test_nothing(model);
    test_places(model);
    test_commit_fails(model);
    test_contents(model);
    test_many_cells();
    test_kinds(model);
    test_stopped(model);
    taut_model_free(model);
    CHECK(chdir("/") == 0 && folder_entries() == 0, "something was left behind");
    folder_remove();
    return check_failures != 0;
}
