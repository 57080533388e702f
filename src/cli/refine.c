/* refine.c -- taut refine: halves every knot span without changing the surface. */
#include "cli/cli.h"

static int run(const cli_options *options)
{
    taut_model *model = NULL, *refined = NULL;
    taut_error error;
    cli_options all = *options; /* what is written: every surface */
    int code = cli_check_outputs(options);

    all.surface = NULL;
    if (code != 0) {
        return code;
    }
    if (cli_read_model(options->files[0], options, &model, &error) != TAUT_OK) {
        return cli_fail_in(options->files[0], &error);
    }
    code = taut_model_refine(model, options->surface, options->flag_u, options->flag_v, &refined,
                             &error) == TAUT_OK
               ? cli_write_model(refined, &all)
               : cli_fail_in(options->files[0], &error);
    taut_model_free(refined);
    taut_model_free(model);
    return code;
}

static const cli_option options_of_refine[] = {
    {"--u", CLI_FLAG, offsetof(cli_options, flag_u), 0, 0, 0, NULL, "along u only"},
    {"--v", CLI_FLAG, offsetof(cli_options, flag_v), 0, 0, 0, NULL, "along v only"},
    CLI_OUTPUT,
    CLI_SURFACE,
    CLI_UNTRIM,
    CLI_THREADS,
    CLI_LAST};

const cli_command cli_command_refine = {
    .name = "refine",
    .usage = "MODEL.json [--u] [--v] [-o FILE]",
    .summary = "halve every knot span; the surface stays the same",
    .text =
        "Without --u and --v both directions are refined. A c- or h-bezier direction becomes the\n"
        "bspline of two segments.\n",
    .example = "taut refine model.json --u -o finer.json\n",
    .files_min = 1,
    .files_max = 1,
    .options = options_of_refine,
    .run = run,
};
