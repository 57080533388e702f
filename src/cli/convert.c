/* convert.c -- taut convert: a model into other formats. */
#include "cli/cli.h"

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

/* Reads every model and writes them side by side. */
static int run_many(const cli_options *options)
{
    taut_model *models[TAUT_MODELS_MAX] = {NULL};
    const taut_model *written[TAUT_MODELS_MAX];
    taut_error error;
    int count = 0, code = 0;

    for (int i = 0; i < options->file_count && code == 0; i++) {
        if (cli_read_model(options->files[i], options, &models[i], &error) != TAUT_OK) {
            code = cli_fail_in(options->files[i], &error);
        } else {
            code = cli_one_unit(options->files[i], models[0], &models[i], 0);
            cli_prove_again(options->files[i], models[i], options);
            written[count++] = models[i];
        }
    }
    if (code == 0) {
        code = cli_write_models(count, written, options);
    }
    for (int i = 0; i < count; i++) {
        taut_model_free(models[i]);
    }
    return code;
}

/* The model, or with --pieces its spans. */
static taut_status read_model(const cli_options *options, taut_model **model, taut_error *error)
{
    taut_model *whole = NULL;
    taut_status status = cli_read_model(options->files[0], options, &whole, error);
    if (status != TAUT_OK || !options->pieces) {
        *model = whole;
        return status;
    }
    status = taut_model_pieces(whole, options->surface, model, error);
    taut_model_free(whole);
    return status;
}

static int run(const cli_options *options)
{
    taut_model *model = NULL, *nurbs = NULL, *shown = NULL;
    double bound = 0;
    taut_error error;
    cli_options all = *options; /* pieces have names of their own */
    int code = cli_check_outputs(options);

    if (code == 0 && options->output_count == 0) {
        code = cli_misuse("option", "`taut convert` needs at least one -o FILE");
    }
    if (code != 0) {
        return code;
    }
    if (options->file_count > 1 && options->pieces) {
        return cli_misuse("operand", "--pieces takes one model at a time");
    }
    if (options->file_count > 1) {
        return run_many(options);
    }
    if (read_model(options, &model, &error) != TAUT_OK) {
        return cli_fail_in(options->files[0], &error);
    }
    all.surface = options->pieces ? NULL : options->surface;
    code = cli_prove_for_outputs(options->files[0], &model, options, &shown);
    if (code == 0 && wants_nurbs(options) &&
        taut_model_to_nurbs(model, options->tolerance, &nurbs, &bound, &error) != TAUT_OK) {
        code = cli_fail_in(options->files[0], &error);
    }
    code = code == 0 ? cli_write_or_nurbs(model, nurbs, bound, shown, &all) : code;
    taut_model_free(shown);
    taut_model_free(nurbs);
    taut_model_free(model);
    return code;
}

static const cli_option options_of_convert[] = {
    CLI_OUTPUT,
    CLI_TOLERANCE,
    CLI_DIVIDE,
    CLI_SHEET,
    CLI_SOLID,
    CLI_COEFFICIENTS,
    CLI_LAGRANGE,
    {"--pieces", CLI_FLAG, offsetof(cli_options, pieces), 0, 0, 0, NULL,
     "every knot span on its own, on bezier, c-bezier or h-bezier bases"},
    CLI_SURFACE,
    CLI_FIGURE,
    CLI_SHORT_KNOTS,
    CLI_UNTRIM,
    CLI_THREADS,
    {"--quiet", CLI_FLAG, offsetof(cli_options, quiet), 0, 0, 0, NULL,
     "no word of how near a file is to the model; warnings stay"},
    CLI_LAST};

const cli_command cli_command_convert = {
    .name = "convert",
    .usage = "MODEL.json... -o FILE... [--tolerance T] [--divide N] [--pieces] [--quiet]",
    .summary = "write a model in other formats",
    .text = "The ending of FILE says the format. With --tolerance, JSON too holds NURBS, within a "
            "distance that is proved and printed; without it the model itself. Several models go "
            "side by side into one figure (.svg, .pdf, .png). With --pieces a spline comes as its "
            "Bezier patches, a ce-bezier as its quartic bezier.",
    .example = "taut convert model.json -o model.step -o model.png --colour H\n",
    .files_min = 1,
    .files_max = TAUT_MODELS_MAX,
    .options = options_of_convert,
    .run = run,
};
