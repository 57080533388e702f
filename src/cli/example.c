/* example.c -- taut example: the worked problems, ready to pipe into `taut make -`. */
#include "cli/cli.h"
#include "cli/embedded_files.h"

static int run(const cli_options *options)
{
    const taut_embedded *file = NULL;
    if (options->file_count == 0) {
        cli_embedded_list(taut_examples);
        return cli_print_text("", 0);
    }
    file = cli_embedded_find(taut_examples, options->files[0]);
    if (file == NULL) {
        return cli_embedded_unknown(taut_examples, "example", options->files[0]);
    }
    return cli_print_text(file->text, file->length);
}

static const cli_option options_of_example[] = {CLI_THREADS, CLI_LAST};

const cli_command cli_command_example = {
    .name = "example",
    .usage = "[NAME]",
    .summary = "list the worked problems, or print one",
    .text = "taut example NAME | taut make - -o model.json -o model.png\n",
    .files_min = 0,
    .files_max = 1,
    .options = options_of_example,
    .run = run,
};
