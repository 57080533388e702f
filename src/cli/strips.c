/* strips.c -- which model a file gets: laths of a net go to CAD and to meshes as strips. */
#include "cli/cli.h"

#include <string.h>

/* Does a file of this ending hold surfaces in space, and nothing of a model's own? */
static int holds_strips(const char *path)
{
    static const char *const endings[] = {"3mf", "glb",  "iges", "igs", "obj",
                                          "ply", "step", "stl",  "stp", "vtu"};
    taut_error error;
    const char *ending = taut_formats_ending(taut_draw_formats(), path, &error);
    for (size_t i = 0; ending != NULL && i < sizeof endings / sizeof endings[0]; i++) {
        if (strcmp(ending, endings[i]) == 0) {
            return 1;
        }
    }
    return 0;
}

int cli_strips(const taut_model *model, const cli_options *options, const char *path,
               taut_model **strips, const taut_model **written)
{
    taut_error error;
    *written = model;
    if (!holds_strips(path)) {
        return 0;
    }
    if (*strips == NULL) {
        const taut_status status = taut_trace_strips(model, options->solid, strips, &error);
        if (status != TAUT_OK && (options->solid || strcmp(error.reason, "width") != 0)) {
            return cli_fail_at(path, &error);
        }
    }
    *written = *strips != NULL ? *strips : model;
    return 0;
}
