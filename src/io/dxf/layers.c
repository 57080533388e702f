#include "io/dxf/layers.h"

#include <stdio.h>
#include <string.h>

enum { NAME_ROOM = 64, COLOURS = 6 };

static const char *text_of(const taut_record *object, const char *member)
{
    const taut_record *found =
        taut_record_kind_of(object) == TAUT_RECORD_OBJECT ? taut_record_get(object, member) : NULL;
    return found != NULL && taut_record_kind_of(found) == TAUT_RECORD_TEXT ? taut_record_text(found)
                                                                           : "";
}

static const taut_record *list_of(const taut_record *details, const char *member)
{
    const taut_record *found = details != NULL ? taut_record_get(details, member) : NULL;
    return found != NULL && taut_record_kind_of(found) == TAUT_RECORD_LIST ? found : NULL;
}

/* The object of a list whose `member` is this text; NULL, also for no text. Objects stand in the order of the curves, so that the search goes on
 * from *next, around. */
static const taut_record *find(const taut_record *list, const char *member, const char *text,
                               size_t *next)
{
    const size_t count = list != NULL ? taut_record_count(list) : 0;
    for (size_t k = 0; text[0] != '\0' && k < count; k++) {
        const size_t i = (*next + k) % count;
        if (strcmp(text_of(taut_record_at(list, i), member), text) == 0) {
            *next = i + 1;
            return taut_record_at(list, i);
        }
    }
    return NULL;
}

/* Is a cable along several edges along this one? */
static int is_along(const taut_record *cables, const char *curve)
{
    for (size_t k = 0; cables != NULL && k < taut_record_count(cables); k++) {
        const taut_record *along = list_of(taut_record_at(cables, k), "along");
        for (size_t i = 0; along != NULL && i < taut_record_count(along); i++) {
            if (strcmp(taut_record_text(taut_record_at(along, i)), curve) == 0) {
                return 1;
            }
        }
    }
    return 0;
}

static void name_layer(const taut_record *details, const char *curve, size_t *next,
                       char name[NAME_ROOM])
{
    size_t first = 0;
    const taut_record *lath = find(list_of(details, "laths"), "name", curve, next);
    const char *plain = "curves";
    if (lath != NULL) {
        snprintf(name, NAME_ROOM, "%.30s %.30s", text_of(details, "trace"),
                 text_of(lath, "family"));
        return;
    }
    const taut_record *cables = list_of(details, "cables");
    if (find(cables, "edge", curve, &first) != NULL || is_along(cables, curve)) {
        plain = "cables";
    } else if (strncmp(curve, "axis", 4) == 0) {
        plain = "axes";
    }
    snprintf(name, NAME_ROOM, "%s", plain);
}

static int layer_named(const char *name, taut_arena *arena, taut_dxf_layers *layers)
{
    int i = 0;
    while (i < layers->count && strcmp(layers->layers[i].name, name) != 0) {
        i++;
    }
    if (i == layers->count) {
        const char *kept = taut_arena_text(arena, name);
        layers->layers[layers->count++] =
            (taut_dxf_layer){kept != NULL ? kept : "", 1 + i % COLOURS};
    }
    return i;
}

taut_status taut_dxf_layers_of(const taut_model *model, taut_arena *arena, taut_dxf_layers *layers)
{
    const size_t curves = (size_t)taut_model_curve_count(model);
    size_t next = 0;
    *layers = (taut_dxf_layers){.layers = taut_arena_take(arena, curves, sizeof(taut_dxf_layer)),
                                .of = taut_arena_take(arena, curves, sizeof(int))};
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < (int)curves; i++) {
        char name[NAME_ROOM];
        name_layer(taut_model_details(model), taut_curve_name(taut_model_curve(model, i)), &next,
                   name);
        layers->of[i] = layer_named(name, arena, layers);
    }
    return taut_arena_status(arena);
}
