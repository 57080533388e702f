/* join.c -- taut join: how two surfaces meet along an edge. */
#include "cli/cli.h"

#include <stdio.h>
#include <string.h>

/* "u1" or "NAME.u1" in a model: the surface and the edge; 0, or the exit code after one message. */
static int find_edge(const taut_model *model, const char *word, const taut_surface **surface,
                     taut_edge *edge)
{
    const char *dot = strrchr(word, '.');
    const size_t length = dot != NULL ? (size_t)(dot - word) : 0;

    if (taut_edge_of_name(dot != NULL ? dot + 1 : word, edge) != TAUT_OK) {
        return cli_misuse(
            "value", "found edge \"%.80s\", expected u0, u1, v0, v1 or one of a surface, NAME.u0",
            word);
    }
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        const char *name = taut_surface_name(taut_model_surface(model, i));
        if (dot == NULL || (strlen(name) == length && strncmp(name, word, length) == 0)) {
            if (dot == NULL && taut_model_surface_count(model) > 1) {
                break;
            }
            *surface = taut_model_surface(model, i);
            return 0;
        }
    }
    if (dot == NULL && taut_model_surface_count(model) > 1) {
        return cli_misuse("name", "%.80s: the model has %d surfaces, expected NAME.%s", word,
                          taut_model_surface_count(model), taut_edge_name(*edge));
    }
    return cli_misuse("name", "%.80s: the model has no such surface", word);
}

static int print_join(const cli_options *options, const taut_join *join, const char *unit)
{
    char room[CLI_UNIT_ROOM];
    taut_record *record = taut_record_new();
    taut_join_record(join, record);
    if (options->json) {
        taut_record_add_text(record, "unit", unit);
    }
    if (options->json) {
        return cli_print_record(record);
    }
    for (size_t i = 0; i < taut_record_count(record); i++) {
        const taut_record *value = taut_record_at(record, i);
        printf("%-20s", taut_record_key(record, i));
        if (taut_record_kind_of(value) == TAUT_RECORD_NUMBER) {
            printf("%.6g%s\n", taut_record_number(value),
                   cli_unit_of(taut_record_key(record, i), unit, room));
        } else if (taut_record_kind_of(value) == TAUT_RECORD_BOOL) {
            printf("%s\n", taut_record_bool(value) ? "yes" : "no");
        } else if (taut_record_kind_of(value) == TAUT_RECORD_TEXT) {
            printf("%s\n", taut_record_text(value));
        } else {
            printf("-\n");
        }
    }
    taut_record_free(record);
    return cli_print_text("", 0);
}

static int run(const cli_options *options)
{
    const taut_surface *surfaces[2] = {NULL, NULL};
    taut_model *models[2] = {NULL, NULL};
    taut_edge edges[2] = {TAUT_EDGE_U0, TAUT_EDGE_U0};
    taut_join join;
    const taut_join_options watched = {.monitor = cli_monitor(options->quiet)};
    taut_error error;
    int code = 0;

    for (int i = 0; i < 2 && code == 0; i++) {
        if (cli_read_model(options->files[2 * i], options, &models[i], &error) != TAUT_OK) {
            code = cli_fail_in(options->files[2 * i], &error);
        } else {
            code = cli_one_unit(options->files[2 * i], models[0], &models[i], options->json);
        }
        if (code == 0) {
            code = find_edge(models[i], options->files[2 * i + 1], &surfaces[i], &edges[i]);
        }
    }
    if (code == 0) {
        const taut_status status = taut_join_measure_with(surfaces[0], edges[0], surfaces[1],
                                                          edges[1], &watched, &join, &error);
        cli_monitor_done();
        code = status == TAUT_OK ? print_join(options, &join, taut_model_unit(models[0]))
                                 : cli_fail(&error);
    }
    taut_model_free(models[0]);
    taut_model_free(models[1]);
    return code;
}

static const cli_option options_of_join[] = {CLI_JSON, CLI_UNTRIM, CLI_THREADS, CLI_LAST};

const cli_command cli_command_join = {
    .name = "join",
    .usage = "MODEL.json EDGE MODEL.json EDGE [--json]",
    .summary = "gap, angles and order of contact of two edges",
    .text =
        "EDGE is u0, u1, v0 or v1, or NAME.u1 where the model has several surfaces. The edges are\n"
        "matched end to end, whatever their directions; orders are -1 for a gap and at most 3.\n",
    .example = "taut join left.json u1 right.json u0\n",
    .files_min = 4,
    .files_max = 4,
    .options = options_of_join,
    .run = run,
};
