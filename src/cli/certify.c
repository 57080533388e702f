/* certify.c -- taut certify: proves a saved model again. */
#include "cli/cli.h"
#include "cli/report.h"

#include <stdio.h>

/* Exchange formats hold surfaces and no more: what a reader misses who certifies one. */
static void say_what_is_missing(const char *file)
{
    fprintf(stderr,
            "taut: %s: note: this format keeps the surfaces alone, not the certificate, nor the "
            "witness that `least` is proved with: keep the model as .json too\n",
            file);
}

static int print_certificate(const cli_options *options, const taut_certificate *certificate,
                             const taut_model *model)
{
    const int holds = taut_certificate_holds(certificate) == TAUT_TRUE;
    int code = 0;
    if (options->json) {
        taut_record *record = taut_record_new();
        cli_certificate_record(record, NULL, certificate);
        code = cli_print_record(record);
    } else if (!options->quiet) {
        fprintf(stderr, "%s\n", taut_certificate_construct(certificate));
        cli_certificate_print(certificate, model);
        cli_verdict_print(certificate);
    } else if (!holds) {
        cli_verdict_print(certificate);
    }
    if (code == 0 && !options->quiet) {
        cli_warn_of_curvature(options->files[0], certificate);
    }
    return code == 0 && !holds ? 1 : code;
}

static int run(const cli_options *options)
{
    taut_certify_options chosen = {.tolerance = options->tolerance,
                                   .exact = options->exact,
                                   .monitor = cli_monitor(options->quiet || options->json)};
    taut_model *model = NULL;
    taut_problem *problem = NULL;
    taut_certificate *certificate = NULL;
    taut_error error;
    taut_status status = cli_read_model(options->files[0], options, &model, &error);
    int at = 0; /* the file that an error is about */
    int code = 0;

    if (status == TAUT_OK && !options->json && !options->quiet &&
        taut_model_certificate(model) == NULL && !cli_is_json(options->files[0])) {
        say_what_is_missing(options->files[0]);
    }
    if (status == TAUT_OK && options->file_count > 1) {
        at = 1;
        status = taut_problem_read(options->files[1], &problem, &error);
    }
    if (status == TAUT_OK) {
        at = 0;
        chosen.threads = cli_threads_of(options, model);
        status = taut_certify(model, problem, &chosen, &certificate, &error);
        cli_monitor_done();
    }
    code = status == TAUT_OK ? print_certificate(options, certificate, model)
                             : cli_fail_in(options->files[at], &error);
    taut_certificate_free(certificate);
    taut_problem_free(problem);
    taut_model_free(model);
    return code;
}

static const cli_option options_of_certify[] = {
    CLI_JSON,
    {"--quiet", CLI_FLAG, offsetof(cli_options, quiet), 0, 0, 0, NULL,
     "no report: a line where the certificate does not hold, and the exit code"},
    CLI_TOLERANCE,
    CLI_UNTRIM,
    CLI_THREADS,
    CLI_EXACT,
    CLI_LAST};

const cli_command cli_command_certify = {
    .name = "certify",
    .usage = "MODEL.json [PROBLEM.json] [--json] [--quiet]",
    .summary = "prove a saved model again, from its numbers alone",
    .text =
        "With the problem every claim is judged; without it those that the model alone decides.\n"
        "Exit 1 when a claim does not hold, and when one other than `least` is left undecided.\n",
    .example = "taut certify model.json problem.json\n",
    .files_min = 1,
    .files_max = 2,
    .options = options_of_certify,
    .run = run,
};
