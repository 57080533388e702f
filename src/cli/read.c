/* read.c -- models in, and what is to be said of them. */
#include "cli/cli.h"

#include <stdio.h>
#include <string.h>

/* To a person; a program is told all. */
enum { NOTES_TOLD = 3 };

/* Notes of a reader of CAD files; those of a saved model were told when it was made. */
static void tell_notes(const char *path, const taut_model *model)
{
    const taut_record *details = taut_model_details(model);
    const taut_record *notes = taut_record_get(details, "notes");
    const size_t count = taut_record_count(notes);

    const size_t told = cli_speaks_json() || count < NOTES_TOLD ? count : NOTES_TOLD;
    char more[64];

    for (size_t i = 0; i < told; i++) {
        cli_warn(path, taut_record_text(taut_record_at(notes, i)));
    }
    if (count > told) {
        snprintf(more, sizeof more, "and %zu more, in details.notes", count - told);
        cli_warn(path, more);
    }
}

/* A saved model of whole surfaces under trimmed faces is not what its file showed, which would be lost in the next one. */
static void tell_of_trims(const char *path, const taut_model *model)
{
    const taut_record *details = taut_model_details(model);
    const taut_record *trimmed = taut_record_get(details, "trimmed");
    char note[120];

    if (taut_record_get(details, "read_from") != NULL && taut_record_number(trimmed) > 0) {
        snprintf(note, sizeof note,
                 "surfaces under trimmed faces are whole in it: %.0f (see its details.notes)",
                 taut_record_number(trimmed));
        cli_warn(path, note);
    }
}

/* What a reader of `path` had to say, but for --quiet. */
static void tell_of(const char *path, const cli_options *options, const taut_model *model)
{
    if (model == NULL || options->quiet) {
        return;
    }
    if (cli_is_json(path)) {
        tell_of_trims(path, model);
    } else {
        tell_notes(path, model);
    }
}

/* A file that shows a model, a mesh or a picture, does not hold it. */
static void add_remedy(const char *path, taut_error *error)
{
    taut_error unknown;
    const char *ending = taut_formats_ending(taut_draw_formats(), path, &unknown);
    const size_t length = strlen(error->message);

    if (strncmp(error->message, "this is not JSON", 16) == 0 && ending != NULL &&
        !cli_is_json(path)) {
        snprintf(error->message + length, sizeof error->message - length,
                 "; a %s file shows a model and does not hold it: give the .json that it was "
                 "written from",
                 ending);
    }
}

static taut_status read_chosen(const char *path, const cli_options *options,
                               const taut_read_options *chosen, taut_model **model,
                               taut_error *error)
{
    const taut_status status = taut_model_read_with(path, chosen, model, error);

    cli_monitor_done();
    if (status == TAUT_OK) {
        tell_of(path, options, *model);
    } else {
        add_remedy(path, error);
    }
    return status;
}

taut_status cli_read_model(const char *path, const cli_options *options, taut_model **model,
                           taut_error *error)
{
    const taut_read_options chosen = {.untrim = options->untrim,
                                      .monitor = cli_monitor(options->quiet)};
    return read_chosen(path, options, &chosen, model, error);
}

taut_status cli_read_edges(const char *path, const cli_options *options, taut_model **model,
                           taut_error *error)
{
    const taut_read_options chosen = {.untrim = options->untrim,
                                      .edges = !options->untrim,
                                      .monitor = cli_monitor(options->quiet)};
    return read_chosen(path, options, &chosen, model, error);
}

taut_status cli_read_either(const char *path, const cli_options *options, taut_problem **problem,
                            taut_model **model, taut_error *error)
{
    const taut_read_options chosen = {.untrim = options->untrim,
                                      .monitor = cli_monitor(options->quiet)};
    const taut_status status =
        taut_problem_or_model_read_with(path, &chosen, problem, model, error);

    cli_monitor_done();
    if (status == TAUT_OK) {
        tell_of(path, options, *model);
    } else {
        add_remedy(path, error);
    }
    return status;
}
