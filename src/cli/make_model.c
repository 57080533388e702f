/* make_model.c -- one problem made and proved, for `make` and for its lists. */
#include "cli/make.h"

#include <stdio.h>
#include <string.h>

int cli_make_model(const taut_problem *problem, const cli_options *options, const char *place,
                   cli_made *made)
{
    const taut_make_options chosen = {.tolerance = options->tolerance,
                                      .threads = cli_threads_to_make(options, problem),
                                      .monitor = cli_monitor(options->quiet || options->json),
                                      .exact = options->exact,
                                      .time_limit = options->time_limit};
    taut_certify_options proof = {
        .tolerance = options->tolerance, .exact = options->exact, .monitor = chosen.monitor};
    cli_report *report = &made->report;
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_error error;
    const double start = cli_seconds();
    taut_status status = taut_make(problem, &chosen, &model, &error);

    report->construct = taut_problem_construction(problem);
    report->seconds_made = cli_seconds() - start;
    if (status == TAUT_OK) {
        proof.threads = cli_threads_of(options, model);
        status = taut_certify(model, problem, &proof, &certificate, &error);
        report->seconds_proved = cli_seconds() - start - report->seconds_made;
    }
    if (status != TAUT_OK) {
        taut_model_free(model);
        if (error.where[0] == '\0' || error.where[0] == '/') {
            char where[sizeof error.where];
            snprintf(where, sizeof where, "%s%.100s", place, error.where);
            memcpy(error.where, where, sizeof where);
        }
        return options->words != NULL ? cli_fail_in_words(options->words, options->files[0], &error)
                                      : cli_fail_in(options->files[0], &error);
    }
    taut_model_set_certificate(model, certificate);
    report->model = made->model = model;
    report->certificate = certificate;
    return 0;
}
