/* test_watched.c -- whoever writes a file is told of its bytes, in every format; an end leaves neither text nor file. */
#include "check.h"
#include "core/pulse.h"
#include "monitors.h"
#include "problems.h"

#include "taut/dirichlet.h"
#include "taut/write.h"

#include <stdio.h>
#include <string.h>

/* Of each format how many operations a byte counts for at least: those of an archive are made, summed and written; and how many
 * come before the first byte: a grid of 97 x 97 cells is as many patches, of 1000 operations each, and sixteen points of 300 each. */
static const struct {
    const char *name;
    double byte, before;
} formats[] = {{"3mf", 60, 0},  {"geomdl.json", 20, 0}, {"glb", 20, 0},
               {"json", 20, 0}, {"obj", 20, 0},         {"ply", 20, 0},
               {"step", 20, 0}, {"stl", 20, 0},         {"vtu", 28, 97 * 97 * (1e3 + 16 * 300)}};

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
    test_problem problem = problem_tetrahedron(100);
    taut_model *model = NULL;

    CHECK(taut_dirichlet_make(&problem.data, NULL, &model, NULL) == TAUT_OK, "made");
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++) {
        const char *name = formats[f].name;
        watch all = {.stop_at = 0}, none = {.stop_at = 0};
        size_t length = 0, again = 0;
        CHECK(write_text(model, name, &all, &length) == TAUT_OK, "%s", name);
        CHECK(write_text(model, name, &none, &again) == TAUT_OK && again == length &&
                  none.reports == all.reports,
              "%s: once more", name);
        const double operations = formats[f].byte * (double)length + formats[f].before;
        CHECK(all.reports > operations / TAUT_PULSE_WORK - 1, "%s: %d reports of %zu bytes", name,
              all.reports, length);
        for (int k = all.reports; k >= 1; k -= k > all.reports - 2 ? 1 : 1 + all.reports / 3) {
            watch stop = {.stop_at = k};
            CHECK(write_text(model, name, &stop, &length) == TAUT_INTERRUPTED && stop.reports == k,
                  "%s: stopped at %d of %d: went on to %d", name, k, all.reports, stop.reports);
        }
        check_file(model, name);
    }
    taut_model_free(model);
    problem_free(&problem);
    return check_failures != 0;
}
