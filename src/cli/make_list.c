/* make_list.c -- taut make on a list of problems: a list of models, or a file for each.
 *
 * All documents are read before any is made, all are made before any file appears: one that is
 * wrong, or asks for what does not exist, leaves nothing.
 */
#include "cli/make.h"
#include "platform/system.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINES = 8 }; /* documents that the table shows though they hold */

typedef struct batch {
    const cli_options *options;
    int count;
    cli_made *made;       /* [count] */
    char **paths;         /* [count][outputs + 1]: what goes where, for the reports */
    double *bounds;       /* the same shape */
    double seconds_lists; /* writing what holds all of them */
} batch;

/* The % of a file's name that its number takes the place of, or NULL; folders keep theirs. */
static const char *percent_of(const char *path)
{
    return strchr(taut_system_last_part(path), '%');
}

/* Does all of the list go into this one file? */
static int holds_all(const char *path)
{
    return cli_is_json(path) && percent_of(path) == NULL;
}

/* The path of document i: its number, with as many digits as the last one has, for the first % or
 * before the ending. The caller's; NULL: no memory. */
static char *numbered(const char *path, int i, int count)
{
    const char *percent = percent_of(path);
    const size_t room = strlen(path) + 16;
    const int digits = snprintf(NULL, 0, "%d", count - 1);
    char *made = malloc(room);
    if (made == NULL || holds_all(path)) {
        return made != NULL ? strcpy(made, path) : NULL;
    }
    if (percent != NULL) {
        snprintf(made, room, "%.*s%0*d%s", (int)(percent - path), path, digits, i, percent + 1);
    } else { /* the ending, which may have a dot of its own, says the format */
        const char *ending = taut_formats_ending(taut_draw_formats(), path, NULL);
        const int stem = (int)(strlen(path) - strlen(ending)) - 1;
        snprintf(made, room, "%.*s-%0*d%s", stem, path, digits, i, path + stem);
    }
    return made;
}

/* Stages what goes into files of their own. */
static int stage_one(batch *b, taut_outputs *outputs, taut_write_options *chosen, int i)
{
    cli_report *report = &b->made[i].report;
    const size_t first = (size_t)i * ((size_t)b->options->output_count + 1);
    const double start = cli_seconds();
    const int holds = taut_certificate_holds(report->certificate) != TAUT_FALSE;
    int code = 0;

    report->outputs = (const char *const *)(b->paths + first);
    report->bounds = b->bounds + first;
    for (int k = 0; code == 0 && k < b->options->output_count; k++) {
        const char *path = b->options->outputs[k];
        const size_t at = first + (size_t)report->output_count;
        taut_error error;
        if (!holds && !cli_is_json(path)) {
            continue;
        }
        b->paths[at] = numbered(path, i, b->count);
        b->bounds[at] = (double)NAN;
        if (b->paths[at] == NULL) {
            return cli_no_memory();
        }
        report->output_count++;
        chosen->bound = &b->bounds[at];
        if (!holds_all(path) && taut_outputs_model(outputs, b->made[i].model, b->paths[at], chosen,
                                                   &error) != TAUT_OK) {
            code = cli_fail_at(b->paths[at], &error);
        }
    }
    report->seconds_written = cli_seconds() - start;
    return code;
}

/* Stages the lists of all models. */
static int stage_lists(batch *b, taut_outputs *outputs, const taut_write_options *chosen)
{
    const double start = cli_seconds();
    const taut_model **models = malloc((size_t)b->count * sizeof *models);
    const int asked = b->options->output_count;
    int code = models != NULL ? 0 : cli_no_memory();

    for (int i = 0; code == 0 && i < b->count; i++) {
        models[i] = b->made[i].model;
    }
    for (int k = 0; code == 0 && k < (asked > 0 ? asked : 1); k++) {
        const char *path = asked > 0 ? b->options->outputs[k] : "-";
        taut_error error;
        if (holds_all(path) &&
            taut_outputs_models(outputs, b->count, models, path, chosen, &error) != TAUT_OK) {
            code = cli_fail_at(path, &error);
        }
    }
    free(models);
    b->seconds_lists = cli_seconds() - start;
    return code;
}

/* The reports of all, as a list: the caller's; NULL: no memory. */
static taut_record *new_reports(const batch *b)
{
    taut_record *list = taut_record_new_list();
    int is_whole = 1;
    for (int i = 0; i < b->count; i++) {
        taut_record *record = cli_report_record(&b->made[i].report);
        taut_record_add_record(list, NULL, record);
        is_whole &= taut_record_status(record) == TAUT_OK;
        taut_record_free(record);
    }
    if (!is_whole || taut_record_status(list) != TAUT_OK) {
        taut_record_free(list);
        return NULL;
    }
    return list;
}

static int stage_report(const batch *b, taut_outputs *outputs)
{
    taut_record *list = new_reports(b);
    taut_error error;
    taut_status status = TAUT_OK;
    if (list == NULL) {
        return cli_no_memory();
    }
    status = taut_outputs_record(outputs, list, b->options->report, &error);
    taut_record_free(list);
    return status == TAUT_OK ? 0 : cli_fail_at(b->options->report, &error);
}

static void print_one(const batch *b, int i)
{
    const taut_certificate *certificate = b->made[i].report.certificate;
    const taut_verdict holds = taut_certificate_holds(certificate);
    char place[16];
    snprintf(place, sizeof place, "/%d", i);
    fprintf(stderr, "  %-22s%s %s, made %.2g ms, proved %.2g ms\n", place,
            b->made[i].report.construct,
            holds == TAUT_TRUE    ? "holds"
            : holds == TAUT_FALSE ? "DOES NOT HOLD"
                                  : "undecided",
            1e3 * b->made[i].report.seconds_made, 1e3 * b->made[i].report.seconds_proved);
    for (int k = 0; k < taut_certificate_claim_count(certificate); k++) {
        const taut_claim *claim = taut_certificate_claim(certificate, k);
        if (claim->holds == TAUT_FALSE) {
            fprintf(stderr, "  %-22s%s: %.3g, limit %.3g%s%s\n", "", claim->claim, claim->residual,
                    claim->limit, claim->where[0] != '\0' ? ", at " : "", claim->where);
        }
    }
}

/* A line for each that does not hold and for the first of the others; then totals. */
static void print(const batch *b)
{
    double made = 0, proved = 0, written = b->seconds_lists;
    int shown = 0;

    fprintf(stderr, "%d problems\n", b->count);
    for (int i = 0; i < b->count; i++) {
        const cli_report *report = &b->made[i].report;
        made += report->seconds_made;
        proved += report->seconds_proved;
        written += report->seconds_written;
        if (shown < LINES || taut_certificate_holds(report->certificate) != TAUT_TRUE) {
            print_one(b, i);
            shown++;
        }
    }
    if (shown < b->count) {
        fprintf(stderr, "  %-22s%d more that hold\n", "...", b->count - shown);
    }
    fprintf(stderr, "  %-22smade %.3g s, proved %.3g s, written %.3g s\n", "time", made, proved,
            written);
    for (int k = 0; k < b->options->output_count; k++) {
        const char *path = b->options->outputs[k];
        fprintf(stderr, "  %-22s%s%s\n", k == 0 ? "written" : "", path,
                holds_all(path) ? "" : ", numbered");
    }
}

/* Writes everything and tells what happened. */
static int deliver(batch *b)
{
    taut_write_options chosen;
    taut_outputs *outputs = NULL;
    int code = cli_write_options(b->options, &chosen);

    if (code == 0) {
        code = cli_outputs_new(&outputs);
    }
    for (int i = 0; code == 0 && i < b->count; i++) {
        code = stage_one(b, outputs, &chosen, i);
    }
    if (code == 0) {
        chosen.bound = NULL;
        code = stage_lists(b, outputs, &chosen);
    }
    if (code == 0 && b->options->report != NULL) {
        code = stage_report(b, outputs);
    }
    if (code == 0) {
        code = cli_commit(outputs);
    }
    cli_outputs_free(outputs);
    cli_monitor_done();
    if (code == 0 && !b->options->quiet && b->options->json) {
        code = cli_report_json(new_reports(b));
    } else if (code == 0 && !b->options->quiet) {
        print(b);
    }
    for (int i = 0; code == 0 && i < b->count; i++) {
        code = taut_certificate_holds(b->made[i].report.certificate) == TAUT_FALSE;
    }
    return code;
}

int cli_make_list(const taut_problem_list *list, const cli_options *options)
{
    batch b = {.options = options, .count = taut_problem_list_count(list)};
    const size_t rows = (size_t)b.count, row = (size_t)options->output_count + 1;
    int code = 0;

    b.made = calloc(rows, sizeof *b.made);
    b.paths = calloc(rows * row, sizeof *b.paths);
    b.bounds = calloc(rows * row, sizeof *b.bounds);
    if (b.made == NULL || b.paths == NULL || b.bounds == NULL) {
        code = cli_no_memory();
    }
    for (int i = 0; code == 0 && i < b.count; i++) {
        char place[16];
        snprintf(place, sizeof place, "/%d", i);
        code = cli_make_model(taut_problem_list_at(list, i), options, place, &b.made[i]);
    }
    if (code == 0) {
        code = deliver(&b);
    }
    for (size_t i = 0; b.made != NULL && i < rows; i++) {
        taut_model_free(b.made[i].model);
    }
    for (size_t k = 0; b.paths != NULL && k < rows * row; k++) {
        free(b.paths[k]);
    }
    free(b.made);
    free(b.paths);
    free(b.bounds);
    return code;
}
