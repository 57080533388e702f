/* convert.c -- taut convert: a model into other formats. */
#include "cli.h"

static int run(const cli_options *options)
{
    taut_model *model = NULL;
    taut_error error;
    int code = cli_check_outputs(options);

    if (code == 0 && options->output_count == 0) {
        code = cli_misuse("`taut convert` needs at least one -o FILE");
    }
    if (code != 0) {
        return code;
    }
    if (taut_model_read(options->files[0], &model, &error) != TAUT_OK) {
        return cli_fail_in(options->files[0], &error);
    }
    code = cli_write_model(model, options);
    taut_model_free(model);
    return code;
}

static const cli_option options_of_convert[] = {CLI_OUTPUT,  CLI_TOLERANCE, CLI_DIVIDE,
                                                CLI_SURFACE, CLI_FIGURE,    CLI_SHORT_KNOTS,
                                                CLI_THREADS, CLI_LAST};

const cli_command cli_command_convert = {
    .name = "convert",
    .usage = "MODEL.json -o FILE... [--tolerance T] [--divide N]",
    .summary = "write a model in other formats",
    .text = "The ending of FILE says the format.\n",
    .files_min = 1,
    .files_max = 1,
    .options = options_of_convert,
    .run = run,
};
