/* test_watched.c -- whoever writes a file is told of its bytes, in every format; an end leaves neither text nor file. */
#include "check.h"
#include "core/pulse.h"
#include "monitors.h"
#include "problems.h"

#include "taut/dirichlet.h"
#include "taut/write.h"

#include <stdio.h>
#include <string.h>

/* A byte counts for so many operations at least. */
enum { BYTE = 20 };

static taut_status write_text(const taut_model *model, const char *format, watch *w, size_t *length)
{
    const taut_write_options options = {.monitor = monitor_of(w), .divide = 2};
    taut_error error = {.status = TAUT_OK};
    char *text = NULL;
    const taut_status status =
        taut_model_write_text(model, format, &options, &text, length, &error);
    CHECK((text != NULL) == (status == TAUT_OK), "%s: status %d", format, (int)status);
    CHECK(status == TAUT_OK || strcmp(error.reason, "interrupted") == 0, "%s: %s", format,
          error.message);
    taut_text_free(text);
    return status;
}

/* Nothing of a file is there after an end. */
static void check_file(const taut_model *model, const char *format)
{
    watch stop = {.stop_at = 1};
    const taut_write_options options = {.monitor = monitor_of(&stop), .divide = 2};
    char path[64];
    taut_error error = {.status = TAUT_OK};

    snprintf(path, sizeof path, "watched.%s", format);
    remove(path);
    CHECK(taut_model_write(model, path, &options, &error) == TAUT_INTERRUPTED &&
              strcmp(error.reason, "interrupted") == 0,
          "%s: %s", format, error.message);
    FILE *file = fopen(path, "rb");
    CHECK(file == NULL, "%s is there", path);
    if (file != NULL) {
        fclose(file);
    }
}

int main(void)
{
    static const char *const formats[] = {"3mf", "geomdl.json", "glb", "json", "obj",
                                          "ply", "step",        "stl", "vtu"};
    test_problem problem = problem_tetrahedron(100);
    taut_model *model = NULL;

    CHECK(taut_dirichlet_make(&problem.data, NULL, &model, NULL) == TAUT_OK, "made");
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++) {
        watch all = {.stop_at = 0}, none = {.stop_at = 0};
        size_t length = 0, again = 0;
        CHECK(write_text(model, formats[f], &all, &length) == TAUT_OK, "%s", formats[f]);
        CHECK(write_text(model, formats[f], &none, &again) == TAUT_OK && again == length &&
                  none.reports == all.reports,
              "%s: once more", formats[f]);
        CHECK(all.reports > BYTE * (double)length / TAUT_PULSE_WORK - 1,
              "%s: %d reports of %zu bytes", formats[f], all.reports, length);
        for (int k = all.reports; k >= 1; k -= k > all.reports - 2 ? 1 : 1 + all.reports / 3) {
            watch stop = {.stop_at = k};
            CHECK(write_text(model, formats[f], &stop, &length) == TAUT_INTERRUPTED &&
                      stop.reports == k,
                  "%s: stopped at %d of %d: went on to %d", formats[f], k, all.reports,
                  stop.reports);
        }
        check_file(model, formats[f]);
    }
    taut_model_free(model);
    problem_free(&problem);
    return check_failures != 0;
}
