/* test_told.c -- whoever reads a document is told of its bytes and points; an end leaves no model. What is read does not depend on
 * who is told. */
#include "check.h"
#include "core/pulse.h"
#include "monitors.h"
#include "problems.h"

#include "taut/dirichlet.h"
#include "taut/read.h"
#include "taut/write.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COUNT = 250 };

/* A byte is looked at, a point made of three numbers and looked at twice: operations at least. */
static const double byte = 2, point = 12;
static const char path[] = "told.json";

/* How the document is read: from memory, as a file, as one of either kind. */
typedef enum way { TEXT, MODEL, EITHER, WAYS } way;

static taut_status read_told(way how, const char *text, size_t length, watch *w, taut_model **model)
{
    const taut_read_options options = {.monitor = monitor_of(w)};
    taut_error error = {.status = TAUT_OK};
    taut_problem *problem = NULL;
    const taut_status status =
        how == TEXT    ? taut_model_read_text_with(text, length, "text", &options, model, &error)
        : how == MODEL ? taut_model_read_with(path, &options, model, &error)
                       : taut_problem_or_model_read_with(path, &options, &problem, model, &error);
    CHECK(problem == NULL, "no problem");
    CHECK(status == TAUT_OK || strcmp(error.reason, "interrupted") == 0, "%s: %s", error.reason,
          error.message);
    return status;
}

static void check_way(way how, const char *text, size_t length)
{
    const double operations = byte * (double)length + point * COUNT * COUNT;
    watch all = {.stop_at = 0};
    taut_model *model = NULL;
    char *again = NULL;
    size_t size = 0;

    CHECK(read_told(how, text, length, &all, &model) == TAUT_OK, "read");
    CHECK(taut_model_write_text(model, "json", NULL, &again, &size, NULL) == TAUT_OK &&
              size == length && memcmp(again, text, size) == 0,
          "way %d: the same document", (int)how);
    taut_text_free(again);
    taut_model_free(model);
    CHECK(all.reports > operations / TAUT_PULSE_WORK - 1, "way %d: %d reports of %.3g operations",
          (int)how, all.reports, operations);
    for (int k = 1; k <= all.reports; k++) {
        watch stop = {.stop_at = k, .answer = k % 2 != 0 ? TAUT_STOP : TAUT_ENOUGH};
        model = NULL;
        CHECK(read_told(how, text, length, &stop, &model) == TAUT_INTERRUPTED && model == NULL &&
                  stop.reports == k,
              "way %d: stopped at %d of %d: went on to %d", (int)how, k, all.reports, stop.reports);
    }
}

int main(void)
{
    test_problem problem = problem_tetrahedron(COUNT);
    taut_model *model = NULL;
    char *text = NULL;
    size_t length = 0;

    CHECK(taut_dirichlet_make(&problem.data, NULL, &model, NULL) == TAUT_OK, "made");
    CHECK(taut_model_write(model, path, NULL, NULL) == TAUT_OK &&
              taut_model_write_text(model, "json", NULL, &text, &length, NULL) == TAUT_OK,
          "written");
    for (way how = TEXT; how < WAYS; how++) {
        check_way(how, text, length);
    }
    remove(path);
    taut_text_free(text);
    taut_model_free(model);
    problem_free(&problem);
    return check_failures != 0;
}
