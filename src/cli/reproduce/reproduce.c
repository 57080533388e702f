/* reproduce.c -- taut reproduce: every number a paper publishes beside ours. */
#include "cli/reproduce/reproduce.h"

#include "cli/cli.h"
#include "cli/embedded_files.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static void clear(cli_subject *subject)
{
    taut_certificate_free(subject->certificate);
    taut_model_free(subject->model);
    taut_problem_free(subject->problem);
    *subject = (cli_subject){NULL, NULL, NULL};
}

/* Makes the example that a row speaks of. */
static taut_status make(const char *name, cli_subject *subject, taut_error *error)
{
    const taut_embedded *file = cli_embedded_find(taut_examples, name);
    taut_status status = TAUT_OK;
    clear(subject);
    if (file == NULL) {
        *error = (taut_error){.status = TAUT_INTERNAL,
                              .reason = "fault",
                              .message = "a row names an example that is not there"};
        return TAUT_INTERNAL;
    }
    status = taut_problem_read_text(file->text, file->length, file->name, &subject->problem, error);
    if (status == TAUT_OK) {
        status = taut_make(subject->problem, NULL, &subject->model, error);
    }
    if (status == TAUT_OK) {
        status = taut_certify(subject->model, subject->problem, NULL, &subject->certificate, error);
    }
    return status;
}

static const char *text(const taut_record *row, const char *key)
{
    return taut_record_text(taut_record_get(row, key));
}

static double number(const taut_record *row, const char *key)
{
    return taut_record_number(taut_record_get(row, key));
}

/* "-0.2756", or a fraction such as "-5/12"; NaN if it is neither. */
static double printed_number(const char *word)
{
    char above[32];
    const size_t length = strcspn(word, "/");
    double a = (double)NAN, b = 1;
    if (length < sizeof above) {
        memcpy(above, word, length);
        above[length] = '\0';
        if (!cli_number(above, &a) || (word[length] == '/' && !cli_number(word + length + 1, &b))) {
            return (double)NAN;
        }
    }
    return a / b;
}

/* One row judged: added to `list` as a record. Returns whether ours is what it should be. */
static int judge_row(const char *paper, const taut_record *row, const cli_subject *subject,
                     taut_record *list)
{
    const char *erratum = text(row, "erratum");
    const double ours = cli_quantity(subject, text(row, "quantity"));
    const double tolerance = number(row, "tolerance");
    const double printed = printed_number(text(row, "printed"));
    const double right = erratum[0] != '\0' || isnan(printed) ? number(row, "expected") : printed;
    const int agrees = fabs(ours - right) <= tolerance;
    taut_record *out = taut_record_add_object(list, NULL);

    taut_record_add_text(out, "paper", paper);
    taut_record_add_text(out, "source", text(row, "source"));
    taut_record_add_text(out, "problem", text(row, "problem"));
    taut_record_add_text(out, "quantity", text(row, "quantity"));
    taut_record_add_number(out, "printed", printed);
    taut_record_add_text(out, "as_printed", text(row, "printed"));
    taut_record_add_number(out, "ours", ours);
    taut_record_add_number(out, "expected", right);
    taut_record_add_number(out, "tolerance", tolerance);
    taut_record_add_text(out, "verdict",
                         !agrees              ? "differs"
                         : erratum[0] != '\0' ? "erratum"
                         : isnan(printed)     ? "beyond the paper"
                                              : "agrees");
    taut_record_add_text(out, "erratum", erratum);
    return agrees;
}

/* All rows of one paper into `list`; *wrong counts those that are not what they should be. */
static taut_status reproduce(const taut_embedded *paper, taut_record *list, int *wrong,
                             taut_error *error)
{
    cli_subject subject = {NULL, NULL, NULL};
    taut_record *rows = NULL;
    const char *problem = "";
    taut_status status =
        taut_record_read_text(paper->text, paper->length, paper->name, &rows, error);

    for (size_t i = 0; status == TAUT_OK && i < taut_record_count(taut_record_get(rows, "rows"));
         i++) {
        const taut_record *row = taut_record_at(taut_record_get(rows, "rows"), i);
        if (strcmp(problem, text(row, "problem")) != 0) {
            problem = text(row, "problem");
            status = make(problem, &subject, error);
        }
        if (status == TAUT_OK) {
            *wrong += !judge_row(paper->name, row, &subject, list);
        }
    }
    clear(&subject);
    taut_record_free(rows);
    return status;
}

static void print_number(double value)
{
    if (isnan(value)) {
        printf(" %14s", "-");
    } else {
        printf(" %14.10g", value);
    }
}

static void print_table(const taut_record *list)
{
    const char *source = "";
    for (size_t i = 0; i < taut_record_count(list); i++) {
        const taut_record *row = taut_record_at(list, i);
        if (strcmp(source, text(row, "source")) != 0) {
            source = text(row, "source");
            printf("%s%s\n  %-26s %14s %14s  %s\n", i > 0 ? "\n" : "", source, "quantity",
                   "printed", "ours", "verdict");
        }
        printf("  %-26s", text(row, "quantity"));
        print_number(number(row, "printed"));
        print_number(number(row, "ours"));
        printf("  %s", text(row, "verdict"));
        if (text(row, "erratum")[0] != '\0') {
            printf(": %s", text(row, "erratum"));
        }
        putchar('\n');
    }
}

static int print_list(const cli_options *options, taut_record *list, int wrong)
{
    int code = 0;
    if (options->json) {
        code = cli_print_record(list);
    } else if (options->markdown) {
        cli_reproduction_page(list);
        taut_record_free(list);
        code = cli_print_text("", 0);
    } else {
        print_table(list);
        printf("\n%zu rows, %d that should agree and do not\n", taut_record_count(list), wrong);
        taut_record_free(list);
        code = cli_print_text("", 0);
    }
    return code == 0 && wrong > 0 ? 1 : code;
}

static int run(const cli_options *options)
{
    const taut_embedded *only = NULL;
    taut_record *list = NULL;
    taut_status status = TAUT_OK;
    taut_error error;
    int wrong = 0;

    if (options->file_count > 0) {
        only = cli_embedded_find(taut_papers, options->files[0]);
        if (only == NULL) {
            return cli_embedded_unknown(taut_papers, "paper", options->files[0]);
        }
    }
    list = taut_record_new_list();
    for (const taut_embedded *paper = taut_papers; paper->name != NULL && status == TAUT_OK;
         paper++) {
        if (only == NULL || paper == only) {
            status = reproduce(paper, list, &wrong, &error);
        }
    }
    if (status != TAUT_OK) {
        taut_record_free(list);
        return cli_fail(&error);
    }
    return print_list(options, list, wrong);
}

static const cli_option options_of_reproduce[] = {
    CLI_JSON,
    {"--markdown", CLI_FLAG, offsetof(cli_options, markdown), 0, 0, 0, NULL,
     "print a page, with a summary of each paper first"},
    CLI_THREADS,
    CLI_LAST};

const cli_command cli_command_reproduce = {
    .name = "reproduce",
    .usage = "[PAPER] [--json | --markdown]",
    .summary = "every number the papers print, beside ours",
    .text = "Verdicts: agrees (to half a unit of the last digit printed); erratum (the paper is "
            "wrong: ours is\n"
            "what is right, or shows how the printed number arose); beyond the paper; differs "
            "(exit 1).\n",
    .example = "taut reproduce dirichlet\n",
    .files_min = 0,
    .files_max = 1,
    .options = options_of_reproduce,
    .run = run,
};
