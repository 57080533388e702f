/* main.c -- finds the command and runs it. */
#include "cli/cli.h"
#include "cli/command_list.h"
#include "platform/system.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CLI_DECLARE(identifier) extern const cli_command cli_command_##identifier;
CLI_COMMAND_LIST(CLI_DECLARE)
#undef CLI_DECLARE

static const cli_command *const commands[] = {
#define CLI_ROW(identifier) &cli_command_##identifier,
    CLI_COMMAND_LIST(CLI_ROW)
#undef CLI_ROW
};
enum { COMMAND_COUNT = (int)(sizeof commands / sizeof commands[0]) };

static int print_help(void)
{
    printf("taut builds minimal, harmonic and blend surfaces from their boundaries, with "
           "certificates.\n\n");
    for (int i = 0; i < COMMAND_COUNT; i++) {
        printf("  taut %-10s %s\n", commands[i]->name, commands[i]->summary);
    }
    printf(
        "\n  taut help COMMAND     what a command takes; so does taut COMMAND --help\n"
        "  taut help REASON      what an error means, and what to change\n"
        "  taut help WORD        a construction, a claim, a number of the report or a term\n"
        "  taut --version        which taut this is\n\n"
        "A first surface:  taut example dirichlet-tent | taut make - -o tent.json -o tent.png\n"
        "Exit codes: 0 done, 1 the numbers say no, 2 command line, 3 document, 4 does not exist,\n"
        "            5 file, 6 memory or a fault of taut's own, 130 interrupted.\n");
    return cli_print_text("", 0);
}

static int print_command_help(const cli_command *command)
{
    enum { COLUMN = 18 };
    int prints_json = 0;
    const int begun = printf("taut %s ", command->name);
    cli_print_filled(command->usage, begun, begun);
    printf("\n\n");
    cli_print_filled(command->text, 0, 0);
    printf("\n\n");
    for (const cli_option *o = command->options; o->kind != CLI_END; o++) {
        char left[48];
        prints_json |= strcmp(o->name, "--json") == 0;
        snprintf(left, sizeof left, "%s%s%s", o->name, o->value != NULL ? " " : "",
                 o->value != NULL ? o->value : "");
        if (strlen(left) > COLUMN) {
            printf("  %s\n  %-*s ", left, COLUMN, "");
        } else {
            printf("  %-*s ", COLUMN, left);
        }
        cli_print_filled(o->help, COLUMN + 3, COLUMN + 3);
        putchar('\n');
    }
    if (!prints_json) {
        printf("  %-*s %s\n", COLUMN, "--json", "errors as JSON on standard error, for programs");
    }
    printf("\nExample:\n");
    for (const char *line = command->example; *line != '\0'; line += strcspn(line, "\n") + 1) {
        printf("  %.*s\n", (int)strcspn(line, "\n"), line);
    }
    cli_term_help(command->name, 1); /* trace, pattern: constructions; panels: a claim */
    return cli_print_text("", 0);
}

static int print_version(void)
{
    const char *wanted = getenv("TAUT_KERNEL");
    printf("taut %s, %s kernels\n", taut_version(), taut_kernel_in_use());
    if (wanted != NULL && strcmp(wanted, taut_kernel_in_use()) != 0) {
        printf(
            "TAUT_KERNEL=%.40s is passed over: this processor has no such kernels, or the name is "
            "not one of baseline, avx2, avx512\n",
            wanted);
    }
    return cli_print_text("", 0);
}

static const cli_command *command_of(const char *name)
{
    for (int i = 0; i < COMMAND_COUNT; i++) {
        if (strcmp(name, commands[i]->name) == 0) {
            return commands[i];
        }
    }
    return NULL;
}

enum { REASONS_MAX = 512, TERMS_MAX = 512 };

/* No such command, nor a word that `taut help` explains where those are asked for too; 2. */
static int unknown(const char *name, int words_too)
{
    const char *names[COMMAND_COUNT + REASONS_MAX + TERMS_MAX + 4] = {"--help", "--version",
                                                                      "help"};
    char terms[TERMS_MAX][CLI_TERM_ROOM];
    size_t count = 3;
    for (int i = 0; i < COMMAND_COUNT; i++) {
        names[count++] = commands[i]->name;
    }
    for (int i = 0; words_too && i < REASONS_MAX && cli_reason_at(i) != NULL; i++) {
        names[count++] = cli_reason_at(i);
    }
    for (int i = 0; words_too && i < TERMS_MAX && cli_term_at(i, terms[i]); i++) {
        names[count++] = terms[i];
    }
    const char *near = cli_nearest(name, names);
    return cli_misuse("command", "there is no command%s \"%.40s\"%s%s%s; %s",
                      words_too ? ", construction, member, claim or reason" : "", name,
                      near != NULL ? " (did you mean \"" : "", near != NULL ? near : "",
                      near != NULL ? "\"?)" : "",
                      words_too ? "`taut --help` lists commands, docs/format.md members, "
                                  "docs/certificate.md claims, docs/errors.md reasons"
                                : "`taut --help` lists them");
}

/* taut help [COMMAND | REASON | WORD]; no word is a command and a reason (tests/cli/test_help.sh), some are a reason and
 * a claim. Words of the report that have a blank need no quotes. */
static int help(int count, char **words)
{
    char word[CLI_TERM_ROOM] = "";

    if (count == 0) {
        return print_help();
    }
    for (int i = 0; i < count; i++) {
        const size_t used = strlen(word);
        snprintf(word + used, sizeof word - used, "%s%s", i > 0 ? " " : "", words[i]);
    }
    if (strcmp(word, "help") == 0 || strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0) {
        return print_help();
    }
    const cli_command *command = command_of(word);
    if (command != NULL) {
        return print_command_help(command);
    }
    const int found = cli_reason_help(word);
    return cli_term_help(word, found > 0) + found > 0 ? cli_print_text("", 0) : unknown(word, 1);
}

static int run(const cli_command *command, int count, char **words)
{
    cli_options options = {.file_count = 0};
    int code = cli_parse(command, count, words, &options);
    if (code == 0) {
        if (!options.quiet && !cli_speaks_json()) {
            cli_announce(command->name);
        }
        code = options.help ? print_command_help(command) : command->run(&options);
        cli_warnings_done();
    }
    cli_parse_free(&options);
    return code;
}

int main(int argc, char **argv)
{
    if (taut_system_begin(&argc, &argv) != 0) {
        return cli_no_memory();
    }
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++) {
        if (strncmp(argv[i], "--json", strlen("--json")) == 0) {
            cli_speak_json(); /* also of what is wrong with the words before */
        }
    }
    if (cli_speaks_json()) {
        cli_catch_signals();
    }
    if (argc < 2) {
        return cli_misuse("command", "no command; `taut --help` lists them");
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) {
        return print_help();
    }
    if (strcmp(argv[1], "--version") == 0) {
        return print_version();
    }
    if (strcmp(argv[1], "help") == 0) {
        return help(argc - 2, argv + 2);
    }
    const cli_command *command = command_of(argv[1]);
    return command != NULL ? run(command, argc - 2, argv + 2) : unknown(argv[1], 0);
}
