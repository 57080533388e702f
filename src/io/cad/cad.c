/* cad.c -- what OpenCASCADE does: STEP and IGES read, IGES written. */
#include "io/cad/cad.h"
#include "core/arena.h"
#include "core/fail.h"
#include "core/memory.h"
#include "io/cad/helper.h"
#include "io/cad/prepare.h"
#include "io/cad/scan.h"
#include "io/file/in.h"
#include "io/format.h"
#include "mesh/colour.h"
#include "platform/system.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static void set_direction(taut_cad_item *item, int d, const taut_basis *basis)
{
    taut_basis_spec spec;
    taut_basis_spec_of(basis, &spec);
    item->degree[d] = spec.degree;
    item->count[d] = taut_basis_count(basis);
    item->knots[d] = spec.knots;
}

/* Items that borrow all their numbers from a model of NURBS. */
static void list_items(const taut_model *nurbs, taut_cad_item *items)
{
    const int surfaces = taut_model_surface_count(nurbs);
    for (int i = 0; i < surfaces; i++) {
        const taut_surface *surface = taut_model_surface(nurbs, i);
        items[i].name = taut_surface_name(surface);
        set_direction(&items[i], 0, taut_surface_u(surface));
        set_direction(&items[i], 1, taut_surface_v(surface));
        items[i].points = taut_surface_points(surface);
        items[i].weights = taut_surface_weights(surface);
    }
    for (int i = 0; i < taut_model_curve_count(nurbs); i++) {
        const taut_curve *curve = taut_model_curve(nurbs, i);
        taut_cad_item *item = &items[surfaces + i];
        item->name = taut_curve_name(curve);
        set_direction(item, 0, taut_curve_t(curve));
        item->points = taut_curve_points(curve);
        item->weights = taut_curve_weights(curve);
    }
}

static taut_status send_items(const taut_model *nurbs, const taut_cad_facts *facts,
                              const taut_monitor *monitor, FILE *text, taut_arena *arena,
                              taut_error *error)
{
    const int count = taut_model_surface_count(nurbs) + taut_model_curve_count(nurbs);
    taut_cad_item *items = taut_arena_take(arena, (size_t)count, sizeof *items);
    taut_cad_result result = {.text = text};
    const char *const notes[] = {facts->made, facts->exact};

    if (items == NULL) {
        return taut_fail_memory(error);
    }
    list_items(nurbs, items);
    const taut_cad_job job = {.kind = TAUT_CAD_IGES,
                              .unit = taut_model_unit(nurbs),
                              .name = facts->name,
                              .notes = notes,
                              .note_count = 2,
                              .date = facts->date,
                              .precision = facts->precision};
    return taut_cad_run(&job, count, items, monitor, &result, error);
}

/* The file `path`, which is there and empty. */
static taut_status write_items(const taut_model *nurbs, const taut_cad_facts *facts,
                               const taut_monitor *monitor, const char *path, taut_error *error)
{
    FILE *text = NULL;
    const int reason = taut_system_open_device(path, &text);
    if (reason != 0) {
        return taut_fail_file(error, path, "write", reason);
    }
    taut_arena *arena = taut_arena_new();
    taut_status status = send_items(nurbs, facts, monitor, text, arena, error);
    taut_arena_free(arena);
    if (fclose(text) != 0 && status == TAUT_OK) {
        status = taut_fail(error, TAUT_IO, "write", NULL, taut_none, taut_none,
                           "the file cannot be written");
    }
    return status;
}

static taut_status write_iges(const taut_model *model, const taut_write_options *options,
                              const char *path, taut_error *error)
{
    taut_model *nurbs = NULL;
    taut_cad_facts facts;
    taut_arena *arena = taut_arena_new();
    taut_status status = taut_cad_prepare(model, options, arena, &nurbs, &facts, error);

    if (status == TAUT_OK) {
        status = write_items(nurbs, &facts, &options->monitor, path, error);
    }
    taut_model_free(nurbs);
    taut_arena_free(arena);
    if (status == TAUT_OK && options->bound != NULL) {
        *options->bound = taut_cad_bound(&facts);
    }
    return status;
}

/* A file that is there, and nothing else than a file. */
static taut_status check_file(const char *path, taut_error *error)
{
    struct stat about;
    if (stat(path, &about) != 0) {
        return taut_fail_file(error, path, "read", errno);
    }
    if (!S_ISREG(about.st_mode)) {
        return taut_fail_file(error, path, "read", S_ISDIR(about.st_mode) ? EISDIR : ESPIPE);
    }
    return TAUT_OK;
}

/* "line 7" of a text is PATH:7 of the file. */
static void place_line(const char *path, taut_error *error)
{
    static const char line[] = "line ";
    char where[sizeof error->where];
    if (error != NULL && strncmp(error->where, line, sizeof line - 1) == 0) {
        snprintf(where, sizeof where, "%.150s:%.30s", path, error->where + sizeof line - 1);
        memcpy(error->where, where, sizeof where);
    }
}

/* What the file says of itself must hold before the library sees it. */
static taut_status scan_file(taut_cad_kind kind, const char *path, taut_error *error)
{
    char *text = NULL;
    size_t length = 0;
    taut_status status = taut_file_read(path, &text, &length, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = (kind == TAUT_CAD_STEP ? taut_cad_scan_step : taut_cad_scan_iges)(text, length, error);
    if (status != TAUT_OK) {
        place_line(path, error);
    }
    taut_free(text);
    return status;
}

/* Do its surfaces belong to several products? */
static int has_products(const taut_record *products)
{
    int several = 0;
    for (size_t i = 1; i < taut_record_count(products); i++) {
        several = several || strcmp(taut_record_text(taut_record_at(products, i)),
                                    taut_record_text(taut_record_at(products, 0))) != 0;
    }
    return several;
}

/* What a product is called; "" for OpenCASCADE's own words for what has no name. */
static const char *own_name(const char *name)
{
    static const char nameless[] = "Open CASCADE STEP translator";
    return strncmp(name, nameless, sizeof nameless - 1) == 0 ? "" : name;
}

/* The whole of an assembly; else the one product of a file, where it says more than the name of the first surface; else "". */
static const char *product_of(const taut_cad_result *result)
{
    const char *whole = own_name(result->product);
    if (whole[0] != '\0' || taut_record_count(result->products) == 0 ||
        has_products(result->products)) {
        return whole;
    }
    const char *name = own_name(taut_record_text(taut_record_at(result->products, 0)));
    return strcmp(name, taut_surface_name(taut_model_surface(result->model, 0))) == 0 ? "" : name;
}

/* Is this the whole itself, with surfaces that are in no part of it? */
static int is_whole(const taut_cad_result *result, const taut_record *use)
{
    static const double here[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    int stays = result->product[0] != '\0' &&
                strcmp(taut_record_text(taut_record_get(use, "product")), result->product) == 0;
    for (size_t k = 0; k < 12; k++) {
        const taut_record *row = taut_record_at(taut_record_get(use, "placement"), k / 4);
        stays = stays && taut_record_number(taut_record_at(row, k % 4)) == here[k];
    }
    return stays;
}

/* More than one use of a product, or one within a whole of another name. */
static int has_parts(const taut_cad_result *result)
{
    const char *whole = own_name(result->product);
    return taut_record_count(result->uses) > 1 ||
           (taut_record_count(result->uses) == 1 && whole[0] != '\0' &&
            !is_whole(result, taut_record_at(result->uses, 0)));
}

/* Are there colours other than those that taut gives? */
static int has_colours(const taut_record *colours, const taut_model *model)
{
    int other = 0;
    for (int i = 0; i < (int)taut_record_count(colours) && !other; i++) {
        const char *text = taut_record_text(taut_record_at(colours, (size_t)i));
        char own[8];
        const taut_ink ink = taut_colour_plain(taut_colour_of_surface(model, i));
        snprintf(own, sizeof own, "#%02x%02x%02x", (unsigned)ink.r, (unsigned)ink.g,
                 (unsigned)ink.b);
        other = text[0] != '\0' && strcmp(text, own) != 0;
    }
    return other;
}

/* The parts of an assembly: of each use of a product its name, place and surfaces. IGES has no products, and places there are of
 * faces: a cone of FreeCAD lies otherwise than its ends. */
static void add_parts(const taut_cad_result *result, taut_record *details)
{
    taut_record *parts = taut_record_add_list(details, "parts");
    for (size_t p = 0; p < taut_record_count(result->uses); p++) {
        const taut_record *use = taut_record_at(result->uses, p);
        if (is_whole(result, use)) {
            continue;
        }
        taut_record *made = taut_record_add_object(parts, NULL);
        taut_record_add_record(made, "product", taut_record_get(use, "product"));
        taut_record_add_record(made, "placement", taut_record_get(use, "placement"));
        taut_record *surfaces = taut_record_add_list(made, "surfaces");
        for (size_t i = 0; i < taut_record_count(result->instances); i++) {
            if (taut_record_number(taut_record_at(result->instances, i)) == (double)p) {
                taut_record_add_number(surfaces, NULL, (double)i);
            }
        }
    }
}

/* What was read, with what there is to say of it. */
static taut_status finish_model(taut_cad_kind kind, taut_cad_result *result, taut_error *error)
{
    taut_record *details = taut_record_new();
    int is_said = taut_record_count(result->notes) > 0;
    if (taut_record_status(result->notes) != TAUT_OK ||
        taut_record_status(result->products) != TAUT_OK ||
        taut_record_status(result->uses) != TAUT_OK ||
        taut_record_status(result->instances) != TAUT_OK ||
        taut_record_status(result->colours) != TAUT_OK) {
        taut_record_free(details);
        return taut_fail_memory(error);
    }
    taut_record_add_text(details, "read_from", kind == TAUT_CAD_STEP ? "STEP" : "IGES");
    taut_record_add_number(details, "trimmed", result->trimmed);
    if (result->edges > 0) {
        taut_record_add_number(details, "edges", result->edges);
        is_said = 1;
    }
    taut_record_add_record(details, "notes", result->notes);
    if (has_products(result->products)) {
        taut_record_add_record(details, "products", result->products);
        is_said = 1;
    }
    if (product_of(result)[0] != '\0') {
        taut_record_add_text(details, "product", product_of(result));
        is_said = 1;
    }
    if (has_parts(result) && kind == TAUT_CAD_STEP) {
        add_parts(result, details);
        is_said = 1;
    }
    if (has_colours(result->colours, result->model)) {
        taut_record_add_record(details, "colours", result->colours);
        is_said = 1;
    }
    if (taut_record_status(details) != TAUT_OK) {
        taut_record_free(details);
        return taut_fail_memory(error);
    }
    if (is_said) {
        taut_model_set_details(result->model, details);
    } else {
        taut_record_free(details);
    }
    return TAUT_OK;
}

static taut_status read_items(const taut_cad_job *job, const taut_monitor *monitor,
                              taut_cad_result *result, taut_error *error)
{
    taut_status status = TAUT_OK;
    result->notes = taut_record_new_list();
    result->products = taut_record_new_list();
    result->colours = taut_record_new_list();
    result->instances = taut_record_new_list();
    result->uses = taut_record_new_list();
    if (result->notes == NULL || result->products == NULL || result->colours == NULL ||
        result->instances == NULL || result->uses == NULL ||
        taut_model_new(&result->model) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = taut_cad_run(job, 0, NULL, monitor, result, error);
    return status == TAUT_OK ? finish_model(job->kind, result, error) : status;
}

static taut_status read_cad(taut_cad_kind kind, const char *path, const taut_read_options *options,
                            taut_model **model, taut_error *error)
{
    const taut_cad_job job = {.kind = kind, .path = path, .edges = options->edges != 0};
    taut_cad_result result = {.text = NULL};
    taut_status status = check_file(path, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = scan_file(kind, path, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_items(&job, &options->monitor, &result, error);
    taut_record_free(result.notes);
    taut_record_free(result.products);
    taut_record_free(result.colours);
    taut_record_free(result.instances);
    taut_record_free(result.uses);
    if (status != TAUT_OK) {
        taut_model_free(result.model);
        return status;
    }
    *model = result.model;
    return TAUT_OK;
}

taut_status taut_cad_read_step(const char *path, const taut_read_options *options,
                               taut_model **model, taut_error *error)
{
    return read_cad(TAUT_CAD_STEP, path, options, model, error);
}

static taut_status read_iges(const char *path, const taut_read_options *options, taut_model **model,
                             taut_error *error)
{
    return read_cad(TAUT_CAD_IGES, path, options, model, error);
}

const taut_format_ops taut_format_iges = {.write_path = write_iges, .read = read_iges};
