/* view.c -- taut view: a model as a page to turn it in. */
#include "cli/cli.h"
#include "platform/system.h"

#include <string.h>

/* One model into each -o, or into standard output, whatever the path: a page is what was asked. */
static int write_pages(const taut_model *model, const cli_options *options)
{
    static const char *const standard[] = {"-"};
    const char *const *paths = options->output_count > 0 ? options->outputs : standard;
    const int count = options->output_count > 0 ? options->output_count : 1;
    char name[128];
    taut_write_options chosen;
    taut_outputs *outputs = NULL;
    taut_error error;
    int code = cli_write_options(options, &chosen);

    chosen.threads = cli_threads_of(options, model);
    chosen.format = "html";
    if (chosen.title == NULL && strcmp(options->files[0], "-") != 0) {
        cli_label(options->files[0], name, sizeof name);
        chosen.title = name;
    }
    if (code == 0) {
        code = cli_outputs_new(&outputs);
    }
    for (int i = 0; i < count && code == 0; i++) {
        if (taut_outputs_model(outputs, model, paths[i], &chosen, &error) != TAUT_OK) {
            code = cli_fail_at(paths[i], &error);
        }
    }
    if (code == 0) {
        code = cli_commit(outputs);
    }
    cli_monitor_done();
    cli_outputs_free(outputs);
    return code;
}

/* A page goes to standard output, to a device, or to a name that says so or says nothing. */
static int is_page(const char *path)
{
    const char *name = strrchr(path, '/') != NULL ? strrchr(path, '/') + 1 : path;
    const char *dot = strrchr(name, '.');
    return strncmp(path, "/dev/", strlen("/dev/")) == 0 || dot == NULL ||
           strcmp(dot, ".html") == 0 || strcmp(dot, ".htm") == 0;
}

static int run(const cli_options *options)
{
    taut_model *model = NULL;
    taut_error error;
    int code = 0;

    if (options->output_count == 0 && taut_system_is_terminal(TAUT_STANDARD_OUTPUT)) {
        return cli_misuse("option",
                          "`taut view` needs -o FILE.html here: a page is not for a terminal");
    }
    for (int i = 0; i < options->output_count; i++) {
        if (!is_page(options->outputs[i])) {
            return cli_misuse_path("format", options->outputs[i],
                                   "-o %s: `taut view` writes pages, which end in .html; `taut "
                                   "convert` writes the other formats",
                                   options->outputs[i]);
        }
    }
    if (cli_read_model(options->files[0], options, &model, &error) != TAUT_OK) {
        return cli_fail_in(options->files[0], &error);
    }
    if (options->file_count > 1) {
        code = cli_prove_against(options->files[0], options->files[1], model, options);
    } else {
        cli_prove_again(options->files[0], model, options);
    }
    code = code == 0 ? write_pages(model, options) : code;
    taut_model_free(model);
    return code;
}

static const cli_option options_of_view[] = {
    {"-o", CLI_LIST, offsetof(cli_options, outputs), offsetof(cli_options, output_count), 0, 0,
     "FILE", "write the page to FILE; else to standard output"},
    CLI_SURFACE,
    {"--view", CLI_TEXT, offsetof(cli_options, view), 0, 0, 0, "AZ,EL",
     "where it is looked at from at first, in degrees"},
    {"--title", CLI_TEXT, offsetof(cli_options, title), 0, 0, 0, "TEXT", "its heading"},
    {"--frames", CLI_FLAG, offsetof(cli_options, side_by_side), 0, 0, 0, NULL,
     "the surfaces are frames of one that moves (found by itself where the details say so)"},
    CLI_UNTRIM,
    CLI_THREADS,
    CLI_LAST};

const cli_command cli_command_view = {
    .name = "view",
    .usage = "MODEL.json [PROBLEM.json] [-o FILE.html]",
    .summary = "write a page to turn a model in, with its certificate",
    .text = "The page is one file and asks for no other: open it in any browser. `make` and "
            "`convert` write it too, as -o FILE.html. It says what of a large model it leaves "
            "out. The certificate is proved again; give the problem too, and no claim is as it "
            "was saved.",
    .example = "taut view model.json -o model.html\n",
    .files_min = 1,
    .files_max = 2,
    .options = options_of_view,
    .run = run,
};
