/* split.c -- taut split: cuts the surfaces of a model at a parameter. */
#include "cli/cli.h"

static int run(const cli_options *options)
{
    const int along_v = options->text_v != NULL;
    const char *word = along_v ? options->text_v : options->text_u;
    taut_model *model = NULL, *split = NULL;
    taut_error error;
    taut_status (*cut)(const taut_model *, const char *, int, double, taut_model **, taut_error *) =
        options->exact ? taut_model_split_exact : taut_model_split;
    double t = 0;
    cli_options all = *options; /* what is written: every surface */
    int code = 0;

    all.surface = NULL;
    if ((options->text_u != NULL) == along_v) {
        return cli_misuse("option", "`taut split` needs one of --u T and --v T");
    }
    if (!cli_number(word, &t)) {
        return cli_misuse_value(along_v ? "--v" : "--u", word, "a number");
    }
    code = cli_check_outputs(options);
    if (code != 0) {
        return code;
    }
    if (cli_read_model(options->files[0], options, &model, &error) != TAUT_OK) {
        return cli_fail_in(options->files[0], &error);
    }
    code = cut(model, options->surface, along_v ? TAUT_ALONG_V : TAUT_ALONG_U, t, &split, &error) ==
                   TAUT_OK
               ? cli_write_model(split, &all)
               : cli_fail_in(options->files[0], &error);
    taut_model_free(split);
    taut_model_free(model);
    return code;
}

static const cli_option options_of_split[] = {
    {"--u", CLI_TEXT, offsetof(cli_options, text_u), 0, 0, 0, "T", "cut along u at T"},
    {"--v", CLI_TEXT, offsetof(cli_options, text_v), 0, 0, 0, "T", "cut along v at T"},
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
    .text =
        "Every surface gives its low piece, then its high one, with names of their own; the pieces "
        "keep\n"
        "their parameters. A c- or h-bspline cut off its knots opens into c- or h-bezier pieces.\n",
    .example = "taut split model.json --u 0.5 -o halves.json\n",
    .files_min = 1,
    .files_max = 1,
    .options = options_of_split,
    .run = run,
};
