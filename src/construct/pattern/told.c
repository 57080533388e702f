/* told.c -- what a finished pattern says, as structs: members of its details by their names, and the surfaces and curves that are called as
 * they are. */
#include "construct/common/told.h"
#include "core/fail.h"
#include "taut/pattern.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { EDGES = 4 };
static const char *const edge_names[EDGES] = {"right", "end", "left", "start"};

static const taut_record *list_of(const taut_model *cloth, const char *name)
{
    return taut_told_list(cloth, "pattern", name);
}

int taut_pattern_piece_count(const taut_model *cloth)
{
    return (int)taut_record_count(list_of(cloth, "pieces"));
}

int taut_pattern_seam_count(const taut_model *cloth)
{
    return (int)taut_record_count(list_of(cloth, "seams"));
}

/* Item i of a list, where there is a place for what is told of it. */
static taut_status find(const taut_model *cloth, const char *name, int i, const void *place,
                        const taut_record **found, taut_error *error)
{
    return taut_told_item(list_of(cloth, name), "pattern", name, i, place, found, error);
}

static const taut_curve *curve_named(const taut_model *cloth, const char *name, const char *what)
{
    char whole[64];
    snprintf(whole, sizeof whole, what != NULL ? "%.40s.%s" : "%.40s", name, what);
    for (int i = 0; i < taut_model_curve_count(cloth); i++) {
        const taut_curve *curve = taut_model_curve(cloth, i);
        if (strcmp(taut_curve_name(curve), whole) == 0) {
            return curve;
        }
    }
    return NULL;
}

/* The last one of this name: the flat pieces are behind what is cut. */
static const taut_surface *surface_named(const taut_model *cloth, const char *name)
{
    for (int i = taut_model_surface_count(cloth); i-- > 0;) {
        const taut_surface *surface = taut_model_surface(cloth, i);
        if (strcmp(taut_surface_name(surface), name) == 0) {
            return surface;
        }
    }
    return NULL;
}

static taut_pattern_sewn_edge edge_of(const taut_model *cloth, const taut_record *piece, int e)
{
    const taut_record *at = taut_record_get(taut_record_get(piece, "edges"), edge_names[e]);
    const int is_sewn = taut_record_get(at, "seam") != NULL;
    taut_pattern_sewn_edge edge = {
        .seam = is_sewn ? taut_told_text(at, "seam") : NULL,
        .part = {is_sewn ? 0 : NAN, is_sewn ? 1 : NAN},
        .length = taut_told_number(at, "length"),
        .flat_length = taut_told_number(at, "flat_length"),
        .allowance =
            taut_record_get(at, "allowance") != NULL ? taut_told_number(at, "allowance") : 0,
        .line = curve_named(cloth, taut_told_text(piece, "name"), edge_names[e])};
    if (is_sewn && taut_record_get(at, "part") != NULL) {
        taut_told_numbers(at, "part", 2, edge.part);
    }
    return edge;
}

static void take_place(const taut_model *cloth, taut_pattern_flat_piece *piece)
{
    const taut_record *places = taut_record_get(list_of(cloth, "roll"), "pieces");
    piece->on_roll[0] = piece->on_roll[1] = NAN;
    for (size_t k = 0; k < taut_record_count(places); k++) {
        const taut_record *place = taut_record_at(places, k);
        if (strcmp(taut_told_text(place, "name"), piece->name) == 0) {
            taut_told_numbers(place, "at", 2, piece->on_roll);
            piece->is_turned = taut_record_get(place, "turned") != NULL;
            return;
        }
    }
}

taut_status taut_pattern_piece_at(const taut_model *cloth, int i, taut_pattern_flat_piece *piece,
                                  taut_error *error)
{
    const taut_record *at = NULL;
    const taut_status status = find(cloth, "pieces", i, piece, &at, error);
    if (status != TAUT_OK) {
        return status;
    }
    const taut_record *strain = taut_record_get(at, "strain");
    *piece = (taut_pattern_flat_piece){
        .name = taut_told_text(at, "name"),
        .flat = surface_named(cloth, taut_told_text(at, "name")),
        .cut = curve_named(cloth, taut_told_text(at, "name"), "cut"),
        .area = taut_told_number(at, "area"),
        .flat_area = taut_told_number(at, "flat_area"),
        .cut_area = taut_told_number(at, "cut_area"),
        .curvature = taut_told_number(at, "curvature"),
        .strain = {taut_told_number(strain, "min"), taut_told_number(strain, "max")},
        .energy = taut_told_number(at, "energy")};
    taut_told_numbers(at, "extent", 2, piece->extent);
    for (int e = 0; e < EDGES; e++) {
        piece->edges[e] = edge_of(cloth, at, e);
    }
    take_place(cloth, piece);
    return TAUT_OK;
}

static taut_status fail_room(const char *name, const char *what, int room, int count,
                             taut_error *error)
{
    return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, room, count,
                     "%.40s has %d %s, and there is room for %d", name, count, what, room);
}

taut_status taut_pattern_seam_at(const taut_model *cloth, int i, const int rooms[2],
                                 const char **pieces, double *marks, taut_pattern_sewn_seam *seam,
                                 taut_error *error)
{
    const taut_record *at = NULL;
    const taut_status status = find(cloth, "seams", i, seam, &at, error);
    if (status != TAUT_OK) {
        return status;
    }
    const taut_record *along = taut_record_get(at, "pieces"),
                      *at_marks = taut_record_get(at, "marks");
    taut_pattern_sewn_seam found = {.name = taut_told_text(at, "name"),
                                    .kind = taut_told_text(at, "kind"),
                                    .curve = curve_named(cloth, taut_told_text(at, "name"), NULL),
                                    .length = taut_told_number(at, "length"),
                                    .flat_length = taut_told_number(at, "flat_length"),
                                    .disagreement = taut_told_number(at, "disagreement"),
                                    .piece_count = (int)taut_record_count(along),
                                    .mark_count = (int)taut_record_count(at_marks)};
    taut_told_numbers(at, "stretch", 2, found.stretch);
    if (pieces != NULL && (rooms == NULL || rooms[0] < found.piece_count)) {
        return fail_room(found.name, "pieces", rooms != NULL ? rooms[0] : 0, found.piece_count,
                         error);
    }
    if (marks != NULL && (rooms == NULL || rooms[1] < found.mark_count)) {
        return fail_room(found.name, "marks", rooms != NULL ? rooms[1] : 0, found.mark_count,
                         error);
    }
    for (size_t k = 0; pieces != NULL && k < (size_t)found.piece_count; k++) {
        pieces[k] = taut_record_text(taut_record_at(along, k));
    }
    for (size_t k = 0; marks != NULL && k < (size_t)found.mark_count; k++) {
        marks[k] = taut_record_number(taut_record_at(at_marks, k));
    }
    *seam = found;
    return TAUT_OK;
}
