/* film_patches.c -- films of many patches.
 *
 *     "patches": [PATCH, ..]      PATCH  { "name", "u", "v", "corners", "edges", "tension" }
 *     "seams":   [SEAM, ..]       SEAM   ["a.u1", "-b.v0", ..] | { "edges": [..], "cable": LAW, "plane": PLANE }
 *
 *     "cells":   [CELL, ..]       CELL   { "name", "sides": ["a", "-b", ..], "pressure": p | "volume": V, "from": P }
 *
 * An edge runs with its parameter, one with a minus sign backwards.
 */
#include "io/problem/film_patches.h"

#include "core/fail.h"
#include "io/problem/film_net.h"
#include "io/problem/member.h"
#include "io/problem/net_document.h"

#include <stdio.h>
#include <string.h>

static const char *const patch_members[] = {"name",      "u",         "v",       "corners",
                                            "edges",     "points",    "tension", "force_density",
                                            "prestress", "reference", "updates", NULL};
static const char *const seam_members[] = {"edges", "cable", "plane", NULL};
static const char *const cell_members[] = {"name", "sides", "pressure", "volume", "from", NULL};
static const char *const edge_names[4] = {"u0", "u1", "v0", "v1"};
static const char *const corner_names[4] = {"u0v0", "u1v0", "u0v1", "u1v1"};
static const char *const of_patches[] = {
    "curves", "boundary",      "u",         "v",         "corners", "edges", "points", "tension",
    "name",   "force_density", "prestress", "reference", "updates", NULL};

/* What is being read. */
typedef struct reading {
    taut_reader *document;
    taut_problem *problem;
    const taut_film_patch_readers *readers;
    taut_film_problem *data;
    taut_film_problem *patches;
    taut_film_seam *seams;
    int count; /* of patches read */
} reading;

/* A corner that nothing is said of is held where a curve ends, else unknown. */
static void free_corners(const taut_json *at, taut_film_problem *patch)
{
    const taut_json corners = taut_json_member(at, "corners");

    for (int c = 0; c < 4; c++) {
        const taut_json corner = taut_json_member(&corners, corner_names[c]);
        const int has_curve =
            patch->edges[c % 2].curve != NULL || patch->edges[2 + c / 2].curve != NULL;
        if (corner.value == NULL && !has_curve && !patch->has_corner[c]) {
            patch->corner_kinds[c] = TAUT_FILM_FREE;
        }
    }
}

static taut_status read_patch(const taut_json *at, void *into, taut_error *error)
{
    reading *r = into;
    taut_film_problem *patch = &r->patches[r->count];
    taut_reader in = taut_reader_of(at, patch_members, error);

    if (in.status == TAUT_OK) {
        r->readers->patch(&in, r->problem, patch);
        r->readers->tension(&in, r->problem, patch);
        free_corners(at, patch);
    }
    if (in.status == TAUT_OK && patch->name == NULL) {
        char name[24];
        snprintf(name, sizeof name, "film-%d", r->count);
        patch->name = taut_arena_text(r->problem->arena, name);
        in.status = patch->name == NULL ? taut_fail_memory(error) : TAUT_OK;
    }
    r->count++;
    return in.status;
}

taut_status taut_film_document_side(const taut_json *at, const taut_film_problem *data,
                                    taut_film_side *side, taut_error *error)
{
    const char *text = taut_json_text_at(at),
               *first = data->patch_count > 0 ? data->patches[0].name : "";
    const char *join = data->patch_count > 0 ? "." : "";

    if (text == NULL) {
        return taut_json_refuse(at, error, "type", "the name of an edge, \"%s%su0\"", first, join);
    }
    side->reversed = text[0] == '-';
    text += side->reversed;
    const char *dot = strrchr(text, '.');
    for (int k = 0; k < 4 * data->patch_count || (data->patch_count == 0 && k < 4); k++) {
        const char *name = data->patch_count > 0 ? data->patches[k / 4].name : NULL;
        const int is_patch = name == NULL ? dot == NULL
                                          : dot != NULL && strlen(name) == (size_t)(dot - text) &&
                                                strncmp(name, text, strlen(name)) == 0;
        if (is_patch && strcmp(dot == NULL ? text : dot + 1, edge_names[k % 4]) == 0) {
            side->patch = k / 4;
            side->edge = k % 4;
            return TAUT_OK;
        }
    }
    return taut_json_refuse(at, error, "name",
                            "an edge of a patch, such as \"%s%su0\" or \"-%s%sv1\"", first, join,
                            first, join);
}

static taut_status read_sides(const reading *r, const taut_json *at, taut_film_seam *seam,
                              taut_error *error)
{
    size_t count = 0;
    taut_status status =
        taut_json_array(at, 2, 4 * (size_t)TAUT_FILM_PATCHES_MAX, "edges", &count, error);

    if (status != TAUT_OK) {
        return status;
    }
    taut_film_side *sides = taut_arena_take(r->problem->arena, count, sizeof *sides);
    if (sides == NULL) {
        return taut_fail_memory(error);
    }
    for (size_t k = 0; status == TAUT_OK && k < count; k++) {
        const taut_json item = taut_json_item(at, k);
        status = taut_film_document_side(&item, r->data, &sides[k], error);
    }
    seam->count = (int)count;
    seam->sides = sides;
    return status;
}

static taut_status read_seam(const taut_json *at, void *into, taut_error *error)
{
    reading *r = into;
    taut_film_seam *seam = &r->seams[r->data->seam_count++];

    if (taut_json_kind_at(at) != TAUT_JSON_OBJECT) {
        return read_sides(r, at, seam, error);
    }
    taut_reader in = taut_reader_of(at, seam_members, error);
    const taut_json edges = taut_json_member(at, "edges");
    const taut_json plane = taut_json_member(at, "plane");
    if (in.status == TAUT_OK) {
        in.status = read_sides(r, &edges, seam, error);
    }
    if (in.status == TAUT_OK && taut_reader_has(&in, "cable")) {
        seam->edge.kind = TAUT_FILM_CABLE;
        r->readers->cable(&in, &seam->edge);
    } else if (in.status == TAUT_OK && plane.value != NULL) {
        in.status =
            taut_json_fail(&plane, error, "conflict", 1, 0, "found \"plane\" without a \"cable\"");
    }
    return in.status;
}

/* The net of a patch, once its seams are known. */
static void read_points(const reading *r, const taut_json *at, int p)
{
    const taut_json edges = taut_json_member(at, "edges");
    taut_reader in = taut_reader_of(at, patch_members, r->document->error);
    unsigned char named[4];

    for (int e = 0; e < 4; e++) {
        named[e] = taut_json_member(&edges, edge_names[e]).value != NULL;
    }
    for (int s = 0; s < r->data->seam_count; s++) {
        for (int k = 0; k < r->seams[s].count; k++) {
            if (r->seams[s].sides[k].patch == p) {
                named[r->seams[s].sides[k].edge] = TAUT_FILM_EDGE_JOINED;
            }
        }
    }
    if (taut_reader_has(&in, "points")) {
        taut_film_document_points(&in, r->problem->arena, named, &r->patches[p]);
    }
    r->document->status = in.status;
}

/* An edge in a seam says nothing of itself: one that is held where its corners are would move all the same. */
static taut_status refuse_held(const reading *r, const taut_json *patches, int s)
{
    const taut_film_seam *seam = &r->seams[s];

    for (int k = 0; k < seam->count; k++) {
        const taut_film_side *side = &seam->sides[k];
        const taut_json patch = taut_json_item(patches, (size_t)side->patch);
        const taut_json edges = taut_json_member(&patch, "edges");
        const taut_json edge = taut_json_member(&edges, edge_names[side->edge]);
        const taut_film_edge *read = &r->patches[side->patch].edges[side->edge];
        if (edge.value != NULL && read->kind == TAUT_FILM_FIXED && read->curve == NULL) {
            return taut_json_fail(&edge, r->document->error, "edge-conflict", 1, 0,
                                  "edge %.80s.%s is in a seam, and held too: leave out one of them",
                                  r->patches[side->patch].name, edge_names[side->edge]);
        }
    }
    return TAUT_OK;
}

void taut_film_document_patches(taut_reader *document, taut_problem *problem,
                                const taut_film_patch_readers *readers, taut_film_problem *data,
                                taut_film_parts *parts)
{
    const taut_json patches = taut_json_member(document->object, "patches");
    const taut_json seams = taut_json_member(document->object, "seams");
    reading r = {.document = document, .problem = problem, .readers = readers, .data = data};
    const size_t seam_count = taut_json_count_at(&seams);

    for (int k = 0; document->status == TAUT_OK && of_patches[k] != NULL; k++) {
        const taut_json at = taut_json_member(document->object, of_patches[k]);
        if (at.value != NULL) {
            document->status = taut_json_fail(
                &at, document->error, "conflict", 2, 1,
                "found \"%s\" beside \"patches\": give it to each patch", of_patches[k]);
        }
    }
    r.patches = taut_arena_take(problem->arena, TAUT_FILM_PATCHES_MAX, sizeof *r.patches);
    r.seams = taut_arena_take(problem->arena, seam_count + 1, sizeof *r.seams);
    if (document->status == TAUT_OK && (r.patches == NULL || r.seams == NULL)) {
        document->status = taut_fail_memory(document->error);
    }
    if (document->status == TAUT_OK) {
        document->status = taut_json_each(&patches, 1, TAUT_FILM_PATCHES_MAX, "patches", read_patch,
                                          &r, document->error);
    }
    data->patch_count = r.count;
    data->patches = r.patches;
    if (document->status == TAUT_OK && seams.value != NULL) {
        document->status = taut_json_each(&seams, 0, 4 * (size_t)TAUT_FILM_PATCHES_MAX, "seams",
                                          read_seam, &r, document->error);
    }
    data->seams = r.seams;
    for (int s = 0; document->status == TAUT_OK && s < r.data->seam_count; s++) {
        document->status = refuse_held(&r, &patches, s);
    }
    for (int p = 0; document->status == TAUT_OK && p < r.count; p++) {
        const taut_json at = taut_json_item(&patches, (size_t)p);
        read_points(&r, &at, p);
    }
    taut_film_document_start(document, problem->arena, r.count, r.patches);
    *parts = (taut_film_parts){r.patches, r.seams};
}

/* ---- cells ---- */

typedef struct cells {
    taut_problem *problem;
    taut_film_problem *data;
    taut_film_cell *made;
    taut_film_face *sides; /* of the cell being read */
} cells;

static taut_status read_face(const taut_json *at, void *into, taut_error *error)
{
    cells *r = into;
    taut_film_cell *cell = &r->made[r->data->cell_count];
    const char *text = taut_json_text_at(at);
    const char *lone = r->data->name != NULL ? r->data->name : "film";
    const int count = r->data->patch_count > 0 ? r->data->patch_count : 1;

    for (int p = 0; text != NULL && p < count; p++) {
        const char *name = r->data->patch_count > 0 ? r->data->patches[p].name : lone;
        if (strcmp(text + (text[0] == '-'), name) == 0) {
            r->sides[cell->count++] =
                (taut_film_face){.patch = p, .reversed = (unsigned char)(text[0] == '-')};
            return TAUT_OK;
        }
    }
    return taut_json_refuse(at, error, text != NULL ? "name" : "type",
                            "a side of a patch, such as \"%s\" or \"-%s\"",
                            r->data->patch_count > 0 ? r->data->patches[0].name : lone,
                            r->data->patch_count > 0 ? r->data->patches[0].name : lone);
}

static taut_status read_origin(const taut_json *at, void *value, taut_error *error)
{
    return taut_net_document_point(at, value, error);
}

static taut_status read_cell(const taut_json *at, void *into, taut_error *error)
{
    cells *r = into;
    taut_film_cell *cell = &r->made[r->data->cell_count];
    taut_reader in = taut_reader_of(at, cell_members, error);
    const taut_json sides = taut_json_member(at, "sides");
    const int has_volume = taut_reader_has(&in, "volume"),
              has_pressure = taut_reader_has(&in, "pressure");

    if (in.status == TAUT_OK && has_volume + has_pressure != 1) {
        in.status = taut_json_fail(
            at, error, has_volume ? "conflict" : "missing", has_volume + has_pressure, 1,
            "found %d of \"pressure\" and \"volume\", expected one", has_volume + has_pressure);
    }
    taut_member_name(&in, r->problem->arena, &cell->name);
    r->sides = taut_arena_take(r->problem->arena, taut_json_count_at(&sides) + 1, sizeof *r->sides);
    if (in.status == TAUT_OK && r->sides == NULL) {
        in.status = taut_fail_memory(error);
    }
    if (in.status == TAUT_OK) {
        in.status = taut_json_each(&sides, 1, 2 * (size_t)TAUT_FILM_PATCHES_MAX, "sides", read_face,
                                   r, error);
    }
    cell->sides = r->sides;
    cell->has_volume = (unsigned char)has_volume;
    taut_reader_optional_number(&in, "volume", &cell->volume);
    taut_reader_optional_number(&in, "pressure", &cell->pressure);
    taut_reader_optional(&in, "from", read_origin, cell->from);
    r->data->cell_count++;
    return in.status;
}

void taut_film_document_cells(taut_reader *document, taut_problem *problem, taut_film_problem *data)
{
    const taut_json at = taut_json_member(document->object, "cells");
    cells r = {.problem = problem, .data = data};

    if (document->status != TAUT_OK || at.value == NULL) {
        return;
    }
    r.made = taut_arena_take(problem->arena, TAUT_FILM_CELLS_MAX + 1, sizeof *r.made);
    document->status = r.made == NULL ? taut_fail_memory(document->error)
                                      : taut_json_each(&at, 0, TAUT_FILM_CELLS_MAX, "cells",
                                                       read_cell, &r, document->error);
    data->cells = r.made;
}
