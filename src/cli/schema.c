/* schema.c -- taut schema: the JSON Schema of a document. */
#include "cli/cli.h"
#include "cli/embedded_files.h"

static int run(const cli_options *options)
{
    const taut_embedded *file = NULL;
    if (options->file_count == 0) {
        cli_embedded_list(taut_schemas);
        return cli_print_text("", 0);
    }
    file = cli_embedded_find(taut_schemas, options->files[0]);
    if (file == NULL) {
        return cli_embedded_unknown(taut_schemas, "schema", options->files[0]);
    }
    return cli_print_text(file->text, file->length);
}

static const cli_option options_of_schema[] = {CLI_THREADS, CLI_LAST};

const cli_command cli_command_schema = {
    .name = "schema",
    .usage = "[problem | model | report | trace | pattern]",
    .summary = "the JSON Schema of the documents",
    .text = "Without a name the schemas are listed.\n",
    .example = "taut schema problem > problem.schema.json\n",
    .files_min = 0,
    .files_max = 1,
    .options = options_of_schema,
    .run = run,
};
