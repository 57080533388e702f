/* example.c -- taut example: the worked problems, ready to pipe into `taut make -`. */
#include "cli/cli.h"
#include "cli/embedded_files.h"
#include "platform/system.h"

#include <stdio.h>
#include <string.h>

/* What stands after "NAME: " in the list of titles; *length 0 where there is none. */
static const char *title_of(const char *name, int name_length, int *length)
{
    const char *line = taut_titles[0].text;
    while (*line != '\0') {
        const int whole = (int)strcspn(line, "\n");
        if (strncmp(line, name, (size_t)name_length) == 0 &&
            strncmp(line + name_length, ": ", 2) == 0) {
            *length = whole - name_length - 2;
            return line + name_length + 2;
        }
        line += whole + (line[whole] == '\n');
    }
    *length = 0;
    return "";
}

static int is_construction(const char *name)
{
    for (int i = 0; i < taut_construct_count(); i++) {
        if (strcmp(name, taut_construct_name(i)) == 0) {
            return 1;
        }
    }
    return 0;
}

/* Does the document ask for this construction? Examples are read as any document is. */
static int asks_for(const taut_embedded *file, const char *construct)
{
    taut_problem *problem = NULL;
    taut_error error;
    const int asks =
        taut_problem_read_text(file->text, file->length, file->name, &problem, &error) == TAUT_OK &&
        strcmp(taut_problem_construction(problem), construct) == 0;
    taut_problem_free(problem);
    return asks;
}

const char *cli_example_of(const char *construct)
{
    const taut_embedded *shortest = NULL;
    for (const taut_embedded *file = taut_examples; file->name != NULL; file++) {
        if ((shortest == NULL || file->length < shortest->length) && asks_for(file, construct)) {
            shortest = file;
        }
    }
    return shortest != NULL ? shortest->name : NULL;
}

/* Bare names for a program; for a person at a terminal a title beside each. */
static int list(const char *construct)
{
    enum { COLUMN = 29 };
    const int titles = taut_system_is_terminal(TAUT_STANDARD_OUTPUT);
    if (construct != NULL && !is_construction(construct)) {
        return cli_misuse_value("--construct", construct, "a construction, such as pipe");
    }
    for (const taut_embedded *file = taut_examples; file->name != NULL; file++) {
        const int length = (int)(strlen(file->name) - strlen(".json"));
        int title_length = 0;
        const char *title = title_of(file->name, length, &title_length);
        if (construct != NULL && !asks_for(file, construct)) {
            continue;
        }
        if (titles) {
            printf("%-*.*s %.*s\n", COLUMN, length, file->name, title_length, title);
        } else {
            printf("%.*s\n", length, file->name);
        }
    }
    return cli_print_text("", 0);
}

static int run(const cli_options *options)
{
    const taut_embedded *file = NULL;
    if (options->file_count == 0) {
        return list(options->construct);
    }
    if (options->construct != NULL) {
        return cli_misuse("option", "--construct filters the list: leave the name out");
    }
    file = cli_embedded_find(taut_examples, options->files[0]);
    if (file == NULL) {
        return cli_embedded_unknown(taut_examples, "example", options->files[0]);
    }
    return cli_print_text(file->text, file->length);
}

static const cli_option options_of_example[] = {{"--construct", CLI_TEXT,
                                                 offsetof(cli_options, construct), 0, 0, 0, "NAME",
                                                 "list only the problems of one construction"},
                                                CLI_THREADS,
                                                CLI_LAST};

const cli_command cli_command_example = {
    .name = "example",
    .usage = "[NAME | --construct CONSTRUCTION]",
    .summary = "list the worked problems, or print one",
    .text =
        "Without a name all are listed: with a title each on a terminal, bare names in a pipe.\n",
    .example = "taut example --construct pipe\n"
               "taut example dirichlet-tent | taut make - -o model.json -o model.png\n",
    .files_min = 0,
    .files_max = 1,
    .options = options_of_example,
    .run = run,
};
