/* measure.c -- taut measure: lengths, areas, energies, curvatures. */
#include "cli/cli.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The measurements of a model as the contract's record. */
static taut_status measure_model(const taut_model *model, const cli_options *options,
                                 taut_record *record, taut_error *error)
{
    const taut_measure_options chosen = {.grid = options->grid,
                                         .threads = cli_threads_of(options, model),
                                         .monitor = cli_monitor(options->json)};
    taut_record *surfaces = taut_record_add_list(record, "surfaces");
    taut_record *curves = taut_record_add_list(record, "curves");
    taut_status status = TAUT_OK;

    for (int i = 0; i < taut_model_surface_count(model) && status == TAUT_OK; i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        taut_surface_measure measure;
        if (options->surface != NULL && strcmp(options->surface, taut_surface_name(surface)) != 0) {
            continue;
        }
        status = taut_measure_surface(surface, &chosen, &measure, error);
        if (status == TAUT_OK) {
            taut_measure_surface_record(surface, &measure, taut_record_add_object(surfaces, NULL));
        }
    }
    for (int i = 0;
         i < taut_model_curve_count(model) && status == TAUT_OK && options->surface == NULL; i++) {
        taut_curve_measure measure;
        status = taut_measure_curve(taut_model_curve(model, i), &chosen, &measure, error);
        if (status == TAUT_OK) {
            taut_measure_curve_record(taut_model_curve(model, i), &measure,
                                      taut_record_add_object(curves, NULL));
        }
    }
    return status;
}

/* Of several surfaces, or curves: how many there are, and their areas and lengths in all; null where one has none. */
static void add_together(taut_record *record)
{
    static const struct {
        const char *list, *member, *all;
    } rows[] = {{"surfaces", "area", "surface_area"}, {"curves", "length", "curve_length"}};
    taut_record *together = NULL;

    for (size_t r = 0; r < 2; r++) {
        const taut_record *list = taut_record_get(record, rows[r].list);
        const size_t count = taut_record_count(list);
        double sum = 0;
        for (size_t k = 0; k < count; k++) {
            const taut_record *value = taut_record_get(taut_record_at(list, k), rows[r].member);
            sum +=
                taut_record_kind_of(value) == TAUT_RECORD_NUMBER ? taut_record_number(value) : NAN;
        }
        if (count > 1) {
            together = together == NULL ? taut_record_add_object(record, "together") : together;
            taut_record_add_number(together, rows[r].list, (double)count);
            taut_record_add_number(together, rows[r].all, sum);
        }
    }
}

static int is_numbers(const taut_record *value)
{
    return taut_record_kind_of(value) == TAUT_RECORD_LIST &&
           taut_record_kind_of(taut_record_at(value, 0)) == TAUT_RECORD_NUMBER;
}

static void print_value(const taut_record *value, int digits)
{
    switch (taut_record_kind_of(value)) {
    case TAUT_RECORD_NUMBER:
        printf("%.*g", digits, taut_record_number(value));
        break;
    case TAUT_RECORD_TEXT:
        fputs(taut_record_text(value), stdout);
        break;
    case TAUT_RECORD_BOOL:
        fputs(taut_record_bool(value) ? "yes" : "no", stdout);
        break;
    case TAUT_RECORD_LIST: /* of numbers, or of such lists */
        for (size_t i = 0; i < taut_record_count(value); i++) {
            fputs(i == 0 ? "" : is_numbers(value) ? " " : "  to  ", stdout);
            print_value(taut_record_at(value, i), digits);
        }
        break;
    case TAUT_RECORD_OBJECT:
    case TAUT_RECORD_NULL:
    default:
        putchar('-');
        break;
    }
}

/* Parameters, which have no unit, as "max_abs_at". */
static int is_place(const char *key)
{
    const size_t length = strlen(key);
    return length > 3 && strcmp(key + length - 3, "_at") == 0;
}

/* As many digits as are vouched for: all of the box, whose corners may be control points; one more than integrals are good
 * to; four of extremes, which are sought on a grid, and of the mean of |H|. */
static int digits_of(const char *key)
{
    static const char *const sought[] = {"max_", "min_", "mean_"};
    int is_sought = strcmp(key, "max") == 0 || strcmp(key, "min") == 0;
    for (size_t i = 0; i < sizeof sought / sizeof sought[0]; i++) {
        is_sought |= strncmp(key, sought[i], strlen(sought[i])) == 0;
    }
    return is_sought ? 4 : strcmp(key, "bounding_box") == 0 ? 15 : 11;
}

/* One line a member; objects indent theirs. */
static void print_lines(const taut_record *record, const char *unit, const char *above, int indent)
{
    char room[CLI_UNIT_ROOM];
    for (size_t i = 0; i < taut_record_count(record); i++) {
        const taut_record *value = taut_record_at(record, i);
        printf("%*s%-*s", indent, "", 30 - indent, taut_record_key(record, i));
        if (taut_record_kind_of(value) == TAUT_RECORD_OBJECT) {
            putchar('\n');
            print_lines(value, unit, taut_record_key(record, i), indent + 2);
        } else {
            print_value(value, digits_of(taut_record_key(record, i)));
            cli_unit_of(taut_record_key(record, i), unit, room);
            puts(room[0] != '\0'                        ? room
                 : is_place(taut_record_key(record, i)) ? ""
                                                        : cli_unit_of(above, unit, room));
        }
    }
}

static int has_surface(const taut_model *model, const char *name)
{
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        if (strcmp(name, taut_surface_name(taut_model_surface(model, i))) == 0) {
            return 1;
        }
    }
    return 0;
}

/* What the reader of a CAD file had to say: for programs, beside the numbers. */
static void add_notes(const taut_model *model, taut_record *record)
{
    const taut_record *details = taut_model_details(model);
    const taut_record *notes = taut_record_get(details, "notes");
    if (taut_record_get(details, "read_from") != NULL && taut_record_count(notes) > 0) {
        taut_record_add_record(record, "notes", notes);
    }
}

static int run(const cli_options *options)
{
    taut_model *model = NULL;
    taut_record *record = NULL;
    taut_error error = {.status = TAUT_NO_MEMORY, .reason = "memory", .message = "memory ran out"};
    cli_options reading = *options;
    reading.quiet = options->json; /* which has the notes */
    taut_status status = cli_read_model(options->files[0], &reading, &model, &error);
    int code = 0;

    if (status == TAUT_OK && options->surface != NULL && !has_surface(model, options->surface)) {
        taut_model_free(model);
        return cli_misuse("name", "--surface %.80s: the model has no surface of that name",
                          options->surface);
    }
    if (status == TAUT_OK) {
        record = taut_record_new();
        status = measure_model(model, options, record, &error);
        cli_monitor_done();
    }
    if (status == TAUT_OK) {
        add_together(record);
        taut_record_add_text(record, "unit", taut_model_unit(model));
        add_notes(model, record);
        status = taut_record_status(record);
    }
    if (status != TAUT_OK) {
        code = cli_fail_in(options->files[0], &error);
    } else if (options->json) {
        code = cli_print_record(record);
        record = NULL;
    } else {
        for (size_t i = 0; i < 2; i++) {
            const taut_record *list = taut_record_at(record, i);
            for (size_t k = 0; k < taut_record_count(list); k++) {
                print_lines(taut_record_at(list, k), taut_model_unit(model), "", 0);
            }
        }
        const taut_record *together = taut_record_get(record, "together");
        if (taut_record_count(together) > 0) {
            puts("together");
            print_lines(together, taut_model_unit(model), "", 2);
        }
        code = cli_print_text("", 0);
    }
    taut_record_free(record);
    taut_model_free(model);
    return code;
}

static const cli_option options_of_measure[] = {CLI_JSON,
                                                {"--grid", CLI_INTEGER, offsetof(cli_options, grid),
                                                 0, 2, TAUT_GRID_MAX, "N",
                                                 "extremes over N x N parameters (default 101)"},
                                                CLI_SURFACE,
                                                CLI_UNTRIM,
                                                CLI_THREADS,
                                                CLI_LAST};

const cli_command cli_command_measure = {
    .name = "measure",
    .usage = "MODEL.json [--json] [--grid N]",
    .summary = "areas, energies, curvatures, edges of a model",
    .text = "Integrals are good to 1e-10 relative; extremes are over a closed uniform grid of "
            "parameters.\n",
    .example = "taut measure model.json --grid 201\n",
    .files_min = 1,
    .files_max = 1,
    .options = options_of_measure,
    .run = run,
};
