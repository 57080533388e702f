/* format.c -- the table of formats, and finding one by a path. */
#include "io/format.h"

#include "core/fail.h"
#include "geometry/whole.h"
#include "io/file/in.h"
#include "io/json/in.h"
#include "platform/system.h"
#include "taut/limits.h"
#include "taut/read.h"
#include "taut/version.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

static const taut_format_row rows[] = {TAUT_FORMAT_LIST(TAUT_FORMAT_ROW)};
enum { FORMAT_COUNT = (int)(sizeof rows / sizeof rows[0]) };

static const taut_formats own = {TAUT_VERSION, FORMAT_COUNT, rows};
static const taut_formats none = {TAUT_VERSION, 0, NULL};

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

/* Of "geomdl.json" and "json" the longer one, in *found where it is longer than what is there. */
static void find_ending(const taut_formats *formats, const char *name,
                        const taut_format_row **found)
{
    const size_t length = strlen(name);
    for (int i = 0; i < formats->count; i++) {
        const taut_format_row *row = &formats->rows[i];
        const size_t ending = strlen(row->ending);
        const size_t longest = *found != NULL ? strlen((*found)->ending) : 0;
        if (ending > longest && length > ending && name[length - ending - 1] == '.' &&
            strcasecmp(row->ending, name + length - ending) == 0) {
            *found = row;
        }
    }
}

static const taut_format_row *find_json(void)
{
    const taut_format_row *found = NULL;
    find_ending(&own, ".json", &found);
    return found;
}

/* "json, obj, pdf": two sorted lists as one. */
static void list_endings(const taut_formats *more, char *list, size_t size)
{
    size_t n = 0;
    int i = 0, j = 0;
    list[0] = '\0';
    while ((i < own.count || j < more->count) && n < size) {
        const int is_own = j == more->count ||
                           (i < own.count && strcmp(own.rows[i].ending, more->rows[j].ending) < 0);
        const char *ending = is_own ? own.rows[i].ending : more->rows[j].ending;
        n += (size_t)snprintf(list + n, size - n, "%s.%s", i + j > 0 ? ", " : "", ending);
        i += is_own;
        j += !is_own;
    }
}

/* Formats of another version say of themselves what this one does not understand. */
static taut_status check_version(const taut_formats *more, taut_error *error)
{
    if (strcmp(more->version, TAUT_VERSION) == 0) {
        return TAUT_OK;
    }
    return taut_fail(error, TAUT_BAD_ARGUMENT, "format", NULL, taut_none, taut_none,
                     "formats of taut %.40s are handed to taut %s, expected the same version",
                     more->version, TAUT_VERSION);
}

const taut_format_row *taut_format_find(const taut_formats *more, const char *path,
                                        taut_error *error)
{
    const taut_format_row *found = NULL;
    char list[200];

    more = more != NULL ? more : &none;
    if (path == NULL) {
        taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                  "a format needs a path");
        return NULL;
    }
    if (check_version(more, error) != TAUT_OK) {
        return NULL;
    }
    find_ending(&own, taut_system_last_part(path), &found);
    find_ending(more, taut_system_last_part(path), &found);
    if (found != NULL) {
        return found;
    }
    if (strcmp(path, "-") == 0) {
        return find_json();
    }
    const taut_place place = taut_system_place_of(path);
    if (place == TAUT_PLACE_FOLDER) {
        taut_fail_file(error, path, "write", EISDIR);
        return NULL;
    }
    if (strncmp(path, "/dev/", 5) == 0 || place == TAUT_PLACE_OTHER) {
        return find_json(); /* a device or a pipe: as standard output */
    }
    list_endings(more, list, sizeof list);
    taut_fail(error, TAUT_BAD_ARGUMENT, "format", NULL, taut_none, taut_none,
              "the ending of %.100s is not one of %s", path, list);
    return NULL;
}

int taut_format_of(const char *path, taut_error *error)
{
    const taut_format_row *found = taut_format_find(NULL, path, error);
    return found != NULL ? (int)(found - rows) : -1;
}

const char *taut_formats_ending(const taut_formats *more, const char *path, taut_error *error)
{
    const taut_format_row *found = taut_format_find(more, path, error);
    return found != NULL ? found->ending : NULL;
}

int taut_format_wants(const taut_model *model, const taut_write_options *options, int i)
{
    return taut_model_shows(model, options->surface, i);
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
        options->threads < 0 || options->threads > TAUT_THREADS_MAX || !(options->thickness >= 0) ||
        isinf(options->thickness)) {
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
