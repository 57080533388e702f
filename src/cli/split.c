/* split.c -- taut split: cuts the surfaces of a model at a parameter. */
#include "cli/cli.h"

#include <stdio.h>
#include <string.h>

enum { CUTS_MAX = 64 };

/* "0.25,0.5,0.75"; 0: no such numbers. */
static int read_cuts(const char *word, double cuts[CUTS_MAX])
{
    int count = 0;
    for (const char *at = word; count < CUTS_MAX; count++) {
        const char *end = at + strcspn(at, ",");
        char number[64];
        if ((size_t)(end - at) >= sizeof number) {
            return 0;
        }
        snprintf(number, sizeof number, "%.*s", (int)(end - at), at);
        if (!cli_number(number, &cuts[count])) {
            return 0;
        }
        if (*end == '\0') {
            return count + 1;
        }
        at = end + 1;
    }
    return 0;
}

static taut_status add_all(const taut_model *pieces, taut_model *to)
{
    taut_status status = TAUT_OK;
    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(pieces); i++) {
        taut_surface *copy = NULL;
        status = taut_surface_copy(taut_model_surface(pieces, i), &copy);
        status = status == TAUT_OK ? taut_model_add_surface(to, copy) : status;
        if (status != TAUT_OK) {
            taut_surface_free(copy);
        }
    }
    return status;
}

/* Surface i, cut where t is inside of it. */
static taut_status cut_one(const taut_model *model, int i, int direction, double t, taut_model *to,
                           taut_error *error)
{
    const taut_surface *surface = taut_model_surface(model, i);
    const taut_basis *basis =
        direction == TAUT_ALONG_U ? taut_surface_u(surface) : taut_surface_v(surface);
    taut_model *pieces = NULL;
    taut_status status = TAUT_OK;

    if (taut_basis_lo(basis) < t && t < taut_basis_hi(basis)) {
        status = taut_surface_split(surface, direction, t, &pieces, error);
        status = status == TAUT_OK ? add_all(pieces, to) : status;
        taut_model_free(pieces);
        return status;
    }
    taut_surface *copy = NULL;
    status = taut_surface_copy(surface, &copy);
    status = status == TAUT_OK ? taut_model_add_surface(to, copy) : status;
    if (status != TAUT_OK) {
        taut_surface_free(copy);
    }
    return status;
}

/* What the first cut left, cut again at t; curves stay as they are. */
static taut_status cut_again(taut_model **model, int direction, double t, taut_error *error)
{
    taut_model *next = NULL;
    taut_status status = taut_model_new(&next);

    *error = (taut_error){.status = status};
    if (status == TAUT_OK) {
        status = taut_model_set_unit(next, taut_model_unit(*model));
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(*model); i++) {
        status = cut_one(*model, i, direction, t, next, error);
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_curve_count(*model); i++) {
        taut_curve *copy = NULL;
        status = taut_curve_copy(taut_model_curve(*model, i), &copy);
        status = status == TAUT_OK ? taut_model_add_curve(next, copy) : status;
        if (status != TAUT_OK) {
            taut_curve_free(copy);
        }
    }
    if (status == TAUT_OK) {
        taut_model_free(*model);
        *model = next;
        return TAUT_OK;
    }
    taut_model_free(next);
    return status;
}

static int run(const cli_options *options)
{
    const int along_v = options->text_v != NULL;
    const int direction = along_v ? TAUT_ALONG_V : TAUT_ALONG_U;
    const char *word = along_v ? options->text_v : options->text_u;
    taut_model *model = NULL, *split = NULL;
    taut_error error;
    taut_status (*cut)(const taut_model *, const char *, int, double, taut_model **, taut_error *) =
        options->exact ? taut_model_split_exact : taut_model_split;
    double cuts[CUTS_MAX];
    cli_options all = *options; /* what is written: every surface */
    int code = 0;

    all.surface = NULL;
    if ((options->text_u != NULL) == along_v) {
        return cli_misuse("option", "`taut split` needs one of --u T and --v T");
    }
    const int count = read_cuts(word, cuts);
    if (count == 0) {
        return cli_misuse_value(along_v ? "--v" : "--u", word, "a number");
    }
    if (count > 1 && (options->exact || options->surface != NULL)) {
        return cli_misuse("option", "several cuts are of all surfaces, and not --exact");
    }
    code = cli_check_outputs(options);
    if (code != 0) {
        return code;
    }
    if (cli_read_model(options->files[0], options, &model, &error) != TAUT_OK) {
        return cli_fail_in(options->files[0], &error);
    }
    taut_status status = cut(model, options->surface, direction, cuts[0], &split, &error);
    for (int k = 1; status == TAUT_OK && k < count; k++) {
        status = cut_again(&split, direction, cuts[k], &error);
    }
    if (status == TAUT_NO_MEMORY) {
        code = cli_no_memory();
    } else {
        code = status == TAUT_OK ? cli_write_model(split, &all)
                                 : cli_fail_in(options->files[0], &error);
    }
    taut_model_free(split);
    taut_model_free(model);
    return code;
}

static const cli_option options_of_split[] = {
    {"--u", CLI_TEXT, offsetof(cli_options, text_u), 0, 0, 0, "T", "cut along u at T, or T,T,.."},
    {"--v", CLI_TEXT, offsetof(cli_options, text_v), 0, 0, 0, "T", "cut along v at T, or T,T,.."},
    CLI_OUTPUT,
    CLI_SURFACE,
    CLI_UNTRIM,
    CLI_THREADS,
    CLI_EXACT,
    CLI_LAST};

const cli_command cli_command_split = {
    .name = "split",
    .usage = "MODEL.json (--u T | --v T) [-o FILE]",
    .summary = "cut surfaces and curves at a parameter, exactly",
    .text = "Every surface gives its low piece, then its high one, with names of their own; the "
            "pieces keep their parameters. A c- or h-bspline cut off its knots opens into c- or "
            "h-bezier pieces. Of several cuts, each is of the pieces that it is inside of.",
    .example = "taut split model.json --u 0.5 -o halves.json\n",
    .files_min = 1,
    .files_max = 1,
    .options = options_of_split,
    .run = run,
};
