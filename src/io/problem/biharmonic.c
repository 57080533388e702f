/* biharmonic.c -- the problem `biharmonic`: four rows, or a surface and an edge
 * (docs/format.md). */
#include "taut/biharmonic.h"
#include "core/fail.h"
#include "io/model/surface.h"
#include "io/problem/document_ops.h"
#include "io/problem/net_document.h"

#include <string.h>

static const char *const members[] = {"name", "u",     "v",       "points", "surface",
                                      "edge", "width", "contact", "insist", NULL};

static void release_surface(void *surface)
{
    taut_surface_free(surface);
}

/* Members that have no meaning beside the one that is there. */
static taut_status refuse_strangers(const taut_json *document, const char *const *strangers,
                                    const char *beside, taut_error *error)
{
    for (int i = 0; strangers[i] != NULL; i++) {
        const taut_json at = taut_json_member(document, strangers[i]);
        if (at.value != NULL) {
            return taut_json_fail(&at, error, "value", taut_none, taut_none,
                                  "found \"%s\" %s \"surface\"", strangers[i], beside);
        }
    }
    return TAUT_OK;
}

static taut_status read_rows(const taut_json *document, taut_arena *arena,
                             taut_biharmonic_problem *data, taut_error *error)
{
    static const char *const strangers[] = {"edge", "width", "contact", "insist", NULL};
    taut_net_document net = {NULL, NULL, NULL, NULL, NULL};
    const char *name = "";
    taut_status status = refuse_strangers(document, strangers, "without", error);

    if (status == TAUT_OK) {
        status = taut_net_document_read(document, arena, &net, error);
    }
    if (status == TAUT_OK) {
        status = taut_name_document_read(document, &name, error);
    }
    if (status == TAUT_OK && name[0] != '\0') {
        data->name = taut_arena_text(arena, name);
        status = data->name != NULL ? TAUT_OK : taut_fail_memory(error);
    }
    for (int i = 0; i < 2 && status == TAUT_OK; i++) {
        const taut_json at = taut_json_member(document, i == 0 ? "u" : "v");
        const taut_basis *basis = i == 0 ? net.u : net.v;
        if (strcmp(taut_basis_type(basis), "bezier") != 0) {
            status = taut_json_fail(&at, error, "value", taut_none, taut_none,
                                    "found a basis of type \"%s\", expected \"bezier\"",
                                    taut_basis_type(basis));
        }
    }
    data->u = net.u;
    data->v = net.v;
    data->points = net.points;
    data->known = net.known;
    return status;
}

static taut_status read_neighbour(const taut_json *document, taut_arena *arena,
                                  taut_biharmonic_problem *data, taut_error *error)
{
    static const char *const strangers[] = {"name", "u", "v", "points", NULL};
    static const char *const edges[] = {"u0", "u1", "v0", "v1", NULL};
    static const char *const contacts[] = {"c1", "c2", NULL};
    const taut_json at = taut_json_member(document, "surface");
    const taut_json edge = taut_json_member(document, "edge");
    const taut_json width = taut_json_member(document, "width");
    const taut_json contact = taut_json_member(document, "contact");
    taut_surface *surface = NULL;
    int word = 0, order = 0;
    taut_status status = refuse_strangers(document, strangers, "beside", error);

    if (status == TAUT_OK) {
        status = taut_surface_document_read(&at, &surface, error);
    }
    if (status == TAUT_OK && !taut_arena_keep(arena, surface, release_surface)) {
        status = taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        data->surface = surface;
        status = taut_json_word(&edge, edges, &word, error);
    }
    if (status == TAUT_OK && contact.value != NULL) {
        status = taut_json_word(&contact, contacts, &order, error);
    }
    if (status == TAUT_OK && width.value != NULL) {
        status = taut_json_number(&width, &data->width, error);
        if (status == TAUT_OK && !(data->width > 0)) {
            status = taut_json_expected(&width, error, "a positive number");
        }
    }
    if (status == TAUT_OK) {
        status = taut_json_flag(document, "insist", &data->insist, error);
    }
    data->edge = (taut_edge)word;
    data->contact = order + 1;
    return status;
}

static taut_status biharmonic_read(const taut_json *document, taut_problem *problem,
                                   taut_error *error)
{
    taut_biharmonic_problem *data = taut_arena_take(problem->arena, 1, sizeof *data);
    const taut_json surface = taut_json_member(document, "surface");
    taut_status status = data != NULL ? TAUT_OK : taut_fail_memory(error);

    if (status == TAUT_OK) {
        status = surface.value != NULL ? read_neighbour(document, problem->arena, data, error)
                                       : read_rows(document, problem->arena, data, error);
    }
    if (status == TAUT_OK) {
        problem->data = data;
    }
    return status;
}

const taut_document_ops taut_document_biharmonic = {
    .members = members,
    .read = biharmonic_read,
};
