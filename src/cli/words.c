#include "cli/words.h"

#include "cli/make.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void cli_put(cli_words *t, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    const int more = vsnprintf(NULL, 0, format, list);
    va_end(list);
    if (more < 0 || t->failed) {
        t->failed = 1;
        return;
    }
    if (t->length + (size_t)more + 1 > t->room) {
        const size_t room = 2 * t->room + (size_t)more + 256;
        char *bytes = realloc(t->bytes, room);
        t->failed = bytes == NULL;
        if (t->failed) {
            return;
        }
        t->bytes = bytes;
        t->room = room;
    }
    va_start(list, format);
    t->length += (size_t)vsnprintf(t->bytes + t->length, t->room - t->length, format, list);
    va_end(list);
}

void cli_put_word(cli_words *t, const char *word)
{
    cli_put(t, "\"");
    for (; *word != '\0'; word++) {
        if ((unsigned char)*word < ' ') {
            cli_put(t, "\\u%04x", (unsigned)*word);
        } else {
            cli_put(t, "%s%c", *word == '"' || *word == '\\' ? "\\" : "", *word);
        }
    }
    cli_put(t, "\"");
}

int cli_put_number(const char *option, const char *word, const char *member, cli_words *t)
{
    double value = 0;
    if (word == NULL) {
        return 0;
    }
    if (!cli_number(word, &value)) {
        return cli_misuse_value(option, word, "a number");
    }
    cli_put(t, ", \"%s\": %.17g", member, value);
    return 0;
}

void cli_put_named(const char *word, const char *member, cli_words *t)
{
    if (word != NULL) {
        cli_put(t, ", \"%s\": ", member);
        cli_put_word(t, word);
    }
}

int cli_run_words(const cli_options *options, const char *command,
                  int (*write)(const cli_options *options, cli_words *t))
{
    cli_words document = {NULL, 0, 0, 0};
    taut_problem *problem = NULL;
    taut_error error;
    int code = write(options, &document);

    if (code == 0 && taut_problem_read_text(document.bytes, document.length, "the command line",
                                            &problem, &error) != TAUT_OK) {
        code = cli_fail_in_words(command, options->files[0], &error);
    }
    if (code == 0) {
        cli_options own = *options;
        own.words = command;
        own.surface = NULL; /* it says what it is made of; all of it is written */
        code = cli_make_one(problem, &own);
    }
    taut_problem_free(problem);
    free(document.bytes);
    return code;
}

/* A model, or a file of another program: what the command would take with a rule. */
static int is_model(const char *path, const taut_error *error)
{
    const size_t length = strlen(path);
    const int is_json = length >= 5 && strcmp(path + length - 5, ".json") == 0;
    return strcmp(error->reason, "kind") == 0 ||
           (strcmp(error->reason, "syntax") == 0 && !is_json && strcmp(path, "-") != 0);
}

int cli_run_document(const cli_options *options, const char *construction, const char *needs)
{
    taut_problem *problem = NULL;
    taut_error error;
    int code = 0;

    if (taut_problem_read(options->files[0], &problem, &error) != TAUT_OK) {
        return is_model(options->files[0], &error) ? cli_misuse("option", "%s", needs)
                                                   : cli_fail_in(options->files[0], &error);
    }
    code = strcmp(taut_problem_construction(problem), construction) == 0
               ? cli_make_one(problem, options)
               : cli_misuse("option", "%s", needs);
    taut_problem_free(problem);
    return code;
}
