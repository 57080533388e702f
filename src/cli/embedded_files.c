#include "cli/embedded_files.h"

#include "cli/cli.h"

#include <stdio.h>
#include <string.h>

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

int cli_embedded_unknown(const taut_embedded *files, const char *kind, const char *name)
{
    char known[512] = "";
    size_t used = 0;
    for (const taut_embedded *file = files; file->name != NULL && used < sizeof known; file++) {
        used += (size_t)snprintf(known + used, sizeof known - used, "%s%.*s", used > 0 ? ", " : "",
                                 (int)(strlen(file->name) - strlen(".json")), file->name);
    }
    return cli_misuse("name", "there is no %s \"%.60s\"; there are: %s", kind, name, known);
}
