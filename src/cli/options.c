/* options.c -- the command line, by each command's table. */
#include "cli/cli.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const cli_option *find_option(const cli_command *command, const char *word)
{
    for (const cli_option *o = command->options; o->kind != CLI_END; o++) {
        if (strcmp(o->name, word) == 0) {
            return o;
        }
    }
    return NULL;
}

static int unknown(const cli_command *command, const char *word)
{
    const char *names[64] = {"--help", "--json"};
    int n = 2;
    for (const cli_option *o = command->options; o->kind != CLI_END && n < 63; o++) {
        names[n++] = o->name;
    }
    const char *near = cli_nearest(word, names);
    return cli_misuse("option", "`taut %s` has no option %.40s%s%s%s", command->name, word,
                      near != NULL ? " (did you mean " : "", near != NULL ? near : "",
                      near != NULL ? "?)" : "");
}

/* Appends to a list of words, in blocks of a power of two. */
static int append(char *base, const cli_option *option, const char *word)
{
    const char ***list = (const char ***)(void *)(base + option->offset);
    int *count = (int *)(void *)(base + option->offset_count);
    if (*count >= CLI_LIST_MAX) {
        return cli_misuse("option", "%s is given more than %d times", option->name, CLI_LIST_MAX);
    }
    if ((*count & (*count - 1)) == 0) {
        const char **grown = realloc(*list, (size_t)(*count > 0 ? 2 * *count : 1) * sizeof **list);
        if (grown == NULL) {
            return cli_no_memory();
        }
        *list = grown;
    }
    (*list)[(*count)++] = word;
    return 0;
}

/* Puts the value of an option in its place. */
static int set_option(char *base, const cli_option *option, const char *word)
{
    double value = 0;
    if (option->kind == CLI_TEXT) {
        *(const char **)(void *)(base + option->offset) = word;
        return 0;
    }
    if (option->kind == CLI_LIST) {
        return append(base, option, word);
    }
    if (!cli_number(word, &value) || value < option->lo || value > option->hi ||
        (option->kind == CLI_INTEGER && value != floor(value))) {
        return cli_misuse_value(option->name, word, "%s from %g to %g",
                                option->kind == CLI_INTEGER ? "a whole number" : "a number",
                                option->lo, option->hi);
    }
    if (option->kind == CLI_INTEGER) {
        *(int *)(void *)(base + option->offset) = (int)value;
    } else {
        *(double *)(void *)(base + option->offset) = value;
    }
    return 0;
}

static int take_file(const cli_command *command, cli_options *options, const char *word)
{
    if (options->file_count == command->files_max) {
        return cli_misuse("operand",
                          "`taut %s` does not know what to do with %.80s: it takes %d at most",
                          command->name, word, command->files_max);
    }
    options->files[options->file_count++] = word;
    return 0;
}

/* One word, with `value` glued to it ("--name=value") or in the next one; *used says how many
 * words went. */
static int take_option(const cli_command *command, char **words, int left, cli_options *options,
                       int *used)
{
    char name[64];
    const char *equals = strchr(words[0], '=');
    const size_t length = equals != NULL ? (size_t)(equals - words[0]) : strlen(words[0]);
    const cli_option *option = NULL;

    if (length >= sizeof name) {
        return unknown(command, words[0]);
    }
    memcpy(name, words[0], length);
    name[length] = '\0';
    option = find_option(command, name);
    if (option == NULL) {
        return unknown(command, name);
    }
    if (option->kind == CLI_FLAG) {
        if (equals != NULL) {
            return cli_misuse("option", "%s takes no value", option->name);
        }
        *(int *)(void *)((char *)options + option->offset) = 1;
        return 0;
    }
    if (equals == NULL && left < 2) {
        return cli_misuse("option", "%s needs a value: %s %s", option->name, option->name,
                          option->value);
    }
    *used = equals != NULL ? 1 : 2;
    return set_option((char *)options, option, equals != NULL ? equals + 1 : words[1]);
}

int cli_parse(const cli_command *command, int count, char **words, cli_options *options)
{
    int only_files = 0; /* after "--" */
    int code = 0;
    for (int i = 0, used = 1; i < count && code == 0; i += used) {
        used = 1;
        if (!only_files && strcmp(words[i], "--") == 0) {
            only_files = 1;
        } else if (!only_files &&
                   (strcmp(words[i], "--help") == 0 || strcmp(words[i], "-h") == 0)) {
            options->help = 1;
            return 0;
        } else if (!only_files && strcmp(words[i], "--json") == 0) {
            options->json = 1;
        } else if (!only_files && words[i][0] == '-' && words[i][1] != '\0') {
            code = take_option(command, words + i, count - i, options, &used);
        } else {
            code = take_file(command, options, words[i]);
        }
    }
    if (code == 0 && options->file_count < command->files_min) {
        code = cli_misuse("operand", "`taut %s` needs more: taut %s %s", command->name,
                          command->name, command->usage);
    }
    return code;
}

void cli_parse_free(cli_options *options)
{
    free(options->outputs);
    free(options->geodesics);
    free(options->holds);
    free(options->seam_lines);
    free(options->at);
    free(options->families);
    free(options->seed_edges);
    free(options->seed_lines);
}
