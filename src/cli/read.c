/* read.c -- models in, and what is to be said of them. */
#include "cli/cli.h"

#include <stdio.h>

enum { NOTES_TOLD = 3 };

/* Names come out of files that are not ours: what would steer a terminal is not printed. */
static void tell_note(const char *path, const char *note)
{
    fprintf(stderr, "taut: %s: warning: ", path);
    for (const char *c = note; *c != '\0'; c++) {
        const unsigned char byte = (unsigned char)*c;
        fputc(byte < 0x20 || byte == 0x7f ? '?' : byte, stderr);
    }
    fputc('\n', stderr);
}

/* Notes of a reader of CAD files; those of a saved model were told when it was made. */
static void tell_notes(const char *path, const taut_model *model)
{
    const taut_record *details = taut_model_details(model);
    const taut_record *notes = taut_record_get(details, "notes");
    const size_t count = taut_record_count(notes);

    for (size_t i = 0; i < count && i < NOTES_TOLD; i++) {
        tell_note(path, taut_record_text(taut_record_at(notes, i)));
    }
    if (count > NOTES_TOLD) {
        fprintf(stderr, "taut: %s: warning: and %zu more, in details.notes\n", path,
                count - NOTES_TOLD);
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
        tell_note(path, note);
    }
}

/* What a reader of `path` had to say, unless all that is printed is JSON. */
static void tell_of(const char *path, const cli_options *options, const taut_model *model)
{
    if (model == NULL || options->json) {
        return;
    }
    if (cli_is_json(path)) {
        tell_of_trims(path, model);
    } else {
        tell_notes(path, model);
    }
}

static taut_status read_chosen(const char *path, const cli_options *options,
                               const taut_read_options *chosen, taut_model **model,
                               taut_error *error)
{
    const taut_status status = taut_model_read_with(path, chosen, model, error);

    if (status == TAUT_OK) {
        tell_of(path, options, *model);
    }
    return status;
}

taut_status cli_read_model(const char *path, const cli_options *options, taut_model **model,
                           taut_error *error)
{
    const taut_read_options chosen = {.untrim = options->untrim};
    return read_chosen(path, options, &chosen, model, error);
}

taut_status cli_read_edges(const char *path, const cli_options *options, taut_model **model,
                           taut_error *error)
{
    const taut_read_options chosen = {.untrim = options->untrim, .edges = !options->untrim};
    return read_chosen(path, options, &chosen, model, error);
}

taut_status cli_read_either(const char *path, const cli_options *options, taut_problem **problem,
                            taut_model **model, taut_error *error)
{
    const taut_read_options chosen = {.untrim = options->untrim};
    const taut_status status =
        taut_problem_or_model_read_with(path, &chosen, problem, model, error);

    if (status == TAUT_OK) {
        tell_of(path, options, *model);
    }
    return status;
}
