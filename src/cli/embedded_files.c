#include "cli/embedded_files.h"

#include "cli/cli.h"

#include <stdio.h>
#include <string.h>

enum { NAMES = 256, NAME_ROOM = 80 }; /* that a misspelt one is compared with */

const taut_embedded *cli_embedded_find(const taut_embedded *files, const char *name)
{
    const size_t length = strlen(name);
    for (; files->name != NULL; files++) {
        if (strncmp(files->name, name, length) == 0 && strcmp(files->name + length, ".json") == 0) {
            return files;
        }
    }
    return NULL;
}

void cli_embedded_list(const taut_embedded *files)
{
    for (; files->name != NULL; files++) {
        printf("%.*s\n", (int)(strlen(files->name) - strlen(".json")), files->name);
    }
}

/* All names, where they fit; else 0. */
static int list_names(const taut_embedded *files, char *list, size_t size)
{
    size_t used = 0;
    for (; files->name != NULL && used < size; files++) {
        used += (size_t)snprintf(list + used, size - used, "%s%.*s", used > 0 ? ", " : "",
                                 (int)(strlen(files->name) - strlen(".json")), files->name);
    }
    return used < size;
}

/* The first that begins so; else NULL. */
static const char *beginning_with(const char *name, const char *const *names)
{
    const size_t length = strlen(name);
    while (*names != NULL && (length == 0 || strncmp(*names, name, length) != 0)) {
        names++;
    }
    return *names;
}

/* Too many to list: the nearest, if one is near, or one that begins with what was asked for. */
static int fail_among_many(const taut_embedded *files, const char *kind, const char *name)
{
    char texts[NAMES][NAME_ROOM];
    const char *names[NAMES + 1];
    size_t count = 0;

    for (; files[count].name != NULL && count < NAMES; count++) {
        (void)snprintf(texts[count], NAME_ROOM, "%.*s",
                       (int)(strlen(files[count].name) - strlen(".json")), files[count].name);
        names[count] = texts[count];
    }
    names[count] = NULL;
    const char *near = cli_nearest(name, names);
    near = near != NULL ? near : beginning_with(name, names);
    return cli_misuse("name", "there is no %s \"%.60s\"%s%s%s; `taut %s` lists them", kind, name,
                      near != NULL ? " (did you mean \"" : "", near != NULL ? near : "",
                      near != NULL ? "\"?)" : "", kind);
}

int cli_embedded_unknown(const taut_embedded *files, const char *kind, const char *name)
{
    char known[512];
    return list_names(files, known, sizeof known)
               ? cli_misuse("name", "there is no %s \"%.60s\"; there are: %s", kind, name, known)
               : fail_among_many(files, kind, name);
}
