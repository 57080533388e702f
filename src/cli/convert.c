/* convert.c -- taut convert: a model into other formats. */
#include "cli.h"

/* With --tolerance, JSON holds NURBS too: the model within the tolerance of every surface's size.
 */
static int wants_nurbs(const cli_options *options)
{
    int wanted = 0;
    for (int i = 0; i < options->output_count && options->tolerance > 0; i++) {
        wanted |= cli_is_json(options->outputs[i]);
    }
    return wanted;
}

static int run(const cli_options *options)
{
    taut_model *model = NULL, *nurbs = NULL;
    double bound = 0;
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
    if (wants_nurbs(options) &&
        taut_model_to_nurbs(model, options->tolerance, &nurbs, &bound, &error) != TAUT_OK) {
        code = cli_fail_in(options->files[0], &error);
    } else {
        code = cli_write_models(model, nurbs, bound, options);
    }
    taut_model_free(nurbs);
    taut_model_free(model);
    return code;
}

static const cli_option options_of_convert[] = {CLI_OUTPUT, CLI_TOLERANCE, CLI_DIVIDE, CLI_SURFACE,
                                                CLI_FIGURE, CLI_THREADS,   CLI_LAST};

const cli_command cli_command_convert = {
    .name = "convert",
    .usage = "MODEL.json -o FILE... [--tolerance T] [--divide N]",
    .summary = "write a model in other formats",
    .text = "The ending of FILE says the format. With --tolerance, JSON too holds NURBS, within a "
            "distance that is\nproved and printed; without it the model itself.\n",
    .files_min = 1,
    .files_max = 1,
    .options = options_of_convert,
    .run = run,
};
