#include "io/flat/flat.h"

#include "core/fail.h"
#include "io/flat/cloth.h"

#include <math.h>

/* Between two sheets, over the larger side of one. */
static const double aside = 0.1;

enum { CUT, SLOT, ENGRAVE, SHEET, LAYERS };
static const taut_flat_layer lath_layers[LAYERS] = {[CUT] = {"CUT", "1", "#d00000"},
                                                    [SLOT] = {"SLOT", "5", "#0000d0"},
                                                    [ENGRAVE] = {"ENGRAVE", "3", "#008000"},
                                                    [SHEET] = {"SHEET", "8", "#808080"}};

typedef struct reading {
    taut_arena *arena;
    taut_flat *flat;
    double size[2], step; /* of a sheet, and from one to the next */
    double shift;         /* of the piece's */
    int is_wrong;
} reading;

static const taut_record *member(const taut_record *object, const char *key)
{
    return object != NULL && taut_record_kind_of(object) == TAUT_RECORD_OBJECT
               ? taut_record_get(object, key)
               : NULL;
}

static size_t count_of(const taut_record *list)
{
    return list != NULL && taut_record_kind_of(list) == TAUT_RECORD_LIST ? taut_record_count(list)
                                                                         : 0;
}

static double number(reading *r, const taut_record *record)
{
    const int is_number = record != NULL && taut_record_kind_of(record) == TAUT_RECORD_NUMBER;
    r->is_wrong |= !is_number;
    return is_number ? taut_record_number(record) : 0;
}

static void pair(reading *r, const taut_record *list, double out[2])
{
    const int is_pair = count_of(list) == 2;
    r->is_wrong |= !is_pair;
    for (size_t d = 0; d < 2; d++) {
        out[d] = is_pair ? number(r, taut_record_at(list, d)) : 0;
    }
}

static void add_line(reading *r, int layer, const taut_record *points)
{
    const size_t count = count_of(points);
    double(*own)[2] = taut_arena_take(r->arena, count + 1, sizeof *own);
    r->is_wrong |= count < 2;
    for (size_t k = 0; own != NULL && k < count; k++) {
        pair(r, taut_record_at(points, k), own[k]);
        own[k][0] += r->shift;
    }
    r->flat->lines[r->flat->line_count++] =
        (taut_flat_line){layer, layer != ENGRAVE, count, (const double(*)[2])own};
}

static void add_text(reading *r, const taut_record *text)
{
    const taut_record *word = member(text, "text");
    taut_flat_text *to = &r->flat->texts[r->flat->text_count++];
    r->is_wrong |= word == NULL || taut_record_kind_of(word) != TAUT_RECORD_TEXT;
    to->text = r->is_wrong ? "" : taut_record_text(word);
    pair(r, member(text, "at"), to->at);
    to->at[0] += r->shift;
    to->angle = number(r, member(text, "angle"));
    to->height = number(r, member(text, "height"));
}

static void add_piece(reading *r, const taut_record *piece)
{
    const taut_record *slots = member(piece, "slots"), *lines = member(piece, "lines");
    const taut_record *texts = member(piece, "texts");
    r->shift = (number(r, member(piece, "sheet")) - 1) * r->step;
    add_line(r, CUT, member(piece, "outline"));
    for (size_t k = 0; k < count_of(slots); k++) {
        add_line(r, SLOT, member(taut_record_at(slots, k), "outline"));
    }
    for (size_t k = 0; k < count_of(lines); k++) {
        add_line(r, ENGRAVE, taut_record_at(lines, k));
    }
    for (size_t k = 0; k < count_of(texts); k++) {
        add_text(r, taut_record_at(texts, k));
    }
}

static void add_sheet(reading *r, size_t index)
{
    const double x = (double)index * r->step;
    double(*corners)[2] = taut_arena_take(r->arena, 4, sizeof *corners);
    for (int k = 0; corners != NULL && k < 4; k++) {
        corners[k][0] = x + (k == 1 || k == 2 ? r->size[0] : 0);
        corners[k][1] = k >= 2 ? r->size[1] : 0;
    }
    r->flat->lines[r->flat->line_count++] =
        (taut_flat_line){SHEET, 1, 4, (const double(*)[2])corners};
}

/* How many lines and texts there are. */
static void count_all(const taut_record *pieces, size_t *lines, size_t *texts)
{
    for (size_t k = 0; k < count_of(pieces); k++) {
        const taut_record *piece = taut_record_at(pieces, k);
        *lines += 1 + count_of(member(piece, "slots")) + count_of(member(piece, "lines"));
        *texts += count_of(member(piece, "texts"));
    }
}

int taut_flat_is(const taut_model *model)
{
    return taut_flat_is_cloth(model) ||
           (count_of(member(taut_model_details(model), "pieces")) > 0 &&
            count_of(member(taut_model_details(model), "sheets")) > 0);
}

static taut_status read_laths(const taut_model *model, taut_arena *arena, taut_flat *flat,
                              taut_error *error)
{
    const taut_record *details = taut_model_details(model);
    const taut_record *sheets = member(details, "sheets"), *pieces = member(details, "pieces");
    reading r = {.arena = arena, .flat = flat};
    size_t lines = count_of(sheets), texts = 0;

    count_all(pieces, &lines, &texts);
    *flat = (taut_flat){.layer_count = LAYERS,
                        .text_layer = ENGRAVE,
                        .layers = lath_layers,
                        .lines = taut_arena_take(arena, lines + 1, sizeof *flat->lines),
                        .texts = taut_arena_take(arena, texts + 1, sizeof *flat->texts)};
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (count_of(sheets) > 0) {
        pair(&r, member(taut_record_at(sheets, 0), "size"), r.size);
    }
    r.step = r.size[0] + aside * fmax(r.size[0], r.size[1]);
    for (size_t k = 0; k < count_of(sheets); k++) {
        add_sheet(&r, k);
        flat->size[0] = (double)k * r.step + r.size[0];
    }
    flat->size[1] = r.size[1];
    for (size_t k = 0; k < count_of(pieces); k++) {
        add_piece(&r, taut_record_at(pieces, k));
    }
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return r.is_wrong ? taut_fail(error, TAUT_BAD_INPUT, "value", "/details/pieces", taut_none,
                                  taut_none, "the model's pieces are not what a net tells of them")
                      : TAUT_OK;
}

taut_status taut_flat_read(const taut_model *model, taut_arena *arena, taut_flat *flat,
                           taut_error *error)
{
    return taut_flat_is_cloth(model) ? taut_flat_read_cloth(model, arena, flat, error)
                                     : read_laths(model, arena, flat, error);
}
