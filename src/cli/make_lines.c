/* make_lines.c -- taut make --lines: one problem a line in, one model or one error a line out, in order.
 *
 * The output is the one that grows in place. What ends before its time leaves whole lines and perhaps one that is broken: started
 * again, that one is cut off, and the lines that are there are not made again. Blank lines of the input are passed over.
 */
#include "cli/cli.h"
#include "cli/make.h"
#include "platform/system.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROOM_FIRST = 1 << 16 };
static const char error_begin[] = "{ \"error\":"; /* of a line; no model begins so */

typedef struct lines {
    const cli_options *options;
    const char *name; /* of the input, for messages */
    taut_source in;
    FILE *out;
    char *text; /* what was read and not yet used: the next line begins at `first` */
    size_t first, end, room;
    int is_over;    /* the input has no more bytes */
    int64_t number; /* of the line that was taken last, from 1 */
    int64_t there, made, errors, false_claims;
} lines;

static int fail(const char *path, const char *reason, int number)
{
    taut_error error = {.status = TAUT_IO, .found = (double)NAN, .limit = (double)NAN};
    char said[128];
    snprintf(error.reason, sizeof error.reason, "%s", reason);
    snprintf(error.where, sizeof error.where, "%.180s", path);
    snprintf(error.message, sizeof error.message, "%s",
             taut_system_reason(number, said, sizeof said));
    return cli_fail(&error);
}

/* Room for more of a line that is longer than all there is. */
static int make_room(lines *l)
{
    char *larger = NULL;
    if (l->first > 0) {
        memmove(l->text, l->text + l->first, l->end - l->first);
        l->end -= l->first;
        l->first = 0;
    }
    if (l->end < l->room) {
        return 0;
    }
    if ((double)l->room > TAUT_FILE_MAX) {
        return fail(l->name, "large", EFBIG);
    }
    larger = realloc(l->text, 2 * l->room);
    if (larger == NULL) {
        return cli_no_memory();
    }
    l->text = larger;
    l->room *= 2;
    return 0;
}

/* The next line, without its end: borrowed until the next call. *line is NULL behind the last one. */
static int next_line(lines *l, const char **line, size_t *length)
{
    size_t looked = 0;
    *line = NULL;
    for (;;) {
        char *at = l->text + l->first;
        const char *end = memchr(at + looked, '\n', l->end - l->first - looked);
        if (end != NULL || (l->is_over && l->end > l->first)) {
            *line = at;
            *length = end != NULL ? (size_t)(end - at) : l->end - l->first;
            l->first += *length + (end != NULL);
            l->number++;
            return 0;
        }
        if (l->is_over) {
            return 0;
        }
        looked = l->end - l->first;
        const int code = make_room(l);
        if (code != 0) {
            return code;
        }
        size_t count = 0;
        const int reason = taut_system_read(&l->in, l->text + l->end, l->room - l->end, &count);
        if (reason != 0) {
            return fail(l->name, "read", reason);
        }
        l->end += count;
        l->is_over = count == 0;
    }
}

/* The next line that says something. */
static int next_problem(lines *l, const char **line, size_t *length)
{
    int code = 0;
    do {
        code = next_line(l, line, length);
    } while (code == 0 && *line != NULL && strspn(*line, " \t\r") >= *length);
    return code;
}

/* Whole lines that the output has from before; the rest of it is cut off. */
static int go_on(lines *l, const char *path)
{
    double whole = 0, at = 0;
    size_t begin = 0; /* letters of error_begin that the line has begun with */
    int begins = 1, c;
    while ((c = fgetc(l->out)) != EOF) {
        at++;
        if (c == '\n') {
            l->errors += begin == sizeof error_begin - 1;
            l->there++;
            whole = at;
            begin = 0;
            begins = 1;
        } else if (begins && begin < sizeof error_begin - 1) {
            begins = c == error_begin[begin];
            begin += (size_t)begins;
        }
    }
    if (ferror(l->out)) {
        return fail(path, "read", errno);
    }
    const int reason = taut_system_cut(l->out, whole);
    return reason == 0 ? 0 : fail(path, "write", reason);
}

static int put(lines *l, char *text, size_t length)
{
    length = cli_one_line(text, length);
    if (fwrite(text, 1, length, l->out) != length || fputc('\n', l->out) == EOF ||
        fflush(l->out) != 0) {
        return fail(l->options->output_count > 0 ? l->options->outputs[0] : "standard output",
                    "write", errno);
    }
    return 0;
}

static int put_error(lines *l, const taut_error *error)
{
    taut_record *record = cli_error_record(error, error->where);
    char *text = NULL;
    size_t length = 0;
    int code = 0;
    if (error->status == TAUT_INTERRUPTED || error->status == TAUT_NO_MEMORY) {
        code = cli_fail(error); /* no fault of this line's: it is made another time */
    } else if (taut_record_status(record) != TAUT_OK ||
               taut_record_write(record, &text, &length) != TAUT_OK) {
        code = cli_no_memory();
    } else {
        l->errors++;
        code = put(l, text, length);
    }
    taut_text_free(text);
    taut_record_free(record);
    return code;
}

static taut_status prove(const taut_problem *problem, const cli_options *options,
                         taut_model **model, taut_error *error)
{
    const taut_make_options chosen = {.tolerance = options->tolerance,
                                      .threads = options->threads,
                                      .monitor = cli_monitor(1),
                                      .exact = options->exact};
    const taut_certify_options proof = {
        .threads = options->threads, .tolerance = options->tolerance, .exact = options->exact};
    taut_certificate *certificate = NULL;
    taut_status status = taut_make(problem, &chosen, model, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_certify(*model, problem, &proof, &certificate, error);
    if (status == TAUT_OK) {
        taut_model_set_certificate(*model, certificate);
    }
    return status;
}

/* One line. */
static int make_one(lines *l, const char *line, size_t length)
{
    const taut_write_options written = {.threads = l->options->threads,
                                        .short_knots = l->options->short_knots};
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_error error;
    char name[TAUT_PATH_ROOM], *text = NULL;
    size_t size = 0;
    int code = 0;

    snprintf(name, sizeof name, "%.4000s:%" PRId64, l->name, l->number);
    taut_status status = taut_problem_read_text(line, length, name, &problem, &error);
    if (status == TAUT_OK) {
        status = prove(problem, l->options, &model, &error);
    }
    if (status == TAUT_OK) {
        status = taut_model_write_text(model, "json", &written, &text, &size, &error);
    }
    if (status == TAUT_OK) {
        l->made++;
        l->false_claims += taut_certificate_holds(taut_model_certificate(model)) == TAUT_FALSE;
        code = put(l, text, size);
    } else {
        code = put_error(l, &error);
    }
    taut_text_free(text);
    taut_model_free(model);
    taut_problem_free(problem);
    return code;
}

static int make_all(lines *l)
{
    const char *line = NULL;
    size_t length = 0;
    int64_t i = 0;
    int code = next_problem(l, &line, &length);
    for (; code == 0 && line != NULL; i++) {
        if (i >= l->there) {
            code = make_one(l, line, length);
        }
        if (code == 0) {
            code = next_problem(l, &line, &length);
        }
    }
    return code;
}

static int open_output(lines *l)
{
    const char *path = l->options->output_count > 0 ? l->options->outputs[0] : "-";
    if (strcmp(path, "-") == 0) {
        l->out = stdout;
        return 0;
    }
    const int reason = taut_system_open_growing(path, &l->out);
    return reason == 0 ? go_on(l, path) : fail(path, "write", reason);
}

static void report(const lines *l)
{
    if (l->there > 0) {
        fprintf(stderr, "%" PRId64 " lines were there\n", l->there);
    }
    fprintf(stderr, "%" PRId64 " made, %" PRId64 " that do not hold; %" PRId64 " errors\n", l->made,
            l->false_claims, l->errors);
}

static int check_options(const cli_options *options)
{
    if (options->output_count > 1 || options->report != NULL) {
        return cli_misuse("option", "--lines writes one file of lines, and no report");
    }
    if (options->output_count == 1 && strcmp(options->outputs[0], options->files[0]) == 0 &&
        strcmp(options->files[0], "-") != 0) {
        return cli_misuse("option",
                          "the lines are read from the file that they are to be written to");
    }
    return 0;
}

int cli_make_lines(const cli_options *options)
{
    const int is_standard = strcmp(options->files[0], "-") == 0;
    lines l = {.options = options,
               .name = is_standard ? "standard input" : options->files[0],
               .room = ROOM_FIRST};
    int code = check_options(options);
    if (code != 0) {
        return code;
    }
    const int reason = taut_system_open(options->files[0], &l.in);
    if (reason != 0) {
        return fail(l.name, "read", reason);
    }
    cli_catch_signals(); /* what is whole stays, and what is broken is cut off the next time */
    l.text = malloc(l.room);
    code = l.text != NULL ? open_output(&l) : cli_no_memory();
    if (code == 0) {
        code = make_all(&l);
    }
    cli_monitor_done();
    if (code == 0 && !options->quiet) {
        report(&l);
    }
    if (l.out != NULL && l.out != stdout && fclose(l.out) != 0 && code == 0) {
        code = fail(options->outputs[0], "write", errno);
    }
    taut_system_close(&l.in);
    free(l.text);
    return code != 0 ? code : l.errors > 0;
}
