/* test_output_refusals.c -- what taut_outputs and its kin refuse: nothing given, two outputs to one
 * place, endings and names that mean nothing; every refusal leaves no file. */
#include "check.h"
#include "shapes.h"

#include "taut/model.h"
#include "taut/write.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static taut_model *make_model(void)
{
    taut_model *model = NULL;
    CHECK(taut_model_new(&model) == TAUT_OK, "model");
    CHECK(taut_model_add_surface(model, shape_saddle(0.5)) == TAUT_OK, "surface");
    return model;
}

static void check_told(const char *what, taut_status status, taut_status expected,
                       const taut_error *error)
{
    CHECK(status == expected, "%s: status %d", what, (int)status);
    CHECK(error->status == expected && error->message[0] != '\0', "%s: \"%s\"", what,
          error->message);
}

static void test_nothing(const taut_model *model)
{
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

int main(void)
{
    char folder[] = "/tmp/taut-test-XXXXXX";
    taut_model *model = make_model();
    if (mkdtemp(folder) == NULL || chdir(folder) != 0) {
        return 1;
    }
    test_nothing(model);
    test_places(model);
    test_commit_fails(model);
    taut_model_free(model);
    CHECK(chdir("/") == 0 && rmdir(folder) == 0, "something was left in %s", folder);
    return check_failures != 0;
}
