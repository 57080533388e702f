/* boundary.c -- taut boundary: the curves and edges of a file that a "boundary" may name. */
#include "cli/cli.h"

#include <stdio.h>
#include <string.h>

/* One curve: its number, name, basis, length and ends. */
static taut_status add_row(const taut_curve *curve, int number, int is_edge, taut_record *list)
{
    const taut_basis *basis = taut_curve_t(curve);
    const char *name = taut_curve_name(curve);
    taut_record *row = taut_record_add_object(list, NULL);
    taut_curve_measure measure;
    double ends[2][3];

    taut_status status = taut_measure_curve(curve, NULL, &measure, NULL);
    if (status != TAUT_OK) {
        return status;
    }
    taut_curve_eval(curve, taut_basis_lo(basis), 0, ends[0]);
    taut_curve_eval(curve, taut_basis_hi(basis), 0, ends[1]);
    taut_record_add_number(row, "number", number);
    taut_record_add_text(row, "name", name);
    taut_record_add_text(row, "kind", is_edge ? "edge" : "curve");
    taut_record_add_text(row, "type", taut_basis_type(basis));
    taut_record_add_number(row, "points", taut_basis_count(basis));
    taut_record_add_number(row, "length", measure.length);
    taut_record_add_numbers(row, "from", 3, ends[0]);
    taut_record_add_numbers(row, "to", 3, ends[1]);
    return TAUT_OK;
}

static taut_record *list_curves(const taut_model *curves, int own)
{
    taut_record *record = taut_record_new();
    taut_record_add_text(record, "unit", taut_model_unit(curves));
    taut_record *list = taut_record_add_list(record, "curves");
    taut_status status = TAUT_OK;
    for (int i = 0; i < taut_model_curve_count(curves) && status == TAUT_OK; i++) {
        status = add_row(taut_model_curve(curves, i), i + 1, i >= own, list);
    }
    if (status != TAUT_OK || taut_record_status(record) != TAUT_OK) {
        taut_record_free(record);
        return NULL;
    }
    return record;
}

/* How many of a model's curves are edges of trimmed faces: the last. */
static int edges_of(const taut_model *model)
{
    const double count = taut_record_number(taut_record_get(taut_model_details(model), "edges"));
    return count >= 0 && count <= taut_model_curve_count(model) ? (int)count : 0;
}

static void print_point(const taut_record *row, const char *member)
{
    const taut_record *point = taut_record_get(row, member);
    printf("  %s", member);
    for (size_t c = 0; c < 3; c++) {
        printf(" %.9g", taut_record_number(taut_record_at(point, c)));
    }
}

static int print_rows(const taut_record *record)
{
    const taut_record *list = taut_record_get(record, "curves");
    for (size_t i = 0; i < taut_record_count(list); i++) {
        const taut_record *row = taut_record_at(list, i);
        printf("%4zu  %-5s  %-24s  %.9g %s", i + 1, taut_record_text(taut_record_get(row, "kind")),
               taut_record_text(taut_record_get(row, "name")),
               taut_record_number(taut_record_get(row, "length")),
               taut_record_text(taut_record_get(record, "unit")));
        print_point(row, "from");
        print_point(row, "to");
        putchar('\n');
    }
    return cli_print_text("", 0);
}

static int run(const cli_options *options)
{
    taut_model *model = NULL, *curves = NULL;
    taut_error error;
    int code = 0;

    if (cli_read_edges(options->files[0], options, &model, &error) != TAUT_OK ||
        taut_model_boundary(model, &curves, &error) != TAUT_OK) {
        taut_model_free(model);
        return cli_fail_in(options->files[0], &error);
    }
    taut_record *record = list_curves(curves, taut_model_curve_count(model) - edges_of(model));
    if (record == NULL) {
        code = cli_no_memory();
    } else if (options->json) {
        code = cli_print_record(record);
    } else {
        code = print_rows(record);
        taut_record_free(record);
    }
    taut_model_free(curves);
    taut_model_free(model);
    return code;
}

static const cli_option options_of_boundary[] = {CLI_JSON, CLI_UNTRIM, CLI_LAST};

const cli_command cli_command_boundary = {
    .name = "boundary",
    .usage = "FILE [--json]",
    .summary = "list the curves and edges that a \"boundary\" may name",
    .text = "Lists the curves of a file and the edges of its surfaces (of a trimmed face the "
            "curves that trim it), one a line: number, kind, name, length, ends. A problem takes "
            "four of them by number or name: \"boundary\": { \"file\": \"FILE\", \"edges\": [1, "
            "2, \"face.u0\", 7] }.",
    .example = "taut boundary hull.step\n",
    .files_min = 1,
    .files_max = 1,
    .options = options_of_boundary,
    .run = run,
};
