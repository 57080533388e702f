/* film_along.c -- cables along several edges.
 *
 *     "cables": [CABLE, ..]       CABLE  { "name", "along": ["a.v1", "-b.v1", ..], and the members of a law }
 *
 * An edge of it is in no seam, or in one without a cable of its own, and has no other edge said of it.
 */
#include "io/problem/film_along.h"

#include "core/fail.h"
#include "io/problem/member.h"

#include <string.h>

static const char *const along_members[] = {"name", "along",      "force",     "length",
                                            "sag",  "unstressed", "stiffness", NULL};
static const char *const edge_names[4] = {"u0", "u1", "v0", "v1"};

typedef struct reading {
    taut_problem *problem;
    const taut_film_parts *parts;
    taut_film_law_read *read_law;
    taut_film_problem *data;
    const taut_json *document;
    taut_film_along *made;
} reading;

/* The seam that an edge is in, or NULL. */
static taut_film_seam *seam_of(const reading *r, const taut_film_side *side)
{
    for (int s = 0; s < r->data->seam_count; s++) {
        for (int k = 0; k < r->data->seams[s].count; k++) {
            const taut_film_side *one = &r->data->seams[s].sides[k];
            if (one->patch == side->patch && one->edge == side->edge) {
                return &r->parts->seams[s];
            }
        }
    }
    return NULL;
}

/* Does the document say something of an edge of a patch? */
static int is_said(const reading *r, const taut_film_side *side)
{
    const taut_json patches = taut_json_member(r->document, "patches");
    const taut_json patch =
        patches.value != NULL ? taut_json_item(&patches, (size_t)side->patch) : *r->document;
    const taut_json edges = taut_json_member(&patch, "edges");
    return taut_json_member(&edges, edge_names[side->edge]).value != NULL;
}

static taut_status take_side(const reading *r, const taut_json *at, const taut_film_side *side,
                             taut_error *error)
{
    taut_film_seam *seam = seam_of(r, side);
    taut_film_edge *edge =
        seam != NULL ? &seam->edge : &r->parts->patches[side->patch].edges[side->edge];
    const int is_ring = r->data->patch_count == 0 && r->data->ring != TAUT_FILM_OPEN &&
                        (r->data->ring == TAUT_FILM_RING_U) == (side->edge < 2);

    if (is_ring || is_said(r, side) || edge->kind != TAUT_FILM_FIXED || edge->curve != NULL) {
        return taut_json_fail(at, error, "edge-conflict", 2, 1,
                              "found an edge that is held, drawn, or part of a cable already: "
                              "leave out one of them");
    }
    edge->kind = TAUT_FILM_CABLE;
    edge->along = r->data->along_count + 1;
    return TAUT_OK;
}

static taut_status read_sides(const reading *r, const taut_json *at, taut_film_along *along,
                              taut_error *error)
{
    size_t count = 0;
    taut_status status =
        taut_json_array(at, 1, 4 * (size_t)TAUT_FILM_PATCHES_MAX, "edges", &count, error);

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
        if (status == TAUT_OK) {
            status = take_side(r, &item, &sides[k], error);
        }
    }
    along->count = (int)count;
    along->sides = sides;
    return status;
}

static taut_status check_name(const reading *r, const taut_json *at, taut_error *error)
{
    for (int k = 0; k < r->data->along_count; k++) {
        const char *name = r->made[r->data->along_count].name;
        if (name != NULL && r->made[k].name != NULL && strcmp(r->made[k].name, name) == 0) {
            return taut_json_refuse(at, error, "name", "a name of its own");
        }
    }
    return TAUT_OK;
}

static taut_status read_along(const taut_json *at, void *into, taut_error *error)
{
    reading *r = into;
    taut_film_along *along = &r->made[r->data->along_count];
    taut_reader in = taut_reader_of(at, along_members, error);
    const taut_json edges = taut_json_member(at, "along"), name = taut_json_member(at, "name");

    taut_member_name(&in, r->problem->arena, &along->name);
    if (in.status == TAUT_OK) {
        r->read_law(&in, at, &along->edge);
    }
    if (in.status == TAUT_OK) {
        in.status = check_name(r, &name, error);
    }
    if (in.status == TAUT_OK) {
        in.status = read_sides(r, &edges, along, error);
    }
    r->data->along_count++;
    return in.status;
}

void taut_film_document_along(taut_reader *document, taut_problem *problem,
                              const taut_film_parts *parts, taut_film_law_read *read_law,
                              taut_film_problem *data)
{
    const taut_json at = taut_json_member(document->object, "cables");
    reading r = {.problem = problem,
                 .parts = parts,
                 .read_law = read_law,
                 .data = data,
                 .document = document->object};

    if (document->status != TAUT_OK || at.value == NULL) {
        return;
    }
    r.made = taut_arena_take(problem->arena, TAUT_FILM_ALONG_MAX + 1, sizeof *r.made);
    document->status = r.made == NULL ? taut_fail_memory(document->error)
                                      : taut_json_each(&at, 0, TAUT_FILM_ALONG_MAX, "cables",
                                                       read_along, &r, document->error);
    data->along = r.made;
}
