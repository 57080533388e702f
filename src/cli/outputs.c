/* outputs.c -- writing what a command made, whole or not at all, also when interrupted. */
#include "cli/cli.h"
#include "platform/system.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const taut_outputs *volatile at_risk; /* what an interrupt must remove */

#define STOPPED(code)                                                                              \
    "{ \"error\": { \"exit\": " code                                                               \
    ", \"reason\": \"interrupted\", \"where\": \"\", \"message\": "                                \
    "\"stopped on request\", \"found\": null, \"expected\": null } }\n"

/* Removes what is half done; one line for a program, made beforehand: a handler may not format. */
static void stopped(int code)
{
    static const struct {
        int code;
        const char *line;
    } lines[] = {{130, STOPPED("130")}, {143, STOPPED("143")}, {129, STOPPED("129")}};
    if (at_risk != NULL) {
        taut_outputs_abandon(at_risk);
    }
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        if (lines[i].code == code && cli_speaks_json()) {
            taut_system_say(lines[i].line);
        }
    }
}

void cli_catch_signals(void)
{
    taut_system_on_interrupt(stopped);
}

int cli_outputs_new(taut_outputs **outputs)
{
    if (taut_outputs_new(outputs) != TAUT_OK) {
        return cli_no_memory();
    }
    at_risk = *outputs;
    cli_catch_signals();
    return 0;
}

void cli_outputs_free(taut_outputs *outputs)
{
    at_risk = NULL;
    taut_outputs_free(outputs);
}

int cli_commit(taut_outputs *outputs)
{
    taut_error error;
    return taut_outputs_commit(outputs, &error) == TAUT_OK ? 0 : cli_fail(&error);
}

/* "1:20" as 20. */
static int reduction_of(const char *word, double *reduction)
{
    return strncmp(word, "1:", 2) == 0 && cli_number(word + 2, reduction) && *reduction > 0;
}

/* How plans of flat pieces are printed. */
static int take_paper(const cli_options *options, taut_write_options *chosen)
{
    if (options->tiles != NULL) {
        chosen->tiles = strcmp(options->tiles, "a4") == 0   ? TAUT_PAPER_A4
                        : strcmp(options->tiles, "a3") == 0 ? TAUT_PAPER_A3
                                                            : TAUT_PAPER_NONE;
        if (chosen->tiles == TAUT_PAPER_NONE) {
            return cli_misuse_value("--tiles", options->tiles, "a4 or a3");
        }
    }
    if (options->scale != NULL && !reduction_of(options->scale, &chosen->reduction)) {
        return cli_misuse_value("--scale", options->scale, "1:N, such as 1:20");
    }
    return options->tiles != NULL && options->scale != NULL
               ? cli_misuse("option",
                            "--tiles are 1:1, and --scale is something else: give one of them")
               : 0;
}

int cli_write_options(const cli_options *options, taut_write_options *chosen)
{
    static const struct {
        const char *word;
        taut_colour colour;
    } colours[] = {{"H", TAUT_COLOUR_MEAN},          {"K", TAUT_COLOUR_GAUSSIAN},
                   {"I", TAUT_COLOUR_ISOTHERMALITY}, {"gap", TAUT_COLOUR_GAP},
                   {"warp", TAUT_COLOUR_WARP},       {"weft", TAUT_COLOUR_WEFT},
                   {"strain", TAUT_COLOUR_STRAIN}};

    *chosen = (taut_write_options){.tolerance = options->tolerance,
                                   .formats = taut_draw_formats(),
                                   .divide = options->divide,
                                   .thickness = options->sheet,
                                   .coefficients = options->coefficients,
                                   .lagrange = options->lagrange,
                                   .threads = options->threads,
                                   .surface = options->surface,
                                   .short_knots = options->short_knots,
                                   .no_net = options->no_net     ? 1
                                             : options->show_net ? -1
                                                                 : 0,
                                   .title = options->title,
                                   .isolines = options->isolines,
                                   .reflections = options->reflections,
                                   .combs = options->combs,
                                   .reactions = options->reactions,
                                   .column = options->column,
                                   .side_by_side = options->side_by_side,
                                   .width = options->width,
                                   .monitor = cli_monitor(options->quiet || options->json)};
    if (options->colour != NULL) {
        for (size_t i = 0; i < sizeof colours / sizeof colours[0]; i++) {
            if (strcmp(options->colour, colours[i].word) == 0) {
                chosen->colour = colours[i].colour;
            }
        }
        if (chosen->colour == TAUT_COLOUR_PLAIN) {
            return cli_misuse_value("--colour", options->colour,
                                    "H, K, I, gap, warp, weft or strain");
        }
    }
    if (options->view != NULL) {
        chosen->has_view = 1;
        if (!cli_pair(options->view, &chosen->view[0], &chosen->view[1])) {
            return cli_misuse_value("--view", options->view,
                                    "two numbers, azimuth and elevation in degrees");
        }
    }
    return take_paper(options, chosen);
}

/* For an ending that others write and taut does not: what to take instead, or "". */
static const char *instead_of(const char *path)
{
    static const struct {
        const char *endings, *hint;
    } rows[] = {
        {" .jpg .jpeg .gif .bmp .tif .tiff .webp .eps ", "; a picture is .png, .svg or .pdf"},
        {" .dwg ", "; a drawing is .dxf"},
        {" .gltf .fbx .dae .off .amf ", "; a mesh is .glb, .obj, .stl, .ply or .3mf"},
        {" .3dm .sat .x_t .brep .fcstd .sldprt ", "; a surface for CAD is .step or .igs"},
        {" .xlsx .xls .ods .tsv .txt ", "; a table is .csv"},
        {" .vtk .vts ", "; ParaView reads .vtu"}};
    const char *dot = strrchr(taut_system_last_part(path), '.');
    char word[16];

    if (dot != NULL && strlen(dot) < sizeof word - 2) {
        snprintf(word, sizeof word, " %s ", dot);
        for (char *c = word; *c != '\0'; c++) {
            *c = *c >= 'A' && *c <= 'Z' ? (char)(*c + ('a' - 'A')) : *c;
        }
        for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
            if (strstr(rows[i].endings, word) != NULL) {
                return rows[i].hint;
            }
        }
    }
    return "";
}

/* A folder that is not there is told before anything is made for it. A % takes the number of a list's item later. */
static int check_folder(const char *path)
{
    const int folder = (int)(taut_system_last_part(path) - path);
    taut_target_kind kind = TAUT_TARGET_FILE;
    char target[TAUT_PATH_ROOM];

    if (folder == 0 || strchr(path, '%') != NULL ||
        taut_system_target(path, &kind, target) != ENOENT) {
        return 0;
    }
    taut_error error = {
        .status = TAUT_IO, .reason = "write", .found = (double)NAN, .limit = (double)NAN};
    snprintf(error.message, sizeof error.message,
             "cannot write %.200s: there is no folder %.*s: make it first, or write elsewhere",
             path, folder < 200 ? folder : 200, path);
    return cli_fail_at(path, &error);
}

/* Do sheets of a thickness go there? */
static int takes_thickness(const char *path)
{
    static const char thick[] = " 3mf glb iges igs obj ply step stl stp ";
    taut_error error;
    const char *ending = taut_formats_ending(taut_draw_formats(), path, &error);
    char word[24] = "";
    if (ending != NULL) {
        snprintf(word, sizeof word, " %s ", ending);
    }
    return word[0] != '\0' && strstr(thick, word) != NULL;
}

/* A thickness that nothing is written with is refused; a picture beside what has it shows the surface itself, which is said. */
static int check_thickness(const cli_options *options)
{
    int taken = 0;
    for (int i = 0; i < options->output_count; i++) {
        taken += takes_thickness(options->outputs[i]);
    }
    if (options->sheet > 0 && taken == 0) {
        return cli_misuse("option", "--thickness makes sheets in STEP, IGES and meshes (.3mf, "
                                    ".glb, .obj, .ply, .stl): give -o such a file");
    }
    for (int i = 0; options->sheet > 0 && i < options->output_count; i++) {
        if (!takes_thickness(options->outputs[i]) && !cli_is_json(options->outputs[i])) {
            cli_warn(options->outputs[i], "--thickness makes no difference here: it is of STEP, "
                                          "IGES and meshes");
        }
    }
    return 0;
}

int cli_check_outputs(const cli_options *options)
{
    for (int i = 0; i < options->output_count; i++) {
        taut_error error;
        if (taut_formats_ending(taut_draw_formats(), options->outputs[i], &error) == NULL) {
            return cli_misuse_path(error.reason, options->outputs[i], "-o %s: %s%s",
                                   options->outputs[i], error.message,
                                   instead_of(options->outputs[i]));
        }
        const int code = check_folder(options->outputs[i]);
        if (code != 0) {
            return code;
        }
        for (int j = 0; j < i; j++) {
            if (strcmp(options->outputs[i], options->outputs[j]) == 0) {
                return cli_misuse_path("option", options->outputs[i], "-o %s is given twice",
                                       options->outputs[i]);
            }
        }
    }
    const int code = check_thickness(options);
    return code == 0 && options->report != NULL ? check_folder(options->report) : code;
}

const char *cli_distance(double bound, const taut_model *model, char room[CLI_DISTANCE_ROOM])
{
    if (bound > 0) {
        snprintf(room, CLI_DISTANCE_ROOM, ", within %.3g %s", bound, taut_model_unit(model));
    } else {
        snprintf(room, CLI_DISTANCE_ROOM, "%s", bound == 0 ? ", exact" : "");
    }
    return room;
}

int cli_is_json(const char *path)
{
    taut_error error;
    const char *ending = taut_formats_ending(taut_draw_formats(), path, &error);
    return ending != NULL && strcmp(ending, "json") == 0;
}

int cli_is_picture(const char *path)
{
    static const char *const pictures[] = {"html", "pdf", "png", "svg"};
    taut_error error;
    const char *ending = taut_formats_ending(taut_draw_formats(), path, &error);
    for (size_t i = 0; ending != NULL && i < sizeof pictures / sizeof pictures[0]; i++) {
        if (strcmp(ending, pictures[i]) == 0) {
            return 1;
        }
    }
    return 0;
}

int cli_write_model(const taut_model *model, const cli_options *options)
{
    return cli_write_or_nurbs(model, NULL, 0, NULL, options);
}

int cli_write_or_nurbs(const taut_model *model, const taut_model *nurbs, double bound,
                       const taut_model *shown, const cli_options *options)
{
    static const char *const standard[] = {"-"};
    const char *const *paths = options->output_count > 0 ? options->outputs : standard;
    const int count = options->output_count > 0 ? options->output_count : 1;
    taut_write_options chosen;
    taut_outputs *outputs = NULL;
    taut_model *strips = NULL;
    taut_error error;
    double bounds[CLI_LIST_MAX];
    int code = cli_write_options(options, &chosen);

    chosen.threads = cli_threads_of(options, model);
    if (code == 0) {
        code = cli_outputs_new(&outputs);
    }
    for (int i = 0; i < count && code == 0; i++) {
        const int stands_in = nurbs != NULL && cli_is_json(paths[i]);
        const taut_model *written = stands_in                                   ? nurbs
                                    : shown != NULL && cli_is_picture(paths[i]) ? shown
                                                                                : model;
        if (written == model && options->surface == NULL) {
            code = cli_strips(model, options, paths[i], &strips, &written);
        }
        bounds[i] = stands_in ? bound : (double)NAN;
        chosen.bound = &bounds[i];
        if (code == 0 &&
            taut_outputs_model(outputs, written, paths[i], &chosen, &error) != TAUT_OK) {
            code = cli_fail_at(paths[i], &error);
        }
    }
    if (code == 0) {
        code = cli_commit(outputs);
    }
    taut_model_free(strips);
    cli_monitor_done();
    /* what was approximated is said */
    for (int i = 0; i < count && code == 0 && !options->json && !options->quiet; i++) {
        char distance[CLI_DISTANCE_ROOM];
        if (bounds[i] > 0) {
            fprintf(stderr, "%s%s of the model\n", paths[i],
                    cli_distance(bounds[i], model, distance));
        }
    }
    cli_outputs_free(outputs);
    return code;
}

void cli_label(const char *file, char *text, size_t size)
{
    const char *name = taut_system_last_part(file);
    const char *dot = strrchr(name, '.');
    const size_t length = dot != NULL && dot > name ? (size_t)(dot - name) : strlen(name);
    snprintf(text, size, "%.*s", (int)(length < size ? length : size - 1), name);
}

int cli_write_models(int count, const taut_model *const *models, const cli_options *options)
{
    char texts[TAUT_MODELS_MAX][128];
    const char *labels[TAUT_MODELS_MAX];
    taut_write_options chosen;
    taut_outputs *outputs = NULL;
    taut_error error;
    int code = cli_write_options(options, &chosen);

    for (int i = 0; i < count; i++) {
        cli_label(options->files[i], texts[i], sizeof texts[i]);
        labels[i] = texts[i];
    }
    chosen.labels = labels;
    if (code == 0) {
        code = cli_outputs_new(&outputs);
    }
    for (int i = 0; i < options->output_count && code == 0; i++) {
        if (taut_outputs_models(outputs, count, models, options->outputs[i], &chosen, &error) !=
            TAUT_OK) {
            code = cli_fail_at(options->outputs[i], &error);
        }
    }
    if (code == 0) {
        code = cli_commit(outputs);
    }
    cli_monitor_done();
    cli_outputs_free(outputs);
    return code;
}

int cli_print_text(const char *text, size_t length)
{
    if (fwrite(text, 1, length, stdout) != length || fflush(stdout) != 0 || ferror(stdout)) {
        taut_error error = {.status = TAUT_IO,
                            .reason = "write",
                            .where = "standard output",
                            .found = (double)NAN,
                            .limit = (double)NAN,
                            .message = "it could not be written"};
        return cli_fail(&error);
    }
    return 0;
}

/* The record as JSON, freed by taut_text_free; 0 or the exit code. Frees the record. */
static int text_of(taut_record *record, char **text, size_t *length)
{
    const int is_whole =
        taut_record_status(record) == TAUT_OK && taut_record_write(record, text, length) == TAUT_OK;
    taut_record_free(record);
    return is_whole ? 0 : cli_no_memory();
}

int cli_print_record(taut_record *record)
{
    char *text = NULL;
    size_t length = 0;
    int code = text_of(record, &text, &length);

    if (code == 0) {
        code = cli_print_text(text, length);
    }
    taut_text_free(text);
    return code;
}

int cli_report_json(taut_record *record)
{
    char *text = NULL;
    size_t length = 0;
    const int code = text_of(record, &text, &length);

    if (code == 0) {
        fwrite(text, 1, length, stderr);
    }
    taut_text_free(text);
    return code;
}
