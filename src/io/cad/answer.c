/* answer.c -- what taut-cad says is looked at like any input: it may have read a file made to break it. */
#include "io/cad/answer.h"

#include "core/arena.h"
#include "core/fail.h"
#include "geometry/keep.h"
#include "io/json/utf8.h"

#include <string.h>

enum { NOTES_MAX = 100 };

/* Puts what comes next at source->room[0]; 0 at the end. */
static int fill_source(taut_cad_source *source)
{
    source->at = 0;
    source->end = source->more(source->context, source->room, sizeof source->room);
    source->is_dry = source->end == 0;
    return !source->is_dry;
}

static int get_bytes(taut_cad_source *source, void *to, size_t size, size_t count)
{
    char *bytes = to;
    size_t left = size * count;
    while (left > 0) {
        if (source->at == source->end && !fill_source(source)) {
            return 0;
        }
        const size_t have = source->end - source->at, part = left < have ? left : have;
        memcpy(bytes, source->room + source->at, part);
        source->at += part;
        bytes += part;
        left -= part;
    }
    return 1;
}

/* -1 at the end. */
static int get_tag(taut_cad_source *source)
{
    char tag = 0;
    return get_bytes(source, &tag, 1, 1) ? tag : -1;
}

taut_cad_greeting taut_cad_get_hello(taut_cad_source *source, taut_cad_hello *hello)
{
    const taut_cad_hello expected = taut_cad_hello_answer();
    if (!get_bytes(source, hello->mark, 1, sizeof hello->mark)) {
        return TAUT_CAD_SILENT;
    }
    if (memcmp(hello->mark, expected.mark, sizeof hello->mark) != 0) {
        return TAUT_CAD_STRANGER;
    }
    if (!get_bytes(source, &hello->version, sizeof hello->version, 1) ||
        !get_bytes(source, &hello->layout, sizeof hello->layout, 1)) {
        return TAUT_CAD_SILENT;
    }
    return hello->version == expected.version && hello->layout == expected.layout
               ? TAUT_CAD_GREETED
               : TAUT_CAD_OTHER_VERSION;
}

/* Cut to whole characters; what is no UTF-8 becomes '?'. */
static void mend_name(char *name, size_t length)
{
    size_t i = 0;
    while (i < length) {
        const size_t step = name[i] != '\0' ? taut_utf8_length(name + i, length - i) : 0;
        if (step == 0 && length == TAUT_NAME_MAX && length - i < 4) {
            length = i;
        } else if (step == 0) {
            name[i] = '?';
        }
        i += step > 0 ? step : 1;
    }
    name[length] = '\0';
}

static taut_status refuse_stream(taut_error *error)
{
    return taut_fail(error, TAUT_BAD_INPUT, "library", NULL, taut_none, taut_none,
                     "OpenCASCADE gave nothing that can be read");
}

/* Are these numbers that taut takes, before memory is taken for them? */
static taut_status check_head(const taut_cad_item_head *head, taut_error *error)
{
    const int directions = head->count[1] > 0 ? 2 : 1;
    if (head->name_length < 0 || head->name_length > TAUT_NAME_MAX || head->product_length < 0 ||
        head->product_length > TAUT_NAME_MAX || head->colour < 0 || head->colour > 1 << 24 ||
        head->instance < 0 || head->instance > TAUT_OBJECTS_MAX) {
        return refuse_stream(error);
    }
    for (int d = 0; d < directions; d++) {
        if (head->degree[d] < 1 || head->degree[d] > TAUT_DEGREE_MAX ||
            head->count[d] <= head->degree[d] || head->count[d] > TAUT_COUNT_MAX) {
            return taut_fail(error, TAUT_BAD_INPUT, "size", NULL, head->count[d], TAUT_COUNT_MAX,
                             "found degree %d with %d points, expected a degree of 1 to %d and at "
                             "most %d points",
                             head->degree[d], head->count[d], TAUT_DEGREE_MAX, TAUT_COUNT_MAX);
        }
    }
    if (taut_cad_point_count(head) > TAUT_POINTS_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", NULL, (double)taut_cad_point_count(head),
                         TAUT_POINTS_MAX, "found a net of %d x %d points, expected at most %d",
                         head->count[0], head->count[1], TAUT_POINTS_MAX);
    }
    return TAUT_OK;
}

/* An item as it came; the arena owns its numbers. */
typedef struct item_read {
    taut_cad_item_head head;
    char name[TAUT_NAME_MAX + 1], product[TAUT_NAME_MAX + 1];
    double *knots[2], *points, *weights;
    taut_arena *arena;
} item_read;

static taut_status new_basis(const item_read *item, int d, taut_basis **basis, taut_error *error)
{
    const taut_basis_spec spec = {.type = "bspline",
                                  .degree = item->head.degree[d],
                                  .knot_count = (int)taut_cad_knot_count(&item->head, d),
                                  .knots = item->knots[d]};
    const taut_status status = taut_basis_new(&spec, item->head.count[d], basis, error);
    if (status == TAUT_OK && !taut_keep_basis(item->arena, *basis)) {
        return taut_fail_memory(error);
    }
    return status;
}

static taut_status add_curve(const item_read *item, taut_model *model, taut_error *error)
{
    taut_basis *t = NULL;
    taut_curve *curve = NULL;
    taut_status status = new_basis(item, 0, &t, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_curve_new(item->name, t, item->points, item->weights, &curve, error);
    if (status == TAUT_OK && taut_model_add_curve(model, curve) != TAUT_OK) {
        taut_curve_free(curve);
        return taut_fail_memory(error);
    }
    return status;
}

static taut_status add_surface(const item_read *item, taut_model *model, taut_error *error)
{
    taut_basis *u = NULL, *v = NULL;
    taut_surface *surface = NULL;
    taut_status status = new_basis(item, 0, &u, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = new_basis(item, 1, &v, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_surface_new(item->name, u, v, item->points, item->weights, &surface, error);
    if (status == TAUT_OK && taut_model_add_surface(model, surface) != TAUT_OK) {
        taut_surface_free(surface);
        return taut_fail_memory(error);
    }
    return status;
}

/* Says of an item what is to be said; items are counted from 1, as faces are by `taut boundary`. */
static void add_notes(const taut_cad_item_head *head, const char *name, int index,
                      taut_record *notes)
{
    const char *what = head->count[1] > 0 ? "surface" : "curve";
    char text[TAUT_NAME_MAX + 160];
    for (int note = TAUT_CAD_TRIMMED; note <= TAUT_CAD_APPROXIMATE; note *= 2) {
        if ((head->notes & note) != 0 && taut_record_count(notes) < NOTES_MAX) {
            snprintf(text, sizeof text, "%s %d \"%s\": %s", what, index + 1, name,
                     note == TAUT_CAD_TRIMMED
                         ? "the face is trimmed; this is the whole surface under it"
                         : "the original is no NURBS; this comes near it");
            taut_record_add_text(notes, NULL, text);
        }
    }
}

/* What a surface is a part of, and its colour. */
static void add_looks(const item_read *item, taut_cad_result *result)
{
    char colour[8] = "";
    if (item->head.colour > 0) {
        snprintf(colour, sizeof colour, "#%06x", (unsigned)(item->head.colour - 1) & 0xffffffU);
    }
    taut_record_add_text(result->products, NULL, item->product);
    taut_record_add_text(result->colours, NULL, colour);
}

/* Which use of a product a surface is of: numbers come as they appear. */
static taut_status add_use(const item_read *item, taut_cad_result *result, taut_error *error)
{
    const size_t count = taut_record_count(result->uses);
    if (result->uses == NULL || result->instances == NULL) {
        return TAUT_OK;
    }
    if ((size_t)item->head.instance > count) {
        return refuse_stream(error);
    }
    if ((size_t)item->head.instance == count) {
        taut_record *use = taut_record_add_object(result->uses, NULL);
        taut_record_add_text(use, "product", item->product);
        taut_record *rows = taut_record_add_list(use, "placement");
        for (int i = 0; i < 3; i++) {
            taut_record_add_numbers(rows, NULL, 4, item->head.place + 4 * i);
        }
    }
    taut_record_add_number(result->instances, NULL, item->head.instance);
    return TAUT_OK;
}

static taut_status get_numbers(taut_cad_source *source, item_read *item, taut_error *error)
{
    const taut_cad_item_head *head = &item->head;
    const size_t ku = taut_cad_knot_count(head, 0);
    const size_t kv = taut_cad_knot_count(head, 1);
    const size_t n = taut_cad_point_count(head);
    item->knots[0] = taut_arena_take(item->arena, ku, sizeof(double));
    item->knots[1] = taut_arena_take(item->arena, kv, sizeof(double));
    item->points = taut_arena_take(item->arena, n, 3 * sizeof(double));
    item->weights = head->is_rational ? taut_arena_take(item->arena, n, sizeof(double)) : NULL;
    if (taut_arena_status(item->arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return get_bytes(source, item->knots[0], sizeof(double), ku) &&
                   get_bytes(source, item->knots[1], sizeof(double), kv) &&
                   get_bytes(source, item->points, 3 * sizeof(double), n) &&
                   get_bytes(source, item->weights, sizeof(double), head->is_rational ? n : 0)
               ? TAUT_OK
               : refuse_stream(error);
}

static taut_status get_item_into(taut_cad_source *source, item_read *item, taut_cad_result *result,
                                 taut_error *error)
{
    taut_status status = TAUT_OK;
    if (result->model == NULL || !get_bytes(source, &item->head, sizeof item->head, 1)) {
        return refuse_stream(error);
    }
    status = check_head(&item->head, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (!get_bytes(source, item->name, 1, (size_t)item->head.name_length) ||
        !get_bytes(source, item->product, 1, (size_t)item->head.product_length)) {
        return refuse_stream(error);
    }
    mend_name(item->name, (size_t)item->head.name_length);
    mend_name(item->product, (size_t)item->head.product_length);
    const int is_surface = item->head.count[1] > 0;
    const int index = is_surface ? taut_model_surface_count(result->model)
                                 : taut_model_curve_count(result->model);
    status = get_numbers(source, item, error);
    if (status == TAUT_OK && index >= TAUT_OBJECTS_MAX) {
        status = taut_fail(error, TAUT_BAD_INPUT, "size", NULL, index, TAUT_OBJECTS_MAX,
                           "found more than %d %s", TAUT_OBJECTS_MAX,
                           is_surface ? "surfaces" : "curves");
    } else if (status == TAUT_OK) {
        status = (is_surface ? add_surface : add_curve)(item, result->model, error);
    }
    if (status == TAUT_BAD_INPUT) {
        char prefix[48];
        snprintf(prefix, sizeof prefix, "/%s/%d", is_surface ? "surfaces" : "curves", index);
        taut_error_prefix(error, prefix);
    }
    if (status != TAUT_OK) {
        return status;
    }
    add_notes(&item->head, item->name, index, result->notes);
    if (is_surface) {
        add_looks(item, result);
        status = add_use(item, result, error);
    }
    result->trimmed += (item->head.notes & TAUT_CAD_TRIMMED) != 0;
    result->edges += !is_surface && (item->head.notes & TAUT_CAD_EDGE) != 0;
    return status;
}

static taut_status get_item(taut_cad_source *source, taut_cad_result *result, taut_error *error)
{
    item_read item = {.arena = taut_arena_new()};
    const taut_status status = get_item_into(source, &item, result, error);
    taut_arena_free(item.arena);
    return status;
}

static taut_status get_unit(taut_cad_source *source, taut_cad_result *result, taut_error *error)
{
    char unit[TAUT_CAD_UNIT];
    if (result->model == NULL || !get_bytes(source, unit, 1, TAUT_CAD_UNIT) ||
        unit[TAUT_CAD_UNIT - 1] != '\0' || taut_model_set_unit(result->model, unit) != TAUT_OK) {
        return refuse_stream(error);
    }
    return TAUT_OK;
}

/* What came through a pipe may be anything. */
static void end_text(char *text, size_t size)
{
    text[size - 1] = '\0';
}

/* What it could not read, in its own words; they reach terminals, so that only what is printed stays. */
static taut_status get_note(taut_cad_source *source, taut_cad_result *result, taut_error *error)
{
    char note[TAUT_CAD_NOTE_MAX + 1];
    int length = 0;
    if (result->model == NULL || !get_bytes(source, &length, sizeof length, 1) || length < 0 ||
        length > TAUT_CAD_NOTE_MAX || !get_bytes(source, note, 1, (size_t)length)) {
        return refuse_stream(error);
    }
    for (int i = 0; i < length; i++) {
        note[i] = note[i] >= ' ' && note[i] <= '~' ? note[i] : '?';
    }
    note[length] = '\0';
    if (taut_record_count(result->notes) < NOTES_MAX) {
        taut_record_add_text(result->notes, NULL, note);
    }
    return TAUT_OK;
}

static taut_status get_product(taut_cad_source *source, taut_cad_result *result, taut_error *error)
{
    int length = 0;
    if (result->model == NULL || !get_bytes(source, &length, sizeof length, 1) || length < 0 ||
        length > TAUT_NAME_MAX || !get_bytes(source, result->product, 1, (size_t)length)) {
        return refuse_stream(error);
    }
    mend_name(result->product, (size_t)length);
    return TAUT_OK;
}

/* A part of the text of a file that is written. */
static taut_status get_text(taut_cad_source *source, taut_cad_result *result, taut_error *error)
{
    char text[TAUT_CAD_TEXT_MAX];
    int length = 0;
    if (result->text == NULL || !get_bytes(source, &length, sizeof length, 1) || length < 0 ||
        length > TAUT_CAD_TEXT_MAX || !get_bytes(source, text, 1, (size_t)length)) {
        return refuse_stream(error);
    }
    if (fwrite(text, 1, (size_t)length, result->text) != (size_t)length) {
        return taut_fail(error, TAUT_IO, "write", NULL, taut_none, taut_none,
                         "the file cannot be written");
    }
    return TAUT_OK;
}

static taut_status get_end(taut_cad_source *source, taut_cad_result *result, taut_error *error)
{
    taut_error found;
    int status = 0;
    if (!get_bytes(source, &status, sizeof status, 1) ||
        !get_bytes(source, &found, sizeof found, 1)) {
        return TAUT_OK; /* died while saying so */
    }
    end_text(found.reason, sizeof found.reason);
    end_text(found.expected, sizeof found.expected);
    end_text(found.where, sizeof found.where);
    end_text(found.message, sizeof found.message);
    if (status < TAUT_OK || status > TAUT_INTERRUPTED ||
        (status != TAUT_OK && found.reason[0] == '\0')) {
        return refuse_stream(error);
    }
    result->has_ended = 1;
    result->status = (taut_status)status;
    if (status != TAUT_OK && error != NULL) {
        *error = found;
        error->status = result->status;
    }
    return TAUT_OK;
}

taut_status taut_cad_get_all(taut_cad_source *source, taut_cad_result *result, taut_error *error)
{
    taut_status status = TAUT_OK;
    int tag = 0;
    while (status == TAUT_OK && !result->has_ended && (tag = get_tag(source)) != -1) {
        if (tag == 'U') {
            status = get_unit(source, result, error);
        } else if (tag == 'I') {
            status = get_item(source, result, error);
        } else if (tag == 'N') {
            status = get_note(source, result, error);
        } else if (tag == 'P') {
            status = get_product(source, result, error);
        } else if (tag == 'T') {
            status = get_text(source, result, error);
        } else if (tag == 'E') {
            status = get_end(source, result, error);
            if (status == TAUT_OK && !result->has_ended) {
                break;
            }
        } else {
            status = refuse_stream(error);
        }
    }
    return status;
}
