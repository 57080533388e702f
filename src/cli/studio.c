/* studio.c -- taut studio: a problem as a page to edit it in.
 *
 * The module `studio` (cmake/studio.cmake) is a table of one file, the page with a place for the problem. What stands
 * there is the document with every < written \u003c, which within a JSON text can only stand in a string
 * and means the same there.
 */
#include "cli/cli.h"
#include "cli/embedded_files.h"
#include "platform/system.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char first_example[] = "dirichlet-tent";
static const char place[] = "@problem@";
static const char less[] = "\\u003c";

/* The page of the module, or NULL. */
static const taut_embedded *find_page(void)
{
    return taut_system_lacks_modules() == NULL ? taut_system_module("studio") : NULL;
}

static int fail_without(void)
{
    taut_error error = {
        .status = TAUT_IO, .reason = "not-installed", .found = (double)NAN, .limit = (double)NAN};
    snprintf(error.message, sizeof error.message,
             "the page of `taut studio` is not there: install clang, lld, wasi-libc, "
             "libclang-rt-14-dev-wasm32 and binaryen, and build taut again (make studio)");
    return cli_fail(&error);
}

/* One operand: an example where it looks like no path and nothing has that name; else a file. */
static int is_example(const char *word)
{
    const char *dot = strrchr(word, '.');
    return strcmp(word, "-") != 0 && taut_system_last_part(word) == word &&
           (dot == NULL || strcmp(dot, ".json") != 0) &&
           taut_system_place_of(word) == TAUT_PLACE_NONE;
}

/* The problem that is asked for; 0 or the exit code. */
static int read_problem(const cli_options *options, taut_problem **problem)
{
    const char *word = options->file_count > 0 ? options->files[0] : first_example;
    taut_error error;

    if (!is_example(word)) {
        return taut_problem_read(word, problem, &error) == TAUT_OK ? 0 : cli_fail_in(word, &error);
    }
    const taut_embedded *file = cli_embedded_find(taut_examples, word);
    if (file == NULL) {
        return cli_embedded_unknown(taut_examples, "example", word);
    }
    return taut_problem_read_text(file->text, file->length, word, problem, &error) == TAUT_OK
               ? 0
               : cli_fail_in(word, &error);
}

static char *put(char *to, const char *text, size_t length)
{
    memcpy(to, text, length);
    return to + length;
}

/* The page with the document in its place: *length, and the caller's to free; NULL: no memory. */
static char *fill_page(const taut_embedded *page, const char *text, size_t text_length,
                       size_t *length)
{
    const size_t before = (size_t)(strstr(page->text, place) - page->text);
    const size_t after = page->length - before - strlen(place);
    char *whole = malloc(before + text_length * strlen(less) + after);

    if (whole == NULL) {
        return NULL;
    }
    char *to = put(whole, page->text, before);
    for (size_t i = 0; i < text_length; i++) {
        to = text[i] == '<' ? put(to, less, strlen(less)) : put(to, text + i, 1);
    }
    to = put(to, page->text + before + strlen(place), after);
    *length = (size_t)(to - whole);
    return whole;
}

/* Writes it whole or not at all; 0 or the exit code. */
static int write_page(const char *path, const char *text, size_t length)
{
    taut_outputs *outputs = NULL;
    taut_error error;
    int code = cli_outputs_new(&outputs);

    if (code == 0 && taut_outputs_text(outputs, text, length, path, &error) != TAUT_OK) {
        code = cli_fail_at(path, &error);
    }
    if (code == 0) {
        code = cli_commit(outputs);
    }
    cli_outputs_free(outputs);
    return code;
}

static int check_output(const cli_options *options)
{
    if (options->output_count != 1) {
        return cli_misuse("option", "`taut studio` needs one -o FILE.html");
    }
    const char *path = options->outputs[0], *dot = strrchr(taut_system_last_part(path), '.');
    if (dot == NULL || strcmp(dot, ".html") != 0) {
        return cli_misuse_path("format", path,
                               "-o %s: `taut studio` writes a page, which ends in .html", path);
    }
    return 0;
}

static int run(const cli_options *options)
{
    taut_problem *problem = NULL;
    size_t text_length = 0, length = 0;
    int code = check_output(options);

    if (code == 0) {
        code = read_problem(options, &problem);
    }
    if (code != 0) {
        return code;
    }
    const taut_embedded *page = find_page();
    if (page == NULL) {
        code = fail_without();
    } else {
        const char *text = taut_problem_text(problem, &text_length);
        char *whole = fill_page(page, text, text_length, &length);
        code = whole == NULL ? cli_no_memory() : write_page(options->outputs[0], whole, length);
        free(whole);
    }
    taut_problem_free(problem);
    return code;
}

static const cli_option options_of_studio[] = {{"-o", CLI_LIST, offsetof(cli_options, outputs),
                                                offsetof(cli_options, output_count), 0, 0, "FILE",
                                                "write the page to FILE, which ends in .html"},
                                               CLI_JSON,
                                               CLI_LAST};

const cli_command cli_command_studio = {
    .name = "studio",
    .usage = "[PROBLEM.json | EXAMPLE] -o FILE.html",
    .summary = "write a page to edit a problem in, with the library inside",
    .text = "The page is one file that works offline from the disk: drag points, type numbers, "
            "see the surface and its proof follow, save the problem, export the model. Without an "
            "operand it opens with an example; all examples are in it.",
    .example = "taut studio dirichlet-tent -o studio.html\n",
    .files_min = 0,
    .files_max = 1,
    .options = options_of_studio,
    .run = run,
};
