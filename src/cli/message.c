/* message.c -- what is told when something went wrong: one message, one line, for a person or, with
 * --json, for a program. */
#include "cli/cli.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static int speaks_json;

void cli_speak_json(void)
{
    speaks_json = 1;
}

int cli_speaks_json(void)
{
    return speaks_json;
}

/* Part of a line, whatever the names and words in it are: what would move the cursor is a "?". */
static void print_part(const char *part)
{
    for (const char *at = part; *at != '\0'; at++) {
        fputc(iscntrl((unsigned char)*at) ? '?' : *at, stderr);
    }
}

static void print_line(const char *line)
{
    fputs("taut: ", stderr);
    print_part(line);
    fputc('\n', stderr);
}

/* The word for an error that names none. */
static const char *reason_of(const taut_error *error)
{
    return error->reason[0] != '\0'             ? error->reason
           : error->status == TAUT_NO_MEMORY    ? "memory"
           : error->status == TAUT_INTERRUPTED  ? "interrupted"
           : error->status == TAUT_BAD_ARGUMENT ? "argument"
                                                : "fault";
}

static const char *sentence_of(const taut_error *error)
{
    return error->message[0] != '\0' ? error->message : taut_status_text(error->status);
}

static void add_number_or_null(taut_record *record, const char *key, double value)
{
    if (isfinite(value)) {
        taut_record_add_number(record, key, value);
    } else {
        taut_record_add_null(record, key);
    }
}

taut_record *cli_error_record(const taut_error *error, const char *where)
{
    taut_record *record = taut_record_new();
    taut_record *object = taut_record_add_object(record, "error");

    taut_record_add_number(object, "exit", taut_status_exit_code(error->status));
    taut_record_add_text(object, "reason", reason_of(error));
    taut_record_add_text(object, "where", where);
    taut_record_add_text(object, "message", sentence_of(error));
    add_number_or_null(object, "found", error->found);
    if (error->expected[0] != '\0') {
        taut_record_add_text(object, "expected", error->expected);
    } else {
        add_number_or_null(object, "expected", error->limit);
    }
    return record;
}

size_t cli_one_line(char *text, size_t length)
{
    size_t end = 0;
    while (length > 0 && text[length - 1] == '\n') {
        length--;
    }
    for (size_t i = 0; i < length;
         i++) { /* texts have no line ends of their own: those that are there are the layout's */
        const int is_end = text[i] == '\n';
        text[end++] = is_end ? ' ' : text[i];
        while (is_end && i + 1 < length && text[i + 1] == ' ') {
            i++;
        }
    }
    text[end] = '\0';
    return end;
}

/* A record as a line on standard error; 0 where memory ran out. Frees it. */
static int print_record(taut_record *record)
{
    char *text = NULL;
    size_t length = 0;
    const int is_written = taut_record_status(record) == TAUT_OK &&
                           taut_record_write(record, &text, &length) == TAUT_OK;

    if (is_written) {
        length = cli_one_line(text, length);
        fwrite(text, 1, length, stderr);
        fputc('\n', stderr);
    }
    taut_text_free(text);
    taut_record_free(record);
    return is_written;
}

static void print_json(const taut_error *error, const char *where)
{
    if (!print_record(cli_error_record(error, where))) {
        fprintf(stderr,
                "{ \"error\": { \"exit\": %d, \"reason\": \"%s\", \"where\": \"\", "
                "\"message\": \"memory ran out\", \"found\": null, \"expected\": null } }\n",
                taut_status_exit_code(error->status), reason_of(error));
    }
}

/* What a program is warned of: one line at the end, where nothing failed. A failure is one line alone. */
static taut_record *warnings, *warned_of;
static int has_failed;

void cli_warn(const char *file, const char *text)
{
    if (speaks_json) {
        if (warnings == NULL) {
            warnings = taut_record_new();
            warned_of = taut_record_add_list(warnings, "warnings");
        }
        taut_record *object = taut_record_add_object(warned_of, NULL);
        taut_record_add_text(object, "where", file);
        taut_record_add_text(object, "message", text);
    } else {
        fputs("taut: ", stderr);
        print_part(file);
        fputs(": warning: ", stderr);
        print_part(text);
        fputc('\n', stderr);
    }
}

void cli_warnings_done(void)
{
    if (warnings == NULL || has_failed) {
        taut_record_free(warnings);
    } else {
        (void)print_record(warnings); /* there is nobody to be told that memory ran out */
    }
    warnings = NULL;
}

/* What a person reads more about by `taut help`; a wrong command line has its own --help, and what the machine or the
 * person at it did needs none. */
static int has_more(const taut_error *error)
{
    return error->status != TAUT_BAD_ARGUMENT && error->status != TAUT_INTERRUPTED &&
           error->status != TAUT_NO_MEMORY;
}

static int print_error(const taut_error *error, const char *where)
{
    char line[sizeof error->where + sizeof error->message + sizeof error->reason + 32];
    cli_monitor_done();
    has_failed = 1;
    if (speaks_json) {
        print_json(error, where);
    } else {
        snprintf(line, sizeof line, "%s%s%s%s%s%s", error->where,
                 error->where[0] != '\0' ? ": " : "", sentence_of(error),
                 has_more(error) ? " (see: taut help " : "",
                 has_more(error) ? reason_of(error) : "", has_more(error) ? ")" : "");
        print_line(line);
    }
    return taut_status_exit_code(error->status);
}

int cli_fail(const taut_error *error)
{
    return print_error(error, error->where);
}

int cli_fail_in(const char *file, const taut_error *error)
{
    const char *name = strcmp(file, "-") == 0 ? "standard input" : file;
    const size_t length = strlen(name);
    taut_error placed = *error;
    /* a pointer begins like the name of a file that is absolute */
    const int names_file = strncmp(error->where, name, length) == 0 && error->where[length] == ':';
    if (error->where[0] == '\0' || (error->where[0] == '/' && !names_file)) {
        snprintf(placed.where, sizeof placed.where, "%.100s%s%.80s", name,
                 error->where[0] != '\0' ? ": " : "", error->where);
    }
    return print_error(&placed, error->where[0] != '\0' ? error->where : placed.where);
}

int cli_fail_at(const char *path, const taut_error *error)
{
    return print_error(error, error->where[0] != '\0' ? error->where : path);
}

static taut_error misuse(const char *reason)
{
    taut_error error = {.status = TAUT_BAD_ARGUMENT, .found = (double)NAN, .limit = (double)NAN};
    snprintf(error.reason, sizeof error.reason, "%s", reason);
    return error;
}

int cli_misuse(const char *reason, const char *format, ...)
{
    taut_error error = misuse(reason);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(error.message, sizeof error.message, format, arguments);
    va_end(arguments);
    return cli_fail(&error);
}

int cli_misuse_path(const char *reason, const char *path, const char *format, ...)
{
    taut_error error = misuse(reason);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(error.message, sizeof error.message, format, arguments);
    va_end(arguments);
    return cli_fail_at(path, &error);
}

int cli_misuse_value(const char *option, const char *word, const char *expected, ...)
{
    taut_error error = misuse("value");
    va_list arguments;
    va_start(arguments, expected);
    vsnprintf(error.expected, sizeof error.expected, expected, arguments);
    va_end(arguments);
    snprintf(error.where, sizeof error.where, "%s %.40s", option, word);
    snprintf(error.message, sizeof error.message, "expected %s", error.expected);
    if (!cli_number(word, &error.found)) {
        error.found = (double)NAN;
    }
    return cli_fail(&error);
}

int cli_refuse_given(const char *command, const char *without, size_t count, const cli_given *words)
{
    for (size_t k = 0; k < count; k++) {
        if (words[k].is_given) {
            return cli_misuse("option",
                              "`taut %s`: found %s without %s: give both with a surface; a "
                              "document says all of it",
                              command, words[k].name, without);
        }
    }
    return 0;
}

int cli_fail_in_words(const char *command, const char *file, const taut_error *error)
{
    taut_error told = *error;
    if (error->status != TAUT_BAD_INPUT || strncmp(error->where, "/of", 3) == 0 ||
        strcmp(error->where, "/surface") == 0) {
        return cli_fail_in(file, error);
    }
    told.status = TAUT_BAD_ARGUMENT;
    told.where[0] = '\0';
    snprintf(told.message, sizeof told.message, "`taut %s`: %.80s: %.160s", command, error->where,
             error->message);
    return cli_fail(&told);
}

int cli_no_memory(void)
{
    taut_error error = {.status = TAUT_NO_MEMORY, .found = (double)NAN, .limit = (double)NAN};
    return cli_fail(&error);
}

const char *cli_nearest(const char *word, const char *const *words)
{
    enum { LETTERS = 64 }; /* compared */
    int edits = 0;
    const char *nearest = taut_nearest_word(word, words, &edits);
    return edits <= (int)strnlen(word, LETTERS) / 3 + 1 ? nearest : NULL;
}
