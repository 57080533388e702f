/* make.c -- taut make: document -> problem -> model -> certificate -> files and a report. */
#include "cli/make.h"
#include "cli/cli.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Stages the model in every output, and the report; 0 or the exit code. */
static int stage(taut_outputs *outputs, const cli_options *options, cli_report *report,
                 const char **written, double *bounds)
{
    const int holds = taut_certificate_holds(report->certificate) != TAUT_FALSE;
    const taut_model *model = report->model;
    taut_write_options chosen;
    taut_model *strips = NULL;
    taut_error error;
    int code = cli_write_options(options, &chosen);

    chosen.threads = cli_threads_of(options, model);
    report->outputs = written;
    report->bounds = bounds;
    if (code == 0 && options->output_count == 0 &&
        taut_outputs_model(outputs, report->model, "-", &chosen, &error) != TAUT_OK) {
        code = cli_fail(&error);
    }
    for (int i = 0; i < options->output_count && code == 0; i++) {
        if (!holds && !cli_is_json(options->outputs[i])) { /* nobody builds from such a picture */
            continue;
        }
        bounds[report->output_count] = (double)NAN;
        chosen.bound = &bounds[report->output_count];
        code = cli_strips(report->model, options, options->outputs[i], &strips, &model);
        chosen.surface = model == report->model ? options->surface : NULL;
        if (code == 0 &&
            taut_outputs_model(outputs, model, options->outputs[i], &chosen, &error) != TAUT_OK) {
            code = cli_fail_at(options->outputs[i], &error);
        }
        written[report->output_count++] = options->outputs[i];
    }
    taut_model_free(strips);
    return code;
}

static int stage_report(taut_outputs *outputs, const char *path, const cli_report *report)
{
    taut_record *record = cli_report_record(report);
    taut_error error;
    const int is_whole = taut_record_status(record) == TAUT_OK;
    const taut_status status =
        is_whole ? taut_outputs_record(outputs, record, path, &error) : TAUT_NO_MEMORY;
    taut_record_free(record);
    return !is_whole ? cli_no_memory() : status == TAUT_OK ? 0 : cli_fail_at(path, &error);
}

/* Why it ends with 1: the claims that are false, and the files that are not there therefore. */
static void say_false(const cli_options *options, const taut_certificate *certificate)
{
    int left_out = 0;

    fprintf(stderr, "taut: not all claims hold:");
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *claim = taut_certificate_claim(certificate, i);
        if (claim->holds == TAUT_FALSE) {
            fprintf(stderr, " %.60s", claim->claim);
        }
    }
    for (int i = 0; i < options->output_count; i++) {
        if (!cli_is_json(options->outputs[i])) {
            fprintf(stderr, "%s %s", left_out == 0 ? "; only JSON is written then, not" : ",",
                    options->outputs[i]);
            left_out++;
        }
    }
    fprintf(stderr, "\n");
}

/* Writes everything and tells what happened. */
static int deliver(const cli_options *options, cli_report *report)
{
    const size_t room = (size_t)options->output_count + 1;
    const char **written = calloc(room, sizeof *written);
    double *bounds = calloc(room, sizeof *bounds);
    taut_outputs *outputs = NULL;
    const double start = cli_seconds();
    int code = written == NULL || bounds == NULL ? cli_no_memory() : cli_outputs_new(&outputs);

    if (code == 0) {
        code = stage(outputs, options, report, written, bounds);
    }
    report->seconds_written = cli_seconds() - start;
    if (code == 0 && options->report != NULL) {
        code = stage_report(outputs, options->report, report);
    }
    if (code == 0) {
        code = cli_commit(outputs);
    }
    cli_outputs_free(outputs);
    cli_monitor_done();
    if (code == 0 && !options->quiet && options->json) {
        code = cli_report_json(cli_report_record(report));
    } else if (code == 0 && !options->quiet) {
        cli_report_print(report);
    }
    if (code == 0 && !options->quiet) {
        cli_warn_of_curvature(options->files[0], report->certificate);
    }
    if (code == 0 && taut_certificate_holds(report->certificate) == TAUT_FALSE) {
        if (!options->json) {
            say_false(options, report->certificate);
        }
        code = 1;
    }
    free(bounds);
    free(written);
    return code;
}

int cli_make_one(const taut_problem *problem, const cli_options *options)
{
    cli_made made = {.model = NULL};
    int code = cli_make_model(problem, options, "", &made);
    if (code == 0) {
        code = deliver(options, &made.report);
    }
    taut_model_free(made.model);
    return code;
}

static int make(const cli_options *options)
{
    taut_problem_list *list = NULL;
    taut_error error;
    int code = 0;

    if (taut_problem_list_read(options->files[0], &list, &error) != TAUT_OK) {
        return cli_fail_in(options->files[0], &error);
    }
    code = taut_problem_list_is_list(list) ? cli_make_list(list, options)
                                           : cli_make_one(taut_problem_list_at(list, 0), options);
    taut_problem_list_free(list);
    return code;
}

static int run(const cli_options *options)
{
    int code = 0;
    if (options->watch && (options->lines || options->output_count == 0)) {
        return cli_misuse("option", options->lines ? "--watch makes one document, not --lines"
                                                   : "--watch needs a file to write: -o FILE");
    }
    if (options->watch && strcmp(options->files[0], "-") == 0) {
        return cli_misuse("operand", "--watch needs the name of a file, not standard input");
    }
    if (options->lines) {
        return cli_make_lines(options);
    }
    code = cli_check_outputs(options);
    return code != 0 ? code : options->watch ? cli_watch(options, make) : make(options);
}

static const cli_option options_of_make[] = {
    CLI_OUTPUT,
    {"--report", CLI_TEXT, offsetof(cli_options, report), 0, 0, 0, "FILE",
     "write the report as JSON"},
    CLI_TOLERANCE,
    {"--time-limit", CLI_NUMBER, offsetof(cli_options, time_limit), 0, 1e-6, 1e9, "S",
     "end each making after S seconds with the best so far, which need not pass its proof"},
    CLI_DIVIDE,
    CLI_SHEET,
    CLI_SOLID,
    CLI_COEFFICIENTS,
    CLI_LAGRANGE,
    CLI_THREADS,
    CLI_FIGURE,
    CLI_EXACT,
    {"--lines", CLI_FLAG, offsetof(cli_options, lines), 0, 0, 0, NULL,
     "one problem per line, one model or error per line; goes on where it was stopped"},
    {"--watch", CLI_FLAG, offsetof(cli_options, watch), 0, 0, 0, NULL,
     "make again whenever the file is saved, until Ctrl-C"},
    {"--json", CLI_FLAG, offsetof(cli_options, json), 0, 0, 0, NULL,
     "report and errors as JSON on standard error"},
    {"--quiet", CLI_FLAG, offsetof(cli_options, quiet), 0, 0, 0, NULL, "no report"},
    CLI_LAST};

const cli_command cli_command_make = {
    .name = "make",
    .usage = "PROBLEM.json [-o FILE]... [--report FILE] [--tolerance T] [--quiet] [--json]",
    .summary = "build the surface a problem asks for, and prove it",
    .text = "Reads a problem (- is standard input), builds its model, proves it, and writes it to "
            "every FILE in the format of its ending; without -o as JSON to standard output. The "
            "report goes to standard error. A claim that does not hold is exit 1, and only JSON "
            "outputs are written. A JSON list of problems gives a list of models; formats that "
            "hold one model a file give FILE-0.obj, FILE-1.obj, ... A % in the name takes the "
            "number, in JSON too. One that fails leaves no file of any. With --lines each line is "
            "a problem, and each line out a model (JSON Lines); one that fails is a line too; "
            "started again it makes the lines that are missing. With --watch it goes on: each "
            "time the file is saved it is made again.",
    .example = "taut make tent.json -o model.json -o model.step -o model.png\n"
               "taut make --watch tent.json -o model.html\n",
    .files_min = 1,
    .files_max = 1,
    .options = options_of_make,
    .run = run,
};
