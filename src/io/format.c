/* format.c -- the table of formats, and finding one by a path. */
#include "io/format.h"

#include "core/fail.h"
#include "io/file/in.h"
#include "io/json/in.h"
#include "platform/system.h"
#include "taut/limits.h"
#include "taut/read.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

typedef struct format_row {
    const taut_format_ops *ops;
    const char *ending, *text;
} format_row;

static const format_row rows[] = {
#define TAUT_FORMAT_ROW(identifier, ending, text) {&taut_format_##identifier, ending, text},
    TAUT_FORMAT_LIST(TAUT_FORMAT_ROW)
#undef TAUT_FORMAT_ROW
};
enum { FORMAT_COUNT = (int)(sizeof rows / sizeof rows[0]) };

int taut_format_count(void)
{
    return FORMAT_COUNT;
}

const char *taut_format_ending(int i)
{
    return i >= 0 && i < FORMAT_COUNT ? rows[i].ending : NULL;
}

const char *taut_format_text(int i)
{
    return i >= 0 && i < FORMAT_COUNT ? rows[i].text : NULL;
}

const taut_format_ops *taut_format_ops_at(int i)
{
    return i >= 0 && i < FORMAT_COUNT ? rows[i].ops : NULL;
}

/* The format of a name's ending; of "geomdl.json" and "json" the longer one. */
static int find_ending(const char *name)
{
    const size_t length = strlen(name);
    size_t longest = 0;
    int found = -1;
    for (int i = 0; i < FORMAT_COUNT; i++) {
        const size_t ending = strlen(rows[i].ending);
        if (ending > longest && length > ending && name[length - ending - 1] == '.' &&
            strcasecmp(rows[i].ending, name + length - ending) == 0) {
            longest = ending;
            found = i;
        }
    }
    return found;
}

/* "json, obj, pdf" */
static void list_endings(char *list, size_t size)
{
    size_t n = 0;
    list[0] = '\0';
    for (int i = 0; i < FORMAT_COUNT && n < size; i++) {
        n += (size_t)snprintf(list + n, size - n, "%s.%s", i > 0 ? ", " : "", rows[i].ending);
    }
}

int taut_format_of(const char *path, taut_error *error)
{
    char list[200];
    int i = 0;

    if (path == NULL) {
        taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                  "a format needs a path");
        return -1;
    }
    i = find_ending(taut_system_last_part(path));
    if (i >= 0) {
        return i;
    }
    if (strcmp(path, "-") == 0) {
        return find_ending(".json");
    }
    const taut_place place = taut_system_place_of(path);
    if (place == TAUT_PLACE_FOLDER) {
        taut_fail_file(error, path, "write", EISDIR);
        return -1;
    }
    if (strncmp(path, "/dev/", 5) == 0 || place == TAUT_PLACE_OTHER) {
        return find_ending(".json"); /* a device or a pipe: as standard output */
    }
    list_endings(list, sizeof list);
    taut_fail(error, TAUT_BAD_ARGUMENT, "format", NULL, taut_none, taut_none,
              "the ending of %.100s is not one of %s", path, list);
    return -1;
}

int taut_format_wants(const taut_model *model, const taut_write_options *options, int i)
{
    return options->surface == NULL ||
           strcmp(options->surface, taut_surface_name(taut_model_surface(model, i))) == 0;
}

/* The surface's name that is nearest to the one asked for. */
static const char *nearest_surface(const taut_model *model, const char *name)
{
    enum { LOOKED_AT = 256 };
    const char *names[LOOKED_AT + 1];
    int count = 0;
    while (count < LOOKED_AT && count < taut_model_surface_count(model)) {
        names[count] = taut_surface_name(taut_model_surface(model, count));
        count++;
    }
    names[count] = NULL;
    return taut_nearest_word(name, names, NULL);
}

taut_status taut_format_check(const taut_model *model, const taut_write_options *options,
                              taut_error *error)
{
    int named = 0;
    if (!(options->tolerance >= 0) || isinf(options->tolerance) || options->divide < 0 ||
        options->threads < 0 || options->threads > TAUT_THREADS_MAX) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "an option of writing is out of its range");
    }
    for (int i = 0; options->surface != NULL && i < taut_model_surface_count(model); i++) {
        named += taut_format_wants(model, options, i);
    }
    if (options->surface == NULL || named == 1) {
        return TAUT_OK;
    }
    if (named > 1) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "surface", NULL, named, 1,
                         "%d surfaces are named \"%.60s\", expected one", named, options->surface);
    }
    if (taut_model_surface_count(model) == 0) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "surface", NULL, 0, 1,
                         "no surface is named \"%.60s\": the model has none", options->surface);
    }
    return taut_fail(error, TAUT_BAD_ARGUMENT, "surface", NULL, 0, 1,
                     "no surface is named \"%.60s\"; the nearest name is \"%.60s\"",
                     options->surface, nearest_surface(model, options->surface));
}
