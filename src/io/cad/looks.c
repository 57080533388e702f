/* looks.c -- what a model says of the file that it was read from: colours of its surfaces, parts of an assembly. */
#include "core/fail.h"
#include "io/cad/prepare.h"
#include "io/format.h"

/* The model's surface that each of `nurbs` comes from; NULL where memory runs out. */
static int *find_origins(const taut_model *model, const taut_write_options *options,
                         const int *from, const taut_model *nurbs, taut_arena *arena)
{
    const int count = taut_model_surface_count(nurbs);
    int *origins = taut_arena_take(arena, (size_t)count, sizeof *origins);
    for (int i = 0, chosen = -1, at = -1; origins != NULL && i < count; i++) {
        for (; chosen < (from != NULL ? from[i] : i); chosen++) {
            for (at++; !taut_format_wants(model, options, at); at++) {
            }
        }
        origins[i] = at;
    }
    return origins;
}

/* The colours that the file had which the model was read from, for the surfaces that are there now. */
static taut_status keep_colours(const taut_record *said, const int *origins, taut_model *nurbs)
{
    if (said == NULL) {
        return TAUT_OK;
    }
    taut_record *details = taut_record_new();
    taut_record *colours = taut_record_add_list(details, "colours");
    for (int i = 0; i < taut_model_surface_count(nurbs); i++) {
        const char *text = taut_record_text(taut_record_at(said, (size_t)origins[i]));
        taut_record_add_text(colours, NULL, text != NULL ? text : "");
    }
    if (taut_record_status(details) != TAUT_OK) {
        taut_record_free(details);
        return TAUT_NO_MEMORY;
    }
    taut_model_set_details(nurbs, details);
    return TAUT_OK;
}

/* Which part of an assembly each surface of the model belongs to, the first that has it: owner[surface], -1: none. */
static void find_owners(const taut_record *said, int count, int *owner)
{
    for (int i = 0; i < count; i++) {
        owner[i] = -1;
    }
    for (size_t p = 0; p < taut_record_count(said); p++) {
        const taut_record *list = taut_record_get(taut_record_at(said, p), "surfaces");
        for (size_t k = 0; k < taut_record_count(list); k++) {
            const double i = taut_record_number(taut_record_at(list, k));
            if (i >= 0 && i < count && owner[(int)i] < 0) {
                owner[(int)i] = (int)p;
            }
        }
    }
}

/* Parts of the assembly that the model was read from, details.parts. */
static taut_status keep_parts(const taut_model *model, const int *origins, const taut_model *nurbs,
                              taut_arena *arena, taut_cad_facts *facts)
{
    const taut_record *said = taut_record_get(taut_model_details(model), "parts");
    const size_t count = taut_record_count(said);
    if (count == 0 || count > TAUT_OBJECTS_MAX) {
        return TAUT_OK;
    }
    const char **names = taut_arena_take(arena, count, sizeof *names);
    int *owner = taut_arena_take(arena, (size_t)taut_model_surface_count(model), sizeof *owner);
    int *part = taut_arena_take(arena, (size_t)taut_model_surface_count(nurbs), sizeof *part);
    double *places = taut_arena_take(arena, count, 12 * sizeof *places);
    if (names == NULL || owner == NULL || part == NULL || places == NULL) {
        return TAUT_NO_MEMORY;
    }
    find_owners(said, taut_model_surface_count(model), owner);
    for (size_t p = 0; p < count; p++) {
        const char *name = taut_record_text(taut_record_get(taut_record_at(said, p), "product"));
        names[p] = name != NULL ? name : "";
        for (size_t k = 0; k < 12; k++) { /* NaN where nothing is said: no rotation */
            const taut_record *rows = taut_record_get(taut_record_at(said, p), "placement");
            places[12 * p + k] =
                taut_record_number(taut_record_at(taut_record_at(rows, k / 4), k % 4));
        }
    }
    for (int i = 0; i < taut_model_surface_count(nurbs); i++) {
        part[i] = owner[origins[i]];
    }
    facts->part_count = (int)count;
    facts->parts = names;
    facts->places = places;
    facts->part = part;
    return TAUT_OK;
}

taut_status taut_cad_keep_looks(const taut_model *model, const taut_write_options *options,
                                taut_arena *arena, taut_model *nurbs, taut_cad_facts *facts,
                                taut_error *error)
{
    const taut_record *colours = taut_record_get(taut_model_details(model), "colours");
    if (taut_model_surface_count(nurbs) == 0) {
        return TAUT_OK;
    }
    const int *origins = find_origins(model, options, facts->from, nurbs, arena);
    return origins != NULL && keep_colours(colours, origins, nurbs) == TAUT_OK &&
                   keep_parts(model, origins, nurbs, arena, facts) == TAUT_OK
               ? TAUT_OK
               : taut_fail_memory(error);
}
